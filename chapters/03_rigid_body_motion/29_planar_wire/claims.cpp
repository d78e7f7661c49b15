// The claims of exercise 3.29. Positions are compared with complex multiplication, derivatives with dual
// numbers, and integrals with antiderivatives for three wires. The energy is compared with a sum over
// particles, and forces with the slope of the total potential energy.

#include <concepts>
#include <optional>

#include "chapters/03_rigid_body_motion/29_planar_wire/planar_wire.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_29 {

using std::cos, std::hypot, std::sin, std::sqrt;

template <class T>
using PointOf = planar_wire::Point<T>;

/// exp(i angle) z by complex multiplication.
template <class T>
PointOf<T> turned_by(const T& angle, const PointOf<T>& z) {
  const T C = cos(angle), S = sin(angle);
  return {C * z[0] - S * z[1], C * z[1] + S * z[0]};
}

/// A random wire in motion, and a point b of it in body space. Recorded for Coq, the wire is any curve (b0 s,
/// b1 s) of the density delta s, and the point is arbitrary.
template <class T>
struct SampleOf {
  Wire wire{};
  T x{}, y{}, theta{}, vx{}, vy{}, w{};
  Point center{};
  PointOf<T> b{};
  T mu0;
  T turn = T(1);  ///< rotation of the curve in body space
  std::optional<Tolerance> allowed = {};

  SampleOf() = default;
  explicit SampleOf(Random& random)
      : wire{static_cast<Shape>(random.below(3)), random.between(0.5, 2), random.between(0.3, 3),
             random.between(0.5, 2)},
        x(random.between(-3, 3)),
        y(random.between(-3, 3)),
        theta(random.between(-3, 3)),
        vx(random.magnitude(0.5, 3)),
        vy(random.magnitude(0.5, 3)),
        w(random.magnitude(0.5, 3)),
        center(wire.center()),
        b(body(wire.end() * random.between(0.02, 0.98))),
        mu0(wire.over_mass([](double) { return 1; })) {}

  std::array<T*, 8> quantities() { return {&x, &y, &theta, &vx, &vy, &w, &b[0], &b[1]}; }
  Tolerance tolerance(double terms) const { return allowed.value_or(rounding(terms)); }
  std::string where() const {
    const char* const shapes[] = {"straight", "semicircle", "parabola"};
    return shapes[static_cast<int>(wire.shape)] +
           filled(R"(, $q$ = @4, density @4 (1 + @4 $s/L$), $\theta$ = @4)",
                  {wire.q, wire.d0, wire.k, theta});
  }
  TypesetIn<T> typeset() const;
  /// A function's values at the nodes of integrals over the wire.
  Value at_nodes(const auto& f) const {
    std::vector<double> all;
    wire.along([&](double u) {
      const Value here = f(u);
      all.insert(all.end(), here.begin(), here.end());
      return 0;
    });
    return all;
  }
  Point body(double u) const {
    const Point p = wire.point(u);
    return {p[0] - center[0], p[1] - center[1]};
  }
  /// Position by complex numbers, c + exp(i theta) p, where p is the point in the body.
  PointOf<T> position(const PointOf<T>& p) const {
    const PointOf<T> z = turned_by(theta, p);
    return {x + z[0], y + z[1]};
  }
  /// Velocity by dual numbers in the time.
  PointOf<T> velocity(const PointOf<T>& p) const {
    const Dual<T> angle(theta, w);
    return {(Dual<T>(x, vx) + p[0] * cos(angle) - p[1] * sin(angle)).slope,
            (Dual<T>(y, vy) + p[0] * sin(angle) + p[1] * cos(angle)).slope};
  }
  /// The kinetic energy of 2000 particles.
  double of_particles() const {
    constexpr int n = 2000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      const double u = wire.end() * (i + 0.5) / n;
      const Point v = velocity(body(u));
      sum += wire.density(u) * wire.stretch(u) * wire.end() / n * (v[0] * v[0] + v[1] * v[1]) / 2;
    }
    return sum;
  }
  /// Mass integral of a function of the body's points and their velocities.
  template <class F>
  T integrated(const F& of) const {
    if constexpr (std::same_as<T, Shortened>) {
      const PointOf<T> p{T::letter("b0 s"), T::letter("b1 s")};
      return T::letter("(RInt (fun s => (" + T(of(p, velocity(p))).expression().coq() + ") * delta s) 0 L)");
    } else {
      return wire.over_mass([&](double u) {
        const Point p = body(u);
        return of(p, velocity(p));
      });
    }
  }
  T mu2() const {
    return integrated([](const auto& p, const auto&) { return p[0] * p[0] + p[1] * p[1]; });
  }
};

