// SPDX-License-Identifier: MIT
#include "evenmesh/io/text_scan.h"

#include <bit>
#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace evenmesh {
namespace {

std::optional<double> scan(std::string_view text) {
  double value = 0.0;
  const char* const end = scan_number(text.data(), text.data() + text.size(), value);
  return end == nullptr ? std::nullopt : std::optional(value);
}

std::string explain(std::string_view text) {
  return explain_bad_number(text.data(), text.data() + text.size());
}

TEST(ScanNumber, ReadsWhatPeopleWrite) {
  const std::pair<std::string_view, double> numbers[] = {
      {"1", 1.0},     {"+1", 1.0},    {"-2.", -2.0}, {".5", 0.5},        {"+.5e1", 5.0},
      {"1E-3", 1e-3}, {"1e+3", 1e3},  {"007", 7.0},  {"5e-324", 5e-324}, {"3 4", 3.0},
      {"3\r\n", 3.0}, {"3\\\n", 3.0}, {"0e999", 0.0}};
  for (const auto& [text, value] : numbers) EXPECT_EQ(scan(text), value) << text;
}

TEST(ScanNumber, RefusesEverythingElse) {
  for (const std::string_view text :
       {"",   " 1",  "x",    "1x",  "1,5", "+-1",  "--1",      "+",     "-",      ".",     "e5",
        "1e", "1e+", "0x10", "1d3", "nan", "-inf", "infinity", "1e999", "-1e999", "1_000", "1#"}) {
    EXPECT_FALSE(scan(text)) << text;
  }
}

TEST(ScanNumber, TakesNumbersTooSmallForZero) {
  for (const std::string_view text :
       {"1e-400", "0.00001e-320", "123456e-9999999999999999999", "2e-324", "1000e-330"}) {
    EXPECT_EQ(scan(text), 0.0) << text;
  }
  EXPECT_TRUE(std::signbit(*scan("-1e-400")));
  EXPECT_FALSE(scan("0.00001e320"));
  EXPECT_FALSE(scan("100000e306"));
}

TEST(ExplainBadNumber, SaysWhatToDo) {
  EXPECT_EQ(explain("0,25 1"),
            "'0,25' has a decimal comma; write numbers with a point, as in 0.25");
  EXPECT_EQ(explain("1.5D3"), "'1.5D3' has an exponent written with D; write it with E");
  EXPECT_EQ(explain("nan"), "'nan' is not a finite number; repair the file or write it again");
  EXPECT_EQ(explain("1e999"), "'1e999' is too large for a double; scale the mesh down");
  EXPECT_EQ(explain("\x1b[2J"), "'?[2J' is not a number");
}

TEST(NumberText, ReadsBackAsTheSameNumber) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const NumberText text(value);
    const std::optional<double> back = scan(text.view());
    ASSERT_TRUE(back) << text.view();
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
  }
}

}  // namespace
}  // namespace evenmesh
