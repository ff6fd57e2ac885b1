// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "evenmesh/base/parallel.h"
#include "evenmesh/solver/blocks.h"
#include "evenmesh/solver/multigrid.h"
#include "evenmesh/solver/sparse.h"

namespace evenmesh {

/// Which aggregate each row belongs to. Rows without unknown belong to none.
struct Aggregates {
  static constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> of_row;
  std::uint32_t count = 0;
};

/// Groups strongly coupled neighbours: every row none of whose neighbours is taken yet founds an
/// aggregate with them; what remains joins the neighbouring aggregate it is coupled to most.
/// Aggregates are numbered in the order of their founders, so good orders stay good.
Aggregates aggregate(const SymmetricMatrix& matrix);

/// P = (I - omega D^-1 A) P_0, with P_0 the aggregates' indicator functions and
/// omega = 4 / (3 rho), rho the Gershgorin bound of D^-1 A.
SparseMatrix smoothed_interpolation(Workers& workers, const SymmetricMatrix& matrix,
                                    const Aggregates& aggregates);

SparseMatrix transpose(const SparseMatrix& matrix, std::size_t columns);

/// P^T A P.
SymmetricMatrix galerkin_product(Workers& workers, const SymmetricMatrix& matrix,
                                 const SparseMatrix& interpolation,
                                 const SparseMatrix& restriction);

/// The rows in which p^T P (S (x) I) P p differs from (p^T S p) (x) I, P being made of projectors.
/// @param matrix  S
/// @param coarse  p^T S p
CoupledRows galerkin_couplings(Workers& workers, const SymmetricMatrix& matrix,
                               const Projections& projections, const SparseMatrix& interpolation,
                               const SparseMatrix& restriction, const SymmetricMatrix& coarse);

/// The same on coarser levels: of p^T A p, where A is matrix (x) I but for the rows given.
CoupledRows galerkin_couplings(Workers& workers, const SymmetricMatrix& matrix,
                               const CoupledRows& rows, const SparseMatrix& interpolation,
                               const SparseMatrix& restriction, const SymmetricMatrix& coarse);

}  // namespace evenmesh
