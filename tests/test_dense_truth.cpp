// The true motion at every frame: compared with integrations that share nothing with its generators, compared
// with the tables, and kept from run to run.

#include <algorithm>
#include <array>
#include <complex>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include "chapters/contents.hpp"
#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "reference/truth.hpp"
#include "report/study/parallel.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const fs::path tables = fs::path(ODDITY_SOURCE) / "reference";

const Reference& known() {
  static const Reference all(tables);
  return all;
}

// ---- compared with integrations ---------------------------------------------------------------------------

/// The scene's parameters, with each number of its start up to a tenth off.
Parameters beside(const Exercise& exercise, Random& random) {
  Parameters p(exercise.parameters);
  for (std::string_view name : exercise.scene->perturbed_parameters) {
    const Parameter& declared = *std::ranges::find(exercise.parameters, name, &Parameter::name);
    const double size = p[name] == 0 ? 1 : std::abs(p[name]);
    p.set(name, std::clamp(p[name] + size * random.between(-0.1, 0.1), declared.least, declared.most));
  }
  return p;
}

/// A start of a scene, and the model that comes nearest to the reference.
struct Case {
  const Entry* entry;
  Parameters parameters;
  Horizon horizon{0, 1, 60};
  std::string nearest = "none";
  double error = std::numeric_limits<double>::infinity();  ///< largest error at any frame
  double known_to = 0;       ///< difference of the two integrations, plus the reference's own error
  double one_frame_off = 0;  ///< the error of the same motion read a frame late
};

/// The motion shifted by one frame.
Value late(const Value& motion, int frames) {
  const std::size_t parts = motion.size() / static_cast<std::size_t>(frames);
  Value shifted = motion;
  for (std::size_t i = motion.size(); i-- > parts;) shifted[i] = shifted[i - parts];
  return shifted;
}

/// Finds the model that Fehlberg 7(8) at 1e-13 brings nearest. Its difference from the same model by
/// Dormand-Prince 5(4) at 1e-9 is the error of the coarser one. That bounds the error of the finer one,
/// except for a rounding per frame.
void follow(Case& c) {
  const Quantity dense = motion(*c.entry->exercise.scene, c.parameters, c.horizon, known());
  Value nearest;
  for (const Method& method : dense.methods) {
    if (method.algorithm != "Fehlberg 7(8)") continue;
    const Answer fine = method.run(1e-13);
    const double error = fine.reached() ? distance(fine.value, dense.reference.value) : std::nan("");
    if (!(error < c.error)) continue;
    c.nearest = method.model;
    c.error = error;
    nearest = fine.value;
  }
  const Method* coarser = method_of(dense, c.nearest, "Dormand-Prince 5(4)");
  if (!coarser) return;
  c.known_to = distance(nearest, coarser->run(1e-9).value) + dense.reference_error +
               rounding(size_of(nearest), dense.samples).allowed;
  c.one_frame_off = distance(late(nearest, dense.samples), dense.reference.value);
}

std::vector<Case> two_starts_of_each_scene() {
  std::vector<Case> cases;
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    Random random(100.0 * entry.number.chapter + entry.number.index);
    for (int start = 0; start < 2; ++start)
      cases.push_back(
          {&entry, beside(entry.exercise, random), {std::min(entry.exercise.scene->horizon, 3.0), 1, 60}});
  }
  return cases;
}

}  // namespace

TEST_CASE("at every frame the true motion agrees with a model that shares nothing with it", "[truth]") {
  std::vector<Case> cases = two_starts_of_each_scene();
  parallel_for_each(cases, follow);
  for (const Case& c : cases) {
    INFO(to_string(c.entry->number) << ": " << c.nearest << " is off by " << c.error << " and knows to "
                                    << c.known_to);
    CHECK(c.error <= c.known_to);
    CHECK(c.known_to < 1e-6 * c.one_frame_off);
  }
}

// ---- compared with separate integrations: none of the program's equations, none of its algorithms
// ----------

