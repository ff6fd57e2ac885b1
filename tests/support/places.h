// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace evenmesh::testing {

/// The project's own sources: the folder with its README.
std::filesystem::path source_dir();

/// The small meshes that come with the project.
std::filesystem::path data_dir();

/// The folder with other people's meshes, which may not be there: where the environment's
/// EVENMESH_CORPUS_DIR says, or `shared/corpus` beside the project.
std::filesystem::path corpus_dir();

}  // namespace evenmesh::testing
