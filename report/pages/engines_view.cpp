#include "report/pages/engines_view.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "reference/text.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

/// Two digits, without an exponent where people do without one: "0.12", "350".
std::string two_digits(double x) {
  const std::string text = rounded(x, 2);
  return std::abs(x) >= 100 && std::abs(x) < 1e6 ? std::to_string(std::lround(std::stod(text))) : text;
}

/// "3.4 cm", "0.12 deg": of errors in the motion's units, what a reader can picture.
std::string pictured(double error, const std::string& unit) {
  if (!std::isfinite(error)) return "-";
  if (unit == "m") return two_digits(100 * error) + " cm";
  if (unit == "rad") return two_digits(180 / std::numbers::pi * error) + " deg";
  return two_digits(error) + " " + unit;
}

std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units) {
  std::string text;
  for (std::size_t i = 0; i < errors.size(); ++i)
    text += (i == 0 ? "" : ", ") + pictured(errors[i], units[i]);
  return text;
}

const EngineTrial* at_rate(const EngineSeries& series, double rate, double frames_per_second) {
  for (const EngineTrial& t : series.trials)
    if (std::abs(t.steps_per_frame * frames_per_second - rate) < 1e-9 * rate) return &t;
  return nullptr;
}

std::string shown(const EngineTrial* trial, const EngineContest& contest) {
  if (trial == nullptr) return "";
  if (trial->outcome == Outcome::ok || trial->outcome == Outcome::inaccurate)
    return pictured(trial->errors, contest.units);
  return std::string(name_of(trial->outcome));
}

std::string enough_from(const EngineSeries& series, const EngineContest& contest) {
  const EngineTrial* first = series.first_enough();
  return first == nullptr ? "never" : rounded(first->steps_per_frame * contest.frames_per_second, 6) + " Hz";
}

std::string order_of(const EngineSeries& series) {
  const std::string stated = series.stated_order > 0 ? " (" + std::to_string(series.stated_order) + ")" : "";
  return (series.law ? rounded(series.law->exponent, 2) : "-") + stated;
}

/// Of the coarsest trial that is enough, else of the coarsest.
const EngineTrial* priced(const EngineSeries& series) {
  if (const EngineTrial* first = series.first_enough()) return first;
  return series.trials.empty() ? nullptr : &series.trials.front();
}

std::string cheaper(const EngineSeries& series, const EngineContest& contest) {
  const EngineTrial* first = series.first_enough();
  if (!contest.least || first == nullptr || series.webassembly) return "";
  return two_digits(first->seconds_per_frame / contest.least->seconds_per_frame) + "x";
}

std::string name_of(const EngineSeries& s) {
  return s.engine + (s.variant == "defaults" ? "" : ", " + s.variant) + (s.webassembly ? " *" : "");
}

/// Whether someone who looks for accuracy takes a before b.
bool better(const EngineSeries& a, const EngineSeries& b) {
  const auto steps = [](const EngineSeries& s) {
    const EngineTrial* first = s.first_enough();
    return first ? first->steps_per_frame : std::numeric_limits<int>::max();
  };
  if (steps(a) != steps(b)) return steps(a) < steps(b);
  return a.trials.front().in_needs < b.trials.front().in_needs / 2;
}

/// Of each engine its defaults, and what is best beside them where that is better; or all.
std::vector<const EngineSeries*> shown_of(const EngineContest& contest, bool all) {
  std::vector<const EngineSeries*> shown;
  for (const EngineSeries& s : contest.series) {
    if (!s.cannot.empty()) continue;
    const bool same_engine = !shown.empty() && shown.back()->engine == s.engine;
    if (all || !same_engine)
      shown.push_back(&s);
    else if (!shown.back()->defaults && better(s, *shown.back()))
      shown.back() = &s;
    else if (shown.back()->defaults && better(s, *shown.back()))
      shown.push_back(&s);
  }
  return shown;
}

