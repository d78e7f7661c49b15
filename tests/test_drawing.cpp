// Drawings of the scenes: each is drawn wherever its motion leads, rigid parts stay rigid, and the pictures
// are complete.

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stack>

#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/charts/drawing.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

using Kind = Drawing::Kind;
using Primitive = Drawing::Primitive;
using Observed = std::vector<double>;

/// The exercises that are scenes.
std::vector<const Entry*> scenes() {
  std::vector<const Entry*> all;
  for (const Entry& e : registry())
    if (of_the_book(e.number) && e.exercise.scene) all.push_back(&e);
  return all;
}

const Entry& entry(const char* number) {
  return *std::ranges::find(registry(), exercise_number(number), &Entry::number);
}

Drawing drawn(const Entry& e, double t, const Observed& observed) {
  Drawing drawing;
  e.exercise.scene->draw(Parameters(e.exercise.parameters), t, observed, drawing);
  return drawing;
}

/// The exercise's motion by Runge-Kutta 4 at its smallest step.
struct Motion {
  std::vector<double> times;
  std::vector<Observed> observed;

  explicit Motion(const Entry& e) {
    const Scene& scene = *e.exercise.scene;
    const Parameters p(e.exercise.parameters);
    const Quantity seen = scene.motion(p, {scene.horizon, 24}, Reference::nothing());
    const std::size_t n = scene.axes.observables.size();
    times = {0};
    observed = {observed_at_start(scene, p)};
    for (const Method& m : seen.methods) {
      if (m.algorithm != "Runge-Kutta 4" || observed.size() > 1) continue;
      const Value all = run(seen, m, m.resolution.settings.back()).answer.value;
      for (std::size_t i = 0; i + n <= all.size(); i += n) {
        observed.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                              all.begin() + static_cast<std::ptrdiff_t>(i + n));
        times.push_back(scene.horizon * static_cast<double>(times.size()) / 24);
      }
    }
  }
};

double length(const Place& a) { return std::hypot(a.x, a.y, a.z); }
double way(const std::vector<Place>& through) {
  double all = 0;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) all += length(through[i + 1] - through[i]);
  return all;
}

std::vector<Primitive> of(const Drawing& drawing, Kind kind) {
  std::vector<Primitive> all;
  for (const Primitive& p : drawing.primitives())
    if (p.kind == kind) all.push_back(p);
  return all;
}
std::vector<double> ways(const Drawing& drawing, Kind kind) {
  std::vector<double> all;
  for (const Primitive& p : of(drawing, kind)) all.push_back(way(p.points));
  return all;
}

/// Number of points of a shape of this kind; 0: any number from two on.
std::size_t points_of(Kind kind) {
  static const std::map<Kind, std::size_t> many{{Kind::body, 1},   {Kind::rod, 2},    {Kind::spring, 2},
                                                {Kind::disc, 2},   {Kind::sphere, 1}, {Kind::axis, 2},
                                                {Kind::arrow, 2},  {Kind::anchor, 1}, {Kind::angle, 3},
                                                {Kind::length, 2}, {Kind::label, 1},  {Kind::direction, 2}};
  const auto found = many.find(kind);
  return found == many.end() ? 0 : found->second;
}

bool finite(const Drawing& drawing) {
  return std::ranges::all_of(drawing.primitives(), [](const Primitive& p) {
    return std::isfinite(p.size) && std::ranges::all_of(p.points, [](const Place& x) {
             return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
           });
  });
}

/// "θ1" under its parameter's name.
std::string name_of(std::string_view letter) {
  std::string name(letter);
  for (const auto& [sign, word] : std::map<std::string, std::string>{
           {"θ", "theta"}, {"φ", "phi"}, {"ψ", "psi"}, {"λ", "lambda"}, {"ℓ", "l"}})
    if (name.starts_with(sign)) name.replace(0, sign.size(), word);
  return name;
}

