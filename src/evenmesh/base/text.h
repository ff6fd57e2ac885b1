// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace evenmesh {

/// White space of ASCII, whatever the locale.
inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Without the spaces around it.
std::string_view trimmed(std::string_view text);

/// A piece of a user's text fit for a message, whatever its length and bytes: half a UTF-8 sequence
/// would spoil a terminal or a JSON report.
std::string shown(std::string_view text);

/// With small letters for the capital ones of ASCII.
std::string lower(std::string_view text);

/// Whether two words differ in nothing but capital and small letters of ASCII.
bool equal_but_for_case(std::string_view a, std::string_view b);

/// The known word that a misspelt one is nearest to, letters of either case being the same; empty
/// if none is near.
std::string nearest_word(std::string_view word, std::span<const std::string_view> known);

/// " (did you mean 'boundary'?)", or nothing if no known word is near.
std::string suggestion(std::string_view word, std::span<const std::string_view> known);

}  // namespace evenmesh
