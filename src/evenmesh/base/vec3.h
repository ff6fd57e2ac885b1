// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross()

namespace evenmesh {

/// A point or a vector in space, in the length unit of the input file.
using Vec3 = Eigen::Vector3d;

/// A read-only view of positions, one per vertex.
using Points = std::span<const Vec3>;

/// A vertex number, counted from 0. 32 bits hold every mesh that fits one machine.
using Index = std::uint32_t;

/// A position in an array over cell corners, which may exceed 2^32.
using Offset = std::uint64_t;

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points must be contiguous doubles");

}  // namespace evenmesh
