#include <numbers>

#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex05_03 {

using namespace fields;

// ---- derivatives ------------------------------------------------------------------------------------------

namespace {

/// The three derivatives and their sum, times |x|^3.
Value scaled(const Point& slopes, const Point& x) {
  const double r = length(x);
  const Point s{slopes[0] * r * r * r, slopes[1] * r * r * r, slopes[2] * r * r * r};
  return {s[0], s[1], s[2], s[0] + s[1] + s[2]};
}

/// A central difference, in scaled(), by a step of `part` of |x|. It omits about part^order, and a rounding
/// is divided by the step.
struct Difference {
  int order;
  double part;

  double omitted() const { return 4 * std::pow(part, order); }
  double rounded() const { return epsilon / (2 * part); }
  Foreseen ends(double need) const {
    constexpr double known_to = 30;
    return foreseen(within_factor(known_to, omitted() + rounded()), need);
  }
  std::string why() const {
    return omitted() > rounded() ? R"(even the finest step is too coarse for $|\mathbf x|$)"
           : 4 * part < epsilon  ? "$x+h$ is $x$"
                                 : "rounding grows as $1/h$: the finest step is not the best";
  }
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
};

}  // namespace

Foreseen by_quotient_rule(const Point& x) {
  const double below = half_power(dot(x, x), 6);
  if (std::isinf(below)) return {Outcome::inaccurate};
  return {below == 0 ? Outcome::non_finite : Outcome::ok, below == 0 || std::isnormal(below)};
}

Quantity partials(const std::string& name, const std::string& says, const Point& x, const Reference& truth) {
  const Known known = truth("05_03_partials", {x[0], x[1], x[2]});
  Quantity q{
      name,
      "1",
      says,
      {known.source + ", and the sum zero", Value{known.value[0], known.value[1], known.value[2], 0.0}},
      known.error,
      {1e-9, "nine decimals"},
      {},
      {}};
  const double need = q.need.allowed;
  const std::string field = "field", formula = "published derivatives";
  const auto published = [x](Point (*f)(const Point&)) {
    return [x, f](double) { return Answer{scaled(f(x), x), static_cast<long>(x.size())}; };
  };
  const Foreseen by_rule = by_quotient_rule(x);
  const bool overflows = by_rule.outcome == Outcome::inaccurate;
  q.add(expecting(by_rule,
                  filled(overflows ? R"($|\mathbf x|^6$ overflows from $|\mathbf x|=@2$ on)"
                                   : R"($|\mathbf x|^6$ is zero below $|\mathbf x|=@2$)",
                         {std::pow(overflows ? std::numeric_limits<double>::max()
                                             : std::numeric_limits<double>::denorm_min(),
                                   1.0 / 6)}),
                  {formula, "quotient rule", no_resolution(), published(each<quotient>)}));
  q.add({formula, "simplified", no_resolution(), published(each<simplified>)});
  const auto by = [x](auto way) {
    Point slopes;
    for (std::size_t i = 0; i < 3; ++i) slopes[i] = way.along(inverse_square, x, axes[i])[i];
    return Answer{scaled(slopes, x), way.calls};
  };
  const double size = length(x);
  q.add({field, "dual numbers", no_resolution(), [=](double) { return by(ByDuals{}); }});
  const auto by_differences = [&]<int order>(const std::string& step, double unit) {
    const Difference finest{order, steps().settings.back() * unit / size};
    q.add(expecting(finest.ends(need), finest.why(),
                    {field + ", step " + step, "central differences " + std::to_string(order), steps(),
                     [=](double h) { return by(ByDifferences<order>{h * unit}); }}));
  };
  for (const auto& [step, unit] : {std::pair{"h", 1.0}, std::pair{"h |x|", size}}) {
    by_differences.operator()<2>(step, unit);
    by_differences.operator()<4>(step, unit);
  }
  return q;
}

// ---- the flux: 4 pi when the origin is inside, 0 when it is outside ---------------------------------------

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

/// Semi-axes a, a, b; the centre is d along b. The axis b is not along an axis of the integration.
struct Spheroid {
  double a, b, d;
  Point axis{2.0 / 3, 1.0 / 3, 2.0 / 3};

  /// x.dS / |x|^3 per unit of u = cos(theta) and phi: with x = d axis + A n, dS = det(A) A^-1 n du dphi.
  double density(double u, double phi) const {
    const double s = std::sqrt(std::max(0.0, 1 - u * u));
    const Point n{s * std::cos(phi), s * std::sin(phi), u};
    const double along = dot(axis, n);
    Point x, normal;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = a * n[i] + (d + (b - a) * along) * axis[i];
      normal[i] = a * b * n[i] + a * (a - b) * along * axis[i];
    }
    const double square = dot(x, x);
    return dot(x, normal) / (square * std::sqrt(square));
  }
};

