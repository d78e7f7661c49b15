#include "report/pages/engines_page.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "reference/text.hpp"
#include "report/charts/engines_chart.hpp"
#include "report/pages/engines_tables.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The first row names the columns; those from `numbers` on are set to the right.
std::string as_table(const Rows& rows, std::size_t numbers) {
  Rows cells;
  for (const auto& row : rows) {
    cells.emplace_back();
    for (const std::string& cell : row) cells.back().push_back(escaped(cell));
  }
  std::string right;
  for (std::size_t i = numbers; i < rows.front().size(); ++i) right += static_cast<char>('0' + i);
  return table(cells.front(), {cells.begin() + 1, cells.end()}, right);
}

std::string picture_name(const std::string& scene) { return "engines/" + file_name(scene) + ".svg"; }

const std::vector<OwnSteps>& own_in(const OwnByScene& own, const std::string& scene) {
  static const std::vector<OwnSteps> none;
  const auto found = own.find(scene);
  return found == own.end() ? none : found->second;
}

// ---- all scenes -------------------------------------------------------------------------------------------

/// From which rate on an engine's defaults are enough.
std::string rate_cell(const EngineContest& contest, const EngineSeries& s) {
  if (!s.cannot.empty()) return "";
  if (const EngineTrial* first = s.first_enough())
    return format_significant(first->steps_per_frame * contest.frames_per_second, 6);
  return why_never(contest, s).empty() ? "finer" : "never";
}

std::string enough_table(const std::vector<EngineContest>& contests) {
  Rows rows{{"defaults of"}};
  std::vector<std::pair<std::string, bool>> engines;
  for (const EngineContest& c : contests) {
    rows[0].push_back(c.scene);
    for (const EngineSeries& s : c.series)
      if (const std::pair key(s.engine, s.webassembly);
          s.defaults && std::ranges::find(engines, key) == engines.end())
        engines.push_back(key);
  }
  for (const auto& [engine, webassembly] : engines) {
    std::vector<std::string> row{engine + (webassembly ? " *" : "")};
    for (const EngineContest& c : contests) {
      const auto s = std::ranges::find_if(c.series, [&](const EngineSeries& one) {
        return one.defaults && one.engine == engine && one.webassembly == webassembly;
      });
      row.push_back(s == c.series.end() ? "" : rate_cell(c, *s));
    }
    rows.push_back(std::move(row));
  }
  return as_table(rows, 1);
}

/// The cheapest native variant that is enough, and what `choose` takes.
std::string replaced_table(const std::vector<EngineContest>& contests) {
  Rows rows{
      {"scene", "the cheapest engine that is enough", "at", "a frame", "instead", "a frame", "cheaper"}};
  for (const EngineContest& c : contests) {
    if (!c.least) continue;
    const EngineSeries* best = nullptr;
    const EngineTrial* paid = nullptr;
    for (const EngineSeries& s : c.series)
      if (const EngineTrial* t = s.webassembly ? nullptr : s.first_enough();
          t && (!paid || t->seconds_per_frame < paid->seconds_per_frame))
        best = &s, paid = t;
    rows.push_back({c.scene + " " + c.title, best ? full_name(*best) : "none",
                    best ? format_significant(paid->steps_per_frame * c.frames_per_second, 6) + " Hz" : "",
                    best ? shown_time(paid->seconds_per_frame) : "", c.least->says,
                    shown_time(c.least->seconds_per_frame),
                    best ? two_digits(paid->seconds_per_frame / c.least->seconds_per_frame) + "x" : ""});
  }
  return as_table(rows, 2);
}

std::string not_explained(const std::vector<EngineContest>& contests) {
  int count = 0;
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      count += s.cannot.empty() && !s.first_enough() && why_never(c, s) == "not explained";
  return count == 1 ? "One of all variants in all scenes is *not explained*."
                    : std::to_string(count) + " of all variants in all scenes are *not explained*.";
}

