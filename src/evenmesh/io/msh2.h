// SPDX-License-Identifier: MIT
#pragma once

#include "evenmesh/io/msh_content.h"
#include "evenmesh/io/msh_scanner.h"

namespace evenmesh {

/// Read what stands in $Nodes and $Elements of a Gmsh file of version 2, text or binary.
/// @throws IoError  see read_mesh()
void read_msh2_nodes(MshScanner& scanner, MshContent& content);
void read_msh2_elements(MshScanner& scanner, MshContent& content);

}  // namespace evenmesh
