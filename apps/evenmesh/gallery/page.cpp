// SPDX-License-Identifier: MIT
#include "apps/evenmesh/gallery/page.h"

#include <algorithm>
#include <system_error>

#include <fmt/core.h>

#include "apps/evenmesh/gallery/pictures.h"
#include "apps/evenmesh/gallery/tables.h"
#include "evenmesh/base/error.h"
#include "evenmesh/io/output_file.h"

namespace evenmesh::gallery {
namespace {

constexpr std::string_view kPreface = R"(# Gallery: the figures of the paper

<!-- Made by `evenmesh demo all -o docs`, as are the pictures. -->

S. Kulovec, L. Kos and J. Duhovnik, *Mesh Smoothing with Global Optimization under Constraints* (2011), Figs. 5 to 31:
the same costs, weights and constraints, its dense Lagrange-Newton method, and what evenmesh makes of the same mesh.
`evenmesh demo fig13` repeats one of them, `evenmesh demo list` names all.

Rows of the tables:

- **in the paper**: the iterations it reports.
- **paper's method**: dense Lagrange-Newton from the identity, nothing but the paper's own constraints. On the three
  exact meshes it ends by the stop criterion (12) with the eps that is given; on the others by eps 1e-6 or with
  the paper's number of iterations, whichever comes first.
- **with validity**: the same method with the demand that no cell turns over, to the end.
- **evenmesh**: the solver that scales, chosen by itself, with validity and the promise that nothing gets worse:
  "pulled back" says that the minimum of the costs would have broken it.
- **cure**, **cure, evenmesh**: the last two with what is said to be missing.

f is the weighted sum of the costs, shape the inverse mean ratio of cells (1 is ideal), area the total area relative to
the start's, cells that are turned over counting negative. The paper's stop criterion has a number eps that it does not
give; 1e-5 and, for Fig. 9, 1e-8 come to its numbers of iterations. Of the meshes from Fig. 12 on it shows pictures only:
ours look like them, so that numbers of iterations do not compare exactly.

Curves of convergence show how far f is above the least value that the run comes to; where a penalty or a multiplier
changes on the way, what is minimised until then has a least value of its own.
)";

std::string figure_range(const Plate& plate) {
  const bool two = plate.last_figure == plate.first_figure + 1;
  return fmt::format("Figs. {} {} {}", plate.first_figure, two ? "and" : "to", plate.last_figure);
}

std::string mesh_words(const Plate& plate) {
  return fmt::format("{} {}", plate.words,
                     plate.exact ? "The mesh is the paper's own, its disturbance ours."
                                 : "The mesh is a look-alike.");
}

// "Fig. 13a".
std::string figure_of(const Case& of) { return fmt::format("Fig. {}", of.id.substr(3)); }

std::string heading(const Case& of) {
  std::string text = fmt::format("{}: {}", figure_of(of), of.title);
  if (const std::string costs = cost_words(of.setup); of.setup.costs.size() > 1) {
    text += fmt::format(" ({})", costs);
  }
  return text;
}

// Sentences about a case, one after the other.
std::string lesson_of(const Exhibit& exhibit) {
  const Case& of = *exhibit.of;
  std::string text(of.lesson);
  const auto add = [&](const std::string& sentence) {
    if (!text.empty()) text += ' ';
    text += sentence;
  };
  if (!of.cure.costs.empty()) {
    add(fmt::format("The cure: {} ({}).", of.cure_words, cost_words(of.cure)));
  }
  if (!of.paper_words.empty()) add(fmt::format("The paper: {}.", of.paper_words));
  if (const double departure = exhibit.results.front().departure; departure > 0.01) {
    add(fmt::format("Free in space, vertices leave the sphere by up to {:.2f} of its radius.",
                    departure / kSheetRadius));
  }
  return text;
}

std::string in_markdown(const Exhibit& exhibit) {
  const Case& of = *exhibit.of;
  const std::string lesson = lesson_of(exhibit);
  return fmt::format(
      "\n### {}\n\n{}{}\n![{} before and after](pictures/gallery/{}.svg)\n\n"
      "![{} convergence](pictures/gallery/{}_convergence.svg)\n",
      heading(of), lesson.empty() ? "" : lesson + "\n\n",
      as_markdown(table_of(of, exhibit.results)), figure_of(of), of.id, figure_of(of), of.id);
}

// The mesh a case starts from, by its name in the folder of pictures.
std::string mesh_file_of(const Case& of) {
  return of.tangled ? fmt::format("{}.obj", of.id)
                    : fmt::format("fig{}.obj", plate_of(of.start).first_figure);
}

std::string as_obj(const Mesh& mesh) {
  std::string text;
  for (const Vec3& p : mesh.points()) text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  for (std::size_t c = 0; c < mesh.cells().size(); ++c) {
    text += 'f';
    for (const Index v : mesh.cells().vertices(c)) text += fmt::format(" {}", v + 1);
    text += '\n';
  }
  return text;
}

// Lines of at most a hundred characters, broken between words.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 100;
  std::string result;
  std::size_t length = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (length > 0) {
      const bool fits = length + 1 + (end - begin) <= kWidth;
      result += fits ? ' ' : '\n';
      length = fits ? length + 1 : 0;
    }
    result += text.substr(begin, end - begin);
    length += end - begin;
    begin = end + 1;
  }
  return result + '\n';
}

