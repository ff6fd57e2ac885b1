// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/evenmesh/commands.h"

namespace evenmesh::app {

/// What all verbs have.
struct CommonArguments {
  int threads = 0;
  bool quiet = false;
  bool verbose = false;
};

void add_input(CLI::App& app, InputArguments& input, bool required);
/// What of these is not the file.
void add_analysis(CLI::App& app, InputArguments& input);
void add_smooth_options(CLI::App& app, SmoothArguments& smooth);
/// --report and what belongs to it.
void add_html(CLI::App& app, HtmlArguments& html);
void add_html_size(CLI::App& app, HtmlArguments& html);
void add_common(CLI::App& app, CommonArguments& common);

/// The options that are given or have a default, by their name in a configuration file, with their
/// value in TOML.
std::vector<std::pair<std::string, std::string>> effective_options(const CLI::App& app);

}  // namespace evenmesh::app
