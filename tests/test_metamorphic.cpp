// Changes that must not matter: the zero of a potential, the units of numbers, the direction of time, the
// direction of the axes.

#include <algorithm>
#include <bit>
#include <functional>
#include <map>

#include "chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"
#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"
#include "chapters/03_rigid_body_motion/09_damped_ball/models.hpp"
#include "chapters/03_rigid_body_motion/11_paraboloid_hill/models.hpp"
#include "chapters/03_rigid_body_motion/13_tilted_chute/models.hpp"
#include "chapters/03_rigid_body_motion/15_turning_rod/models.hpp"
#include "chapters/03_rigid_body_motion/17_foucault/models.hpp"
#include "chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"
#include "chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"
#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/models.hpp"
#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "report/study/choose.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// ---- the models -------------------------------------------------------------------------------------------

/// Calls see(exercise, model's name, model, horizon) for every model with a conserved quantity, at its
/// exercise's default parameters.
template <class See>
void for_each_model(const See& see) {
  using std::numbers::pi;
  see("2.7", "matrix", curve_on_sphere::AsMatrix<double>{{{1}}}, 4.0);
  see("2.7", "quaternion", curve_on_sphere::AsQuaternion<double>{{{1}}}, 4.0);
  const kepler::Given<double> earth{4 * pi * pi, 1, 1, 0.09375, 1.75, 6.25};
  see("3.3", "equation (2)", kepler::Distance<double>{earth}, 2.0);
  see("3.3", "polar", kepler::Polar<double>{earth}, 2.0);
  see("3.3", "Cartesian", kepler::Cartesian<double>{earth}, 2.0);
  for (double a : {pi / 6, pi / 2}) {
    const pendulum::Given<double> released{a, 1, 9.81};
    see("3.5", "one angle", pendulum::OneAngle<double>{released}, 10.0);
    see("3.5", "Cartesian with constraint", pendulum::CartesianWithConstraint<double>{released}, 10.0);
  }
  const bead_on_cubic::Given<double> bead{1, 1};
  see("3.7", "one coordinate", bead_on_cubic::OneCoordinate<double>{bead}, 4.0);
  see("3.7", "Cartesian with constraints", bead_on_cubic::CartesianWithConstraints<double>{bead}, 4.0);
  see("3.9", "plane, with the work", damped_ball::PlaneWithWork<double>{{1, 4, 0.4, 1, 0.5, 0, 1.5}}, 5.0);
  const auto down = paraboloid_hill::from_the_top<double>({1, 2, 10, 2, 2, 0.75});
  see("3.11", "plane", paraboloid_hill::in_plane(down), 2.0);
  see("3.11", "momenta", paraboloid_hill::in_momenta(down), 2.0);
  see("3.11", "space", paraboloid_hill::InSpace<double>{down}, 2.0);
  const tilted_chute::Given<double> ball{1, 5, 3, 9.81, 1, -1};
  see("3.13", "angle about the axis", tilted_chute::Angle<double>{ball}, 4.0);
  see("3.13", "space", tilted_chute::InSpace<double>{ball}, 4.0);
  const turning_rod::Given<double> rod{1, 1, 10, pi / 4, 2};
  see("3.15", "along the rod", turning_rod::AlongTheRodWithWork<double>{{rod}}, 2.0);
  see("3.15", "turning plane", turning_rod::InTheTurningPlane<double>{{rod}}, 2.0);
  see("3.15", "Cartesian with constraints", turning_rod::CartesianWithConstraints<double>{{rod}}, 2.0);
  const foucault::Given<double> bob{0.75, 1, 0.0625, 9.81, 0.5, 0.25, 1, 0};
  see("3.17", "Cartesian", foucault::Cartesian<double>{bob}, 16.0);
  see("3.17", "two angles", foucault::TwoAngles<double>{bob}, 16.0);
  const two_pulleys::Given<double> pulleys{1, 2, 0.5, 0.25, 0.5, 0.5, 40,   30,  1,
                                           1, 1, 1.5, 9.81, 1,   2.5, 0.25, -0.5};
  see("3.19", "two coordinates", two_pulleys::TwoCoordinates<double>{pulleys}, 8.0);
  see("3.19", "four coordinates", two_pulleys::FourCoordinates<double>{pulleys}, 8.0);
  const pipe_and_disk::Given<double> disk{1, 2, 0.5, 1, 3, 0.2, 2, 0.5, 10};
  see("3.21", "two angles", pipe_and_disk::TwoAngles<double>{disk}, 8.0);
  see("3.21", "Cartesian center", pipe_and_disk::Center<double>{disk}, 8.0);
  const spring_bar::Given<double> bar{1, 1, 0.5, 98.1, 0.8, 9.81, 1, 0.3, 0};
  see("3.23", "one angle", spring_bar::OneAngle<double>{bar}, 4.0);
  see("3.23", "Cartesian with constraint", spring_bar::CartesianWithConstraint<double>{bar}, 4.0);
  const chain::Given<double> links{{1, 0.75, 0.5},     {1, 0.75, 0.5}, 9.8125, 2.5,
                                   {0.25, 0.375, 0.5}, {0, 0, 0}};
  see("3.25", "dense mass matrix", chain::Angles<double, chain::Equations::dense>{links}, 4.0);
  see("3.25", "tensions", chain::Angles<double, chain::Equations::tensions>{links}, 4.0);
  const two_bodies::Given<double> bodies{1, 2, 1, 1, 0.25, 0.5, 1.5};
  see("3.27", "(r, u, phi)", two_bodies::Published<double>{bodies}, 4.0);
  see("3.27", "two bodies", two_bodies::BothBodies<double>{bodies}, 4.0);
  const planar_wire::Thrown<double> wire{6, 0.5, 2, 5, 6, 9.81, {0.25, 0.5}};
  see("3.29", "x, y, theta", planar_wire::Generalized<double>{wire}, 2.0);
  see("3.29", "two particles", planar_wire::TwoParticles<double>{wire}, 2.0);
  for (double shaken : {0.0, 0.0625}) {
    const heavy_top::Top<double> heavy{
        {1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 30}, shaken, shaken == 0 ? 0.0 : 3.0};
    const char* exercise = shaken == 0 ? "3.33" : "3.35";
    if (shaken == 0) see(exercise, "one angle", heavy_top::OneAngle<double>{heavy}, 4.0);
    see(exercise, "Euler angles", heavy_top::EulerAngles<double>{heavy}, 4.0);
    see(exercise, "axis and angular momentum", heavy_top::AxisAndMomentum<double>{heavy}, 4.0);
    see(exercise, "rigid body", heavy_top::RigidBody<double>{heavy}, 4.0);
  }
}

