// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/objective.h"

namespace evenmesh::bench {

/// How close to the cost to be reached counts as there.
inline constexpr double kSameCost = 1e-6;

/// Another optimiser at work on the case `triangles`: the function it minimises, and the clock.
///
/// Its unknowns are x and y of the vertices that may move. Values and gradients are those of
/// Objective::evaluate() on one thread, so what is compared is what each makes of them. The clock
/// starts after everything that all optimisers need alike (mesh, topology, problem).
class Contest {
 public:
  /// @param target  the cost to be reached, within kSameCost of it
  /// @param most_cpu_seconds  when to give up
  Contest(std::size_t vertices, double target, double most_cpu_seconds);
  Contest(const Contest&) = delete;
  Contest& operator=(const Contest&) = delete;

  const Mesh& mesh() const { return mesh_; }
  std::size_t unknowns() const { return 2 * moving_.size(); }
  /// Number of a vertex's first unknown; -1 if it is fixed.
  const std::vector<std::ptrdiff_t>& first_unknown() const { return first_unknown_; }
  std::vector<double> start() const;

  void start_clock();
  /// The cost at y; fills in the gradient unless it is empty.
  double evaluate(std::span<const double> y, std::span<double> gradient);
  /// Tells the clock of a cost that an iterate has; true if the contest is over.
  bool over(double cost);

  /// What came out, for the report.
  nlohmann::json result() const;

 private:
  Mesh mesh_;
  Problem problem_;
  Objective objective_;
  Workers workers_{1};
  std::vector<Index> moving_;
  std::vector<std::ptrdiff_t> first_unknown_;
  std::vector<Vec3> x_, g_;

  double target_;
  double most_cpu_seconds_;
  double started_ = 0.0;
  double finished_ = 0.0;  // CPU seconds when the target was reached
  bool reached_ = false;
  double least_cost_;
  int values_ = 0;
  int gradients_ = 0;
};

}  // namespace evenmesh::bench
