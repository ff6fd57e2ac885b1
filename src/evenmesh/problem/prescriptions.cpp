// SPDX-License-Identifier: MIT
#include "evenmesh/problem/prescriptions.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace evenmesh {
namespace {

void check_on_planes(const Scene& scene, Index v, const Vec3& displacement,
                     const std::string& text) {
  if (scene.type == MeshType::planar &&
      scene.is_apart(std::abs(scene.orientation.normal.dot(displacement)))) {
    fail(text, fmt::format("{} would leave the plane of the mesh", scene.name_of(v)));
  }
  for (const Symmetry& symmetry : scene.constraints.symmetries) {
    if (scene.distance(symmetry.plane, v) > kInPlane * scene.size) continue;
    const double off = std::abs(symmetry.plane.normal.dot(displacement));
    if (!scene.is_apart(off)) continue;
    contradict(symmetry.text, text,
               fmt::format("{} would leave the plane by {:.3g}", scene.name_of(v), off));
  }
}

void check_on_slide(const Scene& scene, const Arrangement& arrangement, Index v,
                    const Vec3& position, const std::string& text) {
  const Motion& motion = arrangement.motion;
  const Track* const track = motion.track(v);
  const Vec3 displacement = position - scene.points[v];
  const Vec3 off =
      track != nullptr
          ? Vec3(track->nearest(position, motion.start()[motion.slot(v)]).position - position)
          : Vec3(displacement - motion.project(v, displacement));
  if (!scene.is_apart(off.norm())) return;
  contradict(
      scene.constraints.slides[arrangement.slide_of[v]].selection.text, text,
      fmt::format("{} would leave what it slides on by {:.3g}", scene.name_of(v), off.norm()));
}

void check_same(const Scene& scene, const TargetList& targets, Index v, const Vec3& position,
                const std::string& text) {
  const double apart = (targets.position(v) - position).norm();
  if (!scene.is_apart(apart)) return;
  contradict(targets.text(v), text,
             fmt::format("they bring {} to places {:.3g} apart", scene.name_of(v), apart));
}

void prescribe_one(const Scene& scene, Index v, const Vec3& position, const std::string& text,
                   Arrangement& arrangement) {
  const Vec3 displacement = position - scene.points[v];
  const double way = displacement.norm();
  if (!std::isfinite(way)) {
    fail(text, fmt::format("the place of {} is not finite", scene.name_of(v)));
  }
  if (scene.is_fixed(v) && way > 0.0) {
    contradict(scene.constraints.fixed->text, text,
               fmt::format("{} is fixed, but would move by {:.3g}", scene.name_of(v), way));
  }
  check_on_planes(scene, v, displacement, text);
  TargetList& targets = arrangement.targets;
  if (targets.has(v)) {
    check_same(scene, targets, v, position, text);
  } else if (arrangement.slides(v) && arrangement.moves(v)) {
    check_on_slide(scene, arrangement, v, position, text);
  }
  arrangement.motion.fix(v);
  if (!targets.has(v)) targets.set(v, position, text);
}

// @return  whether the image had no target before
bool carry_to(const Scene& scene, const Image& image, Arrangement& arrangement) {
  const TargetList& targets = arrangement.targets;
  const Vec3 displacement = targets.displacement(image.of);
  if (!targets.has(image.vertex)) {
    const std::string text = targets.text(image.of);
    prescribe_one(scene, image.vertex, scene.points[image.vertex] + displacement, text,
                  arrangement);
    return true;
  }
  const double apart = (targets.displacement(image.vertex) - displacement).norm();
  if (scene.is_apart(apart)) {
    contradict(image.periodic->text, targets.text(image.vertex),
               fmt::format("{} and its image {} would move differently, by {:.3g}",
                           scene.name_of(image.of), scene.name_of(image.vertex), apart));
  }
  return false;
}

// What is brought somewhere takes its images along, and these take theirs.
void carry_to_images(const Scene& scene, Arrangement& arrangement) {
  std::vector<Image>& images = arrangement.images;
  const auto is_before = [](const Image& a, const Image& b) { return a.of < b.of; };
  std::stable_sort(images.begin(), images.end(), is_before);
  std::vector<Index> brought;
  for (Index v = 0; v < scene.points.size(); ++v) {
    if (arrangement.targets.has(v)) brought.push_back(v);
  }
  for (std::size_t i = 0; i < brought.size(); ++i) {
    const auto [first, last] =
        std::equal_range(images.begin(), images.end(), Image{brought[i]}, is_before);
    for (auto image = first; image != last; ++image) {
      if (carry_to(scene, *image, arrangement)) brought.push_back(image->vertex);
    }
  }
}

}  // namespace

void prescribe(const Scene& scene, Arrangement& arrangement) {
  for (const Prescription& p : scene.constraints.prescriptions) {
    for (const Target& target : p.targets) {
      prescribe_one(scene, target.vertex, target.position, p.text, arrangement);
    }
  }
  carry_to_images(scene, arrangement);
}

std::vector<ConstraintSummary> summarize_prescriptions(const Scene& scene) {
  std::vector<ConstraintSummary> lines;
  for (const Prescription& p : scene.constraints.prescriptions) {
    double farthest = 0.0;
    std::vector<char> named(scene.points.size(), 0);  // curves share their ends
    for (const Target& target : p.targets) {
      named[target.vertex] = 1;
      farthest = std::max(farthest, (target.position - scene.points[target.vertex]).norm());
    }
    lines.push_back({p.kind, p.text, Entry::eliminated, count(named), "vertices",
                     fmt::format("by {:.3g} at most", farthest)});
  }
  return lines;
}

}  // namespace evenmesh
