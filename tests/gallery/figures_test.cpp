// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/figures.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "evenmesh/base/error.h"

namespace evenmesh::gallery {
namespace {

std::set<std::string> ids(std::string_view word) {
  std::set<std::string> found;
  for (const Case* each : find_cases(word)) found.emplace(each->id);
  return found;
}

TEST(FindCases, KnowsEveryFigureOfThePaperFrom5To31) {
  for (int figure = 5; figure <= 31; ++figure) {
    EXPECT_FALSE(find_cases("fig" + std::to_string(figure)).empty()) << figure;
  }
}

TEST(FindCases, KnowsEveryCaseByItsOwnName) {
  for (const Case& each : cases()) {
    EXPECT_EQ(ids(each.id), std::set<std::string>{std::string(each.id)});
  }
}

TEST(FindCases, GivesFiguresOfConvergenceTheirMeshes) {
  EXPECT_EQ(ids("fig6"), ids("fig5"));
  EXPECT_EQ(ids("fig14"), (std::set<std::string>{"fig13a", "fig13b"}));
  EXPECT_EQ(ids("fig16"), (std::set<std::string>{"fig15a", "fig15b"}));
  EXPECT_EQ(ids("fig31"), (std::set<std::string>{"fig29", "fig30"}));
}

TEST(FindCases, GivesFiguresOfStartMeshesAllThatStartsThere) {
  EXPECT_EQ(ids("fig12"),
            (std::set<std::string>{"fig12t", "fig13a", "fig13b", "fig15a", "fig15b"}));
  EXPECT_EQ(ids("fig28"), (std::set<std::string>{"fig29", "fig30"}));
  EXPECT_EQ(find_cases("all").size(), cases().size());
}

TEST(FindCases, SuggestsTheNearestOfWhatItDoesNotKnow) {
  for (const auto& [word, hint] : {std::pair{"fig32", "fig31?"},
                                   {"fig4", "fig5?"},
                                   {"fig15c", "fig15?"},
                                   {"Fig9", "fig9?"},
                                   {"fig13A", "fig13?"},
                                   {"", "fig"}}) {
    try {
      find_cases(word);
      ADD_FAILURE() << word;
    } catch (const InvalidOption& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("did you mean ") + hint),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(Cases, ShowFiguresOfTheirPlate) {
  for (const Case& each : cases()) {
    const Plate& plate = plate_of(each.start);
    for (const int figure : each.figures) {
      EXPECT_GE(figure, plate.first_figure) << each.id;
      EXPECT_LE(figure, plate.last_figure) << each.id;
    }
  }
}

TEST(CostWords, NameWeightsOtherThanOne) {
  EXPECT_EQ(cost_words(find_cases("fig5b")[0]->setup), "local");
  EXPECT_EQ(cost_words(find_cases("fig24a")[0]->setup), "0.3 global + 0.7 barycenter");
}

}  // namespace
}  // namespace evenmesh::gallery