std::vector<std::vector<std::string>> rows_of(const EngineContest& contest, const std::vector<double>& rates,
                                              bool all) {
  std::vector<std::vector<std::string>> rows{{"engine", "numbers"}};
  for (double rate : rates) rows[0].push_back("at " + rounded(rate, 6) + " Hz");
  for (const char* head :
       {"enough from", "order (stated)", "least error", "energy", "joints off", "a frame", "costs"})
    rows[0].emplace_back(head);
  for (const EngineSeries* series : shown_of(contest, all)) {
    const EngineSeries& s = *series;
    std::vector<std::string> row{name_of(s), s.precision};
    for (double rate : rates) row.push_back(shown(at_rate(s, rate, contest.frames_per_second), contest));
    const EngineTrial* trial = priced(s);
    const EngineTrial* first = at_rate(s, contest.frames_per_second, contest.frames_per_second);
    row.push_back(enough_from(s, contest));
    row.push_back(order_of(s));
    row.push_back(two_digits(s.floor) + " needs");
    row.push_back(first && std::isfinite(first->energy) ? two_digits(100 * first->energy) + " %" : "");
    row.push_back(first && first->off_joint > 0 ? two_digits(1000 * first->off_joint) + " mm" : "");
    row.push_back(trial ? shown_time(trial->seconds_per_frame) : "");
    row.push_back(cheaper(s, contest));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "ODE: no joint that ...; Box2D, Chipmunk: ...".
std::string cannot_text(const EngineContest& contest) {
  std::map<std::string, std::vector<std::string>> engines;
  for (const EngineSeries& s : contest.series) {
    auto& names = engines[s.cannot];
    if (!s.cannot.empty() && (names.empty() || names.back() != s.engine)) names.push_back(s.engine);
  }
  std::string text;
  for (const auto& [reason, names] : engines) {
    if (reason.empty()) continue;
    text += text.empty() ? "" : "; ";
    for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + names[i];
    text += ": " + reason;
  }
  return text;
}

std::string need_text(const EngineContest& contest) {
  return "Worst error over " + rounded(contest.horizon, 6) + " s at every frame; enough is " +
         pictured(contest.needs, contest.units) + ".";
}

std::string least_text(const EngineContest& contest) {
  if (!contest.least) return "";
  return "Instead: " + contest.least->says + ", which errs by " +
         pictured(contest.least->errors, contest.units) + " for " +
         shown_time(contest.least->seconds_per_frame) + " a frame.";
}

}  // namespace

std::string engines_text(const std::vector<EngineContest>& contests, const std::vector<double>& rates,
                         bool all, const Screen& screen) {
  std::string text;
  for (const EngineContest& contest : contests) {
    text += screen.styled(Style::heading, contest.scene + "  " + contest.title) + "\n";
    text += wrapped("  " + need_text(contest) + "\n", screen, 2);
    text += aligned(rows_of(contest, rates, all), screen,
                    {.shorten = {"engine"}, .leave_out = {"joints off", "numbers", "energy", "least error"}});
    if (contest.least) text += wrapped("  " + least_text(contest) + "\n", screen, 2);
    if (const std::string cannot = cannot_text(contest); !cannot.empty())
      text += wrapped("  Not to be had by " + cannot + ".\n", screen, 2);
    text += "\n";
  }
  return text + "  * behind WebAssembly: its times are not those of a native program\n";
}

namespace {

std::string as_markdown(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += "|";
    for (const std::string& cell : rows[i]) text += " " + escaped(cell) + " |";
    text += "\n";
    if (i > 0) continue;
    text += "|";
    for (std::size_t k = 0; k < rows[i].size(); ++k) text += k < 2 ? " --- |" : " ---: |";
    text += "\n";
  }
  return text;
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

}  // namespace

std::string engines_page(const std::vector<EngineContest>& contests, const std::vector<double>& rates,
                         const std::vector<Surprise>& surprises) {
  std::string text =
      "# Engines on trial\n\nOther people's physics engines on scenes of the book, each set up once for all of "
      "them, judged at every frame against the same references as oddity's own models. `./oddity engines --report` "
      "makes this page.\n\n"
      "Of each engine stand its defaults, and below these the best of its variants where that is better; names "
      "with * run behind WebAssembly, and their times are not those of native programs. *Enough from* is the rate "
      "from which on every finer one holds; the *order* is of the error over the step, where it follows one, beside "
      "the one that its manual or its integrator's name states; *least error* is the least of all rates tried, in "
      "parts of what is enough; *energy* and *joints off* are at one step a frame; *a frame* is the time at the "
      "rate from which it is enough, or at one step a frame; *costs* is that beside the model below the table. What is not of an engine, the forces of turning axes and a gravity that is shaken, acts by its value at the beginning of each step: there every engine is of first order.\n";
  for (const EngineContest& c : contests) {
    text += "\n## " + escaped(c.scene + " " + c.title) + "\n\n" + need_text(c) + "\n\n" +
            as_markdown(rows_of(c, rates, false)) + "\n";
    if (c.least) text += escaped(least_text(c)) + "\n\n";
    if (const std::string cannot = cannot_text(c); !cannot.empty())
      text += "Not to be had by " + escaped(cannot) + ".\n";
  }
  text += "\n## The same bits\n\n" + bits_of(contests);
  text += "\n## What was found in the engines\n\n";
  for (const Surprise& s : surprises)
    text += "- " + escaped(s.says) + " ([" + s.file + "](../solvers/engines/found/" + s.file + "))\n";
  return text + "\n## The engines\n\n" + engines_known(contests);
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

Table engines_table(const std::vector<EngineContest>& contests) {
  Table table{
      {"scene", "engine", "version", "precision", "variant", "webassembly", "hz", "outcome", "error", "unit",
       "in_needs", "energy", "off_joint", "seconds_per_frame", "spread", "same_bits", "restored"},
      {}};
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      for (const EngineTrial& t : s.trials)
        for (std::size_t i = 0; i < c.units.size(); ++i)
          table.rows.push_back({c.scene, s.engine, s.version, s.precision, s.variant, long(s.webassembly),
                                t.steps_per_frame * c.frames_per_second, std::string(name_of(t.outcome)),
                                t.errors.empty() ? NAN : t.errors[i], c.units[i], t.in_needs, t.energy,
                                t.off_joint, t.seconds_per_frame, t.spread, long(t.same_bits), t.restored});
  return table;
}

namespace {

/// A cell that needs no quotes, for tests/engines.sh.
std::string plain(std::string text) {
  std::ranges::replace(text, ',', ';');
  return text;
}

}  // namespace

std::string engine_rows(const std::vector<EngineContest>& contests) {
  Table table{{"scene", "engine", "version", "variant", "order", "stated", "enough_from", "at_frame_rate",
               "same_bits", "restored"},
              {}};
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series) {
      if (s.trials.empty()) continue;
      const EngineTrial* enough = s.first_enough();
      const bool same = std::ranges::all_of(s.trials, &EngineTrial::same_bits);
      table.rows.push_back({c.scene, plain(s.engine), plain(s.version), plain(s.variant),
                            s.law ? rounded(s.law->exponent, 2) : "-",
                            s.stated_order > 0 ? std::to_string(s.stated_order) : "-",
                            enough ? rounded(enough->steps_per_frame * c.frames_per_second, 6) : "never",
                            std::string(name_of(s.trials.front().outcome)), same ? "same" : "other",
                            s.trials.front().restored});
    }
  return to_csv(table);
}

std::string engine_answer(const EngineContest& contest, const Screen& screen) {
  std::string text;
  for (const EngineSeries& s : contest.series) {
    std::string line = "  on " + s.engine + " " + s.version + ", " + s.variant + " (" + s.precision + "): ";
    if (!s.cannot.empty()) {
      text += wrapped(line + "not to be had: " + s.cannot + ".\n", screen, 4);
      continue;
    }
    const EngineTrial &coarsest = s.trials.front(), *enough = s.first_enough();
    line += "at " + rounded(coarsest.steps_per_frame * contest.frames_per_second, 6) + " Hz " +
            (coarsest.errors.empty() ? std::string(name_of(coarsest.outcome))
                                     : "it errs by " + pictured(coarsest.errors, contest.units));
    if (enough == nullptr)
      line += "; no more steps make that enough, up to " + std::to_string(s.trials.back().steps_per_frame) +
              " a frame";
    else if (enough != &coarsest)
      line += "; " + std::to_string(enough->steps_per_frame) + " steps a frame bring " +
              pictured(enough->errors, contest.units);
    const EngineTrial& paid = enough ? *enough : coarsest;
    line += ", for " + shown_time(paid.seconds_per_frame) + " a frame";
    if (contest.least && enough && !s.webassembly)
      line += ", " + two_digits(paid.seconds_per_frame / contest.least->seconds_per_frame) +
              " times what the choice above costs";
    text += wrapped(line + ".\n", screen, 4);
  }
  return text;
}

}  // namespace oddity