bool known(const Entry& e, std::string_view letter) {
  static const std::set<std::string_view> words{"",  "x", "y", "z", "x1",    "x2", "x3",
                                                "v", "0", "r", "u", "r × u", "45°"};
  const std::string name = name_of(letter);
  return words.contains(letter) || std::ranges::count(e.exercise.parameters, name, &Parameter::name) > 0 ||
         std::ranges::count(e.exercise.scene->axes.observables, name) > 0;
}

/// Whether the text is one element of XML in which all tags are closed.
bool well_formed(std::string_view text) {
  std::stack<std::string_view> open;
  std::size_t roots = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '<') {
      if (text[i] == '>' || (open.empty() && !std::isspace(static_cast<unsigned char>(text[i]))))
        return false;
      if (text[i] == '&') {
        const std::size_t end = text.find(';', i);
        if (end == text.npos) return false;
        const std::string_view name = text.substr(i + 1, end - i - 1);
        if (name != "amp" && name != "lt" && name != "gt" && name != "quot") return false;
      }
      ++i;
      continue;
    }
    const std::size_t end = text.find('>', i);
    if (end == text.npos) return false;
    std::string_view tag = text.substr(i + 1, end - i - 1);
    if (std::ranges::count(tag, '"') % 2 != 0 || tag.find('<') != tag.npos) return false;
    i = end + 1;
    const std::string_view name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.starts_with('/')) {
      if (open.empty() || open.top() != tag.substr(1)) return false;
      open.pop();
    } else {
      roots += open.empty();
      if (!tag.ends_with('/')) open.push(name);
    }
  }
  return open.empty() && roots == 1;
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != text.npos; i = text.find(part, i + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("Every scene draws itself along its motion", "[drawing]") {
  CHECK(scenes().size() == 18);
  for (const Entry* e : scenes()) {
    INFO(to_string(e->number));
    REQUIRE(e->exercise.scene->draw);
    const Motion motion(*e);
    REQUIRE(motion.times.size() == 25);
    for (std::size_t i = 0; i < motion.times.size(); ++i) {
      REQUIRE(motion.observed[i].size() == e->exercise.scene->axes.observables.size());
      const Drawing drawing = drawn(*e, motion.times[i], motion.observed[i]);
      CHECK(finite(drawing));
      for (const Primitive& p : drawing.primitives()) {
        INFO("letter " << p.letter);
        CHECK(known(*e, p.letter));
        const std::size_t many = points_of(p.kind);
        CHECK((many == 0 ? p.kind == Kind::support || p.points.size() >= 2 : p.points.size() == many));
      }
    }
  }
}

TEST_CASE("A drawing is finite wherever a wrong motion leads, and moves with it", "[drawing]") {
  Random random(18);
  for (const Entry* e : scenes()) {
    INFO(to_string(e->number));
    const std::size_t n = e->exercise.scene->axes.observables.size();
    for (double size : {0.0, 1.0, 1e3, 1e9})
      for (int i = 0; i < 20; ++i) {
        Observed any(n);
        for (double& x : any) x = size * random.between(-1, 1);
        CHECK(finite(drawn(*e, random.between(0, e->exercise.scene->horizon), any)));
      }
    const Observed start = observed_at_start(*e->exercise.scene, Parameters(e->exercise.parameters));
    for (std::size_t k = 0; k < n; ++k) {
      INFO("observable " << k);
      Observed other = start;
      other[k] += 0.125;
      const auto before = drawn(*e, 0, start).primitives(), after = drawn(*e, 0, other).primitives();
      REQUIRE(before.size() == after.size());
      bool moved = false;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Kind kind = before[i].kind;
        if (kind == Kind::body || kind == Kind::plate || kind == Kind::disc || kind == Kind::arrow)
          for (std::size_t j = 0; j < before[i].points.size(); ++j)
            moved |= length(after[i].points[j] - before[i].points[j]) > 1e-3;
      }
      CHECK(moved);
    }
  }
}