std::string starts_words() {
  return fmt::format(
      "{} random starts by the paper's method; errors are distances from the known "
      "optimum, 'at the end' with an eps of 1e-16:",
      kStarts);
}

}  // namespace

Exhibit make_exhibit(const Case& of) { return {&of, run_all_ways(of)}; }

Series make_series(Start start) {
  Series series;
  for (const Case& each : cases()) {
    if (each.start != start) continue;
    series.of.push_back(&each);
    series.medians.push_back(run_random_starts(each, Way::paper));
  }
  return series;
}

std::string text_of(const Exhibit& exhibit) {
  const Plate& plate = plate_of(exhibit.of->start);
  std::string text = fmt::format("{} - {}\n", heading(*exhibit.of), plate.title);
  text += wrapped(mesh_words(plate));
  if (const std::string lesson = lesson_of(exhibit); !lesson.empty()) text += wrapped(lesson);
  return text + as_text(table_of(*exhibit.of, exhibit.results)) + '\n';
}

std::string text_of(const Series& series) {
  return wrapped(starts_words()) + as_text(starts_table(series.of, series.medians)) + '\n';
}

std::string gallery_page(const std::vector<Exhibit>& exhibits, const std::vector<Series>& series) {
  std::string page(kPreface);
  auto next = series.begin();
  for (const Plate& plate : plates()) {
    page += fmt::format("\n## {}: {}\n\n{} As a file: [fig{}.obj](pictures/gallery/fig{}.obj).\n",
                        figure_range(plate), plate.title, mesh_words(plate), plate.first_figure,
                        plate.first_figure);
    if (plate.exact) {
      page += fmt::format("\n{}\n\n{}", starts_words(),
                          as_markdown(starts_table(next->of, next->medians)));
      ++next;
    }
    for (const Exhibit& exhibit : exhibits) {
      if (exhibit.of->start == plate.start) page += in_markdown(exhibit);
    }
  }
  return page;
}

void write_files(const Exhibit& exhibit, const std::filesystem::path& folder) {
  const std::string id(exhibit.of->id);
  write_text(folder / mesh_file_of(*exhibit.of), as_obj(start_mesh(*exhibit.of)));
  write_text(folder / (id + ".svg"), picture_of(*exhibit.of, exhibit.results));
  write_text(folder / (id + "_convergence.svg"), convergence_of(*exhibit.of, exhibit.results));
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) {
    throw IoError(fmt::format("{}: the folder cannot be made: {}", path.parent_path().string(),
                              error.message()));
  }
  OutputFile file(path);
  file.append(text);
  file.close();
  file.commit();
}

}  // namespace evenmesh::gallery
