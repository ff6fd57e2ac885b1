// SPDX-License-Identifier: MIT
#include "evenmesh/classic/gauss_seidel.h"

#include <algorithm>
#include <utility>

namespace evenmesh {

GaussSeidel::GaussSeidel(const RelaxationSetting& setting, Steps steps, Accept accept)
    : motion_(setting.motion),
      stars_(setting.mesh, setting.motion),
      steps_(std::move(steps)),
      accept_(accept),
      shapes_(setting.mesh, setting.orientation) {}

void GaussSeidel::sweep(Workers& workers, std::vector<Vec3>& x, Motion::Places& places) {
  constexpr std::size_t kVerticesPerTask = 512;
  const std::vector<Vec3> x_0 = x;
  for (const std::vector<Index>& colour : stars_.colours()) {
    const std::size_t tasks = (colour.size() + kVerticesPerTask - 1) / kVerticesPerTask;
    workers.run(tasks, [&](std::size_t task) {
      const std::size_t first = task * kVerticesPerTask;
      const std::size_t last = std::min(colour.size(), first + kVerticesPerTask);
      for (std::size_t i = first; i < last; ++i) relax(colour[i], x_0, x, places);
    });
  }
}

void GaussSeidel::move_by(Index vertex, const Vec3& move, Points x_0, std::vector<Vec3>& x,
                          Motion::Places& places) const {
  x[vertex] = x_0[vertex] + move;
  motion_.retract(vertex, x_0, places, x, places);
}

// A vertex is where it was at the start of the sweep until its own turn.
void GaussSeidel::relax(Index vertex, Points x_0, std::vector<Vec3>& x,
                        Motion::Places& places) const {
  const Star star = stars_.of(vertex);
  const std::uint32_t slot = motion_.slot(vertex);
  const TrackPoint place = slot == Motion::kNone ? TrackPoint{} : places[slot];
  const bool judged = accept_ == Accept::unless_worst_gets_worse;
  const double worst = judged ? shapes_.of(star, x).shape : 0.0;
  for (const Step& step : steps_) {
    Vec3 move = motion_.project(places, vertex, step.rule->move(star, x));
    for (int attempt = 0; attempt < step.attempts; ++attempt, move *= 0.5) {
      if (move.isZero(0.0)) break;
      move_by(vertex, move, x_0, x, places);
      if (!judged || shapes_.of(star, x).shape >= worst) return;
      if (slot != Motion::kNone) places[slot] = place;
      move_by(vertex, Vec3::Zero(), x_0, x, places);
    }
  }
}

}  // namespace evenmesh
