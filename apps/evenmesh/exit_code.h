// SPDX-License-Identifier: MIT
#pragma once

namespace evenmesh::app {

/// What the program tells the shell. Part of the interface: scripts depend on it.
enum ExitCode : int {
  kDone = 0,
  kInternalError = 1,
  kBadUsage = 2,     // a wrong option, selector or combination
  kBadFile = 3,      // cannot be read, is broken or of a format not supported; or not written
  kBelowTarget = 4,  // check: some cell is inverted or degenerate
  kRefused = 5,  // nothing was written: nothing could be improved without making something worse
  kInterrupted = 130
};

}  // namespace evenmesh::app
