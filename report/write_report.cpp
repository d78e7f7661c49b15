#include "report/write_report.hpp"

#include "reference/bad_input.hpp"
#include "report/chart.hpp"
#include "report/markdown.hpp"
#include "report/stability.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

void draw_charts(const Results& results, int chapter, const fs::path& folder) {
  std::vector<std::string> scripts;
  std::vector<fs::path> files;
  for (const ExerciseResult& e : results.exercises) {
    if (chapter == 0 && e.stability) {
      files.push_back(folder / map_file(e));
      scripts.push_back(map_script(e, files.back().string() + ".part"));
    }
    for (const QuantityResult& q : e.quantities)
      if ((chapter == 0 || e.number.chapter == chapter) && has_chart(q)) {
        files.push_back(folder / chart_file(e, q));
        scripts.push_back(chart_script(q, to_string(e.number) + " " + e.title + ": " + q.name,
                                       files.back().string() + ".part"));
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
    if (c.last_odd > 0) write(chapter_file(c.number), chapter_page(results, c.number));
  write("stability.md", stability_page(results));
  write("times.md", times_page(results));
  return write("README.md", index_page(results));
}

}  // namespace oddity
