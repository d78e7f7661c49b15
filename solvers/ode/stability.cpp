#include "solvers/ode/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>

#include "solvers/linear.hpp"
#include "solvers/ode/all.hpp"
#include "solvers/ode/implicit_euler.hpp"
#include "solvers/ode/known_tongues.hpp"
#include "solvers/stop.hpp"

namespace oddity::ode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Plane = std::array<double, 2>;

/// y' = z y in its real and imaginary parts; for partitioned algorithms, q'' = Re(z^2) q.
struct LinearProblem {
  std::complex<double> z;

  template <class Y>
  void operator()(const Y& y, Y& dydt, const auto&) const {
    dydt[0] = z.real() * y[0] - z.imag() * y[1];
    dydt[1] = z.imag() * y[0] + z.real() * y[1];
  }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    a = {(z * z).real() * q[0]};
  }
};

/// (q, v) of q'' = 2 Re(z) q' - |z|^2 q, whose eigenvalues are z and its conjugate.
struct DampedOscillation {
  std::complex<double> z;

  template <class Y>
  void operator()(const Y& y, Y& dydt, const auto&) const {
    dydt[0] = y[1];
    dydt[1] = 2 * z.real() * y[1] - std::norm(z) * y[0];
  }
};

template <class Algorithm, class Problem>
Plane one_step(const Problem& problem, const Plane& y) {
  return integrate<Algorithm>(problem, y, 0, 1, 1).value;
}

/// ln of the spectral radius of the 2 x 2 matrix whose columns are a step of (1, 0) and of (0, 1).
double log_radius(const Plane& a, const Plane& b) {
  const double half_trace = (a[0] + b[1]) / 2, determinant = a[0] * b[1] - a[1] * b[0];
  const double discriminant = half_trace * half_trace - determinant;
  return discriminant < 0 ? std::log(determinant) / 2
                          : std::log(std::abs(half_trace) + std::sqrt(discriminant));
}

/// The root nearest to 1 of the recurrence's characteristic polynomial, by Newton's method, if it is certain
/// to be the largest. With the coefficients b[1], b[2], ... of the polynomial divided by its linear factor,
/// the others are smaller if sum |b[k]| / |root|^k < 1 (Cauchy).
std::optional<std::complex<double>> principal_root(const Recurrence& c) {
  std::complex<double> root = 1;
  for (int i = 0; i < 10; ++i) {
    const double size = std::abs(root);
    std::complex<double> value = 1, slope = 0;
    double others = -1, power = 1;
    for (const auto& coefficient : c) {
      others += std::abs(value) * power;
      power /= size;
      slope = slope * root + value;
      value = value * root - coefficient;
    }
    const auto correction = value / slope;
    root -= correction;
    if (std::abs(correction) < 1e-14) return others < 1 ? std::optional(root) : std::nullopt;
  }
  return std::nullopt;
}

/// ln of the largest root of the recurrence's characteristic polynomial, by its companion matrix. The real
/// matrix (x, -y; y, x) represents a complex number x + i y.
double log_radius(const Recurrence& c) {
  if (const auto root = principal_root(c)) return std::log(std::abs(*root));
  const auto n = static_cast<Eigen::Index>(2 * c.size());
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  companion.diagonal(-2).setOnes();
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(2 * i);
    companion(0, column) = companion(1, column + 1) = c[i].real();
    companion(0, column + 1) = -c[i].imag();
    companion(1, column) = c[i].imag();
  }
  double largest = 0;
  for (const auto& root : eigenvalues(companion)) largest = std::max(largest, std::abs(root));
  return std::log(largest);
}

