// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "evenmesh/report/report_page.h"

namespace evenmesh {

/// The part of the report that needs no script and can be printed: tables and pictures as HTML, to
/// stand in a <main>.
/// @param notes   in addition to those of the page
/// @param pictures  SVG as it stands
std::string static_page(const ReportPage& page, const std::vector<std::string>& notes,
                        const std::string& pictures);

/// Histogram, convergence of a run, and the mesh, as SVG to stand in HTML.
/// @param most_bytes  of the mesh's picture, which is made smaller until it fits, or left out
std::string report_pictures(const ReportPage& page, const ShownMesh& mesh, std::size_t most_bytes);

}  // namespace evenmesh
