// SPDX-License-Identifier: MIT
#include "evenmesh/classic/relaxation.h"

#include <cassert>
#include <utility>

#include <fmt/core.h>

#include "evenmesh/base/error.h"
#include "evenmesh/classic/angle_based.h"
#include "evenmesh/classic/climb.h"
#include "evenmesh/classic/diffusion.h"
#include "evenmesh/classic/gauss_seidel.h"
#include "evenmesh/classic/laplacian.h"
#include "evenmesh/classic/optimal_delaunay.h"

namespace evenmesh {
namespace {

constexpr int kClimbs = 4;  // the climb and its halves

bool treats(Method method, CellKind kind) {
  if (method == Method::angle_based) return kind == CellKind::triangle;
  if (method == Method::optimal_delaunay) {
    return kind == CellKind::triangle || kind == CellKind::tet;
  }
  return true;
}

std::string_view what_it_treats(Method method) {
  return method == Method::angle_based ? "triangles" : "triangles and tets";
}

GaussSeidel::Steps steps(Method method, const RelaxationSetting& in) {
  GaussSeidel::Steps steps;
  const auto add = [&](std::unique_ptr<Rule> rule, int attempts = 1) {
    steps.push_back({std::move(rule), attempts});
  };
  switch (method) {
    case Method::laplacian:
    case Method::smart_laplacian:
      add(std::make_unique<Laplacian>());
      break;
    case Method::combined:
      add(std::make_unique<Laplacian>());
      add(std::make_unique<Climb>(in.mesh, in.orientation), kClimbs);
      break;
    case Method::lennard_jones:
      add(std::make_unique<Diffusion>(Force::lennard_jones, in.length));
      break;
    case Method::lennard_jones_printed:
      add(std::make_unique<Diffusion>(Force::lennard_jones_printed, in.length));
      break;
    case Method::pliant:
      add(std::make_unique<Diffusion>(Force::pliant, in.length));
      break;
    case Method::angle_based:
      add(std::make_unique<AngleBased>(in.mesh, in.orientation));
      break;
    case Method::optimal_delaunay:
      add(std::make_unique<OptimalDelaunay>(in.mesh, in.orientation));
      break;
    case Method::lagrange_newton:
    case Method::global_laplacian:
      assert(false);
      break;
  }
  return steps;
}

}  // namespace

void check_cells(Method method, const Cells& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (treats(method, cells.kind(c))) continue;
    throw InvalidOption(
        fmt::format("the method {} is for {}, and cell {} is a {}; choose another method, such as "
                    "smart_laplacian",
                    name(method), what_it_treats(method), c, traits(cells.kind(c)).name));
  }
}

std::unique_ptr<Relaxation> make_relaxation(Method method, const RelaxationSetting& setting) {
  check_cells(method, setting.mesh.cells());
  const bool judged = method == Method::smart_laplacian || method == Method::combined;
  return std::make_unique<GaussSeidel>(setting, steps(method, setting),
                                       judged ? Accept::unless_worst_gets_worse : Accept::all);
}

}  // namespace evenmesh
