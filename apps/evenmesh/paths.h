// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/evenmesh/commands.h"

namespace evenmesh::app {

/// Where the result goes; empty for a dry run that names nothing.
/// @throws InvalidOption  it is named nowhere or twice, it is the input without --in-place, or a
///                        dry run is to write a report
std::string output_path(const SmoothArguments& arguments);

/// Finds out before the work whether a report can be written.
/// @param json  where it goes; empty and "-" (stdout) are always right
/// @throws InvalidOption  that is the input or the output
/// @throws IoError        its folder is not there, or it may not be written
void check_report_path(const std::string& json, const std::string& input,
                       const std::string& output);

}  // namespace evenmesh::app
