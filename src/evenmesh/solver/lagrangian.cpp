// SPDX-License-Identifier: MIT
#include "evenmesh/solver/lagrangian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "evenmesh/mesh/determinants.h"

namespace evenmesh {
namespace {

// Wide and weak first: that turns nearly all cells round in a few steps. A stronger penalty is for
// those that resist; the exact one, which needs mu > lambda, comes with the multipliers.
struct Stage {
  double delta, mu;
};
constexpr std::array kStages = {Stage{0.3, 5.0}, Stage{0.05, 20.0}, Stage{0.01, 80.0}};
constexpr int kMostStepsInStage = 10;
constexpr double kFirstRho = 10.0;
constexpr double kGreatestRho = 100.0;
constexpr double kRhoGrowth = 1.6;
constexpr double kResidualFall = 0.5;  // what a round should bring at least
constexpr int kMostRounds = 60;
constexpr double kMet = 1e-6;            // what counts as meeting a demand, in units of v
constexpr double kEquationSlack = 0.01;  // part of that for equations, which have no margin
constexpr double kMargin = 2e-6;  // what is aimed at beyond the demand, so that it is met strictly

// At a corner whose neighbour is itself the determinant is always 0. A polygon has one for all.
bool repeats_a_vertex(CellKind kind, std::span<const Index> cell) {
  if (kind == CellKind::polygon) return false;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (std::count(cell.begin(), cell.end(), cell[i]) > 1) return true;
  }
  return false;
}

}  // namespace

template <typename Body>
void Lagrangian::for_rows(const Layout::Block& block, Points x, const Body& body) const {
  if (demands_.empty()) return;
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const Demand& demand = demands_[block.first + i];
    if (demand.scale == 0.0f) continue;
    const std::uint32_t number = block.cells.numbers[i];
    const double scale = demand.scale / size_unit_;
    for_determinants(block.cells.kind, block.cells.cell(i), x, problem_.orientation.up(number),
                     problem_.orientation.sign(number), [&](std::uint32_t k, const auto& corner) {
                       body(i, demand.row + k, scale * corner.determinant() - demand.least, corner);
                     });
  }
}

// ---- setting up --------------------------------------------------------------------------------

Lagrangian::Lagrangian(Workers& workers, const Mesh& input, Points origin, const Problem& problem,
                       const Layout& layout)
    : input_(input), origin_(origin), problem_(problem), layout_(layout) {
  set_up_scales(workers);
  if (problem.validity.demanded) set_up_cells(workers);
  set_up_functions();
  for (std::size_t v = 0; v < problem.max_move.size(); ++v) {
    const auto vertex = static_cast<Index>(v);
    if (problem.motion.freedom(vertex) == Motion::Freedom::fixed) continue;
    if (std::isfinite(problem.max_move[v])) leashes_.push_back({vertex, problem.max_move[v]});
  }
  reset(workers, input.points());
}

void Lagrangian::reset(Workers& workers, Points x) {
  std::fill(lambda_.begin(), lambda_.end(), 0.0f);
  for (FunctionRow& row : functions_) row.lambda = 0.0;
  for (Leash& leash : leashes_) leash.lambda = 0.0;
  rho_ = kFirstRho;
  rounds_ = 0;
  last_residual_ = std::numeric_limits<double>::infinity();
  const bool violated = violation(workers, x).cells > 0;
  enter_stage(violated ? 0 : static_cast<int>(kStages.size()));
  dormant_ = !violated && functions_.empty() && leashes_.empty();
}

