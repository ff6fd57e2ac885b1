// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "evenmesh/report/report_page.h"
#include "evenmesh/report/shown_mesh.h"

namespace evenmesh {

/// A report as one HTML file that loads nothing else: what page says, as tables and pictures for
/// print, and the mesh before and after to be turned, zoomed and searched. Its policy lets only its
/// own script run. docs/html_report.md describes it.
/// @param most_bytes  of the file: what is left out of the mesh for that is said in it. Tables,
///                    pictures and the script stay, even if they alone are more.
std::string html_report(const ReportPage& page, const ShownMesh& mesh, std::size_t most_bytes);

}  // namespace evenmesh
