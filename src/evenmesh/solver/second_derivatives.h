// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include <Eigen/Core>

#include "evenmesh/base/vec3.h"
#include "evenmesh/solver/layout.h"
#include "evenmesh/solver/objective.h"
#include "evenmesh/solver/reduced_matrix.h"

namespace evenmesh {

/// Takes a small symmetric matrix as ReducedMatrix::add() does, and may change it.
using TakeBlock = std::function<void(std::span<const Index> vertices, Eigen::MatrixXd& block)>;

/// The second derivatives of what each of a block's cells adds to an objective, with respect to the
/// unknowns of its vertices: central differences of its gradient, which is all that costs offer,
/// with a relative error of about 1e-9.
/// @param unit  length of the differences, over 1e-5, where a cell has no size of its own
void differentiate_cells(const Objective& objective, const Layout::Block& block, Points x,
                         const ReducedMatrix& unknowns, double unit, const TakeBlock& take);

/// The same for a function of some vertices, given its gradient with respect to them.
/// @param gradient  gradient(own, g) sets g to that at the positions `own` of `vertices`
void differentiate_function(std::span<const Index> vertices, Points x,
                            const ReducedMatrix& unknowns, double unit,
                            const std::function<void(Points own, std::span<Vec3> g)>& gradient,
                            const TakeBlock& take);

/// The nearest matrix without negative eigenvalues.
void clamp_eigenvalues(Eigen::MatrixXd& matrix);

}  // namespace evenmesh
