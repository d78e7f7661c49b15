#include "report/site/site.hpp"

#include <map>

#include "reference/files.hpp"
#include "report/site/data.hpp"
#include "report/site/exercise_page.hpp"
#include "report/site/formulas.hpp"
#include "report/site/front_page.hpp"
#include "report/site/players.hpp"

namespace oddity {

namespace fs = std::filesystem;

fs::path write_site(const Results& results, const Reference& truth, const fs::path& folder) {
  for (const char* room : {"", "assets", "data"}) require_writable_folder(folder / room);
  std::map<std::string, std::string> pages{{"index.html", front_page(results)}};
  for (const ExerciseResult& e : results.exercises) pages[to_string(e.number) + ".html"] = exercise_page(e);
  html::typeset(pages);
  for (const auto& [name, text] : pages) write_whole(folder / name, text);
  const Styles styles(results);
  const auto models = module_script();
  for (const ExerciseResult& e : results.exercises)
    write_whole(folder / "data" / (to_string(e.number) + ".js"), exercise_data(e, truth, styles, !models));
  write_whole(folder / "data" / "scenes.js", scenes_data(results, styles));
  for (const EmbeddedFile& asset : embedded_assets())
    write_whole(folder / "assets" / asset.path, std::string(asset.text));
  if (models) write_whole(folder / "assets" / "models.js", *models);
  return folder / "index.html";
}

}  // namespace oddity
