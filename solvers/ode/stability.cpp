#include "solvers/ode/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

namespace oddity::ode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Plane = std::array<double, 2>;

/// y' = z y in its real and imaginary parts, and, partitioned, q'' = Re(z^2) q.
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

template <class Algorithm>
Plane one_step(const LinearProblem& problem, const Plane& y) {
  return integrate<Algorithm>(problem, y, 0, 1, 1).value;
}

/// ln of the spectral radius of the 2 x 2 matrix whose columns are a step of (1, 0) and of (0, 1).
double log_radius(const Plane& a, const Plane& b) {
  const double half_trace = (a[0] + b[1]) / 2, determinant = a[0] * b[1] - a[1] * b[0];
  const double discriminant = half_trace * half_trace - determinant;
  return discriminant < 0 ? std::log(determinant) / 2
                          : std::log(std::abs(half_trace) + std::sqrt(discriminant));
}

/// The root next to 1 of the recurrence's characteristic polynomial, by Newton's method, where it is certain
/// to be the largest: with b[1], b[2], ... the coefficients of what the polynomial leaves when divided by it,
/// the others are smaller where sum |b[k]| / |root|^k < 1 (Cauchy).
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

/// ln of the largest root of the recurrence's characteristic polynomial: by its companion matrix, a complex
/// number x + i y being the real matrix (x, -y; y, x).
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

/// Beside each eigenvalue lambda a partitioned algorithm also has -lambda.
double growth_in_truth(std::string_view algorithm, const std::complex<double>& lambda) {
  return is_partitioned(algorithm) ? std::abs(lambda.real()) : std::max(0.0, lambda.real());
}

/// In the direction of lambda, as multiples of 1 / |lambda|.
std::vector<Tongue> scan(std::string_view algorithm, double direction, double negligible) {
  const std::complex<double> unit = std::polar(1.0, direction);
  const double allowed = 2 * growth_in_truth(algorithm, unit) + negligible;
  const auto excess = [&](double r) { return growth(algorithm, r * unit) - r * allowed; };
  const auto edge = [&](double low, double high) {
    const bool unstable = excess(high) > 0;
    for (int i = 0; i < 30; ++i) ((excess((low + high) / 2) > 0) == unstable ? high : low) = (low + high) / 2;
    return high;
  };
  constexpr double largest = 30;
  std::vector<Tongue> tongues;
  bool unstable = false;
  double last = finest / 2, r = last;
  while (r < largest) {
    const double here = excess(r);
    if ((here > 0) != unstable) {
      unstable = !unstable;
      const double at = r == last ? 0 : edge(last, r);
      if (unstable)
        tongues.push_back({at, infinity});
      else
        tongues.back().to = at;
    }
    last = r;
    r *= 1 + std::clamp(std::abs(here) / 20, 0.002, 0.05);
  }
  return tongues;
}

/// The scan in this direction, rounded to a thousandth of a radian; each is made once.
const std::vector<Tongue>& scanned(std::string_view algorithm, const std::complex<double>& lambda,
                                   double negligible) {
  static std::map<std::tuple<std::string, long, double>, std::vector<Tongue>> known;
  static std::mutex mutex;
  constexpr double to_imaginary = 1500, quarter_turn = std::numbers::pi / 2;
  const long rounded = std::lround(std::abs(std::arg(lambda)) / quarter_turn * to_imaginary);
  const std::tuple key(std::string(algorithm), rounded, negligible);
  {
    const std::scoped_lock lock(mutex);
    if (const auto found = known.find(key); found != known.end()) return found->second;
  }
  auto tongues = scan(algorithm, static_cast<double>(rounded) / to_imaginary * quarter_turn, negligible);
  const std::scoped_lock lock(mutex);
  return known.emplace(key, std::move(tongues)).first->second;
}

}  // namespace

Eigenvalues eigenvalues_of_jacobian(const std::function<void(const double*, double*, double)>& rhs,
                                    std::span<const double> x, double t) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const detail::RawProblem problem{
      x.size(), &rhs,
      [](const void* object, const double* y, double* dydt, double time) {
        (*static_cast<const std::function<void(const double*, double*, double)>*>(object))(y, dydt, time);
        return detail::Call::ok;
      },
      nullptr};
  Eigen::MatrixXd transposed(n, n);  // Eigen's columns are the problem's rows; the eigenvalues are the same
  detail::differences(problem, x.data(), transposed.data(), nullptr, t);
  return eigenvalues(transposed);
}

double growth(std::string_view algorithm, std::complex<double> z) {
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
  const double no_motion = 0.01 / (spectrum.span * static_cast<double>(spectrum.at.size()));
  std::vector<Tongue> all;
  for (const Eigenvalues& eigenvalues : spectrum.at)
    for (const auto& lambda : eigenvalues) {
      const double size = std::abs(lambda);
      if (lambda.imag() < 0 || size < no_motion) continue;  // a real Jacobian's come in pairs that grow alike
      for (const Tongue& tongue : scanned(algorithm, lambda, negligible))
        all.push_back({tongue.from < finest ? 0 : tongue.from / size, tongue.to / size});
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
  const auto tongues = unstable_steps(algorithm, spectrum);
  return tongues.empty() ? infinity : tongues.front().from;
}

double added_growth(std::string_view algorithm, const Spectrum& spectrum, double step, double time,
                    double as_fast) {
  double sum = 0;
  for (const Eigenvalues& eigenvalues : spectrum.at) {
    double most = -infinity;
    for (const auto& lambda : eigenvalues)
      most = std::max(most,
                      growth(algorithm, step * lambda) / step - as_fast * growth_in_truth(algorithm, lambda));
    sum += most;
  }
  return sum / static_cast<double>(spectrum.at.size()) * time;
}

namespace {

double largest_of(const Eigenvalues& eigenvalues) {
  double largest = 0;
  for (const auto& lambda : eigenvalues) largest = std::max(largest, std::abs(lambda));
  return largest;
}

}  // namespace

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
