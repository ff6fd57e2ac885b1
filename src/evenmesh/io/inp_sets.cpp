// SPDX-License-Identifier: MIT
#include "evenmesh/io/inp_sets.h"

#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "evenmesh/io/deck_lines.h"

namespace evenmesh {
namespace {

std::string key_of(InpSets::Kind kind, std::size_t scope, std::string_view name) {
  return fmt::format("{} {} {}", static_cast<int>(kind), scope, in_capitals(name));
}

std::size_t found_or_zero(const std::map<std::string, std::size_t>& map, std::string_view name) {
  const auto at = map.find(in_capitals(name));
  return at == map.end() ? 0 : at->second;
}

}  // namespace

std::size_t InpSets::add_scope(std::string name) {
  parts_.emplace(in_capitals(name), scopes_.size());
  scopes_.push_back({.name = std::move(name)});
  return scopes_.size() - 1;
}

void InpSets::add_instance(const std::string& instance, const std::string& part) {
  instances_[in_capitals(instance)] = scope_of_part(part);
}

std::size_t InpSets::scope_of_part(std::string_view part) const {
  return found_or_zero(parts_, part);
}

std::size_t InpSets::scope_of_instance(std::string_view instance) const {
  return found_or_zero(instances_, instance);
}

std::size_t InpSets::set(Kind kind, std::size_t scope, const std::string& name) {
  const auto [at, is_new] = numbers_.emplace(key_of(kind, scope, name), sets_.size());
  if (is_new) sets_.push_back({.kind = kind, .scope = scope, .name = name});
  return at->second;
}

std::optional<std::size_t> InpSets::find(Kind kind, std::size_t scope,
                                         std::string_view name) const {
  const auto at = numbers_.find(key_of(kind, scope, name));
  if (at == numbers_.end()) return std::nullopt;
  return at->second;
}

std::optional<std::size_t> InpSets::find_anywhere(Kind kind, std::size_t scope,
                                                  std::string_view name) const {
  if (const auto found = find(kind, scope, name)) return found;
  if (const auto found = find(kind, 0, name)) return found;
  std::optional<std::size_t> only;
  for (std::size_t s = 1; s < scopes_.size(); ++s) {
    const auto found = find(kind, s, name);
    if (found && only) return std::nullopt;
    if (found) only = found;
  }
  return only;
}

void InpSets::add_range(std::size_t set, std::size_t scope, const NumberRange& range) {
  std::vector<Piece>& pieces = sets_[set].pieces;
  const bool goes_on = !pieces.empty() && pieces.back().scope == scope && range.step == 1 &&
                       pieces.back().range.step == 1 && range.first == pieces.back().range.last + 1;
  if (goes_on) {
    pieces.back().range.last = range.last;
  } else {
    pieces.push_back({scope, range});
  }
}

void InpSets::add_set(std::size_t set, std::size_t other) {
  if (set != other) sets_[set].others.push_back(other);
}

void InpSets::Members::add(Index member) {
  if (member == NodeNumbers::kNone) return;  // an element that is no cell
  if (member >= taken.size()) taken.resize(std::size_t{member} + 1 + taken.size(), 0);
  if (taken[member]) return;
  taken[member] = 1;
  list.push_back(member);
}

void InpSets::collect(const Piece& piece, Kind kind, Members& members) const {
  const Scope& scope = scopes_[piece.scope];
  const bool of_nodes = kind == Kind::nodes;
  const std::vector<std::uint64_t>& numbers = of_nodes ? scope.nodes : scope.elements;
  const std::vector<Index>& meant = of_nodes ? scope.vertices : scope.cells;
  const NodeNumbers& index = of_nodes ? scope.node_numbers : scope.element_numbers;
  const NumberRange& range = piece.range;
  if ((range.last - range.first) / range.step > numbers.size()) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const bool in = numbers[i] >= range.first && numbers[i] <= range.last &&
                      (numbers[i] - range.first) % range.step == 0;
      if (in) members.add(meant[i]);
    }
    return;
  }
  for (std::uint64_t number = range.first; number <= range.last; number += range.step) {
    const Index place = index.find(number);
    if (place != NodeNumbers::kNone) members.add(meant[place]);
  }
}

std::vector<Index> InpSets::collect(std::size_t set, Kind kind) const {
  std::vector<char> seen(sets_.size(), 0);
  Members members;
  std::vector<std::size_t> waiting = {set};
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    if (seen[at]) continue;
    seen[at] = 1;
    if (sets_[at].kind == kind) {
      for (const Piece& piece : sets_[at].pieces) collect(piece, kind, members);
    }
    waiting.insert(waiting.end(), sets_[at].others.begin(), sets_[at].others.end());
  }
  return std::move(members.list);
}

std::vector<Index> InpSets::members(std::size_t set) const { return collect(set, sets_[set].kind); }

std::vector<Index> InpSets::vertices(std::size_t set, const Cells& cells) const {
  std::vector<Index> result = collect(set, Kind::nodes);
  for (const Index cell : collect(set, Kind::elements)) {
    const auto corners = cells.vertices(cell);
    result.insert(result.end(), corners.begin(), corners.end());
  }
  return result;
}

std::vector<Index> InpSets::vertices_of(std::string_view word, std::size_t scope,
                                        const Cells& cells) const {
  const std::size_t dot = word.rfind('.');
  if (dot != std::string_view::npos) {
    scope = scope_of_instance(word.substr(0, dot));
    word.remove_prefix(dot + 1);
  }
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc() && stop == word.data() + word.size()) {
    const auto vertex_in = [this, number](const Scope& in) {
      const Index place = in.node_numbers.find(number);
      return place == NodeNumbers::kNone ? std::vector<Index>() : std::vector{in.vertices[place]};
    };
    const std::vector<Index> found = vertex_in(scopes_[scope]);
    // Some programs write loads behind the only part as if its numbers were the model's.
    if (found.empty() && scope == 0 && scopes_.size() == 2) return vertex_in(scopes_[1]);
    return found;
  }
  const auto set = find_anywhere(Kind::nodes, scope, word);
  return set ? vertices(*set, cells) : std::vector<Index>();
}

std::size_t InpSets::listed(const Set& set) const {
  std::size_t count = 0;
  for (const Piece& piece : set.pieces) {
    const std::uint64_t numbers = (piece.range.last - piece.range.first) / piece.range.step + 1;
    const Scope& scope = scopes_[piece.scope];
    count += std::min<std::uint64_t>(
        numbers, set.kind == Kind::nodes ? scope.nodes.size() : scope.elements.size());
  }
  return count;
}

std::vector<NamedSet> InpSets::named(const std::shared_ptr<const InpSets>& sets) {
  std::vector<NamedSet> result;
  for (std::size_t i = 0; i < sets->sets_.size(); ++i) {
    const Set& set = sets->sets_[i];
    const bool of_nodes = set.kind == Kind::nodes;
    const std::string& scope = sets->scopes_[set.scope].name;
    result.push_back(
        {.kind = of_nodes ? "nset" : "elset",
         .name = scope.empty() ? set.name : scope + "." + set.name,
         .members = sets->listed(set),
         .unit = of_nodes ? "vertices" : "cells",
         .vertices = [sets, i](const Cells& cells) { return sets->vertices(i, cells); }});
    for (const std::size_t other : set.others) {
      result.back().members += sets->listed(sets->sets_[other]);
    }
  }
  return result;
}

}  // namespace evenmesh