template <class Algorithm>
double growth_of(const LinearProblem& problem) {
  if constexpr (requires { Algorithm::recurrence(problem.z); })
    return log_radius(Algorithm::recurrence(problem.z));
  if constexpr (Algorithm::kind == Kind::velocities_first) {
    const DampedOscillation oscillation{problem.z};
    return log_radius(one_step<Algorithm>(oscillation, {1, 0}), one_step<Algorithm>(oscillation, {0, 1}));
  }
  const Plane a = one_step<Algorithm>(problem, {1, 0});
  if constexpr (Algorithm::kind == Kind::partitioned)
    return log_radius(a, one_step<Algorithm>(problem, {0, 1}));
  else
    return std::log(std::hypot(a[0], a[1]));
}

}  // namespace

bool is_partitioned(std::string_view algorithm) {
  bool found = false;
  for_each_algorithm([&]<class Algorithm>() {
    if (Algorithm::name == algorithm) found = Algorithm::kind == Kind::partitioned;
  });
  return found;
}

bool is_multistep(std::string_view algorithm) {
  bool found = false;
  for_each_algorithm([&]<class Algorithm>() {
    if constexpr (requires { Algorithm::recurrence(1.0); }) found = found || Algorithm::name == algorithm;
  });
  return found;
}

namespace {

bool takes_velocities_first(std::string_view algorithm) {
  bool found = false;
  for_each_algorithm([&]<class Algorithm>() {
    if (Algorithm::name == algorithm) found = Algorithm::kind == Kind::velocities_first;
  });
  return found;
}

/// Growth rate in the reference. A partitioned algorithm has -lambda next to each eigenvalue lambda.
double growth_in_truth(std::string_view algorithm, const std::complex<double>& lambda) {
  return is_partitioned(algorithm) ? std::abs(lambda.real()) : std::max(0.0, lambda.real());
}

/// The fastest growth of a disturbance of this eigenvalue that does not count as unstable.
double allowed_growth(std::string_view algorithm, const std::complex<double>& lambda, double negligible) {
  const double fades = is_partitioned(algorithm) ? 0 : std::max(0.0, -lambda.real());
  return 2 * growth_in_truth(algorithm, lambda) + std::max(0.0, negligible * std::abs(lambda) - fades);
}

/// Growth in a step of r / |lambda|, beyond the allowed growth.
using Excess = std::function<double(double)>;

/// The step between `low` and `high` at which the excess changes its sign.
double edge(const Excess& excess, double low, double high) {
  const bool unstable = excess(high) > 0;
  while (high - low > 1e-10 * high) {
    const double middle = (low + high) / 2;
    ((excess(middle) > 0) == unstable ? high : low) = middle;
  }
  return high;
}

constexpr double largest_scanned = 30;  ///< h |lambda|

/// For an algorithm that takes velocities first, each of whose steps costs the eigenvalues of a matrix. Where
/// only the first tongue is wanted, `brief_near`: its edge is exact all the same.
constexpr double coarse_near = 0.02, brief_near = 0.05;

/// The tongues up to the step `longest`. Near an edge the next step is longer by the fraction `near`.
std::vector<Tongue> scan(const Excess& excess, double near, double longest = largest_scanned) {
  std::vector<Tongue> tongues;
  bool unstable = false;
  double last = finest / 2, r = last;
  while (r < longest) {
    check_stop();
    const double here = excess(r);
    if ((here > 0) != unstable) {
      unstable = !unstable;
      const double at = r == last ? 0 : edge(excess, last, r);
      if (unstable)
        tongues.push_back({at, infinity});
      else
        tongues.back().to = at;
    }
    last = r;
    r *= 1 + std::clamp(std::abs(here) / 20, near, 0.05);
  }
  return tongues;
}

/// Excess along the direction of `unit`.
Excess excess_along(std::string_view algorithm, std::complex<double> unit, double negligible) {
  const double allowed = allowed_growth(algorithm, unit, negligible);
  return [=](double r) { return growth(algorithm, r * unit) - r * allowed; };
}

/// The edge nearest to `at`, an edge of a neighbouring direction; nothing if it moved by more than a tenth.
std::optional<double> moved_edge(const Excess& excess, double at) {
  if (at == 0 || std::isinf(at)) return at;
  for (double part : {1e-3, 1e-2, 1e-1}) {
    const double low = at * (1 - part), high = at * (1 + part);
    if ((excess(low) > 0) != (excess(high) > 0)) return edge(excess, low, high);
  }
  return std::nullopt;
}

/// Tongues in the direction of lambda, as multiples of 1 / |lambda|. Scans its direction rounded to a
/// thousandth of a radian once, and from there moves the edges to the exact direction.
std::vector<Tongue> tongues_along(std::string_view algorithm, const std::complex<double>& lambda,
                                  double negligible) {
  static std::map<std::tuple<std::string, long, double>, std::vector<Tongue>> known;
  static std::mutex mutex;
  constexpr double to_imaginary = 1500, quarter_turn = std::numbers::pi / 2, near = 0.002;
  const double direction = std::abs(std::arg(lambda));
  const long rounded = std::lround(direction / quarter_turn * to_imaginary);
  const double scanned_direction = static_cast<double>(rounded) / to_imaginary * quarter_turn;
  std::optional<std::vector<Tongue>> tongues;
  const std::tuple key(std::string(algorithm), rounded, negligible);
  {
    const std::scoped_lock lock(mutex);
    if (const auto found = known.find(key); found != known.end()) tongues = found->second;
  }
  if (!tongues) {
    tongues = scan(excess_along(algorithm, std::polar(1.0, scanned_direction), negligible), near);
    const std::scoped_lock lock(mutex);
    known.emplace(key, *tongues);
  }
  if (std::abs(direction - scanned_direction) < 1e-12) return *tongues;
  const Excess excess = excess_along(algorithm, std::polar(1.0, direction), negligible);
  for (Tongue& tongue : *tongues) {
    const auto from = moved_edge(excess, tongue.from), to = moved_edge(excess, tongue.to);
    if (!from || !to) return scan(excess, near);
    tongue = {*from, *to};
  }
  return *tongues;
}

/// ln of the spectral radius of a step of h of x' = J x by an algorithm that takes the velocities first.
double growth_velocities_first(const std::vector<double>& jacobian, const std::vector<bool>& velocities,
                               double h) {
  const auto n = static_cast<Eigen::Index>(velocities.size());
  Eigen::MatrixXd j(n, n), step = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) j(i, k) = jacobian[static_cast<std::size_t>(i * n + k)];
  for (bool first : {true, false}) {
    const Eigen::MatrixXd rates = j * step;
    for (Eigen::Index i = 0; i < n; ++i)
      if (velocities[static_cast<std::size_t>(i)] == first) step.row(i) += h * rates.row(i);
  }
  double largest = 0;
  for (const auto& root : eigenvalues(step)) largest = std::max(largest, std::abs(root));
  return std::log(largest);
}