namespace {

using State = std::vector<double>;
using Slope = std::function<State(const State&)>;

/// Classical Runge-Kutta with 256 steps a frame, extrapolated at each frame with half as many: order 5.
State next_frame(const Slope& slope, const State& from, double frame) {
  const auto moved = [](State x, double by, const State& v) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * v[i];
    return x;
  };
  const auto in_steps = [&](int steps) {
    State x = from;
    const double h = frame / steps;
    for (int k = 0; k < steps; ++k) {
      const State a = slope(x), b = slope(moved(x, h / 2, a)), c = slope(moved(x, h / 2, b)),
                  d = slope(moved(x, h, c));
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return x;
  };
  State fine = in_steps(256);
  const State coarse = in_steps(128);
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] += (fine[i] - coarse[i]) / 15;
  return fine;
}

/// A table's motion by its physics.
struct Physics {
  std::string table;
  State inputs, start;
  Slope slope;
  std::function<State(const State&)> seen;
};

Physics pendulum(double a, double L, double g) {
  return {"03_05_swing",
          {a, L, g},
          {a, 0},
          [=](const State& x) -> State {
            return {x[1], -g * std::sin(x[0]) / L};
          },
          [](const State& x) -> State { return {x[0]}; }};
}

/// From its energy m r^2 w^2/2 + m g r sin + c/2 (d - ell)^2. There d^2 = h^2 + 2 s^2 + 2 s (h sin - s cos).
Physics bar(double m, double r, double s, double c, double h, double g, double ell, double angle, double w) {
  const auto slope = [=](const State& x) -> State {
    const double C = std::cos(x[0]), S = std::sin(x[0]);
    const double d = std::sqrt(h * h + 2 * s * s + 2 * s * (h * S - s * C));
    const double up = m * g * r * C + c * (d - ell) * s * (h * C + s * S) / d;
    return {x[1], -up / (m * r * r)};
  };
  return {"03_23_swing", {m, r, s, c, h, g, ell, angle, w}, {angle, w}, slope, [r](const State& x) -> State {
            return {r * std::cos(x[0]), r * std::sin(x[0])};
          }};
}

/// The second body relative to the first one, in complex numbers.
Physics two_bodies(double G, double m1, double m2, double r, double dr, double phi, double dphi) {
  using Plane = std::complex<double>;
  const Plane z = std::polar(r, phi), dz = Plane(dr, r * dphi) * std::polar(1.0, phi);
  const auto slope = [=](const State& x) -> State {
    const Plane at(x[0], x[1]), pull = -G * (m1 + m2) / std::pow(std::abs(at), 3) * at;
    return {x[2], x[3], pull.real(), pull.imag()};
  };
  return {"03_27_two_bodies",
          {G, m1, m2, r, dr, phi, dphi},
          {z.real(), z.imag(), dz.real(), dz.imag()},
          slope,
          [](const State& x) -> State {
            return {x[0], x[1]};
          }};
}

/// A direction, and its rate across it. Otherwise rounding along it would grow tenfold in a third of a
/// second.
std::pair<std::array<double, 3>, std::array<double, 3>> on_the_sphere(const State& x) {
  const double size = std::hypot(x[0], x[1], x[2]);
  const std::array d{x[0] / size, x[1] / size, x[2] / size};
  const double along = d[0] * x[3] + d[1] * x[4] + d[2] * x[5];
  return {d, {x[3] - along * d[0], x[4] - along * d[1], x[5] - along * d[2]}};
}

/// The axis d and its rate: mu1 d x d'' + mu3 spin d' = l d x (-m g k), d.d = 1.
Physics top(double m, double l, double mu1, double mu3, double g, const std::array<double, 6>& angles) {
  const auto [theta, phi, psi, dtheta, dphi, dpsi] = angles;
  const double S = std::sin(theta), C = std::cos(theta), s = std::sin(phi), c = std::cos(phi);
  const double spin = dpsi + dtheta * c;
  const auto slope = [=](const State& x) -> State {
    const auto [d, v] = on_the_sphere(x);
    const double squares = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const std::array turn{d[1] * v[2] - d[2] * v[1], d[2] * v[0] - d[0] * v[2], d[0] * v[1] - d[1] * v[0]};
    // d'' = -d'^2 d + (mu3 spin d x d' - m g l (k - (k.d) d))/mu1 with the torque turned across d.
    const auto across = [&, &d = d](std::size_t i) { return (i == 2 ? 1 : 0) - d[2] * d[i]; };
    const auto a = [&, &d = d](std::size_t i) {
      return -squares * d[i] + (mu3 * spin * turn[i] - m * g * l * across(i)) / mu1;
    };
    return {v[0], v[1], v[2], a(0), a(1), a(2)};
  };
  return {"03_33_axis",
          {m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi},
          {S * s, -C * s, c, C * dtheta * s + S * c * dphi, S * dtheta * s - C * c * dphi, -s * dphi},
          slope,
          [](const State& x) -> State {
            return {x[0], x[1], x[2]};
          }};
}

