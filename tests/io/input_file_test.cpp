// SPDX-License-Identifier: MIT
#include "evenmesh/io/input_file.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

TEST(InputFile, CountsLinesAsAnEditorDoes) {
  const auto file = InputFile::borrow("a\r\nb\rc\n\n\r\r\nd\r", "x");
  const std::size_t lines[] = {1, 1, 1, 2, 2, 3, 3, 4, 5, 6, 6, 7, 7, 8};
  for (std::size_t i = 0; i < std::size(lines); ++i) EXPECT_EQ(file->line_of(i), lines[i]) << i;
}

TEST(InputFile, CountsLinesOfLongFilesAsOfShortOnes) {
  std::mt19937 random(3);
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "\r\nab"[random() % 4];
  const auto file = InputFile::borrow(text, "x");
  std::size_t line = 1;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    ASSERT_EQ(file->line_of(i), line) << i;
    if (i == text.size()) break;
    const bool before_lf = i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] == '\n' || (text[i] == '\r' && !before_lf)) ++line;
  }
}

}  // namespace
}  // namespace evenmesh
