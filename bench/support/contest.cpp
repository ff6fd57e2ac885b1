// SPDX-License-Identifier: MIT
#include "bench/support/contest.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "bench/support/case.h"
#include "evenmesh/base/timer.h"

namespace evenmesh::bench {

Contest::Contest(std::size_t vertices, double target, double most_cpu_seconds)
    : mesh_(make_case_mesh("triangles", vertices)),
      problem_(make_case_problem(mesh_)),
      objective_(mesh_, problem_),
      first_unknown_(mesh_.point_count(), -1),
      x_(mesh_.points().begin(), mesh_.points().end()),
      g_(x_.size()),
      target_(target),
      most_cpu_seconds_(most_cpu_seconds),
      least_cost_(std::numeric_limits<double>::infinity()) {
  for (Index v = 0; v < x_.size(); ++v) {
    if (problem_.motion.freedom(v) == Motion::Freedom::fixed) continue;
    first_unknown_[v] = static_cast<std::ptrdiff_t>(unknowns());
    moving_.push_back(v);
  }
}

std::vector<double> Contest::start() const {
  std::vector<double> y;
  y.reserve(unknowns());
  for (const Index v : moving_) y.insert(y.end(), {mesh_.points()[v].x(), mesh_.points()[v].y()});
  return y;
}

void Contest::start_clock() { started_ = cpu_seconds(); }

double Contest::evaluate(std::span<const double> y, std::span<double> gradient) {
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    x_[moving_[i]].head<2>() = Eigen::Vector2d(y[2 * i], y[2 * i + 1]);
  }
  if (gradient.empty()) {
    ++values_;
    return objective_.evaluate(workers_, x_, {});
  }
  ++gradients_;
  const double cost = objective_.evaluate(workers_, x_, g_);
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    gradient[2 * i] = g_[moving_[i]].x();
    gradient[2 * i + 1] = g_[moving_[i]].y();
  }
  return cost;
}

bool Contest::over(double cost) {
  least_cost_ = std::min(least_cost_, cost);
  const double used = cpu_seconds() - started_;
  if (!reached_) finished_ = used;
  if (cost <= target_ * (1.0 + kSameCost)) reached_ = true;
  return reached_ || used > most_cpu_seconds_;
}

nlohmann::json Contest::result() const {
  return {{"vertices", mesh_.point_count()},
          {"unknowns", unknowns()},
          {"target", target_},
          {"reached", reached_},
          {"cost", least_cost_},
          {"relative_excess", least_cost_ / target_ - 1.0},
          {"cpu_seconds", finished_},
          {"cpu_limit_seconds", most_cpu_seconds_},
          {"values", values_},
          {"gradients", gradients_}};
}

}  // namespace evenmesh::bench
