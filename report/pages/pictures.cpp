#include "report/pages/pictures.hpp"

#include <algorithm>

#include "reference/files.hpp"
#include "report/charts/drawing.hpp"
#include "report/charts/stability_map.hpp"
#include "report/pages/quantities.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/findings.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"
#include "report/text/readable.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

std::string setup_file(const ExerciseResult& e) { return "charts/" + to_string(e.number) + "_setup.svg"; }
std::string frames_file(const ExerciseResult& e) { return "charts/" + to_string(e.number) + "_frames.svg"; }

const Entry* entry_of(const ExerciseResult& e) {
  const auto found = std::ranges::find(registry(), e.number, &Entry::number);
  return found == registry().end() ? nullptr : &*found;
}

/// The set-up with its letters, as SVG; empty if the scene has no drawing.
std::string setup_picture(const ExerciseResult& e) {
  const Entry* entry = entry_of(e);
  return entry ? setup_svg(*entry) : "";
}

/// The motion as a strip of frames, as SVG; empty if the scene has no drawing.
std::string frames_picture(const ExerciseResult& e) {
  const Entry* entry = entry_of(e);
  const Trajectory* t = trajectory_of(e);
  if (!entry || !t || !entry->exercise.scene) return "";
  const Parameters parameters(entry->exercise.parameters);
  const std::size_t observables = observed_at_start(*entry->exercise.scene, parameters).size();
  return true_path(*t).value.size() == observables * t->times.size() ? frames_svg(*entry, *t) : "";
}

void write_picture(const fs::path& file, const std::string& svg) {
  if (!svg.empty()) write_whole(file, svg);
}

std::string title_of(const ExerciseResult& e, const QuantityResult& q) {
  return to_string(e.number) + " " + e.title + ": " + readable(q.says) +
         (q.samples > 1 ? " (" + instants(q) + ")" : "");
}

void draw_series(const ExerciseResult& e, const fs::path& folder) {
  for (const auto& series : series_of(e))
    write_picture(folder / series_file(e, *series.front()),
                  series_svg(series, to_string(e.number) + " " + e.title + ": work over size"));
}

}  // namespace

std::string picture_links(const ExerciseResult& e) {
  std::string text;
  if (!setup_picture(e).empty())
    text += "![" + escaped(e.title, false) + ": the set-up](" + setup_file(e) + ")\n\n";
  if (!frames_picture(e).empty())
    text += "![" + escaped(e.title, false) + ": the motion in frames](" + frames_file(e) + ")\n\n";
  return text;
}

void draw_pictures(const Results& results, const fs::path& folder, const Progress& progress) {
  std::size_t done = 0;
  for (const ExerciseResult& e : results.exercises) {
    if (progress) progress(drawing_charts, static_cast<double>(done++), results.exercises.size());
    write_picture(folder / setup_file(e), setup_picture(e));
    write_picture(folder / frames_file(e), frames_picture(e));
    if (e.stability) draw_map(e, folder);
    for (const QuantityResult& q : e.quantities) {
      if (q.trajectory) write_picture(folder / trajectory_file(e, q), trajectory_svg(q, title_of(e, q)));
      if (const auto all = charts_of(q); !all.empty())
        write_picture(folder / chart_file(e, q, all.front()), chart_svg(q, title_of(e, q), all.front()));
    }
    draw_series(e, folder);
  }
}

void draw_charts(const ExerciseResult& e, Curves curves, double seam, const fs::path& folder) {
  for (const QuantityResult& q : e.quantities) {
    if (q.trajectory) write_picture(folder / trajectory_file(e, q), trajectory_svg(q, title_of(e, q)));
    for (Across across : charts_of(q))
      write_picture(folder / chart_file(e, q, across), chart_svg(q, title_of(e, q), across, curves, seam));
  }
  draw_series(e, folder);
}

void draw_map(const ExerciseResult& e, const fs::path& folder) {
  write_picture(folder / map_file(e), map_svg(e));
}

}  // namespace oddity
