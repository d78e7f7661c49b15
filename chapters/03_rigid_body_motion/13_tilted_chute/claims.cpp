// The claims of exercise 3.13. The cylinder's formulas are tried on points constructed by moving along the
// axis and rotating about it. Partial derivatives are by dual numbers. The equations of motion are
// Lagrange's, with the Lagrangian differentiated by nested dual numbers. They are in the plane's coordinates
// and in those of the cylinder, s along its axis and phi about it.

#include <cmath>
#include <numbers>

#include "chapters/03_rigid_body_motion/13_tilted_chute/tilted_chute.hpp"
#include "chapters/03_rigid_body_motion/shared/height_field.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"

namespace oddity::ex03_13 {

using namespace tilted_chute;
using std::abs, std::asin, std::cos, std::hypot, std::pow, std::sin, std::sqrt, std::numbers::pi;
template <class T>
using Three = std::array<T, 3>;
using Point = Three<double>;

inline Shortened asin(const Shortened& x) { return function("asin", x.expression()); }
inline Shortened tan(const Shortened& x) { return function("tan", x.expression()); }
/// The angle whose tangent is rise / run, for run > 0.
inline Shortened slope_angle(const Shortened& rise, const Shortened& run) {
  return function("atan", (rise / run).expression());
}
inline double slope_angle(double rise, double run) { return std::atan2(rise, run); }

/// The Lagrangian of a unit mass in the distance along the axis and the angle about it, from the position
/// alone.
template <class G>
struct AlongAndAbout {
  Chute<G> chute;
  G g;

  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const auto x = chute.position(Dual<T>(q[0], v[0]), Dual<T>(q[1], v[1]));
    return T(0.5) * (x[0].slope * x[0].slope + x[1].slope * x[1].slope + x[2].slope * x[2].slope) -
           T(g) * x[2].value;
  }
};

template <class T>
Three<T> sum(const std::type_identity_t<Three<T>>& a, const Three<T>& b, std::type_identity_t<T> factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
template <class T>
Three<T> unit(const Three<T>& a) {
  return sum({}, a, 1 / sqrt(dot(a, a)));
}

/// Y^T (I + sign D D^T) Y with the matrix written out.
template <class T>
T quadratic(const Three<T>& y, const Three<T>& d, double sign = -1) {
  T total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) total += y[i] * ((i == j ? 1.0 : 0.0) + sign * d[i] * d[j]) * y[j];
  return total;
}

/// A point X of a cylinder about P + t D, constructed along the axis and then at distance R from it. U, V, D
/// are orthonormal.
template <class T>
struct OnCylinderOf {
  T R, t;
  Three<T> P, D, U, V, X, Y;

  OnCylinderOf() = default;
  explicit OnCylinderOf(Random& random)
      : R(random.between(0.2, 3)),
        t(random.magnitude(0.1, 3)),
        P(random.point(3)),
        D(random.direction()),
        U(unit(cross(D, random.direction()))),
        V(cross(D, U)),
        X(sum(sum(P, D, t), unit(cross(D, random.direction())), R)),
        Y(sum(X, P, -1)) {}
  std::vector<T*> letters() {
    std::vector<T*> all{&R, &t};
    for (Three<T>* point : {&P, &D, &U, &V, &X, &Y})
      for (T& x : *point) all.push_back(&x);
    return all;
  }
  std::string where() const {
    return "$R$ = " + format_significant(R, 4) + ", $t$ = " + format_significant(t, 4);
  }
  TypesetIn<T> typeset() const {
    return {{"R", R},      {"t", t},      {"P", P},
            {"D", D},      {"U", U},      {"V", V},
            {"X", X},      {"Y", Y},      {"I", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
            {"y_1", y1()}, {"y_2", y2()}, {"y_3", y3()}};
  }
  T y1() const { return dot(U, Y); }
  T y2() const { return dot(V, Y); }
  T y3() const { return dot(D, Y); }
};
using OnCylinder = OnCylinderOf<double>;

/// A chute, a position and a velocity in the plane, a friction, an angle and a distance along the axis.
template <class T>
struct OnChuteOf {
  Chute<T> chute;
  T g, x1, x2, x3, v1, v2, k, phi, way;