// Geometric mean of the springs' stiffnesses, which a collapsed cell cannot spoil. Some cells speak
// for all of a block.
double Lagrangian::typical_stiffness(CellBlock cells) const {
  constexpr std::size_t kSample = 200;
  cells.vertices = cells.vertices.first(std::min(cells.size(), kSample) *
                                        static_cast<std::size_t>(cells.vertices_per_cell));
  std::vector<Spring> springs;
  double sum = 0.0;
  for (const Term& term : problem_.terms) {
    springs.clear();
    term.cost->add_springs(cells, input_.points(), springs);
    double logs = 0.0;
    std::size_t count = 0;
    for (const Spring& spring : springs) {
      if (!(spring.stiffness > 0.0) || !std::isfinite(spring.stiffness)) continue;
      logs += std::log(spring.stiffness);
      ++count;
    }
    if (count > 0) sum += term.weight * std::exp(logs / static_cast<double>(count));
  }
  return sum > 0.0 && std::isfinite(sum) ? sum : 1.0;
}

void Lagrangian::set_up_scales(Workers& workers) {
  stiffnesses_.assign(layout_.chunks(), 0.0);
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    stiffnesses_[chunk] = std::max(stiffnesses_[chunk], typical_stiffness(block.cells));
  });
  sizes_ = reference_sizes(input_, problem_.orientation);
  dimension_ = problem_.orientation.type == MeshType::volume ? 3.0 : 2.0;
  const auto greatest = [](const std::vector<double>& values) {
    const double most = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
    return most > 0.0 ? most : 1.0;
  };
  other_stiffness_ = greatest(stiffnesses_);
  size_unit_ = greatest(sizes_);
  const double mean = std::max(mean_size(input_, problem_.orientation), 1e-3 * size_unit_);
  typical_length_ = std::pow(mean, 1.0 / dimension_);
  weight_unit_ = other_stiffness_ * std::pow(size_unit_, 2.0 / dimension_);
}

void Lagrangian::set_up_cells(Workers& workers) {
  const Validity& validity = problem_.validity;
  demands_.resize(layout_.cells());
  std::vector<std::uint32_t> rows(layout_.cells() + 1, 0);
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    const CellKind kind = block.cells.kind;
    const double ideal = ideal_determinant(kind);
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const std::uint32_t number = block.cells.numbers[i];
      const auto cell = block.cells.cell(i);
      const Vec3 up = problem_.orientation.up(number);
      const double size = sizes_[number];
      const bool fixed = std::all_of(cell.begin(), cell.end(), [&](Index v) {
        return problem_.motion.freedom(v) == Motion::Freedom::fixed;
      });
      if (!(size > 0.0) || fixed || repeats_a_vertex(kind, cell)) continue;
      if (traits(kind).dimension == 2 && up.isZero()) continue;
      const double unit = size * ideal;
      double own = std::numeric_limits<double>::infinity();
      for_determinants(kind, cell, input_.points(), up, problem_.orientation.sign(number),
                       [&](std::uint32_t, const auto& corner) {
                         own = std::min(own, corner.determinant() / unit);
                       });
      double least = validity.min_jacobian;
      if (least == 0.0) {
        least = Validity::kDefaultJacobian;
        if (own > 0.0) least = std::min(least, 0.5 * own);
      }
      if (validity.min_size > 0.0) least = std::max(least, validity.min_size / size);
      Demand& demand = demands_[block.first + i];
      demand.scale = static_cast<float>(size_unit_ / unit);
      demand.least = static_cast<float>(least);
      demand.weight =
          static_cast<float>(stiffnesses_[chunk] * std::pow(size, 2.0 / dimension_) / weight_unit_);
      rows[block.first + i + 1] = static_cast<std::uint32_t>(determinants_of(kind));
    }
  });
  for (std::size_t i = 0; i < demands_.size(); ++i) {
    rows[i + 1] += rows[i];
    demands_[i].row = rows[i];
  }
  lambda_.assign(rows.back(), 0.0f);
  if (rows.back() == 0) demands_.clear();
  sizes_ = {};
}

