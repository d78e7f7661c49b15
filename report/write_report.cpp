#include "report/write_report.hpp"

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/catalog_page.hpp"
#include "report/chart.hpp"
#include "report/ledger.hpp"
#include "report/markdown.hpp"
#include "report/stability.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The pictures of one chapter, or of all (0) and then by time too.
void draw_charts(const Results& results, int chapter, const fs::path& folder) {
  std::vector<std::string> scripts;
  std::vector<fs::path> files;
  const auto part = [&](const std::string& name) {
    files.push_back(folder / name);
    return files.back().string() + ".part";
  };
  for (const ExerciseResult& e : results.exercises) {
    if (chapter == 0 && e.stability) scripts.push_back(map_script(e, part(map_file(e))));
    for (const QuantityResult& q : e.quantities) {
      if (chapter != 0 && e.number.chapter != chapter) continue;
      const std::string title = to_string(e.number) + " " + e.title + ": " + q.name;
      if (q.trajectory) scripts.push_back(trajectory_script(q, title, part(trajectory_file(e, q))));
      if (!has_chart(q)) continue;
      for (Cost kind : {Cost::evaluations, Cost::time})
        if (chapter == 0 || kind == Cost::evaluations)
          scripts.push_back(chart_script(q, title, kind, part(chart_file(e, q, kind))));
    }
  }
  draw(scripts);
  for (const fs::path& file : files) fs::rename(file.string() + ".part", file);
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "charts", error);
  if (error)
    throw BadInput("cannot make the folder " + (folder / "charts").string() + ": " + error.message());
}

fs::path write_report(const Results& results, int chapter, const fs::path& folder) {
  make_folder(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    write_whole(folder / name, text);
    return folder / name;
  };
  draw_charts(results, chapter, folder);
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

std::vector<fs::path> write_charts(const Results& results, const fs::path& folder) {
  make_folder(folder);
  draw_charts(results, 0, folder);
  std::vector<fs::path> pages;
  for (const ExerciseResult& e : results.exercises) {
    pages.push_back(folder / (to_string(e.number) + ".md"));
    write_whole(pages.back(), charts_page(e));
  }
  return pages;
}

}  // namespace oddity
