// The limits up to which a model is sufficient for a game, from the page of cheapest models, compared with
// this file's own formulas and integrations, at every frame.

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <functional>

#include "report/study/cheapest_models.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

constexpr double pi = 3.14159265358979323846, degree = pi / 180, centimeter = 0.01;
constexpr int frames = 600;  // ten seconds

const CheapestModels& cheapest_models_of(Number number) {
  static std::map<Number, CheapestModels> made;
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  if (!made.contains(number)) {
    const auto entry = std::ranges::find_if(registry(), [&](const Entry& e) { return e.number == number; });
    made.emplace(number, cheapest_models(Task(*entry), truth).value());
  }
  return made.at(number);
}

std::optional<BreakEven> break_even(Number number, const std::string& model, const std::string& parameter) {
  for (const BreakEven& found : cheapest_models_of(number).break_evens)
    if (found.model == model && found.parameter == parameter) return found;
  return {};
}

/// The argument at which f crosses `limit`, between low and high.
double crossing(const std::function<double(double)>& f, double limit, double low, double high) {
  const bool rising = f(high) > limit;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > limit) == rising ? high : low) = middle;
  }
  return (low + high) / 2;
}

/// Within the page's intervals the largest error at any frame is within the limit, except for 0.2 % at their
/// ends.
void check_intervals(const BreakEven& found, const std::function<double(double)>& largest_error,
                     double limit) {
  constexpr int parts = 150;
  for (int i = 0; i <= parts; ++i) {
    const double part = static_cast<double>(i) / parts,
                 at = found.looked.from * std::pow(found.looked.to / found.looked.from, part);
    bool inside = false, near_an_end = false;
    for (const Interval& enough : found.enough) {
      inside = inside || (enough.from <= at && at <= enough.to);
      near_an_end =
          near_an_end || std::abs(at / enough.from - 1) < 2e-3 || std::abs(at / enough.to - 1) < 2e-3;
    }
    if (near_an_end) continue;
    const double error = largest_error(at);
    INFO(found.model << " at " << found.parameter << " = " << at << ": error / limit = " << error / limit);
    CHECK((error <= limit) == inside);
  }
}

// ---- 3.5 --------------------------------------------------------------------------------------------------

/// theta = 2 asin(k cd(w t, k)) minus a cosine with this part of w.
double off_a_cosine(double a, double part) {
  const double w = std::sqrt(9.81), k = std::sin(a / 2);
  double largest = 0;
  for (int i = 1; i <= frames; ++i) {
    const double t = i / 60.0, theta = 2 * std::asin(k * boost::math::jacobi_cd(k, w * t));
    largest = std::max(largest, std::abs(theta - a * std::cos(part * w * t)));
  }
  return largest;
}
double small_angle(double a) { return off_a_cosine(a, 1); }
double amplitude_corrected(double a) { return off_a_cosine(a, 1 - a * a / 16); }

// ---- 3.23 -------------------------------------------------------------------------------------------------

/// The mass of the bar at its own values, compared with its motion linearized about the level.
struct LoadedBar {
  double theta0;
  using State = std::array<double, 2>;
  static constexpr double m = 1, r = 1, s = 0.5, c = 98.1, h = 0.8, g = 9.81, ell = 1;

  void operator()(const State& x, State& dxdt, double) const {
    const double across = s - s * std::cos(x[0]), up = h + s * std::sin(x[0]),
                 length = std::hypot(across, up);
    const double stretching = s * (across * std::sin(x[0]) + up * std::cos(x[0])) / length;  // dlength/dtheta
    dxdt = {x[1], -(m * g * r * std::cos(x[0]) + c * (length - ell) * stretching) / (m * r * r)};
  }
  double linear(double t) const {
    const double rest = -(m * g * r + c * s * (h - ell)) / (c * s * s), w = s / r * std::sqrt(c / m);
    return rest + (theta0 - rest) * std::cos(w * t);
  }
};

std::vector<double> frame_times() {
  std::vector<double> times;
  for (int i = 0; i <= frames; ++i) times.push_back(i / 60.0);
  return times;
}

double small_oscillation(double theta0) {
  const LoadedBar bar{theta0};
  const auto times = frame_times();
  const auto motion =
      ode::integrate<ode::BulirschStoer>(bar, LoadedBar::State{theta0, 0}, std::span(times), 1e-11);
  double largest = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    largest = std::max(
        largest, 2 * LoadedBar::r * std::abs(std::sin((motion.value[i][0] - bar.linear(times[i])) / 2)));
  return largest;
}

// ---- 3.33 and 3.35 ----------------------------------------------------------------------------------------

/// The axis and the angular momentum of a top about its tip, which is shaken along x.
struct SpunTop {
  double spin_rate, A = 0, lambda = 0;
  using State = std::array<double, 6>;
  static constexpr double m = 1, l = 0.25, mu1 = 0.125, mu3 = 0.0625, g = 9.81, theta = 0.25, phi = 0.5,
                          dtheta = 0.5, dphi = 0.25;

