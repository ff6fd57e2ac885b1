// SPDX-License-Identifier: MIT
#include "evenmesh/solver/direction.h"

#include <algorithm>

#include "evenmesh/solver/vectors.h"

namespace evenmesh {

void ConjugateGradients::next(Workers& workers, Points g, Points g_old, Points z,
                              std::vector<Vec3>& p) {
  const double gz = dot(workers, g, z);
  const double beta =
      last_gz_ > 0.0 ? std::max(0.0, (gz - dot(workers, g_old, z)) / last_gz_) : 0.0;
  last_gz_ = gz;
  for_ranges(workers, p.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) p[i] = beta * p[i] - z[i];
  });
}

void Lbfgs::remember(Workers& workers, Points x, Points x_old, Points g, Points g_old) {
  Pair pair;
  if (pairs_.size() == kPairs) {
    pair = std::move(pairs_.front());
    pairs_.pop_front();
  }
  pair.s.resize(x.size());
  pair.y.resize(x.size());
  add(workers, x, -1.0, x_old, pair.s);
  add(workers, g, -1.0, g_old, pair.y);
  const double curvature = dot(workers, pair.s, pair.y);
  if (!(curvature > 0.0)) return;
  pair.rho = 1.0 / curvature;
  pairs_.push_back(std::move(pair));
}

void Lbfgs::before_preconditioner(Workers& workers, std::vector<Vec3>& q) {
  for (auto pair = pairs_.rbegin(); pair != pairs_.rend(); ++pair) {
    pair->alpha = pair->rho * dot(workers, pair->s, q);
    add(workers, q, -pair->alpha, pair->y, q);
  }
}

void Lbfgs::after_preconditioner(Workers& workers, std::vector<Vec3>& p) {
  for (const Pair& pair : pairs_) {
    const double beta = pair.rho * dot(workers, pair.y, p);
    add(workers, p, pair.alpha - beta, pair.s, p);
  }
  for_ranges(workers, p.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) p[i] = -p[i];
  });
}

}  // namespace evenmesh
