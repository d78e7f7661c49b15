#include "report/pages/write_report.hpp"

#include "reference/files.hpp"
#include "report/pages/catalog_page.hpp"
#include "report/pages/cheapest_models_view.hpp"
#include "report/pages/pictures.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/trust.hpp"
#include "report/study/cheapest_models.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  require_writable_folder(folder);
  require_writable_folder(folder / "charts");
}

fs::path write_report(const Results& results, Edition edition, const fs::path& folder,
                      const Progress& progress, const Trust& trust) {
  make_folder(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    write_whole(folder / name, text);
    return folder / name;
  };
  draw_pictures(results, folder, progress);
  for (const ExerciseResult& e : results.exercises)
    write(exercise_file(e.number), exercise_page_text(results, e, trust.standings.proved()));
  write("errata.md", errata_page_text(results));
  write("algorithms.md", catalog_page());
  write("trust.md", trust_page(results, trust));
  write("models.md", cheapest_models_page(results));
  write("stability.md", stability_page(results));
  if (edition == Edition::whole) write("times.md", times_page(results));
  return write("README.md", index_page(results, edition));
}

std::vector<fs::path> write_charts(const Results& results, Curves curves, const fs::path& folder,
                                   const Progress& progress) {
  make_folder(folder);
  std::vector<fs::path> pages;
  for (const ExerciseResult& e : results.exercises) {
    if (progress) progress(drawing_charts, static_cast<double>(pages.size()), results.exercises.size());
    draw_charts(e, curves, results.seam, folder);
    pages.push_back(folder / exercise_file(e.number));
    write_whole(pages.back(), charts_page(e));
  }
  return pages;
}

}  // namespace oddity
