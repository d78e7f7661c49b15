#pragma once

#include <complex>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

/// Linear theory of stability: how an algorithm's step changes y' = lambda y, and what that allows along a
/// motion whose Jacobian is frozen point by point.
namespace oddity::ode {

using Eigenvalues = std::vector<std::complex<double>>;

/// The eigenvalues of a model's Jacobian at points of its motion, each of which stands for `span` of time.
struct Spectrum {
  double span;
  std::vector<Eigenvalues> at;
};

/// rhs(x, dxdt, t) of as many unknowns as `x` has; the Jacobian by central differences.
Eigenvalues eigenvalues_of_jacobian(const std::function<void(const double*, double*, double)>& rhs,
                                    std::span<const double> x, double t);

/// ln |R(z)|, the rate at which y' = lambda y grows in a step of the named algorithm, z = h lambda. A
/// partitioned algorithm solves q'' = lambda^2 q, of which it takes the real part, and gives its faster
/// growth; a multistep one gives the growth of its largest root. Throws std::logic_error for an algorithm
/// that has no fixed step.
double growth(std::string_view algorithm, std::complex<double> z);

/// The largest step up to which disturbances grow, over the whole spectrum, less than tenfold beyond what
/// they do in truth; infinity when every step does.
double stable_step(std::string_view algorithm, const Spectrum&);

}  // namespace oddity::ode
