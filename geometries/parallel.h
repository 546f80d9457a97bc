// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>

#include "core/progress.h"

namespace mesecina {

/// Runs body() where TBB's algorithms use as many threads as `progress` allows and the machine has.
template <class Body>
void parallel_region(const Progress& progress, const Body& body) {
  if (progress.threads() <= 1) {
    body();
  } else {
    // For more it would print a warning.
    tbb::task_arena(std::min(progress.threads(), tbb::info::default_concurrency())).execute(body);
  }
}

/// Calls both, the second at the same time as the first if `progress` allows a second thread. They must not depend on
/// each other. Only the first may report progress: it is called by this thread. Throws what the first throws, else what
/// the second does.
template <class First, class Second>
void at_once(const Progress& progress, const First& first, const Second& second) {
  if (progress.threads() <= 1) {
    first();
    second();
    return;
  }
  parallel_region(progress, [&] {
    tbb::task_group other;
    other.run([&second] { second(); });
    try {
      first();
    } catch (...) {
      try {
        other.wait();
      } catch (...) {
        // What the first threw goes before.
      }
      throw;
    }
    other.wait();
  });
}

/// Calls body(b) for b in [0, blocks), on as many threads as `progress` allows, testing for cancellation before each.
/// The calls must be independent of each other, so that the result is the same for every number of threads.
template <class Body>
void parallel_blocks(std::size_t blocks, Progress& progress, const Body& body) {
  if (progress.threads() <= 1 || blocks <= 1) {
    for (std::size_t b = 0; b < blocks; ++b) {
      progress.check();
      body(b);
    }
    return;
  }
  parallel_region(progress, [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks), [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t b = range.begin(); b < range.end(); ++b) {
        progress.check();
        body(b);
      }
    });
  });
}

/// The same for single elements, a block at a time.
template <class Body>
void parallel_for(std::size_t count, Progress& progress, const Body& body) {
  constexpr std::size_t block = 8192;
  parallel_blocks((count + block - 1) / block, progress, [&](std::size_t b) {
    const std::size_t end = std::min(count, (b + 1) * block);
    for (std::size_t i = b * block; i < end; ++i) body(i);
  });
}

}  // namespace mesecina
