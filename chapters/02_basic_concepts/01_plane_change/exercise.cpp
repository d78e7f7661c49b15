// Exercise 2.1: which of r, v, a, speed, T and N of r(t) = (t, t^3, 0) for t < 0, (t, 0, t^3) for t >= 0 pass
// continuously through t = 0?
// The formulas of the text are held against dual numbers, its limits against Richardson's extrapolation from
// a distance. N is T turned by a right angle in the plane of its piece (the book's (2.5)); the other route to
// it is the principal normal, along (v x a) x v [do Carmo, Differential Geometry of Curves and Surfaces,
// 1-5], which is -N before 0. A unit normal out of that plane need not jump [Bishop, Amer. Math. Monthly 82
// (1975) 246].

#include <cmath>
#include <numbers>

#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/02_basic_concepts/shared/space.hpp"
#include "chapters/claims.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex02_01 {

using namespace space;
using limits::joined, limits::limit, limits::limit_at_zero, std::numbers::sqrt2;

constexpr Parameter parameters[] = {
    {"h", 0.25, "1", "distance from $t=0$ at which a numerical limit starts", 1e-3, 0.5},
    {"seed", 1, "", "of the random times", 0, 1e9, whole_number},
};

// ---- the curve --------------------------------------------------------------------------------------------

constexpr int before = -1, after = 1;

/// (x, y, 0) in the plane of the piece before 0, (x, 0, y) in that of the piece after.
template <class T>
Vector<T> in_plane(int side, const T& x, const T& y) {
  return side < 0 ? Vector<T>{x, y, T(0.0)} : Vector<T>{x, T(0.0), y};
}
auto piece(int side) {
  return [side](const auto& t) { return in_plane(side, t, t * t * t); };
}
/// The polynomial of degree n-1 through n points of a piece.
Vector3 interpolated(int side, double t, int n) {
  Vector3 sum{};
  for (int i = 0; i < n; ++i) {
    double weight = 1;
    for (int j = 0; j < n; ++j)
      if (j != i) weight *= (t - 0.5 * j) / (0.5 * (i - j));
    sum = sum + weight * piece(side)(0.5 * i);
  }
  return sum;
}

struct Local {
  Vector3 r, v, a, T, N;
  double speed;
};
Local local(int side, double t) {
  const auto m = motion_of(piece(side), t);
  const Vector3 T = unit(m.v), N = in_plane(side, -(side < 0 ? T[1] : T[2]), T[0]);
  return {m.r, m.v, m.a, T, N, length(m.v)};
}
Value all_of(const Local& l) { return joined(l.r, l.v, l.a, l.speed, l.T, l.N); }

/// From positions alone: differences of step h, on the side of the limit or across 0.
Value from_positions(int side, double h, bool across) {
  const auto r = [&](double t) { return piece(t < 0 || (t == 0 && side < 0) ? before : after)(t); };
  const double s = side * h;
  const Vector3 near = r(s), far = across ? r(-s) : r(0), far2 = r(2 * s);
  const Vector3 v = across ? (near - far) / (2 * s) : (near - far) / s;
  const Vector3 a = across ? (near - 2.0 * r(0) + far) / (h * h) : (far2 - 2.0 * near + r(0)) / (h * h);
  const Vector3 T = unit(v), normal = unit(a - dot(a, T) * T);
  return all_of({near, v, a, T, double(side) * normal, length(v)});
}

Quantity one_sided_limits(double h) {
  const Value at_zero{0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0, 0};
  Quantity limits{
      "one_sided_limits",
      "1",
      R"($\mathbf r$, $\mathbf v$, $\mathbf a$, speed, $\mathbf T$ and $\mathbf N$ as $t\to0$ from below, )"
      R"(then from above)",
      {R"(polynomials at 0, and $\mathbf T$ turned in the plane of its piece)",
       joined(at_zero, Vector3{0, 1, 0}, at_zero, Vector3{0, 0, 1})},
      0,
      {1e-10, "ten decimals of numbers of size one"}};
  const auto both = [](auto f) { return [f](double s) { return joined(f(before, s), f(after, s)); }; };
  const auto pieces = both([](int side, double s) { return all_of(local(side, side * s)); });
  const auto one_sided = both([](int side, double s) { return from_positions(side, s, false); });
  const auto central = both([](int side, double s) { return from_positions(side, s, true); });
  const Knob halvings{"halvings", {2, 4, 6, 8, 10}};
  const std::string derivatives = "derivatives of each piece";
  const auto richardson = [=](auto f) {
    return [=](double n) { return limit_at_zero(f, h, static_cast<int>(n)); };
  };
  const Knob distances{"distance", {h, h * 0x1p-5, h * 0x1p-10, h * 0x1p-15, h * 0x1p-20}};
  limits.add({derivatives, "value at a distance", distances,
              [=](double s) {
                return Answer{pieces(s), 1};
              },
              Outcome::inaccurate, "the acceleration is still 6 distances away"});
  limits.add({derivatives, "Richardson", halvings, richardson(pieces)});
  limits.add({"differences of positions, one side", "Richardson", halvings, richardson(one_sided)});
  limits.add({"differences of positions across 0", "Richardson", halvings, richardson(central),
              Outcome::deceived, R"(they see one normal, $(0,-1,1)/\sqrt2$, at every $h$)"});
  limits.add(Breakdown{
      R"(Central differences are the better ones inside a piece. Across the joint they give )"
      R"($(0,-1,1)/\sqrt2$ for the normal, half-way between $-\mathbf N$ before and $\mathbf N$ after, )"
      R"(however small the step.)",
      "differences of positions across 0, Richardson", 10, Outcome::deceived,
      "differences of positions, one side, Richardson", 10});
  return limits;
}

