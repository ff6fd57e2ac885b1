// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "evenmesh/geometry/track.h"
#include "evenmesh/problem/constraints.h"
#include "evenmesh/problem/scene.h"

namespace evenmesh {

/// Vertices that slide on figures, on the curves and the surface of the input, or on another
/// surface.
class Slides {
 public:
  /// Decides who takes part in which slide, and notes the first of each vertex in slide_of. What
  /// the shape hangs on stays: corners on every slide, edges where faces slide.
  /// @pre  default_of is known and not applied yet, slide_of is kNone everywhere
  Slides(const Scene& scene, Arrangement& arrangement);

  /// Puts vertices on what they slide on; those on several on what these have in common. What is
  /// off its figure gets a target there.
  std::vector<ConstraintSummary> put_all();

 private:
  bool is_held(Index v, const Slide& s) const;
  ConstraintSummary put(std::uint32_t s);
  double put_on_given(std::uint32_t s);
  double put_on_fitted(std::uint32_t s);
  double put_on_own(std::uint32_t s);
  double put_on(Index v, std::uint32_t s, const std::shared_ptr<const Track>& track,
                const TrackPoint& at);
  void put_on_second(Index v, SlideOn on, const TrackPoint& at);
  double set_target(Index v, std::uint32_t s, const Vec3& position);
  void check_in_mesh_plane(Index v, const Slide& slide, const Track& track,
                           const TrackPoint& at) const;
  ConstraintSummary summarize(std::uint32_t s, double farthest) const;

  const Slide& slide(std::uint32_t s) const { return scene_.constraints.slides[s]; }

  const Scene& scene_;
  Arrangement& arrangement_;
  std::vector<std::vector<char>> taking_part_;  // per slide and vertex
};

}  // namespace evenmesh
