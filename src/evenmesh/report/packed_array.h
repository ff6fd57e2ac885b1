// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace evenmesh {

/// How the numbers of an array become small ones without a sign.
enum class Rule : std::uint8_t {
  as_is,     // they have none
  zigzag,    // 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
  delta,     // zigzag of the difference to the same component of the entry before
  highwater  // how far below the least number that has not come up yet: 0 for that one itself
};

/// The word for it in the report: "unsigned", "signed", "delta", "highwater".
std::string_view name(Rule rule);

/// An array of whole numbers in few bytes, as web/README.md describes them: made small by a
/// rule, byte p of all numbers in plane p, the planes one after the other deflated with zlib.
struct PackedArray {
  std::string bytes = {};      // a zlib stream
  std::size_t count = 0;       // of numbers: entries times components
  std::size_t components = 1;  // of an entry
  int planes = 1;              // 1 to 4
  Rule rule = Rule::as_is;
};

/// Always the same bytes for the same numbers and the same zlib.
/// @pre  entries are complete; as_is: no number is negative; delta and zigzag: what is packed is
///       less than 2^31 in size; highwater: one component, and the least number that has not come
///       up yet is the greatest there may be
PackedArray pack(std::span<const std::int64_t> values, std::size_t components, Rule rule);

/// The shorter of zigzag and delta.
PackedArray pack_signed(std::span<const std::int64_t> values, std::size_t components);

}  // namespace evenmesh
