// SPDX-License-Identifier: MIT
#include "evenmesh/constraint/keep.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/sides.h"

namespace evenmesh {
namespace {

using Group = std::optional<std::uint32_t>;

// ---- lists of polygons --------------------------------------------------------------------------

/// Boundary edges or surface polygons, as numbers of their vertices.
struct Polygons {
  std::vector<Index> corners;      // first of the mesh's vertices, then of local ones
  std::vector<Offset> offsets{0};  // polygon i has corners [offsets[i], offsets[i + 1])
  std::vector<std::int32_t> weights;

  std::size_t size() const { return weights.size(); }
  void add(std::span<const Index> vertices, int weight) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    offsets.push_back(corners.size());
    weights.push_back(weight);
  }
};

/// Numbers the vertices that polygons use, ascending, and writes these numbers into them.
std::vector<Index> make_local(Polygons& polygons, std::size_t vertex_count) {
  std::vector<Index> local(vertex_count, 0);
  for (const Index v : polygons.corners) local[v] = 1;
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (!local[v]) continue;
    local[v] = static_cast<Index>(vertices.size());
    vertices.push_back(static_cast<Index>(v));
  }
  for (Index& corner : polygons.corners) corner = local[corner];
  return vertices;
}

// ---- functions ----------------------------------------------------------------------------------

/// What the functions here have in common: polygons, whose parts of the total are added up.
class Total : public Function {
 public:
  Total(Keep what, Polygons polygons, std::size_t vertex_count)
      : what_(what), polygons_(std::move(polygons)) {
    vertices_ = make_local(polygons_, vertex_count);
  }

  std::string_view name() const override { return evenmesh::name(what_); }
  std::span<const Index> vertices() const override { return vertices_; }

 protected:
  /// Calls part(corners, weight, x) for every polygon, x(corner) being a position seen from origin.
  template <typename Part>
  double add_up(Points own, std::span<Vec3> gradient, const Part& part) const {
    assert(gradient.empty() || gradient.size() == vertices_.size());
    std::fill(gradient.begin(), gradient.end(), Vec3::Zero());
    if (vertices_.empty()) return 0.0;
    // Totals do not depend on where the origin is, but their digits do.
    const Vec3 origin = own.front();
    const auto at = [&](Index corner) -> Vec3 { return own[corner] - origin; };
    double sum = 0.0;
    const Index* const corners = polygons_.corners.data();
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const Offset first = polygons_.offsets[i];
      const std::size_t count = polygons_.offsets[i + 1] - first;
      sum += part(std::span(corners + first, count), polygons_.weights[i], at);
    }
    return sum;
  }

 private:
  Keep what_;
  Polygons polygons_;
  std::vector<Index> vertices_;
};

/// 1/2 sum over edges of n . (x_a x x_b)
class AreaWithin final : public Total {
 public:
  AreaWithin(Polygons edges, std::size_t vertex_count, const Vec3& normal)
      : Total(Keep::area, std::move(edges), vertex_count), normal_(normal) {}

  double evaluate(Points own, std::span<Vec3> gradient) const override {
    return add_up(own, gradient, [&](std::span<const Index> edge, int weight, const auto& at) {
      const Vec3 a = at(edge[0]);
      const Vec3 b = at(edge[1]);
      const double half = 0.5 * weight;
      if (!gradient.empty()) {
        gradient[edge[0]] += half * b.cross(normal_);
        gradient[edge[1]] += half * normal_.cross(a);
      }
      return half * normal_.dot(a.cross(b));
    });
  }

 private:
  Vec3 normal_;
};

std::size_t next(std::size_t i, std::size_t count) { return i + 1 == count ? 0 : i + 1; }

/// sum over i of x_i x x_i+1 and the corners' mean
struct Figure {
  Vec3 doubled_area = Vec3::Zero();
  Vec3 mean = Vec3::Zero();
};

template <typename At>
Figure figure(std::span<const Index> corners, const At& at) {
  const Vec3 first = at(corners[0]);
  Figure result;
  Vec3 arm = Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec3 next_arm = at(corners[i]) - first;
    result.doubled_area += arm.cross(next_arm);
    sum += next_arm;
    arm = next_arm;
  }
  result.mean = first + sum / static_cast<double>(corners.size());
  return result;
}

/// Adds what makes the derivatives of  direction . 1/2 sum_i x_i x x_i+1.
template <typename At>
void add_area_slopes(std::span<const Index> corners, const At& at, const Vec3& direction,
                     std::span<Vec3> gradient) {
  Vec3 before = at(corners.back());
  Vec3 here = at(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 after = at(corners[next(i, corners.size())]);
    gradient[corners[i]] += 0.5 * (after - before).cross(direction);
    before = here;
    here = after;
  }
}

