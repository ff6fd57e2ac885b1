// SPDX-License-Identifier: MIT
#include "evenmesh/solver/lift.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "evenmesh/base/timer.h"
#include "evenmesh/cost/shape.h"
#include "evenmesh/mesh/rings.h"
#include "evenmesh/quality/metric.h"
#include "evenmesh/solver/descent.h"
#include "evenmesh/solver/part.h"

namespace evenmesh {
namespace {

constexpr int kExponents[] = {8, 32, 32};
constexpr double kBad = 0.5;          // times the mean of shape: what is below is lifted
constexpr std::size_t kMostBad = 50;  // one cell in so many at most
constexpr double kPull = 4.0;
constexpr int kRings = 1;  // of vertices around those of bad cells
constexpr int kIterations = 30;
constexpr double kTolerance = 1e-2;
constexpr double kGain = 1.01;  // a place that gains less is not tried again

double shape_of(const Mesh& mesh, const Orientation& orientation, Points x, std::size_t cell) {
  std::vector<Vec3> corners;
  for (const Index v : mesh.cells().vertices(cell)) corners.push_back(x[v]);
  return measure(Metric::shape, mesh.cells().kind(cell), corners, orientation.up(cell),
                 orientation.sign(cell));
}

class Lift {
 public:
  Lift(Workers& workers, const Mesh& mesh, const Problem& problem, Points start, Points origin,
       const Options& options, std::vector<Vec3>& x)
      : workers_(workers),
        mesh_(mesh),
        problem_(problem),
        start_(start),
        origin_(origin),
        options_(options),
        x_(x),
        shape_(mesh.cells().size()),
        given_up_(mesh.cells().size(), 0),
        lifted_(mesh.cells().size(), 0) {
    find_who_may_move();
    options_.solver = SolverKind::multigrid;
    options_.watch = {};
    options_.max_iterations = kIterations;
    options_.tolerance = kTolerance;
  }

  Lifting run() {
    measure_all();
    if (options_.lift_below > 0.0) {
      threshold_ = options_.lift_below;
    } else {
      const double sum = std::accumulate(shape_.begin(), shape_.end(), 0.0);
      threshold_ = kBad * sum / static_cast<double>(std::max<std::size_t>(1, shape_.size()));
    }
    for (const int exponent : kExponents) {
      const std::vector<std::uint32_t> bad = find_bad();
      if (bad.empty() || interrupted_ || out_of_time()) break;
      lift(bad, exponent);
    }
    result_.cells = static_cast<std::size_t>(std::count(lifted_.begin(), lifted_.end(), 1));
    return result_;
  }

 private:
  bool out_of_time() const {
    return options_.time_limit_seconds > 0.0 && timer_.seconds() >= options_.time_limit_seconds;
  }

  void find_who_may_move() {
    const Motion& motion = problem_.motion;
    may_move_.resize(mesh_.point_count());
    for (Index v = 0; v < may_move_.size(); ++v) {
      may_move_[v] = motion.freedom(v) != Motion::Freedom::fixed && !motion.is_tied(v);
    }
    for (const Bound& bound : problem_.bounds) {
      for (const Index v : bound.function->vertices()) may_move_[v] = 0;
    }
  }

  void measure_all() {
    for_ranges(workers_, shape_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t c = first; c < last; ++c) {
        shape_[c] = is_judged(c) ? shape_of(mesh_, problem_.orientation, x_, c) : 1.0;
      }
    });
  }

  // Surface cells in a volume mesh are where something acts.
  bool is_judged(std::size_t cell) const {
    return problem_.orientation.type != MeshType::volume ||
           traits(mesh_.cells().kind(cell)).dimension == 3;
  }

