// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/evenmesh/gallery/run.h"

namespace evenmesh::gallery {

/// The mesh at the start and as the ways of a case leave it, side by side, as SVG. Ways that lead
/// to what another one shows already are left out.
/// @param results  run_all_ways(of)
std::string picture_of(const Case& of, const std::vector<Result>& results);

/// How far each way is above the least cost it comes to, iteration by iteration, and how many the
/// paper takes, as SVG.
std::string convergence_of(const Case& of, const std::vector<Result>& results);

}  // namespace evenmesh::gallery
