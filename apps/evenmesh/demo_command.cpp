// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "apps/evenmesh/commands.h"
#include "apps/evenmesh/exit_code.h"
#include "apps/evenmesh/gallery/page.h"
#include "apps/evenmesh/gallery/tables.h"

namespace evenmesh::app {
namespace {

using gallery::Case;
using gallery::Exhibit;
using gallery::Series;

// What the words ask for, each case once, in the order of the gallery.
std::vector<const Case*> chosen(const std::vector<std::string>& words) {
  std::vector<const Case*> found;
  for (const std::string& word : words) {
    for (const Case* each : gallery::find_cases(word)) found.push_back(each);
  }
  std::sort(found.begin(), found.end());  // they lie in one table
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// True for the last of the chosen cases of an exact mesh, after which its random starts follow.
bool ends_series(const std::vector<const Case*>& all, std::size_t i) {
  if (!gallery::plate_of(all[i]->start).exact) return false;
  return i + 1 == all.size() || all[i + 1]->start != all[i]->start;
}

}  // namespace

int demo_command(const DemoArguments& arguments, const Console& console) {
  if (arguments.figures == std::vector<std::string>{"list"}) {
    print(gallery::as_text(gallery::list_of_cases()));
    console.say("'demo fig13a' runs one, 'demo fig13' all of a figure, 'demo all' every one");
    return kDone;
  }
  const bool few = arguments.figures.empty();
  const std::vector<const Case*> all =
      chosen(few ? std::vector<std::string>{"fig5", "fig7", "fig9"} : arguments.figures);
  const bool page = all.size() == gallery::cases().size();
  const std::filesystem::path folder = arguments.folder;

  std::vector<Exhibit> exhibits;
  std::vector<Series> series;
  for (std::size_t i = 0; i < all.size(); ++i) {
    exhibits.push_back(gallery::make_exhibit(*all[i]));
    print(text_of(exhibits.back()));
    if (!arguments.folder.empty()) {
      write_files(exhibits.back(), page ? folder / "pictures" / "gallery" : folder);
    }
    if (!ends_series(all, i)) continue;
    series.push_back(gallery::make_series(all[i]->start));
    print(text_of(series.back()));
  }
  if (arguments.folder.empty()) {
    console.say(few ? "'demo list' names the other figures; -o FOLDER writes meshes and pictures"
                    : "-o FOLDER writes the start meshes, pictures of them and of convergence");
  } else if (page) {
    gallery::write_text(folder / "gallery.md", gallery_page(exhibits, series));
    console.say(fmt::format("wrote {}", (folder / "gallery.md").string()));
  } else {
    console.say(fmt::format("wrote meshes and pictures into {}", arguments.folder));
  }
  return kDone;
}

}  // namespace evenmesh::app
