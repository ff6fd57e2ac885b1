// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace evenmesh::shapes {

/// The least cost `local` that Ipopt finds when no triangle may have less than a given area.
///
/// Made by  oracle_ipopt SHAPE VERTICES SEED NOISE LEAST RIM  (bench/) with the fields below in
/// that order, exact derivatives and a tolerance of 1e-9; all digits given are the same from every
/// start listed for one problem (noise moves the boundary of a disk: with a fixed one, each noise
/// is a problem of its own). Turning the whole disk changes nothing, so minimisers are many; their
/// cost is one.
struct IpoptMinimum {
  std::string_view shape;  // disk: disk_triangles(); square: irregular_triangles(), jitter 0.3
  std::size_t vertices;    // as asked for
  std::uint64_t seed;
  double noise;
  double least;          // part of the mean area of the mesh without noise
  std::string_view rim;  // slide: boundary vertices stay on the unit circle; fixed: where they are
  double least_area;     // the limit itself: least times that mean area
  double cost;
  std::size_t inverted;  // triangles, at the start
  std::size_t at_limit;  // triangles, at the minimum
};

inline constexpr std::array<IpoptMinimum, 15> kIpoptMinima{{
    {"disk", 1000, 1, 0, 0.2, "slide", 0.00032302682728042095, 0.09662257357, 0, 41},
    {"disk", 1000, 1, 1, 0.2, "slide", 0.00032302682728042095, 0.09662257357, 443, 41},
    {"disk", 1000, 1, 2, 0.2, "slide", 0.00032302682728042095, 0.09662257357, 776, 41},
    {"disk", 1000, 1, 0, 0.6, "slide", 0.0009690804818412628, 0.105450257, 0, 60},
    {"disk", 1000, 1, 1, 0.6, "slide", 0.0009690804818412628, 0.105450257, 443, 60},
    {"disk", 10000, 1, 0, 0.2, "slide", 3.222956733613571e-05, 0.09405361134, 0, 272},
    {"disk", 10000, 1, 1, 0.2, "slide", 3.222956733613571e-05, 0.09405361134, 4398, 272},
    {"disk", 10000, 1, 0, 0.6, "slide", 9.668870200840714e-05, 0.1001595954, 0, 500},
    {"disk", 10000, 1, 0, 0.2, "fixed", 3.222956733613571e-05, 0.1235392187, 0, 0},
    {"disk", 10000, 1, 1, 0.2, "fixed", 3.222956733613571e-05, 0.1312458916, 4398, 1},
    {"square", 1000, 1, 0, 0.7, "fixed", 0.00038377192982456113, 0.01474473819, 0, 48},
    {"square", 1000, 1, 0.95, 0.7, "fixed", 0.00038377192982456113, 0.01474473819, 426, 48},
    {"square", 10000, 1, 0, 0.2, "fixed", 1.0198878123406437e-05, 0.009059336496, 0, 0},
    {"square", 10000, 1, 0.95, 0.2, "fixed", 1.0198878123406437e-05, 0.009059336496, 4766, 0},
    {"square", 10000, 1, 0, 0.7, "fixed", 3.569607343192253e-05, 0.009117577438, 0, 193},
}};

}  // namespace evenmesh::shapes
