#include "report/site/moving_picture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chapters/contents.hpp"
#include "chapters/drawing.hpp"
#include "reference/text.hpp"
#include "report/charts/drawing.hpp"
#include "report/charts/sketch.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using Kind = Drawing::Kind;
using html::element;

/// A motion as drawings at evenly spaced times, until it ends.
using Film = std::vector<Drawing>;

Film film_of(const Path& path, const Trajectory& t, const Entry& entry, std::size_t frames) {
  const std::size_t count = t.observables.size();
  const Parameters parameters(entry.exercise.parameters);
  Film film;
  for (std::size_t k = 0; k < frames; ++k) {
    const std::size_t at = k * (t.times.size() - 1) / (frames - 1);
    if ((at + 1) * count > path.value.size()) break;
    const std::vector<double> observed(path.value.begin() + static_cast<long>(at * count),
                                       path.value.begin() + static_cast<long>((at + 1) * count));
    if (!std::ranges::all_of(observed, [](double x) { return std::isfinite(x); })) break;
    film.emplace_back();
    entry.exercise.scene->draw(parameters, t.times[at], observed, film.back());
  }
  return film;
}

bool is_shown(Kind kind) {
  return kind == Kind::body || kind == Kind::rod || kind == Kind::rope || kind == Kind::spring ||
         kind == Kind::track || kind == Kind::disc || kind == Kind::plate || kind == Kind::arrow;
}

/// Maps the scene's lengths to the picture's.
class View {
 public:
  static constexpr double side = 320, margin = 16;

  explicit View(const Film& film) : camera_(film.front().is_in_space()) {
    for (const Drawing& drawing : film) box_.add(camera_.extent(drawing));
    scale_ = (side - 2 * margin) / std::max({box_.width(), box_.height(), 1e-12});
  }

  double scale() const { return scale_; }
  Spot operator()(const Place& p, const Drawing& drawing) const {
    const Spot s = camera_.at(p - anchor_of(drawing));
    return {side / 2 + scale_ * (s.x - (box_.left + box_.right) / 2),
            side / 2 + scale_ * (s.y - (box_.top + box_.bottom) / 2)};
  }

 private:
  Camera camera_;
  Box box_;
  double scale_ = 1;
};

std::string pixels(double x) { return format_significant(std::round(std::clamp(x, -999.0, 999.0)), 3); }
std::string pair(Spot s) { return pixels(s.x) + "," + pixels(s.y); }

std::string points_text(const Drawing::Primitive& p, const View& view, const Drawing& drawing) {
  std::string text;
  const std::size_t most = p.kind == Kind::track ? 60 : 12;
  const std::size_t last = p.points.size() - 1, count = std::min(most, last);
  for (std::size_t i = 0; i <= count; ++i)
    text += (i == 0 ? "" : " ") + pair(view(p.points[count == 0 ? 0 : i * last / count], drawing));
  return text;
}

/// An attribute's initial value, and its changes.
struct Moving {
  std::string name;
  std::vector<std::string> values = {};
};

std::string shape(const std::string& tag, const std::string& still, std::vector<Moving> attributes,
                  double seconds) {
  std::string text = "<" + tag + still, changes;
  for (const Moving& attribute : attributes) {
    text += " " + attribute.name + "=\"" + attribute.values.front() + "\"";
    if (std::ranges::all_of(attribute.values, [&](const auto& v) { return v == attribute.values.front(); }))
      continue;
    changes += "<animate attributeName=\"" + attribute.name + "\" dur=\"" + format_significant(seconds, 3) +
               "s\" begin=\"indefinite\" repeatCount=\"indefinite\" values=\"";
    for (const std::string& value : attribute.values) changes += value + ";";
    changes.back() = '"';
    changes += "/>";
  }
  return text + ">" + changes + "</" + tag + ">";
}

/// One primitive throughout the film.
std::string primitive_text(const Film& film, std::size_t which, const View& view, double seconds) {
  const auto& first = film.front().primitives()[which];
  const auto still = [](const std::string& name) { return " class=\"" + name + "\""; };
  if (first.kind == Kind::body || first.kind == Kind::disc) {
    Moving x{"cx"}, y{"cy"};
    for (const Drawing& drawing : film) {
      const Spot s = view(drawing.primitives()[which].points.front(), drawing);
      x.values.push_back(pixels(s.x)), y.values.push_back(pixels(s.y));
    }
    const double size = view.scale() * first.size,
                 radius = first.kind == Kind::disc ? size : std::clamp(size, 7.0, 18.0);
    const std::string name = first.kind == Kind::body ? "body" : "disc";
    return shape("circle", still(name) + " r=\"" + pixels(radius) + "\"", {x, y}, seconds);
  }
  Moving points{"points"};
  for (const Drawing& drawing : film)
    points.values.push_back(points_text(drawing.primitives()[which], view, drawing));
  const std::string name = first.kind == Kind::track    ? "track"
                           : first.kind == Kind::spring ? "spring"
                           : first.kind == Kind::plate  ? "plate"
                                                        : "rod";
  return shape(first.kind == Kind::plate ? "polygon" : "polyline", still(name), {points}, seconds);
}

/// The moving or the fixed parts of a film.
std::string layer_text(const Film& film, const View& view, double seconds, bool background) {
  std::string text;
  for (std::size_t i = 0; i < film.front().primitives().size(); ++i) {
    const Kind kind = film.front().primitives()[i].kind;
    const bool stands = kind == Kind::track;
    const bool always = std::ranges::all_of(film, [&](const Drawing& drawing) {
      return i < drawing.primitives().size() && drawing.primitives()[i].kind == kind;
    });
    if (is_shown(kind) && stands == background && always) text += primitive_text(film, i, view, seconds);
  }
  return text;
}

/// A film that ends early stays at its last drawing.
void prolong(Film& film, std::size_t frames) {
  while (!film.empty() && film.size() < frames) film.push_back(film.back());
}

}  // namespace

std::string moving_picture(const ExerciseResult& e) {
  constexpr std::size_t frames = 40;
  const auto entry = std::ranges::find(registry(), e.number, &Entry::number);
  const Path* published = published_path(e);
  if (!published || entry == registry().end() || !entry->exercise.scene || !entry->exercise.scene->draw)
    return "";
  const Trajectory& t = *trajectory_of(e);
  if (t.times.size() < frames || t.observables.empty() || published->error <= t.close) return "";
  Film truth = film_of(true_path(t), t, *entry, frames), wrong = film_of(*published, t, *entry, frames);
  if (truth.empty() || wrong.empty() || truth.front().primitives().empty()) return "";
  const View view(truth);
  prolong(truth, frames), prolong(wrong, frames);
  const double seconds = std::clamp(t.times.back(), 4.0, 10.0);
  return "<figure class=\"thumb\"><svg viewBox=\"0 0 320 320\" role=\"img\" aria-label=\"" +
         in_xml("The motion of the published version, " + published->model + ", and the true one") + "\">" +
         element("g", " class=\"still\"", layer_text(truth, view, seconds, true)) +
         element("g", " class=\"truth\"", layer_text(truth, view, seconds, false)) +
         element("g", " class=\"published\"", layer_text(wrong, view, seconds, false)) +
         "</svg><figcaption><span class=\"truth\">true</span> <span class=\"published\">" +
         in_xml(published->model) + "</span></figcaption></figure>\n";
}

}  // namespace oddity