/// The cheapest and the richest algorithms that every model accepts, at steps and tolerances from coarse to
/// fine.
const std::vector<std::pair<std::string_view, double>> runs{
    {"explicit Euler", 0x1p-4}, {"explicit Euler", 0x1p-7},    {"Runge-Kutta 4", 0x1p-3},
    {"Runge-Kutta 4", 0x1p-6},  {"Dormand-Prince 5(4)", 1e-2}, {"Dormand-Prince 5(4)", 1e-6},
    {"Fehlberg 7(8)", 1e-4},    {"Fehlberg 7(8)", 1e-10}};

// ---- another zero of the potential ------------------------------------------------------------------------

/// The motion with another zero of each conserved quantity.
template <class Model>
struct CountedFrom : Model {
  double elsewhere;
  auto conserved(const typename Model::State& x, double t) const {
    auto all = Model::conserved(x, t);
    for (Conserved<double>& one : all) one.value += elsewhere;
    return all;
  }
};

/// The largest kinetic part of a model's conserved quantities; if there are several, of the one where it is
/// least.
template <class Model>
double least_moving(const Model& model, double end) {
  const auto times = Horizon{end, 128}.times();
  const auto motion = ode::integrate<ode::Fehlberg78>(model, model.start(), std::span(times), 1e-10);
  auto most = model.conserved(motion.value.front(), 0);
  for (std::size_t i = 0; i < motion.value.size(); ++i)
    for (std::size_t k = 0; k < most.size(); ++k)
      most[k].moving = std::max(most[k].moving, model.conserved(motion.value[i], times[i])[k].moving);
  return std::ranges::min_element(most, {}, &Conserved<double>::moving)->moving;
}