/// Half side h, centre c.
struct Cube {
  double h;
  Point c;

  /// The sum of `face(density, ranges)` over the faces, where the density is x.dS / |x|^3 in the face's
  /// coordinates.
  template <class Face>
  Integral over_faces(const Face& face) const {
    Integral sum;
    for (std::size_t n = 0; n < 3; ++n)
      for (double side : {-1.0, 1.0}) {
        const double z = h + side * c[n], x = c[(n + 1) % 3], y = c[(n + 2) % 3];
        const Integral one =
            face([z](double p, double q) { return z / std::pow(p * p + q * q + z * z, 1.5); }, x, y);
        sum.value += one.value;
        sum.evaluations += one.evaluations;
        if (sum.reached()) sum.ending = one.ending, sum.message = one.message;
      }
    return sum;
  }
  Integral flux(const Rule& rule) const {
    return over_faces([&](const auto& density, double x, double y) {
      return nested(
          rule, density, x - h, x + h, [y, this](double) { return y - h; },
          [y, this](double) { return y + h; });
    });
  }
};

Tolerance ten_decimals() { return {1e-10, "ten decimals"}; }

template <class F>
Rule with(F rule, double setting) {
  return
      [rule, n = static_cast<int>(setting)](FunctionOfOne f, double a, double b) { return rule(f, a, b, n); };
}
Rule qags_with(double tolerance) {
  return [tolerance](FunctionOfOne f, double a, double b) { return qags(f, a, b, tolerance); };
}

const std::string low_order = "order 4 is too low for ten decimals with these panels";

}  // namespace

Quantity spheroid_flux(const std::string& name, const std::string& says, double a, double b, double d,
                       const Reference& truth, bool peaked) {
  const Spheroid surface{a, b, d};
  Quantity q = quantity(name, "1", says, truth("05_03_spheroid_flux", {a, b, d}), ten_decimals());
  const Outcome fixed = peaked ? Outcome::inaccurate : Outcome::ok;
  const std::string why = peaked ? "the density is a peak, narrower than the points are apart" : "";
  const auto by = [surface](const Rule& rule) {
    const auto in_angles = [&](double theta, double phi) {
      return std::sin(theta) * surface.density(std::cos(theta), phi);
    };
    const auto zero = [](double) { return 0.0; };
    return answer(nested(rule, in_angles, 0, std::numbers::pi, zero, [](double) { return two_pi; }));
  };
  const auto by_product = [surface](double points) {
    const int n = static_cast<int>(points);
    long calls = 0;
    const auto circle = [&](double u) {
      const Integral around =
          trapezoid([&](double phi) { return surface.density(u, phi); }, 0, two_pi, 2 * n);
      calls += around.evaluations;
      return around.value;
    };
    const Integral flux = gauss_legendre(circle, -1, 1, n);
    return Answer{flux.value, calls};
  };
  const std::string angles = "theta, phi";
  q.add({"cos(theta), phi", "Gauss-Legendre by trapezoid", doubling("points", 4, 6), by_product, fixed, why});
  q.add({angles, "Gauss-Legendre", doubling("points", 4, 6),
         [by](double n) { return by(with(gauss_legendre, n)); }, fixed, why});
  q.add({angles, "Simpson", doubling("panels", 8, 6), [by](double n) { return by(with(simpson, n)); },
         Outcome::inaccurate, peaked ? why : low_order});
  q.add({angles, "trapezoid", doubling("panels", 8, 6), [by](double n) { return by(with(trapezoid, n)); },
         Outcome::inaccurate, R"(over $\theta$, which is no period, the trapezoid rule has order 2)"});
  q.add({angles, "QAGS", tolerances(2, 10), [by](double tolerance) { return by(qags_with(tolerance)); }});
  return q;
}

Quantity cube_flux(double h, const Reference& truth) {
  const Cube cube{h, {0.25 * h, -0.5 * h, 0.125 * h}};
  Quantity q =
      quantity("flux_cube", "1", "flux through a cube around the origin, its centre at $(h/4,-h/2,h/8)$",
               truth("05_03_cube_flux", {cube.h, cube.c[0], cube.c[1], cube.c[2]}), ten_decimals());
  q.add({"faces", "Gauss-Legendre", doubling("points", 4, 5),
         [cube](double n) { return answer(cube.flux(with(gauss_legendre, n))); }});
  q.add({"faces", "Simpson", doubling("panels", 8, 5),
         [cube](double n) { return answer(cube.flux(with(simpson, n))); }, Outcome::inaccurate, low_order});
  q.add({"faces", "QAGS", tolerances(2, 10),
         [cube](double tolerance) { return answer(cube.flux(qags_with(tolerance))); }});
  return q;
}

}  // namespace oddity::ex05_03
