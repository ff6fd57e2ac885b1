// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/evenmesh/gallery/meshes.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/problem/problem.h"

/// What the figures of Kulovec, Kos and Duhovnik (2011) show, as a table.
namespace evenmesh::gallery {

/// The start meshes, by the figure that shows them.
enum class Start : std::uint8_t { fig5, fig7, fig9, fig12, fig17, fig22, fig28 };

/// What keeps vertices where they are.
enum class Held : std::uint8_t {
  boundary,  // boundary vertices are fixed, the others free, in space too
  nothing,   // all are free
  sheet      // boundary vertices are fixed, the others slide on the sheet of Fig. 28
};

/// What is minimised, and under which constraints.
struct Setup {
  std::vector<CostChoice> costs;
  Held held = Held::boundary;
  bool scale_free = false;
  bool keep_area = false;
};

/// One of the paper's optimisations.
struct Case {
  std::string_view id;       // "fig13a": the figure with the result
  std::vector<int> figures;  // all that belong to it, result and convergence
  Start start = Start::fig5;
  bool tangled = false;  // starts from the mesh tangled
  std::string_view title;
  Setup setup;
  int paper_iterations = 0;           // 0: the paper has no such case
  std::string_view paper_words = {};  // where what it says about these differs; or empty
  double eps = 1e-6;                  // of the paper's stop criterion (12), which it does not give
  /// Constraints as they are, one minimum: every solver must find it.
  bool unique = true;
  /// What this case teaches: where the formulation folds or collapses, and why. Or empty.
  std::string_view lesson = {};
  /// What to ask for instead where that is not the costs' own minimum; no costs: nothing.
  Setup cure = {};
  std::string_view cure_words = {};
};

/// A start mesh and the figures around it.
struct Plate {
  Start start = Start::fig5;
  int first_figure = 0;
  int last_figure = 0;
  std::string_view title;
  bool exact = false;  // the paper's own mesh; else a look-alike
  std::string_view words;
};

std::span<const Plate> plates();
std::span<const Case> cases();
const Plate& plate_of(Start start);

/// The mesh a case starts from. Of the exact ones the one with seed 1.
Mesh start_mesh(const Case& of);
/// Where its vertices belong; empty where that is not known.
std::vector<Vec3> known_optimum(const Case& of);
/// A mesh whose optimum is known, disturbed with a seed.
/// @pre  its plate is exact
KnownMesh known_mesh(Start start, std::uint64_t seed);

/// The cases that a word asks for: "fig13a" that one, "fig13" and "fig14" both that these figures
/// show, "fig12" all that start from its mesh, "all" every one.
/// @throws InvalidOption  there is no such figure; the message has the nearest that there is
std::vector<const Case*> find_cases(std::string_view word);

/// "0.3 local + 0.7 barycenter".
std::string cost_words(const Setup& setup);

}  // namespace evenmesh::gallery
