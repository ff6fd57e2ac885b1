// SPDX-License-Identifier: MIT
#pragma once

namespace evenmesh::app {

// What the program tells the shell. Part of the interface: scripts depend on it.
inline constexpr int kDone = 0;
inline constexpr int kInternalError = 1;
inline constexpr int kBadUsage = 2;     // a wrong option, selector or combination
inline constexpr int kBadFile = 3;      // cannot be read, is broken, unsupported; or not written
inline constexpr int kBelowTarget = 4;  // check: some cell is inverted or degenerate; smoothing: a
                                        // demand is not met (what there is was written)
inline constexpr int kRefused = 5;      // nothing written: nothing gets better without harm
inline constexpr int kInterrupted = 130;

}  // namespace evenmesh::app