TEST_CASE("A drawing is finite at all parameters", "[drawing]") {
  Random random(3);
  for (const Entry* e : scenes()) {
    INFO(to_string(e->number));
    for (int i = 0; i < 100; ++i) {
      Parameters p(e->exercise.parameters);
      for (const Parameter& x : p.declared()) {
        if (x.whole) continue;
        const int end = random.below(4);  // its least, its largest, or one in between
        p.set(x.name, end == 0 ? x.least : end == 1 ? x.most : random.between(x.least, x.most));
        INFO(x.name << " = " << p[x.name]);
      }
      if (e->number == Number{3, 13} && p["H"] >= p["L"]) continue;  // no chute
      Observed any(e->exercise.scene->axes.observables.size());
      for (double& x : any) x = random.between(-1, 1);
      Drawing drawing;
      e->exercise.scene->draw(p, random.between(0, e->exercise.scene->horizon), any, drawing);
      CHECK(finite(drawing));
      CHECK(well_formed(setup_svg(drawing, "")));
    }
  }
}

TEST_CASE("The start that a scene shows is its start", "[drawing]") {
  const auto start = [](const char* number) {
    const Entry& e = entry(number);
    return observed_at_start(*e.exercise.scene, Parameters(e.exercise.parameters));
  };
  CHECK(near_ulps(start("3.5")[0], 0.5235987755982988, 64));
  CHECK(near(start("3.19")[0], 1, 1e-6));
  CHECK(near(start("3.19")[1], 2.5, 1e-6));
  CHECK(near(start("3.31")[2], 0, 1e-6));
  const Observed frame = start("2.7");
  for (std::size_t k = 0; k < 9; ++k) CHECK(near(frame[k], k % 4 == 0 ? 1 : 0, 1e-6));
}

TEST_CASE("Rigid parts have the same length at every time", "[drawing]") {
  struct Rigid {
    const char* number;
    Kind kind;
    std::vector<double> lengths;  ///< lengths of the first ones of this kind
  };
  const std::vector<Rigid> all{
      {"3.5", Kind::rod, {1}},         {"3.17", Kind::rope, {1}},           {"3.21", Kind::rod, {2}},
      {"3.23", Kind::rod, {0.5, 0.5}}, {"3.25", Kind::rod, {1, 0.75, 0.5}}, {"3.33", Kind::rod, {0.5}},
      {"3.35", Kind::rod, {0.5}}};
  for (const auto& [number, kind, lengths] : all) {
    INFO(number);
    const Motion motion(entry(number));
    for (std::size_t i = 0; i < motion.times.size(); ++i) {
      const auto seen = ways(drawn(entry(number), motion.times[i], motion.observed[i]), kind);
      for (std::size_t k = 0; k < lengths.size(); ++k) CHECK(near_part(seen.at(k), lengths[k], 1e-5));
    }
  }
}

TEST_CASE("The machine's ropes keep their lengths, and its springs have those of the equations",
          "[drawing]") {
  const Entry& e = entry("3.19");
  const auto ropes = [](const Drawing& d) {
    std::vector<double> all;
    for (const Primitive& p : of(d, Kind::rope))
      if (p.points.size() > 2) all.push_back(way(p.points));
    return all;
  };
  const auto first = ropes(drawn(e, 0, {1, 2.5}));
  REQUIRE(first.size() == 2);
  Random random(19);
  for (int i = 0; i < 50; ++i) {
    const double y2 = random.between(0.9, 1.6), y3 = random.between(2.2, 3);
    const Drawing drawing = drawn(e, 0, {y2, y3});
    const auto now = ropes(drawing), springs = ways(drawing, Kind::spring);
    CHECK(near_ulps(now[0], first[0], 64));
    CHECK(near_ulps(now[1], first[1], 64));
    CHECK(near_ulps(springs[0], y2 + 1, 64));             // S1 = y2 + K1
    CHECK(near_ulps(springs[1], y3 - 2 * y2 + 1.5, 64));  // S2 = y3 - 2 y2 + K2
  }
}

