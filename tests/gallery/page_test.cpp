// SPDX-License-Identifier: MIT
//
// The page that is in the repository, docs/gallery.md, against a fresh run. Where this fails for a
// good reason, make the page anew:  build/release/evenmesh demo all -o docs
#include "apps/evenmesh/gallery/page.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

namespace evenmesh::gallery {
namespace {

const std::filesystem::path kDocs = EVENMESH_DOCS_DIR;

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string word; in >> word;) result.push_back(word);
  return result;
}

// The number that a word is as a whole.
std::optional<double> number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return std::nullopt;
  return value;
}

// One in the last digit that is shown: of five digits, or of three after the point.
bool equal_up_to_rounding(const std::string& a, const std::string& b) {
  const auto x = number(a);
  const auto y = number(b);
  if (!x || !y) return a == b;
  return std::abs(*x - *y) <= std::max(1.1e-4 * std::abs(*x), std::abs(*x) < 1.0 ? 1.1e-3 : 0.0);
}

// The page made anew, once.
const std::string& fresh_page() {
  static const std::string page = [] {
    std::vector<Exhibit> exhibits;
    for (const Case& each : cases()) exhibits.push_back(make_exhibit(each));
    std::vector<Series> series;
    for (const Plate& plate : plates()) {
      if (plate.exact) series.push_back(make_series(plate.start));
    }
    return gallery_page(exhibits, series);
  }();
  return page;
}

TEST(GalleryPage, StatesTheNumbersOfAFreshRun) {
  const std::vector<std::string> stated = lines(content(kDocs / "gallery.md"));
  const std::vector<std::string> fresh = lines(fresh_page());
  ASSERT_EQ(stated.size(), fresh.size());
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const auto a = words(stated[i]);
    const auto b = words(fresh[i]);
    ASSERT_EQ(a.size(), b.size()) << "line " << i + 1 << ": " << fresh[i];
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_TRUE(equal_up_to_rounding(a[k], b[k]))
          << "line " << i + 1 << ": " << a[k] << " is stated, but it is " << b[k] << " in\n"
          << fresh[i];
    }
  }
}

TEST(GalleryPage, HasItsPicturesBesideIt) {
  std::uintmax_t bytes = 0;
  for (const Case& each : cases()) {
    for (const char* const kind : {".svg", "_convergence.svg"}) {
      const auto path = kDocs / "pictures" / "gallery" / (std::string(each.id) + kind);
      ASSERT_TRUE(std::filesystem::is_regular_file(path)) << path;
      EXPECT_NE(fresh_page().find(path.filename().string()), std::string::npos) << path;
      bytes += std::filesystem::file_size(path);
    }
  }
  EXPECT_LT(bytes, 2'000'000u);
}

TEST(GalleryPage, HasNoTimes) {
  for (const char* word : {" s |", " ms", "seconds"}) {
    EXPECT_EQ(fresh_page().find(word), std::string::npos) << word;
  }
}

TEST(EqualUpToRounding, TellsTheLastDigitFromOthers) {
  EXPECT_TRUE(equal_up_to_rounding("0.567", "0.568"));
  EXPECT_FALSE(equal_up_to_rounding("0.567", "0.569"));
  EXPECT_TRUE(equal_up_to_rounding("10.572", "10.573"));
  EXPECT_FALSE(equal_up_to_rounding("10.572", "10.574"));
  EXPECT_FALSE(equal_up_to_rounding("24", "25"));
  EXPECT_FALSE(equal_up_to_rounding("converged", "interrupted"));
}

}  // namespace
}  // namespace evenmesh::gallery