namespace {

using Sample = SampleOf<double>;
using Samples = std::vector<Sample>;
using Reader = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;

/// A force per mass with a potential: phi(X, Y) = X^2 Y/4 + 10 Y + sin(X).
template <class T>
T phi(const T& X, const T& Y) {
  using std::sin;
  return 0.25 * X * X * Y + 10.0 * Y + sin(X);
}
PointOf<double> force(const PointOf<double>& r) {
  return {-0.5 * r[0] * r[1] - cos(r[0]), -0.25 * r[0] * r[0] - 10};
}

// Recorded for Coq, it is any potential with the slopes Ux and Uy.
Shortened of_place(const char* name, const PointOf<Shortened>& r) {
  return Expression::letter("(" + std::string(name) + " (" + r[0].expression().coq() + ") (" +
                            r[1].expression().coq() + "))");
}
Dual<Shortened> phi(const Dual<Shortened>& X, const Dual<Shortened>& Y) {
  const PointOf<Shortened> r{X.value, Y.value};
  return {of_place("U", r), of_place("Ux", r) * X.slope + of_place("Uy", r) * Y.slope};
}
PointOf<Shortened> force(const PointOf<Shortened>& r) { return {-of_place("Ux", r), -of_place("Uy", r)}; }

}  // namespace

template <class T>
TypesetIn<T> SampleOf<T>::typeset() const {
  const T C = cos(theta), S = sin(theta);
  TypesetIn<T> letters{{"L", b[0]},          {"x", x},
                       {"b_0", b[0]},        {"y", y},
                       {"b_1", b[1]},        {R"(\dot\theta)", w},
                       {"c", {x, y}},        {R"(\mu_0)", mu0},
                       {"b", {b[0], b[1]}},  {R"(\mu_2)", mu2()},
                       {R"(\dot x)", vx},    {R"(\dot c)", {vx, vy}},
                       {R"(\dot y)", vy},    {R"(R(\theta))", {C, -S, S, C}},
                       {"R", {C, -S, S, C}}, {R"(\frac{dR}{d\theta})", {-S, -C, C, -S}},
                       {R"(\theta)", theta}};
  if constexpr (std::same_as<T, double>) {
    const TypesetLetters along{{"ds", at_nodes([&](double node) {
                                  return wire.along([=](double u) { return u == node ? 1 : 0; });
                                })},
                               {R"(\delta)", at_nodes([&](double u) { return wire.density(u); })},
                               {"b", at_nodes([&](double u) { return body(u); })},
                               {"b_0", at_nodes([&](double u) { return body(u)[0]; })},
                               {"b_1", at_nodes([&](double u) { return body(u)[1]; })},
                               {"v", velocity(b)},
                               {"v", at_nodes([&](double u) { return velocity(body(u)); })},
                               {"F", at_nodes([&](double u) { return force(position(body(u))); })},
                               {R"(\imath)", {1, 0}},
                               {R"(\jmath)", {0, 1}}};
    letters.insert(letters.end(), along.begin(), along.end());
  }
  return letters;
}