double largest_of(const Eigenvalues& eigenvalues) {
  double largest = 0;
  for (const auto& lambda : eigenvalues) largest = std::max(largest, std::abs(lambda));
  return largest;
}

/// Eigenvalues that turn the motion by less are left out.
double no_motion_of(const Spectrum& spectrum) {
  return 0.01 / (spectrum.span * static_cast<double>(spectrum.at.size()));
}

/// Excess at this point of the spectrum for multiples of 1 / |lambda| of its largest eigenvalue. Each
/// eigenvalue may grow as fast as the largest growth allowed for any of them. The rounding of a double root
/// counts as no growth.
Excess excess_velocities_first(const Spectrum& spectrum, std::size_t point, double size,
                               std::string_view algorithm, double negligible) {
  constexpr double rounding = 1e-7;
  double allowed = rounding * size;
  for (const auto& lambda : spectrum.at[point])
    if (std::abs(lambda) >= no_motion_of(spectrum))
      allowed = std::max(allowed, allowed_growth(algorithm, lambda, negligible));
  return [&spectrum, point, size, allowed](double r) {
    return growth_velocities_first(spectrum.jacobians[point], spectrum.velocities, r / size) -
           r * allowed / size;
  };
}

/// Excess of every disturbance at one point of the motion, and the unit of its steps.
struct ExcessAt {
  Excess excess;
  double size;
};
std::vector<ExcessAt> excesses(std::string_view algorithm, const Spectrum& spectrum, double negligible) {
  const double no_motion = no_motion_of(spectrum);
  const bool by_matrix = takes_velocities_first(algorithm) && !spectrum.jacobians.empty();
  std::vector<ExcessAt> all;
  for (std::size_t i = 0; i < spectrum.at.size(); ++i) {
    if (const double size = largest_of(spectrum.at[i]); by_matrix && size >= no_motion)
      all.push_back({excess_velocities_first(spectrum, i, size, algorithm, negligible), size});
    for (const auto& lambda : spectrum.at[i])
      if (const double size = std::abs(lambda); !by_matrix && lambda.imag() >= 0 && size >= no_motion)
        all.push_back({excess_along(algorithm, lambda / size, negligible), size});
  }
  return all;
}

