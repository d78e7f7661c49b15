// Outcome of each variant of an engine, over scenes and rates.

#include <algorithm>
#include <cmath>

#include "extras/engines/chart.hpp"
#include "extras/engines/labels.hpp"
#include "report/charts/stability_map.hpp"
#include "report/text/svg.hpp"

namespace oddity {

namespace {

constexpr double map_names = 250, map_top = 150, map_row = 15, map_cell = 7, map_gap = 12;

constexpr std::string_view grades = "gnwx";

/// Grade of a trial: sufficient, within ten times the tolerance, worse, no answer.
char grade(const EngineTrial& t) {
  if (!std::isfinite(t.in_needs)) return 'x';
  return t.in_needs <= 1 ? 'g' : t.in_needs <= 10 ? 'n' : 'w';
}

constexpr std::string_view map_style =
    ".g{fill:#0072b2}.n{fill:#e69f00}.w{fill:#f7dfae}.x{fill:#000}"
    "@media(prefers-color-scheme:dark){.w{fill:#6b5530}.x{fill:#fff}}";

/// A variant over the scenes; null for scenes without it.
struct MapLine {
  std::string name;
  std::vector<const EngineSeries*> in_scene;
};

std::vector<MapLine> map_lines(const std::vector<EngineContest>& contests) {
  std::vector<MapLine> lines;
  for (std::size_t scene = 0; scene < contests.size(); ++scene)
    for (const EngineSeries& s : contests[scene].series) {
      auto line = std::ranges::find(lines, full_name(s), &MapLine::name);
      if (line == lines.end()) line = lines.insert(lines.end(), {full_name(s), {}});
      line->in_scene.resize(contests.size());
      line->in_scene[scene] = &s;
    }
  return lines;
}

void add_map_legend(Svg& svg) {
  double x = map_names;
  const double y = map_top - 72;
  for (const auto& [letter, words] : {std::pair{"g", "enough"},
                                      {"n", "within ten times that"},
                                      {"w", "worse"},
                                      {"x", "no answer, or no numbers"}}) {
    svg.rectangle({x, y}, 12, 12, letter);
    svg.text({x + 17, y + 10}, words, "t");
    x += 60 + 6.2 * static_cast<double>(std::string_view(words).size());
  }
}

/// Left edge of each scene's block, and right edge of the last.
std::vector<double> blocks(const std::vector<EngineContest>& contests) {
  std::vector<double> left{map_names};
  for (const EngineContest& contest : contests) {
    std::size_t rates = 4;
    for (const EngineSeries& s : contest.series) rates = std::max(rates, s.trials.size());
    left.push_back(left.back() + map_cell * static_cast<double>(rates) + map_gap);
  }
  return left;
}

double row_top(std::size_t row) { return map_top + map_row * static_cast<double>(row); }

/// The cells of one grade, as a path.
std::string cells(const std::vector<MapLine>& lines, const std::vector<double>& left, char wanted) {
  std::string data;
  for (std::size_t row = 0; row < lines.size(); ++row)
    for (std::size_t scene = 0; scene < lines[row].in_scene.size(); ++scene) {
      if (!lines[row].in_scene[scene]) continue;
      double x = left[scene];
      for (const EngineTrial& t : lines[row].in_scene[scene]->trials) {
        if (grade(t) == wanted)
          data += "M" + px(x) + " " + px(row_top(row)) + "h" + px(map_cell - 1) + "v" + px(map_row - 3) +
                  "h-" + px(map_cell - 1) + "z";
        x += map_cell;
      }
    }
  return data;
}

std::string map_finding(const std::vector<EngineContest>& contests) {
  int enough = 0, all = 0;
  for (const EngineContest& contest : contests)
    for (const EngineSeries& s : contest.series)
      if (!s.trials.empty()) ++all, enough += s.trials.front().outcome == Outcome::ok;
  return "At 60 Hz " + std::to_string(enough) + " of " + std::to_string(all) +
         " pairs of a variant and a scene are within 1 cm and 1 degree";
}

}  // namespace

std::string engine_map_svg(const std::vector<EngineContest>& contests) {
  const std::vector<MapLine> lines = map_lines(contests);
  const std::vector<double> left = blocks(contests);
  const std::string says = map_finding(contests);
  const std::string of = "How engines end in each scene, from 60 Hz on the left of its block, by doubling";
  Svg svg(left.back(), row_top(lines.size()) + 12, of + ". " + says, std::string(map_style));
  svg.headline(says, of);
  add_map_legend(svg);
  for (std::size_t scene = 0; scene < contests.size(); ++scene) {
    double y = map_top - 8;
    std::vector<std::string> words = wrapped(contests[scene].scene, 8);
    for (; !words.empty(); words.pop_back(), y -= 13) svg.text({left[scene], y}, words.back(), "t small");
  }
  for (std::size_t row = 0; row < lines.size(); ++row)
    svg.text({map_names - 8, row_top(row) + 10}, shortened(lines[row].name, 40), "t small", Svg::Anchor::end);
  for (char wanted : grades)
    if (const std::string data = cells(lines, left, wanted); !data.empty())
      svg.path(data, std::string(1, wanted));
  return svg.str();
}

}  // namespace oddity