namespace {

/// The point turned by the matrix dR/dtheta.
template <class T>
PointOf<T> turned(const SampleOf<T>& s, const PointOf<T>& p) {
  return {-p[0] * sin(s.theta) - p[1] * cos(s.theta), p[0] * cos(s.theta) - p[1] * sin(s.theta)};
}

/// The derivative by the angle theta, recorded as such.
template <class T, class F>
T slope_at(const T& theta, const F& f) {
  if constexpr (std::same_as<T, Shortened>)
    return T::letter("(Derive (fun theta => " + f(theta).expression().coq() + ") theta)");
  else
    return derivative(f, theta);
}

// ---- the text's formulas ----------------------------------------------------------------------------------

/// The kinetic energy of a uniform rod of the same mass and the length l, by quadrature.
template <class T>
T energy_of_rod(const SampleOf<T>& s, const std::type_identity_t<T>& l) {
  const auto f = [&](const T& L) {
    const PointOf<T> v = s.velocity({L, T(0)});
    return s.mu0 / l * (v[0] * v[0] + v[1] * v[1]) / 2;
  };
  if constexpr (std::same_as<T, Shortened>)
    return recorded_integral(f, -l / 2, l / 2);
  else
    return gauss_legendre(f, -l / 2, l / 2, 4).value;
}

Samples within(const Tolerance& allowed, Samples samples) {
  for (Sample& s : samples) s.allowed = allowed;
  return samples;
}

// ---- rough friction ---------------------------------------------------------------------------------------

/// The moment about the center of mass of rough friction of size 1 per mass, against the velocity of every
/// point, with velocities times `speed`.
Formula<Sample> friction(const std::string& by, double speed,
                         const std::function<Integral(FunctionOfOne, double end)>& rule, double factor = 1) {
  return {by, [=](const Sample& s) {
            const auto at = [&](double u) {
              const Point p = s.body(u), v = s.velocity(p), d = turned(s, p);
              const double vx = speed * v[0], vy = speed * v[1];
              return -(vx * d[0] + vy * d[1]) / hypot(vx, vy) * s.wire.density(u) * s.wire.stretch(u);
            };
            return factor * rule(at, s.wire.end()).value;
          }};
}

Formula<Sample> by_simpson(int panels) {
  return friction("Simpson's rule, " + std::to_string(panels) + " panels", 1,
                  [=](FunctionOfOne f, double end) { return simpson(f, 0, end, panels); });
}

/// Compares the moment at a multiple of the sample's velocities with `part` of that at the velocities
/// themselves.
Check friction_at_speed(const std::string& by, Samples samples, double speed, double part) {
  for (Sample& s : samples) s.allowed = rounding(s.mu0 * s.wire.q * (1 + s.wire.q));
  const auto rule = [](FunctionOfOne f, double end) { return gauss_legendre(f, 0, end, 64); };
  const std::string by_rule = ", by Gauss and Legendre";
  return compare("moment of rough friction", friction(by + by_rule, speed, rule),
                 friction(format_shortest(part) + " times that of the moving wire" + by_rule, 1, rule, part),
                 samples);
}

/// The center of mass by adaptive quadrature.
Point center_by_qag(const Wire& w) {
  const auto over = [&](const auto& of) {
    return qag([&](double u) { return of(w.point(u)) * w.density(u) * w.stretch(u); }, 0, w.end(), 1e-12)
        .value;
  };
  const double mass = over([](const Point&) { return 1; });
  return {over([](const Point& p) { return p[0]; }) / mass, over([](const Point& p) { return p[1]; }) / mass};
}

const std::string cross_term = "cross term left out", at_rest = "friction at rest";

const std::string by_angle = R"($(x,y)+L(\cos\theta,\sin\theta)$)", by_matrix = R"($(x,y)+R\,(L,0)$)";

void at_a_point(Table& table, const Samples& samples) {
  const std::string complex = "complex multiplication", by_dual = "dual numbers in the time";
  const auto claim = table.over(samples);
  const auto of_rod = []<class T>(const SampleOf<T>& s) { return s.position({s.b[0], T(0)}); };
  const Reader rod{complex, of_rod}, velocity{by_dual, [](const auto&s) { return s.velocity(s.b); }};
  claim("thin_rod", 2791,
        R"(A point of the rod, $L$ from its center, is at $(x,y)+L(\cos\theta,\sin\theta)$)", rod, by_angle);
  claim("thin_rod_matrix", 2795, R"(In matrix form the point of the rod is $(x,y)+R\,(L,0)$)", rod,
        by_matrix);
  claim("rotates_about_origin", 2823,
        R"(The matrix $R(\theta)$ rotates the body about the origin of body space)",
        {R"($e^{i\theta}b$ and $|b|$)",
         [](const auto& s) {
           const auto z = turned_by(s.theta, s.b);
           return values(z[0], z[1], hypot(s.b[0], s.b[1]));
         }},
        R"($(Rb,\ |Rb|)$)", "the point $b$ turned, and its distance from the origin",
        "a rotation keeps lengths");
  claim("position", 2827, R"(The position is $r=c+R(\theta)b$, $c$ being the center of mass)",
        {complex, [](const auto& s) { return s.position(s.b); }}, R"($c+R(\theta)b$)");
  claim("velocity", 2831, R"(The velocity is $v=\dot c+\dot\theta\frac{dR}{d\theta}b$)", velocity,
        R"($\dot c+\dot\theta\frac{dR}{d\theta}b$)");
  claim("dR_dtheta", 2847,
        R"($\frac{dR}{d\theta}$ has the rows $(-\sin\theta,-\cos\theta;\ \cos\theta,-\sin\theta)$)",
        {"dual numbers in the angle",
         []<class T>(const SampleOf<T>& s) {
           const auto C = [](const auto& angle) { return cos(angle); };
           const auto S = [](const auto& angle) { return sin(angle); };
           const auto minus_S = [](const auto& angle) { return -sin(angle); };
           return values(slope_at(s.theta, C), slope_at(s.theta, minus_S), slope_at(s.theta, S),
                         slope_at(s.theta, C));
         }},
        R"($(-\sin\theta,-\cos\theta;\ \cos\theta,-\sin\theta)$)");
  const std::string components = R"((\dot x-\dot\theta(b_0\sin\theta+b_1\cos\theta),\ \dot )"
                                 R"(y+\dot\theta(b_0\cos\theta-b_1\sin\theta))$)";
  claim("velocity_components", 2857, "$v=" + components, velocity, "$" + components);
  const std::string squares = R"(\dot x^2+\dot y^2+\dot\theta^2(b_0^2+b_1^2))",
                    cross = R"(2\dot\theta\,(\dot x,\dot y)\cdot\frac{dR}{d\theta}b$)";
  claim(
      "speed_squared", 2901, "Each point has $|v|^2=" + squares + "$",
      {.truth = {by_dual,
                 [](const auto& s) {
                   const auto v = s.velocity(s.b);
                   return v[0] * v[0] + v[1] * v[1];
                 }},
       .printed = "$" + squares + "$",
       .corrected = "$" + squares + "+" + cross,
       .root = cross_term,
       .why =
           "The cross term $" + cross +
           filled(
               R"( is missing. A wheel that rolls shows it: with $\dot x=1$, $\dot\theta=-1$ and $b=(0,-1)$ )"
               R"(at $\theta=0$ the point rests, and the formula gives @1. The term vanishes in the integral )"
               R"(alone, because $\int b\,\delta\,ds=0$; the kinetic energy that follows is right.)",
               {1 * 1 + 1 * 1})});
}

const Reader by_integral{
    R"($\int\frac12|v|^2\delta\,ds$, $v$ by dual numbers)", [](const auto& s) {
      return 0.5 * s.integrated([](const auto&, const auto& v) { return v[0] * v[0] + v[1] * v[1]; });
    }};

/// Minus the slope of the total potential energy by a generalized coordinate: 0, 1, 2 for x, y, theta.
Reader slope(int coordinate) {
  return {"minus the slope of the total potential energy, by dual numbers",
          [coordinate]<class T>(const SampleOf<T>& s) {
            const auto along = [&](int k) { return T(coordinate == k ? 1.0 : 0.0); };
            const Dual<T> X(s.x, along(0)), Y(s.y, along(1)), angle(s.theta, along(2)), C = cos(angle),
                                                                                        Z = sin(angle);
            return -s.integrated([&](const auto& p, const auto&) {
              return phi(X + C * p[0] - Z * p[1], Y + Z * p[0] + C * p[1]).slope;
            });
          }};
}

/// The integral of a component of the force.
Reader component(const std::string& text, std::size_t i) {
  return {text, [i](const auto& s) {
            return s.integrated([&](const auto& p, const auto&) { return force(s.position(p))[i]; });
          }};
}
const Reader Fx = component(R"($\int F\cdot\imath\,\delta\,ds$)", 0),
             Fy = component(R"($\int F\cdot\jmath\,\delta\,ds$)", 1);
const Reader moment_of_force{R"($F_\theta=\int F\cdot\frac{dR}{d\theta}b\,\delta\,ds$)", [](const auto& s) {
                               return s.integrated([&](const auto& p, const auto&) {
                                 const auto f = force(s.position(p)), d = turned(s, p);
                                 return f[0] * d[0] + f[1] * d[1];
                               });
                             }};
const Reader moment_of_weight{
    "the integrals of $(0,-g)$", []<class T>(const SampleOf<T>& s) {
      return values(T(0), -9.81 * s.integrated([](const auto&, const auto&) { return T(1); }),
                    -9.81 * s.integrated([&](const auto& p, const auto&) { return turned(s, p)[1]; }));
    }};

void over_the_wire(Table& table, const Samples& samples) {
  const auto claim = table.over(samples);
  const auto reoriented = [](const std::string& text, double shift) {
    return Reader{text, [shift]<class T>(const SampleOf<T>& s) {
                    return s.integrated([&](const PointOf<T>& p, const auto&) {
                      const PointOf<T> z = turned_by(s.turn, p);
                      return (z[0] + shift) * (z[0] + shift) + z[1] * z[1];
                    });
                  }};
  };
  claim("reorient_or_not", 2825, "The curve may be turned in body space, or not",
        {.quantity = R"($\mu_2$)",
         .truth = {"the curve as it is", [](const auto& s) { return s.mu2(); }},
         .printed = reoriented("turned by 1 radian", 0),
         .near_misses = {reoriented("turned by 1 radian and shifted by 0.1", 0.1)}});
  claim.equation("kinetic_energy_formula", 2905,
                 R"($T=\frac{\mu_0}2(\dot x^2+\dot y^2)+\frac{\mu_2}2\dot\theta^2$)", by_integral);
  claim("only_differences", 2923, R"($T$ is a rod's, with other $\mu_0$ and $\mu_2$)",
        {.truth = by_integral,
         .printed = {R"(a rod with the same $\mu_0$ and $\mu_2$)",
                     [](const auto& s) { return energy_of_rod(s, sqrt(12 * s.mu2() / s.mu0)); }},
         .near_misses = {{R"(a rod with the same $\mu_0$ and length)",
                          [](const auto& s) { return energy_of_rod(s, s.wire.arc_length(s.wire.end())); }}}});
}

/// Other routes are the formulas that are proved.
void forces(Claims& claims, const Samples& samples) {
  const auto claim = claims.over(samples);
  claim("force_x", 2927,
        R"($F_x=\int F\cdot\imath\,\delta\,ds$, $F$ being the force per mass (our condition))",
        {.truth = slope(0), .other_routes = {Fx}, .printed = {Fx.text}});
  claim("force_y", 2933, R"($F_y$ is $\int F\cdot\jmath\,\delta\,ds$, $F$ per mass)",
        {.truth = slope(1),
         .other_routes = {Fy},
         .printed = {R"($(\int F\cdot\imath\,\delta\,ds,\ \int F\cdot\jmath\,\delta\,ds)$)"},
         .meant = {Fy.text},
         .why = R"(The unit vector $\jmath$ after the dot is lost in the text at hand; line 2931, on $F_x$, )"
                R"(has its $\imath$. Without it the integrand is the force, a vector, and not its )"
                R"(component.)"});
  claim("force_theta", 2939, R"($F_\theta=\int F\cdot\frac{dR}{d\theta}b\,\delta\,ds$, $F$ per mass)",
        {.truth = slope(2), .other_routes = {moment_of_force}, .printed = {moment_of_force.text}});
}

// ---- proofs -----------------------------------------------------------------------------------------------

ForAll<SampleOf> any_point() {
  return for_all<SampleOf>(
      {"x", "y", "theta", "vx", "vy", "w", "b0", "b1"},
      "first [ring [(circle theta)] | apply f_equal; ring [(circle theta)] | symmetry; apply is_derive_unique; "
      "auto_derive; [trivial | ring]]",
      "it holds of any point of any wire in any motion", {0, 0, 0, 0, 1, -1, 1, 0});
}

/// For any curve with its center of mass at zero.
ForAll<SampleOf> any_curve() {
  ForAll<SampleOf> all = any_point();
  SampleOf<Shortened>& any = all.any;
  any.turn = Shortened::letter("turn");
  any.mu0 = any.integrated([](const auto&, const auto&) { return Shortened(1.0); });
  all.letters = "(b0 b1 delta : R -> R) (Ux Uy : R -> R -> R) (L x y theta vx vy w turn : R)";
  for (const char* function : {"b0", "b1", "delta"})
    all.given.push_back({"(forall s, continuous " + std::string(function) + " s)"});
  for (std::size_t i = 0; i < 2; ++i)
    all.given.push_back(any.integrated([i](const auto& p, const auto&) { return p[i]; }).expression() == 0);
  for (const Proposition& is : positive({any.mu0, any.mu2()})) all.given.push_back(is);
  const std::string by_moments = "by_moments b0 b1 delta L H H0 H1 H2 H3 theta vx vy w; ";
  all.tactic = "first [solve [apply RInt_ext; intros; in_reals; ring [(circle turn)]] | solve [" +
               by_moments + "field] | " + by_moments + "by_rod b0 b1 delta L theta vx vy w]";
  all.says = "it holds of any curve of any density";
  return all;
}

/// Recorded, the matrix and the complex product are equal, so this claim is the same as that of the line
/// before.
Provable rod_by_matrix(const ForAll<SampleOf>& all) {
  return {"3.29-thin_rod_matrix",
          "it is the point of the rod that the line before gives",
          {{"printed", all.letters, all.given,
            equal(Reader(by_matrix).recorded(all.any), Reader(by_angle).recorded(all.any)), "ring"}}};
}

/// Compares a generalized force with the slope of the potential energy, if the integral of the slope exists.
Lemma force_lemma(const std::string& reading, const Reader& force, int coordinate, ForAll<SampleOf> all) {
  const Expressions truth = slope(coordinate).recorded(all.any);
  const std::string text = truth[0].coq();
  const std::size_t begin = text.find("RInt");
  all.given.push_back({"ex_RInt" + text.substr(begin + 4, text.rfind(')') - begin - 4)});
  return {reading, all.letters, all.given, equal(force.recorded(all.any), truth),
          "by_slope b0 b1 theta x y H6"};
}

}  // namespace

