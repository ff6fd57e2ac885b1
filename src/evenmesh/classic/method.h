// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace evenmesh {

/// What moves the vertices: our own minimiser of costs under constraints, or one of the smoothers
/// it is compared with. docs/classic.md has what each is good at and how it fails.
enum class Method : std::uint8_t {
  lagrange_newton,        // minimises the problem's costs; not a classic method
  laplacian,              // every vertex to the mean of its neighbours
  smart_laplacian,        // the same, where the worst cell around does not get worse
  combined,               // the same, and where it does get worse a climb of the worst shape
  global_laplacian,       // all vertices to the mean of their neighbours at once: a linear system
  lennard_jones,          // repelled by near, drawn to far neighbours: d^-13 - d^-7
  lennard_jones_printed,  // the same with d^-13 - d^-4
  pliant,                 // the same with (1 - d^4) exp(-d^4)
  angle_based,            // edges turn to halve the angles at the far ends
  optimal_delaunay        // to the weighted mean of the circumcentres around
};

/// The word for it on the command line and in reports: "smart_laplacian".
std::string_view name(Method method);

/// All words, lagrange_newton's first.
std::vector<std::string_view> method_names();

/// @throws InvalidOption  there is no such method; the message has a near word and all others
Method method_of(const std::string& word);

}  // namespace evenmesh