/// The largest difference over 180 frames, at 60 a second.
double differs(const Physics& physics) {
  constexpr int frames = 180;
  constexpr double frame = 1.0 / 60;
  std::vector<double> times;
  for (int k = 1; k <= frames; ++k) times.push_back(k / 60.0);
  const Known known = Reference(tables).motion(physics.table, physics.inputs, times);
  State x = physics.start;
  double most = 0;
  std::size_t at = 0;
  for (int k = 0; k < frames; ++k) {
    x = next_frame(physics.slope, x, frame);
    for (double component : physics.seen(x)) {
      const double off = std::abs(component - known.value[at++]);
      if (!(off <= most)) most = off;
    }
  }
  return at == known.value.size() ? most : std::nan("");
}

}  // namespace

TEST_CASE("at every frame the true motion agrees with a separate integration", "[truth]") {
  std::vector<std::pair<Physics, double>> all{
      {pendulum(2.7, 1.3, 9.7), 0},
      {bar(1.1, 0.9, 0.6, 90, 0.75, 9.7, 1.05, 0.35, -0.5), 0},
      {two_bodies(1.1, 2, 1.2, 0.9, 0.2, 0.5, 1.4), 0},
      {top(1.1, 0.3, 0.12, 0.06, 9.7, {0.3, 0.6, 0.7, 0.4, 0.2, 28}), 0}};
  parallel_for_each(all, [](auto& one) { one.second = differs(one.first); });
  for (const auto& [physics, off] : all) {
    INFO(physics.table);
    CHECK(off < 2e-12);
  }
}

// ---- compared with the tables -----------------------------------------------------------------------------

namespace {

/// A motion of a table: its inputs without the time, and the times of its rows.
struct Tabulated {
  const truth::Entry* entry;
  std::vector<double> inputs, times;
};

/// A chaotic motion needs many digits, and one with friction needs extrapolation: these take a minute.
const std::set<std::string_view> slow_tables{"03_25_growth", "03_31_slide"};

/// The motions with several times in a table, at most `most` of each table.
std::vector<Tabulated> tabulated_motions(std::size_t most) {
  std::vector<Tabulated> all;
  for (const truth::Entry& entry : truth::registry()) {
    const truth::Truth generator = entry.make();
    if (generator.inputs.back() != "t") continue;
    std::map<std::vector<double>, std::vector<double>> motions;
    for (std::vector<double> row : generator.rows) {
      const double t = row.back();
      row.pop_back();
      motions[row].push_back(t);
    }
    std::size_t taken = 0;
    for (auto& [inputs, times] : motions) {
      std::ranges::sort(times);
      if (times.size() > 1 && times.front() >= 0 && taken++ < most) all.push_back({&entry, inputs, times});
    }
  }
  return all;
}

/// The times, and those halfway between, so that the motion is not the table's.
std::vector<double> with_those_between(const std::vector<double>& times) {
  std::vector<double> all;
  for (double t : times) {
    if (!all.empty()) all.push_back((all.back() + t) / 2);
    all.push_back(t);
  }
  return all;
}

/// Largest difference of a new motion from the table's rows, in units of the sum of their errors.
double off_the_rows(const Tabulated& motion) {
  const Known dense = known().motion(motion.entry->name, motion.inputs, with_those_between(motion.times));
  if (dense.source.find("on the spot") == std::string::npos) return std::nan("");
  const std::size_t parts = dense.value.size() / (2 * motion.times.size() - 1);
  double off = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    std::vector<double> row = motion.inputs;
    row.push_back(motion.times[k]);
    const Known stored = known()(motion.entry->name, row);
    for (std::size_t i = 0; i < parts; ++i)
      off = std::max(
          off, std::abs(dense.value[2 * k * parts + i] - stored.value[i]) / (dense.error + stored.error));
  }
  return off;
}

