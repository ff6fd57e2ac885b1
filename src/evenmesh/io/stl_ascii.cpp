// SPDX-License-Identifier: MIT
#include "evenmesh/io/stl_ascii.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "evenmesh/io/byte_patcher.h"
#include "evenmesh/io/stl_soup.h"
#include "evenmesh/io/text_scan.h"

namespace evenmesh {
namespace {

struct Word {
  const char* begin;
  const char* end;
  bool empty() const { return begin == end; }
};

/// A facet as it stands in the file.
struct FacetText {
  const char* begin;
  std::array<Word, 3> normal;
  std::array<std::array<Word, 3>, 3> words;  // [corner][axis]
  std::array<Vec3, 3> corners;
};

bool is_space(char c) { return is_blank(c) || is_eol(c); }

/// Case does not matter. @param keyword in lower case
bool is_keyword(const Word& word, std::string_view keyword) {
  return std::equal(word.begin, word.end, keyword.begin(), keyword.end(),
                    [](char c, char k) { return c == k || (c >= 'A' && c <= 'Z' && c + 32 == k); });
}

class Parser {
 public:
  Parser(const InputFile& input, const char* begin)
      : input_(input), p_(begin), end_(input.bytes().data() + input.bytes().size()) {}

  /// The next word, which is not taken; empty at the end of the file.
  Word peek() {
    while (p_ != end_ && is_space(*p_)) ++p_;
    const char* stop = p_;
    while (stop != end_ && !is_space(*stop)) ++stop;
    return {p_, stop};
  }
  Word take() {
    const Word word = peek();
    p_ = word.end;
    return word;
  }

  /// The rest of the line, without blanks around it.
  std::string take_line() {
    while (p_ != end_ && is_blank(*p_)) ++p_;
    const char* const begin = p_;
    while (p_ != end_ && !is_eol(*p_)) ++p_;
    const char* stop = p_;
    while (stop != begin && is_blank(stop[-1])) --stop;
    return {begin, stop};
  }

  /// @pre peek() is "facet"
  FacetText take_facet(std::size_t number) {
    facet_ = number + 1;
    FacetText facet;
    facet.begin = peek().begin;
    expect("facet");
    expect("normal");
    for (Word& word : facet.normal) {
      if (is_keyword(peek(), "outer") || peek().empty()) fail("has a normal with too few numbers");
      word = take();
    }
    expect("outer");
    expect("loop");
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_keyword(peek(), "endloop")) fail(fmt::format("has {} vertices instead of 3", i));
      take_corner(facet.words[i], facet.corners[i]);
    }
    if (is_keyword(peek(), "vertex")) {
      fail("has more than three vertices; STL knows triangles only");
    }
    expect("endloop");
    expect("endfacet");
    return facet;
  }

 private:
  void take_corner(std::array<Word, 3>& words, Vec3& position) {
    expect("vertex");
    for (int k = 0; k < 3; ++k) {
      const Word word = words[static_cast<std::size_t>(k)] = take();
      if (scan_number(word.begin, word.end, position[k]) == nullptr) {
        if (word.empty()) fail_at_end();
        input_.fail_at(word.begin, explain_bad_number(word.begin, word.end));
      }
    }
  }

  void expect(std::string_view keyword) {
    const Word word = take();
    if (word.empty()) fail_at_end();
    if (is_keyword(word, keyword)) return;
    input_.fail_at(word.begin, fmt::format("facet {} has {} where '{}' should be", facet_,
                                           quoted_word(word.begin, word.end), keyword));
  }

  [[noreturn]] void fail(std::string_view what) {
    const Word word = peek();
    if (word.empty()) fail_at_end();
    input_.fail_at(word.begin, fmt::format("facet {} {}", facet_, what));
  }
  [[noreturn]] void fail_at_end() const {
    input_.fail_at(end_,
                   fmt::format("the file ends within facet {}; it was cut off. Export or copy "
                               "it again",
                               facet_));
  }

  const InputFile& input_;
  const char* p_;
  const char* end_;
  std::size_t facet_ = 0;  // counted from 1
};

class AsciiStlPatch final : public StlPatch {
 public:
  AsciiStlPatch(std::shared_ptr<const InputFile> file, Mesh as_read,
                std::vector<std::uint64_t> facets)
      : StlPatch(std::move(file), std::move(as_read)), facets_(std::move(facets)) {}