/// sum over polygons of |1/2 sum_i x_i x x_i+1|
class SurfaceArea final : public Total {
 public:
  SurfaceArea(Polygons polygons, std::size_t vertex_count)
      : Total(Keep::area, std::move(polygons), vertex_count) {}

  double evaluate(Points own, std::span<Vec3> gradient) const override {
    return add_up(own, gradient, [&](std::span<const Index> corners, int, const auto& at) {
      if (corners.size() == 3) return add_triangle(corners, at, gradient);
      const Vec3 doubled = figure(corners, at).doubled_area;
      const double length = doubled.norm();
      if (!gradient.empty() && length > 0.0) {
        add_area_slopes(corners, at, doubled / length, gradient);
      }
      return 0.5 * length;
    });
  }

 private:
  // The same as for any polygon in fewer operations: most surfaces are made of these.
  template <typename At>
  static double add_triangle(std::span<const Index> corners, const At& at,
                             std::span<Vec3> gradient) {
    const Vec3 first = at(corners[0]);
    const Vec3 u = at(corners[1]) - first;
    const Vec3 v = at(corners[2]) - first;
    const Vec3 doubled = u.cross(v);
    const double length = doubled.norm();
    if (!gradient.empty() && length > 0.0) {
      const Vec3 half_normal = (0.5 / length) * doubled;
      const Vec3 second_slope = v.cross(half_normal);
      const Vec3 third_slope = half_normal.cross(u);
      gradient[corners[0]] -= second_slope + third_slope;
      gradient[corners[1]] += second_slope;
      gradient[corners[2]] += third_slope;
    }
    return 0.5 * length;
  }
};

/// 1/6 sum over polygons of c . sum_i x_i x x_i+1
class VolumeWithin final : public Total {
 public:
  VolumeWithin(Polygons polygons, std::size_t vertex_count)
      : Total(Keep::volume, std::move(polygons), vertex_count) {}

  double evaluate(Points own, std::span<Vec3> gradient) const override {
    return add_up(own, gradient, [&](std::span<const Index> corners, int weight, const auto& at) {
      if (corners.size() == 3) return add_triangle(corners, weight / 6.0, at, gradient);
      const Figure its = figure(corners, at);
      const double sixth = weight / 6.0;
      if (!gradient.empty()) {
        add_area_slopes(corners, at, 2.0 * sixth * its.mean, gradient);
        const Vec3 share = sixth / static_cast<double>(corners.size()) * its.doubled_area;
        for (const Index corner : corners) gradient[corner] += share;
      }
      return sixth * its.mean.dot(its.doubled_area);
    });
  }

 private:
  template <typename At>
  static double add_triangle(std::span<const Index> corners, double sixth, const At& at,
                             std::span<Vec3> gradient) {
    const Vec3 a = at(corners[0]);
    const Vec3 b = at(corners[1]);
    const Vec3 c = at(corners[2]);
    const Vec3 normal = sixth * b.cross(c);
    if (!gradient.empty()) {
      gradient[corners[0]] += normal;
      gradient[corners[1]] += sixth * c.cross(a);
      gradient[corners[2]] += sixth * a.cross(b);
    }
    return a.dot(normal);
  }
};

// ---- what they are made of ----------------------------------------------------------------------

bool counts(const Cells& cells, std::size_t cell, int dimension, const Group& group) {
  return traits(cells.kind(cell)).dimension == dimension && (!group || cells.group(cell) == *group);
}

void check_for_cells(const Mesh& mesh, Keep what, int dimension, const Group& group) {
  const Cells& cells = mesh.cells();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (counts(cells, cell, dimension, group)) return;
  }
  // Who asks by name knows the name, and the number says nothing to a user.
  throw InvalidOption(fmt::format("cannot keep the {0} of {1}: {1} has no {2} cells{3}", name(what),
                                  group ? "the group" : "the mesh",
                                  dimension == 2 ? "surface" : "volume",
                                  dimension == 2 ? "; try volume" : ""));
}

/// How often cells that count go along a side, those against uses[0] subtracted.
int net_uses(const Side& side, const Cells& cells, const Orientation& orientation, int dimension,
             const Group& group) {
  double net = 0.0;
  for (const SideUse& use : side.uses) {
    if (!counts(cells, use.cell, dimension, group)) continue;
    const double direction = use.forward == side.uses[0].forward ? 1.0 : -1.0;
    net += direction * orientation.sign(use.cell);
  }
  return static_cast<int>(net);
}

