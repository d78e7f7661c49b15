#include "extras/sweep/merge.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/charts/chart_parts.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/numbers.hpp"

namespace oddity::sweep {

namespace {

namespace fs = std::filesystem;

/// The folder that contains the chunk.
const fs::path& folder_of(const std::vector<fs::path>& folders, std::size_t chunk) {
  const fs::path* found = nullptr;
  for (const fs::path& folder : folders) {
    if (!fs::exists(chunk_file(folder, chunk))) continue;
    if (found)
      throw BadInput("chunk " + std::to_string(chunk) + " is there twice: " +
                     chunk_file(*found, chunk).string() + " and " + chunk_file(folder, chunk).string());
    found = &folder;
  }
  if (!found)
    throw BadInput("chunk " + std::to_string(chunk) + " is missing: '" + program_as_typed() +
                   " sweep run' makes the missing ones");
  return *found;
}

void require_folders(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders)
    if (!fs::is_directory(folder))
      throw BadInput("there is no folder " + folder.string() +
                     ": name those that have the sweep's chunks, each with its folder 'chunks'");
}

/// Throws if a folder has a chunk that is not in the plan.
void require_no_other(const Plan& plan, const std::vector<fs::path>& folders) {
  std::set<fs::path> names;
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk) names.insert(chunk_file({}, chunk).filename());
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder / "chunks")) continue;
    for (const auto& file : fs::directory_iterator(folder / "chunks"))
      if (file.path().extension() == ".txt" && !names.contains(file.path().filename()))
        throw BadInput(file.path().string() + " is no chunk of this sweep");
  }
}

std::vector<Tile> tiles_of(const Plan& plan, const fs::path& folder, std::size_t chunk) {
  auto tiles = kept(folder, plan, chunk);
  if (!tiles)
    throw BadInput(chunk_file(folder, chunk).string() + " is damaged: '" + program_as_typed() +
                   " sweep run' makes it again");
  return *std::move(tiles);
}

/// Until all endings are known, they are numbered in the order of their first cells.
class Merging {
 public:
  explicit Merging(Map& map) : map_(map) {}

  void add(const Tile& tile) {
    map_.checked += tile.checked;
    map_.otherwise += tile.otherwise;
    for (int y = tile.cells.first_y; y <= tile.cells.last_y; ++y)
      for (int x = tile.cells.first_x; x <= tile.cells.last_x; ++x) {
        const std::size_t from = tile.place(x, y), to = map_.place(x, y);
        map_.ended[to] = place_of(tile.ended[from].as);
        map_.error[to] = tile.ended[from].error;
        map_.evaluations[to] = tile.ended[from].evaluations;
        map_.looked[to] = tile.looked[from];
      }
  }

  void sort() {
    std::vector<std::uint16_t> sorted(places_.size());
    for (const auto& [name, place] : places_) {
      sorted[place] = static_cast<std::uint16_t>(map_.endings.size());
      map_.endings.push_back(name);
    }
    for (std::uint16_t& place : map_.ended) place = sorted[place];
  }

 private:
  std::uint16_t place_of(const std::string& name) {
    const auto [found, is_new] = places_.try_emplace(name, static_cast<std::uint16_t>(places_.size()));
    if (is_new && places_.size() > 65'536) throw BadInput("more than 65,536 different endings");
    return found->second;
  }

  Map& map_;
  std::map<std::string, std::uint16_t> places_;
};

}  // namespace

Map merged(const Plan& plan, const std::vector<fs::path>& folders) {
  require_folders(folders);
  require_no_other(plan, folders);
  Map map{plan.asked, plan.fingerprint, plan.width(), plan.height(), {}, {}, {}, {}, {}};
  const auto cells = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  map.ended.resize(cells);
  map.looked.resize(cells);
  map.error.resize(cells);
  map.evaluations.resize(cells);
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk) folder_of(folders, chunk);
  Merging merging(map);
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk)
    for (const Tile& tile : tiles_of(plan, folder_of(folders, chunk), chunk)) merging.add(tile);
  merging.sort();
  return map;
}

std::string summary(const Map& map) {
  const auto cells = static_cast<long>(map.ended.size()), looked = std::ranges::count(map.looked, 1);
  std::string text = with_commas(cells) + " cells";
  if (looked == cells) return text + ", all of them looked at";
  text += ", " + percent(static_cast<double>(looked) / static_cast<double>(cells)) + " of them looked at; ";
  if (map.checked == 0) return text + "none of the others was checked";
  return text + (map.otherwise == 0 ? "none" : with_commas(map.otherwise)) + " of " +
         with_commas(map.checked) + " checked between them ended otherwise";
}

Table cells_table(const Map& map) {
  Table table;
  for (const Axis& axis : map.asked.axes)
    table.columns.push_back(axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"));
  for (const char* column : {"ended", "error in needs", "evaluations", "looked at"})
    table.columns.emplace_back(column);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t place = map.place(x, y);
      std::vector<Cell> row{map.asked.axes[0].at(x)};
      if (map.asked.axes.size() == 2) row.emplace_back(map.asked.axes[1].at(y));
      row.emplace_back(map.endings[map.ended[place]]);
      row.emplace_back(map.error[place]);
      row.emplace_back(map.evaluations[place]);
      row.emplace_back(static_cast<long>(map.looked[place]));
      table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace oddity::sweep