void Lagrangian::set_up_functions() {
  std::vector<Vec3> gradient;
  for (std::size_t b = 0; b < problem_.bounds.size(); ++b) {
    const Bound& bound = problem_.bounds[b];
    gradient.assign(bound.function->vertices().size(), Vec3::Zero());
    value(b, input_.points(), gradient);
    double squares = 0.0;
    for (const Vec3& g : gradient) squares += g.squaredNorm();
    double unit = std::sqrt(squares) * typical_length_;
    if (!(unit > 0.0) || !std::isfinite(unit)) unit = typical_length_;
    const auto number = static_cast<std::uint32_t>(b);
    if (bound.is_equation()) {
      functions_.push_back({number, 1.0, bound.lower, true, unit});
      continue;
    }
    if (std::isfinite(bound.lower)) {
      functions_.push_back({number, 1.0, bound.lower, false, unit});
    }
    if (std::isfinite(bound.upper)) {
      functions_.push_back({number, -1.0, bound.upper, false, unit});
    }
  }
}

// ---- the function ------------------------------------------------------------------------------

Lagrangian::Slope Lagrangian::psi(double v, double lambda) const {
  if (mode_ == Mode::multipliers) {
    const double force = lambda - rho_ * (v - kMargin);
    if (force <= 0.0) return {-lambda * lambda / (2.0 * rho_), 0.0, 0.0};
    return {(force * force - lambda * lambda) / (2.0 * rho_), -force, rho_};
  }
  const double root = std::sqrt(v * v + 4.0 * delta_ * delta_);
  // root - v without cancellation.
  const double gap = v > 0.0 ? 4.0 * delta_ * delta_ / (root + v) : root - v;
  const double bend = 4.0 * delta_ * delta_ / (root * root * root);
  return {0.5 * mu_ * gap, -0.5 * mu_ * gap / root, 0.5 * mu_ * bend};
}

Lagrangian::Slope Lagrangian::psi_of_equation(double v, double lambda) const {
  return {(0.5 * rho_ * v - lambda) * v, rho_ * v - lambda, rho_};
}

Lagrangian::Slope Lagrangian::psi_of(const FunctionRow& row, double c) const {
  const double v = value_of(row, c);
  return row.equation ? psi_of_equation(v, row.lambda) : psi(v, row.lambda);
}

double Lagrangian::value_of(const Leash& leash, Points x) const {
  const double move = (x[leash.vertex] - origin_[leash.vertex]).norm() / leash.length;
  return 1.0 - move * move;
}

double Lagrangian::evaluate(const Layout::Block& block, Points x, std::span<Vec3> gradient) const {
  if (dormant_) return 0.0;
  double sum = 0.0;
  for_rows(block, x, [&](std::size_t i, std::uint32_t row, double v, const auto& corner) {
    const Slope slope = psi(v, lambda_[row]);
    const Demand& demand = demands_[block.first + i];
    sum += demand.weight * slope.value;
    if (gradient.empty() || slope.derivative == 0.0) return;
    const double factor = weight_unit_ * demand.weight * slope.derivative;
    corner.add_gradient(factor * (demand.scale / size_unit_), gradient);
  });
  return weight_unit_ * sum;
}

double Lagrangian::value(std::size_t bound, Points x, std::span<Vec3> gradient) const {
  return problem_.bounds[bound].function->at(x, gradient);
}

double Lagrangian::evaluate_others(Points x, std::span<Vec3> gradient) const {
  double sum = 0.0;
  std::vector<Vec3> part;
  const double weight = weight_of_functions();
  for (const FunctionRow& row : functions_) {
    const Function& function = *problem_.bounds[row.bound].function;
    part.assign(gradient.empty() ? 0 : function.vertices().size(), Vec3::Zero());
    const Slope slope = psi_of(row, value(row.bound, x, part));
    sum += weight * slope.value;
    if (slope.derivative == 0.0) continue;
    const double factor = weight * slope.derivative * row.sign / row.unit;
    for (std::size_t i = 0; i < part.size(); ++i) {
      gradient[function.vertices()[i]] += factor * part[i];
    }
  }
  for (const Leash& leash : leashes_) {
    const Slope slope = psi(value_of(leash, x), leash.lambda);
    sum += weight_of(leash) * slope.value;
    if (gradient.empty() || slope.derivative == 0.0) continue;
    const Vec3 move = x[leash.vertex] - origin_[leash.vertex];
    gradient[leash.vertex] -= 2.0 * other_stiffness_ * slope.derivative * move;
  }
  return sum;
}