/// The edges that cells of a planar mesh have between them on one side only.
Polygons outline(const Mesh& mesh, const Orientation& orientation, const Group& group) {
  const Cells& cells = mesh.cells();
  Polygons result;
  for_each_side(cells, mesh.point_count(), 2, [&](const Side& side) {
    const int net = net_uses(side, cells, orientation, 2, group);
    // Forward is from the smaller vertex to the other.
    const int weight = side.uses[0].forward ? net : -net;
    if (net != 0) result.add(std::array{side.first, side.uses[0].second}, weight);
  });
  return result;
}

/// The faces that volume cells have between them on one side only.
Polygons skin(const Mesh& mesh, const Orientation& orientation, const Group& group) {
  const Cells& cells = mesh.cells();
  Polygons result;
  for_each_side(cells, mesh.point_count(), 3, [&](const Side& side) {
    const int net = net_uses(side, cells, orientation, 3, group);
    const SideUse& use = side.uses[0];
    if (net != 0) result.add(face_vertices(cells, use.cell, use.face).span(), net);
  });
  return result;
}

Polygons surface_cells(const Mesh& mesh, const Orientation& orientation, const Group& group) {
  const Cells& cells = mesh.cells();
  Polygons result;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (!counts(cells, cell, 2, group)) continue;
    result.add(cells.vertices(cell), orientation.sign(cell) < 0.0 ? -1 : 1);
  }
  return result;
}

/// Throws unless every edge is gone along as often in one direction as in the other.
void check_that_it_closes(const Mesh& mesh, const Orientation& orientation, const Group& group) {
  const Cells& cells = mesh.cells();
  std::size_t open = 0;
  std::size_t inconsistent = 0;
  for_each_side(cells, mesh.point_count(), 2, [&](const Side& side) {
    if (net_uses(side, cells, orientation, 2, group) == 0) return;
    const auto used = std::count_if(side.uses.begin(), side.uses.end(), [&](const SideUse& use) {
      return counts(cells, use.cell, 2, group);
    });
    ++(used == 1 ? open : inconsistent);
  });
  if (open > 0) {
    throw InvalidOption(
        fmt::format("cannot keep the volume: the surface is not closed, it has {} boundary edges; "
                    "try area",
                    open));
  }
  if (inconsistent > 0) {
    throw InvalidOption(
        fmt::format("cannot keep the volume: the surface has no inside and outside, {} of its "
                    "edges join cells that cannot be wound alike; try area",
                    inconsistent));
  }
}

std::shared_ptr<const Function> area_function(const Mesh& mesh, const Orientation& orientation,
                                              const Group& group) {
  check_for_cells(mesh, Keep::area, 2, group);
  if (orientation.type == MeshType::planar) {
    return std::make_shared<AreaWithin>(outline(mesh, orientation, group), mesh.point_count(),
                                        orientation.normal);
  }
  return std::make_shared<SurfaceArea>(surface_cells(mesh, orientation, group), mesh.point_count());
}

std::shared_ptr<const Function> volume_function(const Mesh& mesh, const Orientation& orientation,
                                                const Group& group) {
  if (orientation.type == MeshType::volume) {
    check_for_cells(mesh, Keep::volume, 3, group);
    return std::make_shared<VolumeWithin>(skin(mesh, orientation, group), mesh.point_count());
  }
  if (orientation.type == MeshType::planar) {
    throw InvalidOption("cannot keep the volume: the mesh is planar and encloses none; try area");
  }
  check_for_cells(mesh, Keep::volume, 2, group);
  check_that_it_closes(mesh, orientation, group);
  Polygons cells = surface_cells(mesh, orientation, group);
  const VolumeWithin as_wound(cells, mesh.point_count());
  if (as_wound.at(mesh.points()) < 0.0) {
    for (std::int32_t& weight : cells.weights) weight = -weight;
  }
  return std::make_shared<VolumeWithin>(std::move(cells), mesh.point_count());
}

}  // namespace

std::string_view name(Keep what) { return what == Keep::area ? "area" : "volume"; }

std::shared_ptr<const Function> keep_function(const Mesh& mesh, const Orientation& orientation,
                                              Keep what, std::optional<std::uint32_t> group) {
  return what == Keep::area ? area_function(mesh, orientation, group)
                            : volume_function(mesh, orientation, group);
}

Bound make_keep(const Mesh& mesh, const Orientation& orientation, Keep what,
                std::optional<std::uint32_t> group, std::optional<double> value) {
  if (value && !(*value > 0.0 && std::isfinite(*value))) {
    throw InvalidOption(fmt::format(
        "a total {} of {} cannot be kept: it must be positive and finite", name(what), *value));
  }
  auto function = keep_function(mesh, orientation, what, group);
  const double kept = value ? *value : function->at(mesh.points());
  return {std::move(function), kept, kept};
}

}  // namespace evenmesh
