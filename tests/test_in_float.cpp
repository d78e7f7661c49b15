// Methods in float: the algorithms, how they are driven, and the possible effect of roundings.

#include <cctype>
#include <cmath>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/in_float.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

/// x' = 1, with a record of the times of its calls.
struct Clock {
  mutable std::vector<float> asked = {};
  void operator()(const std::array<float, 2>&, std::array<float, 2>& dxdt, float t) const {
    asked.push_back(t);
    dxdt = {1, 0};
  }
};

/// x'' = -x.
template <class T>
struct Swing {
  void operator()(const std::array<T, 2>& x, std::array<T, 2>& dxdt, T) const { dxdt = {x[1], -x[0]}; }
  void acceleration(const std::array<T, 1>& q, std::array<T, 1>& a) const { a = {-q[0]}; }
};

template <class T>
using Any = ode::AnySystem<2, T>;

const char* const in_float_too[] = {"explicit Euler",  "symplectic Euler", "semi-implicit Euler",
                                    "velocity Verlet", "Runge-Kutta 4",    "modified midpoint",
                                    "McLachlan 4",     "Adams-Bashforth 4"};

Quantity pendulum_motion(const Horizon& horizon) {
  const Exercise& exercise = std::ranges::find(registry(), exercise_number("3.5"), &Entry::number)->exercise;
  return motion(*exercise.scene, Parameters(exercise.parameters), horizon,
                Reference(std::string(ODDITY_SOURCE) + "/reference"));
}

std::string source(std::string_view file) { return text_of(std::filesystem::path(ODDITY_SOURCE) / file); }

/// The text between the bracket at `open` and its end, split at its own commas. Assumes no comparisons.
std::vector<std::string> parts(std::string_view text, std::size_t open) {
  std::vector<std::string> all(1);
  int depth = 0;
  bool quoted = false;
  for (char c : text.substr(std::min(open, text.size()))) {
    if (c == '"') quoted = !quoted;
    const bool opens = !quoted && std::string_view("([{<").find(c) != std::string_view::npos;
    const bool closes = !quoted && std::string_view(")]}>").find(c) != std::string_view::npos;
    if (closes && --depth == 0) break;
    if (c == ',' && !quoted && depth == 1)
      all.emplace_back();
    else if (depth > 0 && (quoted || !std::isspace(static_cast<unsigned char>(c)) || !all.back().empty()))
      all.back() += c;
    depth += opens;
  }
  return all;
}

/// The model that an expression constructs, without its number type: "OneAngle" for
/// "pendulum::OneAngle<double>{{a, L, g}}".
std::string constructed(const std::string& expression) {
  static const std::regex space("\\b[a-z_]+::"), number("double"), alone("<T>");
  std::string name = std::regex_replace(expression, space, "");
  name = std::regex_replace(name, number, "T");
  name.resize(std::min(name.find_first_of("({"), name.size()));
  return std::regex_replace(name, alone, "");
}

/// The listing's expression for a model in float; empty if it has none of this name.
std::string listed(const Listing& listing, const std::string& name) {
  const auto found = std::ranges::find_if(listing.models, [&](const auto& model) {
    return model.first == name || model.first.starts_with(name + ", ");
  });
  return found == listing.models.end() ? "" : constructed(std::string(found->second));
}

/// The models' names among a motion's methods in float, in their order.
std::vector<std::string> names_in_float(const Quantity& motion) {
  std::vector<std::string> names;
  for (const Method& m : motion.methods_in_float)
    if (names.empty() || names.back() != m.model) names.push_back(m.model);
  return names;
}

}  // namespace

TEST_CASE("a parser of calls splits them at their own commas", "[in_float]") {
  CHECK(parts("f(a, g(b, c),\n  {\"d, (\", e[1]})", 1) ==
        std::vector<std::string>{"a", "g(b, c)", "{\"d, (\", e[1]}"});
  CHECK(constructed("a::B<double>{{c::d}}") == "B");
  CHECK(constructed("in_plane(p)") == "in_plane");
  CHECK(constructed("chain::Angles<double, chain::Equations::dense>{p}") == "Angles<T, Equations::dense>");
}

TEST_CASE("the name of a model in float belongs to the model that is listed under it", "[in_float]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Scene& scene = *entry.exercise.scene;
    INFO(to_string(entry.number));
    const std::filesystem::path header = scene.listing.headers.front();
    const std::string models = source(header.string()), tuple = "return std::tuple{";
    const auto constructs = parts(models, models.find(tuple) + tuple.size() - 1);
    std::string calls;
    for (const char* file : {"exercise.cpp", "methods.cpp"})
      calls += source((header.parent_path() / file).string());
    const std::string call = "return with_float(";
    REQUIRE(calls.find(call) != std::string::npos);
    const auto arguments = parts(calls, calls.find(call) + call.size() - 1);
    REQUIRE(arguments.size() >= 4);
    const auto given = parts(arguments[3], 0);
    REQUIRE(given.size() == constructs.size());
    const auto names = names_in_float(motion(scene, Parameters(entry.exercise.parameters), truth));
    auto name = names.begin();
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (given[i] == "\"\"") continue;
      REQUIRE(name != names.end());
      INFO(*name << ": name " << given[i] << " in model " << i + 1);
      CHECK(listed(scene.listing, *name++) == constructed(constructs[i]));
    }
    CHECK(name == names.end());
  }
}

