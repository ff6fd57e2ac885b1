// SPDX-License-Identifier: MIT
#include "evenmesh/mesh/curved_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

namespace evenmesh {
namespace {

constexpr Index kNone = ~Index{0};
constexpr double kOffMiddle = 1e-6;  // relative to the distance of the corners

/// Local numbers of the corners that a node is between, ascending; one for a corner itself.
using Leaders = std::vector<std::uint8_t>;

/// A shape function: 1 in the middle of its leaders' reference places.
struct Function {
  Leaders leaders;
  Vec3 place;
};

/// Everything about a kind of cell that does not hang on where it is.
struct Element {
  std::vector<Function> functions;            // corners, edges, quads, whole
  std::vector<std::vector<double>> at_place;  // [node][function of lower order]
  std::vector<std::vector<Vec3>> gradients;   // [node][function]
};

/// The corners of the reference cells: the unit square, cube, triangle, tet and wedge.
Vec3 reference(CellKind kind, std::size_t corner) {
  constexpr double kCube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  constexpr double kSimplex[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (kind == CellKind::quad || kind == CellKind::hex) {
    return Vec3(kCube[corner][0], kCube[corner][1], kCube[corner][2]);
  }
  if (kind == CellKind::wedge) {
    return Vec3(kSimplex[corner % 3][0], kSimplex[corner % 3][1], corner < 3 ? 0.0 : 1.0);
  }
  return Vec3(kSimplex[corner][0], kSimplex[corner][1], kSimplex[corner][2]);
}

/// Along one direction: 1 at one end and 0 at the other, or 1 in the middle.
double along(double t, bool has_start, bool has_end) {
  if (has_start && has_end) return 4.0 * t * (1.0 - t);
  return has_start ? 1.0 - t : t;
}

/// In a triangle or tet: 1 in the middle of so many of its corners.
double over_simplex(const std::vector<double>& barycentric) {
  constexpr double kScale[] = {0, 1, 4, 27, 256};
  double product = kScale[barycentric.size()];
  for (const double b : barycentric) product *= b;
  return product;
}

double value(CellKind kind, const Leaders& leaders, const Vec3& u) {
  const bool is_cube = kind == CellKind::quad || kind == CellKind::hex;
  double product = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_cube && !(kind == CellKind::wedge && axis == 2)) continue;
    if (kind == CellKind::quad && axis == 2) continue;
    bool start = false;
    bool end = false;
    for (const std::uint8_t corner : leaders) {
      (reference(kind, corner)[axis] == 0.0 ? start : end) = true;
    }
    product *= along(u[axis], start, end);
  }
  if (is_cube) return product;
  const std::size_t corners = kind == CellKind::tet ? 4 : 3;
  const double all[4] = {1.0 - u[0] - u[1] - (kind == CellKind::tet ? u[2] : 0.0), u[0], u[1],
                         u[2]};
  std::vector<double> chosen;
  for (std::size_t i = 0; i < corners; ++i) {
    const auto is_chosen = [&](std::uint8_t corner) {
      return (kind == CellKind::wedge ? corner % 3U : corner) == i;
    };
    if (std::any_of(leaders.begin(), leaders.end(), is_chosen)) chosen.push_back(all[i]);
  }
  return product * over_simplex(chosen);
}

/// Exact, for no shape function has a higher power than the second of one variable.
Vec3 gradient(CellKind kind, const Leaders& leaders, const Vec3& u) {
  Vec3 result;
  for (int k = 0; k < 3; ++k) {
    const Vec3 half = 0.5 * Vec3::Unit(k);
    result[k] = value(kind, leaders, u + half) - value(kind, leaders, u - half);
  }
  return result;
}

Element make_element(CellKind kind) {
  Element element;
  const CellTraits& row = traits(kind);
  const auto add = [&](Leaders leaders) {
    std::sort(leaders.begin(), leaders.end());
    Vec3 place = Vec3::Zero();
    for (const std::uint8_t c : leaders) place += reference(kind, c);
    place /= static_cast<double>(leaders.size());
    element.functions.push_back({std::move(leaders), place});
  };
  Leaders whole;
  for (int c = 0; c < row.vertices; ++c) {
    add({static_cast<std::uint8_t>(c)});
    whole.push_back(static_cast<std::uint8_t>(c));
  }
  for (const CellTraits::Edge edge : row.edges) add({edge.a, edge.b});
  for (const CellTraits::Face& face : row.faces) {
    if (face.count == 4) add({face.vertices.begin(), face.vertices.end()});
  }
  if (kind != CellKind::tet && kind != CellKind::wedge) add(whole);
  for (const Function& node : element.functions) {
    std::vector<double> values;
    std::vector<Vec3> gradients;
    for (const Function& function : element.functions) {
      values.push_back(value(kind, function.leaders, node.place));
      gradients.push_back(gradient(kind, function.leaders, node.place));
    }
    element.at_place.push_back(std::move(values));
    element.gradients.push_back(std::move(gradients));
  }
  return element;
}

bool is_judged(CellKind kind) { return kind != CellKind::polygon && kind != CellKind::pyramid; }

const Element& element_of(CellKind kind) {
  static const auto kElements = [] {
    std::array<Element, kCellKinds> elements;
    for (int k = 0; k < kCellKinds; ++k) {
      const auto each = static_cast<CellKind>(k);
      if (is_judged(each)) elements[static_cast<std::size_t>(k)] = make_element(each);
    }
    return elements;
  }();
  return kElements[static_cast<std::size_t>(kind)];
}

/// Finds followers by their leaders.
class Directory {
 public:
  explicit Directory(const Followers& followers) : followers_(followers) {
    for (std::size_t i = 0; i < followers.size(); ++i) {
      const auto leaders = followers.leaders(i);
      entries_.emplace_back(key({leaders.begin(), leaders.end()}), i);
    }
    std::sort(entries_.begin(), entries_.end());
  }

