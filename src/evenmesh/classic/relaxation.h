// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/base/vec3.h"
#include "evenmesh/classic/method.h"
#include "evenmesh/constraint/motion.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/orientation.h"

namespace evenmesh {

/// A way to move vertices again and again, without a function that is known to fall.
class Relaxation {
 public:
  virtual ~Relaxation() = default;

  /// Moves every vertex that may move once, as its motion allows. Fixed vertices keep their bits;
  /// tied ones go together. Same bits for any number of threads.
  /// @param[in,out] x       positions
  /// @param[in,out] places  of the motion, at x
  virtual void sweep(Workers& workers, std::vector<Vec3>& x, Motion::Places& places) = 0;
};

/// What a classic method has to know.
struct RelaxationSetting {
  const Mesh& mesh;
  const Orientation& orientation;  // of the input
  const Motion& motion;
  double length = 0.0;  // that edges should have, for methods that ask: the mesh's mean
};

/// A method that goes from vertex to vertex: all but lagrange_newton and global_laplacian.
/// @throws InvalidOption  the mesh has cells of a kind that the method cannot treat
/// What the setting refers to must outlive the relaxation.
std::unique_ptr<Relaxation> make_relaxation(Method method, const RelaxationSetting& setting);

/// Throws InvalidOption, with names and remedy, if the mesh has cells that a method cannot treat.
void check_cells(Method method, const Cells& cells);

}  // namespace evenmesh