TEST_CASE("Two bodies are drawn about their center of mass, a box and a wire in their shapes", "[drawing]") {
  const Motion orbit(entry("3.27")), box(entry("3.31")), wire(entry("3.29"));
  for (std::size_t i = 0; i < orbit.times.size(); ++i) {
    const auto bodies = of(drawn(entry("3.27"), orbit.times[i], orbit.observed[i]), Kind::body);
    CHECK(length(2 * bodies.at(0).points[0] + bodies.at(1).points[0]) < 1e-12);  // m1 = 2, m2 = 1

    const auto corners = of(drawn(entry("3.31"), box.times[i], box.observed[i]), Kind::plate).at(0).points;
    CHECK(near_ulps(length(corners[1] - corners[0]), 0.6, 64));
    CHECK(near_ulps(length(corners[2] - corners[1]), 0.4, 64));

    const Drawing thrown = drawn(entry("3.29"), wire.times[i], wire.observed[i]);
    const auto pieces = ways(thrown, Kind::rod);
    // The arc of y = x^2 from 0 to 1, by chords.
    CHECK(near_part(std::accumulate(pieces.begin(), pieces.end(), 0.0), 1.4789428, 1e-3));
    const Place mark = of(thrown, Kind::body).at(0).points[0];
    CHECK(length(of(thrown, Kind::rod).at(0).points[0] - mark) < 1e-12);
    // Its center flies like a thrown stone.
    const double t = wire.times[i];
    CHECK(length(of(thrown, Kind::disc).at(0).points[0] - Place{2 * t, 5 * t - 9.81 / 2 * t * t}) < 1e-5);
  }
}

TEST_CASE("The pictures of every scene are complete", "[drawing]") {
  for (const Entry* e : scenes()) {
    INFO(to_string(e->number));
    const std::string setup = setup_svg(*e);
    CHECK(well_formed(setup));
    CHECK(has(setup, "<title>" + to_string(e->number) + " "));
    CHECK(!has(setup, "nan"));
    CHECK(!has(setup, "inf"));
    std::set<std::string_view> letters;
    const Observed start = observed_at_start(*e->exercise.scene, Parameters(e->exercise.parameters));
    const Drawing drawing = drawn(*e, 0, start);
    for (const Primitive& p : drawing.primitives())
      if (!p.letter.empty()) letters.insert(p.letter);
    CHECK(count(setup, "<text") >= letters.size());

    const Motion motion(*e);
    std::vector<double> path;
    for (std::size_t i = 1; i < motion.observed.size(); ++i)
      path.insert(path.end(), motion.observed[i].begin(), motion.observed[i].end());
    Trajectory t;
    t.time_unit = std::string(e->exercise.scene->axes.time);
    t.times.assign(motion.times.begin() + 1, motion.times.end());
    t.paths.resize(1);
    t.paths[0].value = path;
    const std::string frames = frames_svg(*e, t);
    CHECK(well_formed(frames));
    CHECK(!has(frames, "nan"));
    CHECK(count(frames, "<svg") == 6);
    CHECK(has(frames, ">0 " + t.time_unit + "<"));
  }
  CHECK(setup_svg(entry("2.1")).empty());
}

TEST_CASE("A drawing's letters and titles are text, whatever they contain", "[drawing]") {
  Drawing drawing;
  drawing.body({1, 0}, 0.1, "<script>alert(1)</script>");
  drawing.label({}, "a&b\"'>");
  drawing.length({}, {1, 0}, "]]>");
  const std::string picture = setup_svg(drawing, "</title><script>&");
  CHECK(well_formed(picture));
  CHECK(!has(picture, "<script"));
  CHECK(has(picture, "&lt;script&gt;"));
  CHECK(has(picture, "a&amp;b"));
}

TEST_CASE("A bad drawing still gives a picture", "[drawing]") {
  Drawing nothing, point, dot;
  point.body({}, 0);
  dot.rod({1, 1}, {1, 1});
  dot.spring({}, {}, 0);
  dot.axis({}, {}, "x");
  dot.angle({}, {}, {1, 0}, "a");
  for (const Drawing& d : {nothing, point, dot}) {
    const std::string picture = setup_svg(d, "");
    CHECK(well_formed(picture));
    CHECK(!has(picture, "nan"));
    CHECK(!has(picture, "inf"));
  }
}
