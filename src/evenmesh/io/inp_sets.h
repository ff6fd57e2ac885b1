// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenmesh/io/node_numbers.h"
#include "evenmesh/mesh/mesh.h"
#include "evenmesh/mesh/named_sets.h"

namespace evenmesh {

/// Numbers first, first + step ... last.
struct NumberRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t step = 1;
};

/// The parts of a deck, each with its own numbers of nodes and elements, and the sets in them.
/// Scope 0 is what stands outside of parts.
class InpSets {
 public:
  enum class Kind : std::uint8_t { nodes, elements };

  struct Scope {
    std::string name = {};
    std::vector<std::uint64_t> nodes = {};
    std::vector<Index> vertices = {};  // of these nodes
    std::vector<std::uint64_t> elements = {};
    std::vector<Index> cells = {};  // of these elements
    NodeNumbers node_numbers = {};
    NodeNumbers element_numbers = {};
  };

  InpSets() : scopes_(1) {}

  /// @return  the number of a new scope
  std::size_t add_scope(std::string name);
  void add_instance(const std::string& instance, const std::string& part);
  std::size_t scope_of_part(std::string_view part) const;  // 0 if it is not known
  std::size_t scope_of_instance(std::string_view instance) const;
  Scope& scope(std::size_t number) { return scopes_[number]; }
  std::size_t scopes() const { return scopes_.size(); }

  /// The set of this name, made if it is new.
  std::size_t set(Kind kind, std::size_t scope, const std::string& name);
  std::optional<std::size_t> find(Kind kind, std::size_t scope, std::string_view name) const;
  /// The same, or the one set of this name outside of parts or in any of them.
  std::optional<std::size_t> find_anywhere(Kind kind, std::size_t scope,
                                           std::string_view name) const;
  void add_range(std::size_t set, std::size_t scope, const NumberRange& range);
  void add_set(std::size_t set, std::size_t other);
  const std::string& name(std::size_t set) const { return sets_[set].name; }

  /// The vertices of a node set, or the cells of an element set, each once.
  std::vector<Index> members(std::size_t set) const;
  std::vector<Index> vertices(std::size_t set, const Cells& cells) const;

  /// What a word in a deck names, as in "12", "BOLTS" or "Part-1-1.BOLTS".
  std::vector<Index> vertices_of(std::string_view word, std::size_t scope,
                                 const Cells& cells) const;

  /// All sets, for those who select by them.
  static std::vector<NamedSet> named(const std::shared_ptr<const InpSets>& sets);

 private:
  struct Piece {
    std::size_t scope = 0;
    NumberRange range = {};
  };
  struct Set {
    Kind kind = Kind::nodes;
    std::size_t scope = 0;
    std::string name = {};
    std::vector<Piece> pieces = {};
    std::vector<std::size_t> others = {};
  };
  /// Vertices, or cells, each once however often sets list them.
  struct Members {
    std::vector<Index> list = {};
    std::vector<char> taken = {};
    void add(Index member);
  };
  std::vector<Index> collect(std::size_t set, Kind kind) const;
  void collect(const Piece& piece, Kind kind, Members& members) const;
  std::size_t listed(const Set& set) const;

  std::vector<Scope> scopes_;
  std::map<std::string, std::size_t> parts_;      // by name in capitals
  std::map<std::string, std::size_t> instances_;  // likewise
  std::vector<Set> sets_;
  std::map<std::string, std::size_t> numbers_;  // of sets, by kind, scope and name in capitals
};

}  // namespace evenmesh
