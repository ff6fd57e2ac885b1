// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "apps/evenmesh/console.h"
#include "apps/evenmesh/loading.h"
#include "evenmesh/problem/constraint_text.h"

namespace evenmesh::app {

/// A report in HTML.
struct HtmlArguments {
  std::string path;      // empty: none
  double most_mb = 8.0;  // of the file, 10^6 bytes
};

struct SmoothArguments {
  InputArguments input;
  std::string output;
  bool in_place = false;
  std::string costs;  // "local=0.3,barycenter=0.3"; empty: chosen by kind of cell
  bool scale_free = false;
  double global_length = 0.0;
  ConstraintText constraints;
  std::string method = "lagrange_newton";
  std::string solver = "auto";
  int iterations = 200;
  double tolerance = 1e-6;
  double eta = 0.0;
  double time_limit = 0.0;
  int threads = 0;
  bool allow_worse = false;
  std::string wall_layers = "hold";
  std::string target;  // "shape>=0.3"
  bool only_failing = false;
  int layers = 2;  // of vertices around failing cells that may move
  bool keep_partial = false;
  std::string json;  // empty: none; "-": stdout
  HtmlArguments html;
  int keep_iterates = 0;  // of these the report in HTML has the positions
  std::string plot;       // a folder for pictures; empty: none
  std::string config;     // a TOML file; empty: none
  bool dry_run = false;
  std::string command;  // the whole command line
  /// What holds in the end, from the command line, a file or by default: names and values in TOML.
  std::vector<std::pair<std::string, std::string>> effective;
};

/// Smooths a file. Returns an exit code; throws Error for what is wrong with input or options.
/// @param interrupted  asked after every iteration
int smooth_command(const SmoothArguments& arguments, Console& console,
                   const std::function<bool()>& interrupted);

struct CheckArguments {
  InputArguments input;
  HtmlArguments html;
  int threads = 0;
  std::string command;  // the whole command line
};

/// Measures a file: quality table and worst cells. kBelowTarget if a cell is inverted or has no
/// size.
int check_command(const CheckArguments& arguments, const Console& console);

struct CompareArguments {
  InputArguments before;
  std::string after;
  HtmlArguments html;
  int threads = 0;
  std::string command;  // the whole command line
};

/// Writes a report on two files with the same cells.
/// @throws InvalidOption  their cells are not the same
int compare_command(const CompareArguments& arguments, const Console& console);

/// Says what is in a file.
int info_command(const InputArguments& arguments, const Console& console);

struct DemoArguments {
  std::vector<std::string> figures;  // "fig13a", "fig13", "all", "list"; none: the known optima
  std::string folder;                // for pictures; empty: none
};

/// Repeats figures of the paper, and writes pictures of what comes out; of all of them a page, too.
int demo_command(const DemoArguments& arguments, const Console& console);

}  // namespace evenmesh::app
