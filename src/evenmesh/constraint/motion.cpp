// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/motion.h"

#include <algorithm>
#include <cassert>

#include "evenmesh/geometry/area.h"
#include "evenmesh/mesh/extent.h"

namespace evenmesh {
namespace {

// Mean normal around each vertex of a surface mesh, unit or zero.
std::vector<Vec3> tangent_plane_normals(const Mesh& mesh) {
  const Cells& cells = mesh.cells();
  std::vector<Vec3> areas(cells.size());
  std::vector<Vec3> corners;
  // Areas and their products must not leave the range of double, whatever the unit of length.
  const double half = extent_of(mesh.points(), cells.corners()).half();
  const double unit = half > 0.0 ? half : 1.0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    corners.clear();
    const Vec3& first = mesh.points()[cells.vertices(c)[0]];
    for (const Index v : cells.vertices(c)) corners.push_back((mesh.points()[v] - first) / unit);
    areas[c] = area_vector(corners);
  }
  // Files wind neighbouring cells either way. The greatest cell around a vertex says which way its
  // normal points; it does not matter which, only that the others do not cancel it.
  std::vector<std::uint32_t> greatest(mesh.point_count(), ~0u);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) {
      if (greatest[v] == ~0u || areas[c].squaredNorm() > areas[greatest[v]].squaredNorm()) {
        greatest[v] = static_cast<std::uint32_t>(c);
      }
    }
  }
  std::vector<Vec3> normals(mesh.point_count(), Vec3::Zero());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const Index v : cells.vertices(c)) {
      const bool agrees = areas[c].dot(areas[greatest[v]]) >= 0.0;
      normals[v] += agrees ? areas[c] : Vec3(-areas[c]);
    }
  }
  for (Vec3& n : normals) {
    const double length = n.stableNorm();
    n = length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
  }
  return normals;
}

}  // namespace

const Vec3 Motion::kNoNormal = Vec3::Zero();

Motion::Motion(const Mesh& mesh, const Orientation& orientation, std::span<const char> fixed)
    : freedom_(mesh.point_count(), Freedom::fixed) {
  assert(fixed.size() == mesh.point_count());
  const bool bound = orientation.type != MeshType::volume;
  if (orientation.type == MeshType::planar) normals_ = {orientation.normal};
  if (orientation.type == MeshType::surface) normals_ = tangent_plane_normals(mesh);
  for (const Index v : mesh.cells().corners()) {
    if (fixed[v]) continue;
    if (orientation.type == MeshType::surface && normals_[v].isZero()) continue;
    freedom_[v] = bound ? Freedom::plane : Freedom::free;
  }
}

std::size_t Motion::moving() const {
  return static_cast<std::size_t>(std::count_if(freedom_.begin(), freedom_.end(),
                                                [](Freedom f) { return f != Freedom::fixed; }));
}

Motion Motion::renumbered(std::span<const Index> order) const {
  Motion result;
  result.freedom_.reserve(order.size());
  for (const Index v : order) result.freedom_.push_back(freedom_[v]);
  if (normals_.size() <= 1) {
    result.normals_ = normals_;
  } else {
    result.normals_.reserve(order.size());
    for (const Index v : order) result.normals_.push_back(normals_[v]);
  }
  return result;
}

}  // namespace evenmesh
