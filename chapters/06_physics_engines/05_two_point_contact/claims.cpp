#include "chapters/claims.hpp"

#include <Eigen/Geometry>

#include "chapters/06_physics_engines/05_two_point_contact/two_point_contact.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/quadrature.hpp"

namespace Eigen {

template <>
struct NumTraits<oddity::Shortened> : GenericNumTraits<oddity::Shortened> {
  enum { RequireInitialization = 1 };
};

}  // namespace Eigen

/// The displayed lines of the two-point contact, and the book's conclusions from them, on random bodies.
namespace oddity::ex06_05 {

namespace {

Vector3d vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Uniformly distributed rotation, from a random unit quaternion.
Matrix3d random_rotation(Random& random) {
  Eigen::Vector4d q;
  for (int i = 4; i-- > 0;) q[i] = random.normal();
  q.normalize();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

/// A box of constant density at a random position and orientation.
Body random_box(Random& random) {
  const double mass = random.between(0.5, 2);
  const Matrix3d r = random_rotation(random);
  const double c = random.between(0.5, 2), b = random.between(0.5, 2), a = random.between(0.5, 2);
  const Matrix3d own = box_inertia(mass, a, b, c);
  return {mass, r * own * r.transpose(), vector(random.point()), vector(random.point()),
          vector(random.point())};
}

/// Eight unequal masses: a body of very uneven density.
Body random_masses(Random& random) {
  std::array<Vector3d, 8> at;
  std::array<double, 8> masses;
  Body body{0, Matrix3d::Zero(), Vector3d::Zero(), vector(random.point()), vector(random.point())};
  for (std::size_t i = 0; i < 8; ++i) {
    at[i] = vector(random.point(2));
    masses[i] = random.between(0.02, 0.5);
    body.mass += masses[i];
    body.center += masses[i] * at[i];
  }
  body.center /= body.mass;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vector3d r = at[i] - body.center;
    body.inertia += masses[i] * (r.dot(r) * Matrix3d::Identity() - r * r.transpose());
  }
  return body;
}

struct Sample {
  Body body;
  Contact hit;
  Vector3d normal;
  double f;

  Vector3d arm(const Vector3d& p) const { return p - body.center; }
  /// Change of v by the impulse, and bounds for that of w.
  double kick() const { return std::abs(f) / body.mass; }
  double twist() const { return yielding() * angular_impulse(); }
  double angular_impulse() const { return std::abs(f) * std::max(arm(hit.p0).norm(), arm(hit.p1).norm()); }
  /// Size of J^-1.
  double yielding() const { return inverse(body.inertia).cwiseAbs().sum(); }

  std::vector<double*> letters() {
    std::vector<double*> all{&body.mass, &f};
    for (Vector3d* x : {&body.center, &body.v, &body.w, &hit.p0, &hit.p1, &normal})
      for (int i = 0; i < 3; ++i) all.push_back(&(*x)[i]);
    for (int i = 0; i < 9; ++i) all.push_back(&body.inertia(i / 3, i % 3));
    return all;
  }
  TypesetLetters typeset() const {
    const Matrix3d yields = inverse(body.inertia);
    std::vector<double> rows;
    for (int i = 0; i < 9; ++i) rows.push_back(yields(i / 3, i % 3));
    return {{"v^-", body.v},
            {"w^-", body.w},
            {"m", body.mass},
            {"f", f},
            {"N", normal},
            {"J^{-1}", rows},
            {"r(P_0)", arm(hit.p0)},
            {"r(P_1)", arm(hit.p1)},
            {"r(M)", arm((hit.p0 + hit.p1) / 2)}};
  }
  std::string where() const { return "$f$ = " + format_significant(f, 6); }
};

/// Bound of the coordinates of the points of contact.
constexpr double reach = 2;

std::vector<Sample> samples(double seed, int count, Body (*make_body)(Random&)) {
  Random random(seed);
  std::vector<Sample> all;
  for (int n = 0; n < count; ++n) {
    const Body body = make_body(random);
    const Vector3d normal = vector(random.direction());
    const double f = random.magnitude(0.1, 3);
    all.push_back({body, {vector(random.point(reach)), vector(random.point(reach)), f * normal}, normal, f});
  }
  return all;
}

/// A sample's quantities as letters, with the inverse of the inertia.
using LetterVector = Eigen::Matrix<Shortened, 3, 1>;
using LetterMatrix = Eigen::Matrix<Shortened, 3, 3>;
struct Lettered {
  struct {
    Shortened mass;
    LetterMatrix inertia;
    LetterVector center, v, w;
  } body;
  struct {
    LetterVector p0, p1;
  } hit;
  LetterVector normal;
  Shortened f;

