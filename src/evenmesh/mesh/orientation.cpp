// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "evenmesh/mesh/extent.h"
#include "evenmesh/mesh/plane.h"
#include "evenmesh/mesh/sides.h"
#include "evenmesh/mesh/winding.h"

namespace evenmesh {
namespace {

bool has_volume_cells(const Cells& cells) {
  return std::any_of(cells.kinds().begin(), cells.kinds().end(),
                     [](CellKind kind) { return traits(kind).dimension == 3; });
}

std::vector<Index> used_vertices(const Mesh& mesh) {
  std::vector<char> used(mesh.point_count(), 0);
  for (const Index v : mesh.cells().corners()) used[v] = 1;
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) vertices.push_back(static_cast<Index>(v));
  }
  return vertices;
}

/// A length in which no cell is huge; 1 where everything is in one place.
double unit_of(const Mesh& mesh, std::span<const Index> vertices) {
  const double half = extent_of(mesh.points(), vertices).half();
  return half > 0.0 ? half : 1.0;
}

/// Two of a bow-tie's corners turn one way and two the other.
bool is_bow_tie(Points points, std::span<const Index> v, double unit) {
  if (v.size() != 4) return false;
  std::array<Vec3, 4> turns;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array<Index, 3> corner{v[(i + 3) % 4], v[i], v[(i + 1) % 4]};
    turns[i] = doubled_area(points, corner, unit);
  }
  return std::count_if(turns.begin(), turns.end(),
                       [&](const Vec3& turn) { return turn.dot(turns[0]) < 0.0; }) == 2;
}

bool is_twisted(const Winding& winding) {
  return std::find(winding.twisted.begin(), winding.twisted.end(), char{1}) !=
         winding.twisted.end();
}

/// Quads of a twisted piece that were made bow-ties by their vertices' order rather than by their
/// positions: two of their sides are diagonals, which no neighbour has.
std::vector<char> misnumbered_quads(const Mesh& mesh, const Winding& winding, double unit) {
  const Cells& cells = mesh.cells();
  std::vector<std::uint8_t> borders(cells.size(), 0);  // per cell: sides of its own, up to two
  for_each_side(cells, mesh.point_count(), 2, [&](const Side& side) {
    std::uint8_t& count = borders[side.uses[0].cell];
    if (side.cells == 1 && count < 2) ++count;
  });
  std::vector<char> result(cells.size(), 0);
  for (std::size_t cell = 0; cell < result.size(); ++cell) {
    result[cell] = winding.twisted[cell] && borders[cell] == 2 &&
                   is_bow_tie(mesh.points(), cells.vertices(cell), unit);
  }
  return result;
}

/// How surface cells are wound, whatever misnumbered quads say where they contradict the others.
Winding surface_winding(const Mesh& mesh, double unit) {
  const Cells& cells = mesh.cells();
  Winding winding = find_winding(cells, mesh.point_count(), 2);
  if (!is_twisted(winding)) return winding;
  const std::vector<char> mute = misnumbered_quads(mesh, winding, unit);
  return find_winding(cells, mesh.point_count(), 2, mute);
}

template <class Size>
std::vector<double> sizes_of(const Mesh& mesh, Size size) {
  const auto corners = mesh.cells().corners();
  const auto offsets = mesh.cells().offsets();
  std::vector<double> sizes(mesh.cells().size());
  for (std::size_t cell = 0; cell < sizes.size(); ++cell) {
    // In a mesh in random order the points of a cell are anywhere: ask for them ahead.
    constexpr std::size_t kAhead = 48;
    const Offset end = std::min<Offset>(offsets[cell + 1] + kAhead, corners.size());
    for (Offset i = std::min<Offset>(offsets[cell] + kAhead, end); i < end; ++i) {
      __builtin_prefetch(mesh.points().data() + corners[i]);
    }
    sizes[cell] = size(cell);
  }
  return sizes;
}

/// The sense of every cell, signs[i] in {-1, 1}, such that most of each piece is positive.
///
/// @param sizes  signed area or volume of each cell as it is wound in the file
std::vector<std::int8_t> majority_signs(const Winding& winding, std::span<const double> sizes) {
  const std::size_t count = winding.piece.size();
  std::vector<double> balance(count, 0.0);  // per piece, at its first cell
  for (std::size_t cell = 0; cell < count; ++cell) {
    balance[winding.piece[cell]] += winding.sense(cell) * sizes[cell];
  }
  std::vector<std::int8_t> signs(count, 1);
  for (std::size_t cell = 0; cell < count; ++cell) {
    int sense = winding.sense(cell);
    if (balance[winding.piece[cell]] < 0.0) sense = -sense;
    // Where neighbours cannot agree, winding tells nothing: such cells are judged one by one.
    if (winding.twisted[cell]) sense = sizes[cell] < 0.0 ? -1 : 1;
    signs[cell] = static_cast<std::int8_t>(sense);
  }
  return signs;
}

/// The winding of every cell against that of the first of its piece.
std::vector<std::int8_t> senses(const Winding& winding) {
  std::vector<std::int8_t> result(winding.piece.size());
  for (std::size_t cell = 0; cell < result.size(); ++cell) {
    result[cell] = static_cast<std::int8_t>(winding.sense(cell));
  }
  return result;
}

