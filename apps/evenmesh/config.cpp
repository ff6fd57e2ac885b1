// SPDX-License-Identifier: MIT
#include "apps/evenmesh/config.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <vector>

#include <fmt/core.h>
#include <toml++/toml.h>

#include "evenmesh/base/error.h"
#include "evenmesh/base/text.h"

namespace evenmesh::app {
namespace {

// What an option takes.
enum class Takes { truth, integer, number, text, measure, list };

// Numbers that may have a unit are text to the parser of the command line.
constexpr std::array<std::string_view, 5> kMeasures = {"max-move", "max-deviation", "min-area",
                                                       "min-volume", "min-jacobian"};

Takes takes(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::string name = option.get_name(false, false).substr(2);
  if (option.get_items_expected_max() == 0) return Takes::truth;
  if (option.get_items_expected_max() > 1) return Takes::list;
  if (type == "INT") return Takes::integer;
  if (type == "FLOAT") return Takes::number;
  const bool measure = std::find(kMeasures.begin(), kMeasures.end(), name) != kMeasures.end();
  return measure ? Takes::measure : Takes::text;
}

std::string_view expected(Takes takes) {
  constexpr std::string_view kWords[] = {
      "true or false", "a whole number",       "a number",
      "a string",      "a number or a string", "a string or an array of strings"};
  return kWords[static_cast<int>(takes)];
}

// A number as the command line has it.
std::string number(const toml::node& node) {
  return node.is_integer() ? std::to_string(node.as_integer()->get())
                           : fmt::format("{}", node.as_floating_point()->get());
}

// The values of one key in the order of the command line; none where the type is wrong.
std::vector<std::string> values(const toml::node& node, Takes takes) {
  const bool is_number = node.is_integer() || node.is_floating_point();
  switch (takes) {
    case Takes::truth:
      if (const auto* truth = node.as_boolean()) return {truth->get() ? "true" : "false"};
      return {};
    case Takes::integer:
      return node.is_integer() ? std::vector{number(node)} : std::vector<std::string>{};
    case Takes::number:
      return is_number ? std::vector{number(node)} : std::vector<std::string>{};
    case Takes::measure:
      if (is_number) return {number(node)};
      break;
    case Takes::list:
      if (const toml::array* array = node.as_array()) {
        std::vector<std::string> all;
        for (const toml::node& item : *array) {
          if (!item.is_string()) return {};
          all.push_back(item.as_string()->get());
        }
        return all;
      }
      break;
    case Takes::text:
      break;
  }
  if (const auto* text = node.as_string()) return {text->get()};
  return {};
}

// [cost] local = 0.3, barycenter = 0.3
std::vector<std::string> weights(const toml::table& table) {
  std::string text;
  for (const auto& [key, node] : table) {
    if (!node.is_integer() && !node.is_floating_point()) return {};
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", key.str(), number(node));
  }
  return {text};
}

class Config {
 public:
  Config(std::string path, CLI::App& app) : path_(std::move(path)), app_(app) {}

  void read() const {
    std::ifstream file(path_, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) throw IoError(path_ + ": cannot be read");
    toml::table table;
    try {
      table = toml::parse(text, path_);
    } catch (const toml::parse_error& error) {
      throw InvalidOption(fmt::format("{}{}", place(error.source()), error.description()));
    }
    for (const auto& [key, node] : table) take(key, node);
  }

 private:
  std::string place(const toml::source_region& source) const {
    return fmt::format("{}:{}:{}: ", path_, source.begin.line, source.begin.column);
  }

  CLI::Option* find(std::string_view key) const {
    std::string name(key);
    std::replace(name.begin(), name.end(), '_', '-');
    CLI::Option* option = app_.get_option_no_throw("--" + name);
    return option != nullptr && !config_key(*option).empty() ? option : nullptr;
  }

  std::string known(std::string_view key) const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app_.get_options()) {
      const std::string name = config_key(*option);
      if (!name.empty()) names.push_back(name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return suggestion(key, views);
  }

  void take(const toml::key& key, const toml::node& node) const {
    CLI::Option* option = find(key.str());
    if (option == nullptr) {
      throw InvalidOption(fmt::format("{}there is no option '{}'{}", place(key.source()),
                                      shown(key.str()), known(key.str())));
    }
    const Takes kind = takes(*option);
    const bool is_weights = node.is_table() && config_key(*option) == "cost";
    const std::vector<std::string> given =
        is_weights ? weights(*node.as_table()) : values(node, kind);
    if (given.empty() && !(node.is_array() && node.as_array()->empty())) {
      throw InvalidOption(
          fmt::format("{}{} takes {}{}", place(node.source()), key.str(), expected(kind),
                      config_key(*option) == "cost" ? " or a table of weights" : ""));
    }
    if (option->count() > 0) return;  // the command line wins
    try {
      for (const std::string& value : given) option->add_result(value);
      if (!given.empty()) option->run_callback();
    } catch (const CLI::ParseError& error) {
      throw InvalidOption(place(node.source()) + error.what());
    }
  }

  std::string path_;
  CLI::App& app_;
};

}  // namespace

void read_config(const std::string& path, CLI::App& app) { Config(path, app).read(); }

std::string config_key(const CLI::Option& option) {
  const std::string name = option.get_name(false, false);
  for (const std::string_view none : {"--help", "--version", "--config", "--dry-run"}) {
    if (name == none) return "";
  }
  return name.starts_with("--") ? name.substr(2) : "";
}

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string to_toml(const CLI::Option& option) {
  const std::vector<std::string> results = option.reduced_results();
  switch (takes(option)) {
    case Takes::truth:
    case Takes::integer:
    case Takes::number:
      return results.back();
    case Takes::text:
    case Takes::measure:
      return toml_string(results.back());
    case Takes::list:
      break;
  }
  std::string list;
  for (const std::string& result : results)
    list += (list.empty() ? "" : ", ") + toml_string(result);
  return "[" + list + "]";
}

}  // namespace evenmesh::app