  OnChuteOf() = default;
  explicit OnChuteOf(Random& random)
      : chute{random.between(0.5, 3), random.between(2, 10), 0},
        g(random.between(0.5, 20)),
        x1(random.magnitude(0.05, 3)),
        x2(chute.R * random.magnitude(0.05, 0.9)),
        x3(random.magnitude(0.05, 3)),
        v1(random.magnitude(0.05, 3)),
        v2(random.magnitude(0.05, 3)),
        k(random.between(0.1, 2)),
        phi(random.magnitude(0.05, 1.4)),
        way(random.magnitude(0.05, 3)) {
    chute.H = chute.L * sin(random.between(0.1, 1.4));
  }
  T cosine() const { return sqrt(chute.L * chute.L - chute.H * chute.H) / chute.L; }
  T theta() const { return asin(chute.H / chute.L); }
  std::array<T*, 12> letters() {
    return {&chute.R, &chute.L, &chute.H, &g, &x1, &x2, &x3, &v1, &v2, &k, &phi, &way};
  }
  TypesetIn<T> typeset() const {
    return {{"R", chute.R},
            {"L", chute.L},
            {"H", chute.H},
            {R"(\theta)", theta()},
            {"g", g},
            {"x_1", x1},
            {"x_2", x2},
            {"x_3", x3},
            {R"(\dot x_1)", v1},
            {R"(\dot x_2)", v2},
            {"k", k},
            {"d_1", d1()},
            {"d_3", d3()},
            {"p_3", p3()},
            {"D", {d1(), 0, d3()}},
            {"P", {0, 0, p3()}},
            {"I", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
            {R"(\ddot x_1)", accelerations()[0]},
            {R"(\ddot x_2)", accelerations()[1]},
            {"h_{x_1x_1}", second(1, 1)},
            {"h_{x_1x_2}", second(1, 2)},
            {"h_{x_2x_2}", second(2, 2)}};
  }
  std::string where() const {
    return R"($\theta$ = )" + format_significant(theta(), 4) + ", $R$ = " + format_significant(chute.R, 4) +
           ", $x_2$ = " + format_significant(x2, 4) + ", $v$ = (" + format_significant(v1, 4) + ", " +
           format_significant(v2, 4) + ")";
  }
  /// (x1'', x2'') from the Lagrangian of the height, with friction and a side wind per mass.
  Two<T> accelerations(const T& friction = 0, const T& wind = 0) const {
    using D = Dual<T>;
    const T n1 = chute.height(D(x1, T(1)), D(x2)).slope, n2 = chute.height(D(x1), D(x2, T(1))).slope;
    const T rise = chute.height(D(x1, v1), D(x2, v2)).slope;
    const Two<T> force{-friction * (v1 + n1 * rise), wind - friction * (v2 + n2 * rise)};
    return lagrange_accelerations(height_field::Lagrangian<Chute<T>, T>{chute, g}, Two<T>{x1, x2}, {v1, v2},
                                  force);
  }
  /// (x1'', x2'') without forces, from the Lagrangian in the distance along the axis and the angle about it.
  Two<T> accelerations_about_axis() const {
    const T angle = asin(x2 / chute.R), turning = v2 / (chute.R * cos(angle));
    const T along = (x1 - chute.R * (1 - cos(angle)) * chute.s()) / chute.c();
    const T speed = (v1 - chute.R * sin(angle) * turning * chute.s()) / chute.c();
    const Two<T> a =
        lagrange_accelerations(AlongAndAbout<T>{chute, g}, Two<T>{along, angle}, {speed, turning});
    const auto x = [&](std::size_t i) {
      return [&, i](const auto& t) {
        return chute.position(along + speed * t + 0.5 * a[0] * t * t,
                              angle + turning * t + 0.5 * a[1] * t * t)[i];
      };
    };
    return {second_derivative(x(0), T(0)), second_derivative(x(1), T(0))};
  }

  T d1() const { return -cosine(); }
  T d3() const { return chute.H / chute.L; }
  T p3() const { return chute.R / cosine(); }
  /// The cylinder's equation at any point: left side minus right side.
  T excess() const { return quadratic<T>({x1, x2, x3 - p3()}, {d1(), 0, d3()}) - chute.R * chute.R; }
  /// A point of the chute's half of the cylinder, or, rotated by pi, of the other half.
  Three<T> on_it(bool other_half = false) const {
    return chute.position(way, other_half ? phi + pi_of<T>() : phi);
  }
  /// A copy with such a point as its position.
  OnChuteOf placed() const {
    OnChuteOf there = *this;
    const Three<T> x = on_it();
    there.x1 = x[0], there.x2 = x[1], there.x3 = x[2];
    return there;
  }
  /// d^2 h / dx_i dx_j by nested dual numbers.
  T second(int i, int j) const {
    using Along = Dual<T>;
    const auto x = [&](int n, const T& value) {
      return Dual<Along>(Along(value, T(i == n ? 1.0 : 0.0)), Along(T(j == n ? 1.0 : 0.0), T(0.0)));
    };
    return chute.height(x(1, x1), x(2, x2)).slope.slope;
  }
  /// A copy with the ball on the center line, without sideways speed.
  OnChuteOf on_center() const {
    OnChuteOf there = *this;
    there.x2 = there.v2 = 0;
    return there;
  }
  /// x1'' on the center line of a chute at another angle.
  T at_angle(double angle) const {
    OnChuteOf there = on_center();
    there.chute.H = chute.L * sin(angle);
    return there.accelerations()[0];
  }
  /// The published accelerations, with `square` for x2'^2 and `slope` for h_x1.
  Two<T> published(const T& square, const T& slope) const {
    const T R2 = chute.R * chute.R, c = cosine(), r = depth(), tangent = chute.H / (chute.L * c);
    const T above = R2 * square / (r * r * r * c) + g;
    const T factor = -above / (1 + tangent * tangent + x2 * x2 / (r * r * c * c));
    return {factor * slope, factor * x2 / (r * c)};
  }
  T slope() const { return -chute.H / (chute.L * cosine()); }
  /// The first form of x1'' on the center line, with its numerator as a product.
  T center_as_printed() const { return g * (chute.H * chute.L * cosine()) / (1 + slope() * slope()); }
  T depth() const { return sqrt(chute.R * chute.R - x2 * x2); }

  T bracket(const Three<T>& x) const { return d1() * (x[2] - p3()) - d3() * x[0]; }
  T depth_at(const Three<T>& x) const { return sqrt(chute.R * chute.R - x[1] * x[1]); }
};
using OnChute = OnChuteOf<double>;

using CylinderTable = ProvableClaims<OnCylinderOf>;
using ChuteTable = ProvableClaims<OnChuteOf>;

// ---- the cylinder -----------------------------------------------------------------------------------------

void cylinder(CylinderTable& table, const std::vector<OnCylinder>& samples) {
  using Form = ProvableFormula<OnCylinderOf>;
  const Form square{"$R^2$, the point having been put $R$ from the axis",
                    [](const auto& s) { return s.R * s.R; }};
  const auto across = [](const auto& s) { return sum(sum({}, s.U, s.y1()), s.V, s.y2()); };

  table.formula("cylinder", 1587,
                "The cylinder of radius $R$ about the line $P+tD$, $|D|=1$, is $(X-P)^T(I-DD^T)(X-P)=R^2$",
                samples,
                {.quantity = "the equation of the cylinder of radius $R$ about the line $P+tD$, $|D|=1$",
                 .truth = square,
                 .printed = "$(X-P)^T(I-DD^T)(X-P)$"});
  table.formula(
      "coordinates", 1595,
      R"($X=P+y_1U+y_2V+y_3D$ with $y_1=U\cdot(X-P)$, $y_2=V\cdot(X-P)$, $y_3=D\cdot(X-P)$, where $U$, )"
      R"($V$, $D$ are orthonormal)",
      samples,
      {.quantity = "$P+y_1U+y_2V+y_3D$",
       .truth = {"$X$", [](const auto& s) { return s.X; }},
       .printed = R"($P+(U\cdot(X-P))U+(V\cdot(X-P))V+(D\cdot(X-P))D$)"});
  table.formula(
      "distance", 1597, "A point of the cylinder has $y_1^2+y_2^2=R^2$", samples,
      {.quantity = "the cylinder in these coordinates", .truth = square, .printed = "$y_1^2+y_2^2$"});
  table.formula("perpendicular", 1599, R"($y_1U+y_2V=(X-P)-(D\cdot(X-P))D$)", samples,
                {.quantity = "$y_1U+y_2V$",
                 .truth = {"the sum of the two", across},
                 .printed = R"($(X-P)-(D\cdot(X-P))D$)"});
  table.formula("squared_left", 1601, "$|y_1U+y_2V|^2=y_1^2+y_2^2$", samples,
                {.quantity = "$|y_1U+y_2V|^2$",
                 .truth = {"the vector's square",
                           [=](const auto& s) {
                             const auto w = across(s);
                             return dot(w, w);
                           }},
                 .printed = "$y_1^2+y_2^2$"});

  const auto row = [&](std::string_view slug, int line, const std::string& text,
                       const std::string& changes_that_hold = {}) {
    table.formula(slug, line, "On the cylinder $R^2=" + text.substr(1), samples,
                  {.quantity = "$R^2$ on the cylinder",
                   .truth = square,
                   .printed = text,
                   .changes_that_hold = changes_that_hold});
  };
  row("squared_right", 1603, R"($|(X-P)-(D\cdot(X-P))D|^2$)");
  row("opened", 1605, R"($(X-P)\cdot(X-P)-2(D\cdot(X-P))^2+(D\cdot(X-P))^2(D\cdot D)$)", R"($D\cdot D=1$)");
  row("gathered", 1607, R"($(X-P)\cdot(X-P)-(D\cdot(X-P))^2$)");
  row("rows_and_columns", 1609, "$(X-P)^T(X-P)-((X-P)^TD)(D^T(X-P))$");
  row("matrices", 1611, "$(X-P)^TI(X-P)-(X-P)^T(DD^T)(X-P)$", "$I$ is the unit matrix");
  row("one_matrix", 1613, "$(X-P)^T(I-DD^T)(X-P)$");
}

// ---- the axis ---------------------------------------------------------------------------------------------

void axis(ChuteTable& table, const std::vector<OnChute>& samples) {
  table.formula("triangle", 1617,
                R"(The axis has the length $L$: where $x_3$ rises by $H$, $x_1$ falls by $L\cos\theta$)",
                samples,
                {.quantity = "hypotenuse and opposite side",
                 .truth = {R"($L$ and $L\sin\theta$)",
                           [](const auto& s) { return values(s.chute.L, s.chute.L * sin(s.theta())); }},
                 .printed = R"($(\sqrt{(L\cos\theta)^2+H^2},\ H)$)"});
  table.formula("adjacent", 1619, R"(The adjacent side of the triangle is $\sqrt{L^2-H^2}$)", samples,
                {.quantity = "the triangle's adjacent side",
                 .truth = {R"($L\cos\theta$)", [](const auto& s) { return s.chute.L * cos(s.theta()); }},
                 .printed = R"($\sqrt{L^2-H^2}$)"});
  table.formula("cosine", 1621, R"($\cos\theta=\sqrt{L^2-H^2}/L$)", samples,
                {.quantity = R"($\cos\theta$)",
                 .truth = {R"($\cos(\sin^{-1}(H/L))$)", [](const auto& s) { return cos(s.theta()); }},
                 .printed = R"($\sqrt{L^2-H^2}/L$)"});
  const auto run = [](const auto& s) { return sqrt((s.chute.L - s.chute.H) * (s.chute.L + s.chute.H)); };
  table.formula("sine", 1621, R"($\sin\theta=H/L$)", samples,
                {.quantity = R"($\sin\theta$)",
                 .truth = {"the angle between the chute and the plane",
                           [=](const auto& s) { return sin(slope_angle(s.chute.H, run(s))); }},
                 .printed = "$H/L$"});
  table.formula("direction", 1623, R"(The unit vector up the axis is $D=(-\cos\theta,0,\sin\theta)$)",
                samples,
                {.quantity = "the unit vector $D$ up the axis",
                 .truth = {R"($(-\sqrt{L^2-H^2},0,H)$, normalized)",
                           [=]<class T>(const OnChuteOf<T>& s) {
                             return unit<T>({-run(s), 0, s.chute.H});
                           }},
                 .printed = R"($(-\cos\theta,0,\sin\theta)$)"});
  table.formula("axis_point", 1631,
                R"(The axis passes at $(0,0,\alpha)$ over the origin, where $\alpha=R/\cos\theta$)", samples,
                {.quantity = R"(the origin's distance $|(0,0,p_3)\times D|$ from the axis)",
                 .truth = {"$R$", [](const auto& s) { return s.chute.R; }},
                 .printed = R"($|(0,0,\frac{R}{\cos\theta})\times(-\cos\theta,0,\sin\theta)|$)"});
}

// ---- the cylinder solved for x3 ---------------------------------------------------------------------------

void solved(ChuteTable& table, const std::vector<OnChute>& samples) {
  using Form = ProvableFormula<OnChuteOf>;
  const Form form{"$(X-P)^T(I-DD^T)(X-P)-R^2$ at any point", [](const auto& s) { return s.excess(); }};
  const std::string equation =
      "the expression that is zero on the cylinder about the axis through $(0,0,p_3)$ along $(d_1,0,d_3)$";
  table.formula(
      "expansion_1", 1637, "On the cylinder $0=x_1^2+x_2^2+(x_3-p_3)^2-(d_1x_1+d_3(x_3-p_3))^2$", samples,
      {.quantity = equation,
       .truth = form,
       .printed = "$x_1^2+x_2^2+(x_3-p_3)^2-(d_1x_1+d_3(x_3-p_3))^2$",
       .meant = "$x_1^2+x_2^2+(x_3-p_3)^2-(d_1x_1+d_3(x_3-p_3))^2-R^2$",
       .kind = Fault::formula,
       .why =
           "The term $-R^2$, there in the lines before and after, is left out: so read it is the axis alone "
           "that satisfies the equation."});
  const std::string rest = "(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+(1-d_1^2)x_1^2+x_2^2-R^2$";
  table.formula(
      "expansion_2", 1639,
      "On the cylinder $0=(1-d_3)^2(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+(1-d_1^2)x_1^2+x_2^2-R^2$", samples,
      {.quantity = "this expression by powers of $x_3-p_3$",
       .truth = form,
       .printed = "$(1-d_3)^2" + rest,
       .meant = "$(1-d_3^2)" + rest,
       .kind = Fault::formula,
       .why =
           filled("The square belongs to $d_3$: $(1-d_3^2)$, which the next line writes as $d_1^2$. With the "
                  "default chute, $d_3=3/5$, that is @2, and as printed @2.",
                  {1 - 0.36, 0.4 * 0.4})});
  table.formula("expansion_3", 1641,
                "On the cylinder $0=d_1^2(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+d_3^2x_1^2+x_2^2-R^2$, as "
                "$d_1^2+d_3^2=1$",
                samples,
                {.quantity = "this expression with $d_1^2+d_3^2=1$",
                 .truth = form,
                 .printed = "$d_1^2(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+d_3^2x_1^2+x_2^2-R^2$"});
  table.formula("expansion_4", 1643, "On the cylinder $0=(d_1(x_3-p_3)-d_3x_1)^2+x_2^2-R^2$", samples,
                {.quantity = "this expression with a square",
                 .truth = form,
                 .printed = "$(d_1(x_3-p_3)-d_3x_1)^2+x_2^2-R^2$"});

  const std::string bracket = "$d_1(x_3-p_3)-d_3x_1$";
  table.formula("origin", 1649, "The origin is on the cylinder", samples,
                {.quantity = "$(X-P)^T(I-DD^T)(X-P)$ at $X=0$",
                 .truth = {"$R^2$", [](const auto& s) { return s.chute.R * s.chute.R; }},
                 .printed = "$(-P)^T(I-DD^T)(-P)$"});
  table.formula("at_origin", 1651, R"(At the origin the left side is $\cos\theta\,(R/\cos\theta)=-d_1p_3=R$)",
                samples,
                {.quantity = bracket + " at the origin",
                 .truth = {"the bracket at $x_1=x_3=0$",
                           [](const auto& s) {
                             return s.bracket({0, 0, 0});
                           }},
                 .printed = R"($(\cos\theta\,(R/\cos\theta),\ -d_1p_3,\ R)$)"});
  table.formula("plus", 1653, "At the origin the root has the plus sign", samples,
                {.quantity = bracket + " at the origin",
                 .truth = {"the bracket at $x_1=x_3=0$",
                           [](const auto& s) {
                             return s.bracket({0, 0, 0});
                           }},
                 .printed = R"($+\sqrt{R^2-0}$)"});
}

/// Claims about points on the chute.
void on_the_chute(ChuteTable& table, const std::vector<OnChute>& samples) {
  using Form = ProvableFormula<OnChuteOf>;
  const std::string bracket = "$d_1(x_3-p_3)-d_3x_1$";
  table.formula(
      "two_roots", 1647,
      R"($d_1(x_3-p_3)-d_3x_1=\pm\sqrt{R^2-x_2^2}$ (our check: the lower half has plus, the upper minus))",
      samples,
      {.quantity = bracket + " on the two halves of the cylinder",
       .truth = {"points of the lower half and of the upper, turned about the axis",
                 [](const auto& s) { return values(s.bracket(s.on_it()), s.bracket(s.on_it(true))); }},
       .printed = R"($(\sqrt{R^2-x_2^2},\ -\sqrt{R^2-x_2^2})$)"});
  table.formula("chute", 1655, R"(The chute is $d_1(x_3-p_3)-d_3x_1=+\sqrt{R^2-x_2^2}$)", samples,
                {.quantity = bracket + " on the chute",
                 .truth = {"points of the lower half, turned about the axis",
                           [](const auto& s) { return s.bracket(s.on_it()); }},
                 .printed = R"($\sqrt{R^2-x_2^2}$)"});
  const Form x3{"$x_3$ of a point turned about the axis", [](const auto& s) { return s.on_it()[2]; }};
  table.formula(
      "solved", 1659, R"(Solved for $x_3$: $x_3=p_3+(d_3x_1+\sqrt{R^2-x_2^2})/d_1$)", samples,
      {.quantity = "$x_3$ on the chute", .truth = x3, .printed = R"($p_3+(d_3x_1+\sqrt{R^2-x_2^2})/d_1$)"});
  table.formula("height", 1663,
                R"(The height of the chute is $h(x_1,x_2)=(LR-Hx_1-L\sqrt{R^2-x_2^2})/(L\cos\theta)$)",
                samples,
                {.quantity = "the height $h(x_1,x_2)$ of the chute",
                 .truth = x3,
                 .printed = R"($(LR-Hx_1-L\sqrt{R^2-x_2^2})/(L\cos\theta)$)"});
}

// ---- the height's derivatives -----------------------------------------------------------------------------

/// A quantity that should vanish, and the size of its terms, which cancel.
struct Vanishing {
  double value, terms;
  std::string place;
  double size() const { return terms; }
  std::string where() const { return place; }
};
/// Compares value and size by `of` with zero at every sample.
template <class Of>
Check vanishes(std::string quantity, std::string by, const std::vector<OnChute>& samples, const Of& of) {
  std::vector<Vanishing> all;
  for (const OnChute& s : samples) {
    const auto [value, terms] = of(s);
    all.push_back({value, terms, s.where()});
  }
  return compare<Vanishing>(std::move(quantity), {"zero", [](const Vanishing&) { return 0.0; }},
                            {std::move(by), [](const Vanishing& v) { return v.value; }}, all);
}

void derivatives(Claims& claims, ChuteTable& table, const std::vector<OnChute>& samples) {
  table.formula(
      "h1", 1673, R"(The derivative $h_{x_1}$ is $-H/(L\cos\theta)$)", samples,
      {.quantity = "$h_{x_1}$",
       .truth = {"$h$ by dual numbers",
                 []<class T>(const OnChuteOf<T>& s) {
                   return s.chute.height(Dual<T>(s.x1, T(1)), Dual<T>(s.x2)).slope;
                 }},
       .printed = R"($-HL\cos\theta$)",
       .meant = R"($-H/(L\cos\theta)$)",
       .kind = Fault::lost_typography,
       .why = filled(
           "The fraction's bar is lost. For the default chute the quotient is $@2$, and the product $@2$.",
           {-3.0 / (5 * 0.8), -3.0 * 5 * 0.8})});
  table.formula(
      "h2", 1677, R"(The derivative $h_{x_2}$ is $x_2/\big((R^2-x_2^2)^{1/2}\cos\theta\big)$)", samples,
      {.quantity = "$h_{x_2}$",
       .truth = {"$h$ by dual numbers",
                 []<class T>(const OnChuteOf<T>& s) {
                   return s.chute.height(Dual<T>(s.x1), Dual<T>(s.x2, T(1))).slope;
                 }},
       .printed = R"($x_2(R^2-x_2^2)^{1/2}\cos\theta$)",
       .meant = R"($x_2/\big((R^2-x_2^2)^{1/2}\cos\theta\big)$)",
       .kind = Fault::lost_typography,
       .why =
           "The fraction's bar is lost. Towards the rim this slope becomes infinite, and the product zero."});
  const auto second = [&](const std::string& quantity, int i, int j) {
    return vanishes(quantity, "$h$ by nested dual numbers", samples,
                    [=](const OnChute& s) { return std::pair(s.second(i, j), abs(s.second(2, 2))); });
  };
  const auto zero = [&](const std::string& text, std::vector<Check> all) {
    const bool holds = std::ranges::all_of(all, &Check::holds);
    return Reading{text, std::move(all),
                   is_as_typeset(compare_typeset(
                       Statement<OnChute>{text, [=](const OnChute&) { return holds; }}, samples))};
  };
  claims.add("h11_h12", 1679, "$h_{x_1x_1}=h_{x_1x_2}=0$",
             {.printed = zero("$h_{x_1x_1}=h_{x_1x_2}=0$",
                              {second("$h_{x_1x_1}$", 1, 1), second("$h_{x_1x_2}$", 1, 2)}),
              .near_misses = {zero("$h_{x_2x_2}=0$", {second("$h_{x_2x_2}$", 2, 2)})}});
  table.formula("h22", 1681, R"($h_{x_2x_2}=R^2/\big((R^2-x_2^2)^{3/2}\cos\theta\big)$)", samples,
                {.quantity = "$h_{x_2x_2}$",
                 .truth = {"$h$ by nested dual numbers", [](const auto& s) { return s.second(2, 2); }},
                 .printed = R"($R^2/\big((R^2-x_2^2)^{3/2}\cos\theta\big)$)"});
}

// ---- the equations of motion ------------------------------------------------------------------------------

void equations(Claims& claims, const std::vector<OnChute>& samples) {
  using S = const OnChute&;
  using Form = Formula<OnChute>;
  const Form lagrange{"Lagrange's equations by nested dual numbers", [](S s) { return s.accelerations(); }},
      about{"Lagrange's equations along and about the axis, mapped by dual numbers",
            [](S s) { return s.accelerations_about_axis(); }};
  const auto reading = [&](std::string quantity, const Form& formula,
                           std::initializer_list<Form> truths) -> Reading {
    const Form form = computed(formula);
    Reading all{form.text, {}, is_as_typeset(compare_typeset(form, samples))};
    for (const Form& truth : truths) all.checks.push_back(compare(quantity, form, truth, samples));
    return all;
  };
  const std::string both = R"($(\ddot x_1,\ddot x_2)$)";
  const auto written = [](const std::string& square, const std::string& gravity, const std::string& slope) {
    return R"($-\frac{R^2)" + square + R"(/\left((R^2-x_2^2)^{3/2}\cos\theta\right))" + gravity +
           R"(}{1+H^2/(L^2\cos^2\theta)+x_2^2/\left((R^2-x_2^2)\cos^2\theta\right)}\left()" + slope +
           R"(,\ \frac{x_2}{(R^2-x_2^2)^{1/2}\cos\theta}\right)$)";
  };
  const std::string rate = R"(\dot x_2^2)", gradient = R"(-\frac{H}{L\cos\theta})",
                    right = written(rate, "+g", gradient);
  claims.add(
      "equations", 1691, R"(The equations of motion are $(\ddot x_1,\ddot x_2)=)" + right.substr(1),
      {.printed = reading(both, {written("x_2^2", "+g", R"(-HL\cos\theta)")}, {lagrange}),
       .meant = reading(both, {right}, {lagrange, about}),
       .near_misses = {reading(both, {written(rate, "-g", gradient)}, {lagrange})},
       .why =
           R"(A dot and a bar are lost: the numerator has $R^2\dot x_2^2$, and the vector is the gradient )"
           R"($(-H/(L\cos\theta),\,x_2/((R^2-x_2^2)^{1/2}\cos\theta))$. So read, it follows from Lagrange's )"
           R"(equations, in the coordinates of the plane and in those of the cylinder.)",
       .kind = Fault::lost_typography});

  const Form truth{"Lagrange's equations at $x_2=\\dot x_2=0$",
                   [](S s) { return s.on_center().accelerations()[0]; }};
  const auto over = [](std::string text, double (*tangent)(S)) -> Form {
    return {std::move(text), [=](S s) {
              const double t = tangent(s);
              return s.g * t / (1 + t * t);
            }};
  };
  const std::string first = R"($\ddot x_1$ on the center line)";
  const Form by_slope = over(R"($gt/(1+t^2)$, $t=H/(L\cos\theta)$)", [](S s) { return -s.slope(); }),
             by_tangent = over(R"($g\tan\theta/(1+\tan^2\theta)$)", [](S s) { return std::tan(s.theta()); }),
             by_sine{R"($\frac g2\sin2\theta$)", [](S s) { return s.g / 2 * sin(2 * s.theta()); }},
             product{R"($gHL\cos\theta/(1+t^2)$)", [](S s) { return s.center_as_printed(); }};
  const std::string other_forms =
      R"(=\frac{g\tan\theta}{1+\tan^2\theta}=\frac g2\sin2\theta$, $t=\frac H{L\cos\theta}$)";
  const auto chain = [&](const std::string& numerator, const Form& beginning) {
    Reading all{R"($\ddot x_1=\frac{)" + numerator + "}{1+t^2}" + other_forms, {}};
    for (const Form& form : {beginning, by_tangent, by_sine})
      all.checks.push_back(compare(first, form, truth, samples));
    return all;
  };
  claims.add(
      "center_acceleration", 1717, R"(On the center line $\ddot x_1=\frac{gt}{1+t^2})" + other_forms,
      {.printed = chain(R"(gHL\cos\theta)", product),
       .meant = chain("gt", by_slope),
       .near_misses = {reading(first, {R"($g\sin\theta$)", [](S s) { return s.g * sin(s.theta()); }},
                               {truth}),
                       reading(first, {R"($g\sin2\theta$)", [](S s) { return s.g * sin(2 * s.theta()); }},
                               {truth})},
       .why = filled(
           R"(The bar of the numerator, $H/(L\cos\theta)$, is lost; that of the denominator is there. For the )"
           R"(default chute the numerator is @2 and its product @2: @2 m/s$^2$ for @3.)",
           {0.75, 12, 9.81 * 12 / (1 + 0.75 * 0.75), 9.81 * 0.75 / (1 + 0.75 * 0.75)}),
       .kind = Fault::lost_typography});
}

void center_motion(ChuteTable& table, const std::vector<OnChute>& samples) {
  const auto moves = [](std::string text, double factor) -> ProvableFormula<OnChuteOf> {
    return {std::move(text), [=]<class T>(const OnChuteOf<T>& s) {
              const auto x = [&](const auto& t) {
                return s.x1 + s.v1 * t + (s.g * sin(2 * s.theta()) * factor) * t * t;
              };
              return values(x(T(0)), derivative(x, T(0)), second_derivative(x, T(1.5)));
            }};
  };
  table.formula(
      "center_motion", 1735, R"(On the center line $x_1(t)=x_1(0)+\dot x_1(0)t+\frac{g\sin2\theta}4t^2$)",
      samples,
      {.quantity = R"($(x_1(0),\dot x_1(0),\ddot x_1)$ by dual numbers)",
       .truth = {"the start, and Lagrange's equations",
                 [](const auto& s) { return values(s.x1, s.v1, s.on_center().accelerations()[0]); }},
       .printed = moves(R"(of $x_1(0)+\dot x_1(0)t+\frac{g\sin2\theta}4t^2$)", 0.25),
       .near_misses = {moves(R"(of $x_1(0)+\dot x_1(0)t+\frac{g\sin2\theta}2t^2$)", 0.5)}});
}

// ---- statements about the motion --------------------------------------------------------------------------

void statements(Claims& claims, const std::vector<OnChute>& samples) {
  using S = const OnChute&;
  /// That x2'' vanishes at this x2 without sideways speed, in a wind across, with `friction` times the
  /// sample's friction.
  const auto at_rest = [&](std::string text, double x2, double wind, double friction) -> Reading {
    return {std::move(text), {vanishes(R"($\ddot x_2$)", "Lagrange's equations", samples, [=](OnChute s) {
              s.x2 = x2;
              s.v2 = 0;
              const Value a = s.accelerations(friction * s.k, wind);
              return std::pair(a[1], size_of(a));
            })}};
  };
  claims.add("x2_zero", 1715, "$x_2(t)=0$ for all time solves the second equation of motion",
             {.printed = at_rest(R"($\ddot x_2=0$ at $x_2=\dot x_2=0$)", 0, 0, 0),
              .near_misses = {at_rest(R"($\ddot x_2=0$ at $x_2=0.05$, $\dot x_2=0$)", 0.05, 0, 0)}});
  const auto staying = [&](std::string text, double across) -> Reading {
    const std::vector<OnChute> some(samples.begin(), samples.begin() + 20);
    return {std::move(text),
            {vanishes("$x_2$ after 1 s", "Fehlberg 7(8) on the height field", some, [=](S s) {
              const InPlane<double> ball{s.chute, s.g, {s.x1, 0, s.v1, across}};
              const auto end = ode::integrate<ode::Fehlberg78>(ball, ball.start(), 0, 1, 1e-10);
              return std::pair(end.value[1], s.chute.R);
            })}};
  };
  claims.add("stays_in_center", 1715,
             "A ball that starts in the center without speed across stays in the center",
             {.printed = staying("without speed across", 0),
              .near_misses = {staying("with speed across as well", 0.01)}});

  const auto constant = [&](std::string text, double moved) -> Reading {
    return {std::move(text),
            {compare<OnChute>(R"($\ddot x_1$, and whether it is positive)",
                              {"at one place and speed",
                               [](S s) {
                                 const double a = s.on_center().accelerations()[0];
                                 return values(a, a > 0);
                               }},
                              {R"($\ddot x_1$ at another place and speed, and that it is positive)",
                               [=](S s) {
                                 OnChute other = s.on_center();
                                 other.x1 = 1 - s.x1;
                                 other.v1 = 2 - s.v1;
                                 other.x2 = moved * s.x2;
                                 return values(other.accelerations()[0], 1);
                               }},
                              samples)}};
  };
  claims.add("positive", 1733, R"(On the center line $\ddot x_1$ is a positive constant)",
             {.printed = constant("in a chute neither level nor vertical (our condition)", 0),
              .near_misses = {constant("off the center line as well", 1),
                              {"in a level chute as well",
                               {in_all<OnChute>(R"($\ddot x_1>0$ in a level chute)", samples,
                                                [](S s) { return s.at_angle(0) > 0; })}}}});
  const auto always = [](std::string text, std::size_t i) -> Statement<OnChute> {
    return {std::move(text), [=](S s) { return s.accelerations()[i] > 0; }};
  };
  claims.statement<OnChute>(
      "always_positive", 1733, R"(The acceleration along $x_1$ is always positive: $\ddot x_1>0$)", samples,
      {.printed = always(R"($\ddot x_1>0$)", 0), .near_misses = {always(R"($\ddot x_2>0$)", 1)}});

  /// (x1, x1') on the center line a millisecond later, to check which quantities increase.
  const auto then = [](S s) {
    const double a = s.on_center().accelerations()[0], t = 1e-3;
    return Pair{s.x1 + s.v1 * t + a * t * t / 2, s.v1 + a * t};
  };
  const auto faster_and_farther = [=](S s) { return abs(then(s)[1]) > abs(s.v1) && then(s)[0] > s.x1; };
  claims.statement<OnChute>(
      "speed_increases", 1733, R"(On the center line the speed $|\dot x_1|$ and the position $x_1$ increase)",
      samples,
      {.printed = {R"(they increase, whatever $\dot x_1(0)$)", faster_and_farther},
       .corrected = {R"(the velocity $\dot x_1$ increases; $|\dot x_1|$ and $x_1$ do once $\dot x_1\ge0$)",
                     [=](S s) { return then(s)[1] > s.v1 && (s.v1 < 0 || faster_and_farther(s)); }},
       .in_view = {R"(for $\dot x_1(0)\ge0$, a ball let go or sent down)", [](S s) { return s.v1 >= 0; }},
       .near_misses = {{"the position $x_1$", [=](S s) { return then(s)[0] > s.x1; }}},
       .kind = Fault::left_out,
       .root = "a ball sent up",
       .why =
           R"(The next formula admits any $\dot x_1(0)$. A ball sent up the chute first slows down, and its )"
           R"($x_1$ decreases. It is back at its start at $t=-4\dot x_1(0)/(g\sin2\theta)$. The velocity )"
           R"($\dot x_1$ increases from the start.)"});

  const auto steeper = [](double s) { return s + 0.2 * (pi / 2 - s); };
  const auto changes = [=](S s) { return s.at_angle(steeper(s.theta())) - s.at_angle(s.theta()); };
  claims.statement<OnChute>(
      "steeper_is_faster", 1737,
      R"(On the center line the acceleration $\ddot x_1$ increases with the angle $\theta$)", samples,
      {.printed = {R"(it increases with $\theta$)", [=](S s) { return changes(s) > 0; }},
       .corrected =
           {R"($\ddot x_1$ increases up to $45^\circ$ and decreases beyond; the acceleration along the )"
            "chute increases",
            [=](S s) {
              const double theta = s.theta(), more = steeper(theta), turn = pi / 4;
              return (theta >= turn ? changes(s) < 0 : more > turn || changes(s) > 0) &&
                     s.at_angle(more) / cos(more) > s.at_angle(theta) / cos(theta);
            }},
       .near_misses = {{R"($\ddot x_1$ increases up to $60^\circ$)",
                        [=](S s) { return steeper(s.theta()) > pi / 3 || changes(s) > 0; }}},
       .kind = Fault::counterexample,
       .root = "beyond 45 degrees",
       .why =
           R"($\ddot x_1=\frac g2\sin2\theta$ is largest at $45^\circ$, $g/2$, and falls to zero at $90^\circ$: )"
           R"(in free fall nothing moves sideways. The acceleration along the chute grows with the )"
           R"(angle: it is $g\sin\theta$, of which $\ddot x_1$ is the horizontal part.)"});

  const auto slowed = [&](std::string text, double across) -> Reading {
    return {std::move(text),
            {compare<OnChute>(R"($(\ddot x_1,\ddot x_2)$)",
                              {"the equations without friction, less its terms",
                               [=](S s) {
                                 const Value a = s.published(s.v2 * s.v2, s.slope());
                                 return values(a[0] - s.k * s.v1, a[1] - across * s.k * s.v2);
                               }},
                              {R"(Lagrange's equations, friction $-k\dot x$ in space)",
                               [](S s) { return s.accelerations(s.k); }},
                              samples)}};
  };
  Reading corrected = slowed(R"($\ddot x_2=Sx_2-k\dot x_2$, $k$ the friction over the mass)", 1);
  corrected.checks.insert(corrected.checks.begin(),
                          compare<OnChute>(R"($\ddot x_2$ at $x_2=0$, $\dot x_2\ne0$)",
                                           {R"($-k\dot x_2$)", [](S s) { return -s.k * s.v2; }},
                                           {"Lagrange's equations with friction",
                                            [](OnChute s) {
                                              s.x2 = 0;
                                              return s.accelerations(s.k)[1];
                                            },
                                            [](S s) { return size_of(s.accelerations(s.k)); }},
                                           samples));
  claims.add(
      "friction_form", 1739,
      R"(With viscous friction the second equation is still $\ddot x_2=Sx_2$, $S$ a scalar)",
      {.printed = {R"($\ddot x_2=Sx_2$, which is zero wherever $x_2=0$)",
                   {vanishes(R"($\ddot x_2$ at $x_2=0$, $\dot x_2\ne0$)",
                             "Lagrange's equations with friction", samples,
                             [](OnChute s) {
                               s.x2 = 0;
                               const Value a = s.accelerations(s.k);
                               return std::pair(a[1], size_of(a));
                             })}},
       .corrected = corrected,
       .near_misses = {slowed(R"(it is $\ddot x_2=Sx_2-2k\dot x_2$)", 2)},
       .why =
           R"(Friction adds $-k\dot x_2$, a term without $x_2$. Where the ball crosses the center line the )"
           R"(printed form gives $\ddot x_2=0$, but friction slows the ball. In the corrected equation $S$ is )"
           R"(the same as without friction.)",
       .kind = Fault::formula,
       .root = "friction across"});
  claims.add("friction_center", 1739,
             "With viscous friction $x_2(t)=0$ is still a solution, and the ball stays in the center",
             {.printed = at_rest(R"($\ddot x_2=0$ at $x_2=\dot x_2=0$ with friction)", 0, 0, 1),
              .near_misses = {at_rest("with friction and a wind across", 0, 0.1, 1)}});
}

namespace {

void geometry(Claims& all, CylinderTable& about_axis, ChuteTable& chute, ChuteTable& placed,
              const std::vector<OnCylinder>& points, const std::vector<OnChute>& samples) {
  cylinder(about_axis, points);
  axis(chute, samples);
  solved(chute, samples);
  std::vector<OnChute> points_of_chute;
  for (const OnChute& s : samples) points_of_chute.push_back(s.placed());
  on_the_chute(placed, points_of_chute);
  derivatives(all, chute, samples);
  center_motion(chute, samples);
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims all("3.13");
  CylinderTable about_axis(all);
  ChuteTable chute(all), placed(all);
  const auto samples = draw<OnChute>(200, seed);
  geometry(all, about_axis, chute, placed, draw<OnCylinder>(200, seed), samples);
  equations(all, samples);
  statements(all, samples);
  return all.in_order();
}

namespace {

/// The axis' direction D, U and the direction W to the point are unit vectors; U and W are perpendicular to
/// D.
ForAll<OnCylinderOf> any_cylinder() {
  const std::vector<std::string> names{"R",  "t",  "p1", "p2", "p3", "d1", "d2",
                                       "d3", "u1", "u2", "u3", "w1", "w2", "w3"};
  const auto vector = [](const std::string& letter) {
    const auto x = [&](const char* i) { return Shortened::letter(letter + i); };
    return Three<Shortened>{x("1"), x("2"), x("3")};
  };
  const auto W = vector("w");
  OnCylinderOf<Shortened> any;
  any.R = Shortened::letter("R");
  any.t = Shortened::letter("t");
  any.P = vector("p");
  any.D = vector("d");
  any.U = vector("u");
  any.V = cross(any.D, any.U);
  any.Y = sum(sum({}, any.D, any.t), W, any.R);
  any.X = sum(any.P, any.Y);
  ForAll<OnCylinderOf> all{.any = any,
                           .letters = quantified(names),
                           .tactic = "on_cylinder",
                           .says = "it holds for every point of every cylinder"};
  const auto product = [](const auto& a, const auto& b, double is) {
    return dot(a, b).expression() == Expression(is);
  };
  all.given = {product(any.D, any.D, 1), product(any.U, any.U, 1), product(W, W, 1), product(any.U, any.D, 0),
               product(W, any.D, 0)};
  return all;
}

ForAll<OnChuteOf> any_chute() {
  const std::vector<std::string> names{"r", "L", "H", "g", "x1", "x2", "x3", "v1", "v2", "k", "phi", "way"};
  ForAll<OnChuteOf> all{.any = lettered<OnChuteOf>(names),
                        .letters = quantified(names),
                        .tactic = "on_chute",
                        .says = "it holds for every chute that is neither level nor vertical"};
  const auto& [R, L, H] = all.any.chute;
  for (const Shortened& x : {R, H, L - H, R * R - all.any.x2 * all.any.x2, cos(all.any.phi), all.any.g})
    all.given.push_back(above(x.expression(), 0));
  double x = 0.25;
  for (double* letter : all.example.letters()) *letter = x += 0.25;
  all.example.chute = {2, 5, 3};
  return all;
}

Lemma lemma(std::string name, const ForAll<OnChuteOf>& all, const auto& left, const auto& right) {
  return {std::move(name), all.letters, all.given,
          equal(detail::recorded_value(left), detail::recorded_value(right)), all.tactic};
}
Provable provable(const std::string& slug, std::vector<Lemma> lemmas) {
  return {"3.13-" + slug, any_chute().says, std::move(lemmas)};
}

/// The derivatives of the slope along x1, by x1 and by x2, are zero.
Provables bends() {
  const ForAll<OnChuteOf> all = any_chute();
  const auto& s = all.any;
  const auto height = [&](const std::string& x1, const std::string& x2) {
    return s.chute.height(Shortened::letter(x1), Shortened::letter(x2)).expression().coq();
  };
  const auto slope_at = [&](const std::string& x1, const std::string& x2) {
    return "Derive (fun w => " + height("w", x2) + ") " + x1;
  };
  const std::string slope = s.slope().expression().coq();
  return {provable("h11_h12", {{"printed",
                                all.letters,
                                all.given,
                                {{slope_at("x1", "x2") + " = " + slope},
                                 {"Derive (fun z => " + slope_at("z", "x2") + ") x1 = 0"},
                                 {"Derive (fun z => " + slope_at("x1", "z") + ") x2 = 0"}},
                                "bends_of (fun x y => " + height("x", "y") + ") (" + slope + ") x1 x2"}})};
}

/// The printed formula at the example, with numbers for its letters.
Lemma printed_off(const ForAll<OnChuteOf>& all, const auto& printed, const auto& truth, double& margin) {
  OnChute s = all.example;
  OnChuteOf<Shortened> recorded;
  const auto numbers = s.letters();
  std::size_t i = 0;
  for (Shortened* letter : recorded.letters()) *letter = *numbers[i++];
  Value difference = printed(s);
  const Value right = truth(s);
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= right[k];
  return off_at(detail::recorded_value(printed(recorded)), detail::recorded_value(truth(recorded)),
                difference, margin);
}

Provables of_motion() {
  const ForAll<OnChuteOf> all = any_chute();
  const auto& s = all.any;
  const Two<Shortened> meant = s.published(s.v2 * s.v2, s.slope());
  Provable equations = provable("equations", {lemma("meant", all, meant, s.accelerations()),
                                              lemma("about_axis", all, meant, s.accelerations_about_axis())});
  equations.lemmas.push_back(printed_off(
      all, [](const auto& x) { return x.published(x.x2 * x.x2, -x.chute.H * x.chute.L * x.cosine()); },
      [](const auto& x) { return x.accelerations(); }, equations.margin));
  Provable friction = provable(
      "friction_form",
      {lemma("corrected", all, values(meant[0] - s.k * s.v1, meant[1] - s.k * s.v2), s.accelerations(s.k))});
  auto crossing = all;
  crossing.example.x2 = 0;
  friction.lemmas.push_back(printed_off(
      crossing,
      [](const auto& x) {
        return Two<std::decay_t<decltype(x.k)>>{x.accelerations(x.k)[0], 0};
      },
      [](const auto& x) { return x.accelerations(x.k); }, friction.margin));
  for (Provable* wrong : {&equations, &friction}) wrong->says += "; as printed it is off at an example";
  return {equations, friction};
}

Provables of_center() {
  ForAll<OnChuteOf> all = any_chute();
  const auto& s = all.any;
  const Shortened zero = 0;
  for (const Shortened& x : {s.x2, s.v2}) all.given.push_back(x.expression() == zero.expression());
  all.tactic = "subst; on_chute";
  auto elsewhere = s;
  elsewhere.x1 = s.x3;
  elsewhere.v1 = s.k;
  const auto tangent_form = [&](const Shortened& t) { return s.g * t / (1 + t * t); };
  const Shortened a = s.accelerations()[0];
  const Lemma positive{"positive", all.letters, all.given, {above(a.expression(), 0)}, "subst; slides_down"};
  Provable chain =
      provable("center_acceleration", {lemma("meant", all, s.g / 2 * sin(2 * s.theta()), a),
                                       lemma("by_slope", all, tangent_form(-s.slope()), a),
                                       lemma("by_tangent", all, tangent_form(tan(s.theta())), a)});
  auto centered = all;
  centered.example.x2 = centered.example.v2 = 0;
  chain.says += "; as printed it is off at an example";
  chain.lemmas.push_back(printed_off(
      centered, [](const auto& x) { return values(x.center_as_printed()); },
      [](const auto& x) { return values(x.accelerations()[0]); }, chain.margin));
  return {chain, provable("positive", {lemma("constant", all, a, elsewhere.accelerations()[0]), positive}),
          provable("x2_zero", {lemma("printed", all, s.accelerations()[1], zero)}),
          provable("friction_center", {lemma("printed", all, s.accelerations(s.k)[1], zero)})};
}

}  // namespace

/// Writes squares of texts as products.
constexpr const char* in_products = "rewrite <- ?Rsqr_pow2; unfold Rsqr; ";
/// Squares of the lengths of vectors.
constexpr const char* of_lengths =
    "rewrite ?pow2_sqrt by (repeat apply Rplus_le_le_0_compat; apply Rle_0_sqr); ";

/// At an example, for cosines of angles with known sines.
constexpr const char* by_bounds = "rewrite ?cos_asin by lra; unfold Rsqr; interval";

Provables proofs() {
  Claims claims("3.13");
  CylinderTable about_axis(claims);
  ChuteTable chute(claims), placed(claims);
  geometry(claims, about_axis, chute, placed, {}, {});
  ForAll<OnCylinderOf> any_point = any_cylinder();
  any_point.tactic = std::string(of_lengths) + in_products + any_point.tactic;
  ForAll<OnChuteOf> any_place = any_chute();
  any_place.tactic = in_products + any_place.tactic;
  ForAll<OnChuteOf> on_it = any_place;
  on_it.any = on_it.any.placed();
  Provables of_points = about_axis.proofs("3.13", any_point), of_chute = chute.proofs("3.13", any_place);
  for (const Provables& more : {placed.proofs("3.13", on_it), bends(), of_motion(), of_center()})
    of_chute.insert(of_chute.end(), more.begin(), more.end());
  for (Provable& proof : of_points) proof.preamble = cylinder_in_coq;
  for (Provable& proof : of_chute) {
    proof.preamble = chute_in_coq;
    if (proof.claim == "3.13-h1" || proof.claim == "3.13-h2") proof.lemmas.back().tactic = by_bounds;
  }
  std::ranges::move(of_chute, std::back_inserter(of_points));
  return of_points;
}

std::vector<Root> roots() {
  constexpr double g = 9.81, up = 0.8, steep = 75, low = 15, seconds = 1, k = 0.5, late = 10;
  const double a = g * 0.6 * 0.8;  // x1'' on the default chute's center line
  const auto covers = [](double degrees) { return g / 4 * sin(2 * degrees * pi / 180) * seconds * seconds; };
  return {
      {"a ball sent up",
       filled(
           R"(On the default chute's center line a ball with $\dot x_1(0)=@1$ m/s first climbs for @2 s, @1 cm along )"
           R"($x_1$, and is back at its start after @2 s.)",
           {-up, up / a, 100 * up * up / (2 * a), 2 * up / a})},
      {"beyond 45 degrees",
       filled(
           R"(Seen from above, as on a map of a game's level, the ball in a chute of $@2^\circ$ looks as slow as that )"
           R"(in one of $@2^\circ$. They cover @3 m and @3 m in the first @1 s.)",
           {steep, low, covers(steep), covers(low), seconds})},
      {"friction across",
       filled(
           R"(Programmed as $\ddot x_2=Sx_2$ with the $S$ of before, a ball swings across the chute for ever; with )"
           R"($k=@1$ s$^{-1}$ a small swing is down to @1 % after @2 s.)",
           {k, 100 * std::exp(-k / 2 * late), late})}};
}

}  // namespace oddity::ex03_13

namespace oddity {

Provables proofs_3_13() { return ex03_13::proofs(); }

}  // namespace oddity