  static std::array<double, 3> axis(double turned) {
    return {std::sin(turned) * std::sin(phi), -std::cos(turned) * std::sin(phi), std::cos(phi)};
  }
  double total_spin() const { return spin_rate + dtheta * std::cos(phi); }
  State start() const {
    const auto d = axis(theta);
    const std::array rate{dtheta * std::cos(theta) * std::sin(phi) + dphi * std::sin(theta) * std::cos(phi),
                          dtheta * std::sin(theta) * std::sin(phi) - dphi * std::cos(theta) * std::cos(phi),
                          -dphi * std::sin(phi)};
    const double along = mu3 * total_spin();
    return {d[0],
            d[1],
            d[2],
            mu1 * (d[1] * rate[2] - d[2] * rate[1]) + along * d[0],
            mu1 * (d[2] * rate[0] - d[0] * rate[2]) + along * d[1],
            mu1 * (d[0] * rate[1] - d[1] * rate[0]) + along * d[2]};
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const double fx = m * A * lambda * lambda * std::sin(lambda * t), fz = -m * g;
    dxdt = {(x[4] * x[2] - x[5] * x[1]) / mu1, (x[5] * x[0] - x[3] * x[2]) / mu1,
            (x[3] * x[1] - x[4] * x[0]) / mu1, l * x[1] * fz,
            l * (x[2] * fx - x[0] * fz),       -l * x[1] * fx};
  }
  ode::Trajectory<State> motion() const {
    const auto times = frame_times();
    return ode::integrate<ode::BulirschStoer>(*this, start(), std::span(times), 1e-11);
  }
};

double apart(const SpunTop::State& x, const std::array<double, 3>& d) {
  return std::hypot(x[0] - d[0], x[1] - d[1], x[2] - d[2]);
}

double mean_precession(double spin_rate) {
  const SpunTop top{spin_rate};
  const double rate = SpunTop::m * SpunTop::g * SpunTop::l / (SpunTop::mu3 * top.total_spin());
  const auto motion = top.motion();
  double largest = 0;
  for (std::size_t i = 1; i < motion.value.size(); ++i)
    largest = std::max(
        largest, apart(motion.value[i], SpunTop::axis(SpunTop::theta + rate * static_cast<double>(i) / 60)));
  return largest;
}

double fixed_tip(double lambda) {
  const auto shaken = SpunTop{30, 0.0625, lambda}.motion(), fixed = SpunTop{30}.motion();
  double largest = 0;
  for (std::size_t i = 1; i < shaken.value.size(); ++i)
    largest =
        std::max(largest, apart(shaken.value[i], {fixed.value[i][0], fixed.value[i][1], fixed.value[i][2]}));
  return largest;
}

}  // namespace

TEST_CASE("limits up to which a pendulum's closed forms are sufficient", "[cheapest]") {
  for (const auto& [model, error, low, high] :
       {std::tuple("small angle", &small_angle, 0.1, 0.5),
        std::tuple("amplitude-corrected", &amplitude_corrected, 0.5, 2.0)}) {
    const auto found = break_even({3, 5}, model, "a");
    REQUIRE(found);
    REQUIRE(found->enough.size() == 1);
    const double end = crossing(error, degree, low, high);
    CHECK(near(found->enough[0].to, end, 2e-3 * end));
    check_intervals(*found, error, degree);
  }
}

TEST_CASE("limits up to which a small oscillation is sufficient", "[cheapest]") {
  const auto found = break_even({3, 23}, "small oscillation", "theta0");
  REQUIRE(found);
  check_intervals(*found, small_oscillation, centimeter);
}

TEST_CASE("a mean precession is nowhere sufficient for good", "[cheapest]") {
  const auto found = break_even({3, 33}, "mean precession", "dpsi");
  if (found && found->parameter == "dpsi") {
    check_intervals(*found, mean_precession, degree);
    for (const Interval& enough : found->enough) CHECK(enough.to < 100);
  } else {
    check_intervals({"mean precession", "dpsi", "rad/s", {5, 100}, {}}, mean_precession, degree);
  }
}

TEST_CASE("a fixed tip is judged by its own motion, not by an algorithm's", "[cheapest]") {
  const auto found = break_even({3, 35}, "fixed tip, as proposed", "lambda");
  if (found && found->parameter == "lambda")
    check_intervals(*found, fixed_tip, degree);
  else
    check_intervals({"fixed tip", "lambda", "rad/s", {0.5, 14}, {}}, fixed_tip, degree);
}

TEST_CASE("a recipe is the simplest model at the cost of the one that choose takes", "[cheapest]") {
  const CheapestModel& swing = cheapest_models_of({3, 5}).recipe;
  REQUIRE(swing.least);
  CHECK(swing.least->model == "amplitude-corrected");  // Jacobi's functions cost an evaluation, too
  CHECK(amplitude_corrected(30 * degree) <= degree / swing.need.margin());
  CHECK(swing.need.margin() == 3);
  const CheapestModel& top = cheapest_models_of({3, 33}).recipe;
  REQUIRE(top.least);
  CHECK(top.least->model == "one angle, precession by quadrature");
  CHECK(top.least->algorithm == "Runge-Kutta 4");  // without the start of a multistep method
}
