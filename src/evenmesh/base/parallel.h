// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace evenmesh {

/// A few threads that run numbered tasks.
///
/// Which thread runs which task is left to chance, so a task must not care: tasks of one call
/// write to places of their own. Everything in evenmesh that adds numbers up does so per task and
/// then over the tasks in their order, which is why results have the same bits for any number of
/// threads.
class Workers {
 public:
  /// @param threads  how many threads work, the caller's included; 0 means one per core
  explicit Workers(int threads = 1);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls task(i) once for every i in [0, count) and returns when all are done.
  /// The first exception a task throws is thrown again here. Not reentrant.
  void run(std::size_t count, const std::function<void(std::size_t)>& task);

 private:
  void work();
  void take_tasks();

  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable start_;
  std::condition_variable done_;
  std::size_t round_ = 0;    // guarded by mutex_; counts the calls of run()
  std::size_t waiting_ = 0;  // guarded by mutex_; helpers that have not finished this round
  bool stop_ = false;        // guarded by mutex_
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
  std::exception_ptr error_;  // guarded by mutex_
};

/// How many items one task of for_ranges() and sum_over_ranges() handles. Part of the result's
/// bits: sums are formed per range.
inline constexpr std::size_t kRangeSize = 16384;

/// Calls body(first, last) for consecutive ranges that cover [0, n).
void for_ranges(Workers& workers, std::size_t n,
                const std::function<void(std::size_t first, std::size_t last)>& body);

/// Sum of body(first, last) over consecutive ranges that cover [0, n), added in their order.
double sum_over_ranges(Workers& workers, std::size_t n,
                       const std::function<double(std::size_t first, std::size_t last)>& body);

}  // namespace evenmesh
