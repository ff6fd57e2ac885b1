// SPDX-License-Identifier: MIT
//
// Broken files by the thousand: each reader refuses them or keeps its promises. The seeds are those
// of the fuzzers, which go on from here for as long as one likes (./run fuzz).
#include <filesystem>
#include <locale>
#include <map>

#include <gtest/gtest.h>

#include "fuzz/patch_promise.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/places.h"
#include "tests/support/random.h"

namespace evenmesh {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::vector<Format>> kFormats = {
    {"exodus", {Format::exodus}},
    {"inp", {Format::inp}},
    {"medit", {Format::medit}},
    {"meshb", {Format::meshb}},
    {"msh", {Format::msh}},
    {"nastran", {Format::nastran}},
    {"obj", {Format::obj}},
    {"off", {Format::off}},
    {"ply", {Format::ply}},
    {"su2", {Format::su2}},
    {"stl", {Format::stl_ascii, Format::stl_binary}},
    {"ucd", {Format::ucd}},
    {"vtk", {Format::vtk}},
    {"vtp", {Format::vtp}},
    {"vtu", {Format::vtu}},
};

/// Changes a few bytes, repeats or drops a stretch, or puts a word there that often hurts.
class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutate(std::string bytes) {
    const std::size_t changes = 1 + below(3);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) { return random_.below(end); }

  void change(std::string& bytes) {
    static const std::vector<std::string> kWords = {"-1",
                                                    "0",
                                                    "4294967296",
                                                    "99999999999999999999",
                                                    "1e400",
                                                    "nan",
                                                    ",",
                                                    "\n",
                                                    "#",
                                                    "*",
                                                    " ",
                                                    std::string(4, '\xff'),
                                                    std::string(8, '\0'),
                                                    std::string("\1\0\0\0", 4)};
    const std::size_t at = below(bytes.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(20, bytes.size() - at));
    const std::string stretch = bytes.substr(at, length);
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(below(bytes.size()), stretch);
        break;
      case 3:
        bytes.resize(at + 1);
        break;
      default: {
        const std::string& word = kWords[below(kWords.size())];
        bytes.replace(at, std::min(word.size(), bytes.size() - at), word);
      }
    }
  }

  shapes::Random random_;
};

class Comma final : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Seeds, AreReadAndWrittenTheSameInEveryLocale) {
  const auto write_moved = [](const fs::path& path) {
    const std::string bytes = testing::read_bytes(path);
    const MeshFile file = read_mesh(InputFile::borrow(bytes, path.string()));
    return fuzz::written(file, file.representable(fuzz::moved_points(file.mesh)));
  };
  for (const auto& entry :
       fs::recursive_directory_iterator(testing::source_dir() / "fuzz/corpus")) {
    if (!entry.is_regular_file()) continue;
    const std::string classic = write_moved(entry.path());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const std::string with_commas = write_moved(entry.path());
    std::locale::global(before);
    EXPECT_EQ(with_commas, classic) << entry.path();
  }
}

TEST(Mutations, AreRefusedOrKeepThePromisesOfReaders) {
  constexpr int kMutations = 1500;
  for (const auto& [name, formats] : kFormats) {
    int seeds = 0;
    for (const auto& entry : fs::directory_iterator(testing::source_dir() / "fuzz/corpus" / name)) {
      ++seeds;
      const std::string seed = testing::read_bytes(entry.path());
      Mutator mutator(seed.size());
      for (int i = 0; i < kMutations; ++i) {
        const std::string bytes = i == 0 ? seed : mutator.mutate(seed);
        // Under its own address, so that the sanitizer sees a byte read too far.
        const std::vector<char> copy(bytes.begin(), bytes.end());
        for (const Format format : formats) {
          fuzz::check_promise(format, {copy.data(), copy.size()});
        }
      }
    }
    EXPECT_GT(seeds, 0) << name;
  }
}

}  // namespace
}  // namespace evenmesh