// ---- the claims -------------------------------------------------------------------------------------------

struct Sample {
  double t;
  std::array<double*, 1> letters() { return {&t}; }
  std::string where() const { return "$t$ = " + format_shortest(t); }
  int side() const { return t < 0 ? before : after; }
  Local local() const { return ex02_01::local(side(), t); }
};
using OfTime = Formula<Sample>;

double root(double t) { return std::sqrt(1 + 9 * t * t * t * t); }

OfTime by_duals(Vector3 Local::*of) {
  return {"dual numbers", [=](const Sample& s) { return Value(s.local().*of); }};
}
/// (x, y, 0) or (x, 0, y).
OfTime components(std::string text, double (*x)(double t), double (*y)(double t)) {
  return {std::move(text), [=](const Sample& s) { return Value(in_plane(s.side(), x(s.t), y(s.t))); }};
}
double zero(double) { return 0; }
double one(double) { return 1; }

/// What the vector f(side, t) does as t goes to 0 from these sides, by Richardson's extrapolation.
class Limits {
 public:
  explicit Limits(double h) : h_(h) {}

  template <class F>
  Reading tends(const std::string& what, std::initializer_list<int> sides, const Vector3& to,
                const F& f) const {
    const std::string text = "$" + what + R"(\to()" + format_shortest(to[0]) + "," + format_shortest(to[1]) +
                             "," + format_shortest(to[2]) + ")$";
    Reading reading{text, {}};
    for (int side : sides)
      reading.checks.push_back(limit("$" + what + (side < 0 ? "$ from below" : "$ from above"), to, h_,
                                     [=](double s) { return f(side, side * s); }));
    return reading;
  }
  Check jump(double sign, double said) const {
    return limit(sign > 0 ? R"($|\mathbf N_+-\mathbf N_-|$)" : R"($|\mathbf N_++\mathbf N_-|$)", said, h_,
                 [=](double s) { return length(local(after, s).N - sign * local(before, -s).N); });
  }
  /// The formulas of N at t for the limits from both sides.
  Reading normal_at(double t) const {
    Reading reading{R"($\mathbf N$ at $t=)" + format_shortest(t) + "$", {}};
    for (int side : {before, after})
      reading.checks.push_back(limit(R"($\mathbf N$)", 1 / root(t) * in_plane(side, -3 * t * t, 1.0), h_,
                                     [=](double s) { return local(side, side * s).N; }));
    return reading;
  }
  template <class Normal>
  Reading right_angle(const std::string& text, const Normal& normal) const {
    return {text, {limit("cosine of the normals at $t$ and $-t$", 0, h_, [=](double s) {
              return dot(normal(s), local(before, -s).N);
            })}};
  }

 private:
  double h_;
};