void require_on_the_rows(const std::vector<Tabulated>& motions) {
  std::vector<std::pair<const Tabulated*, double>> off;
  for (const Tabulated& motion : motions) off.emplace_back(&motion, std::nan(""));
  parallel_for_each(off, [](auto& one) { one.second = off_the_rows(*one.first); });
  for (const auto& [motion, errors] : off) {
    INFO(motion->entry->name << " to t = " << motion->times.back());
    CHECK(errors <= 1);
  }
}

}  // namespace

TEST_CASE("a motion that is computed again goes through the rows of its table", "[truth]") {
  std::vector<Tabulated> motions = tabulated_motions(1);
  std::erase_if(motions, [](const Tabulated& motion) { return slow_tables.contains(motion.entry->name); });
  CHECK(motions.size() >= 18);
  require_on_the_rows(motions);
}

TEST_CASE("every tabulated motion that is computed again goes through its rows", "[truth][slow]") {
  require_on_the_rows(tabulated_motions(1000));
}

// ---- kept from run to run ---------------------------------------------------------------------------------

namespace {

const std::vector<double> tenths{0.1, 0.2, 0.3, 0.4};

Known swing(const Reference& by, const std::vector<double>& inputs = {0.7, 1, 9.81},
            const std::vector<double>& times = tenths) {
  return by.motion("03_05_swing", inputs, times);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& file : fs::directory_iterator(folder)) files.push_back(file.path());
  return files;
}

/// A cache that contains this one motion.
struct Kept {
  ScratchFolder folder;
  Reference reference{tables, folder.path()};
  Known made = swing(reference);
  fs::path file = files_in(folder.path()).at(0);
  std::string text = text_of(file);

  /// The values read when the file has this text.
  std::vector<double> read(const std::string& changed) const {
    folder.file(file.filename().string(), changed);
    return swing(reference).value;
  }
};

}  // namespace

TEST_CASE("a motion read back is the motion made, in every bit", "[truth]") {
  const Kept kept;
  const Known again = swing(Reference(tables, kept.folder.path()));
  CHECK(again.value == kept.made.value);
  CHECK(again.value == swing(known()).value);
  CHECK(again.error == kept.made.error);
  CHECK(again.source == kept.made.source);
  int ticks = 0;
  swing(kept.reference.watched([&](double) { ++ticks; }));
  CHECK(ticks == 0);  // nothing was made
  swing(known().watched([&](double) { ++ticks; }));
  CHECK(ticks > 0);
}

TEST_CASE("a kept motion that is damaged anywhere is computed again", "[truth]") {
  const Kept kept;
  for (std::size_t length = 0; length < kept.text.size(); length += 7) {
    INFO("cut after " << length << " of " << kept.text.size());
    CHECK(kept.read(kept.text.substr(0, length)) == kept.made.value);
  }
  for (std::size_t at = 0; at < kept.text.size(); at += 5) {
    std::string changed = kept.text;
    changed[at] = changed[at] == '7' ? '3' : '7';
    INFO("another character at " << at << ":\n" << changed);
    CHECK(kept.read(changed) == kept.made.value);
  }
  CHECK(kept.read(kept.text + "1\n") == kept.made.value);
  CHECK(kept.read(kept.text) == kept.made.value);
}

TEST_CASE("a motion of other inputs, times or generators is kept separately", "[truth]") {
  const Kept kept;
  const auto count = [&] { return files_in(kept.folder.path()).size(); };
  CHECK(count() == 1);
  swing(kept.reference, {0.7000000000000001, 1, 9.81});
  CHECK(count() == 2);
  swing(kept.reference, {0.7, 1, 9.81}, {0.1, 0.2, 0.3, 0.4000000000000001});
  CHECK(count() == 3);
  swing(kept.reference, {0.7, 1, 9.81}, {0.1, 0.2, 0.3});
  CHECK(count() == 4);
  swing(kept.reference);
  CHECK(count() == 4);

  const std::string print(truth::fingerprint_of_generators);
  const std::size_t at = kept.text.find(print);
  REQUIRE(print.size() == 64);
  REQUIRE(at != std::string::npos);
  std::string foreign = kept.text;
  foreign[at] = foreign[at] == '0' ? '1' : '0';
  CHECK(kept.read(foreign) == kept.made.value);
  CHECK(text_of(kept.file) == kept.text);
}

TEST_CASE("a motion to other digits is kept separately", "[truth]") {
  const Kept kept;
  swing(kept.reference.to_digits(20));
  CHECK(files_in(kept.folder.path()).size() == 2);
}

