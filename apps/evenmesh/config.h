// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace evenmesh::app {

/// Gives the options of a program that the command line left out the values they have in a TOML
/// file.
///
/// Keys are the names of the options, with dashes or underscores; options that may be repeated take
/// arrays, and `cost` also a table of weights ([cost] local = 0.3).
/// @throws InvalidOption  the file is no TOML, has a key that no option has, or a value of the
/// wrong
///                        type; the message starts with file:line:column
/// @throws IoError        the file cannot be read
void read_config(const std::string& path, CLI::App& app);

/// The key of an option in a configuration file; empty if it has none (--help, --config).
std::string config_key(const CLI::Option& option);

/// The value of an option that was given, in TOML.
std::string to_toml(const CLI::Option& option);

/// A string of TOML with these characters.
std::string toml_string(std::string_view text);

}  // namespace evenmesh::app
