// SPDX-License-Identifier: MIT
#include "evenmesh/io/vtk_content.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/text.h"
#include "evenmesh/io/second_order.h"
#include "evenmesh/io/side_labels.h"

namespace evenmesh {
namespace {

/// Rows of one number differ by their points.
struct CellType {
  std::uint8_t number;
  std::size_t points;
  CellKind kind;
};
constexpr std::array kCellTypes{
    CellType{5, 3, CellKind::triangle},
    CellType{8, 4, CellKind::quad},
    CellType{9, 4, CellKind::quad},
    CellType{10, 4, CellKind::tet},
    CellType{11, 8, CellKind::hex},
    CellType{12, 8, CellKind::hex},
    CellType{13, 6, CellKind::wedge},
    CellType{14, 5, CellKind::pyramid},
    CellType{22, 6, CellKind::triangle},
    CellType{23, 8, CellKind::quad},
    CellType{24, 10, CellKind::tet},
    CellType{25, 20, CellKind::hex},
    CellType{26, 15, CellKind::wedge},
    CellType{27, 13, CellKind::pyramid},
    CellType{28, 9, CellKind::quad},
    CellType{29, 27, CellKind::hex},
    CellType{32, 18, CellKind::wedge},
    CellType{34, 7, CellKind::triangle},
    // Lagrange's, of the orders whose points are numbered as above
    CellType{69, 3, CellKind::triangle},
    CellType{69, 6, CellKind::triangle},
    CellType{70, 4, CellKind::quad},
    CellType{70, 9, CellKind::quad},
    CellType{71, 4, CellKind::tet},
    CellType{71, 10, CellKind::tet},
    CellType{72, 8, CellKind::hex},
    CellType{73, 6, CellKind::wedge},
    CellType{74, 5, CellKind::pyramid},
};

constexpr std::uint8_t kLine = 3;
constexpr std::uint8_t kQuadraticLine = 21;
constexpr std::uint8_t kPixel = 8;
constexpr std::uint8_t kVoxel = 11;
constexpr std::uint8_t kLagrange = 68;  // the first of these types

/// Nothing, points and lines, of any order.
bool makes_no_cell(std::uint8_t type) {
  constexpr std::array<std::uint8_t, 9> kTypes = {
      0, 1, kVtkPolyVertex, kLine, kVtkPolyLine, kQuadraticLine, 35, 68, 75};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool is_line(std::uint8_t type) {
  return type == kLine || type == kVtkPolyLine || type == kQuadraticLine;
}

/// What to call a type that is not read.
std::string_view name_of(std::uint8_t type) {
  switch (type) {
    case 6:
      return "a triangle strip; make triangles of it (vtkTriangleFilter)";
    case 15:
    case 16:
      return "a prism over a pentagon or hexagon";
    case 30:
    case 31:
    case 33:
    case 37:
      return "a cell that is of second order in part";
    case 36:
      return "a polygon of second order";
    case 41:
      return "a convex set of points";
    case 42:
      return "a polyhedron";
    case 69:
    case 70:
    case 71:
    case 72:
    case 73:
    case 74:
      return "a Lagrange cell; of these the first order is read, of triangles, quads and tets also "
             "the second";
    default:
      return type >= 60 && type < 82 ? "a cell of higher order" : "unknown";
  }
}

/// Arrays that name materials in the files of MFEM, deal.II, Gmsh, meshio, ParaView, FEniCS,
/// Cubit, Exodus, VisIt and others.
constexpr std::array<std::string_view, 20> kMaterials{
    "material",  "materials",     "materialid", "materialids",     "material_id",
    "mat",       "mat_id",        "matid",      "attribute",       "region",
    "regionid",  "region_id",     "cell_tags",  "subdomain",       "subdomain_id",
    "medit:ref", "gmsh:physical", "objectid",   "elementblockids", "cellentityids"};

bool names_material(std::string_view array) {
  return std::any_of(kMaterials.begin(), kMaterials.end(),
                     [array](std::string_view name) { return equal_but_for_case(name, array); });
}

}  // namespace

VtkCells structured_cells(const std::array<std::uint64_t, 3>& dimensions) {
  VtkCells result;
  std::array<std::uint64_t, 3> cells{};
  std::vector<std::size_t> axes;  // along which there are cells
  for (std::size_t k = 0; k < 3; ++k) {
    cells[k] = dimensions[k] > 1 ? dimensions[k] - 1 : 1;
    if (dimensions[k] > 1) axes.push_back(k);
  }
  if (axes.size() < 2) return result;
  const std::array<std::uint64_t, 3> step = {1, dimensions[0], dimensions[0] * dimensions[1]};
  const std::uint64_t u = step[axes[0]];
  const std::uint64_t v = step[axes[1]];
  for (std::uint64_t k = 0; k < cells[2]; ++k) {
    for (std::uint64_t j = 0; j < cells[1]; ++j) {
      for (std::uint64_t i = 0; i < cells[0]; ++i) {
        const std::uint64_t first = i * step[0] + j * step[1] + k * step[2];
        for (const std::uint64_t corner : {first, first + u, first + u + v, first + v}) {
          result.points.push_back(static_cast<Index>(corner));
        }
        if (axes.size() == 3) {
          for (std::size_t c = 0; c < 4; ++c) {
            result.points.push_back(
                static_cast<Index>(result.points[result.points.size() - 4] + step[2]));
          }
        }
        result.ends.push_back(result.points.size());
      }
    }
  }
  result.types.assign(result.ends.size(), axes.size() == 3 ? kVtkHex : kVtkQuad);
  return result;
}

bool VtkContent::add_point(const Vec3& position) {
  points_.push_back(position);
  return position.allFinite();
}

void VtkContent::add_cells(const VtkCells& cells, std::size_t first_point) {
  before_ = in_file_;
  piece_ = &cells;
  cells_.reserve(cells_.size() + cells.types.size(), cells_.corners().size() + cells.points.size());
  std::vector<Index> points;
  Offset begin = 0;
  for (std::size_t cell = 0; cell < cells.types.size(); ++cell) {
    points.clear();
    for (Offset i = begin; i < cells.ends[cell]; ++i) {
      const std::uint64_t point = first_point + cells.points[i];
      if (point >= points_.size()) {
        fail(cell, fmt::format("names point {}; the {} points count from 0", cells.points[i],
                               points_.size() - first_point));
      }
      points.push_back(static_cast<Index>(point));
    }
    begin = cells.ends[cell];
    add_cell(cell, cells.types[cell], points);
  }
  piece_ = nullptr;
}

void VtkContent::add_cell(std::size_t cell, std::uint8_t type, std::span<Index> points) {
  const std::size_t number = in_file_++;
  if (makes_no_cell(type) || (type == kVtkPolygon && points.size() < 3)) {
    // From here on the numbers of cells are not those of the file.
    for (std::uint64_t i = 0; counted_ && i < number; ++i) numbers_.push_back(i);
    counted_ = false;
    if (is_line(type)) add_line(type, points, number);
    return;
  }
  CellKind kind = CellKind::polygon;
  if (type != kVtkPolygon) {
    kind = kind_of(cell, type, points.size());
  } else if (points.size() <= 4) {
    kind = points.size() == 3 ? CellKind::triangle : CellKind::quad;
  }
  // Pixels and voxels list their points along the axes.
  if (type == kPixel || type == kVoxel) std::swap(points[2], points[3]);
  if (type == kVoxel) std::swap(points[6], points[7]);

  const std::size_t corners =
      kind == CellKind::polygon ? points.size() : static_cast<std::size_t>(traits(kind).vertices);
  add_followers(kind, EdgeOrder::levels, points, followers_);
  cells_.add(kind, points.first(corners));
  if (!counted_) numbers_.push_back(number);
  if (!piece_->places.empty()) places_.push_back(piece_->places[cell]);
}

void VtkContent::add_line(std::uint8_t type, std::span<const Index> points, std::size_t number) {
  const std::size_t ends = type == kQuadraticLine ? 2 : points.size();
  for (std::size_t i = 0; i + 1 < std::min(ends, points.size()); ++i) {
    lines_.insert(lines_.end(), {points[i], points[i + 1]});
    line_numbers_.push_back(number);
    line_labels_.push_back(0);
  }
}

CellKind VtkContent::kind_of(std::size_t cell, std::uint8_t type, std::size_t points) const {
  const CellType* same_number = nullptr;
  for (const CellType& row : kCellTypes) {
    if (row.number != type) continue;
    if (row.points == points) return row.kind;
    same_number = &row;
  }
  if (same_number == nullptr || type >= kLagrange) {
    fail(cell, fmt::format("is of type {}, {}", type, name_of(type)));
  }
  fail(cell, fmt::format("has {} points; a cell of type {} ({}) has {}", points, type,
                         traits(same_number->kind).name, same_number->points));
}

void VtkContent::fail(std::size_t cell, std::string_view message) const {
  const std::string text = fmt::format("cell {} {}", before_ + cell, message);
  if (piece_->places.empty()) input_->fail(text);
  input_->fail_at(piece_->places[cell], text);
}

void VtkContent::check_not_torn() const {
  if (const auto v = torn_vertex(followers_, cells_, points_.size())) {
    input_->fail(torn_message(fmt::format("point {}", *v), "cell"));
  }
}

DataArray VtkContent::data_array(const VtkArray& array, const Numbers& numbers) const {
  DataArray result{.name = array.name, .on_cells = array.on_cells, .values = array.values};
  if (!array.on_cells || counted_) return result;
  result.values = [numbers, values = array.values] {
    const std::vector<double> all = values();
    std::vector<double> chosen;
    chosen.reserve(numbers->size());
    for (const std::uint64_t number : *numbers) chosen.push_back(all[number]);
    return chosen;
  };
  return result;
}

void VtkContent::set_groups(std::vector<std::string>& names) {
  const auto found = std::find_if(arrays_.begin(), arrays_.end(), [](const VtkArray& array) {
    return array.on_cells && array.whole && names_material(array.name);
  });
  if (found == arrays_.end()) return;
  const std::vector<double> values = found->values();
  std::map<double, std::uint32_t> groups;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    const double value = values[counted_ ? cell : numbers_[cell]];
    const auto next = static_cast<std::uint32_t>(names.size());
    const auto [at, is_new] = groups.emplace(value, next);
    if (is_new) names.push_back(fmt::format("{} {:.0f}", found->name, value));
    cells_.set_group(cell, at->second);
  }
  for (std::size_t i = 0; i < line_numbers_.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(groups.size() + 1);
    const auto at = groups.emplace(values[line_numbers_[i]], next).first;
    line_labels_[i] = at->second;
  }
}

MeshFile VtkContent::take_file() {
  check_not_torn();
  MeshFile file;
  if (points_.empty()) input_->fail("has no points; export the mesh again");
  if (cells_.empty()) add_note("The file has points but no cells that make a surface or a volume.");
  const auto numbers = std::make_shared<const std::vector<std::uint64_t>>(numbers_);
  file.group_names = {""};
  set_groups(file.group_names);
  file.held = {held_by_groups(cells_, lines_, line_labels_),
               "on lines of the file, or at the rims of its groups"};
  for (const VtkArray& array : arrays_) file.arrays.push_back(data_array(array, numbers));
  file.notes = std::move(notes_);
  file.followers = std::move(followers_);
  file.mesh = Mesh(std::move(points_), std::move(cells_));
  return file;
}

FileNumbers VtkContent::take_numbers() {
  return {.vertex = "point",
          .cell = "cell",
          .cells = std::move(numbers_),
          .cell_places = std::move(places_)};
}

}  // namespace evenmesh
