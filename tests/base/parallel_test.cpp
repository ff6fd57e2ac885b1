// SPDX-License-Identifier: MIT
#include "evenmesh/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

TEST(Workers, RunEveryTaskOnce) {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    for (const std::size_t count : {0u, 1u, 7u, 1000u}) {
      std::vector<std::atomic<int>> calls(count);
      workers.run(count, [&](std::size_t i) { ++calls[i]; });
      for (const auto& n : calls) EXPECT_EQ(n, 1);
    }
  }
}

TEST(Workers, PassOnTheFirstException) {
  Workers workers(3);
  EXPECT_THROW(workers.run(100,
                           [](std::size_t i) {
                             if (i == 50) throw std::runtime_error("fifty");
                           }),
               std::runtime_error);
  std::atomic<int> calls = 0;
  workers.run(10, [&](std::size_t) { ++calls; });  // and still work afterwards
  EXPECT_EQ(calls, 10);
}

TEST(SumOverRanges, HasTheSameBitsForAnyNumberOfThreads) {
  const std::size_t n = 5 * kRangeSize + 123;
  const auto body = [](std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i) sum += std::sin(static_cast<double>(i));
    return sum;
  };
  Workers one(1);
  const double expected = sum_over_ranges(one, n, body);
  for (const int threads : {2, 3, 8}) {
    Workers workers(threads);
    for (int repeat = 0; repeat < 20; ++repeat) {
      EXPECT_EQ(sum_over_ranges(workers, n, body), expected);
    }
  }
}

TEST(ForRanges, CoversEveryItemOnce) {
  Workers workers(2);
  std::vector<int> seen(3 * kRangeSize + 1, 0);
  for_ranges(workers, seen.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) ++seen[i];
  });
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

}  // namespace
}  // namespace evenmesh
