// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "evenmesh/classic/relaxation.h"
#include "evenmesh/classic/rule.h"
#include "evenmesh/classic/stars.h"
#include "evenmesh/classic/worst_shape.h"

namespace evenmesh {

/// Which moves are made.
enum class Accept : std::uint8_t {
  all,
  unless_worst_gets_worse  // of the cells around the vertex, by `shape`
};

/// Moves one vertex after the other, each seeing where the others are by now. The order is that of
/// the stars' colours, so it depends on how vertices are numbered, if slightly.
class GaussSeidel final : public Relaxation {
 public:
  /// A rule, and how often its move is tried before the next rule's turn, halved each time.
  struct Step {
    std::unique_ptr<Rule> rule;
    int attempts = 1;
  };
  using Steps = std::vector<Step>;

  /// @param steps  tried in their order; the first move that is accepted is made
  GaussSeidel(const RelaxationSetting& setting, Steps steps, Accept accept);

  void sweep(Workers& workers, std::vector<Vec3>& x, Motion::Places& places) override;

 private:
  void relax(Index vertex, Points x_0, std::vector<Vec3>& x, Motion::Places& places) const;
  void move_by(Index vertex, const Vec3& move, Points x_0, std::vector<Vec3>& x,
               Motion::Places& places) const;

  const Motion& motion_;
  Stars stars_;
  Steps steps_;
  Accept accept_;
  WorstShape shapes_;
};

}  // namespace evenmesh
