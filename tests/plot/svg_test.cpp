// SPDX-License-Identifier: MIT
#include "evenmesh/plot/svg.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/plot/xml.h"

namespace evenmesh {
namespace {

TEST(SvgNumber, IsShortAndHasNoExponent) {
  EXPECT_EQ(svg_number(3.0), "3");
  EXPECT_EQ(svg_number(-0.25), "-0.25");
  EXPECT_EQ(svg_number(1.005e7), "10050000");
  EXPECT_EQ(svg_number(2.3456), "2.35");
  EXPECT_EQ(svg_number(2.3456, 0), "2");
  EXPECT_EQ(svg_number(100.0, 0), "100");
}

TEST(SvgNumber, OfWhatRoundsToNothingHasNoSign) { EXPECT_EQ(svg_number(-0.001), "0"); }

TEST(SvgNumber, OfWhatIsNotFiniteBreaksNoPicture) {
  EXPECT_EQ(svg_number(std::nan("")), "0");
  EXPECT_EQ(svg_number(-std::numeric_limits<double>::infinity()), "0");
}

TEST(SvgNumber, HasAPointInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);
  EXPECT_EQ(svg_number(0.5), "0.5");
  std::setlocale(LC_ALL, before.c_str());
}

TEST(WithThousands, GroupsDigitsByThree) {
  EXPECT_EQ(with_thousands(0), "0");
  EXPECT_EQ(with_thousands(999), "999");
  EXPECT_EQ(with_thousands(1000), "1,000");
  EXPECT_EQ(with_thousands(1234567), "1,234,567");
}

TEST(SvgEscaped, HidesWhatXmlWouldRead) {
  EXPECT_EQ(svg_escaped("<script>alert('a' & \"b\")</script>"),
            "&lt;script&gt;alert(&#39;a&#39; &amp; &quot;b&quot;)&lt;/script&gt;");
}

TEST(SvgEscaped, KeepsCharactersOfAllLengths) {
  const std::string text = "a\u00B0\u2212\U0001F600";
  EXPECT_EQ(svg_escaped(text), text);
}

TEST(SvgEscaped, ReplacesWhatIsNoText) {
  const std::string bad = "\uFFFD";
  EXPECT_EQ(svg_escaped(std::string("a\0b", 3)), "a" + bad + "b");
  EXPECT_EQ(svg_escaped("\x1b[31m"), bad + "[31m");
  EXPECT_EQ(svg_escaped("\xff\xc3"), bad + bad);    // never UTF-8; cut off
  EXPECT_EQ(svg_escaped("\xc0\xaf"), bad + bad);    // longer than need be
  EXPECT_EQ(svg_escaped("\xe0\x80\xaf"), bad);      // longer than need be
  EXPECT_EQ(svg_escaped("\xed\xa0\x80"), bad);      // half a surrogate pair
  EXPECT_EQ(svg_escaped("\xef\xbf\xbf"), bad);      // forbidden in XML
  EXPECT_EQ(svg_escaped("\xf4\x90\x80\x80"), bad);  // beyond the last character
  EXPECT_EQ(svg_escaped("a\tb\nc"), "a b c");
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("longer", 5), "long\u2026");
  EXPECT_EQ(shortened("\u00E4\u00F6\u00FC\u00DF", 3), "\u00E4\u00F6\u2026");
}

TEST(TextWidth, GrowsWithCharactersNotBytes) {
  EXPECT_DOUBLE_EQ(text_width("\u00E4\u00F6", 10.0), text_width("ao", 10.0));
  EXPECT_DOUBLE_EQ(text_width("ao", 20.0), 2.0 * text_width("ao", 10.0));
  EXPECT_EQ(text_width("", 10.0), 0.0);
}

TEST(Svg, IsWellFormedAndHoldsWhatWasDrawn) {
  Svg svg(100, 50);
  svg.open("stroke=\"#000\"");
  svg.line({0, 1}, {2, 3.5}, "");
  svg.polyline(std::vector<Pixel>{{0, 0}, {1, 2}, {3, std::nan("")}}, "fill=\"none\"");
  svg.close();
  svg.text({5, 6}, "<10>", "", "-3");
  const std::vector<testing::Element> all = testing::parse_xml(std::move(svg).finish());
  ASSERT_EQ(all.size(), 7u);  // svg, background, group, line, polyline, text, tspan
  EXPECT_EQ(all[0]["viewBox"], "0 0 100 50");
  EXPECT_EQ(all[3].number("y2"), 3.5);
  EXPECT_EQ(all[4]["points"], "0,0 1,2 3,0");
  EXPECT_EQ(all[5].text, "<10>-3");
}

}  // namespace
}  // namespace evenmesh
