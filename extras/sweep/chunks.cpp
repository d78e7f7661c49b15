#include "extras/sweep/chunks.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
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
#include "report/study/sibling_program.hpp"
#include "report/text/screen.hpp"

namespace oddity::sweep {

namespace {

namespace fs = std::filesystem;

std::string head_of(const Plan& plan, std::size_t chunk) {
  return plan.fingerprint + "\nchunk " + std::to_string(chunk) + "\n";
}

/// Adds a line for the tile; then from below, row after row, one for each computed cell, and one for each run
/// of the others.
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

/// A chunk's lines in order, with their numbers.
class Lines {
 public:
  Lines(const std::string& text, std::string place) : in_(text), place_(std::move(place)) {}

  std::string next() {
    std::string line;
    ++number_;
    if (!std::getline(in_, line)) refuse("a line is missing");
    return line;
  }
  void require_end() {
    ++number_;
    if (in_.peek() != std::istringstream::traits_type::eof()) refuse("there is more than the chunk's cells");
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw BadInput(place_ + ":" + std::to_string(number_) + ": no chunk as a sweep writes it: " + why +
                   "; remove the file, and '" + program_as_typed() + " sweep run' makes it again");
  }

 private:
  std::istringstream in_;
  std::string place_;
  long number_ = 0;
};

/// The next line: three words and the rest.
struct Line {
  const Lines& lines;
  std::array<std::string, 3> words;
  std::string rest;

  explicit Line(Lines& in) : lines(in) {
    std::istringstream text(in.next());
    for (std::string& word : words)
      if (!(text >> word)) in.refuse("the line is short");
    std::getline(text >> std::ws, rest);
  }
  /// NaN if a cell ends without a number.
  double number(std::size_t i) const {
    const auto x = parse_number(words[i]);
    if (!x || *x < 0) lines.refuse("'" + cut(words[i], 40) + "' is no error and no count");
    return *x;
  }
  long whole(std::size_t i, double most) const {
    const auto x = parse_number(words[i]);
    if (!x || !(0 <= *x && *x <= most) || *x != std::floor(*x))
      lines.refuse("'" + cut(words[i], 40) + "' is no number of cells");
    return static_cast<long>(*x);
  }
};

/// Whether a cell may end so: with an outcome of a method, or with the chosen model's and algorithm's name.
bool is_ending(const Asked& asked, const std::string& as) {
  if (as == no_truth) return true;
  if (asked.algorithm.empty()) {
    const auto is_of_names = [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != 0x7f; };
    return as == nothing_holds ||
           (as.size() <= 200 && as.find(", ") != std::string::npos &&
            std::isalpha(static_cast<unsigned char>(as[0])) != 0 && std::ranges::all_of(as, is_of_names));
  }
  if (as == no_method) return true;
  using enum Outcome;
  const std::array outcomes{ok,      inaccurate, drifted, diverged,   non_finite,
                            stalled, deceived,   raised,  chattering, grazing};
  return std::ranges::find(outcomes, as, [](Outcome o) { return name_of(o); }) != outcomes.end();
}

/// Whether a cell with this ending may have such an error, in tolerances. The outcome follows from the error,
/// unless the method gave up.
bool is_error_of(const Asked& asked, const std::string& as, double error) {
  if (as == no_truth || as == no_method || as == nothing_holds) return std::isnan(error);
  if (asked.algorithm.empty() || as == name_of(Outcome::ok)) return error <= 1;
  if (as == name_of(Outcome::inaccurate) || as == name_of(Outcome::diverged)) return error > 1;
  return (as != name_of(Outcome::drifted) && as != name_of(Outcome::deceived)) || !std::isnan(error);
}

Ended ended_of(const Line& line, const Asked& asked) {
  const Ended ended{line.rest, line.number(1), line.number(2)};
  const bool was_run = ended.as != no_truth && ended.as != no_method && ended.as != nothing_holds;
  if (!is_error_of(asked, ended.as, ended.error) || std::isfinite(ended.evaluations) != was_run)
    line.lines.refuse("'" + ended.as + "' does not come of an error of " + format_shortest(ended.error) +
                      " needs and " + format_shortest(ended.evaluations) + " evaluations");
  return ended;
}

Tile read_tile(Lines& in, const Cells& cells, const Asked& asked) {
  const auto count = static_cast<std::size_t>(cells.width()) * static_cast<std::size_t>(cells.height());
  Tile tile{cells, {}, {}};
  const Line head(in);
  if (head.words[0] != "tile" || !head.rest.empty()) in.refuse("it does not begin a tile");
  tile.checked = head.whole(1, static_cast<double>(count));
  tile.otherwise = head.whole(2, static_cast<double>(tile.checked));
  while (tile.ended.size() < count) {
    const Line line(in);
    if (!is_ending(asked, line.rest)) in.refuse("no cell ends as '" + cut(line.rest, 40) + "'");
    const bool looked = line.words[1] != "-" || line.words[2] != "-";
    const Ended ended = looked ? ended_of(line, asked) : Ended{line.rest};
    const long run = line.whole(0, looked ? 1 : static_cast<double>(count - tile.ended.size()));
    if (run == 0) in.refuse("a line is of no cell");
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
  const auto text = read_sealed(file, Whose::anybodys);  // several users may share a sweep
  if (!text) return {};
  const std::string head = head_of(plan, chunk);
  if (!text->starts_with(head)) throw BadInput(file.string() + " is of another sweep");
  Lines lines(*text, file.string());
  for (long i = std::ranges::count(head, '\n'); i > 0; --i) lines.next();
  std::vector<Tile> tiles;
  for (long tile = plan.first_tile[chunk]; tile < plan.first_tile[chunk + 1]; ++tile)
    tiles.push_back(read_tile(lines, plan.tile(tile), plan.asked));
  lines.require_end();
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