TEST_CASE("in float an algorithm does the same as in double, to a rounding per step", "[in_float]") {
  const ode::Adapted<Any<double>, Swing<double>> in_double{Swing<double>{}};
  const ode::Adapted<Any<float>, Swing<float>> in_float{Swing<float>{}};
  const std::vector<double> times{0, 1, 2, 3, 4};
  for (const char* name : in_float_too) {
    INFO(name);
    REQUIRE(ode::in_float<2>(name));
    const auto exact = ode::precompiled<2>(name)(in_double, {1, 0}, times, 0.01, {});
    const auto single = (*ode::in_float<2>(name))(in_float, {1, 0}, times, 0.01);
    CHECK(single.reached());
    CHECK(single.evaluations == exact.evaluations);
    double apart = 0;
    for (std::size_t k = 0; k < times.size(); ++k)
      for (std::size_t i = 0; i < 2; ++i)
        apart = std::max(apart, std::abs(single.value[k][i] - exact.value[k][i]));
    CHECK(apart > 0x1p-26);
    CHECK(apart < 400 * 8 * 0x1p-24);
  }
}

TEST_CASE("algorithms for double only have no counterpart in float", "[in_float]") {
  for (const char* name : {"Fehlberg 7(8)", "Bulirsch-Stoer", "GSL msbdf", "linearly implicit Euler"})
    CHECK_FALSE(ode::in_float<2>(name));
}

TEST_CASE("the time of a motion in float is counted in double, and does not drift", "[in_float]") {
  const Clock clock;
  const ode::Adapted<Any<float>, const Clock&> any(clock);
  const std::vector<double> times{0, 100};
  (*ode::in_float<2>("explicit Euler"))(any, {0, 0}, times, 0.01);
  REQUIRE(clock.asked.size() == 10'000);
  for (std::size_t i = 0; i < clock.asked.size(); i += 999)
    CHECK(clock.asked[i] == static_cast<float>(100.0 / 10'000 * static_cast<double>(i)));
}

TEST_CASE("a scene's parameters are rounded one by one", "[in_float]") {
  const pendulum::Given<double> given{0.1, 1, 9.81};
  const auto single = rounded_to<float>(given);
  CHECK(single.a == 0.1F);
  CHECK(single.L == 1);
  CHECK(single.g == 9.81F);
  CHECK(rounded_to<double>(single).a == static_cast<double>(0.1F));
}

TEST_CASE("each method in float is next to one in double, and is judged by it", "[in_float]") {
  const Quantity swing = pendulum_motion({10});
  REQUIRE(swing.methods_in_float.size() > 10);
  for (const Method& m : swing.methods_in_float) {
    INFO(m.model << ", " << m.algorithm);
    CHECK(m.precision == Precision::in_float);
    CHECK_FALSE(m.unstable_steps);
    CHECK_FALSE(m.disturbances);
    REQUIRE(m.algorithm.ends_with(" in float"));
    const Method* like = method_of(swing, m.model, m.algorithm.substr(0, m.algorithm.size() - 9));
    REQUIRE(like);
    CHECK(like->resolution.settings == m.resolution.settings);
  }
}

TEST_CASE("an error beyond the possible effect of roundings is detected", "[in_float]") {
  const Quantity swing = pendulum_motion({10});
  const Method& single = *method_of(swing, "one angle", "Runge-Kutta 4 in float");
  const double step = single.resolution.settings[4];
  const TimedTrial in_double = as_result(run(swing, *method_of(swing, "one angle", "Runge-Kutta 4"), step));
  TimedTrial in_float = as_result(run(swing, single, step));
  in_float.roundings = single.roundings(step);
  CHECK(in_float.precision == Precision::in_float);
  CHECK(in_float.error > in_double.error);
  CHECK(as_accurate_as_roundings_allow(in_float, in_double));
  in_float.error = 2 * in_double.error + 1.01 * in_float.roundings;
  CHECK_FALSE(as_accurate_as_roundings_allow(in_float, in_double));
  in_float.error = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(as_accurate_as_roundings_allow(in_float, in_double));
  CHECK(single.roundings(step / 2) > 1.5 * single.roundings(step));
  CHECK(in_float.roundings < 0.02);
}

TEST_CASE("a name that a scene does not have is refused", "[in_float]") {
  Quantity swing = pendulum_motion({10});
  const pendulum::Given<double> given{0.5, 1, 9.81};
  CHECK_THROWS_AS(with_float(swing, {10}, given, {"small angel", "", "", "", ""}), std::logic_error);
  CHECK_THROWS_AS(with_float(swing, {10}, given, {"small angle"}), std::logic_error);
}