template <class Model>
void check_counted_from(const Model& model, double end, double elsewhere, double moving) {
  const Horizon horizon{end, 8};
  const CountedFrom<Model> moved{model, elsewhere};
  const double first = std::abs(model.conserved(model.start(), 0)[0].value);
  const double rounding = 1024 * epsilon * (1 + (first + std::abs(elsewhere)) / moving);
  for (const auto& [algorithm, setting] : runs) {
    const Answer here = type_erased(model)->run(algorithm, horizon, setting),
                 there = type_erased(moved)->run(algorithm, horizon, setting);
    INFO(algorithm << " at " << setting << ": drift " << here.drift << ", counted from " << elsewhere << ": "
                   << there.drift);
    if (finite(here.value)) CHECK(std::ranges::equal(here.value, there.value));
    CHECK(here.ending == there.ending);
    if (std::isfinite(here.drift) && here.drift < 1e6)
      CHECK(std::abs(here.drift - there.drift) <= rounding * (1 + here.drift));
    CHECK((here.drift <= 0.01) == (there.drift <= 0.01));
  }
}

}  // namespace

TEST_CASE("the zero of a potential changes no drift", "[metamorphic]") {
  for_each_model([](const char* exercise, const char* name, const auto& model, double end) {
    const double moving = least_moving(model, end), first = model.conserved(model.start(), 0)[0].value;
    for (double elsewhere : {-first, 1000 * moving, -1e-3 * moving}) {
      INFO(exercise << ", " << name);
      check_counted_from(model, end, elsewhere, moving);
    }
  });
}

// ---- time reversed ----------------------------------------------------------------------------------------

namespace {

/// Scenes whose motion cannot be run backward, or that have no model above, with the reason.
const std::map<std::string, std::string> one_way{
    {"3.31", "dry friction: a box at rest has come from many motions"}};

/// The motion backwards: x' = -f(x, end - t) from the state of the model at the end.
template <class Model>
struct Backward {
  using State = typename Model::State;
  Model model;
  double end;
  State last;
  State start() const { return last; }
  void operator()(const State& x, State& dxdt, double t) const {
    model(x, dxdt, end - t);
    for (double& rate : dxdt) rate = -rate;
  }
  auto observe(const State& x, double t) const { return model.observe(x, end - t); }
  auto conserved(const State& x, double t) const { return model.conserved(x, end - t); }
};

template <class Algorithm, class Model>
typename Model::State state_at(const Model& model, double end, double tolerance) {
  return ode::integrate<Algorithm>(model, model.start(), 0, end, tolerance).value;
}

/// End of the motion back from the end, which should be the start.
template <class Algorithm, class Model>
Value there_and_back(const Model& model, double end, double tolerance) {
  const Backward<Model> back{model, end, state_at<Algorithm>(model, end, tolerance)};
  return state_at<Algorithm>(back, end, tolerance);
}

/// The motion observed at eight times, judged by the best run of the other direction.
Outcome judged(const Answer& answer, const Value& truth) {
  Quantity q{"", "", "", {"", truth}, 0, {1e-3 * size_of(truth), ""}};
  q.samples = 8;
  return run(q, Method{"", "", no_resolution(), [&](double) { return answer; }}, 0).outcome;
}

/// The observables at seven times before the end, in reverse order.
Value reversed(const Value& seen) {
  const std::size_t parts = seen.size() / 8;
  std::vector<double> all;
  for (std::size_t k = 7; k-- > 0;)
    for (std::size_t i = 0; i < parts; ++i) all.push_back(seen[k * parts + i]);
  return all;
}

/// Appends the start as the last of eight times.
template <class Model>
Value with_start(const Model& model, const Value& seven) {
  std::vector<double> all(seven.begin(), seven.end());
  for (double x : model.observe(model.start(), 0)) all.push_back(x);
  return all;
}

}  // namespace

TEST_CASE("a motion run backward from its end returns to its start", "[metamorphic]") {
  std::set<std::string> seen;
  for_each_model([&](const char* exercise, const char* name, const auto& model, double end) {
    using Model = std::decay_t<decltype(model)>;
    seen.insert(exercise);
    INFO(exercise << ", " << name);
    const Value fine = there_and_back<ode::Fehlberg78>(model, end, 1e-13);
    const Value coarse = there_and_back<ode::DormandPrince54>(model, end, 1e-9);
    CHECK(distance(fine, Value(model.start())) <=
          distance(fine, coarse) + rounding(size_of(fine), 1024).allowed);

    const Horizon horizon{end, 8};
    const Backward<Model> back{model, end, state_at<ode::Fehlberg78>(model, end, 1e-13)};
    const Value forward_truth = type_erased(model)->run("Fehlberg 7(8)", horizon, 1e-13).value;
    const Value back_truth = with_start(model, reversed(forward_truth));
    for (const auto& [algorithm, setting] :
         {std::pair{"Fehlberg 7(8)", 1e-10}, std::pair{"Dormand-Prince 5(4)", 1e-8}}) {
      CHECK(judged(type_erased(model)->run(algorithm, horizon, setting), forward_truth) == Outcome::ok);
      CHECK(judged(type_erased(back)->run(algorithm, horizon, setting), back_truth) == Outcome::ok);
    }
  });
  for (const Entry& entry : registry())
    if (entry.exercise.scene) {
      INFO(to_string(entry.number));
      CHECK(seen.contains(to_string(entry.number)) != one_way.contains(to_string(entry.number)));
    }
}

