#include "extras/engines/page.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

#include "extras/engines/chart.hpp"
#include "extras/engines/contest.hpp"
#include "extras/engines/labels.hpp"
#include "extras/engines/tables.hpp"
#include "extras/engines/view.hpp"
#include "reference/text.hpp"
#include "report/text/markup.hpp"
#include "report/text/numbers.hpp"

namespace oddity {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The first row names the columns; those from `numbers` on are right-aligned.
std::string as_table(const Rows& rows, std::size_t numbers) {
  std::string right;
  for (std::size_t i = numbers; i < rows.front().size(); ++i) right += static_cast<char>('0' + i);
  return table(rows.front(), {rows.begin() + 1, rows.end()}, right);
}

std::string file_of(const std::string& scene, const char* extension) {
  return "engines/" + file_name(scene) + extension;
}

const std::vector<OwnSteps>& own_in(const OwnByScene& own, const std::string& scene) {
  static const std::vector<OwnSteps> none;
  const auto found = own.find(scene);
  return found == own.end() ? none : found->second;
}

std::string linked(const EngineContest& c) {
  return "[" + escaped(c.scene) + "](" + file_of(c.scene, ".svg") + ")";
}

/// "2.3/240": the error in tolerances at one step a frame, and the rate from which it is sufficient.
std::string error_and_rate(const EngineContest& contest, const EngineSeries& s) {
  const EngineTrial& coarsest = s.trials.front();
  const std::string error = std::isfinite(coarsest.in_needs) ? two_digits(coarsest.in_needs)
                                                             : std::string(name_of(coarsest.outcome));
  if (const EngineTrial* first = s.first_enough())
    return error + "/" + format_significant(first->steps_per_frame * contest.frames_per_second, 6);
  return error + (why_never(contest, s).empty() ? "/finer" : "/never");
}

using EngineName = std::pair<std::string, bool>;  ///< and whether it runs in WebAssembly

std::vector<EngineName> engines_of(const std::vector<EngineContest>& contests) {
  std::vector<EngineName> engines;
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      if (const EngineName key(s.engine, s.webassembly);
          s.defaults && std::ranges::find(engines, key) == engines.end())
        engines.push_back(key);
  return engines;
}

using CellOf = std::function<std::string(const EngineContest&, const EngineSeries&)>;

/// Engines with the same cells share a row; those without any are left out.
std::string defaults_table(const std::vector<EngineContest>& contests, const CellOf& cell) {
  Rows rows{{"defaults of"}};
  for (const EngineContest& c : contests) rows[0].push_back(linked(c));
  for (const EngineName& of : engines_of(contests)) {
    std::vector<std::string> row{escaped(of.first + (of.second ? " *" : ""))};
    for (const EngineContest& c : contests) {
      const auto s = std::ranges::find_if(c.series, [&](const EngineSeries& one) {
        return one.defaults && EngineName(one.engine, one.webassembly) == of;
      });
      row.push_back(s == c.series.end() || !s->cannot.empty() ? "" : cell(c, *s));
    }
    if (std::all_of(row.begin() + 1, row.end(), [](const std::string& one) { return one.empty(); })) continue;
    const auto same = std::ranges::find_if(rows, [&](const std::vector<std::string>& above) {
      return std::equal(row.begin() + 1, row.end(), above.begin() + 1);
    });
    if (same == rows.end())
      rows.push_back(std::move(row));
    else
      same->front() += ", " + row.front();
  }
  return as_table(rows, 1);
}

/// "0.13/0.15": relative drift of its energy and of a momentum at one step a frame.
std::string drifts(const EngineContest&, const EngineSeries& s) {
  const EngineTrial& coarsest = s.trials.front();
  return in_percent(coarsest.energy) + "/" + in_percent(coarsest.momentum);
}

/// Scenes that conserve some momentum, but some engine does not.
std::vector<EngineContest> with_momentum(const std::vector<EngineContest>& contests) {
  std::vector<EngineContest> those;
  for (const EngineContest& c : contests)
    if (std::ranges::any_of(c.series, [](const EngineSeries& s) {
          return s.cannot.empty() && s.trials.front().momentum > 1e-6;
        }))
      those.push_back(c);
  return those;
}

/// The native variant that meets the tolerance in the least time.
const EngineSeries* cheapest(const EngineContest& contest) {
  const EngineSeries* best = nullptr;
  for (const EngineSeries& s : contest.series)
    if (const EngineTrial* t = s.webassembly ? nullptr : s.first_enough();
        t && (!best || t->seconds_per_frame < best->first_enough()->seconds_per_frame))
      best = &s;
  return best;
}

std::string replaced_table(const std::vector<EngineContest>& contests) {
  Rows rows{{"scene", "instead", "of", "cheaper"}};
  for (const EngineContest& c : contests) {
    if (!c.least) continue;
    const EngineSeries* const best = cheapest(c);
    const double seconds = best ? best->first_enough()->seconds_per_frame : 0;
    rows.push_back({escaped(c.scene), escaped(c.least->says), best ? escaped(full_name(*best)) : "",
                    best ? two_digits(seconds / c.least->seconds_per_frame) + "x" : ""});
  }
  return as_table(rows, 3);
}

int unexplained(const std::vector<EngineContest>& contests) {
  int count = 0;
  for (const EngineContest& c : contests)
    count += static_cast<int>(std::ranges::count_if(c.series, [&](const EngineSeries& s) {
      return s.cannot.empty() && !s.first_enough() && why_never(c, s) == "not explained";
    }));
  return count;
}

}  // namespace

