// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/figures.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/mesh/orientation.h"
#include "evenmesh/mesh/topology.h"

namespace evenmesh::gallery {
namespace {

constexpr std::uint64_t kShownSeed = 1;  // of exact meshes
constexpr std::uint64_t kTangledSeed = 4;

const std::vector<Plate>& plate_table() {
  static const std::vector<Plate> table{
      {Start::fig5, 5, 6, "A square of four triangles", true,
       "The centre is displaced by 0.4 of the side and has to come back."},
      {Start::fig7, 7, 8, "Four quads", true,
       "The centre is displaced by 0.4 of a cell's width. All four have to become squares."},
      {Start::fig9, 9, 11, "36 quads", true,
       "The 25 interior vertices are displaced by up to 0.4 of a cell's width in x and in y. All "
       "cells have to become squares."},
      {Start::fig12, 12, 16, "Triangles in a teardrop", false,
       "The paper takes a scanned part; here are 176 irregular triangles in an outline like it."},
      {Start::fig17, 17, 21, "A block of quads", false,
       "14 x 10 quads with wavy sides, the vertices inside displaced at random."},
      {Start::fig22, 22, 27, "A trapezoid and half an annulus", false,
       "Two blocks of quads as in Branets and Carey (2005). The exterior boundary is fixed; all "
       "other vertices, those between the blocks included, move in the plane."},
      {Start::fig28, 28, 31, "Quads and triangles on a curved sheet", false,
       "A part of a sphere. The paper does not say what holds the vertices: in the row 'paper's "
       "method' those on the boundary are fixed and the others free in space, in the other rows "
       "these slide on the sphere."},
  };
  return table;
}

std::vector<CostChoice> local(double weight = 1.0) { return {{"local", weight}}; }
std::vector<CostChoice> global(double weight = 1.0) { return {{"global", weight}}; }
std::vector<CostChoice> with_barycenter(std::vector<CostChoice> costs, double weight) {
  costs.push_back({"barycenter", weight});
  return costs;
}

const std::vector<Case>& case_table() {
  static const std::vector<Case> table{
      {.id = "fig5b",
       .figures = {5, 6},
       .start = Start::fig5,
       .title = "local",
       .setup = {local()},
       .paper_iterations = 5,
       .eps = 1e-5},
      {.id = "fig5c",
       .figures = {5, 6},
       .start = Start::fig5,
       .title = "global",
       .setup = {global()},
       .paper_iterations = 4,
       .eps = 1e-5},
      {.id = "fig7b",
       .figures = {7, 8},
       .start = Start::fig7,
       .title = "local",
       .setup = {local()},
       .paper_iterations = 4,
       .eps = 1e-5},
      {.id = "fig7c",
       .figures = {7, 8},
       .start = Start::fig7,
       .title = "global",
       .setup = {global()},
       .paper_iterations = 3,
       .eps = 1e-5},
      {.id = "fig10a",
       .figures = {9, 10, 11},
       .start = Start::fig9,
       .title = "local",
       .setup = {local()},
       .paper_iterations = 30,
       .eps = 1e-8},
      {.id = "fig10b",
       .figures = {9, 10, 11},
       .start = Start::fig9,
       .title = "global",
       .setup = {global()},
       .paper_iterations = 30,
       .eps = 1e-8},

      {.id = "fig13a",
       .figures = {13, 14},
       .start = Start::fig12,
       .title = "local, boundary free",
       .setup = {local(), Held::nothing},
       .paper_iterations = 50,
       .unique = false,
       .lesson =
           "Scaled by s, the mesh costs s^2 as much: nothing keeps it from shrinking to a point. "
           "The paper calls the result 'not very useful'. Validity keeps triangles positive but "
           "only stops the collapse where they are as small as it allows.",
       .cure = {{{"local", 0.5}, {"global", 0.5}}, Held::nothing},
       .cure_words = "some global keeps the size"},
      {.id = "fig13b",
       .figures = {13, 14},
       .start = Start::fig12,
       .title = "global, boundary free",
       .setup = {global(), Held::nothing},
       .paper_iterations = 50,
       .lesson =
           "The constant length keeps the size, though not the outline; but edge lengths do not "
           "see that triangles are turned over."},
      {.id = "fig15a",
       .figures = {15, 16},
       .start = Start::fig12,
       .title = "local, boundary fixed",
       .setup = {local()},
       .paper_iterations = 30},
      {.id = "fig15b",
       .figures = {15, 16},
       .start = Start::fig12,
       .title = "global, boundary fixed",
       .setup = {global()},
       .paper_iterations = 50,
       .paper_words = "50 in the text, 30 under the figure",
       .unique = false,
       .lesson =
           "Edge lengths cannot see that a triangle is turned over. Where the common length is "
           "longer than there is room for, they escape by folding; validity forbids it."},
      {.id = "fig12t",
       .figures = {12},
       .start = Start::fig12,
       .tangled = true,
       .title = "local, from a tangled start",
       .setup = {local()},
       .lesson =
           "Not in the paper: the vertices inside are displaced by up to a whole edge. Without "
           "validity the method stops in a folded minimum; with it, it untangles and comes to "
           "the same minimum as Fig. 15a."},

      {.id = "fig18a",
       .figures = {18, 19},
       .start = Start::fig17,
       .title = "local, boundary free",
       .setup = {local(), Held::nothing},
       .paper_iterations = 70,
       .unique = false,
       .lesson = "Nothing keeps the size here either, and edge lengths alone let quads shear at no "
                 "cost: f comes to 0 with cells that are rhombs, or folded.",
       .cure = {with_barycenter(local(0.5), 0.5), Held::nothing, false, true},
       .cure_words = "barycenter against shear, and the total area is kept"},
      {.id = "fig18b",
       .figures = {18, 19},
       .start = Start::fig17,
       .title = "global, boundary free",
       .setup = {global(), Held::nothing},
       .paper_iterations = 70,
       .unique = false,
       .lesson = "All edges get the same length, but rhombs have that too, and folded ones.",
       .cure = {with_barycenter(global(0.5), 0.5), Held::nothing},
       .cure_words = "barycenter against shear"},
      {.id = "fig20a",
       .figures = {20, 21},
       .start = Start::fig17,
       .title = "local, boundary fixed",
       .setup = {local()},
       .paper_iterations = 60,
       .unique = false,
       .lesson = "Edge lengths alone have no shear stiffness on quads, which fold.",
       .cure = {with_barycenter(local(0.3), 0.3)},
       .cure_words = "barycenter against shear"},
      {.id = "fig20b",
       .figures = {20, 21},
       .start = Start::fig17,
       .title = "global, boundary fixed",
       .setup = {global()},
       .paper_iterations = 250,
       .unique = false,
       .lesson =
           "As before; and the mean edge length of a disturbed mesh is longer than it has room "
           "for, so that it buckles.",
       .cure = {with_barycenter(global(0.7), 0.3)},
       .cure_words = "barycenter against shear and buckling"},
      {.id = "fig17t",
       .figures = {17},
       .start = Start::fig17,
       .tangled = true,
       .title = "local and barycenter, from a tangled start",
       .setup = {with_barycenter(local(0.3), 0.3)},
       .lesson = "Not in the paper: the vertices inside are displaced by up to a whole edge. With "
                 "validity it comes to the same minimum as the cure of Fig. 20a."},

      {.id = "fig22b",
       .figures = {22, 23},
       .start = Start::fig22,
       .title = "local and barycenter",
       .setup = {with_barycenter(local(0.3), 0.3)},
       .paper_iterations = 150},
      {.id = "fig24a",
       .figures = {24, 25},
       .start = Start::fig22,
       .title = "global and barycenter",
       .setup = {with_barycenter(global(0.3), 0.7)},
       .paper_iterations = 200,
       .paper_words = "200 in the text, 350 under the figure"},
      {.id = "fig24b",
       .figures = {24, 25},
       .start = Start::fig22,
       .title = "local and barycenter",
       .setup = {with_barycenter(local(0.3), 0.3)},
       .paper_iterations = 350,
       .paper_words = "350 in the text, 200 under the figure",
       .lesson = "The same mesh, costs and weights as in Fig. 22b, for which the paper gives 150."},
      {.id = "fig26a",
       .figures = {26, 27},
       .start = Start::fig22,
       .title = "global and barycenter",
       .setup = {with_barycenter(global(0.7), 0.3)},
       .paper_iterations = 200},
      {.id = "fig26b",
       .figures = {26, 27},
       .start = Start::fig22,
       .title = "global, local and barycenter",
       .setup = {{{"global", 0.3}, {"local", 0.3}, {"barycenter", 0.3}}},
       .paper_iterations = 70},

      {.id = "fig29",
       .figures = {29, 31},
       .start = Start::fig28,
       .title = "local and barycenter",
       .setup = {with_barycenter(local(0.6), 0.4)},
       .paper_iterations = 30},
      {.id = "fig30",
       .figures = {30, 31},
       .start = Start::fig28,
       .title = "global and barycenter",
       .setup = {with_barycenter(global(0.6), 0.4)},
       .paper_iterations = 30,
       .paper_words = "the text says 'global and local', with the weight of barycenter"},
  };
  return table;
}

std::string_view start_name(Start start) {
  constexpr std::array<std::string_view, 7> kNames{"fig5",  "fig7",  "fig9", "fig12",
                                                   "fig17", "fig22", "fig28"};
  return kNames[static_cast<std::size_t>(start)];
}

// The number in "fig14"; 0 if it is something else.
int figure_number(std::string_view word) {
  if (!word.starts_with("fig")) return 0;
  int number = 0;
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data() + 3, end, number);
  return error == std::errc() && stopped == end ? number : 0;
}

// How many letters must change to get from one word to the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

std::string nearest(std::string_view word) {
  if (const int number = figure_number(word); number > 0) {
    return fmt::format("fig{}", std::clamp(number, plate_table().front().first_figure,
                                           plate_table().back().last_figure));
  }
  std::vector<std::string> known;
  for (const Plate& plate : plate_table()) {
    for (int n = plate.first_figure; n <= plate.last_figure; ++n) {
      known.push_back(fmt::format("fig{}", n));
    }
  }
  for (const Case& each : case_table()) known.emplace_back(each.id);
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return distance(word, a) < distance(word, b);
  });
}

}  // namespace

