#include "extras/bench/verb.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

#include "extras/bench/bench.hpp"
#include "extras/bench/lanes.hpp"
#include "extras/bench/verbs.hpp"
#include "extras/lanes/price.hpp"
#include "report/cli/verb.hpp"
#include "report/study/progress.hpp"
#include "report/study/settings.hpp"

namespace oddity {

namespace {

using verbs::Format, verbs::output, verbs::print;

struct Asked : Formats {
  bool lanes = false, verbs = false;
  std::vector<std::string> scenes = {};
};

/// Returns 0 if no limit is broken, else 1.
int time_build(const std::string& folder, Format format) {
  const Bench result = with_progress(
      [&](const Progress& progress) { return bench(Reference(folder, motions_folder()), progress); });
  if (format == Format::text)
    std::cout << bench_view(result, output());
  else
    print(bench_table(result), format);
  return result.broken();
}

int time_lanes(const std::vector<std::string>& scenes, Format format) {
  tasks_of(scenes, true);
  if (needs_are_all(lanes::needs_of_lanes)) return 0;
  for (const std::string& number : scenes) static_cast<void>(lanes::scene_in_lanes(number));
  const LanesBench result =
      with_progress([&](const Progress& progress) { return bench_lanes(scenes, 11, progress); });
  if (format == Format::text)
    std::cout << lanes_view(result, output());
  else
    print(lanes_table(result), format);
  return result.broken();
}

int time_verbs(Format format) {
  const VerbsBench result = with_progress([](const Progress& progress) { return bench_verbs(progress); });
  if (format == Format::text)
    std::cout << verbs_view(result, output());
  else
    print(verbs_table(result), format);
  return std::ranges::any_of(result.verbs, [](const VerbCost& v) { return !v.failure.empty(); });
}

}  // namespace

void add_bench(const CommandLine& line) {
  const auto asked = std::make_shared<Asked>();
  auto* bench = add_verb(
      line.app, "bench",
      "Measure how fast this build is: against loops by hand, its best methods, the suite; or lanes, or the verbs.",
      "Times are meaningful only on an idle machine. The exit code is 1 when a limit is broken.\n"
      "Columns: part (race, contest, series, chain or suite), subject, measured, value, half_width (of its quartiles), unit, "
      "at_most, verdict (holds, undecided or BROKEN, where there is a limit). A row for each number.\n"
      "With --lanes: scene, model, algorithm, precision, registers, width, taken (the widest), seconds_alone and "
      "seconds (a body a frame), share (how many times faster, of the width), at_least, ceiling (of the share, where the processor's own "
      "arithmetic has less), verdict (holds, arithmetic: holds relative to that ceiling, not asked: registers of two doubles, undecided "
      "or BROKEN), bodies, "
      "same_bits (of how many bodies), and the half_width of each time and share.\n"
      "With --verbs: part (verb or growth), subject, amount (the number that grows), seconds, cpu_seconds, "
      "peak_bytes, failure (how it ended, unless well).\n"
      "Examples:\n  oddity bench\n  oddity bench --csv\n  oddity bench --lanes 3.5 3.33\n  oddity bench --verbs",
      [line, asked] {
        const verbs::Format format = asked->format();
        line.status = asked->lanes             ? time_lanes(asked->scenes, format)
                      : needs_are_all(Needs()) ? 0
                      : asked->verbs           ? time_verbs(format)
                                               : time_build(line.reference, format);
      },
      true);
  auto* lanes =
      bench->add_flag("--lanes", asked->lanes, "the scenes' models in lanes, compared with each alone");
  bench->add_flag("--verbs", asked->verbs, "time and peak memory of each verb, and how its work grows")
      ->excludes(lanes);
  bench->add_option("scenes", asked->scenes, "with --lanes, these scenes, by number; else all")->needs(lanes);
  add_formats(*bench, *asked, "the numbers measured");
}

}  // namespace oddity
