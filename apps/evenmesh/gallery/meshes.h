// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "evenmesh/base/vec3.h"
#include "evenmesh/mesh/mesh.h"

/// The start meshes of Kulovec, Kos and Duhovnik (2011), Figs. 5 to 31. Figs. 5, 7 and 9 are known
/// exactly; of the others the paper shows pictures only, and these are look-alikes. All are made in
/// code, and the same seed gives the same mesh everywhere.
namespace evenmesh::gallery {

/// A mesh disturbed, and where its vertices belong.
struct KnownMesh {
  Mesh start;
  std::vector<Vec3> optimum;  // per vertex
};

/// Fig. 5: the unit square, split into four triangles that meet in the centre, vertex 4, which is
/// displaced by 0.4 in a random direction.
KnownMesh four_triangles(std::uint64_t seed);

/// Fig. 7: 2 x 2 quads on the unit square whose centre is displaced by 0.4 of a cell's width.
KnownMesh four_quads(std::uint64_t seed);

/// Fig. 9: 6 x 6 quads on the unit square whose interior vertices are displaced by up to 0.4 of a
/// cell's width in x and in y.
KnownMesh square_of_quads(std::uint64_t seed);

/// Fig. 12: irregular triangles that fill the outline of a teardrop, 3.6 long and 2 high, its tip
/// on the right; boundary vertices first.
Mesh teardrop();

/// Fig. 17: a block of 14 x 10 quads with wavy sides, unevenly spaced along them, the vertices
/// inside displaced.
Mesh quad_block();

/// Fig. 22: two blocks of quads, a trapezoid that narrows towards half an annulus, as in Branets
/// and Carey (2005). Lines of the grid have a kink where the blocks meet.
Mesh trapezoid_and_annulus();

/// Fig. 28: a curved sheet of quads in space, those along its boundary cut into triangles; a part
/// of a sphere of radius kSheetRadius around the origin, the vertices inside displaced along it.
Mesh curved_sheet();
inline constexpr double kSheetRadius = 1.8;

/// A mesh tangled: vertices that are not fixed displaced by up to `size` in x and in y.
Mesh tangled(const Mesh& mesh, const std::vector<char>& fixed, double size, std::uint64_t seed);

}  // namespace evenmesh::gallery
