#include "report/write_report.hpp"

#include <fstream>
#include <iterator>
#include <string_view>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/catalog_page.hpp"
#include "report/chart.hpp"
#include "report/gnuplot.hpp"
#include "report/ledger.hpp"
#include "report/markdown.hpp"
#include "report/stability.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// What a viewer shows of a picture as a whole, in place of gnuplot's name.
void set_title(const fs::path& svg, const std::string& title) {
  std::ifstream in(svg, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  constexpr std::string_view gnuplots = "<title>Gnuplot</title>";
  if (const auto at = text.find(gnuplots); at != std::string::npos)
    text.replace(at, gnuplots.size(), "<title>" + in_xml(title) + "</title>");
  write_whole(svg, text);
}

/// Pictures yet to be drawn, in files that have a name of their own until they are whole.
class Pictures {
 public:
  explicit Pictures(const fs::path& folder) : folder_(folder) {}

  /// script(file) draws it.
  template <class Script>
  void add(const std::string& name, const std::string& title, const Script& script) {
    files_.emplace_back(folder_ / name, title);
    scripts_.push_back(script(part(files_.back().first)));
  }
  void finish() const {
    draw(scripts_);
    for (const auto& [file, title] : files_) {
      set_title(part(file), title);
      fs::rename(part(file), file);
    }
  }

 private:
  static std::string part(const fs::path& file) { return file.string() + ".part"; }

  fs::path folder_;
  std::vector<std::pair<fs::path, std::string>> files_;
  std::vector<std::string> scripts_;
};

/// The pictures of one chapter, or of all (0) and then by time too.
void draw_charts(const Results& results, int chapter, const fs::path& folder) {
  const Styles styles(results);
  Pictures pictures(folder);
  for (const ExerciseResult& e : results.exercises) {
    const std::string exercise = to_string(e.number) + " " + e.title + ": ";
    if (chapter == 0 && e.stability)
      pictures.add(map_file(e), map_title(e), [&](const std::string& file) { return map_script(e, file); });
    if (chapter != 0 && e.number.chapter != chapter) continue;
    for (const QuantityResult& q : e.quantities) {
      const std::string title = exercise + q.says;
      const auto chart = [&](Across across) {
        pictures.add(chart_file(e, q, across), title + ". " + finding(q, across),
                     [&](const std::string& file) { return chart_script(q, title, across, file, styles); });
      };
      if (q.trajectory)
        pictures.add(trajectory_file(e, q), title + ". " + motion_finding(q),
                     [&](const std::string& file) { return trajectory_script(q, title, file, styles); });
      for (Across across : charts_of(q))
        if (chapter == 0 || across != Across::time) chart(across);
    }
    for (const auto& series : series_of(e))
      pictures.add(series_file(e, *series.front()), exercise + "work over size",
                   [&](const std::string& file) {
                     return series_script(series, exercise + "work over size", file, styles);
                   });
  }
  pictures.finish();
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