Provables proofs() {
  Claims claims("3.29");
  Table points(claims), wires(claims);
  at_a_point(points, {});
  over_the_wire(wires, {});
  const ForAll<SampleOf> point = any_point(), curve = any_curve();
  Provables proved = points.proofs("3.29", point);
  append(proved, {rod_by_matrix(point)});
  append(proved, wires.proofs("3.29", curve));
  const std::string of_potential = "it is minus the slope of the energy of any curve in any potential";
  proved.push_back({"3.29-force_x", of_potential, {force_lemma("printed", Fx, 0, curve)}});
  proved.push_back({"3.29-force_y", "as meant " + of_potential, {force_lemma("meant", Fy, 1, curve)}});
  const Expression moment = moment_of_weight.recorded(curve.any)[2];
  proved.push_back({"3.29-force_theta",
                    of_potential + "; that of the weight is zero",
                    {force_lemma("printed", moment_of_force, 2, curve),
                     {"weight",
                      curve.letters,
                      curve.given,
                      {moment == 0},
                      "no_moment b0 b1 delta L H H0 H1 H2 H3 theta"}}});
  for (Provable& p : proved) p.preamble = coq_source({"curves"});
  return proved;
}

/// A rod that turns about its center, in m, kg and N per kg, and the moment of its friction, in N m.
constexpr double length_of_rod = 1, mass_of_rod = 2, friction_of_rod = 1,
                 moment_of_rod = friction_of_rod * mass_of_rod * length_of_rod / 4;

