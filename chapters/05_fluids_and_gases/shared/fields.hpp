#pragma once

#include <array>
#include <string>
#include <utility>

#include "chapters/numbers.hpp"
#include "chapters/random.hpp"
#include "solvers/dual.hpp"

/// Scalar and vector fields over space, generic in their number type, and the operators of vector calculus. A
/// scalar field maps Triple<T> to T, a vector field to Triple<T>. An operator maps a field to a field, so
/// operators nest, each adding a level of dual numbers.
namespace oddity::fields {

template <class T>
using Triple = std::array<T, 3>;
using Point = Triple<double>;
/// Three orthonormal vectors.
using Frame = std::array<Point, 3>;
/// Row i, column j: the derivative of component i by x_j.
template <class T>
using Matrix = std::array<Triple<T>, 3>;

constexpr Frame axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline double length(const Point& x) { return std::hypot(x[0], x[1], x[2]); }

/// A randomly rotated frame.
inline Frame random_frame(Random& random) {
  const Point u = random.direction(), v = cross(u, random.direction());
  const Point w{v[0] / length(v), v[1] / length(v), v[2] / length(v)};
  return {u, w, cross(u, w)};
}

// ---- random fields ----------------------------------------------------------------------------------------

/// A sum of terms (p + q.x) sin(k.x + c) exp(l.x) with random coefficients.
class ScalarField {
 public:
  ScalarField() = default;
  /// `size` scales the value, `rate` the derivatives.
  ScalarField(Random& random, double size, double rate) {
    for (Term& t : terms_)
      t = {size * random.between(-1, 1), scaled(random.point(), size * rate),
           scaled(random.point(), 3 * rate), random.between(-3, 3), scaled(random.point(), rate)};
  }

  template <class T>
  T operator()(const Triple<T>& x) const {
    using std::exp, std::sin;
    T sum(0.0);
    for (const Term& t : terms_) sum += (T(t.p) + dot(t.q, x)) * sin(dot(t.k, x) + T(t.c)) * exp(dot(t.l, x));
    return sum;
  }

 private:
  struct Term {
    double p;
    Point q, k;
    double c;
    Point l;
  };
  static Point scaled(const Point& x, double s) { return {s * x[0], s * x[1], s * x[2]}; }

  std::array<Term, 3> terms_{};
};

class VectorField {
 public:
  VectorField() = default;
  VectorField(Random& random, double size, double rate) {
    for (ScalarField& c : components_) c = {random, size, rate};
  }

  template <class T>
  Triple<T> operator()(const Triple<T>& x) const {
    return {components_[0](x), components_[1](x), components_[2](x)};
  }

 private:
  std::array<ScalarField, 3> components_;
};

// ---- operators by dual numbers ----------------------------------------------------------------------------

template <class T>
T slope_of(const Dual<T>& y) {
  return y.slope;
}
template <class T>
Triple<T> slope_of(const Triple<Dual<T>>& y) {
  return {y[0].slope, y[1].slope, y[2].slope};
}

/// The derivative of a field along u at x.
template <class Field, class T>
auto along(const Field& f, const Triple<T>& x, const Point& u) {
  return slope_of(f(Triple<Dual<T>>{Dual<T>(x[0], T(u[0])), Dual<T>(x[1], T(u[1])), Dual<T>(x[2], T(u[2]))}));
}

/// The field d f / d x_j.
template <class Field>
auto partial(Field f, std::size_t j) {
  return [f = std::move(f), j](const auto& x) { return along(f, x, axes[j]); };
}

template <class Field, class T>
Matrix<T> jacobian(const Field& f, const Triple<T>& x) {
  Matrix<T> m;
  for (std::size_t j = 0; j < 3; ++j) {
    const Triple<T> column = along(f, x, axes[j]);
    for (std::size_t i = 0; i < 3; ++i) m[i][j] = column[i];
  }
  return m;
}

/// Sum over an orthonormal frame of u_k o (u_k.grad) f, where o is multiplication (gradient), dot
/// (divergence) or cross (curl). It is the same in every frame, and a rotated one shares no index lists with
/// a published proof.
template <class Field>
auto gradient(Field f, Frame frame = axes) {
  return [f = std::move(f), frame]<class T>(const Triple<T>& x) {
    Triple<T> sum{};
    for (const Point& u : frame) {
      const T slope = along(f, x, u);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += u[i] * slope;
    }
    return sum;
  };
}
template <class Field>
auto divergence(Field f, Frame frame = axes) {
  return [f = std::move(f), frame]<class T>(const Triple<T>& x) {
    T sum(0.0);
    for (const Point& u : frame) sum += dot(u, along(f, x, u));
    return sum;
  };
}
template <class Field>
auto curl(Field f, Frame frame = axes) {
  return [f = std::move(f), frame]<class T>(const Triple<T>& x) {
    Triple<T> sum{};
    for (const Point& u : frame) {
      const Triple<T> term = cross(u, along(f, x, u));
      for (std::size_t i = 0; i < 3; ++i) sum[i] += term[i];
    }
    return sum;
  };
}

/// (f.grad) g
template <class F, class G>
auto advected(F f, G g, Frame frame = axes) {
  return [f, g, frame]<class T>(const Triple<T>& x) {
    const Triple<T> v = f(x);
    Triple<T> sum{};
    for (const Point& u : frame) {
      const T weight = dot(u, v);
      const Triple<T> slope = along(g, x, u);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += weight * slope[i];
    }
    return sum;
  };
}

// ---- products of fields -----------------------------------------------------------------------------------

/// phi f
template <class Scalar, class Vector>
auto times(Scalar phi, Vector f) {
  return [phi, f]<class T>(const Triple<T>& x) {
    const T factor = phi(x);
    const Triple<T> v = f(x);
    return Triple<T>{factor * v[0], factor * v[1], factor * v[2]};
  };
}
/// f . g
template <class F, class G>
auto dot_product(F f, G g) {
  return [f, g](const auto& x) { return dot(f(x), g(x)); };
}
/// f x g
template <class F, class G>
auto cross_product(F f, G g) {
  return [f, g](const auto& x) { return cross(f(x), g(x)); };
}

// ---- the fields of the exercises' quantities --------------------------------------------------------------

/// Three fields without symmetry, of wave number w; reference/make/fields.hpp has its own copy.
struct Waves {
  double w = 1;

  template <class T>
  T phi(const Triple<T>& x) const {
    using std::exp, std::sin;
    const auto [a, b, c] = scaled(x);
    return exp(0.5 * a) * sin(b + c) + a * b * c;
  }
  template <class T>
  Triple<T> f(const Triple<T>& x) const {
    using std::cos, std::exp, std::sin;
    const auto [a, b, c] = scaled(x);
    return {sin(a + 2.0 * b) * exp(0.5 * c) + b * c * c, cos(b * c) + a * a * c,
            exp(-0.5 * a) * cos(2.0 * b - c) + a * b};
  }
  template <class T>
  Triple<T> g(const Triple<T>& x) const {
    using std::cos, std::exp, std::sin;
    const auto [a, b, c] = scaled(x);
    return {cos(a - c) * exp(0.5 * b) + b * b, sin(a * b) + a * c, exp(0.5 * b) * sin(a + c) + a * b * c};
  }

 private:
  template <class T>
  Triple<T> scaled(const Triple<T>& x) const {
    return {w * x[0], w * x[1], w * x[2]};
  }
};

}  // namespace oddity::fields
