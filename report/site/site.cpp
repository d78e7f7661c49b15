#include "report/site/site.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "reference/files.hpp"
#include "report/charts/drawing.hpp"
#include "report/site/data.hpp"
#include "report/site/errata.hpp"
#include "report/site/evidence_pages.hpp"
#include "report/site/example.hpp"
#include "report/site/exercise_page.hpp"
#include "report/site/front_page.hpp"
#include "report/site/further_pages.hpp"
#include "report/site/lesson.hpp"
#include "report/site/own_page.hpp"
#include "report/site/page.hpp"
#include "report/site/players.hpp"
#include "report/site/recipes.hpp"
#include "report/site/single.hpp"
#include "report/study/embedded.hpp"

namespace oddity {

namespace fs = std::filesystem;

std::map<std::string, std::string> site_pages(const Results& results, const ProvedClaims& proved,
                                              const SiteParts& parts, std::span<const EngineContest> contests,
                                              const Trust& trust) {
  std::map<std::string, std::string> pages{
      {"index.html", front_page(results, parts)},        {"errata.html", errata_page(results)},
      {"chooser.html", chooser_page(results, parts)},    {"lesson.html", lesson_page(results, parts)},
      {"recipes.html", recipes_page(results)},           {"algorithms.html", algorithms_page()},
      {"trust.html", trust_html(results, trust)},        {"stability.html", stability_html(results)},
      {"engines.html", engines_html(results, contests)}, {"own.html", own_page(parts)}};
  for (const ExerciseResult& e : results.exercises)
    pages[to_string(e.number) + ".html"] = exercise_page(results, e, proved, contests);
  pages[example_name + std::string(".html")] = example_page(example_result());
  if (!lacks(parts).empty())
    for (auto& [name, page] : pages) html::note_missing(page, lacks(parts), command_for(parts));
  return pages;
}

namespace {

/// The page with its files within it; those in data/ are `data`.
std::string whole_in_one_file(std::string page, const std::function<std::string()>& data) {
  const SiteParts parts = parts_at_hand();
  if (!lacks(parts).empty()) html::note_missing(page, lacks(parts), command_for(parts));
  return in_one_file(page, [&](const std::string& file) {
    if (file.starts_with("data/")) return data();
    if (file == "assets/drawing.css") return std::string(drawing_style());
    if (file == "assets/models.js") return module_script();
    if (file == "assets/own.js") return own_script();
    const auto asset =
        std::ranges::find(embedded_assets(), file.substr(file.find('/') + 1), &EmbeddedFile::path);
    if (asset == embedded_assets().end()) throw std::logic_error("the site has no file " + file);
    return std::string(asset->text);
  });
}

}  // namespace

std::string single_page(const Results& results, const ExerciseResult& e, const Reference& truth,
                        std::span<const EngineContest> contests, const ProvedClaims& proved) {
  return whole_in_one_file(exercise_page(results, e, proved, contests),
                           [&] { return exercise_data(e, truth, Styles(results), !has_module(), contests); });
}

std::string own_in_one_file(const OwnFile& file) {
  return whole_in_one_file(own_page(parts_at_hand(), file), [&] { return own_examples(file); });
}

fs::path write_site(const Results& results, const Reference& truth, const fs::path& folder,
                    const Progress& progress, std::span<const EngineContest> contests, const Trust& trust) {
  const ProvedClaims& proved = trust.standings.proved();
  for (const char* room : {"", "assets", "data"}) require_writable_folder(folder / room);
  for (const auto& [name, text] : site_pages(results, proved, parts_at_hand(), contests, trust))
    write_whole(folder / name, text);
  write_whole(folder / "errata.json", errata_json(results));
  write_whole(folder / "errata.schema.json", errata_schema());
  const Styles styles(results);
  std::size_t written = 0;
  for (const ExerciseResult& e : results.exercises) {
    if (progress) progress("writing the site", static_cast<double>(written++), results.exercises.size());
    write_whole(folder / "data" / (to_string(e.number) + ".js"),
                exercise_data(e, truth, styles, !has_module(), contests));
  }
  write_whole(folder / "data" / (example_name + std::string(".js")),
              example_data(example_result(), !has_module()));
  write_whole(folder / "data" / "scenes.js", scenes_data(results, styles));
  write_whole(folder / "data" / "search.js", search_index(results));
  for (const EmbeddedFile& asset : embedded_assets())
    write_whole(folder / "assets" / asset.path, std::string(asset.text));
  write_whole(folder / "assets" / "drawing.css", std::string(drawing_style()));
  write_whole(folder / "assets" / "models.js", module_script());
  write_whole(folder / "assets" / "own.js", own_script());
  write_whole(folder / "data" / "problems.js", own_examples());
  return folder / "index.html";
}

}  // namespace oddity
