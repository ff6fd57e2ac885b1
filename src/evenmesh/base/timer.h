// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace evenmesh {

/// Wall-clock seconds since construction.
class Timer {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// CPU seconds this process has used so far, user and system, over all threads.
double cpu_seconds();

/// The most memory this process has held resident so far, in bytes; 0 where the system cannot say.
std::uint64_t peak_memory_bytes();

}  // namespace evenmesh
