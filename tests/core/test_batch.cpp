// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
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

/// A number that all processes of a test see.
class Shared_number {
 public:
  Shared_number() {
    void* memory = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    number_ = ::new (memory) std::atomic<int>(0);
  }
  ~Shared_number() { munmap(number_, sizeof(std::atomic<int>)); }
  Shared_number(const Shared_number&) = delete;
  Shared_number& operator=(const Shared_number&) = delete;
  std::atomic<int>& operator*() { return *number_; }

 private:
  std::atomic<int>* number_;
};

/// Runs the batch over files that hold one number, with one layer, "work", that a test gives: it is called with that
/// number, in a process of the batch, so what it changes is not seen outside.
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
  for (const bool is_killed : {false, true}) {
    SCOPED_TRACE(is_killed);
    fs::remove_all(output());
    Shared_number other_is_running;
    Shared_number other_was_running;
    Shared_number attempts;
    EXPECT_EQ(exit_success, run(2, 2, false, [&](int number, Progress&) {
                if (number == 1) {
                  *other_is_running = 1;
                  wait_until([&] { return *attempts > 0; });
                  *other_is_running = 0;
                  return;
                }
                if (*attempts == 0) wait_until([&] { return *other_is_running == 1; });
                ++*attempts;
                if (*attempts > 1) {
                  *other_was_running = (*other_is_running).load();
                } else if (is_killed) {
                  raise(SIGKILL);
                } else {
                  throw std::bad_alloc();
                }
              }));
    EXPECT_EQ(2, *attempts);
    EXPECT_EQ(0, *other_was_running);
    EXPECT_TRUE(has_result(0));
    EXPECT_TRUE(has_result(1));
    EXPECT_THAT(summary(), HasSubstr("input0.number,done,"));
    EXPECT_THAT(errors_.str(), IsEmpty());
  }
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
  Shared_number computed;
  EXPECT_EQ(exit_success, run(3, 2, true, [&](int number, Progress&) { *computed += 1 << number; }));
  EXPECT_EQ(1 << 1, *computed);
  EXPECT_TRUE(has_result(1));
  EXPECT_THAT(summary(), HasSubstr("input0.number,skipped,"));
}

TEST_F(Batch_test, CrashFailsOneInputAndNoOther) {
  rlimit core_size{};
  getrlimit(RLIMIT_CORE, &core_size);
  const rlimit none{0, core_size.rlim_max};
  setrlimit(RLIMIT_CORE, &none);
  for (const int jobs : {1, 3}) {
    SCOPED_TRACE(jobs);
    fs::remove_all(output());
    EXPECT_EQ(exit_some_failed, run(12, jobs, false, [](int number, Progress&) {
                // Sanitizers would report these, and exit.
                for (const int signal : {SIGSEGV, SIGABRT}) std::signal(signal, SIG_DFL);
                if (number == 0 || number == 5) raise(SIGSEGV);
                if (number == 6) std::abort();
                if (number == 7) raise(SIGKILL);
                if (number == 11) std::_Exit(0);
              }));
    const std::string errors = errors_.str();
    for (int i = 0; i < 12; ++i) EXPECT_EQ(has_result(i), i != 0 && i != 5 && i != 6 && i != 7 && i != 11) << i;
    for (const char* line : {"input0.number: the program crashed (signal 11) while it computed this\n",
                             "input5.number: the program crashed (signal 11) while it computed this\n",
                             "input6.number: the program crashed (signal 6) while it computed this\n",
                             "input11.number: the process ended while it computed this\n"})
      EXPECT_THAT(errors, HasSubstr(line));
    EXPECT_THAT(errors, HasSubstr(jobs == 1 ? "input7.number: the process was killed, as happens when memory runs out "
                                              "(signal 9) while it computed this\n"
                                            : "input7.number: the process was killed"));
    EXPECT_EQ(5, std::ranges::count(errors, '\n'));
    EXPECT_THAT(summary(), HasSubstr("input5.number,failed,"));
    EXPECT_THAT(summary(), HasSubstr("input8.number,done,"));
    EXPECT_EQ(12, std::ranges::count(text_of(output() / "stats.jsonl"), '\n'));
    EXPECT_THAT(unfinished(), IsEmpty());
  }
  // None of it is in the way of another run.
  Shared_number computed;
  EXPECT_EQ(exit_success, run(12, 2, true, [&](int, Progress&) { ++*computed; }));
  EXPECT_EQ(5, *computed);
  EXPECT_THAT(errors_.str(), IsEmpty());
  setrlimit(RLIMIT_CORE, &core_size);
}