std::vector<Claim> claims(double seed) {
  const Samples samples = draw<Sample>(200, seed), thirty(samples.begin(), samples.begin() + 30);
  Claims claims("3.29");
  Table points(claims), wires(claims);
  Samples centered = samples, uniform(samples.begin(), samples.begin() + 60);
  for (Sample& s : centered) s.center = center_by_qag(s.wire);
  for (Sample& s : uniform) s.wire.k = 0, s.center = s.wire.center();
  claims.over(centered)("body_space", 2823,
                        R"(In body space the center of mass is at the origin: $\int b\,\delta\,ds=0$)",
                        {R"($\mu_0$)", [](const Sample& s) { return s.mu0; }},
                        {R"($(\mu_0+\int b_0\,\delta\,ds,\ \mu_0+\int b_1\,\delta\,ds)$)"},
                        R"($(\mu_0,\mu_0)+\int b\,\delta\,ds$, $b$ from the center of mass by QAG)",
                        "a multiple of zero is zero");
  at_a_point(points, samples);
  over_the_wire(wires, samples);
  forces(claims, samples);
  claims.over(samples)(
      "arc_length", 2825, R"(The arc length runs from 0 to the total length $\int ds$)",
      {"the primitive of $ds$", [](const Sample& s) { return s.wire.arc_length(s.wire.end()); }},
      {R"($\int ds$)"});
  claims.over(uniform)(
      "mass", 2867, R"(The total mass is $\mu_0=\int\delta\,ds$)",
      {"the primitive of the mass", [](const Sample& s) { return by_primitives(s.wire)[0]; }},
      {R"($\mu_0=\int\delta\,ds$)"}, R"($\mu_0$ of a uniform wire)");
  const std::string energy = R"($T=\int\frac12|v|^2\delta\,ds$)";
  claims.over(within({1e-4, "the midpoint rule's truncation"}, thirty))(
      "kinetic_energy", 2883, "The kinetic energy is " + energy, {"2000 particles", &Sample::of_particles},
      {energy}, {}, "a factor of one changes nothing");
  claims.over(
      within({1e-6, "the truncation of Simpson's rule where a point of the wire all but rests"}, thirty))(
      "numerical_integration", 2945,
      "Numerical integration applies to the generalized forces of rough friction (our condition: on a moving "
      "wire)",
      {.quantity = "moment of rough friction on a moving wire",
       .truth = friction("QAG", 1, [](FunctionOfOne f, double end) { return qag(f, 0, end, 1e-12); }),
       .printed = by_simpson(1 << 15),
       .near_misses = {by_simpson(2)}});
  const std::string slower = "a billion times slower";
  const Check slowly = friction_at_speed(slower, thirty, 1e-9, 1);
  claims.add(
      "friction_at_rest", 2945,
      "With rough friction too, numerical integration applies to the generalized forces",
      {.printed = {"for a wire at rest, too", {friction_at_speed("at rest", thirty, 0, 0)}},
       .corrected = {"for a wire in motion, whatever its speed; at rest the integrand is $0/0$",
                     {slowly, friction_at_speed(slower + ", the other way", thirty, -1e-9, -1)}},
       .in_view = {"for a wire in motion", {slowly}},
       .near_misses = {{"half the friction at half the speed",
                        {friction_at_speed("half as fast", thirty, 0.5, 0.5)}}},
       .why = filled(
           "Rough friction has the direction $-v/|v|$, and a wire at rest has none: every rule that "
           "evaluates the integrand returns NaN. Nor is there a limit. Friction of @1 N a kilogram acts on a "
           "rod of @1 m and @1 kg that turns about its center. The friction's moment is $-@2$ or $+@2$ N m, by "
           "the sense of the turn, however slow it is. At rest, static friction holds the rod, up to a bound; "
           "the integral does not contain it.",
           {friction_of_rod, length_of_rod, mass_of_rod, moment_of_rod, moment_of_rod}),
       .root = at_rest});
  std::vector<Claim> all = claims.in_order();
  const Reader weight{R"($(0,-\mu_0g,0)$)", [](const Sample& s) { return values(0, -9.81 * s.mu0, 0); }};
  std::ranges::find(all, "3.29-force_theta", &Claim::id)
      ->printed.checks.push_back(
          compare(R"($(F_x,F_y,F_\theta)$ of gravity)", moment_of_weight, weight, samples));
  return all;
}

std::vector<Root> roots() {
  constexpr double rolling = 1;
  return {
      {cross_term,
       filled(
           R"(The lowest point of a wheel that rolls at @1 m/s rests on the ground; by the published )"
           R"(formula it slides at $\sqrt2=@3$ times that. In a game that draws skid marks by the speed of )"
           R"(contact, every rolling wheel leaves them.)",
           {rolling, std::sqrt(rolling * rolling + rolling * rolling) / rolling})},
      {at_rest,
       filled(
           R"(A rod of @1 m and @1 kg that lies still on ground of @1 N a kilogram gets NaN for its moment )"
           R"(in the first frame. One whose turn has nearly stopped gets @2 N m to one side or the other, )"
           R"(whichever way its last rounding error turns it.)",
           {length_of_rod, mass_of_rod, friction_of_rod, moment_of_rod})}};
}

}  // namespace oddity::ex03_29
