// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/evenmesh/gallery/run.h"

namespace evenmesh::gallery {

/// Rows of words, the first of them the headings. Numbers are rounded to what does not depend on
/// the machine.
using Table = std::vector<std::vector<std::string>>;

/// What the paper says of a case, the start, and one row for each way.
/// @param results  run_all_ways(of)
Table table_of(const Case& of, const std::vector<Result>& results);

/// The random starts of the cases of an exact plate.
Table starts_table(const std::vector<const Case*>& of, const std::vector<Medians>& medians);

/// All cases: what each figure shows and whether the mesh is exact.
Table list_of_cases();

/// Columns one beside the other, the first two flush left, or the last one too.
std::string as_text(const Table& table);
std::string as_markdown(const Table& table);

}  // namespace evenmesh::gallery