// ---- other units ------------------------------------------------------------------------------------------

namespace {

/// Number of new units in one of the old ones: powers of two, so that nothing is rounded.
struct Units {
  std::string says;
  double length = 1, mass = 1, time = 1;

  double named(std::string_view name) const {
    if (name == "m" || name == "AU") return length;
    if (name == "kg" || name == "solar mass") return mass;
    if (name == "s" || name == "yr") return time;
    if (name == "N") return mass * length / (time * time);
    if (name == "rad" || name == "1" || name.empty()) return 1;
    throw std::logic_error("no factor for the unit '" + std::string(name) + "'");
  }
  /// The factor of a unit such as "kg m^2", "N s/m", "AU^3/(yr^2 solar mass)".
  double operator()(std::string_view unit) const {
    double factor = 1;
    for (bool divide = false; !unit.empty();) {
      double part = 1;
      std::size_t end = 1;
      if (unit[0] == ' ' || unit[0] == '/') {
        divide = divide || unit[0] == '/';
        unit.remove_prefix(1);
        continue;
      }
      if (unit[0] == '(') {
        end = unit.find(')') + 1;
        part = (*this)(unit.substr(1, end - 2));
      } else {
        end = unit.starts_with("solar mass") ? 10 : std::min(unit.find_first_of(" /^)"), unit.size());
        part = named(unit.substr(0, end));
        if (end < unit.size() && unit[end] == '^') {
          part = std::pow(part, unit[end + 1] - '0');
          end += 2;
        }
      }
      factor *= divide ? 1 / part : part;
      divide = false;
      unit.remove_prefix(end);
    }
    return factor;
  }
};

const Units heavier{"mass", 1, 8, 1}, longer{"length", 16, 1, 1}, slower{"time", 1, 1, 0.25};

/// Scenes in which lengths have a fixed unit.
const std::map<std::string, std::string> fixed_lengths{
    {"3.7", "the wire is y = x^2, z = x^3 in metres"},
    {"3.11", "the half axes are those one metre below the top"},
    {"3.29", "the wire is y = x^2 in metres"}};

/// Models that contain a number with a unit.
const std::map<std::string, std::string> fixed_units{
    {"friction regularized at 1 cm/s", "a speed"},
    {"listing as printed", "the book's angular speed, squared"},
    {"listing with the other rest length", "the book's angular speed, squared"}};

/// Unit of a model's step.
double step_in(const Units& units, const std::string& model) {
  if (model == "Levi-Civita's coordinates") return units("s/m");      // dt = r ds
  if (model == "time stretched by the speed") return units("s^2/m");  // dt = speed ds
  return units.time;
}

/// Its Jacobian by differences uses increments that do not scale: its values agree to fewer digits.
bool by_differences(const Method& method) { return method.algorithm == "linearly implicit Euler"; }

/// An exercise with the same numbers in other units, and without ranges.
struct Converted {
  std::vector<Parameter> parameters;
  Entry entry;