/// Longer than what a socket holds.
TEST_F(Batch_test, LongWarningsArriveWhole) {
  const std::string reason = std::string(1'000'000, 'x') + " \"end\"";
  EXPECT_EQ(exit_success, run(1, 1, false, [&](int, Progress&) { throw Unavailable(reason); }));
  EXPECT_TRUE(errors_.str().ends_with("input0.number: layer work: " + reason + "\n")) << errors_.str().substr(0, 200);
}

TEST_F(Batch_test, SignalStopsTheRunAndLeavesOnlyCompleteResults) {
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(output());
    EXPECT_EQ(exit_interrupted, run(4, 1, false, [&](int number, Progress& progress) {
                if (number != 2) return;
                kill(getppid(), signal);
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

/// As of a terminal, which sends it to all processes.
TEST_F(Batch_test, SignalsToWorkersAreLeftToTheRun) {
  EXPECT_EQ(exit_success, run(3, 2, false, [](int, Progress&) { kill(getpid(), SIGINT); }));
  EXPECT_TRUE(has_result(2));
}

TEST_F(Batch_test, ComputationThatDoesNotStopIsEnded) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(exit_interrupted, run(2, 2, false, [this](int number, Progress& progress) {
              if (number == 0) return;
              wait_until([this] { return has_result(0); });
              kill(getppid(), SIGINT);
              wait_until([&] { return progress.is_cancelled(); });
              std::this_thread::sleep_for(std::chrono::minutes(5));
            }));
  EXPECT_THAT(errors_.str(), HasSubstr("stopped: 1 of 2 done"));
  EXPECT_TRUE(has_result(0));
  EXPECT_FALSE(has_result(1));
  EXPECT_THAT(summary(), HasSubstr("input0.number,done,"));
  EXPECT_THAT(unfinished(), IsEmpty());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
}

TEST_F(Batch_death_test, SecondSignalEndsTheProcessAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EXIT(run(
                  1, 1, false,
                  [](int, Progress& progress) {
                    kill(getppid(), SIGINT);
                    wait_until([&] { return progress.is_cancelled(); });
                    std::cerr << "stopping" << std::flush;
                    kill(getppid(), SIGINT);
                    std::this_thread::sleep_for(std::chrono::minutes(5));
                  },
                  std::cerr),
              testing::ExitedWithCode(exit_interrupted), "stopping");
  EXPECT_FALSE(fs::exists(output() / "summary.csv"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
}

TEST_F(Batch_death_test, WorkersEndWithAProgramThatIsKilled) {
  Shared_number worker;
  EXPECT_EXIT(run(
                  1, 1, false,
                  [&](int, Progress&) {
                    *worker = getpid();
                    kill(getppid(), SIGKILL);
                    std::this_thread::sleep_for(std::chrono::minutes(5));
                  },
                  std::cerr),
              testing::KilledBySignal(SIGKILL), "");
  // It may be a zombie of whoever takes in orphans for a while.
  const fs::path about = fs::path("/proc") / std::to_string(*worker) / "stat";
  wait_until([&] {
    const std::string text = text_of(about);
    return text.empty() || text.find(") Z ") != std::string::npos || text.find(") X ") != std::string::npos;
  });
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