  /// The vertex between these, or kNone.
  Index find(std::vector<Index> leaders) const {
    std::sort(leaders.begin(), leaders.end());
    const std::uint64_t wanted = key(leaders);
    auto at = std::lower_bound(entries_.begin(), entries_.end(), std::pair(wanted, std::size_t{0}));
    for (; at != entries_.end() && at->first == wanted; ++at) {
      const auto found = followers_.leaders(at->second);
      std::vector<Index> sorted(found.begin(), found.end());
      std::sort(sorted.begin(), sorted.end());
      if (sorted == leaders) return followers_.vertex(at->second);
    }
    return kNone;
  }

 private:
  static std::uint64_t key(std::vector<Index> leaders) {
    std::sort(leaders.begin(), leaders.end());
    std::uint64_t hash = leaders.size();
    for (const Index v : leaders) hash = (hash ^ v) * 0x9E3779B97F4A7C15U;
    return hash;
  }

  const Followers& followers_;
  std::vector<std::pair<std::uint64_t, std::size_t>> entries_;
};

/// Vertices beside which some follower is off the middle.
std::vector<char> beside_curves(const Followers& followers, Points points) {
  std::vector<char> result(points.size(), 0);
  for (std::size_t i = 0; i < followers.size(); ++i) {
    const auto leaders = followers.leaders(i);
    Vec3 middle = Vec3::Zero();
    for (const Index v : leaders) middle += points[v] / static_cast<double>(leaders.size());
    double size = 0.0;
    for (const Index v : leaders) size = std::max(size, (points[v] - middle).norm());
    if ((points[followers.vertex(i)] - middle).norm() <= kOffMiddle * size) continue;
    for (const Index v : leaders) result[v] = 1;
  }
  return result;
}

}  // namespace

CurvedCells::CurvedCells(const Mesh& mesh, const Followers& followers,
                         const Orientation& orientation)
    : mesh_(mesh), orientation_(orientation) {
  if (followers.empty()) return;
  const std::vector<char> curved = beside_curves(followers, mesh.points());
  if (std::find(curved.begin(), curved.end(), 1) == curved.end()) return;
  const Directory directory(followers);
  for (std::size_t number = 0; number < mesh.cells().size(); ++number) {
    const CellKind kind = mesh.cells().kind(number);
    const auto corners = mesh.cells().vertices(number);
    if (!is_judged(kind)) continue;
    if (std::none_of(corners.begin(), corners.end(), [&](Index v) { return curved[v]; })) continue;
    Cell cell{.number = number, .least = 0.0, .followers = {}};
    for (const Function& function : element_of(kind).functions) {
      if (function.leaders.size() == 1) continue;
      std::vector<Index> leaders;
      for (const std::uint8_t c : function.leaders) leaders.push_back(corners[c]);
      cell.followers.push_back(directory.find(std::move(leaders)));
    }
    if (std::all_of(cell.followers.begin(), cell.followers.end(),
                    [](Index v) { return v == kNone; })) {
      continue;
    }
    cell.least = least_determinant(cell, mesh.points());
    cells_.push_back(std::move(cell));
  }
}

/// The least determinant relative to its mean; where the mean is not above zero, less than zero.
double CurvedCells::least_determinant(const Cell& cell, Points points) const {
  const CellKind kind = mesh_.cells().kind(cell.number);
  const auto corners = mesh_.cells().vertices(cell.number);
  const Element& element = element_of(kind);
  std::vector<Vec3> amounts;  // the coefficient of each function
  for (std::size_t f = 0; f < element.functions.size(); ++f) {
    if (f < corners.size()) {
      amounts.push_back(points[corners[f]]);
      continue;
    }
    const Index follower = cell.followers[f - corners.size()];
    Vec3 amount = Vec3::Zero();
    if (follower != kNone) {
      amount = points[follower];
      for (std::size_t lower = 0; lower < f; ++lower) {
        amount -= element.at_place[f][lower] * amounts[lower];
      }
    }
    amounts.push_back(amount);
  }
  const bool is_surface = traits(kind).dimension == 2;
  double least = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (const std::vector<Vec3>& gradients : element.gradients) {
    std::array<Vec3, 3> columns{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (std::size_t f = 0; f < amounts.size(); ++f) {
      for (int k = 0; k < 3; ++k)
        columns[static_cast<std::size_t>(k)] += gradients[f][k] * amounts[f];
    }
    const Vec3 normal = columns[0].cross(columns[1]);
    const double determinant = is_surface ? normal.dot(orientation_.up(cell.number))
                                          : normal.dot(columns[2]) * orientation_.sign(cell.number);
    least = std::min(least, determinant);
    sum += determinant;
  }
  const double mean = sum / static_cast<double>(element.gradients.size());
  return mean > 0.0 ? least / mean : -1.0;
}

std::vector<std::size_t> CurvedCells::inverted(Points points) const {
  std::vector<std::size_t> result;
  for (const Cell& cell : cells_) {
    if (!(least_determinant(cell, points) > 0.0)) result.push_back(cell.number);
  }
  return result;
}

std::vector<std::size_t> CurvedCells::spoilt(Points points) const {
  constexpr double kEnough = 0.05;
  constexpr double kRounding = 1e-12;
  std::vector<std::size_t> result;
  for (const Cell& cell : cells_) {
    const double least = least_determinant(cell, points);
    if (least < kEnough && least < cell.least - kRounding) result.push_back(cell.number);
  }
  return result;
}

}  // namespace evenmesh