  std::string_view format() const override { return "stl_ascii"; }

  std::vector<Vec3> representable(Points points) const override {
    std::vector<Vec3> result(points.begin(), points.end());
    for (Index i = 0; i < result.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        if (!moved(i, k, points)) result[i][k] = mesh().points()[i][k];
      }
    }
    return result;
  }

  void write(Points points, const std::function<void(std::string_view)>& sink) const override {
    input().check_unchanged();
    BytePatcher out(input().bytes(), sink);
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      if (moved(i, points)) patch_facet(i, points, out);
    }
    out.finish();
    input().check_unchanged();
  }

  std::string cell_name(std::size_t cell) const override {
    return fmt::format("facet {} (line {})", cell + 1, input().line_of(facets_[cell]));
  }

 private:
  void patch_facet(std::size_t facet, Points points, BytePatcher& out) const {
    const FacetText text =
        Parser(input(), input().bytes().data() + facets_[facet]).take_facet(facet);
    const auto [a, b, c] = corners(facet, points);
    const Vec3 normal = facet_normal(a, b, c);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = static_cast<float>(normal[static_cast<int>(k)]);
      out.replace(text.normal[k].begin, text.normal[k].end, NumberText(number).view());
    }
    const auto vertices = mesh().cells().vertices(facet);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        if (!moved(vertices[i], axis, points)) continue;
        out.replace(text.words[i][k].begin, text.words[i][k].end,
                    NumberText(points[vertices[i]][axis]).view());
      }
    }
  }

  std::vector<std::uint64_t> facets_;  // where each facet begins
};

/// The solids of a file, and which facets are theirs.
struct Solids {
  std::vector<std::string> names;
  std::vector<std::size_t> first_facets;

  /// Groups of the cells; none where there is but one solid with facets.
  std::vector<std::uint32_t> groups(std::size_t facets,
                                    std::vector<std::string>& group_names) const {
    std::vector<std::uint32_t> result(facets, 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t last = i + 1 < names.size() ? first_facets[i + 1] : facets;
      if (last == first_facets[i]) continue;
      std::fill(result.begin() + static_cast<std::ptrdiff_t>(first_facets[i]),
                result.begin() + static_cast<std::ptrdiff_t>(last),
                static_cast<std::uint32_t>(group_names.size()));
      group_names.push_back("solid " + (names[i].empty() ? std::to_string(i + 1) : names[i]));
    }
    if (group_names.size() > 2) return result;
    group_names.resize(1);
    return {};
  }
};

}  // namespace

MeshFile read_stl_ascii(std::shared_ptr<const InputFile> input, const ReadOptions& options) {
  const char* const begin = input->bytes().data();
  Parser parser(*input, begin + (input->bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0));
  StlSoup soup(options);
  Solids solids;
  std::vector<std::uint64_t> facets;
  bool closed = true;
  for (Word word = parser.peek(); !word.empty(); word = parser.peek()) {
    if (is_keyword(word, "facet")) {
      const FacetText facet = parser.take_facet(facets.size());
      facets.push_back(static_cast<std::uint64_t>(facet.begin - begin));
      soup.add(facet.corners);
    } else if (is_keyword(word, "solid") || is_keyword(word, "endsolid")) {
      parser.take();
      closed = is_keyword(word, "endsolid");
      std::string name = parser.take_line();
      if (closed) continue;
      solids.names.push_back(std::move(name));
      solids.first_facets.push_back(facets.size());
    } else {
      input->fail_at(word.begin, fmt::format("{} where 'facet', 'solid' or 'endsolid' should be",
                                             quoted_word(word.begin, word.end)));
    }
  }

  MeshFile file;
  if (!closed) {
    if (is_blank(input->bytes().back())) {  // the next line was begun
      input->fail_at(
          input->bytes().size(),
          "the file ends within a line and without 'endsolid'; it was cut off. Export or "
          "copy it again");
    }
    file.notes.push_back("The file ends without 'endsolid'; it may have been cut off.");
  }
  if (facets.empty()) file.notes.push_back("The file has no facets.");
  file.group_names = {""};
  file.mesh = soup.take_mesh(solids.groups(facets.size(), file.group_names));
  file.patch = std::make_unique<AsciiStlPatch>(std::move(input), file.mesh, std::move(facets));
  return file;
}

}  // namespace evenmesh