void frames(Claims& claims, int side, const std::vector<Sample>& samples) {
  const auto tangent = [](double k, int power) {
    return [=](const Sample& s) {
      return Value(std::pow(root(s.t), power) * in_plane(s.side(), 1.0, k * s.t * s.t));
    };
  };
  const auto normal = [](double k, int power) {
    return [=](const Sample& s) {
      const Vector3 n = std::pow(root(s.t), power) * in_plane(s.side(), -k * s.t * s.t, 1.0);
      return joined(n, length(n), dot(n, s.local().T));
    };
  };
  const std::string range = side < 0 ? " before 0" : " from 0 on", T = side < 0 ? "(1,3t^2,0)" : "(1,0,3t^2)",
                    N = side < 0 ? "(-3t^2,1,0)" : "(-3t^2,0,1)", by_root = R"(\sqrt{1+9t^4})";
  const auto is = [](const std::string& what, const std::string& value) {
    return "$" + what + "=" + value + "$";
  };
  const std::string why =
      R"(The bar above the root is lost in the text at hand: the root divides. As it stands the vector is )"
      R"(multiplied by it, and at $t=\pm1$ its length is 10, not 1.)";
  claims.formula(side < 0 ? "tangent_before" : "tangent_after", side < 0 ? 135 : 161,
                 is(R"(\mathbf T)", T + R"(\,)" + by_root) + range, samples,
                 {.quantity = R"($\mathbf T$)",
                  .truth = {R"($\mathbf v/|\mathbf v|$ by dual numbers)", by_duals(&Local::T).of},
                  .printed = {"$" + T + R"(\,)" + by_root + "$", tangent(3, 1)},
                  .meant = {"$" + T + "/" + by_root + "$", tangent(3, -1)},
                  .near_misses = {{R"(the quotient with $-3t^2$)", tangent(-3, -1)}},
                  .kind = Fault::lost_typography,
                  .why = why});
  claims.formula(
      side < 0 ? "normal_before" : "normal_after", side < 0 ? 141 : 167,
      is(R"(\mathbf N)", N + R"(\,)" + by_root) + " is a unit normal" + range, samples,
      {.quantity = R"($\mathbf N$, $|\mathbf N|$ and $\mathbf N\cdot\mathbf T$)",
       .truth = {std::string(side < 0 ? "minus " : "") + "the principal normal by dual numbers, 1 and 0",
                 [](const Sample& s) {
                   const Local l = s.local();
                   return joined(double(s.side()) * unit(cross(cross(l.v, l.a), l.v)), 1, 0);
                 }},
       .printed = {"$" + N + R"(\,)" + by_root + "$", normal(3, 1)},
       .meant = {"$" + N + "/" + by_root + "$", normal(3, -1)},
       .near_misses = {{R"(the quotient with $+3t^2$)", normal(-3, -1)}},
       .kind = Fault::lost_typography,
       .why = why});
}

