#include "report/pages/write_report.hpp"

#include "reference/files.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/gnuplot.hpp"
#include "report/pages/catalog_page.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/readable.hpp"
#include "report/study/ledger.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The pictures of one chapter, or of all (0) and then by time too.
void draw_charts(const Results& results, int chapter, const fs::path& folder, const Progress& progress) {
  const Styles styles(results);
  std::vector<Picture> pictures;
  for (const ExerciseResult& e : results.exercises) {
    const std::string exercise = to_string(e.number) + " " + e.title + ": ";
    if (chapter == 0 && e.stability)
      pictures.push_back({folder / map_file(e),
                          [&e](const fs::path& into) { return map_script(e, into.string()); }, map_title(e)});
    if (chapter != 0 && e.number.chapter != chapter) continue;
    for (const QuantityResult& q : e.quantities) {
      const std::string title = exercise + readable(q.says) + (q.samples > 1 ? " (" + instants(q) + ")" : "");
      if (q.trajectory)
        pictures.push_back(
            {folder / trajectory_file(e, q),
             [&q, &styles, title](const fs::path& into) { return trajectory_script(q, title, into, styles); },
             title + ". " + motion_finding(q)});
      for (Across across : charts_of(q))
        if (chapter == 0 || across != Across::time)
          pictures.push_back({folder / chart_file(e, q, across),
                              [&q, &styles, title, across](const fs::path& into) {
                                return chart_script(q, title, across, into, styles);
                              },
                              title + ". " + finding(q, across)});
    }
    for (const auto& series : series_of(e))
      pictures.push_back({folder / series_file(e, *series.front()),
                          [series, &styles, exercise](const fs::path& into) {
                            return series_script(series, exercise + "work over size", into, styles);
                          },
                          exercise + "work over size"});
  }
  constexpr std::size_t at_once = 40;
  for (std::size_t done = 0; done < pictures.size(); done += at_once) {
    if (progress) progress("drawing the charts", done, pictures.size());
    const std::size_t end = std::min(done + at_once, pictures.size());
    draw({pictures.begin() + static_cast<std::ptrdiff_t>(done),
          pictures.begin() + static_cast<std::ptrdiff_t>(end)});
  }
}

}  // namespace

void make_folder(const fs::path& folder) {
  require_writable_folder(folder);
  require_writable_folder(folder / "charts");
}

fs::path write_report(const Results& results, int chapter, const fs::path& folder, const Progress& progress) {
  make_folder(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    write_whole(folder / name, text);
    return folder / name;
  };
  draw_charts(results, chapter, folder, progress);
  if (chapter != 0) return write(chapter_file(chapter), chapter_page(results, chapter));
  for (const Chapter& c : chapters())
    if (c.last_odd > 0 || std::ranges::any_of(results.exercises, [&](const ExerciseResult& e) {
          return e.number.chapter == c.number;
        }))
      write(chapter_file(c.number), chapter_page(results, c.number));
  write("algorithms.md", catalog_page());
  write("models.md", ledger_page(results));
  write("stability.md", stability_page(results));
  write("times.md", times_page(results));
  return write("README.md", index_page(results));
}

std::vector<fs::path> write_charts(const Results& results, const fs::path& folder, const Progress& progress) {
  make_folder(folder);
  draw_charts(results, 0, folder, progress);
  std::vector<fs::path> pages;
  for (const ExerciseResult& e : results.exercises) {
    pages.push_back(folder / (to_string(e.number) + ".md"));
    write_whole(pages.back(), charts_page(e));
  }
  return pages;
}

}  // namespace oddity
