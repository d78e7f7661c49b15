#include "report/sweep/chunks.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numeric>
#include <sstream>
#include <thread>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/study/parallel.hpp"

namespace oddity::sweep {

namespace {

namespace fs = std::filesystem;

std::string head_of(const Plan& plan, std::size_t chunk) {
  return plan.fingerprint + "\nchunk " + std::to_string(chunk) + "\n";
}

/// A line for the tile; then from below, row after row, one for each cell looked at, and one for each run of
/// the others.
void add(std::string& text, const Tile& tile) {
  const Cells& c = tile.cells;
  text += "tile " + std::to_string(tile.checked) + " " + std::to_string(tile.otherwise) + "\n";
  for (int y = c.first_y; y <= c.last_y; ++y)
    for (int x = c.first_x; x <= c.last_x;) {
      const Ended& ended = tile.ended[tile.place(x, y)];
      if (tile.looked[tile.place(x, y)]) {
        text += "1 " + format_shortest(ended.error) + " " + format_shortest(ended.evaluations) + " " +
                ended.as + "\n";
        ++x;
        continue;
      }
      int run = 0;
      while (x + run <= c.last_x && !tile.looked[tile.place(x + run, y)] &&
             tile.ended[tile.place(x + run, y)].as == ended.as)
        ++run;
      text += std::to_string(run) + " - - " + ended.as + "\n";
      x += run;
    }
}

/// The next line's words; throws when it has too few.
struct Line {
  std::vector<std::string> words;
  std::string rest;

  Line(std::istream& in, int count) {
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error("a line is missing");
    std::istringstream text(line);
    words.resize(static_cast<std::size_t>(count));
    for (std::string& word : words)
      if (!(text >> word)) throw std::runtime_error("a line is short: " + line);
    std::getline(text >> std::ws, rest);
  }
  double number(std::size_t i) const {
    if (const auto x = parse_number(words[i])) return *x;
    throw std::runtime_error("'" + words[i] + "' is no number");
  }
  long whole(std::size_t i, double most) const {
    const double x = number(i);
    if (0 <= x && x <= most && x == std::floor(x)) return static_cast<long>(x);
    throw std::runtime_error("'" + words[i] + "' is no number of cells");
  }
};

Tile read_tile(std::istream& in, const Cells& cells) {
  const auto count = static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height());
  Tile tile{cells, {}, {}};
  const Line head(in, 3);
  tile.checked = head.whole(1, static_cast<double>(count));
  tile.otherwise = head.whole(2, static_cast<double>(count));
  while (tile.ended.size() < count) {
    const Line line(in, 3);
    const bool looked = line.words[1] != "-";
    const Ended ended = looked ? Ended{line.rest, line.number(1), line.number(2)} : Ended{line.rest};
    const long run = line.whole(0, static_cast<double>(count - tile.ended.size()));
    for (long i = 0; i < run; ++i) {
      tile.ended.push_back(ended);
      tile.looked.push_back(looked);
    }
  }
  return tile;
}

}  // namespace

fs::path plan_file(const fs::path& folder) { return folder / "plan.json"; }

fs::path chunk_file(const fs::path& folder, std::size_t chunk) {
  const std::string number = std::to_string(chunk);
  return folder / "chunks" / (std::string(number.size() < 6 ? 6 - number.size() : 0, '0') + number + ".txt");
}

std::vector<Tile> worked_out(const Plan& plan, std::size_t chunk, const Look& look,
                             const std::function<void()>& tick) {
  const bool every_cell = looks_at_every_cell(plan.asked);
  std::vector<Tile> tiles;
  for (long tile = plan.first_tile[chunk]; tile < plan.first_tile[chunk + 1]; ++tile) {
    if (tick) tick();
    tiles.push_back(every_cell ? all_looked_at(plan.tile(tile), look) : quartered(plan.tile(tile), look));
  }
  return tiles;
}

void keep(const fs::path& folder, const Plan& plan, std::size_t chunk, const std::vector<Tile>& tiles) {
  std::string text = head_of(plan, chunk);
  for (const Tile& tile : tiles) add(text, tile);
  write_sealed(chunk_file(folder, chunk), text);
}

std::optional<std::vector<Tile>> kept(const fs::path& folder, const Plan& plan, std::size_t chunk) {
  const fs::path file = chunk_file(folder, chunk);
  const auto text = read_sealed(file);
  if (!text) return {};
  const std::string head = head_of(plan, chunk);
  if (!text->starts_with(head)) throw BadInput(file.string() + " is of another sweep");
  std::istringstream in(text->substr(head.size()));
  std::vector<Tile> tiles;
  try {
    for (long tile = plan.first_tile[chunk]; tile < plan.first_tile[chunk + 1]; ++tile)
      tiles.push_back(read_tile(in, plan.tile(tile)));
  } catch (const std::runtime_error& error) {
    throw BadInput(file.string() + " is no chunk as a sweep writes it: " + error.what() + "; remove it");
  }
  return tiles;
}

std::vector<std::size_t> missing(const fs::path& folder, const Plan& plan) {
  std::vector<std::size_t> chunks;
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk)
    if (!kept(folder, plan, chunk)) chunks.push_back(chunk);
  std::ranges::stable_sort(chunks, std::greater(), [&](std::size_t chunk) { return plan.seconds[chunk]; });
  return chunks;
}

std::vector<std::size_t> dealt(const Plan& plan, const std::vector<std::size_t>& chunks, const Shard& shard) {
  std::vector<std::size_t> order(plan.chunks());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t chunk) { return plan.seconds[chunk]; });
  std::vector<std::size_t> mine;
  for (std::size_t i = shard.number - 1; i < order.size(); i += shard.of)
    if (std::ranges::find(chunks, order[i]) != chunks.end()) mine.push_back(order[i]);
  return mine;
}

void work_through(const fs::path& folder, const Plan& plan, const std::vector<std::size_t>& chunks,
                  int threads, const Reference& truth, const Progress& progress) {
  Stage stage(progress, "chunks", chunks.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr first;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < chunks.size(); i = next++) {
        const Look look = looks_at(plan.asked, truth);
        keep(folder, plan, chunks[i], worked_out(plan, chunks[i], look, [&] { stage.beat(); }));
        stage.add();
      }
    } catch (...) {
      next = chunks.size();
      const std::lock_guard lock(mutex);
      if (!first) first = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others(static_cast<std::size_t>(threads - 1));
    for (std::jthread& thread : others) thread = std::jthread(work);
    work();
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace oddity::sweep
