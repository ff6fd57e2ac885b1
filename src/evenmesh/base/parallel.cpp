// SPDX-License-Identifier: MIT
#include "evenmesh/base/parallel.h"

#include <algorithm>
#include <system_error>

namespace evenmesh {

Workers::Workers(int threads) {
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  helpers_.reserve(static_cast<std::size_t>(threads - 1));
  try {
    for (int i = 1; i < threads; ++i) helpers_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    // The system gives no more. Those there are do the work: results do not depend on their number.
  }
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  start_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Workers::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (helpers_.empty() || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    count_ = count;
    next_ = 0;
    error_ = nullptr;
    waiting_ = helpers_.size();
    ++round_;
  }
  start_.notify_all();
  take_tasks();
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return waiting_ == 0; });
  if (error_) std::rethrow_exception(error_);
}

void Workers::work() {
  std::size_t seen = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      start_.wait(lock, [&] { return stop_ || round_ != seen; });
      if (stop_) return;
      seen = round_;
    }
    take_tasks();
    const std::lock_guard lock(mutex_);
    if (--waiting_ == 0) done_.notify_one();
  }
}

void Workers::take_tasks() {
  try {
    for (std::size_t i = next_++; i < count_; i = next_++) (*task_)(i);
  } catch (...) {
    next_ = count_;  // the others need not start anything new
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
  }
}

void for_ranges(Workers& workers, std::size_t n,
                const std::function<void(std::size_t first, std::size_t last)>& body) {
  const std::size_t count = (n + kRangeSize - 1) / kRangeSize;
  workers.run(count,
              [&](std::size_t i) { body(i * kRangeSize, std::min(n, (i + 1) * kRangeSize)); });
}

double sum_over_ranges(Workers& workers, std::size_t n,
                       const std::function<double(std::size_t first, std::size_t last)>& body) {
  std::vector<double> partial((n + kRangeSize - 1) / kRangeSize, 0.0);
  workers.run(partial.size(), [&](std::size_t i) {
    partial[i] = body(i * kRangeSize, std::min(n, (i + 1) * kRangeSize));
  });
  double sum = 0.0;
  for (const double value : partial) sum += value;
  return sum;
}

}  // namespace evenmesh
