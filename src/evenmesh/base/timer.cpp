// SPDX-License-Identifier: MIT
#include "evenmesh/base/timer.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include <sys/resource.h>

namespace evenmesh {

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t peak_memory_bytes() {
  // Not getrusage(): its peak is inherited from the parent across exec.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("VmHWM:")) continue;
    return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024;  // the kernel counts kibibytes
  }
  return 0;
}

}  // namespace evenmesh
