// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace mesecina::test {
namespace {

TEST(At_once, CallsBothAndTheFirstOnThisThread) {
  for (const int threads : {1, 2, 4}) {
    Progress progress({}, {}, threads);
    std::vector<int> squares(100'000);
    std::thread::id caller;
    int sum = 0;
    at_once(
        progress,
        [&] {
          caller = std::this_thread::get_id();
          parallel_for(squares.size(), progress, [&](std::size_t i) { squares[i] = static_cast<int>(i % 1000); });
        },
        [&] {
          for (int i = 1; i <= 1000; ++i) sum += i;
        });
    EXPECT_EQ(caller, std::this_thread::get_id()) << threads;
    EXPECT_EQ(sum, 500'500) << threads;
    for (std::size_t i = 0; i < squares.size(); ++i) ASSERT_EQ(squares[i], static_cast<int>(i % 1000)) << threads;
  }
}

TEST(At_once, OnOneThreadCallsOneAfterTheOther) {
  std::string calls;
  at_once(
      Progress(), [&] { calls += "first "; }, [&] { calls += "second"; });
  EXPECT_EQ(calls, "first second");
}

/// What was thrown, by its text.
template <class First, class Second>
std::string thrown(int threads, const First& first, const Second& second) {
  try {
    at_once(Progress({}, {}, threads), first, second);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(At_once, ThrowsWhatIsThrown) {
  const auto nothing = [] {};
  const auto first = [] { throw std::runtime_error("first"); };
  const auto second = [] { throw std::runtime_error("second"); };
  for (const int threads : {1, 2}) {
    EXPECT_EQ(thrown(threads, first, nothing), "first") << threads;
    EXPECT_EQ(thrown(threads, nothing, second), "second") << threads;
    EXPECT_EQ(thrown(threads, first, second), "first") << threads;
  }
}

TEST(At_once, DoesNotLeaveTheSecondRunning) {
  for (int repetition = 0; repetition < 20; ++repetition) {
    std::atomic<bool> is_started = false;
    std::atomic<bool> is_over = false;
    const auto first = [&] {
      const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(2);
      while (!is_started && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
      throw std::runtime_error("first");
    };
    const auto second = [&] {
      is_started = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      is_over = true;
    };
    if (tbb::info::default_concurrency() < 2) GTEST_SKIP() << "one core";
    EXPECT_EQ(thrown(2, first, second), "first");
    EXPECT_TRUE(is_over);
  }
}

}  // namespace
}  // namespace mesecina::test
