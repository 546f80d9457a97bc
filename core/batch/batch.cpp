// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <thread>
#include <utility>

#include "core/batch/input_runner.h"
#include "core/batch/messages.h"
#include "core/batch/stop_signals.h"
#include "core/batch/summary.h"
#include "core/batch/worker_pool.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// What a worker says of an input.
struct Answer {
  enum class Kind { computed, failed, found, short_of_memory, cancelled };
  Kind kind = Kind::computed;
  std::string reason;                ///< of a failure
  std::vector<std::string> refused;  ///< why pictures of a computed one are missing
  std::vector<std::string> warnings;
  std::string statistics;  ///< a line without a newline; empty if they are not wanted
};

std::string to_bytes(const Answer& answer) {
  // Texts may quote files, so they need not be UTF-8; this format takes any bytes.
  std::string bytes;
  nlohmann::json::to_msgpack(
      {static_cast<int>(answer.kind), answer.reason, answer.refused, answer.warnings, answer.statistics}, bytes);
  return bytes;
}

Answer answer_of(const std::string& bytes) {
  const auto json = nlohmann::json::from_msgpack(bytes);
  return {static_cast<Answer::Kind>(json.at(0).get<int>()), json.at(1), json.at(2), json.at(3), json.at(4)};
}

/// Says how far the film of the only input is.
class Frame_progress {
 public:
  Frame_progress(Messages& messages, bool is_shown) : messages_(messages), is_shown_(is_shown) {}
  ~Frame_progress() {
    if (shown_ > 0) messages_.end_progress();
  }
  Frame_progress(const Frame_progress&) = delete;
  Frame_progress& operator=(const Frame_progress&) = delete;

  void report(int done, int all) {
    if (!is_shown_) return;
    if (!left_) left_ = Time_left(static_cast<std::uintmax_t>(all));
    left_->count(1, true);
    // Not more often than one can read.
    constexpr double pause = 0.5;
    const double now = std::chrono::duration<double>(Clock::now() - start_).count();
    if (now - last_ < pause) return;
    last_ = now;
    ++shown_;
    const std::string left = left_->text(now);
    messages_.show_progress("film: " + std::to_string(100LL * done / all) + " %" + (left.empty() ? "" : ", " + left));
  }

 private:
  Messages& messages_;
  bool is_shown_;
  std::optional<Time_left> left_;
  Clock::time_point start_ = Clock::now();
  double last_ = 0;
  int shown_ = 0;
};

/// While an input is computed, large arrays come and go: their memory is kept for the next ones, as to get it from the
/// system each time takes a twentieth of the whole. What the input before left is given back.
void keep_memory_within_input() {
#ifdef __GLIBC__
  constexpr int ahead = 1 << 27;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, 2 * ahead);
  mallopt(M_TOP_PAD, ahead);
  malloc_trim(0);
#endif
}

/// One run of the batch: what is the same for all inputs.
class Batch {
 public:
  Batch(const Command_line& command_line, const std::string& program, const std::shared_ptr<const Registry>& registry,
        const Formats& formats, std::ostream& errors, bool is_terminal);
  int run();

 private:
  using Indices = std::vector<std::size_t>;
  enum class State { waiting, computed, incomplete, found, failed };
  /// Of one input.
  struct Row {
    State state = State::waiting;
    std::string statistics;  ///< its line, without a newline
    std::uintmax_t bytes = 0;
  };

  static const char* word_for(State state);
  bool refuse(const std::string& reason);
  bool prepare();
  void compute_all(const Indices& indices, int jobs, const Stop_signals& signals);
  Answer compute(std::size_t index, const std::stop_token& stop);
  void finish(const Worker_pool::Done& done, bool is_alone);
  void finish(std::size_t index, const Answer& answer, bool is_alone);
  void fail(std::size_t index, const std::string& reason);
  void note(std::size_t index, State state, std::string line);
  std::string progress_text() const;
  void flush_statistics();
  bool write_tables();
  int interrupted();

  const Command_line& command_line_;
  Messages messages_;
  Output_folder folder_;
  Input_runner runner_;
  Summary summary_;
  const std::vector<fs::path>& files_;
  int cores_ = 1;

  std::vector<Row> rows_;
  std::size_t next_line_ = 0;  ///< of the statistics
  std::ofstream stats_;
  Indices alone_;  ///< to be computed at the end, without others
  bool is_stopped_ = false;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  std::size_t incomplete_ = 0;
  Time_left time_left_{0};
  Clock::time_point start_ = Clock::now();
};

