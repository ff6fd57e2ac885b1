// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace evenmesh {

/// Everything the library throws on purpose. Broken preconditions are asserts instead, and
/// numerical outcomes (an iteration limit, no descent) are values in the Report.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Connectivity or positions that no mesh can have: an index out of range, a coordinate that is
/// not finite.
class InvalidMesh : public Error {
 public:
  using Error::Error;
};

/// An option, a selector or a weight outside its range. The message names it and the remedy.
class InvalidOption : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written. The message starts with `file:line:` where there is a
/// line and with `file:` otherwise.
class IoError : public Error {
 public:
  using Error::Error;
};

}  // namespace evenmesh