  Converted(const Entry& original, const Units& units, const std::map<std::string, double>& set = {})
      : parameters(original.exercise.parameters.begin(), original.exercise.parameters.end()),
        entry(original) {
    for (Parameter& p : parameters) {
      if (const auto other = set.find(std::string(p.name)); other != set.end()) p.value = other->second;
      p.value *= units(p.unit);
      p.least = -std::numeric_limits<double>::infinity();
      p.most = std::numeric_limits<double>::infinity();
    }
    entry.exercise.parameters = parameters;
  }
  Converted(const Converted&) = delete;
};

/// The factor of each observable of one time.
std::vector<double> factors(const Quantity& motion, const Units& units) {
  std::vector<double> all(motion.reference.value.size() / static_cast<std::size_t>(motion.samples), 1);
  for (const Norm& norm : motion.norms)
    for (std::size_t i : norm.components) all.at(i) = units(norm.unit);
  return all;
}

Value converted(Value value, const std::vector<double>& factors) {
  for (std::size_t i = 0; i < value.size(); ++i) value[i] *= factors[i % factors.size()];
  return value;
}

/// Checks every method with a fixed step and every closed form. A tolerance is also an absolute error, which
/// depends on the units.
void check_units(const Entry& entry, const Units& units) {
  const Scene& scene = *entry.exercise.scene;
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Quantity here = motion(scene, Parameters(entry.exercise.parameters), truth);
  const Converted other(entry, units);
  Quantity there = motion(*other.entry.exercise.scene, Parameters(other.parameters),
                          {scene.horizon * units.time}, Reference::nothing());
  const auto scale = factors(here, units);
  there.reference.value = converted(here.reference.value, scale);
  there.reference_error = here.reference_error * units.length;
  there.need.allowed = here.need.allowed;
  for (std::string_view unit : there.units()) there.needs.push_back(here.need.allowed * units(unit));
  REQUIRE(here.methods.size() == there.methods.size());
  for (std::size_t m = 0; m < here.methods.size(); ++m) {
    const Method& method = here.methods[m];
    if (method.resolution.name == "tolerance" || fixed_units.contains(method.model)) continue;
    for (double setting : method.resolution.settings) {
      if (setting < 4e-3 && method.resolution.name == "step") continue;
      const Trial a = run(here, method, setting);
      const Trial b = run(there, there.methods[m],
                          setting * (method.resolution.name == "step" ? step_in(units, method.model) : 1));
      INFO(to_string(entry.number) << ": " << method.model << ", " << method.algorithm << " at " << setting
                                   << ", another unit of " << units.says << ": error " << a.error << " and "
                                   << b.error);
      CHECK(name_of(a.outcome) == name_of(b.outcome));
      if (!a.answer.reached() || !finite(a.answer.value) || a.outcome == Outcome::diverged ||
          by_differences(method))
        continue;
      const Value expected = converted(a.answer.value, scale);
      CHECK(distance(expected, b.answer.value) <= 1e-11 * size_of(expected));
    }
  }
}

}  // namespace

TEST_CASE("a unit's name has its factor", "[metamorphic]") {
  const Units units{"", 2, 8, 32};
  CHECK(units("") == 1);
  CHECK(units("N s/m") == 8.0 / 32);
  CHECK(units("kg m^2") == 8 * 4);
  CHECK(units("m^3/(kg s^2)") == 8.0 / (8 * 32 * 32));
  CHECK(units("AU^3/(yr^2 solar mass)") == 8.0 / (8 * 32 * 32));
  CHECK(units("1/s") == 1.0 / 32);
}

TEST_CASE("other units change no outcome", "[metamorphic]") {
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    check_units(entry, heavier);
    check_units(entry, slower);
    if (!fixed_lengths.contains(to_string(entry.number))) check_units(entry, longer);
  }
}

// ---- axes turned ------------------------------------------------------------------------------------------

namespace {

/// Scenes that are the same in every direction of a plane, with the parameters that turn their start.
struct Turned {
  int index;
  std::function<void(Parameters&, double angle)> turn;
};

void turn_pair(Parameters& p, const char* x, const char* y, double angle) {
  const double a = p[x], b = p[y], c = std::cos(angle), s = std::sin(angle);
  p.set(x, c * a - s * b);
  p.set(y, s * a + c * b);
}

const std::vector<Turned> isotropic{
    {3, [](Parameters& p, double angle) { p.set("theta0", p["theta0"] + angle); }},
    {9,
     [](Parameters& p, double angle) {
       turn_pair(p, "p1", "p2", angle);
       turn_pair(p, "v1", "v2", angle);
     }},
    {27, [](Parameters& p, double angle) { p.set("phi0", p["phi0"] + angle); }},
    {33, [](Parameters& p, double angle) { p.set("theta", p["theta"] + angle); }}};

/// Why the other scenes cannot be turned.
const std::map<int, std::string> has_a_direction{
    {5, "gravity"},        {7, "the wire"},          {11, "the hill's half axes differ"},
    {13, "the chute"},     {15, "the spring's end"}, {17, "the Earth's axis"},
    {19, "gravity"},       {21, "the force"},        {23, "gravity"},
    {25, "gravity"},       {29, "gravity"},          {31, "the box starts along its own axes"},
    {35, "the tip's line"}};

/// Turns the first two observables of each time.
Value turned(Value value, std::size_t parts, double angle) {
  for (std::size_t i = 0; i < value.size(); i += parts) {
    const double a = value[i], b = value[i + 1];
    value[i] = std::cos(angle) * a - std::sin(angle) * b;
    value[i + 1] = std::sin(angle) * a + std::cos(angle) * b;
  }
  return value;
}

}  // namespace

