// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "evenmesh/base/vec3.h"
#include "evenmesh/geometry/analytic_tracks.h"

namespace evenmesh {

/// A track through points, as well as it can be.
template <class FittedTrack>
struct Fit {
  FittedTrack track;
  double greatest_distance;  // of a point from the track, in the points' length unit
};

// Each minimises the sum of the squares of the points' distances and gives nothing where the points
// do not say which track it is, up to rounding: where there are too few, where they coincide, lie
// on a line or plane of which many such tracks are as near, or on one so flat that its radius would
// exceed 10^6 times the points' extent. Points exactly on a track give it back up to rounding.
// Time is linear in the points.

/// @param points  at least 2 different ones
std::optional<Fit<LineTrack>> fit_line(Points points);

/// @param points  at least 3 not on a line
std::optional<Fit<PlaneTrack>> fit_plane(Points points);

/// The circle in the best plane that comes nearest to the points' shadows there.
/// @param points  at least 3 not on a line
std::optional<Fit<CircleTrack>> fit_circle(Points points);

/// @param points  at least 4 not in a plane
std::optional<Fit<SphereTrack>> fit_sphere(Points points);

/// The best of what descents from 13 directions of the axis, and that which the normals tell if
/// there are any, arrive at.
/// @param points   at least 6 not in a plane
/// @param normals  unit normals of the surface at some points, any signs; may be empty
std::optional<Fit<CylinderTrack>> fit_cylinder(Points points, std::span<const Vec3> normals = {});

}  // namespace evenmesh
