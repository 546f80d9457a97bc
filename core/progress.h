// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/outcome.h"

namespace mesecina {

/// Passed to every computation: takes what it says of its advance, tells it when to stop, and how many threads it may
/// use. A long loop calls `report` or `check` at least every few milliseconds, so that cancelling takes effect within
/// 100 ms.
class Progress {
 public:
  using Listener = std::function<void(std::string_view stage, double fraction)>;

  Progress() = default;
  explicit Progress(std::stop_token stop, Listener listener = {}, int threads = 1)
      : stop_(std::move(stop)), listener_(std::move(listener)), threads_(threads) {}

  void begin_stage(std::string_view name) {
    stage_ = name;
    report(0);
  }
  /// `fraction` in [0,1] of the current stage. Throws Cancelled when a stop was asked for.
  void report(double fraction) {
    check();
    if (listener_) listener_(stage_, fraction);
  }
  /// Throws Cancelled when a stop was asked for. Safe to call from several threads.
  void check() const {
    if (stop_.stop_requested()) throw Cancelled();
  }
  bool is_cancelled() const { return stop_.stop_requested(); }
  /// Results never depend on it.
  int threads() const { return threads_; }

 private:
  std::stop_token stop_;
  Listener listener_;
  std::string stage_;
  int threads_ = 1;
};

}  // namespace mesecina
