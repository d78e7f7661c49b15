#include "report/charts/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "report/charts/sketch.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

constexpr std::string_view style = R"(.drawing{--ink:#1f2328;--thing:#0072b2;--given:#c4560a;color:var(--ink)}
@media(prefers-color-scheme:dark){.drawing{--ink:#e6edf3;--thing:#56b4e9;--given:#f0913f}}
.drawing path,.drawing circle{fill:none;stroke:currentColor;stroke-linecap:round;stroke-linejoin:round}
.drawing text{font:italic 18px "STIX Two Text","Latin Modern Roman","Times New Roman",Times,"Liberation Serif",serif;fill:currentColor;text-anchor:middle}
.drawing .n{font-style:normal}.drawing tspan{font-size:12px;font-style:normal}
.drawing .t{stroke-width:1.4;stroke-opacity:.75}.drawing .g{stroke-width:1;stroke-dasharray:4 4;stroke-opacity:.55}
.drawing .a{stroke-width:1;stroke-opacity:.75}.drawing .l{stroke-width:3}.drawing .z,.drawing .r{stroke-width:1.5}
.drawing .s{stroke-opacity:.35;fill:currentColor;fill-opacity:.05}
.drawing .d{stroke-width:1.5;fill:currentColor;fill-opacity:.16}
.drawing .b{fill:var(--thing);stroke:var(--thing)}.drawing .p{fill:var(--thing);fill-opacity:.3;stroke:var(--thing);stroke-width:2}
.drawing .m{stroke:var(--thing);stroke-width:2}.drawing .o{fill:currentColor}
.drawing .w{stroke-width:1.8}.drawing .x{stroke-width:1;stroke-opacity:.7}
.drawing .v{stroke:var(--thing);stroke-width:2.2}.drawing .q{stroke:var(--given);stroke-width:2}
.drawing .c{stroke-width:1}.drawing .e{stroke-width:.8;stroke-opacity:.5}
.drawing .h{stroke:none;fill:currentColor}.drawing .v.h{fill:var(--thing)}.drawing .q.h{fill:var(--given)}
)";

std::string pixels(double x) { return format_shortest(std::round(10 * x) / 10); }

std::string view_box(const Box& box) {
  return "viewBox=\"" + pixels(box.left) + " " + pixels(box.top) + " " + pixels(box.width()) + " " +
         pixels(box.height()) + "\" width=\"" + pixels(box.width()) + "\" height=\"" + pixels(box.height()) +
         "\"";
}

std::string svg(const Box& box, std::string_view title, const std::string& elements) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" role=\"img\" " + view_box(box) +
         ">\n<title>" + in_xml(title) + "</title>\n<style>\n" + std::string(style) + "</style>\n" + elements +
         "</svg>\n";
}

double scale_to(const Box& content, double width, double height) {
  const double scale = std::min(width / content.width(), height / content.height());
  return std::isfinite(scale) ? scale : 1;
}

/// The box with a margin, at least `least_width` wide, about the same middle.
Box framed(const Box& box, double least_width, double margin) {
  if (!(box.width() >= 0)) return {0, 0, least_width, 2 * margin};  // an empty drawing
  const double beside = margin + std::max(0.0, (least_width - box.width()) / 2 - margin);
  return {box.left - beside, box.top - margin, box.right + beside, box.bottom + margin};
}

std::string title_of(const Entry& e, const std::string& what) {
  const std::string number = e.number.chapter == 0 ? "" : to_string(e.number) + " ";  // examples have none
  return number + std::string(e.exercise.title) + ": " + what;
}

Drawing drawn(const Scene& scene, const Parameters& p, double t, std::span<const double> observed) {
  Drawing drawing;
  scene.draw(p, t, observed, drawing);
  return drawing;
}

}  // namespace

std::vector<double> observed_at_start(const Scene& scene, const Parameters& parameters) {
  // No method observes the start itself: a billionth of the horizon later nothing has visibly moved.
  const Quantity soon = scene.motion(parameters, {1e-9 * scene.horizon, 1}, Reference::nothing());
  std::vector<double> start;
  for (const Method& m : soon.methods) {
    if (m.algorithm != "Runge-Kutta 4") continue;
    const Answer answer = run(soon, m, m.resolution.settings.back()).answer;
    if (answer.reached() && finite(answer.value)) start.assign(answer.value.begin(), answer.value.end());
  }
  return start;
}

std::string_view drawing_style() { return style; }

std::string setup_svg(const Drawing& drawing, std::string_view title) {
  const Camera camera(drawing.is_in_space());
  Sketch sketch(camera, scale_to(camera.extent(drawing), 400, 300));
  sketch.add(drawing, Sketch::With::letters);
  return svg(framed(sketch.extent(), 480, 8), title, sketch.elements());
}

std::string setup_svg(const Entry& e) {
  if (!e.exercise.scene || !e.exercise.scene->draw) return {};
  const Scene& scene = *e.exercise.scene;
  const Parameters p(e.exercise.parameters);
  return setup_svg(drawn(scene, p, 0, observed_at_start(scene, p)), title_of(e, "the set-up"));
}

std::string frames_svg(const Entry& e, const Trajectory& t) {
  if (!e.exercise.scene || !e.exercise.scene->draw || t.times.empty()) return {};
  const Scene& scene = *e.exercise.scene;
  const Parameters p(e.exercise.parameters);
  const Value& path = t.paths.at(t.truest).value;
  const std::size_t n = path.size() / t.times.size();
  std::vector<double> times{0};
  std::vector<Drawing> all{drawn(scene, p, 0, observed_at_start(scene, p))};
  for (std::size_t i = 0; i < t.times.size(); ++i) {
    times.push_back(t.times[i]);
    all.push_back(drawn(scene, p, t.times[i], std::span(path.begin(), path.end()).subspan(i * n, n)));
  }

  const Camera camera(all[0].is_in_space());
  Box content;
  for (const Drawing& d : all) content.add(camera.extent(d));
  constexpr int frames = 5;
  constexpr double width = 168, height = 190, gap = 8, below = 26;
  const double scale = scale_to(content, width - 16, height - 16);
  const double high = std::min(height, scale * content.height() + 16);
  const Box window = [&] {
    const double x = scale * (content.left + content.right) / 2,
                 y = scale * (content.top + content.bottom) / 2;
    return Box{x - width / 2, y - high / 2, x + width / 2, y + high / 2};
  }();

  std::string elements;
  for (int k = 0; k < frames; ++k) {
    const std::size_t now = static_cast<std::size_t>(k) * (all.size() - 1) / (frames - 1);
    Sketch sketch(camera, scale);
    sketch.add(all[now], Sketch::With::motion_alone);
    for (std::size_t b = 0; b < all[0].primitives().size(); ++b) {
      if (!all[0].primitives()[b].leaves_trail) continue;
      std::vector<Place> way;
      for (std::size_t i = 0; i <= now; ++i) way.push_back(all[i].primitives()[b].points[0]);
      sketch.add_trail(way, anchor_of(all[now]));
    }
    const double left = k * (width + gap);
    elements += "<svg x=\"" + pixels(left) + "\" y=\"0\" " + view_box(window) + ">\n" + sketch.elements() +
                "</svg>\n<text class=\"n\" x=\"" + pixels(left + width / 2) + "\" y=\"" + pixels(high + 19) +
                "\">" + format_significant(times[now], 3) + " " + in_xml(t.time_unit) + "</text>\n";
  }
  return svg({0, 0, frames * (width + gap) - gap, high + below}, title_of(e, "the motion"), elements);
}

}  // namespace oddity
