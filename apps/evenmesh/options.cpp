// SPDX-License-Identifier: MIT
#include "apps/evenmesh/options.h"

#include "apps/evenmesh/config.h"

namespace evenmesh::app {

void add_input(CLI::App& app, InputArguments& input, bool required) {
  auto* path = app.add_option("IN", input.path, "the mesh file: OBJ or STL");
  if (required) path->required();
  add_analysis(app, input);
}

void add_analysis(CLI::App& app, InputArguments& input) {
  app.add_option("--feature-angle", input.feature_angle,
                 "edges with a greater dihedral angle are features, in degrees")
      ->capture_default_str();
  app.add_option("--weld", input.weld_tolerance,
                 "STL: corners at most this far apart are one vertex, in the file's unit")
      ->capture_default_str();
}

namespace {

// One phrase for every time the option is given.
void add_phrases(CLI::App& app, const std::string& name, std::vector<std::string>& phrases,
                 const std::string& what) {
  app.add_option(name, phrases, what)->allow_extra_args(false)->option_text("TEXT (repeatable)");
}

void add_constraints(CLI::App& app, ConstraintText& text) {
  app.add_option("--fix", text.fix,
                 "SEL: vertices that stay, no others; auto: what keeps the shape")
      ->capture_default_str();
  add_phrases(app, "--free", text.free, "SEL: without the defaults there");
  add_phrases(app, "--slide", text.slide,
              "'SEL on WHAT': line, plane, circle, cylinder, sphere (fitted, or with numbers as in "
              "plane:x=0), features, boundary, surface, surface=FILE");
  app.add_option(
      "--surface", text.surface,
      "a mesh whose faces the vertices slide on; corners stay, edges keep to their edges");
  add_phrases(app, "--symmetry", text.symmetry,
              "x=0 or px,py,pz,nx,ny,nz: vertices in this plane stay in it");
  add_phrases(app, "--periodic", text.periodic,
              "'A B': two planes or selectors; vertices of A and B move alike");
  app.add_option("--max-move", text.max_move,
                 "no vertex ends farther from where it was: D, or 0.2h times the edges around it");
  add_phrases(app, "--limit", text.limit, "'SEL max-move D': the same for some");
  app.add_option("--max-deviation", text.max_deviation,
                 "how far the result may be from the input's curves and surfaces: D, or 0.5% of "
                 "the box's diagonal (default for surfaces: 0.5%)");
  app.add_option("--min-area", text.min_area, "of every cell: A, or 0.2m times the mean");
  app.add_option("--min-volume", text.min_volume, "of every cell: V, or 0.2m times the mean");
  app.add_option("--min-jacobian", text.min_jacobian,
                 "of every corner, as a part of that of an ideal cell, between 0 and 1");
  add_phrases(app, "--keep", text.keep, "area or volume, 'area of GROUP'");
  add_phrases(app, "--equal-spacing", text.equal_spacing, "SEL: evenly along their curve");
  add_phrases(app, "--prescribe", text.prescribe,
              "'SEL = dx,dy,dz', 'SEL = file.csv' or another mesh: where vertices go");
}

}  // namespace

void add_smooth_options(CLI::App& app, SmoothArguments& smooth) {
  app.add_option("-o,--output", smooth.output, "the file to write");
  app.add_flag("--in-place", smooth.in_place, "replace the input file");
  app.add_option("--cost", smooth.costs,
                 "what to minimise: local, global, barycenter, shape with weights, as in "
                 "local=0.3,barycenter=0.3 (default: shape)")
      ->check([](const std::string& text) {
        return text.empty() ? "no cost given; leave the option out for the default" : "";
      });
  app.add_flag("--scale-free", smooth.scale_free,
               "count lengths relative to each cell's size: fine and coarse cells weigh the same");
  app.add_option("--global-length", smooth.global_length,
                 "edge length that the cost global pulls to (default: the mean of the input)");
  add_constraints(app, smooth.constraints);
  app.add_option("--method", smooth.method,
                 "lagrange_newton, which minimises the cost, or a classic smoother: laplacian, "
                 "smart_laplacian, combined, global_laplacian, lennard_jones, "
                 "lennard_jones_printed, pliant, angle_based, optimal_delaunay")
      ->capture_default_str();
  app.add_option("--solver", smooth.solver, "auto, multigrid, newton or dense")
      ->capture_default_str();
  app.add_option("--iterations", smooth.iterations, "stop after so many")->capture_default_str();
  app.add_option("--tolerance", smooth.tolerance,
                 "stop when the gradient has fallen to this part of its start")
      ->capture_default_str();
  app.add_option(
      "--eta", smooth.eta,
      "--solver dense: stop when eta (Eq. 12 of the paper) is below this, in the unit of "
      "the costs (default: from the tolerance)");
  app.add_option("--time-limit", smooth.time_limit, "stop iterating after so many seconds");
  app.add_option("--wall-layers", smooth.wall_layers,
                 "hold: stacks of flat quads, hexes or wedges on the boundary stay as they are; "
                 "smooth: they are cells like others")
      ->capture_default_str();
  app.add_option("--target", smooth.target,
                 "shape>=X: what every cell is to reach, X between 0 and 1; exit code 4 if one "
                 "does not");
  app.add_flag("--only-failing", smooth.only_failing,
               "move nothing but what is near cells that miss the --target in the input");
  app.add_option("--layers", smooth.layers,
                 "--only-failing: how many rings of vertices around such cells may move")
      ->capture_default_str();
  app.add_flag("--allow-worse", smooth.allow_worse,
               "let quality get worse where the cost asks for it; cells still never turn over");
  app.add_flag("--keep-partial", smooth.keep_partial, "on Ctrl-C write the best mesh so far");
  app.add_option("--json", smooth.json, "write a report in JSON to this file (-: to stdout)");
  add_html(app, smooth.html);
  app.add_option("--keep-iterates", smooth.keep_iterates,
                 "of small meshes, show positions at so many iterations in the report (0: none)")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--plot", smooth.plot,
                 "write pictures (SVG) of convergence, quality and the mesh into this folder");
  app.add_option("--config", smooth.config,
                 "options from a TOML file; those given here win over it");
  app.add_flag("--dry-run", smooth.dry_run,
               "print the constraints and options that would hold, as TOML, and write nothing");
}

void add_html(CLI::App& app, HtmlArguments& html) {
  app.add_option("--report", html.path, "write a report to look at in a browser (HTML)");
  add_html_size(app, html);
}

void add_html_size(CLI::App& app, HtmlArguments& html) {
  app.add_option("--report-max-mb", html.most_mb,
                 "how large that may get; of large meshes it shows less, and says so")
      ->check(CLI::Range(1.0, 1000.0))
      ->option_text("MB")
      ->capture_default_str();
}

void add_common(CLI::App& app, CommonArguments& common) {
  app.add_option("--threads", common.threads, "0: one per core; results do not depend on it")
      ->capture_default_str();
  app.add_flag("-q,--quiet", common.quiet, "say nothing but errors");
  app.add_flag("-v,--verbose", common.verbose, "say more");
}

std::vector<std::pair<std::string, std::string>> effective_options(const CLI::App& app) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = config_key(*option);
    if (name.empty()) continue;
    if (option->count() > 0) {
      result.emplace_back(name, to_toml(*option));
    } else if (!option->get_default_str().empty()) {
      const bool is_text = option->get_type_name() == "TEXT";
      const std::string value = option->get_default_str();
      result.emplace_back(name, is_text ? toml_string(value) : value);
    }
  }
  return result;
}

}  // namespace evenmesh::app