std::string engines_page(const std::vector<EngineContest>& contests, const std::vector<Surprise>& surprises,
                         const std::string& programs) {
  std::string text =
      "# Engines on trial\n\n"
      "Other people's engines on the book's scenes; `./oddity engines --report` makes this page. A cell is the "
      "worst error in 10 s at 60 Hz, in centimeters or degrees, and the rate from which it is below 1: 2.3/240. "
      "*Finer*: beyond the rates tried, or beyond a minute of computing; *never*: `./oddity engines SCENE --kept --all` has the reason, and "
      "more; empty: the engine has no such scene; \\*: behind WebAssembly. Scenes lead to their pictures; "
      "`engines/SCENE.csv` has all trials, `extras/engines/adapters/variants.json` all settings.\n\n" +
      defaults_table(contests, error_and_rate) +
      "Energy and a momentum that no force changes, in percent of the largest of its kind, at 60 Hz:\n\n" +
      defaults_table(with_momentum(contests), drifts) +
      "Lesser models instead of the cheapest native engine that is enough, and how many times cheaper:\n\n" +
      replaced_table(contests);
  if (const int count = unexplained(contests); count > 0)
    text += "Variants in scenes that never come to them, *not explained*: " + std::to_string(count) + ".\n\n";
  text += "## Findings in the engines\n\n" + std::to_string(surprises.size()) +
          " things, each with the smallest program that shows it.\n\n";
  for (const Surprise& s : surprises)
    text += "- [" + escaped(s.says) + "](" + programs + "/" + s.file + ")\n";
  return text;
}

std::map<std::string, std::string> engine_trials(const std::vector<EngineContest>& contests) {
  std::map<std::string, std::string> files;
  for (const EngineContest& c : contests) files[file_of(c.scene, ".csv")] = to_csv(engines_table({c}));
  return files;
}

std::map<std::string, std::string> engine_pictures(const std::vector<EngineContest>& contests,
                                                   const OwnByScene& own) {
  std::map<std::string, std::string> pictures{{"engines/map.svg", engine_map_svg(contests)}};
  for (const EngineContest& c : contests)
    pictures[file_of(c.scene, ".svg")] = engine_rates_svg(c, own_in(own, c.scene));
  return pictures;
}

std::map<std::string, std::string> engine_pictures_of_times(const std::vector<EngineContest>& contests) {
  std::map<std::string, std::string> pictures;
  for (const EngineContest& c : contests)
    for (bool webassembly : {false, true})
      pictures[file_of(c.scene, webassembly ? "_times_webassembly.svg" : "_times.svg")] =
          engine_times_svg(c, webassembly);
  return pictures;
}

std::vector<Surprise> surprises_in(const std::filesystem::path& folder) {
  std::vector<Surprise> all;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(file.path());
    std::string title;
    std::getline(in, title);
    all.push_back({file.path().filename().string(), title.substr(title.find_first_not_of("/ "))});
  }
  std::ranges::sort(all, {}, &Surprise::says);
  return all;
}

}  // namespace oddity
