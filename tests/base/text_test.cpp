// SPDX-License-Identifier: MIT
#include "evenmesh/base/text.h"

#include <array>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

constexpr std::array<std::string_view, 3> kKnown = {"boundary", "features", "id:"};

TEST(Text, IsTrimmedAtBothEnds) {
  EXPECT_EQ(trimmed(" \t a b\n"), "a b");
  EXPECT_EQ(trimmed("  "), "");
}

TEST(Text, IsShownInPrintableLettersAndNotAtLength) {
  EXPECT_EQ(shown("a\nb\xc3\xa9"), "a?b??");
  EXPECT_EQ(shown(std::string(100, 'x')), std::string(40, 'x') + "...");
}

TEST(Text, SuggestsTheNearestKnownWord) {
  EXPECT_EQ(suggestion("Bondary", kKnown), " (did you mean 'boundary'?)");
  EXPECT_EQ(nearest_word("feature", kKnown), "features");
  EXPECT_EQ(nearest_word("corner", kKnown), "");
  EXPECT_EQ(nearest_word(std::string(100, 'x'), kKnown), "");
  EXPECT_EQ(nearest_word("boundary", {}), "");
}

}  // namespace
}  // namespace evenmesh