std::string engines_known(const std::vector<EngineContest>& contests) {
  std::set<std::string> lines;
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      lines.insert("- **" + escaped(s.engine + " " + s.version + ", " + s.variant) + "** (" + s.precision +
                   (s.webassembly ? ", WebAssembly" : "") + "): " + escaped(s.says) + "\n");
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

std::string bits_of(const std::vector<EngineContest>& contests) {
  std::map<std::string, std::set<std::string>> other, restored;
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      for (const EngineTrial& t : s.trials) {
        if (!t.same_bits) other[s.engine + ", " + s.variant].insert(c.scene);
        if (t.restored == "other bits") restored[s.engine + ", " + s.variant].insert(c.scene);
      }
  const auto listed = [](const auto& found) {
    std::string text;
    for (const auto& [name, scenes] : found) {
      text += (text.empty() ? "" : "; ") + escaped(name) + " (";
      for (const std::string& scene : scenes) text += (scene == *scenes.begin() ? "" : ", ") + scene;
      text += ")";
    }
    return text.empty() ? "none" : text;
  };
  return "Run again in the same process, other bits: " + listed(other) +
         ". Gone on from a snapshot, other bits: " + listed(restored) + ".\n";
}

std::string scene_part(const EngineContest& c, const OwnByScene& own, const std::vector<double>& rates) {
  std::string text = "## " + escaped(c.scene + " " + c.title) + "\n\n" + need_text(c) + "\n\n" +
                     as_table(rows_of(c, rates, false), 2);
  if (c.least) text += escaped(least_text(c)) + "\n\n";
  if (const std::string cannot = cannot_text(c); !cannot.empty())
    text += "Not to be had by " + escaped(cannot) + ".\n\n";
  if (!c.differs.empty()) text += prose(c.differs) + "\n\n";
  text += "![" + escaped(c.scene) + ": the error over the steps a second](" + picture_name(c.scene) + ")\n\n";
  const std::vector<std::string> left_out = left_out_of_rates(c, own_in(own, c.scene));
  if (left_out.empty()) return text;
  text += "Not in the picture: ";
  for (const std::string& name : left_out) text += (&name == &left_out.front() ? "" : "; ") + escaped(name);
  return text + ".\n\n";
}

std::string introduction(const std::vector<EngineContest>& contests) {
  return "# Engines on trial\n\n"
         "Other people's physics engines on scenes of the book, each set up once for all of them, judged at "
         "every frame against the same references as oddity's own models. `./oddity engines --report` makes "
         "this page.\n\n"
         "Of each engine stand its defaults, and below these the best of its variants where that is better; "
         "names with * run behind WebAssembly, and their times are not those of native programs. *Enough "
         "from* is the rate from which on every finer one holds. Where none does, it says why: *beyond* "
         "where the error still falls; what is said of a variant's settings where another without these "
         "does better; rounding where double does better, or finer steps err more. " +
         not_explained(contests) +
         " The *order* is of the error over the step in its asymptotic range, beside the one that the "
         "manual or the integrator's name states; *least error* is the least of all rates tried, in parts "
         "of what is enough; *energy* and *joints off* are at one step a frame; *a frame* is the time at "
         "the rate from which it is enough, or at one step a frame; *costs* is that beside the model below "
         "the table. What is not of an engine, the forces of turning axes and a gravity that is shaken, "
         "acts by its value at the beginning of each step: there every engine is of first order. In the "
         "pictures what errs by less than a millionth of what is enough stands at that, and engines that "
         "err alike share a curve.\n\n";
}

}  // namespace

std::string engines_page(const std::vector<EngineContest>& contests, const OwnByScene& own,
                         const std::vector<double>& rates, const std::vector<Surprise>& surprises) {
  std::string text =
      introduction(contests) +
      "## All scenes\n\n"
      "The steps a second from which the defaults are enough; *finer* where the error still falls at the "
      "finest step, nothing where the engine has no such scene.\n\n" +
      enough_table(contests) + "![How engines end](engines/map.svg)\n\nWhat replaces them:\n\n" +
      replaced_table(contests);
  for (const EngineContest& c : contests) text += scene_part(c, own, rates);
  text += "## The same bits\n\n" + bits_of(contests);
  text += "\n## What was found in the engines\n\n" + std::to_string(surprises.size()) +
          " things, each with the smallest program that shows it.\n\n";
  for (const Surprise& s : surprises)
    text += "- " + escaped(s.says) + " ([" + s.file + "](../solvers/engines/found/" + s.file + "))\n";
  return text + "\n## The engines\n\n" + engines_known(contests);
}

std::map<std::string, std::string> engine_pictures(const std::vector<EngineContest>& contests,
                                                   const OwnByScene& own) {
  std::map<std::string, std::string> pictures{{"engines/map.svg", engine_map_svg(contests)}};
  for (const EngineContest& c : contests)
    pictures[picture_name(c.scene)] = engine_rates_svg(c, own_in(own, c.scene));
  return pictures;
}

std::map<std::string, std::string> engine_pictures_of_times(const std::vector<EngineContest>& contests) {
  std::map<std::string, std::string> pictures;
  for (const EngineContest& c : contests)
    for (bool webassembly : {false, true})
      pictures["engines/" + file_name(c.scene) + (webassembly ? "_times_webassembly.svg" : "_times.svg")] =
          engine_times_svg(c, webassembly);
  return pictures;
}

std::vector<Surprise> surprises_in(const std::filesystem::path& folder) {
  std::vector<Surprise> all;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(file.path());
    std::string says;
    for (std::string line; std::getline(in, line) && line.starts_with("//");)
      says += (says.empty() ? "" : " ") + line.substr(std::min(line.size(), line.find_first_not_of("/ ")));
    for (const char* command : {" g++", " node found"}) says = says.substr(0, says.find(command));
    all.push_back({file.path().filename().string(), says});
  }
  std::ranges::sort(all, {}, &Surprise::says);
  return all;
}

}  // namespace oddity