// ---- second derivatives ------------------------------------------------------------------------

double Lagrangian::evaluate_bound(std::size_t bound, Points own, std::span<Vec3> gradient) const {
  const double c = problem_.bounds[bound].function->evaluate(own, gradient);
  double sum = 0.0;
  double factor = 0.0;
  for (const FunctionRow& row : functions_) {
    if (row.bound != bound) continue;
    const Slope slope = psi_of(row, c);
    sum += weight_of_functions() * slope.value;
    factor += weight_of_functions() * slope.derivative * row.sign / row.unit;
  }
  for (Vec3& g : gradient) g *= factor;
  return sum;
}

double Lagrangian::curvature_of_bound(std::size_t bound, Points own, std::span<Vec3> slope) const {
  const double c = problem_.bounds[bound].function->evaluate(own, slope);
  double factor = 0.0;
  for (const FunctionRow& row : functions_) {
    if (row.bound != bound) continue;
    factor += weight_of_functions() * psi_of(row, c).curvature / (row.unit * row.unit);
  }
  return factor;
}

void Lagrangian::for_leashes(Points x,
                             const std::function<void(Index, const Eigen::Matrix3d&)>& body) const {
  for (const Leash& leash : leashes_) {
    const Slope slope = psi(value_of(leash, x), leash.lambda);
    const Vec3 part = (x[leash.vertex] - origin_[leash.vertex]) / leash.length;
    body(leash.vertex, 4.0 * other_stiffness_ * slope.curvature * part * part.transpose() -
                           2.0 * other_stiffness_ * slope.derivative * Eigen::Matrix3d::Identity());
  }
}

// ---- rows one by one ---------------------------------------------------------------------------

void Lagrangian::for_each_row(Points x, const std::function<void(const Row&)>& body) const {
  std::vector<Vec3> slope;
  for (const FunctionRow& row : functions_) {
    const Function& function = *problem_.bounds[row.bound].function;
    slope.assign(function.vertices().size(), Vec3::Zero());
    const double v = value_of(row, value(row.bound, x, slope));
    for (Vec3& part : slope) part *= row.sign / row.unit;
    body({row.equation ? v : v - kMargin, row.equation, function.vertices(), slope});
  }
  for (const Leash& leash : leashes_) {
    const Vec3 down =
        -2.0 / (leash.length * leash.length) * (x[leash.vertex] - origin_[leash.vertex]);
    body({value_of(leash, x) - kMargin, false, {&leash.vertex, 1}, {&down, 1}});
  }
  std::vector<Vec3> gradient(x.size(), Vec3::Zero());
  Workers alone;
  layout_.for_blocks(alone, [&](std::size_t, const Layout::Block& block) {
    for_rows(block, x, [&](std::size_t i, std::uint32_t, double v, const auto& corner) {
      const std::span<const Index> vertices(corner.vertices);
      corner.add_gradient(demands_[block.first + i].scale / size_unit_, gradient);
      slope.clear();
      for (const Index vertex : vertices)
        slope.push_back(std::exchange(gradient[vertex], Vec3::Zero()));
      body({v - kMargin, false, vertices, slope});
    });
  });
}