TEST_CASE("turned axes change no outcome", "[metamorphic]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene || entry.number.chapter != 3) continue;
    const auto one = std::ranges::find(isotropic, entry.number.index, &Turned::index);
    INFO(to_string(entry.number));
    CHECK((one != isotropic.end()) != has_a_direction.contains(entry.number.index));
    if (one == isotropic.end()) continue;
    constexpr double angle = 1;
    Parameters p(entry.exercise.parameters);
    const Quantity here = motion(*entry.exercise.scene, p, truth);
    one->turn(p, angle);
    Quantity there = motion(*entry.exercise.scene, p, {entry.exercise.scene->horizon}, Reference::nothing());
    there.reference.value = turned(here.reference.value, here.reference.value.size() / 4, angle);
    there.reference_error = here.reference_error;
    for (std::size_t m = 0; m < here.methods.size(); ++m) {
      const Method& method = here.methods[m];
      if (method.resolution.name == "tolerance") continue;
      for (double setting : method.resolution.settings) {
        if (setting < 4e-3 && method.resolution.name == "step") continue;
        const Trial a = run(here, method, setting), b = run(there, there.methods[m], setting);
        INFO(method.model << ", " << method.algorithm << " at " << setting << ": error " << a.error
                          << ", turned " << b.error);
        CHECK(name_of(a.outcome) == name_of(b.outcome));
        if (a.answer.reached() && a.outcome != Outcome::diverged && a.outcome != Outcome::non_finite)
          CHECK(near(b.error, a.error, 1e-6 * a.error + 1e-11));
      }
    }
  }
}

// ---- the choice -------------------------------------------------------------------------------------------

namespace {

Time counted(const Method& method, double setting) {
  return {static_cast<double>(method.run(setting).evaluations) * 1e-9, 0};
}

const Entry& exercise(int index) {
  return *std::ranges::find_if(registry(), [&](const Entry& e) { return e.number == Number{3, index}; });
}

Choice chosen_in(const Units& units, int index, const std::map<std::string, double>& set = {}) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Entry& original = exercise(index);
  const Converted other(original, units, set);
  const Scene& scene = *original.exercise.scene;
  Need need{scene.game_tolerance * units(scene.axes.norms.front().unit)};
  need.horizon = std::min(scene.horizon, 1.0) * units.time;
  need.only = {"closed form", "Euler", "Verlet", "Runge-Kutta", "Dormand-Prince 5(4)", "Fehlberg 7(8)"};
  need.frames_per_second = 60 / units.time;
  return choose(Task(other.entry), need, truth, counted);
}

void check_same(const Choice& a, const Choice& b, double time) {
  REQUIRE(a.chosen);
  REQUIRE(b.chosen);
  CHECK(a.chosen->model == b.chosen->model);
  CHECK(a.chosen->algorithm == b.chosen->algorithm);
  CHECK(a.chosen->setting * (a.chosen->resolution == "step" ? time : 1) == b.chosen->setting);
}

}  // namespace

TEST_CASE("a pendulum let go where its energy is zero gets a choice like any other", "[metamorphic]") {
  const Choice level = chosen_in({""}, 5, {{"a", std::numbers::pi / 2}});
  for (const Candidate& candidate : level.candidates) {
    if (candidate.algorithm != "Fehlberg 7(8)") continue;
    INFO(candidate.model);
    CHECK(candidate.outcome == Outcome::ok);
  }
  check_same(level, chosen_in({""}, 5, {{"a", 1.5707963}}), 1);
  check_same(level, chosen_in(longer, 5, {{"a", std::numbers::pi / 2}}), 1);
}

TEST_CASE("the choice is the same in other units", "[metamorphic][slow]") {
  const Choice earth = chosen_in({""}, 3);
  check_same(earth, chosen_in(heavier, 3), 1);
  const Choice chain = chosen_in({""}, 25);
  check_same(chain, chosen_in({"", 4, 0.5, 1}, 25), 1);
  check_same(chain, chosen_in({""}, 25, {{"h", 100}}), 1);
}