std::vector<Claim> claims(double h, double seed) {
  Random random(seed);
  std::vector<Sample> left{{-0.75}}, right{{0.75}};
  for (int i = 0; i < 200; ++i) {
    const Sample s{random.magnitude(1e-3, 1e2)};
    (s.t < 0 ? left : right).push_back(s);
  }
  std::vector<Sample> all = left;
  all.insert(all.end(), right.begin(), right.end());
  const Limits limits(h);
  const auto of = [](Vector3 Local::*vector) {
    return [=](int side, double t) { return local(side, t).*vector; };
  };
  const auto r = of(&Local::r), v = of(&Local::v), a = of(&Local::a), N = of(&Local::N);
  const Vector3 none{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const std::string R = R"(\mathbf r)", V = R"(\mathbf v)", A = R"(\mathbf a)", normal = R"(\mathbf N)";
  Claims claims("2.1");

  const auto with_limit = [&](const std::string& what, const OfTime& formula, const OfTime& truth,
                              Reading at_0) {
    at_0.text = formula.text;
    at_0.checks.insert(at_0.checks.begin(), compare(what, formula, truth, all));
    return at_0;
  };
  const auto near = [&](const std::string& what, const OfTime& formula, const OfTime& truth) {
    return Reading{formula.text, {compare(what, formula, truth, all)}};
  };
  const OfTime velocity = by_duals(&Local::v), acceleration = by_duals(&Local::a);
  claims.add("velocity", 69, R"($\mathbf v=(1,3t^2,0)$ before 0 and $(1,0,3t^2)$ from 0 on)",
             {.printed = with_limit("$" + V + "$",
                                    components("these, and 1 along $x$ at 0 from both sides", one,
                                               [](double t) { return 3 * t * t; }),
                                    velocity,
                                    limits.tends(R"((\mathbf r(t)-\mathbf r(0))/t)", {before, after}, x,
                                                 [=](int side, double t) { return r(side, t) / t; })),
              .near_misses = {near(
                  "$" + V + "$", components(R"($2t^2$ for $3t^2$)", one, [](double t) { return 2 * t * t; }),
                  velocity)}});
  claims.add("acceleration", 77, R"($\mathbf a=(0,6t,0)$ before 0 and $(0,0,6t)$ from 0 on)",
             {.printed = with_limit(
                  "$" + A + "$",
                  components("these, and 0 at 0 from both sides", zero, [](double t) { return 6 * t; }),
                  acceleration,
                  limits.tends(R"((\mathbf v(t)-\mathbf v(0))/t)", {before, after}, none,
                               [=](int side, double t) { return (v(side, t) - x) / t; })),
              .near_misses = {near("$" + A + "$",
                                   components(R"($3t$ for $6t$)", zero, [](double t) { return 3 * t; }),
                                   acceleration)}});
  claims.add("position_from_below", 87, R"($\mathbf r$ tends to 0 from below)",
             {.printed = limits.tends(R, {before}, none, r),
              .near_misses = {limits.tends(R, {before}, 1e-6 * y, r)}});
  const auto through = [](std::string text, int points) {
    return OfTime{std::move(text),
                  [=](const Sample& s) { return Value(interpolated(s.side(), s.t, points)); },
                  [](const Sample& s) { return 10 * (1 + std::abs(s.t * s.t * s.t)); }};
  };
  claims.formula("polynomials", 103, "the components are polynomials (of degree 3), hence continuous", all,
                 {.quantity = R"($\mathbf r$)",
                  .truth = {"the curve", [](const Sample& s) { return Value(piece(s.side())(s.t)); }},
                  .printed = through("the cubic through four of its points", 4),
                  .near_misses = {through("the parabola through three of its points", 3)}});
  claims.add(
      "position_from_above", 105, R"($\mathbf r$ tends to 0 from above)",
      {.printed = limits.tends(R, {after}, none, r), .near_misses = {limits.tends(R, {after}, 1e-6 * z, r)}});
  claims.add("velocity_limit", 121, R"($\mathbf v$ tends to $(1,0,0)$ from both sides)",
             {.printed = limits.tends(V, {before, after}, x, v),
              .near_misses = {limits.tends(V, {before, after}, x + y, v)}});
  claims.add("acceleration_limit", 121, R"($\mathbf a$ tends to 0 from both sides)",
             {.printed = limits.tends(A, {before, after}, none, a),
              .near_misses = {limits.tends(A, {before, after}, 6.0 * y, a)}});
  const auto speed = [](double k) {
    return [=](const Sample& s) { return std::sqrt(1 + k * std::pow(s.t, 4)); };
  };
  claims.formula("speed", 123, R"(the speed is $\sqrt{1+9t^4}$ on both sides)", all,
                 {.quantity = R"($|\mathbf v|$)",
                  .truth = {"dual numbers", [](const Sample& s) { return s.local().speed; }},
                  .printed = {R"($\sqrt{1+9t^4}$)", speed(9)},
                  .near_misses = {{R"($\sqrt{1+3t^4}$)", speed(3)}}});
  frames(claims, before, left);
  claims.add("normal_from_below", 147, R"($\mathbf N$ tends to $(0,1,0)$ from below)",
             {.printed = limits.tends(normal, {before}, y, N),
              .near_misses = {limits.tends(normal, {before}, z, N), limits.tends(normal, {before}, -y, N)}});
  claims.add("normal_by_evaluation", 155, R"(the limits of $\mathbf N$ are its formulas' values at 0)",
             {.printed = limits.normal_at(0), .near_misses = {limits.normal_at(1e-3)}});
  frames(claims, after, right);
  claims.add("normal_from_above", 173, R"($\mathbf N$ tends to $(0,0,1)$ from above)",
             {.printed = limits.tends(normal, {after}, z, N),
              .near_misses = {limits.tends(normal, {after}, y, N), limits.tends(normal, {after}, -z, N)}});
  claims.add("no_sign_helps", 181,
             R"(the two limits of $\mathbf N$ differ, and so do they with one sign changed)",
             {.printed = {R"(both jumps are $\sqrt2$)", {limits.jump(1, sqrt2), limits.jump(-1, sqrt2)}},
              .near_misses = {{"the limits are equal", {limits.jump(1, 0)}},
                              {"they are opposite", {limits.jump(-1, 0)}}}});
  claims.add(
      "no_continuous_normal", 181, "no function for the curve's normal is continuous at 0",
      {.printed =
           limits.right_angle("the normal in the curve's own plane, of either sign: a right angle remains",
                              [=](double t) { return N(after, t); }),
       .near_misses = {limits.right_angle(
           R"(every unit vector perpendicular to $\mathbf T$: but $(0,1,0)$ continues $\mathbf N$ for $t\ge0$)",
           [=](double) { return y; })}});
  return claims.in_order();
}

}  // namespace ex02_01

Exercise exercise_2_1() {
  using namespace ex02_01;
  return {"Curve that changes its plane",
          R"(The curve $\mathbf r(t)=(t,t^3,0)$ for $t<0$, $(t,0,t^3)$ for $t\ge0$: show that position, )"
          R"(velocity and acceleration are continuous at $t=0$, and that the normal $\mathbf N$ is not.)",
          parameters,
          {},
          [](const Parameters& p, const Reference&) {
            return Findings{claims(p["h"], p["seed"]), {one_sided_limits(p["h"])}};
          }};
}

}  // namespace oddity
