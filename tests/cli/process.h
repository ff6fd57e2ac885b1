// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace evenmesh::testing {

/// What a child process left behind.
struct Outcome {
  int exit_code = -1;  // -1: it did not exit by itself
  int signal = 0;      // that ended it
  bool timed_out = false;
  std::string out;
  std::string err;
};

struct RunOptions {
  double time_limit_seconds = 120.0;          // then it is killed
  std::string folder = {};                    // to run in; empty: this process's own
  std::string out = {};                       // file to connect stdout to; empty: collected
  bool close_out = false;                     // no stdout at all
  std::vector<std::string> environment = {};  // "NAME=value", beside this process's own
  /// Called while the child runs, from this process; may send it signals.
  std::function<void(pid_t child)> meanwhile = {};
};

/// Runs the program under test with these arguments (no shell), stdin from /dev/null.
Outcome run(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace evenmesh::testing
