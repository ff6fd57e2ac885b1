// SPDX-License-Identifier: MIT
#include "evenmesh/io/inp_holders.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace evenmesh {
namespace {

/// Keywords whose data lines begin with a node or a node set on whose place something hangs.
constexpr std::array<std::string_view, 5> kHolders = {
    "BOUNDARY", "CLOAD", "CFLUX", "KINEMATIC COUPLING", "DISTRIBUTING COUPLING"};

/// Their parameters name one.
constexpr std::array<std::string_view, 6> kHoldingParameters = {
    "REF NODE", "TIE NSET", "PIN NSET", "CONTROL NODE", "ROT NODE", "NODE"};

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Calls visit with place and text of each field of the data lines that is not empty.
template <typename Visit>
void for_each_field(DeckLines& lines, const Visit& visit) {
  for (; !lines.text().empty() && !lines.is_keyword(); lines.next()) {
    const auto fields = fields_of(lines.text());
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (!fields[i].empty()) visit(i, fields[i]);
    }
  }
}

}  // namespace

void InpHolders::note(const DeckKeyword& keyword, DeckLines& lines, std::size_t scope) {
  for (const auto& [key, value] : keyword.parameters) {
    if (is_one_of(kHoldingParameters, key)) words_.insert({scope, value});
  }
  if (keyword.name == "EQUATION") {
    note_equations(lines, scope);
  } else if (keyword.name == "MPC") {
    for_each_field(lines, [&](std::size_t i, std::string_view field) {
      if (i > 0) words_.insert({scope, std::string(field)});  // the first is the type
    });
  } else if (is_one_of(kHolders, keyword.name)) {
    for_each_field(lines, [&](std::size_t i, std::string_view field) {
      if (i == 0) words_.insert({scope, std::string(field)});
    });
  }
}

// An equation is the number of its terms on a line of its own, then node, degree of freedom and
// coefficient of each.
void InpHolders::note_equations(DeckLines& lines, std::size_t scope) {
  constexpr std::size_t kFieldsOfTerm = 3;
  std::size_t left = 0;  // fields of the equation at hand
  for_each_field(lines, [&](std::size_t, std::string_view field) {
    if (left == 0) {
      std::int64_t terms = 0;
      if (scan_whole(field.data(), field.data() + field.size(), terms) != nullptr && terms > 0) {
        left = kFieldsOfTerm * static_cast<std::size_t>(terms);
      }
      return;
    }
    if (left-- % kFieldsOfTerm == 0) words_.insert({scope, std::string(field)});
  });
}

// Sets overlap: vertices are marked, not listed, so that many sets need no more memory than one.
std::vector<Index> InpHolders::vertices(const InpSets& sets, const Cells& cells,
                                        std::size_t vertices) const {
  std::vector<char> is_held(vertices, 0);
  for (const auto& [scope, word] : words_) {
    for (const Index v : sets.vertices_of(word, scope, cells)) is_held[v] = 1;
  }
  std::vector<Index> result;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (is_held[v]) result.push_back(static_cast<Index>(v));
  }
  return result;
}

}  // namespace evenmesh
