#include "report/pages/closing_screen.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "report/pages/claims.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/findings.hpp"
#include "report/text/readable.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

namespace {

constexpr std::size_t widest_screen = 120, width_in_a_pipe = 100, worst_findings = 10;

std::string duration(double seconds) {
  const long all = std::lround(std::ceil(seconds));
  return all < 60 ? counted(all, "second", "seconds")
                  : counted(all / 60, "minute", "minutes") +
                        (all % 60 ? " " + counted(all % 60, "second", "seconds") : "");
}

// ---- what was checked -------------------------------------------------------------------------------------

std::string checked(const Results& results) {
  long scenes = 0, quantities = 0, trials = 0;
  for (const ExerciseResult& e : results.exercises) {
    scenes += e.scene;
    quantities += std::ssize(e.quantities);
    for (const QuantityResult& q : e.quantities) {
      for (const MethodResult& m : q.methods) trials += std::ssize(m.trials);
      for (const FloatResult& m : q.in_float) trials += std::ssize(m.trials);
    }
  }
  return counted(std::ssize(results.exercises), "exercise", "exercises") + ", " +
         counted(sum_of(counts_of(results)), "claim", "claims") + ", " +
         counted(quantities, "quantity", "quantities") + " in " + counted(trials, "trial", "trials") + ", " +
         counted(scenes, "scene", "scenes") + " in motion";
}

std::string by_verdict(const Counts& found, const Screen& screen) {
  std::string text;
  for_each_count(found, [&](const VerdictNoun& noun, int n) {
    text +=
        (text.empty() ? "" : ", ") + screen.styled(style_of(noun.verdict), counted(n, noun.one, noun.many));
  });
  return text;
}

/// The counts as a bar, in proportion to the claims.
std::string bar(const Counts& found, const Screen& screen) {
  if (!screen.colour || found.empty()) return "";
  const long all = sum_of(found);
  const auto width = std::max(static_cast<long>(screen.width) - 4, 0L);
  std::string text;
  long before = 0;
  for_each_count(found, [&](const VerdictNoun& noun, int n) {
    const long from = before * width / all, to = (before += n) * width / all;
    std::string blocks;
    for (long i = from; i < to; ++i) blocks += "█";
    text += screen.styled(style_of(noun.verdict), blocks);
  });
  return "  " + text + "\n";
}

// ---- what is wrong ----------------------------------------------------------------------------------------

/// The worst erratum of each scene whose visible effect is described.
std::vector<Finding> worst_of_scenes(const Results& results) {
  std::vector<Finding> worst;
  for (Finding& f : errata_worst_first(results))
    if (f.exercise->scene && !f.shows().empty() &&
        std::ranges::find(worst, f.exercise, &Finding::exercise) == worst.end())
      worst.push_back(std::move(f));
  worst.resize(std::min(worst.size(), worst_findings));
  return worst;
}

std::string numbered(Number number) {
  const std::string text = to_string(number);
  return "  " + text + std::string(text.size() < 5 ? 5 - text.size() : 0, ' ') + " ";
}

std::string what_is_wrong(const Results& results, const Screen& screen) {
  long roots = 0;
  for (const ExerciseResult& e : results.exercises) roots += std::ssize(e.roots);
  const std::vector<Finding> worst = worst_of_scenes(results);
  if (worst.empty()) return "";
  std::string text =
      "\n" + screen.styled(Style::heading, "What is wrong") + ", as it shows where things move:\n";
  for (const Finding& w : worst) {
    const std::string number = numbered(w.exercise->number);
    text += wrapped(screen.styled(Style::bad, number) + readable(w.shows()) + "\n", screen, number.size());
  }
  const long others = roots - std::ssize(worst);
  return text + (others > 0 ? "  and " + counted(others, "other", "others") + " in the report\n" : "");
}

std::string failures(const Results& results, const Screen& screen) {
  std::string text;
  for (const ExerciseResult& e : results.exercises)
    if (!e.failure.empty())
      text += screen.styled(Style::bad, numbered(e.number)) + "failed: " + e.failure + "\n";
  return text;
}

// ---- what a game may use ----------------------------------------------------------------------------------

std::string what_a_game_may_use(const Results& results, const std::string& program, const Screen& screen) {
  std::map<std::string, long> scenes;
  for (const ExerciseResult& e : results.exercises)
    if (e.cheapest_models && !e.cheapest_models->least.empty() && e.cheapest_models->least.front().least) {
      const Candidate& least = *e.cheapest_models->least.front().least;
      ++scenes[least.resolution.empty() ? "a closed form" : least.algorithm];
    }
  std::vector<std::pair<std::string, long>> sorted(scenes.begin(), scenes.end());
  std::ranges::stable_sort(sorted, std::greater(), &std::pair<std::string, long>::second);
  std::string text;
  for (const auto& [algorithm, count] : sorted)
    text += (text.empty() ? "  " : ", ") + algorithm + " in " + counted(count, "scene", "scenes");
  if (text.empty()) return "";
  return "\n" + wrapped(screen.styled(Style::heading, "Enough for a game") +
                            ", to 1 cm and 1 degree at every frame over 10 s at 60 Hz:\n" + text +
                            "\n  for a scene, start and budget of your own: " + program + " choose\n",
                        screen, 2);
}

/// The parts that the site lacks, and the command that makes a complete one.
std::string lacks_text(const Closing& closing, const Screen& screen) {
  if (closing.lacks.empty()) return "";
  std::string text;
  for (const std::string& one : closing.lacks) text += "  " + one + "\n";
  return wrapped("\n" + screen.styled(Style::doubtful, "The site lacks") + "\n" + text +
                     "  a whole one is made by: " + closing.command + "\n",
                 screen, 4);
}

std::string what_to_open(const Closing& closing, const Screen& screen) {
  return "\n" + screen.styled(Style::heading, "Open") + "\n" +
         wrapped(aligned({{closing.site.string(),
                           closing.lacks.empty() ? "in a browser: every scene in motion" : "in a browser"},
                          {closing.report.string(), "the report as text"}}),
                 screen, 4) +
         lacks_text(closing, screen);
}

}  // namespace

std::string closing_screen(const Results& results, const Closing& closing, const Screen& terminal) {
  const Screen screen{terminal.at_most(terminal.width == 0 ? width_in_a_pipe : widest_screen),
                      terminal.colour};
  const Counts found = counts_of(results);
  const std::string verdict =
      closing.as_on_record
          ? screen.styled(Style::good, "All results match the approved records")
          : screen.styled(Style::bad, "Results differ from the approved records") + " (see above)";
  return "\n" +
         wrapped(screen.styled(Style::heading, "The solutions of Game Physics, 2nd edition, checked") + ": " +
                     checked(results) + "\n",
                 screen, 2) +
         wrapped("  " + by_verdict(found, screen) + "\n", screen, 2) + bar(found, screen) +
         failures(results, screen) + what_is_wrong(results, screen) +
         what_a_game_may_use(results, closing.program, screen) + what_to_open(closing, screen) + "\n" +
         wrapped(verdict + ", after " + duration(closing.seconds) + ".\n", screen, 2);
}

}  // namespace oddity