  LetterVector arm(const LetterVector& p) const { return p - body.center; }
  TypesetIn<Shortened> typeset() const {
    const auto all = [](const auto& x) {
      ShortenedValue value = std::initializer_list<Shortened>{};
      for (int i = 0; i < x.size(); ++i) value.all.push_back(x(i / x.cols(), i % x.cols()));
      return value;
    };
    return {{"v^-", all(body.v)},
            {"w^-", all(body.w)},
            {"m", body.mass},
            {"f", f},
            {"N", all(normal)},
            {"J^{-1}", all(body.inertia)},
            {"r(P_0)", all(arm(hit.p0))},
            {"r(P_1)", all(arm(hit.p1))},
            {"r(M)", all(arm((hit.p0 + hit.p1) / 2.0))}};
  }
};
using ex06_05::turned;
LetterVector turned(const LetterMatrix& inverse_inertia, const LetterVector& momentum) {
  LetterVector w;
  for (int i = 0; i < 3; ++i)
    w[i] = inverse_inertia(i, 0) * momentum[0] + inverse_inertia(i, 1) * momentum[1] +
           inverse_inertia(i, 2) * momentum[2];
  return w;
}
template <class S>
using VectorOf = std::remove_cvref_t<decltype(S::normal)>;

template <class V>
V product(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// r x fN.
template <class S>
VectorOf<S> torque(const S& s, const VectorOf<S>& arm, const VectorOf<S>& normal) {
  return product(arm, VectorOf<S>(s.f * normal));
}

Formula<Sample> formula(std::string text, const std::function<Vector3d(const Sample&)>& of) {
  return {std::move(text), [=](const Sample& s) { return Value(of(s)); }};
}

// ---- the delta function -----------------------------------------------------------------------------------

constexpr double width = 1e-3;

/// The mean of g over a cube of half side `width` about p, by Gauss-Legendre: an approximate delta function.
template <class G>
double near_point(const G& g, const Vector3d& p) {
  const Rule rule = [](FunctionOfOne f, double a, double b) { return gauss_legendre(f, a, b, 2); };
  const auto low = [](double y) { return [y](double) { return y - width; }; };
  const auto high = [](double y) { return [y](double) { return y + width; }; };
  const double volume = 8 * width * width * width;
  const auto integral = nested(
      rule, [&](double x, double y, double z) { return g(Vector3d(x, y, z)); }, p[0] - width, p[0] + width,
      low(p[1]), high(p[1]), [&](double, double) { return p[2] - width; },
      [&](double, double) { return p[2] + width; });
  return integral.value / volume;
}

/// The mean over a cube of any half side h.
template <class G>
Shortened near_point(const G& g, const LetterVector& p) {
  const Expression h = Expression::letter("h");
  const auto over = [&](int i, const Expression& inner, const char* name) {
    return integral([&](const Expression&) { return inner; }, p[i].expression() - h, p[i].expression() + h,
                    name);
  };
  const LetterVector x(Shortened::letter("x"), Shortened::letter("y"), Shortened::letter("z"));
  return over(0, over(1, over(2, Shortened(g(x)).expression(), "z"), "y"), "x") / (8.0 * h * h * h);
}

/// The integral of g times `weight` delta functions at each point.
template <class G, class Hit>
auto sifted(const G& g, const Hit& hit, double weight) {
  return weight * near_point(g, hit.p0) + weight * near_point(g, hit.p1);
}

double smooth(const Vector3d& x) { return std::exp(0.5 * x[0]) * std::cos(x[1]) + x[2] * x[2] * x[0]; }
double size_of_smooth(const Vector3d& x) { return std::exp(0.5 * x[0]) + x[2] * x[2] * std::abs(x[0]); }
/// A bound of its Laplacian, -3/4 exp(x/2) cos y + 2x, within reach.
double curving() { return 0.75 * std::exp(0.5 * reach) + 2 * reach; }

Reading property(const std::string& text, const std::vector<Sample>& all, bool at_midpoint) {
  WorstSample worst(R"($\int G(X)\,\delta(X,S)\,dX$)", "narrow cubes about both points, weight 0.5 each",
                    at_midpoint ? "$G(M)$" : R"($\frac12(G(P_0)+G(P_1))$)");
  for (const Sample& s : all) {
    const double mean =
        at_midpoint ? smooth((s.hit.p0 + s.hit.p1) / 2) : (smooth(s.hit.p0) + smooth(s.hit.p1)) / 2;
    worst.add(
        sifted(smooth, s.hit, 0.5), mean,
        {width * width / 6 * curving(),
         filled("the cube's half side squared times a sixth of $G$'s Laplacian, at most @2", {curving()})},
        std::max(size_of_smooth(s.hit.p0), size_of_smooth(s.hit.p1)),
        "$P_0$ = (" + format_significant(s.hit.p0[0], 4) + ", ...)");
  }
  return {text, {worst.check()}};
}

// ---- the velocities ---------------------------------------------------------------------------------------

constexpr double pulse = 1e-6;

/// v (from 0) or w (from 3) after a pulse shared by the two points, which move with the body.
Vector3d by_motion(const Sample& s, std::size_t from, double first) {
  Contact hit = s.hit;
  hit.first = first;
  const auto after = after_pulse(s.body, hit, pulse).value;
  return {after[from], after[from + 1], after[from + 2]};
}

/// Error of the pulse's integral by 128 steps, from the first term of Simpson's error at the half steps. At
/// its ends 630 t^4 (1 - t)^4 has the fifth derivatives -+302400.
constexpr double steps_leave = 604800 / 1512.0 * 0x1p-48;
constexpr double rounded_ends = 64 * 0x1p-52 / width;
constexpr double roundings = 16;

/// A pulse does not rotate v: the error is that of its integral, and the rounded bounds of the narrow cubes.
Tolerance of_v(const Sample& s) {
  return {
      (steps_leave + rounded_ends) * s.kick() + roundings * 0x1p-52 * s.body.v.norm(),
      filled("$@2$ of the impulse by the steps of the pulse, $@2$ by the rounded ends of the cubes, and @2 "
             "roundings of $v^-$",
             {steps_leave, rounded_ends, roundings})};
}

/// During the pulse the body turns at most by the pulse's length times |w| plus the impulse's change of it.
/// Arms and inertia turn with the body.
Tolerance of_w(const Sample& s) {
  const double turn = pulse * (s.body.w.norm() + s.twist());
  const double momentum = (s.body.inertia * s.body.w).norm() + s.angular_impulse();
  return {
      2 * turn * s.yielding() * momentum + (steps_leave + rounded_ends) * s.twist() +
          roundings * 0x1p-52 * s.body.w.norm(),
      filled("in a pulse of $@1$ s the body, its arms and its inertia turn by no more than that times $|w|$ "
             "and its change, plus the error allowed for $v^+$",
             {pulse})};
}

/// Rounding of the means over narrow cubes.
Tolerance of_mean(const Sample& s) { return rounding((s.body.v.norm() + 2 * s.kick()) / width, 16); }

/// A sample whose formulas may differ by more than roundings.
struct Judged : Sample {
  Tolerance (*allowed)(const Sample&);
  Tolerance tolerance(double) const { return allowed(*this); }
};
std::vector<Judged> judged(const std::vector<Sample>& all, Tolerance (*allowed)(const Sample&)) {
  std::vector<Judged> same;
  for (const Sample& s : all) same.push_back({s, allowed});
  return same;
}
/// v+ (from 0) or w+ (from 3).
Formula<Judged> motion(std::size_t from) {
  return {"motion under half the pulse at either point",
          [=](const Judged& s) { return Value(by_motion(s, from, 0.5)); }};
}

/// The velocities after the impulse, as printed.
const std::string by_sum = R"($v^-+\frac1m\frac{fN+fN}2$)", by_impulse = "$v^-+fN/m$",
                  by_torques = R"($w^-+\frac12J^{-1}(r(P_0)\times fN+r(P_1)\times fN)$)",
                  by_mean_arm = R"($w^-+J^{-1}(\frac{r(P_0)+r(P_1)}2\times fN)$)",
                  by_midpoint = R"($w^-+J^{-1}(r(M)\times fN)$)";

/// The double integral of the first line, with narrow delta functions.
template <class S>
VectorOf<S> linear_integral(const S& s, double weight) {
  VectorOf<S> v = s.body.v;
  for (int k = 0; k < 3; ++k)
    v[k] += sifted([&](const VectorOf<S>&) { return s.f * s.normal[k]; }, s.hit, weight) / s.body.mass;
  return v;
}

template <class S>
VectorOf<S> angular_integral(const S& s, double weight) {
  VectorOf<S> momentum;
  for (int k = 0; k < 3; ++k)
    momentum[k] =
        sifted([&](const VectorOf<S>& x) { return torque(s, s.arm(x), s.normal)[k]; }, s.hit, weight);
  return s.body.w + turned(s.body.inertia, momentum);
}

/// w+ by half the torques at the two points.
constexpr auto mean_torque = []<class S>(const S& s) -> VectorOf<S> {
  const VectorOf<S> both = torque(s, s.arm(s.hit.p0), s.normal) + torque(s, s.arm(s.hit.p1), s.normal);
  return s.body.w + turned(s.body.inertia, VectorOf<S>(0.5 * both));
};

/// w+ by a single impulse at this arm.
template <class S>
VectorOf<S> at(const S& s, const VectorOf<S>& arm) {
  return s.body.w + turned(s.body.inertia, torque(s, arm, s.normal));
}
void velocities(Claims& claims, const std::vector<Sample>& all) {
  const std::string v = R"($v^-+\frac1m\int fN\,\delta\,dX$ over two narrow delta functions, their )",
                    w = R"($w^-+J^{-1}\int r\times fN\,\delta\,dX$ over two narrow delta functions, their )";
  const auto linear_of = [&](double weight) -> Formula<Judged> {
    return {v + (weight == 1 ? "sum" : "mean"),
            [=](const Judged& s) { return Value(linear_integral<Sample>(s, weight)); }};
  };
  const auto angular_of = [&](double weight) -> Formula<Judged> {
    return {w + (weight == 1 ? "sum" : "mean"),
            [=](const Judged& s) { return Value(angular_integral<Sample>(s, weight)); }};
  };
  const auto pushed = judged(all, of_v), spun = judged(all, of_w);
  claims.formula<Judged>(
      "linear_integral", 3753, R"($v^+=v^-+\frac1m\int\int fN\,\delta(t-t_0)\,\delta(X,S)\,dt\,dX$)", pushed,
      {.quantity = "$v^+$", .truth = motion(0), .printed = linear_of(0.5), .near_misses = {linear_of(1)}});
  claims.formula<Judged>("linear_mean", 3757,
                         R"($v^+=v^-+\frac1m\frac{fN+fN}2$, the integral being the mean of the two impulses)",
                         judged(all, of_mean),
                         {.quantity = "$v^+$", .truth = linear_of(0.5), .printed = {by_sum}});
  claims.formula<Judged>("linear_result", 3761, "$v^+=v^-+fN/m$", pushed,
                         {.quantity = "$v^+$", .truth = motion(0), .printed = {by_impulse}});
  claims.formula<Judged>(
      "angular_integral", 3767,
      R"($w^+=w^-+J^{-1}\int\int r(X,t)\times fN\,\delta(t-t_0)\,\delta(X,S)\,dt\,dX$)", spun,
      {.quantity = "$w^+$", .truth = motion(3), .printed = angular_of(0.5), .near_misses = {angular_of(1)}});
  claims.formula<Judged>("angular_mean", 3771, "$w^+=" + by_torques.substr(1), spun,
                         {.quantity = "$w^+$",
                          .truth = motion(3),
                          .printed = {by_torques},
                          .changes_that_hold = "a factor of one may be left out"});
  const Formula<Sample> truth{"the mean of the two torques",
                              [](const Sample& s) { return Value(mean_torque(s)); }};
  claims.formula<Sample>("angular_mean_arm", 3777, R"($w^+=w^-+J^{-1}(\frac{r(P_0)+r(P_1)}2\times fN)$)", all,
                         {.quantity = "$w^+$", .truth = truth, .printed = {by_mean_arm}});
  claims.formula<Sample>("angular_midpoint", 3783,
                         R"($w^+=w^-+J^{-1}(r(M)\times fN)$ with the midpoint $M=(P_0+P_1)/2$)", all,
                         {.quantity = "$w^+$",
                          .truth = truth,
                          .printed = {by_midpoint},
                          .near_misses = {{"the motion with three quarters of the pulse at $P_0$",
                                           [](const Sample& s) { return Value(by_motion(s, 3, 0.75)); }}}});
}

// ---- segments, faces and densities ------------------------------------------------------------------------

double over_unit(FunctionOfOne g) { return gauss_legendre(g, 0, 1, 4).value; }

/// w+ for the impulse spread along P0 P1 with density 1 + slope (2u - 1) at the fraction u.
template <class S, class Integral>
VectorOf<S> along_segment(const S& s, double slope, const Integral& over_unit) {
  VectorOf<S> momentum;
  for (int k = 0; k < 3; ++k)
    momentum[k] = over_unit([&](const auto& u) {
      const VectorOf<S> x = (1 - u) * s.hit.p0 + u * s.hit.p1;
      return (1 + slope * (2 * u - 1)) * torque(s, s.arm(x), s.normal)[k];
    });
  return s.body.w + turned(s.body.inertia, momentum);
}

Check as_segment(const std::vector<Sample>& all, const std::string& bodies, double slope) {
  return compare("$w^+$ of " + bodies, formula("half the impulse at either point", mean_torque),
                 formula(slope == 0 ? "an even impulse along the segment" : "one that grows along it",
                         [=](const Sample& s) { return along_segment(s, slope, over_unit); }),
                 all);
}

/// A plane quadrilateral at P0, P1 with the sides a, b there: P0, P1, P1 + b, P0 + a.
template <class S>
struct Quadrilateral {
  using V = VectorOf<S>;
  V p0, p1, a, b;

  template <class T>
  V point(const T& u, const T& v) const {
    return p0 + u * (p1 - p0) + v * ((1 - u) * a + u * b);
  }
  /// The area element per du dv, as a vector.
  template <class T>
  V element(const T& u, const T& v) const {
    return product(V(p1 - p0 + v * (b - a)), V((1 - u) * a + u * b));
  }
};
/// The side opposite to P0 P1 is parallel to it and `ratio` times as long; 0 gives a triangle.
template <class S, class T>
Quadrilateral<S> trapezoid_of(const S& s, const VectorOf<S>& a, const T& ratio) {
  return {s.hit.p0, s.hit.p1, a, a + (ratio - 1) * (s.hit.p1 - s.hit.p0)};
}

/// w+ for the impulse spread evenly over `area`.
Vector3d over_area(const Sample& s, const Quadrilateral<Sample>& area) {
  const Rule rule = [](FunctionOfOne f, double low, double high) { return gauss_legendre(f, low, high, 4); };
  const auto integral = [&](const auto& g) {
    const auto element = [&](double u, double v) { return g(area.point(u, v)) * area.element(u, v).norm(); };
    return nested(
               rule, element, 0, 1, [](double) { return 0.0; }, [](double) { return 1.0; })
        .value;
  };
  Vector3d momentum;
  for (long k = 0; k < 3; ++k)
    momentum[k] = integral([&](const Vector3d& x) { return torque(s, s.arm(x), s.normal)[k]; });
  return s.body.w + turned(s.body.inertia, momentum / integral([](const Vector3d&) { return 1.0; }));
}

/// w+ by equal impulses at the corners.
template <class S>
VectorOf<S> at_corners(const S& s, const VectorOf<S>& a, double ratio) {
  const VectorOf<S> e = s.hit.p1 - s.hit.p0, third = s.hit.p0 + a, fourth = third + ratio * e;
  const VectorOf<S> three = (s.hit.p0 + s.hit.p1 + third) / 3.0,
                    four = (s.hit.p0 + s.hit.p1 + third + fourth) / 4.0;
  return at(s, s.arm(ratio == 0 ? three : four));
}

/// Compares equal impulses at the corners with an even impulse over the area.
Check as_area(const std::vector<Sample>& all, const std::string& shape, double ratio) {
  const auto side = [](const Sample& s) {
    const Vector3d e = s.hit.p1 - s.hit.p0;
    return Vector3d(Vector3d(e[1], e[2], e[0]) + 0.5 * e);
  };
  const auto corners = [=](const Sample& s) { return at_corners(s, side(s), ratio); };
  const auto even = [=](const Sample& s) { return over_area(s, trapezoid_of(s, side(s), ratio)); };
  return compare("$w^+$, " + shape, formula("equal impulses at the corners", corners),
                 formula("spread evenly over the area", even), all);
}

void what_follows(Claims& claims, double seed) {
  // For a trapezoid with the parallel sides 2 and 1, over its height.
  const double mean = (0 + 0 + 1 + 1) / 4.0, centroid = over_unit([](double v) { return v * (2 - v); }) /
                                                        over_unit([](double v) { return 2 - v; });
  const auto boxes = samples(seed, 40, random_box);
  auto bodies = samples(seed, 40, random_masses);  // bodies of any density, including constant
  bodies.insert(bodies.begin(), boxes.begin(), boxes.end());
  const std::string of_any = "boxes and unequal masses";
  const Check segment = as_segment(bodies, of_any, 0), triangles = as_area(boxes, "triangles", 0),
              parallelograms = as_area(boxes, "parallelograms", 1);
  claims.add(
      "segment", 3785,
      "two points give exactly the result of the line segment (our reading, as that is not in the solutions: "
      "evenly pressed)",
      {.printed = {"even pressure", {segment}},
       .near_misses = {{"pressure growing by half along the segment", {as_segment(bodies, of_any, 0.2)}}}});
  claims.add(
      "finite_set", 3785,
      "the assumption of only finitely many contact points is no approximation, at least for bodies of "
      "constant density (our reading: equal impulses at the contact's corners replace an even one)",
      {.printed = {"for any contact: segments, triangles, parallelograms and trapezoids",
                   {segment, triangles, parallelograms, as_area(boxes, R"(trapezoids, $1:\frac12$)", 0.5)}},
       .corrected = {"for segments, and where the corners' mean is the area's centroid: triangles, "
                     "parallelograms",
                     {segment, triangles, parallelograms}},
       .near_misses = {{"trapezoids alone, $1:0.9$", {as_area(boxes, "trapezoids, $1:0.9$", 0.9)}}},
       .why = filled(
           "Two points do replace an evenly pressed segment, whatever the body's density. It does not follow that "
           "corners replace a face. "
           "The mean of a trapezoid's corners is not its centroid: with parallel sides 2 and 1 it lies at "
           "@1 of the height, and the centroid at @3. The torque about the long side is then @3 times the right "
           "one. Corners weighted by area (a third of each triangle's share) give the face's result "
           "exactly.",
           {mean, centroid, mean / centroid}),
       .kind = Fault::counterexample,
       .root = "corners for a face"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const auto all = samples(seed, 40, random_masses);
  Claims claims("6.5");
  claims.add("delta", 3743,
             R"($\int G(X)\,\delta(X,S)\,dX=\frac12(G(P_0)+G(P_1))$ for the average of two delta functions)",
             {.printed = property(R"(the mean, $\frac12(G(P_0)+G(P_1))$)", all, false),
              .near_misses = {property("$G(M)$, $M$ the midpoint", all, true)}});
  velocities(claims, all);
  what_follows(claims, seed);
  return claims.in_order();
}

std::vector<Root> roots(const Parameters& p, const Quantity& patch) {
  return {
      {"corners for a face",
       filled(
           R"(A box of $@3\times@3\times@3$ m and @3 kg, hit from below with @3 N s spread evenly over a )"
           R"(trapezoid, starts tipping over its long side at @2 rad/s. Equal impulses at the four corners )"
           "do not tip it over that side at all.",
           {p["a"], p["b"], p["c"], p["m"], p["f"], std::abs(patch.reference.value[0])})}};
}

}  // namespace oddity::ex06_05

// ---- proofs -----------------------------------------------------------------------------------------------

namespace oddity::ex06_05 {

namespace {

constexpr const char* means_in_coq = R"(
Lemma over_line (h k l p : R) : RInt (fun y => k + y * l) (p - h) (p + h) = 2 * h * (k + p * l).
Proof.
  rewrite (RInt_by (fun y => k * y + y * y * l / 2));
    [match goal with |- ?x = ?y => change (@eq R x y) end; field
    | intros; auto_derive; [exact I | field] | intros; apply @ex_derive_continuous; auto_derive; exact I].
Qed.
(* of what is linear in the coordinates *)
Lemma over_cube (g : R -> R -> R -> R) h p q r :
  (forall x y z, g x y z
    = g 0 0 0 + x * (g 1 0 0 - g 0 0 0) + y * (g 0 1 0 - g 0 0 0) + z * (g 0 0 1 - g 0 0 0)) ->
  RInt (fun x => RInt (fun y => RInt (fun z => g x y z) (r - h) (r + h)) (q - h) (q + h)) (p - h) (p + h)
  = 8 * h * h * h * g p q r.
Proof.
  intros e. set (k := g 0 0 0) in *. set (a := g 1 0 0 - k) in *. set (b := g 0 1 0 - k) in *.
  set (c := g 0 0 1 - k) in *. rewrite e.
  rewrite (RInt_ext _ (fun x => 4 * h * h * (k + q * b + r * c) + x * (4 * h * h * a))).
  - rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
  - intros x _. rewrite (RInt_ext _ (fun y => 2 * h * (k + x * a + r * c) + y * (2 * h * b))).
    + rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
    + intros y _. rewrite (RInt_ext _ (fun z => (k + x * a + y * b) + z * c)) by (intros z _; apply e).
      rewrite over_line. match goal with |- ?x = ?y => change (@eq R x y) end. ring.
Qed.
Lemma on_segment (g : R -> R) : (forall u, g u = g 0 + u * (g 1 - g 0)) -> RInt g 0 1 = (g 0 + g 1) / 2.
Proof.
  intros e. rewrite (RInt_ext _ (fun u => g 0 + u * (g 1 - g 0))) by (intros u _; apply e).
  rewrite (RInt_by (fun u => g 0 * u + u * u * (g 1 - g 0) / 2));
    [match goal with |- ?x = ?y => change (@eq R x y) end; field
    | intros; auto_derive; [exact I | field] | intros; apply @ex_derive_continuous; auto_derive; exact I].
Qed.
(* of a force that rises and falls *)
Lemma of_pulse (g : R -> R) c : (forall t, g t = 630 * (t ^ 4 * (1 - t) ^ 4) * c) -> RInt g 0 1 = c.
Proof.
  intros e. rewrite (RInt_ext _ (fun t => 630 * (t ^ 4 * (1 - t) ^ 4) * c)) by (intros u _; apply e).
  rewrite (RInt_by (fun t => (126 * t ^ 5 - 420 * t ^ 6 + 540 * t ^ 7 - 315 * t ^ 8 + 70 * t ^ 9) * c));
    [match goal with |- ?x = ?y => change (@eq R x y) end; ring
    | intros; auto_derive; [exact I | ring] | intros; apply @ex_derive_continuous; auto_derive; exact I].
Qed.
Ltac over_cubes := repeat match goal with |- context [RInt (fun x => RInt (fun y => RInt (fun z => @?g x y z) ?rl ?rh)
    ?ql ?qh) (?p - ?h) ?ph] =>
  match rl with ?r - _ => match ql with ?q - _ => rewrite (over_cube g h p q r) by (intros; ring) end end end.
Ltac pulses := repeat match goal with |- context [RInt ?g 0 1] =>
  rewrite (of_pulse g (g (1 / 2) * 256 / 630)) by (intros; field; assumption) end.
)";

constexpr const char* areas_in_coq = R"(
(* of what is linear in u and quadratic in v *)
Lemma over_square (g : R -> R -> R) :
  (forall u v, g u v = g u 0 + v * (4 * g u (1 / 2) - 3 * g u 0 - g u 1)
    + v * v * (2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1)) ->
  (forall u v, g u v = g 0 v + u * (g 1 v - g 0 v)) ->
  RInt (fun u => RInt (fun v => g u v) 0 1) 0 1
  = (g 0 0 + 4 * g 0 (1 / 2) + g 0 1 + (g 1 0 + 4 * g 1 (1 / 2) + g 1 1)) / 12.
Proof.
  intros q l. set (s := fun u => (g u 0 + 4 * g u (1 / 2) + g u 1) / 6).
  rewrite (RInt_ext _ (fun u => s 0 + u * (s 1 - s 0))).
  - rewrite on_segment by (intros; ring).
    match goal with |- ?x = ?y => change (@eq R x y) end. unfold s. field.
  - intros u _. rewrite (RInt_ext _ (fun v => g u 0 + v * (4 * g u (1 / 2) - 3 * g u 0 - g u 1)
      + v * v * (2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1))) by (intros v _; apply q).
    set (b := 4 * g u (1 / 2) - 3 * g u 0 - g u 1). set (c := 2 * g u 0 - 4 * g u (1 / 2) + 2 * g u 1).
    rewrite (RInt_by (fun v => g u 0 * v + v * v / 2 * b + v * v * v / 3 * c));
      [| intros; auto_derive; [exact I | field] | intros; apply @ex_derive_continuous; auto_derive; exact I].
    match goal with |- ?x = ?y => change (@eq R x y) end.
    unfold b, c, s. rewrite (l u 0), (l u (1 / 2)), (l u 1). field.
Qed.
Ltac over_squares := repeat match goal with |- context [RInt (fun u => RInt (fun v => @?g u v) 0 1) 0 1] =>
  rewrite (over_square g) by (intros; field) end; cbv beta.
)";

/// w+ for the impulse spread over a trapezoid, with the area element as a fraction of P0P1 x a.
LetterVector over_trapezoid(const Lettered& s, const LetterVector& a, double ratio) {
  const auto area = trapezoid_of(s, a, ratio);
  const auto integral = [&](const auto& g) {
    const Shortened u = Shortened::letter("u"), v = Shortened::letter("v");
    const Expression density = Shortened((1.0 + v * (ratio - 1)) * g(area.point(u, v))).expression();
    const auto over = [](const Expression& inner, const char* name) {
      return oddity::integral([&](const Expression&) { return inner; }, 0, 1, name);
    };
    return Shortened(over(over(density, "v"), "u"));
  };
  LetterVector momentum;
  for (int k = 0; k < 3; ++k)
    momentum[k] = integral([&](const LetterVector& x) { return torque(s, s.arm(x), s.normal)[k]; }) /
                  integral([](const LetterVector&) { return Shortened(1.0); });
  return s.body.w + turned(s.body.inertia, momentum);
}

LetterVector letters(const std::string& name) {
  const auto letter = [&](int i) { return Shortened::letter(name + std::to_string(i)); };
  return {letter(0), letter(1), letter(2)};
}

/// The pulse's integral of f for momentum and angular momentum, with the arms at its begin.
template <class F>
LetterVector over_pulse(const F& f) {
  LetterVector all;
  for (int k = 0; k < 3; ++k)
    all[k] = recorded_integral(
        [&](const Shortened& t) {
          const Shortened bump = t * t * (1.0 - t) * (1.0 - t);
          return 630.0 * bump * bump * f(k);
        },
        0.0, 1.0);
  return all;
}

/// Proves that impulses at the corners of triangles and parallelograms, as at the ends of a segment, replace
/// the whole; those of a trapezoid do not.
Provable finite_set(const Lettered& s, const std::string& names, Lemma segment) {
  const auto all = [](const LetterVector& v) {
    return Expressions{v[0].expression(), v[1].expression(), v[2].expression()};
  };
  const LetterVector a = letters("a");
  std::string with_side = names;
  with_side.insert(1, "a0 a1 a2 ratio u v ");
  const Shortened ratio = Shortened::letter("ratio"), u = Shortened::letter("u"), v = Shortened::letter("v");
  const auto area = trapezoid_of(s, a, ratio);
  const LetterVector unit = product(LetterVector(s.hit.p1 - s.hit.p0), a);
  segment.name = "corrected_segment";
  Provable proof{
      "6.5-finite_set",
      "as corrected it holds for any segment, triangle and parallelogram; a trapezoid's corners are "
      "off at an example",
      {segment,
       {"element",
        with_side,
        {},
        equal(all(area.element(u, v)), all(LetterVector((1 + v * (ratio - 1)) * unit))),
        "ring"}},
      0.05,
      std::string(integrals_in_coq) + means_in_coq + areas_in_coq};
  for (const auto& [name, other_side] :
       {std::pair("corrected_triangle", 0.0), {"corrected_parallelogram", 1.0}})
    proof.lemmas.push_back({name,
                            with_side,
                            {},
                            equal(all(at_corners(s, a, other_side)), all(over_trapezoid(s, a, other_side))),
                            "over_squares; field; lra"});
  Lettered example;
  example.f = 1.0;
  example.body.mass = 1.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) example.body.inertia(i, j) = i == j ? 1.0 : 0.0;
  example.hit.p1[0] = 1.0;
  example.normal[2] = 1.0;
  const LetterVector up(Shortened(0.0), Shortened(1.0), Shortened(0.0));
  proof.lemmas.push_back({"printed_differs",
                          "",
                          {},
                          {apart(at_corners(example, up, 0.5)[0].expression(),
                                 over_trapezoid(example, up, 0.5)[0].expression(), 0.05)},
                          "over_squares; interval"});
  return proof;
}

}  // namespace

Provables proofs() {
  Lettered s;
  s.body.mass = Shortened::letter("m");
  s.f = Shortened::letter("f");
  s.body.center = letters("c"), s.body.v = letters("v"), s.body.w = letters("w");
  s.hit.p0 = letters("p"), s.hit.p1 = letters("q"), s.normal = letters("n");
  std::string names = "(h m f";
  for (const char* name : {"c", "v", "w", "p", "q", "n"})
    for (int i = 0; i < 3; ++i) names += " " + (name + std::to_string(i));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const std::string k = "k" + std::to_string(i) + std::to_string(j);
      s.body.inertia(i, j) = Shortened::letter(k);
      names += " " + k;
    }
  names += " : R)";
  const std::vector<Proposition> given{not_zero(Expression::letter("h")), not_zero(s.body.mass.expression())};
  const auto all = [](const LetterVector& v) {
    return Expressions{v[0].expression(), v[1].expression(), v[2].expression()};
  };
  Provables proved;
  const auto add = [&](const std::string& slug, const std::string& says, const Expressions& printed,
                       const LetterVector& truth, const std::string& tactic) {
    proved.push_back({"6.5-" + slug,
                      says,
                      {{"printed", names, given, equal(printed, all(truth)), tactic}},
                      0,
                      std::string(integrals_in_coq) + means_in_coq});
  };
  const LetterVector half0 = Shortened(0.5) * torque(s, s.arm(s.hit.p0), s.normal),
                     half1 = Shortened(0.5) * torque(s, s.arm(s.hit.p1), s.normal);
  const LetterVector pushed = s.body.v + over_pulse([&](int k) {
                                           return 0.5 * s.f * s.normal[k] + 0.5 * s.f * s.normal[k];
                                         }) / s.body.mass;
  const LetterVector spun =
      s.body.w + turned(s.body.inertia, over_pulse([&](int k) { return half0[k] + half1[k]; }));
  const auto text = [&](const std::string& formula) { return recorded_text(formula, s.typeset()); };
  const std::string any_body = "it holds for any body, points, normal and impulse";
  const std::string cubes = "over_cubes; ", pulses = "pulses; ", rest = "field; auto";
  const std::string any_cube = any_body + ", the delta functions as wide as one likes";
  add("linear_integral", any_cube, all(linear_integral(s, 0.5)), pushed, cubes + pulses + rest);
  add("linear_mean", any_cube, text(by_sum), linear_integral(s, 0.5), cubes + rest);
  add("linear_result", any_body, text(by_impulse), pushed, pulses + rest);
  add("angular_integral", any_cube + ", the arms being those at the pulse's begin",
      all(angular_integral(s, 0.5)), spun, cubes + pulses + rest);
  add("angular_mean", any_body + ", the arms being those at the pulse's begin", text(by_torques), spun,
      pulses + rest);
  add("angular_mean_arm", any_body, text(by_mean_arm), mean_torque(s), "field");
  add("angular_midpoint", any_body, text(by_midpoint), mean_torque(s), "field");
  const LetterVector even = along_segment(s, 0, [](const auto& g) { return recorded_integral(g, 0.0, 1.0); });
  const std::string by_segment =
      "repeat match goal with |- context [RInt ?g 0 1] => rewrite (on_segment g) by (intros; ring) end; field";
  add("segment", any_body, all(mean_torque(s)), even, by_segment);
  proved.push_back(finite_set(s, names, proved.back().lemmas.front()));
  return proved;
}

}  // namespace oddity::ex06_05

namespace oddity {

Provables proofs_6_5() { return ex06_05::proofs(); }

}  // namespace oddity