Batch::Batch(const Command_line& command_line, const std::string& program,
             const std::shared_ptr<const Registry>& registry, const Formats& formats, std::ostream& errors,
             bool is_terminal)
    : command_line_(command_line),
      messages_(errors, program, command_line.log,
                is_terminal && (command_line.files.size() > 1 || command_line.recording)),
      folder_(command_line.output),
      runner_(command_line, registry, formats, folder_),
      summary_(runner_.layers(), registry->dimension()),
      files_(command_line.files),
      cores_(std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

bool Batch::refuse(const std::string& reason) {
  messages_.say(Log_level::error, reason);
  return false;
}

bool Batch::prepare() {
  std::map<std::string, fs::path> stems;
  for (const fs::path& file : files_) {
    const auto [it, is_new] = stems.emplace(file.stem().string(), file);
    if (!is_new)
      return refuse(it->second.string() + " and " + file.string() + " would both write '" + it->first +
                    ".*'; give one of them another --output");
  }
  if (command_line_.recording) {
    std::error_code error;
    const fs::path folder = fs::absolute(command_line_.recording->file, error).parent_path();
    fs::create_directories(folder, error);
    if (error) return refuse("--record: " + folder.string() + " cannot be made a directory (" + error.message() + ")");
  }
  const auto reason = runner_.uses_folder() ? folder_.create() : std::nullopt;
  if (reason) return refuse("--output " + folder_.path().string() + ": cannot be made a directory (" + *reason + ")");
  if (command_line_.stats) {
    stats_.open(*command_line_.stats);
    if (!stats_) return refuse("--stats " + command_line_.stats->string() + ": cannot be written");
  }
  rows_.resize(files_.size());
  std::uintmax_t bytes = 0;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(files_[i], error);
    rows_[i].bytes = error ? 1 : size + 1;
    bytes += rows_[i].bytes;
  }
  time_left_ = Time_left(bytes);
  return true;
}

/// In a number of processes. Returns when all are computed, or have stopped because they were asked to.
void Batch::compute_all(const Indices& indices, int jobs, const Stop_signals& signals) {
  if (indices.empty() || is_stopped_) return;
  jobs = static_cast<int>(std::min(static_cast<std::size_t>(jobs), indices.size()));
  Worker_pool workers(
      jobs, {[this](std::size_t index, const std::stop_token& stop) { return to_bytes(compute(index, stop)); },
             [this] { folder_.close(); }});
  for (auto next = indices.begin();;) {
    while (!is_stopped_ && next != indices.end() && workers.has_idle()) workers.give(*next++);
    if (!workers.has_busy()) return;
    if (const auto done = workers.wait(signals.descriptor())) {
      finish(*done, jobs == 1);
    } else if (signals.take()) {
      if (is_stopped_) std::_Exit(exit_interrupted);
      is_stopped_ = true;
      workers.stop();
    }
  }
}

/// In the process of a worker.
Answer Batch::compute(std::size_t index, const std::stop_token& stop) {
  keep_memory_within_input();
  const fs::path& file = files_[index];
  Answer answer;
  try {
    if (command_line_.resume) {
      if (auto record = runner_.find_complete(file)) {
        answer.kind = Answer::Kind::found;
        answer.statistics = std::move(*record);
        return answer;
      }
    }
    const int threads =
        command_line_.threads > 0 ? command_line_.threads : std::max(1, cores_ / std::max(1, command_line_.jobs));
    Frame_progress frames(messages_, files_.size() == 1);
    Input_statistics statistics =
        runner_.compute(file, threads, stop, [&](int frame, int all) { frames.report(frame, all); });
    if (statistics.failed) answer.kind = Answer::Kind::failed;
    answer.reason = statistics.reason;
    for (const auto& [format, reason] : statistics.refused) answer.refused.push_back(reason);
    if (command_line_.stats) answer.statistics = to_json_line(statistics);
    if (!answer.statistics.empty()) answer.statistics.pop_back();
    answer.warnings = std::move(statistics.warnings);
  } catch (const Cancelled&) {
    answer.kind = Answer::Kind::cancelled;
  } catch (const std::bad_alloc&) {
    answer.kind = Answer::Kind::short_of_memory;
  }
  return answer;
}

void Batch::finish(const Worker_pool::Done& done, bool is_alone) {
  if (done.answer) {
    finish(done.task, answer_of(*done.answer), is_alone);
    return;
  }
  runner_.discard(files_[done.task]);
  if (is_stopped_) return;
  // So does the kernel, to whoever uses most, when memory runs out.
  if (done.signal == SIGKILL && !is_alone) {
    Answer answer;
    answer.kind = Answer::Kind::short_of_memory;
    finish(done.task, answer, is_alone);
    return;
  }
  const std::string what = done.signal == 0         ? "the process ended"
                           : done.signal == SIGKILL ? "the process was killed, as happens when memory runs out"
                                                    : "the program crashed";
  const std::string how = done.signal == 0 ? "" : " (signal " + std::to_string(done.signal) + ")";
  fail(done.task, what + how + " while it computed this");
}

