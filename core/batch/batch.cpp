// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <thread>
#include <utility>

#include "core/batch/input_runner.h"
#include "core/batch/messages.h"
#include "core/batch/stop_signals.h"
#include "core/batch/summary.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// One run of the batch: what is the same for all inputs.
class Batch {
 public:
  Batch(const Command_line& command_line, const std::string& program, const std::shared_ptr<const Registry>& registry,
        const Formats& formats, std::ostream& errors, bool is_terminal);
  int run();

 private:
  using Indices = std::vector<std::size_t>;
  enum class State { waiting, computed, found, failed };
  /// Of one input.
  struct Row {
    State state = State::waiting;
    std::string statistics;  ///< its line, without a newline
    std::uintmax_t bytes = 0;
  };

  bool refuse(const std::string& reason);
  bool prepare();
  void compute_all(const Indices& indices, int jobs);
  void process(std::size_t index, int jobs);
  void finish(std::size_t index, const Input_statistics& statistics);
  void finish_found(std::size_t index, const std::string& record);
  void note(std::size_t index, State state, std::string line);
  std::string progress_text() const;
  void flush_statistics();
  bool write_tables();
  int interrupted();
  [[noreturn]] void leave_behind();

  const Command_line& command_line_;
  Messages messages_;
  Output_folder folder_;
  Input_runner runner_;
  Summary summary_;
  const std::vector<fs::path>& files_;
  int cores_ = 1;

  std::mutex mutex_;  ///< of all below
  std::condition_variable changed_;
  std::stop_source stop_;
  int running_ = 0;
  std::vector<Row> rows_;
  std::size_t next_line_ = 0;  ///< of the statistics
  std::ofstream stats_;
  Indices alone_;  ///< to be computed at the end, without others
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  Time_left time_left_{0};
  Clock::time_point start_ = Clock::now();
};

Batch::Batch(const Command_line& command_line, const std::string& program,
             const std::shared_ptr<const Registry>& registry, const Formats& formats, std::ostream& errors,
             bool is_terminal)
    : command_line_(command_line),
      messages_(errors, program, command_line.log, is_terminal && command_line.files.size() > 1),
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
  if (const auto reason = folder_.create())
    return refuse("--output " + folder_.path().string() + ": cannot be made a directory (" + *reason + ")");
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

/// On a number of threads. Returns when all are computed, or have stopped because they were asked to.
void Batch::compute_all(const Indices& indices, int jobs) {
  jobs = static_cast<int>(std::min(static_cast<std::size_t>(jobs), indices.size()));
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < indices.size() && !stop_.stop_requested(); i = next++) process(indices[i], jobs);
    const std::lock_guard lock(mutex_);
    --running_;
    changed_.notify_all();
  };
  running_ = jobs;
  std::vector<std::jthread> workers;
  workers.reserve(static_cast<std::size_t>(jobs));
  for (int j = 0; j < jobs; ++j) workers.emplace_back(work);
  std::unique_lock lock(mutex_);
  const auto is_over = [&] { return running_ == 0; };
  changed_.wait(lock, [&] { return is_over() || stop_.stop_requested(); });
  constexpr std::chrono::seconds patience{1};
  if (!changed_.wait_for(lock, patience, is_over)) leave_behind();
}

void Batch::process(std::size_t index, int jobs) {
  const fs::path& file = files_[index];
  if (command_line_.resume) {
    if (const auto record = runner_.find_complete(file)) {
      finish_found(index, *record);
      return;
    }
  }
  try {
    const int threads =
        command_line_.threads > 0 ? command_line_.threads : std::max(1, cores_ / std::max(1, command_line_.jobs));
    finish(index, runner_.compute(file, threads, stop_.get_token()));
  } catch (const Cancelled&) {
    return;
  } catch (const std::bad_alloc&) {
    if (jobs > 1) {
      messages_.say(Log_level::info, file.string() + ": not enough memory beside others; tried again at the end");
      const std::lock_guard lock(mutex_);
      alone_.push_back(index);
      return;
    }
    Input_statistics statistics;
    statistics.input = file.string();
    statistics.failed = true;
    statistics.reason = file.string() + ": not enough memory";
    finish(index, statistics);
  }
}

void Batch::finish(std::size_t index, const Input_statistics& statistics) {
  if (statistics.failed) {
    messages_.say(Log_level::error, statistics.reason);
  } else {
    // A reader's warning names its file already.
    for (const std::string& warning : statistics.warnings)
      messages_.say(Log_level::warning,
                    (warning.starts_with(statistics.input) ? "" : statistics.input + ": ") + warning);
  }
  std::string line = command_line_.stats ? to_json_line(statistics) : std::string();
  if (!line.empty()) line.pop_back();
  note(index, statistics.failed ? State::failed : State::computed, std::move(line));
}

void Batch::finish_found(std::size_t index, const std::string& record) {
  std::string line;
  if (command_line_.stats) {
    auto json = nlohmann::ordered_json::parse(record);
    json["input"] = files_[index].string();
    line = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  messages_.say(Log_level::info, files_[index].string() + ": results are complete; skipped");
  note(index, State::found, std::move(line));
}

void Batch::note(std::size_t index, State state, std::string line) {
  std::string progress;
  {
    const std::lock_guard lock(mutex_);
    rows_[index].state = state;
    rows_[index].statistics = std::move(line);
    ++done_;
    if (state == State::failed) ++failed_;
    time_left_.count(rows_[index].bytes, state == State::computed);
    flush_statistics();
    progress = progress_text();
  }
  messages_.show_progress(progress);
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
        if (row.state != State::waiting)
          stream << summary_.row(row.state == State::computed ? "done"
                                 : row.state == State::found  ? "skipped"
                                                              : "failed",
                                 row.statistics);
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

/// Some computations take long to notice that they shall stop. What they do is lost in any case, so nobody waits.
void Batch::leave_behind() {
  folder_.close();
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (rows_[i].state == State::waiting) folder_.discard(files_[i]);
  std::_Exit(interrupted());
}

int Batch::run() {
  if (!prepare()) return exit_wrong_usage;
  const Stop_signals signals([this] {
    const std::lock_guard lock(mutex_);
    stop_.request_stop();
    changed_.notify_all();
  });
  Indices indices;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const bool has_ended_a_run = command_line_.resume && folder_.is_begun(files_[i]);
    if (has_ended_a_run)
      messages_.say(Log_level::warning,
                    files_[i].string() + ": an earlier run was killed while it computed this; now it comes last");
    (has_ended_a_run ? alone_ : indices).push_back(i);
  }
  compute_all(indices, command_line_.jobs);
  compute_all(std::exchange(alone_, {}), 1);
  if (done_ < files_.size()) return interrupted();
  messages_.end_progress();
  if (!write_tables()) return exit_some_failed;
  return failed_ > 0 ? exit_some_failed : exit_success;
}

}  // namespace

int run_batch(const Command_line& command_line, const std::string& program,
              const std::shared_ptr<const Registry>& registry, const Formats& formats, std::ostream& errors,
              bool is_terminal) {
  return Batch(command_line, program, registry, formats, errors, is_terminal).run();
}

}  // namespace mesecina
