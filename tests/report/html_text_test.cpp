// SPDX-License-Identifier: MIT
#include "evenmesh/report/html_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace evenmesh {
namespace {

TEST(HtmlText, LeavesNoMarkup) {
  EXPECT_EQ(html_escaped("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(html_escaped("</script><img src=x onerror=alert(1)>"),
            "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;");
}

TEST(HtmlText, KeepsLinesAndLetters) {
  EXPECT_EQ(html_escaped("one\ntwo\n"), "one\ntwo\n");
  EXPECT_EQ(html_escaped("Tür \u2264 \U0001F600"), "Tür \u2264 \U0001F600");
}

TEST(HtmlText, ReplacesWhatIsNoText) {
  EXPECT_EQ(html_escaped("a\xff\x01z"), "a\uFFFD\uFFFDz");
  EXPECT_EQ(html_escaped(std::string("\0\xc3", 2)), "\uFFFD\uFFFD");
}

TEST(ScriptJson, EndsNoElementAndMeansTheSame) {
  const nlohmann::json value = {{"name", "</script><!--<script>"}};
  const std::string text = script_json(value.dump());
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text), value);
}

}  // namespace
}  // namespace evenmesh