  std::vector<std::uint32_t> find_bad() const {
    std::vector<std::uint32_t> bad;
    for (std::size_t c = 0; c < shape_.size(); ++c) {
      if (!(shape_[c] < threshold_) || given_up_[c]) continue;
      const auto vertices = mesh_.cells().vertices(c);
      if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return may_move_[v]; })) {
        bad.push_back(static_cast<std::uint32_t>(c));
      }
    }
    const std::size_t most = std::max<std::size_t>(100, shape_.size() / kMostBad);
    if (bad.size() > most) {
      const auto by_shape = [&](std::uint32_t a, std::uint32_t b) {
        return shape_[a] < shape_[b] || (shape_[a] == shape_[b] && a < b);
      };
      std::nth_element(bad.begin(), bad.begin() + static_cast<std::ptrdiff_t>(most), bad.end(),
                       by_shape);
      bad.resize(most);
    }
    return bad;
  }

  std::vector<char> vertices_around(std::span<const std::uint32_t> bad) const {
    std::vector<char> around(mesh_.point_count(), 0);
    const Cells& cells = mesh_.cells();
    for (const std::uint32_t c : bad) {
      for (const Index v : cells.vertices(c)) around[v] = 1;
    }
    around = with_rings(cells, std::move(around), kRings);
    for (std::size_t v = 0; v < around.size(); ++v) around[v] = around[v] && may_move_[v];
    return around;
  }

  void lift(std::span<const std::uint32_t> bad, int exponent) {
    const std::vector<char> moving = vertices_around(bad);
    Part part = part_around(mesh_, problem_, moving);
    part.problem.terms = {{1.0, std::make_shared<Shape>()},
                          {weight(exponent), std::make_shared<Shape>(exponent)}};
    // What nobody asked for is seen to by the cost.
    const Validity& validity = problem_.validity;
    part.problem.validity.demanded =
        validity.demanded && (validity.min_jacobian > 0.0 || validity.min_size > 0.0);
    std::vector<Vec3> x = part.select(x_);
    part.problem.motion.start_from(workers_, part.select(start_), x);
    move(part, x);
    take_over(part, x, bad);
  }

  // At the threshold the power pulls kPull times as hard as the cost itself.
  double weight(int exponent) const {
    const double dimension = problem_.orientation.type == MeshType::volume ? 3.0 : 2.0;
    return kPull * std::pow(threshold_, 0.5 * dimension * (exponent - 1));
  }

  void move(Part& part, std::vector<Vec3>& x) {
    const std::vector<Vec3> origin = part.select(origin_);
    Objective objective(part.mesh, part.problem);
    objective.constrain(workers_, part.mesh, origin);
    objective.lagrangian()->reset(workers_, x);
    Multigrid preconditioner(workers_, objective.majoriser(workers_, x),
                             objective.projectors(part.problem.motion.start()));
    const std::vector<Vec3> start = x;
    const Flips flips(objective.layout(), start, part.problem.orientation);
    Options options = options_;
    options.progress = [this](const Iteration& iteration) {
      interrupted_ = interrupted_ || (options_.progress && !options_.progress(iteration));
      return !interrupted_;
    };
    if (options.time_limit_seconds > 0.0) {
      options.time_limit_seconds = std::max(1e-9, options.time_limit_seconds - timer_.seconds());
    }
    Report report;
    descend(workers_, objective, preconditioner, flips, options, x, report);
    result_.iterations += report.history.back().number;
  }

  // Numbers of the pieces that vertices belong to; two vertices of a cell that both move are in
  // the same one.
  std::vector<Index> find_pieces(const Part& part) const {
    const Motion& motion = part.problem.motion;
    std::vector<Index> piece(part.vertices.size());
    std::iota(piece.begin(), piece.end(), Index{0});
    const auto root = [&](Index v) {
      while (piece[v] != v) v = piece[v] = piece[piece[v]];
      return v;
    };
    for (std::size_t c = 0; c < part.cells.size(); ++c) {
      Index first = kNone;
      for (const Index v : part.mesh.cells().vertices(c)) {
        if (motion.freedom(v) == Motion::Freedom::fixed) continue;
        const Index own = root(v);
        const Index other = first == kNone ? own : first;
        first = std::min(own, other);
        piece[std::max(own, other)] = first;
      }
    }
    for (Index v = 0; v < piece.size(); ++v) piece[v] = root(v);
    return piece;
  }

  // Takes over the pieces whose least shape has risen.
  void take_over(const Part& part, Points x, std::span<const std::uint32_t> bad) {
    const std::vector<Index> piece = find_pieces(part);
    const Motion& motion = part.problem.motion;
    struct Least {
      double before = 1.0;
      double after = 1.0;
    };
    std::vector<Least> least(part.vertices.size());
    std::vector<Index> piece_of_cell(part.cells.size(), kNone);
    std::vector<double> after(part.cells.size());
    for (std::size_t c = 0; c < part.cells.size(); ++c) {
      for (const Index v : part.mesh.cells().vertices(c)) {
        if (motion.freedom(v) != Motion::Freedom::fixed) piece_of_cell[c] = piece[v];
      }
      if (piece_of_cell[c] == kNone || !is_judged(part.cells[c])) continue;
      Least& own = least[piece_of_cell[c]];
      after[c] = shape_of(part.mesh, part.problem.orientation, x, c);
      own.before = std::min(own.before, shape_[part.cells[c]]);
      own.after = std::min(own.after, after[c]);
    }
    for (Index v = 0; v < part.vertices.size(); ++v) {
      const Least& own = least[piece[v]];
      if (motion.freedom(v) != Motion::Freedom::fixed && own.after > own.before) {
        x_[part.vertices[v]] = x[v];
      }
    }
    std::vector<char> is_bad(shape_.size(), 0);
    for (const std::uint32_t c : bad) is_bad[c] = 1;
    for (std::size_t c = 0; c < part.cells.size(); ++c) {
      if (piece_of_cell[c] == kNone || !is_judged(part.cells[c])) continue;
      const std::uint32_t number = part.cells[c];
      const Least& own = least[piece_of_cell[c]];
      if (is_bad[number] && !(own.after > kGain * own.before)) given_up_[number] = 1;
      if (!(own.after > own.before)) continue;
      if (is_bad[number] && after[c] > shape_[number]) lifted_[number] = 1;
      shape_[number] = after[c];
    }
  }

  static constexpr Index kNone = ~Index{0};

  Workers& workers_;
  const Mesh& mesh_;
  const Problem& problem_;
  const Points start_;
  const Points origin_;
  Options options_;
  const Timer timer_;
  std::vector<Vec3>& x_;
  std::vector<char> may_move_;  // per vertex
  std::vector<double> shape_;   // per cell, at x_
  std::vector<char> given_up_;  // per cell
  std::vector<char> lifted_;    // per cell
  double threshold_ = 0.0;
  bool interrupted_ = false;
  Lifting result_;
};

}  // namespace

Lifting lift_worst(Workers& workers, const Mesh& mesh, const Problem& problem, Points start,
                   Points origin, const Options& options, std::vector<Vec3>& x) {
  return Lift(workers, mesh, problem, start, origin, options, x).run();
}

}  // namespace evenmesh
