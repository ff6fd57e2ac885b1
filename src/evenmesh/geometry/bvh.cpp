// SPDX-License-Identifier: MIT
#include "evenmesh/geometry/bvh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace evenmesh {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::size_t kBins = 16;
/// Nodes deeper than that are halved by count, so that no input makes the tree deeper than
/// kFreeDepth + 32.
constexpr int kFreeDepth = 40;
constexpr std::size_t kStackSize = 80;

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  double half_area() const {
    const Vec3 d = high - low;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

float rounded_down(double x) {
  const auto y = static_cast<float>(x);
  return y > x ? std::nextafter(y, -std::numeric_limits<float>::infinity()) : y;
}

float rounded_up(double x) {
  const auto y = static_cast<float>(x);
  return y < x ? std::nextafter(y, std::numeric_limits<float>::infinity()) : y;
}

}  // namespace

/// Cuts nodes where the surface area heuristic says, over bins of centres.
class Bvh::Builder {
 public:
  Builder(Bvh& tree, std::span<const VertexTriple> triangles)
      : tree_(tree), items_(triangles.size()) {
    for (std::uint32_t t = 0; t < items_.size(); ++t) {
      Item& item = items_[t];
      item.number = t;
      for (const Index v : triangles[t]) item.box.add(tree.points_[v]);
    }
  }

  void build() {
    tree_.nodes_.reserve(items_.size());
    tree_.nodes_.emplace_back();
    // Nodes to be cut, and not a recursion: their depth is bounded, the stack's size is not known.
    std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(items_.size()), 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      cut(task, tasks);
    }
    tree_.nodes_.shrink_to_fit();
    for (const Item& item : items_) tree_.order_.push_back(item.number);
  }

 private:
  struct Item {
    Box box;
    std::uint32_t number;

    double centre(Eigen::Index axis) const { return box.low[axis] + box.high[axis]; }
  };
  struct Task {
    std::uint32_t node, begin, end;
    int depth;
  };
  struct Bin {
    Box box;
    std::uint32_t count = 0;
  };

  void cut(const Task& task, std::vector<Task>& tasks) {
    Box box;
    Box centres;
    for (std::uint32_t i = task.begin; i < task.end; ++i) {
      box.add(items_[i].box);
      centres.add(items_[i].box.low + items_[i].box.high);
    }
    Node& node = tree_.nodes_[task.node];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low[axis] = rounded_down(box.low[static_cast<Eigen::Index>(axis)]);
      node.high[axis] = rounded_up(box.high[static_cast<Eigen::Index>(axis)]);
    }
    if (task.end - task.begin <= kLeafSize) {
      node.first = task.begin;
      node.count = task.end - task.begin;
      // So that the least of equally near triangles comes first.
      std::sort(items_.begin() + task.begin, items_.begin() + task.end,
                [](const Item& a, const Item& b) { return a.number < b.number; });
      return;
    }
    const std::uint32_t middle = split(task, centres);
    const auto child = static_cast<std::uint32_t>(tree_.nodes_.size());
    node.first = child;
    tree_.nodes_.resize(tree_.nodes_.size() + 2);  // node is no longer valid
    tasks.push_back({child + 1, middle, task.end, task.depth + 1});
    tasks.push_back({child, task.begin, middle, task.depth + 1});
  }

  /// Puts the items of one child before those of the other; where the other's begin.
  std::uint32_t split(const Task& task, const Box& centres) {
    Eigen::Index axis = 0;
    const Vec3 extent = centres.high - centres.low;
    const double longest = extent.maxCoeff(&axis);
    constexpr double kLeastExtent = 1e-290;  // that has a finite inverse
    if (task.depth < kFreeDepth && longest > kLeastExtent) {
      const double low = centres.low[axis];
      const double scale = kBins / longest;
      const auto bin_of = [&](const Item& item) {
        return std::min(kBins - 1, static_cast<std::size_t>((item.centre(axis) - low) * scale));
      };
      const std::size_t last = best_bin(task, bin_of);
      const auto middle = std::partition(items_.begin() + task.begin, items_.begin() + task.end,
                                         [&](const Item& item) { return bin_of(item) <= last; });
      const auto result = static_cast<std::uint32_t>(middle - items_.begin());
      if (result > task.begin && result < task.end) return result;
    }
    const std::uint32_t middle = task.begin + (task.end - task.begin) / 2;
    std::nth_element(items_.begin() + task.begin, items_.begin() + middle,
                     items_.begin() + task.end, [&](const Item& a, const Item& b) {
                       return std::pair(a.centre(axis), a.number) <
                              std::pair(b.centre(axis), b.number);
                     });
    return middle;
  }

  /// The bin after which to cut for the least sum of area times count.
  template <class BinOf>
  std::size_t best_bin(const Task& task, const BinOf& bin_of) const {
    std::array<Bin, kBins> bins;
    for (std::uint32_t i = task.begin; i < task.end; ++i) {
      Bin& bin = bins[bin_of(items_[i])];
      bin.box.add(items_[i].box);
      ++bin.count;
    }
    std::array<double, kBins> cost_above{};  // of what is beyond bin i
    Bin sum;
    for (std::size_t i = kBins; i-- > 1;) {
      sum.box.add(bins[i].box);
      sum.count += bins[i].count;
      cost_above[i - 1] = sum.count == 0 ? 0.0 : sum.count * sum.box.half_area();
    }
    sum = {};
    std::size_t best = kBins / 2 - 1;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
      sum.box.add(bins[i].box);
      sum.count += bins[i].count;
      if (sum.count == 0 || sum.count == task.end - task.begin) continue;
      const double cost = sum.count * sum.box.half_area() + cost_above[i];
      if (cost < best_cost) {
        best_cost = cost;
        best = i;
      }
    }
    return best;
  }

  Bvh& tree_;
  std::vector<Item> items_;
};