void Batch::finish(std::size_t index, const Answer& answer, bool is_alone) {
  const std::string file = files_[index].string();
  switch (answer.kind) {
    case Answer::Kind::computed:
      // A reader's warning names its file already.
      for (const std::string& warning : answer.warnings)
        messages_.say(Log_level::warning, (warning.starts_with(file) ? "" : file + ": ") + warning);
      for (const std::string& reason : answer.refused) messages_.say(Log_level::error, reason);
      note(index, answer.refused.empty() ? State::computed : State::incomplete, answer.statistics);
      break;
    case Answer::Kind::failed:
      messages_.say(Log_level::error, answer.reason);
      note(index, State::failed, answer.statistics);
      break;
    case Answer::Kind::found: {
      std::string line;
      if (command_line_.stats) {
        auto json = nlohmann::ordered_json::parse(answer.statistics);
        json["input"] = file;
        line = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
      }
      messages_.say(Log_level::info, file + ": results are complete; skipped");
      note(index, State::found, std::move(line));
      break;
    }
    case Answer::Kind::short_of_memory:
      if (is_alone) {
        fail(index, "not enough memory");
      } else {
        messages_.say(Log_level::info, file + ": not enough memory beside others; tried again at the end");
        alone_.push_back(index);
      }
      break;
    case Answer::Kind::cancelled:
      break;
  }
}

void Batch::fail(std::size_t index, const std::string& reason) {
  Input_statistics statistics;
  statistics.input = files_[index].string();
  statistics.failed = true;
  statistics.reason = statistics.input + ": " + reason;
  messages_.say(Log_level::error, statistics.reason);
  std::string line = command_line_.stats ? to_json_line(statistics) : std::string();
  if (!line.empty()) line.pop_back();
  note(index, State::failed, std::move(line));
}

void Batch::note(std::size_t index, State state, std::string line) {
  rows_[index].state = state;
  rows_[index].statistics = std::move(line);
  ++done_;
  if (state == State::failed) ++failed_;
  if (state == State::incomplete) ++incomplete_;
  time_left_.count(rows_[index].bytes, state == State::computed || state == State::incomplete);
  flush_statistics();
  messages_.show_progress(progress_text());
}

std::string Batch::progress_text() const {
  std::string text = std::to_string(done_) + " of " + std::to_string(files_.size()) + " done";
  if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
  const std::string left = time_left_.text(std::chrono::duration<double>(Clock::now() - start_).count());
  return left.empty() ? text : text + ", " + left;
}

/// Lines come in the order of the inputs, each as soon as those before it are there.
void Batch::flush_statistics() {
  if (!command_line_.stats) return;
  for (; next_line_ < rows_.size() && rows_[next_line_].state != State::waiting; ++next_line_)
    stats_ << rows_[next_line_].statistics << '\n';
  stats_.flush();
}

/// In the summary.
const char* Batch::word_for(State state) {
  switch (state) {
    case State::computed:
      return "done";
    case State::incomplete:
      return "incomplete";
    case State::found:
      return "skipped";
    default:
      return "failed";
  }
}

/// The rest of the statistics, and the summary. Returns whether they could be written.
bool Batch::write_tables() {
  if (!command_line_.stats) return true;
  for (; next_line_ < rows_.size(); ++next_line_)
    if (rows_[next_line_].state != State::waiting) stats_ << rows_[next_line_].statistics << '\n';
  bool is_good = true;
  if (!stats_.flush())
    is_good = refuse("--stats " + command_line_.stats->string() + ": could not be written to its end");
  try {
    write_file(folder_.path() / "summary.csv", [&](std::ostream& stream) {
      stream << summary_.header();
      for (const Row& row : rows_)
        if (row.state != State::waiting) stream << summary_.row(word_for(row.state), row.statistics);
    });
  } catch (const File_error& error) {
    is_good = refuse(error.what());
  }
  return is_good;
}

int Batch::interrupted() {
  messages_.end_progress();
  write_tables();
  messages_.say(Log_level::error, "stopped: " + std::to_string(done_) + " of " + std::to_string(files_.size()) +
                                      " done; the same command with --resume goes on");
  return exit_interrupted;
}

int Batch::run() {
  if (!prepare()) return exit_wrong_usage;
  for (const std::string& warning : command_line_.warnings) messages_.say(Log_level::warning, warning);
  const Stop_signals signals;
  Indices indices;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const bool has_ended_a_run = command_line_.resume && folder_.is_begun(files_[i]);
    if (has_ended_a_run)
      messages_.say(Log_level::warning,
                    files_[i].string() + ": an earlier run was killed while it computed this; now it comes last");
    (has_ended_a_run ? alone_ : indices).push_back(i);
  }
  compute_all(indices, command_line_.jobs, signals);
  compute_all(std::exchange(alone_, {}), 1, signals);
  if (done_ < files_.size()) return interrupted();
  messages_.end_progress();
  if (!write_tables()) return exit_some_failed;
  return failed_ + incomplete_ > 0 ? exit_some_failed : exit_success;
}

}  // namespace

int run_batch(const Command_line& command_line, const std::string& program,
              const std::shared_ptr<const Registry>& registry, const Formats& formats, std::ostream& errors,
              bool is_terminal) {
  return Batch(command_line, program, registry, formats, errors, is_terminal).run();
}

}  // namespace mesecina