/// Steps on both sides of the tongues' edges, and a few between them.
std::vector<double> decisive_steps(const std::vector<Tongue>& tongues, double shortest, double longest) {
  constexpr double beside = 1.01;
  constexpr int within = 4;
  std::vector<double> edges{shortest}, steps;
  for (const Tongue& tongue : tongues)
    for (const double edge : {tongue.from, tongue.to})
      if (edge > edges.back() && edge < longest) edges.push_back(edge);
  edges.push_back(longest);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double ratio = edges[i + 1] / edges[i];
    const double margin = std::min(beside, std::pow(ratio, 0.25));
    const double from = edges[i] * margin, to = edges[i + 1] / margin;
    for (int k = 0; k <= within; ++k)
      steps.push_back(from * std::pow(to / from, static_cast<double>(k) / within));
  }
  return steps;
}

/// Whether the tongues agree with the spectrum at these steps.
bool are_confirmed(const std::vector<Tongue>& tongues, std::string_view algorithm, const Spectrum& spectrum,
                   double negligible) {
  const std::vector<ExcessAt> all = excesses(algorithm, spectrum, negligible);
  double fastest = 0;
  for (const ExcessAt& one : all) fastest = std::max(fastest, one.size);
  if (all.empty()) return false;
  for (const double step : decisive_steps(tongues, finest / fastest, largest_scanned / fastest)) {
    check_stop();
    const bool is_known = std::ranges::any_of(
        tongues, [=](const Tongue& tongue) { return tongue.from < step && step < tongue.to; });
    const bool is_unstable =
        std::ranges::any_of(all, [=](const ExcessAt& one) { return one.excess(step * one.size) > 0; });
    if (is_known != is_unstable) return false;
  }
  return true;
}

}  // namespace

std::vector<double> jacobian_at(const std::function<void(const double*, double*, double)>& rhs,
                                std::span<const double> x, double t) {
  const detail::RawProblem problem{
      x.size(), &rhs,
      [](const void* object, const double* y, double* dydt, double time) {
        (*static_cast<const std::function<void(const double*, double*, double)>*>(object))(y, dydt, time);
        return detail::Call::ok;
      },
      nullptr};
  std::vector<double> rows(x.size() * x.size());
  detail::differences(problem, x.data(), rows.data(), nullptr, t);
  return rows;
}

Eigenvalues eigenvalues_of(const std::vector<double>& matrix) {
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
  const Eigen::MatrixXd transposed = Eigen::Map<const Eigen::MatrixXd>(matrix.data(), n, n);
  return eigenvalues(transposed);  // same as those of the matrix
}