std::span<const Plate> plates() { return plate_table(); }
std::span<const Case> cases() { return case_table(); }

const Plate& plate_of(Start start) {
  return *std::find_if(plates().begin(), plates().end(),
                       [&](const Plate& plate) { return plate.start == start; });
}

KnownMesh known_mesh(Start start, std::uint64_t seed) {
  assert(plate_of(start).exact);
  if (start == Start::fig5) return four_triangles(seed);
  return start == Start::fig7 ? four_quads(seed) : square_of_quads(seed);
}

Mesh start_mesh(const Case& of) {
  constexpr double kTeardropEdge = 0.25;
  Mesh mesh;
  double edge = 1.0;
  switch (of.start) {
    case Start::fig5:
    case Start::fig7:
    case Start::fig9:
      return known_mesh(of.start, kShownSeed).start;
    case Start::fig12:
      mesh = teardrop();
      edge = kTeardropEdge;
      break;
    case Start::fig17:
      mesh = quad_block();
      break;
    case Start::fig22:
      mesh = trapezoid_and_annulus();
      break;
    case Start::fig28:
      mesh = curved_sheet();
      break;
  }
  if (!of.tangled) return mesh;
  return tangled(mesh, find_topology(mesh, find_orientation(mesh)).boundary, edge, kTangledSeed);
}

std::vector<Vec3> known_optimum(const Case& of) {
  return plate_of(of.start).exact ? known_mesh(of.start, kShownSeed).optimum : std::vector<Vec3>();
}

std::vector<const Case*> find_cases(std::string_view word) {
  const int number = figure_number(word);
  const auto shown_by = [&](const Case& each) {
    return word == "all" || word == each.id || word == start_name(each.start) ||
           std::find(each.figures.begin(), each.figures.end(), number) != each.figures.end();
  };
  std::vector<const Case*> found;
  for (const Case& each : case_table()) {
    if (shown_by(each)) found.push_back(&each);
  }
  if (!found.empty()) return found;
  throw InvalidOption(fmt::format("there is no figure '{}'; did you mean {}? 'demo list' has all",
                                  word, nearest(word)));
}

std::string cost_words(const Setup& setup) {
  std::string words;
  for (const CostChoice& cost : setup.costs) {
    if (!words.empty()) words += " + ";
    words += cost.weight == 1.0 ? cost.name : fmt::format("{} {}", cost.weight, cost.name);
  }
  return words;
}

}  // namespace evenmesh::gallery