void Lagrangian::set_multipliers(std::span<const double> multipliers) {
  mode_ = Mode::multipliers;
  dormant_ = false;
  auto next = multipliers.begin();
  for (FunctionRow& row : functions_) row.lambda = *next++ / weight_of_functions();
  for (Leash& leash : leashes_) leash.lambda = *next++ / weight_of(leash);
  Workers alone;
  layout_.for_blocks(alone, [&](std::size_t, const Layout::Block& block) {
    for (std::size_t i = 0; i < block.cells.size() && !demands_.empty(); ++i) {
      const Demand& demand = demands_[block.first + i];
      if (demand.scale == 0.0f) continue;
      for (std::size_t k = 0; k < determinants_of(block.cells.kind); ++k) {
        lambda_[demand.row + k] =
            static_cast<float>(*next++ / (weight_unit_ * static_cast<double>(demand.weight)));
      }
    }
  });
}

// ---- the schedule ------------------------------------------------------------------------------

void Lagrangian::enter_stage(int stage) {
  stage_ = stage;
  const bool penalty = stage < static_cast<int>(kStages.size());
  mode_ = penalty ? Mode::exact_penalty : Mode::multipliers;
  if (!penalty) return;
  delta_ = kStages[static_cast<std::size_t>(stage)].delta;
  mu_ = kStages[static_cast<std::size_t>(stage)].mu;
}

bool Lagrangian::advance(Workers& workers, Points x, int steps, bool minimised) {
  if (dormant_) {
    dormant_ = violation(workers, x).cells == 0;
    return !dormant_;
  }
  if (mode_ == Mode::exact_penalty) {
    const bool met = violation(workers, x).cells == 0;
    if (!met && !minimised && steps < kMostStepsInStage) return false;
    if (met || stage_ + 1 == static_cast<int>(kStages.size())) {
      take_multipliers_from_penalty(workers, x);
      enter_stage(static_cast<int>(kStages.size()));
    } else {
      enter_stage(stage_ + 1);
    }
    return true;
  }
  const double now = residual(workers, x);
  if (now <= kMet || rounds_ >= kMostRounds) return false;
  ++rounds_;
  update_multipliers(workers, x);
  if (now > kResidualFall * last_residual_) rho_ = std::min(kRhoGrowth * rho_, kGreatestRho);
  last_residual_ = now;
  return true;
}

void Lagrangian::take_multipliers_from_penalty(Workers& workers, Points x) {
  layout_.for_blocks(workers, [&](std::size_t, const Layout::Block& block) {
    for_rows(block, x, [&](std::size_t, std::uint32_t row, double v, const auto&) {
      lambda_[row] = v < 5.0 * delta_ ? static_cast<float>(-psi(v, 0.0).derivative) : 0.0f;
    });
  });
}

double Lagrangian::residual(Workers& workers, Points x) const {
  std::vector<double> greatest(layout_.chunks(), 0.0);
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    for_rows(block, x, [&](std::size_t, std::uint32_t row, double v, const auto&) {
      greatest[chunk] =
          std::max(greatest[chunk], std::abs(std::min(v - kMargin, lambda_[row] / rho_)));
    });
  });
  double most = greatest.empty() ? 0.0 : *std::max_element(greatest.begin(), greatest.end());
  for (const FunctionRow& row : functions_) {
    const double v = value_of(row, value(row.bound, x, {}));
    const double off = row.equation ? v / kEquationSlack : std::min(v - kMargin, row.lambda / rho_);
    most = std::max(most, std::abs(off));
  }
  for (const Leash& leash : leashes_) {
    most = std::max(most, std::abs(std::min(value_of(leash, x) - kMargin, leash.lambda / rho_)));
  }
  return most;
}

void Lagrangian::update_multipliers(Workers& workers, Points x) {
  const auto next = [&](double lambda, double v) {
    return std::max(0.0, lambda - rho_ * (v - kMargin));
  };
  layout_.for_blocks(workers, [&](std::size_t, const Layout::Block& block) {
    for_rows(block, x, [&](std::size_t, std::uint32_t row, double v, const auto&) {
      lambda_[row] = static_cast<float>(next(lambda_[row], v));
    });
  });
  for (FunctionRow& row : functions_) {
    const double v = value_of(row, value(row.bound, x, {}));
    row.lambda = row.equation ? row.lambda - rho_ * v : next(row.lambda, v);
  }
  for (Leash& leash : leashes_) leash.lambda = next(leash.lambda, value_of(leash, x));
}