/// Which cells are wound against the greater part of their piece, by size and then by number. If
/// the parts are equal, those of sense 1 count as the greater.
///
/// @param sense  1 or -1 per cell; cells of one piece are wound alike if they have the same
/// @param sizes  area or volume of each cell, with any sign
std::vector<char> minority(const Winding& winding, std::span<const std::int8_t> sense,
                           std::span<const double> sizes) {
  const std::size_t count = winding.piece.size();
  std::vector<double> balance(count, 0.0);
  std::vector<std::int32_t> heads(count, 0);
  for (std::size_t cell = 0; cell < count; ++cell) {
    balance[winding.piece[cell]] += sense[cell] * std::abs(sizes[cell]);
    heads[winding.piece[cell]] += sense[cell];
  }
  std::vector<char> result(count, 0);
  for (std::size_t cell = 0; cell < count; ++cell) {
    if (winding.twisted[cell]) continue;
    const std::uint32_t piece = winding.piece[cell];
    const bool most_are_negative =
        balance[piece] < 0.0 || (balance[piece] == 0.0 && heads[piece] < 0);
    result[cell] = (sense[cell] > 0) == most_are_negative;
  }
  return result;
}

void drop_if_all_positive(std::vector<std::int8_t>& signs) {
  if (std::all_of(signs.begin(), signs.end(), [](std::int8_t s) { return s > 0; })) signs = {};
}

void count_winding(const Winding& winding, const std::vector<char>& against, Orientation& result) {
  result.against_majority =
      static_cast<std::size_t>(std::count(against.begin(), against.end(), char{1}));
  result.orientable = !is_twisted(winding);
}

void orient_plane(const Mesh& mesh, double unit, const Vec3& normal, Orientation& result) {
  const Cells& cells = mesh.cells();
  const Winding winding = surface_winding(mesh, unit);
  const std::vector<double> areas = sizes_of(mesh, [&](std::size_t cell) {
    return doubled_area(mesh.points(), cells.vertices(cell), unit).dot(normal);
  });
  result.signs = majority_signs(winding, areas);
  result.normal = normal;

  double balance = 0.0;
  double total = 0.0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    balance += result.signs[cell] * std::abs(areas[cell]);
    total += std::abs(areas[cell]);
  }
  constexpr double kTie = 1e-12;  // what rounding makes of two equal halves does not count
  if (balance < -kTie * total) {
    result.normal = Vec3::Zero() - normal;  // unlike -normal without negative zeros
    for (std::int8_t& sign : result.signs) sign = static_cast<std::int8_t>(-sign);
  }
  count_winding(winding, minority(winding, result.signs, areas), result);
  drop_if_all_positive(result.signs);
}

void orient_surface(const Mesh& mesh, double unit, Orientation& result) {
  const Cells& cells = mesh.cells();
  result.normals.resize(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    result.normals[cell] = unit_normal(mesh.points(), cells.vertices(cell));
  }
  const Winding winding = surface_winding(mesh, unit);
  const std::vector<double> areas = sizes_of(mesh, [&](std::size_t cell) {
    return doubled_area(mesh.points(), cells.vertices(cell), unit).norm();
  });
  const std::vector<char> against = minority(winding, senses(winding), areas);
  count_winding(winding, against, result);
  if (result.against_majority == 0) return;
  result.signs.resize(cells.size());
  std::transform(against.begin(), against.end(), result.signs.begin(),
                 [](char is_against) { return static_cast<std::int8_t>(is_against ? -1 : 1); });
}

void orient_volume(const Mesh& mesh, double unit, Orientation& result) {
  const Cells& cells = mesh.cells();
  const Winding winding = find_winding(cells, mesh.point_count(), 3);
  const std::vector<double> volumes = sizes_of(mesh, [&](std::size_t cell) {
    // Surface cells of such a mesh have no side to be on.
    if (traits(cells.kind(cell)).dimension != 3) return 0.0;
    return volume(cells.kind(cell), mesh.points(), cells.vertices(cell), unit);
  });
  result.signs = majority_signs(winding, volumes);
  count_winding(winding, minority(winding, result.signs, volumes), result);
  drop_if_all_positive(result.signs);
}

}  // namespace

std::string_view name(MeshType type) {
  switch (type) {
    case MeshType::planar:
      return "planar";
    case MeshType::surface:
      return "surface";
    case MeshType::volume:
      return "volume";
  }
  return "";
}

Orientation find_orientation(const Mesh& mesh) {
  Orientation result;
  if (mesh.cells().empty()) return result;
  const std::vector<Index> vertices = used_vertices(mesh);
  const double unit = unit_of(mesh, vertices);
  if (has_volume_cells(mesh.cells())) {
    result.type = MeshType::volume;
    orient_volume(mesh, unit, result);
  } else if (const auto normal = common_plane(mesh.points(), vertices, kPlanarTolerance)) {
    result.type = MeshType::planar;
    orient_plane(mesh, unit, *normal, result);
  } else {
    orient_surface(mesh, unit, result);
  }
  return result;
}

}  // namespace evenmesh
