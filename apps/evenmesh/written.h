// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/evenmesh/loading.h"
#include "evenmesh/base/error.h"
#include "evenmesh/problem/problem.h"

namespace evenmesh::app {

/// What is in a new file breaks the promise: it must not replace anything.
class Refused : public Error {
 public:
  using Error::Error;
};

/// Per vertex: it may not move, nor is it brought to a target.
std::vector<char> staying_vertices(const Problem& problem);

/// The same without nodes between corners, which move along with others.
std::vector<char> staying_vertices(const Problem& problem, const Input& input);

/// Judges the promise on what was read back from the new file.
/// @param allow_worse  quality does not count
/// @throws Refused  it is broken
void check_written(const Input& input, const Problem& problem, const Mesh& written,
                   bool allow_worse, int threads);

}  // namespace evenmesh::app