double growth(std::string_view algorithm, std::complex<double> z) {
  check_stop();
  if (algorithm == ImplicitEuler::name) return -std::log(std::abs(1.0 - z));
  std::optional<double> found;
  for_each_algorithm([&]<class Algorithm>() {
    if constexpr (!has_tolerance(Algorithm::kind))
      if (Algorithm::name == algorithm) found = growth_of<Algorithm>({z});
  });
  if (!found) throw std::logic_error("no algorithm of fixed step is called " + std::string(algorithm));
  return *found;
}

std::vector<Tongue> unstable_steps(std::string_view algorithm, const Spectrum& spectrum, double negligible) {
  if (const auto* known = KnownTongues::here();
      known && are_confirmed(*known, algorithm, spectrum, negligible))
    return *known;
  const double no_motion = no_motion_of(spectrum);
  const bool by_matrix = takes_velocities_first(algorithm) && !spectrum.jacobians.empty();
  std::vector<Tongue> all;
  const auto add = [&](const std::vector<Tongue>& tongues, double size) {
    for (const Tongue& tongue : tongues)
      all.push_back({tongue.from < finest ? 0 : tongue.from / size, tongue.to / size});
  };
  for (std::size_t i = 0; i < spectrum.at.size(); ++i) {
    if (const double size = largest_of(spectrum.at[i]); by_matrix && size >= no_motion)
      add(scan(excess_velocities_first(spectrum, i, size, algorithm, negligible), coarse_near), size);
    if (by_matrix) continue;
    for (const auto& lambda : spectrum.at[i]) {
      const double size = std::abs(lambda);
      if (lambda.imag() < 0 || size < no_motion)
        continue;  // a real Jacobian has conjugate pairs of equal growth
      add(tongues_along(algorithm, lambda, negligible), size);
    }
  }
  std::ranges::sort(all, {}, &Tongue::from);
  std::vector<Tongue> united;
  for (const Tongue& tongue : all)
    if (united.empty() || tongue.from > united.back().to)
      united.push_back(tongue);
    else
      united.back().to = std::max(united.back().to, tongue.to);
  return united;
}

double stable_step(std::string_view algorithm, const Spectrum& spectrum) {
  if (!(takes_velocities_first(algorithm) && !spectrum.jacobians.empty())) {
    const auto tongues = unstable_steps(algorithm, spectrum);
    return tongues.empty() ? infinity : tongues.front().from;
  }
  double shortest = infinity;
  for (const ExcessAt& one : excesses(algorithm, spectrum, negligible_growth))
    if (const auto tongues = scan(one.excess, brief_near, std::min(shortest * one.size, largest_scanned));
        !tongues.empty())
      shortest = std::min(shortest, tongues.front().from < finest ? 0 : tongues.front().from / one.size);
  return shortest;
}

double added_growth(std::string_view algorithm, const Spectrum& spectrum, double step, double time,
                    double as_fast) {
  const bool by_matrix = takes_velocities_first(algorithm) && !spectrum.jacobians.empty();
  double sum = 0;
  for (std::size_t i = 0; i < spectrum.at.size(); ++i) {
    double most = -infinity, in_truth = 0;
    for (const auto& lambda : spectrum.at[i]) {
      const double truth = as_fast * growth_in_truth(algorithm, lambda);
      in_truth = std::max(in_truth, truth);
      if (!by_matrix) most = std::max(most, growth(algorithm, step * lambda) / step - truth);
    }
    if (by_matrix)
      most = growth_velocities_first(spectrum.jacobians[i], spectrum.velocities, step) / step - in_truth;
    sum += most;
  }
  return sum / static_cast<double>(spectrum.at.size()) * time;
}

double fastest(const Spectrum& spectrum) {
  double sum = 0;
  for (const Eigenvalues& eigenvalues : spectrum.at) sum += largest_of(eigenvalues);
  return sum / static_cast<double>(spectrum.at.size());
}

double largest(const Spectrum& spectrum) {
  double most = 0;
  for (const Eigenvalues& eigenvalues : spectrum.at) most = std::max(most, largest_of(eigenvalues));
  return most;
}

}  // namespace oddity::ode