Bvh::Bvh(Points points, std::span<const VertexTriple> triangles)
    : scale_(unit_scale(points)), points_(points.begin(), points.end()) {
  assert(triangles.size() < kNone);
  for (Vec3& p : points_) p *= scale_.to_unit;
  order_.reserve(triangles.size());
  if (!triangles.empty()) Builder(*this, triangles).build();
  triangles_.reserve(triangles.size());
  places_.resize(triangles.size());
  for (const std::uint32_t number : order_) {
    places_[number] = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(triangles[number]);
  }
}

ClosestPoint Bvh::closest_in(std::uint32_t place, const Vec3& x) const {
  const auto [a, b, c] = triangles_[place];
  if (b == c) return closest_on_segment(points_[a], points_[b], x);
  return closest_on_triangle(points_[a], points_[b], points_[c], x);
}

template <class Accept>
Bvh::Hit Bvh::search(const Vec3& p, double upper_bound, const Accept& accept) const {
  if (nodes_.empty()) return {};
  const Vec3 x = scale_.to_unit * p;
  const auto squared_distance = [&](const Node& node) {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = x[static_cast<Eigen::Index>(axis)];
      const double d = std::max({node.low[axis] - at, at - node.high[axis], 0.0});
      sum += d * d;
    }
    return sum;
  };
  struct Waiting {
    double squared_distance;
    std::uint32_t node;
  };
  std::array<Waiting, kStackSize> stack;
  std::size_t height = 0;
  ClosestPoint best;
  std::uint32_t triangle = kNone;
  const double bound = scale_.to_unit * upper_bound;
  best.squared_distance = bound * bound;
  const auto visit_leaf = [&](const Node& leaf) {
    for (std::uint32_t place = leaf.first; place < leaf.first + leaf.count; ++place) {
      const ClosestPoint found = closest_in(place, x);
      const std::uint32_t number = order_[place];
      const bool nearer = found.squared_distance < best.squared_distance ||
                          (found.squared_distance == best.squared_distance && number < triangle);
      if (!nearer || !accept(place)) continue;
      best = found;
      triangle = number;
    }
  };
  stack[height++] = {squared_distance(nodes_[0]), 0};
  while (height > 0) {
    const Waiting next = stack[--height];
    if (next.squared_distance > best.squared_distance) continue;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      visit_leaf(node);
      continue;
    }
    Waiting near{squared_distance(nodes_[node.first]), node.first};
    Waiting far{squared_distance(nodes_[node.first + 1]), node.first + 1};
    if (far.squared_distance < near.squared_distance) std::swap(near, far);
    assert(height + 2 <= kStackSize);
    if (far.squared_distance <= best.squared_distance) stack[height++] = far;
    if (near.squared_distance <= best.squared_distance) stack[height++] = near;
  }
  if (triangle == kNone) return {};
  return {triangle, scale_.from_unit * best.position,
          scale_.from_unit * std::sqrt(best.squared_distance)};
}

Bvh::Hit Bvh::closest(const Vec3& p, double upper_bound) const {
  return search(p, upper_bound, [](std::uint32_t) { return true; });
}

Bvh::Hit Bvh::closest_facing(const Vec3& p, const Vec3& normal, double least_cosine,
                             double upper_bound) const {
  const Vec3 up = normal.stableNormalized();
  return search(p, upper_bound, [&](std::uint32_t place) {
    const auto [a, b, c] = triangles_[place];
    const Vec3 own = (points_[b] - points_[a]).cross(points_[c] - points_[a]).stableNormalized();
    return !own.isZero(0.0) && own.dot(up) >= least_cosine;
  });
}

Bvh::Hit Bvh::closest_on(std::uint32_t triangle, const Vec3& p) const {
  const ClosestPoint found = closest_in(places_[triangle], scale_.to_unit * p);
  return {triangle, scale_.from_unit * found.position,
          scale_.from_unit * std::sqrt(found.squared_distance)};
}

}  // namespace evenmesh
