// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "core/batch/batch.h"
#include "core/batch/messages.h"
#include "core/batch/summary.h"
#include "core/graph.h"

namespace mesecina {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A fresh folder, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "mesecina_batch_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void wait_until(const std::function<bool()>& is_so) {
  while (!is_so()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Runs the batch over files that hold one number, with one layer, "work", that a test gives: it is called with that
/// number.
class Batch_test : public testing::Test {
 protected:
  using Work = std::function<void(int number, Progress& progress)>;

  int run(int file_count, int jobs, bool resume, Work work) {
    errors_.str("");
    return run(file_count, jobs, resume, std::move(work), errors_);
  }
  int run(int file_count, int jobs, bool resume, Work work, std::ostream& errors) {
    auto registry = std::make_shared<Registry>(2);
    registry->begin_module({"module", "Module", ""});
    Layer_spec layer;
    layer.id = "work";
    layer.build = [work = std::move(work)](Context& context) {
      work(static_cast<int>(context.input(points_input)->front().x), context.progress());
      return Primitive_set();
    };
    registry->add_layer(std::move(layer));
    Formats formats;
    formats.readers.push_back(
        {"numbers", {"number"}, [](const fs::path& file) {
           File_contents contents;
           contents.inputs = Inputs().with(points_input, std::vector<Point_2>{{std::stod(text_of(file)), 0}});
           return contents;
         }});
    formats.layer_writers.push_back(
        {"text", "text", "", [](std::ostream& stream, const Layer_document& document) { stream << document.input; }});
    Command_line command_line;
    for (int i = 0; i < file_count; ++i) {
      const fs::path file = folder_.path() / ("input" + std::to_string(i) + ".number");
      if (!fs::exists(file)) std::ofstream(file) << i;
      command_line.files.push_back(file);
    }
    command_line.layers = {"work"};
    command_line.formats = {"text"};
    command_line.output = output();
    command_line.stats = output() / "stats.jsonl";
    command_line.jobs = jobs;
    command_line.resume = resume;
    return run_batch(command_line, "program", registry, formats, errors, false);
  }
  fs::path output() const { return folder_.path() / "out"; }
  bool has_result(int number) const { return fs::exists(output() / ("input" + std::to_string(number) + ".work.text")); }
  std::vector<fs::path> unfinished() const {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(output()))
      if (entry.path().extension() == ".unfinished") found.push_back(entry.path());
    return found;
  }
  std::string summary() const { return text_of(output() / "summary.csv"); }

  Folder folder_;
  std::ostringstream errors_;
};

using Batch_death_test = Batch_test;

TEST_F(Batch_test, InputWithoutMemoryBesideOthersIsTriedAgainAlone) {
  std::atomic<bool> other_is_running = false;
  std::atomic<int> attempts = 0;
  EXPECT_EQ(exit_success, run(2, 2, false, [&](int number, Progress&) {
              if (number == 1) {
                other_is_running = true;
                wait_until([&] { return attempts > 0; });
                other_is_running = false;
                return;
              }
              if (attempts == 0) wait_until([&] { return other_is_running.load(); });
              ++attempts;
              if (attempts == 1) throw std::bad_alloc();
              EXPECT_FALSE(other_is_running);
            }));
  EXPECT_EQ(2, attempts);
  EXPECT_TRUE(has_result(0));
  EXPECT_TRUE(has_result(1));
  EXPECT_THAT(summary(), HasSubstr("input0.number,done,"));
}

TEST_F(Batch_test, InputWithoutMemoryFailsAloneAndIsTriedAgainWithResume) {
  EXPECT_EQ(exit_some_failed, run(3, 2, false, [](int number, Progress&) {
              if (number == 1) throw std::bad_alloc();
            }));
  EXPECT_TRUE(has_result(0));
  EXPECT_FALSE(has_result(1));
  EXPECT_TRUE(has_result(2));
  EXPECT_THAT(errors_.str(), HasSubstr("input1.number: not enough memory"));
  EXPECT_THAT(summary(), HasSubstr("input1.number,failed,"));
  std::atomic<int> computed = 0;
  EXPECT_EQ(exit_success, run(3, 2, true, [&](int number, Progress&) { computed += 1 << number; }));
  EXPECT_EQ(1 << 1, computed);
  EXPECT_TRUE(has_result(1));
  EXPECT_THAT(summary(), HasSubstr("input0.number,skipped,"));
}

TEST_F(Batch_test, SignalStopsTheRunAndLeavesOnlyCompleteResults) {
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(output());
    EXPECT_EQ(exit_interrupted, run(4, 1, false, [&](int number, Progress& progress) {
                if (number != 2) return;
                kill(getpid(), signal);
                wait_until([&] {
                  progress.check();
                  return false;
                });
              }));
    EXPECT_TRUE(has_result(0));
    EXPECT_TRUE(has_result(1));
    EXPECT_FALSE(has_result(2));
    EXPECT_FALSE(has_result(3));
    EXPECT_THAT(errors_.str(), HasSubstr("stopped: 2 of 4 done"));
    EXPECT_THAT(summary(), HasSubstr("input1.number,done,"));
    EXPECT_THAT(summary(), Not(HasSubstr("input2")));
    EXPECT_THAT(unfinished(), IsEmpty());
  }
}