TEST_CASE("a kept motion that is changed and sealed again is recomputed where long double disagrees",
          "[truth][forged]") {
  const Kept kept;
  const std::string key = kept.text.substr(0, kept.text.find('\n') + 1);
  const auto sealed = [&](double error, const std::vector<double>& values) {
    std::string text = key + format_shortest(error) + "\n";
    for (double x : values) text += format_shortest(x) + "\n";
    return text + checksum(text) + "\n";
  };
  const std::vector<double>& made = kept.made.value;
  const double error = kept.made.error;
  REQUIRE(sealed(error, made) == kept.text);
  const auto is_made_again = [&](double forged_error, const std::vector<double>& values) {
    const bool same = kept.read(sealed(forged_error, values)) == made;
    return same && text_of(kept.file) == kept.text;
  };
  std::vector<double> small_angle, changed = made, twice = made;
  for (double t : tenths) {
    const double rate = std::sqrt(9.81);
    small_angle.insert(small_angle.end(), made.size() / tenths.size(), 0.7 * std::cos(rate * t));
  }
  CHECK(is_made_again(error, small_angle));
  for (double by : {1e-6, -1e-12}) {
    changed.back() = made.back() + by;
    CHECK(is_made_again(error, changed));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (double x : {infinity, -infinity, std::nan("")}) {
    changed.back() = x;
    CHECK(is_made_again(error, changed));
  }
  twice.insert(twice.end(), made.begin(), made.end());
  CHECK(is_made_again(error, twice));
  CHECK(is_made_again(error, {}));
  CHECK(is_made_again(error, {made.front()}));
  for (double none : {0.0, -1.0, 1.0, infinity, std::nan("")}) CHECK(is_made_again(none, made));
}

TEST_CASE("a cache that cannot be written is not used", "[truth]") {
  const ScratchFolder folder;
  const fs::path no_folder = folder.file("a file", "");
  CHECK(swing(Reference(tables, no_folder)).value == swing(known()).value);
}

TEST_CASE("the fingerprint covers everything that makes a motion", "[truth]") {
  const ScratchFolder scratch;
  const fs::path room = scratch.path() / "reference", print = scratch.path() / "print.cpp";
  fs::create_directories(room / "make");
  for (const fs::path& folder : {fs::path(), fs::path("make")})
    for (const auto& file : fs::directory_iterator(tables / folder))
      if (file.is_regular_file()) fs::copy(file, room / folder / file.path().filename());
  const auto printed = [&] {
    const std::string command = "cmake -DFOLDERS='" + room.string() + "' -DOUT='" + print.string() +
                                "' -P '" + (tables / "fingerprint.cmake").string() + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    return text_of(print);
  };
  const std::string before = printed();
  CHECK(before.find(truth::fingerprint_of_generators) != std::string::npos);
  std::set<std::string> all{before};
  const std::vector<std::string> generators{"truth.cpp",       "truth.hpp",        "reference.cpp",
                                            "make/taylor.cpp", "make/motions.hpp", "make/03_05_swing.cpp"};
  for (const std::string& file : generators) {
    std::ofstream(room / file, std::ios::app) << "// another\n";
    CHECK(all.insert(printed()).second);
  }
}

// ---- progress ---------------------------------------------------------------------------------------------

TEST_CASE("an exception of a watch ends the computation of a motion, and nothing is kept", "[truth]") {
  const ScratchFolder folder;
  const Reference reference(tables, folder.path());
  struct Enough {};
  for (int last : {1, 3}) {
    int ticks = 0;
    const auto ending_with = [&](const auto& exception) {
      ticks = 0;
      return reference.watched([&ticks, last, exception](double) {
        if (++ticks == last) throw exception;
      });
    };
    CHECK_THROWS_AS(swing(ending_with(Enough{})), Enough);
    CHECK(ticks == last);
    CHECK_THROWS_AS(swing(ending_with(OutOfTime("over"))), OutOfTime);
    CHECK_THROWS_AS(swing(ending_with(std::logic_error("over"))), std::logic_error);
  }
  CHECK(files_in(folder.path()).empty());
}

TEST_CASE("a long integration reports progress on its way", "[truth]") {
  int ticks = 0;
  const std::vector<double> top{1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 31};
  known().watched([&](double) { ++ticks; }).motion("03_33_axis", top, std::vector{2.0});
  CHECK(ticks > 10);
}