// ---- what came of it ---------------------------------------------------------------------------

Lagrangian::Violation Lagrangian::violation(Workers& workers, Points x) const {
  std::vector<Violation> parts(layout_.chunks());
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    Violation& part = parts[chunk];
    std::size_t last = ~std::size_t{0};
    std::size_t last_inverted = ~std::size_t{0};
    for_rows(block, x, [&](std::size_t i, std::uint32_t, double v, const auto&) {
      if (v >= 0.0) return;
      part.greatest = std::max(part.greatest, -v);
      if (std::exchange(last, i) != i) ++part.cells;
      if (v + demands_[block.first + i].least > 0.0) return;
      if (std::exchange(last_inverted, i) != i) ++part.inverted;
    });
  });
  Violation all;
  for (const Violation& part : parts) {
    all.greatest = std::max(all.greatest, part.greatest);
    all.cells += part.cells;
    all.inverted += part.inverted;
  }
  for (const FunctionRow& row : functions_) {
    const double v = value_of(row, value(row.bound, x, {}));
    all.greatest = std::max(all.greatest, row.equation ? std::abs(v) : -v);
  }
  for (const Leash& leash : leashes_) all.greatest = std::max(all.greatest, -value_of(leash, x));
  return all;
}

std::vector<ActiveCell> Lagrangian::active_cells(Workers& workers, Points x) const {
  std::vector<std::vector<ActiveCell>> parts(layout_.chunks());
  layout_.for_blocks(workers, [&](std::size_t chunk, const Layout::Block& block) {
    std::vector<ActiveCell>& part = parts[chunk];
    for_rows(block, x, [&](std::size_t i, std::uint32_t row, double v, const auto&) {
      const double multiplier = mode_ == Mode::multipliers ? lambda_[row] : 0.0;
      const double excess = v < -kMet ? -v : 0.0;
      if (multiplier == 0.0 && excess == 0.0) return;
      const std::uint32_t number = block.cells.numbers[i];
      const double weighed = weight_unit_ * demands_[block.first + i].weight * multiplier;
      if (part.empty() || part.back().cell != number) part.push_back({number, 0.0, 0.0});
      part.back().multiplier += weighed;
      part.back().excess = std::max(part.back().excess, excess);
    });
  });
  std::vector<ActiveCell> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end(),
            [](const ActiveCell& a, const ActiveCell& b) { return a.cell < b.cell; });
  return all;
}

std::vector<ActiveBound> Lagrangian::active_bounds(Points x) const {
  std::vector<ActiveBound> active;
  const double weight = weight_of_functions();
  for (const FunctionRow& row : functions_) {
    const double v = value_of(row, value(row.bound, x, {}));
    double excess = row.equation ? std::abs(v) : -v;
    if (excess <= kMet) excess = 0.0;
    if (row.lambda == 0.0 && excess == 0.0) continue;
    active.push_back({row.bound, weight * row.sign * row.lambda / row.unit, excess * row.unit});
  }
  return active;
}

std::vector<ActiveBound> Lagrangian::active_moves(Points x) const {
  std::vector<ActiveBound> active;
  for (const Leash& leash : leashes_) {
    const double v = value_of(leash, x);
    if (leash.lambda == 0.0 && v >= -kMet) continue;
    // dv / dlength = 2 / length where v = 0.
    active.push_back({leash.vertex, 2.0 * other_stiffness_ * leash.length * leash.lambda,
                      v < -kMet ? leash.length * (std::sqrt(1.0 - v) - 1.0) : 0.0});
  }
  return active;
}

}  // namespace evenmesh