TEST_F(Batch_death_test, ComputationThatDoesNotStopIsLeftBehind) {
  EXPECT_EXIT(run(
                  2, 2, false,
                  [this](int number, Progress& progress) {
                    if (number == 0) return;
                    wait_until([this] { return has_result(0); });
                    kill(getpid(), SIGINT);
                    wait_until([&] { return progress.is_cancelled(); });
                    std::this_thread::sleep_for(std::chrono::minutes(5));
                  },
                  std::cerr),
              testing::ExitedWithCode(exit_interrupted), "stopped: 1 of 2 done");
  EXPECT_TRUE(has_result(0));
  EXPECT_FALSE(has_result(1));
  EXPECT_THAT(summary(), HasSubstr("input0.number,done,"));
  EXPECT_THAT(unfinished(), IsEmpty());
}

TEST_F(Batch_death_test, SecondSignalEndsTheProcessAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EXIT(run(
                  1, 1, false,
                  [](int, Progress& progress) {
                    kill(getpid(), SIGINT);
                    wait_until([&] { return progress.is_cancelled(); });
                    std::cerr << "stopping" << std::flush;
                    kill(getpid(), SIGINT);
                    std::this_thread::sleep_for(std::chrono::minutes(5));
                  },
                  std::cerr),
              testing::ExitedWithCode(exit_interrupted), "stopping");
  EXPECT_FALSE(fs::exists(output() / "summary.csv"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
}

TEST_F(Batch_test, SignalsActAsBeforeWhenTheRunIsOver) {
  EXPECT_EQ(exit_success, run(1, 1, false, [](int, Progress&) {}));
  sigset_t blocked;
  pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  EXPECT_EQ(0, sigismember(&blocked, SIGINT));
  EXPECT_EQ(0, sigismember(&blocked, SIGTERM));
}

TEST(Time_left_test, GoesByTheBytesThatWereComputed) {
  Time_left left(1000);
  EXPECT_EQ("", left.text(5));
  left.count(500, false);
  EXPECT_EQ("", left.text(5));
  left.count(100, true);
  EXPECT_EQ("about 40 s left", left.text(10));
  EXPECT_EQ("about 7 min left", left.text(100));
  EXPECT_EQ("about 2 h 13 min left", left.text(2000));
  left.count(400, true);
  EXPECT_EQ("", left.text(2000));
}

TEST(Messages_test, ProgressOnATerminalStaysBelowWhatIsSaid) {
  std::ostringstream stream;
  Messages messages(stream, "program", Log_level::warning, true);
  messages.show_progress("1 of 2");
  messages.say(Log_level::warning, "odd");
  messages.say(Log_level::info, "even");
  messages.end_progress();
  EXPECT_EQ("1 of 2\r\x1b[Kprogram: odd\n1 of 2\r\x1b[K", stream.str());
}

TEST(Messages_test, ProgressElsewhereIsALineForWhoWantsIt) {
  std::ostringstream stream;
  Messages(stream, "program", Log_level::warning, false).show_progress("1 of 2");
  EXPECT_EQ("", stream.str());
  Messages(stream, "program", Log_level::info, false).show_progress("1 of 2");
  EXPECT_EQ("program: 1 of 2\n", stream.str());
}

TEST(Summary_test, CellsAreQuotedAndUnknownOnesEmpty) {
  const Summary summary({"dual", "none"}, 3);
  EXPECT_EQ(
      "input,status,reason,seconds,repair,error,warnings,dual.elements,dual.b0,dual.b1,dual.b2,none.elements,none.b0,"
      "none.b1,none.b2\n",
      summary.header());
  EXPECT_EQ("\"a, \"\"b\"\".off\",done,,1.5,\"winding number, 0.5\",0.00025,first; second,7,1,2,0,,,,\n",
            summary.row("done", R"({"input": "a, \"b\".off", "status": "ok", "seconds": {"total": 1.5},
                               "notes": {"repair": "winding number, 0.5"}, "error": {"hausdorff": 2.5e-4},
                               "layers": {"dual": {"vertices": 9, "points": 3, "triangles": 4, "betti": [1, 2, 0]},
                                          "none": {"reason": "there is none"}},
                               "warnings": ["first", "second"]})"));
}

}  // namespace
}  // namespace mesecina
