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
using std::abs, std::asin, std::atan, std::cos, std::hypot, std::pow, std::sin, std::sqrt, std::numbers::pi;
template <class T>
using Three = std::array<T, 3>;

inline Shortened asin(const Shortened& x) { return function("asin", x.expression()); }
inline Shortened atan(const Shortened& x) { return function("atan", x.expression()); }

template <class T>
Three<T> sum(const std::type_identity_t<Three<T>>& a, const Three<T>& b, std::type_identity_t<T> factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
template <class T>
Three<T> unit(const Three<T>& a) {
  return sum({}, a, 1 / sqrt(dot(a, a)));
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
  Letters<T> table() {
    return {{"R", R}, {"t", t}, {"P", P}, {"D", D}, {"U", U}, {"V", V}, {"X", X}, {"Y", Y}};
  }
  TypesetIn<T> typeset() const {
    return {{"I", {1, 0, 0, 0, 1, 0, 0, 0, 1}}, {"y_1", y1()}, {"y_2", y2()}, {"y_3", y3()}};
  }
  T y1() const { return dot(U, Y); }
  T y2() const { return dot(V, Y); }
  T y3() const { return dot(D, Y); }
};
using OnCylinder = OnCylinderOf<double>;

/// A chute, a position and a velocity in the plane, a friction, an angle, and a parameter t: a time, or a
/// distance along the axis.
template <class T>
struct OnChuteOf {
  Chute<T> chute;
  T g, x1, x2, x3, v1, v2, k, phi, t;

  OnChuteOf() = default;
  explicit OnChuteOf(Random& random) {
    for (const Letter<T>& letter : table())
      if (letter.first != &chute.H) *letter.first = letter.from.draw(random);
    x2 *= chute.R, chute.H = chute.L * sin(random.between(0.1, 1.4));
  }
  Letters<T> table() {
    return {{"R", chute.R, {0.5, 3}, "r"},
            {"L", chute.L, {2, 10}},
            {"H", chute.H},
            {"g", g, {0.5, 20}},
            {"x_1", x1, either_sign(0.05, 3)},
            {"x_2", x2, either_sign(0.05, 0.9)},
            {"x_3", x3, either_sign(0.05, 3)},
            {R"(\dot x_1)", v1, either_sign(0.05, 3), "v1"},
            {R"(\dot x_2)", v2, either_sign(0.05, 3), "v2"},
            {"k", k, {0.1, 2}},
            {R"(\phi)", phi, either_sign(0.05, 1.4)},
            {"t", t, either_sign(0.05, 3), "way"}};
  }
  T cosine() const { return sqrt(chute.L * chute.L - chute.H * chute.H) / chute.L; }
  T theta() const { return asin(chute.H / chute.L); }
  TypesetIn<T> typeset() const {
    return {{"S", ratio()},         {R"(\dot x_1(0))", v1},
            {"x_1(0)", x1},         {"I", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
            {"d_1", d1()},          {"h_{x_1x_1}", second(1, 1)},
            {"d_3", d3()},          {"h_{x_1x_2}", second(1, 2)},
            {"p_3", p3()},          {"h_{x_2x_2}", second(2, 2)},
            {"P", {0, 0, p3()}},    {R"(\ddot x_1)", accelerations()[0]},
            {"D", {d1(), 0, d3()}}, {R"(\ddot x_2)", accelerations()[1]},
            {R"(\theta)", theta()}};
  }
  std::string where() const {
    return filled(R"($\theta$ = @4, $R$ = @4, $x_2$ = @4, $v$ = (@4, @4))", {theta(), chute.R, x2, v1, v2});
  }
  /// The slope of the height in a direction, by dual numbers.
  T slope(const T& along1, const T& along2) const {
    return chute.height(Dual<T>(x1, along1), Dual<T>(x2, along2)).slope;
  }
  /// (x1'', x2'') from the Lagrangian of the height, with friction and a side wind per mass.
  Two<T> accelerations(const T& friction = 0, const T& wind = 0) const {
    const T n1 = slope(T(1), T(0)), n2 = slope(T(0), T(1)), rise = slope(v1, v2);
    const Two<T> force{-friction * (v1 + n1 * rise), wind - friction * (v2 + n2 * rise)};
    return lagrange_accelerations(height_field::Lagrangian<Chute<T>, T>{chute, g}, Two<T>{x1, x2}, {v1, v2},
                                  force);
  }
  /// (x1'', x2'') without forces, from the Lagrangian in the distance along the axis and the angle about it.
  Two<T> accelerations_about_axis() const {
    const T angle = asin(x2 / chute.R), turning = v2 / (chute.R * cos(angle));
    const T along = (x1 - chute.R * (1 - cos(angle)) * chute.s()) / chute.c();
    const T speed = (v1 - chute.R * sin(angle) * turning * chute.s()) / chute.c();
    const auto lagrangian = [&]<class X>(const Two<X>& q, const Two<X>& v) {
      const auto x = chute.position(Dual<X>(q[0], v[0]), Dual<X>(q[1], v[1]));
      return X(0.5) * (x[0].slope * x[0].slope + x[1].slope * x[1].slope + x[2].slope * x[2].slope) -
             X(g) * x[2].value;
    };
    const Two<T> a = lagrange_accelerations(lagrangian, Two<T>{along, angle}, {speed, turning});
    const auto x = [&](std::size_t i) {
      return [&, i](const auto& time) {
        return chute.position(along + speed * time + 0.5 * a[0] * time * time,
                              angle + turning * time + 0.5 * a[1] * time * time)[i];
      };
    };
    return {second_derivative(x(0), T(0)), second_derivative(x(1), T(0))};
  }

  T d1() const { return -cosine(); }
  T d3() const { return chute.H / chute.L; }
  T p3() const { return chute.R / cosine(); }
  /// The cylinder's equation at any point, with the matrix written out: left side minus right side.
  T excess() const {
    const Three<T> y{x1, x2, x3 - p3()}, d{d1(), 0, d3()};
    T total = -chute.R * chute.R;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) total += y[i] * ((i == j ? 1.0 : 0.0) - d[i] * d[j]) * y[j];
    return total;
  }
  /// A point of the chute's half of the cylinder, or, rotated by pi, of the other half.
  Three<T> on_it(bool other_half = false) const {
    return chute.position(t, other_half ? phi + pi_of<T>() : phi);
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
  /// Ratio of x2'' to x2 in the published equation without friction.
  T ratio() const {
    const T c = cosine(), r = sqrt(chute.R * chute.R - x2 * x2), tangent = chute.H / (chute.L * c);
    return -(chute.R * chute.R * v2 * v2 / (r * r * r * c) + g) /
           ((1 + tangent * tangent + x2 * x2 / (r * r * c * c)) * r * c);
  }
  T bracket(const Three<T>& x) const { return d1() * (x[2] - p3()) - d3() * x[0]; }
};
using OnChute = OnChuteOf<double>;

using CylinderTable = ProvableClaims<OnCylinderOf>;
using ChuteTable = ProvableClaims<OnChuteOf>;
using Form = ProvableFormula<OnChuteOf>;

// ---- the cylinder -----------------------------------------------------------------------------------------

void cylinder(CylinderTable& table, const std::vector<OnCylinder>& samples) {
  const auto claim = table.over(samples);
  const ProvableFormula<OnCylinderOf> square{"$R^2$, the point having been put $R$ from the axis",
                                             [](const auto& s) { return s.R * s.R; }};
  const auto across = [](const auto& s) { return sum(sum({}, s.U, s.y1()), s.V, s.y2()); };

  claim("cylinder", 1587,
        "The cylinder of radius $R$ about the line $P+tD$, $|D|=1$, is $(X-P)^T(I-DD^T)(X-P)=R^2$", square,
        "$(X-P)^T(I-DD^T)(X-P)$");
  claim("coordinates", 1595,
        R"($X=P+y_1U+y_2V+y_3D$ with $y_1=U\cdot(X-P)$, $y_2=V\cdot(X-P)$, $y_3=D\cdot(X-P)$, where $U$, )"
        R"($V$, $D$ are orthonormal)",
        {"$X$", [](const auto& s) { return s.X; }}, R"($P+(U\cdot(X-P))U+(V\cdot(X-P))V+(D\cdot(X-P))D$)");
  claim("distance", 1597, "A point of the cylinder has $y_1^2+y_2^2=R^2$", square, "$y_1^2+y_2^2$");
  claim.equation("perpendicular", 1599, R"($y_1U+y_2V=(X-P)-(D\cdot(X-P))D$)",
                 {"the sum of the two", across});
  claim.equation("squared_left", 1601, "$|y_1U+y_2V|^2=y_1^2+y_2^2$",
                 {"the vector's square", [=](const auto& s) { return dot(across(s), across(s)); }});

  const auto row = [&](std::string_view slug, int line, const std::string& text,
                       const std::string& changes_that_hold = {}) {
    claim(slug, line, "On the cylinder $R^2=" + text.substr(1), square, text, {}, changes_that_hold);
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
  const auto claim = table.over(samples);
  claim("triangle", 1617,
        R"(The axis has the length $L$: where $x_3$ rises by $H$, $x_1$ falls by $L\cos\theta$)",
        {R"($L$ and $L\sin\theta$)",
         [](const auto& s) { return values(s.chute.L, s.chute.L * sin(s.theta())); }},
        R"($(\sqrt{(L\cos\theta)^2+H^2},\ H)$)", "hypotenuse and opposite side");
  claim("adjacent", 1619, R"(The adjacent side of the triangle is $\sqrt{L^2-H^2}$)",
        {R"($L\cos\theta$)", [](const auto& s) { return s.chute.L * cos(s.theta()); }},
        R"($\sqrt{L^2-H^2}$)");
  claim.equation("cosine", 1621, R"($\cos\theta=\sqrt{L^2-H^2}/L$)",
                 {R"($\cos(\sin^{-1}(H/L))$)", [](const auto& s) { return cos(s.theta()); }});
  const auto run = [](const auto& s) { return sqrt((s.chute.L - s.chute.H) * (s.chute.L + s.chute.H)); };
  claim.equation("sine", 1621, R"($\sin\theta=H/L$)",
                 {"the angle between the chute and the plane",
                  [=](const auto& s) { return sin(atan(s.chute.H / run(s))); }});
  claim("direction", 1623, R"(The unit vector up the axis is $D=(-\cos\theta,0,\sin\theta)$)",
        {R"($(-\sqrt{L^2-H^2},0,H)$, normalized)",
         [=]<class T>(const OnChuteOf<T>& s) {
           return unit<T>({-run(s), 0, s.chute.H});
         }},
        R"($(-\cos\theta,0,\sin\theta)$)");
  claim("axis_point", 1631,
        R"(The axis passes at $(0,0,\alpha)$ over the origin, where $\alpha=R/\cos\theta$)",
        {"$R$", [](const auto& s) { return s.chute.R; }},
        R"($|(0,0,\frac{R}{\cos\theta})\times(-\cos\theta,0,\sin\theta)|$)",
        R"(the origin's distance $|(0,0,p_3)\times D|$ from the axis)");
}

// ---- the cylinder solved for x3 ---------------------------------------------------------------------------

void solved(ChuteTable& table, const std::vector<OnChute>& samples) {
  const auto claim = table.over(samples);
  const auto expansion = [&](std::string_view slug, int line, const std::string& printed,
                             const std::string& as = {}, const std::string& meant = {},
                             const std::string& why = {}) {
    claim(slug, line, "On the cylinder $0=" + printed.substr(1) + as,
          {.quantity = "the expression that is zero on the cylinder about the axis through $(0,0,p_3)$ along "
                       "$(d_1,0,d_3)$",
           .truth = {"$(X-P)^T(I-DD^T)(X-P)-R^2$ at any point", [](const auto& s) { return s.excess(); }},
           .printed = printed,
           .meant = meant,
           .kind = meant.empty() ? Fault::none : Fault::formula,
           .why = why});
  };
  const std::string of_axis = "$x_1^2+x_2^2+(x_3-p_3)^2-(d_1x_1+d_3(x_3-p_3))^2",
                    rest = "(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+(1-d_1^2)x_1^2+x_2^2-R^2$";
  expansion("expansion_1", 1637, of_axis + "$", "", of_axis + "-R^2$",
            "The term $-R^2$, there in the lines before and after, is left out: so read it is the axis alone "
            "that satisfies the equation.");
  expansion(
      "expansion_2", 1639, "$(1-d_3)^2" + rest, "", "$(1-d_3^2)" + rest,
      filled("The square belongs to $d_3$: $(1-d_3^2)$, which the next line writes as $d_1^2$. With the "
             "default chute, $d_3=3/5$, that is @2, and as printed @2.",
             {1 - 0.36, 0.4 * 0.4}));
  expansion("expansion_3", 1641, "$d_1^2(x_3-p_3)^2-2d_1d_3x_1(x_3-p_3)+d_3^2x_1^2+x_2^2-R^2$",
            ", as $d_1^2+d_3^2=1$");
  expansion("expansion_4", 1643, "$(d_1(x_3-p_3)-d_3x_1)^2+x_2^2-R^2$");

  const std::string bracket = "$d_1(x_3-p_3)-d_3x_1$ at the origin";
  const Form at_origin{"the bracket at $x_1=x_3=0$", [](const auto& s) { return s.bracket({0, 0, 0}); }};
  claim("origin", 1649, "The origin is on the cylinder",
        {"$R^2$", [](const auto& s) { return s.chute.R * s.chute.R; }}, "$(-P)^T(I-DD^T)(-P)$",
        "$(X-P)^T(I-DD^T)(X-P)$ at $X=0$");
  claim("at_origin", 1651, R"(At the origin the left side is $\cos\theta\,(R/\cos\theta)=-d_1p_3=R$)",
        at_origin, R"($(\cos\theta\,(R/\cos\theta),\ -d_1p_3,\ R)$)", bracket);
  claim("plus", 1653, "At the origin the root has the plus sign", at_origin, R"($+\sqrt{R^2-0}$)", bracket);
}

/// Claims about points on the chute.
void on_the_chute(ChuteTable& table, const std::vector<OnChute>& samples) {
  const auto claim = table.over(samples);
  claim("two_roots", 1647,
        R"($d_1(x_3-p_3)-d_3x_1=\pm\sqrt{R^2-x_2^2}$ (our check: the lower half has plus, the upper minus))",
        {"points of the lower half and of the upper, turned about the axis",
         [](const auto& s) { return values(s.bracket(s.on_it()), s.bracket(s.on_it(true))); }},
        R"($(\sqrt{R^2-x_2^2},\ -\sqrt{R^2-x_2^2})$)");
  claim(
      "chute", 1655, R"(The chute is $d_1(x_3-p_3)-d_3x_1=+\sqrt{R^2-x_2^2}$)",
      {"points of the lower half, turned about the axis", [](const auto& s) { return s.bracket(s.on_it()); }},
      R"($\sqrt{R^2-x_2^2}$)");
  const Form x3{"$x_3$ of a point turned about the axis", [](const auto& s) { return s.on_it()[2]; }};
  claim("solved", 1659, R"(Solved for $x_3$: $x_3=p_3+(d_3x_1+\sqrt{R^2-x_2^2})/d_1$)", x3,
        R"($p_3+(d_3x_1+\sqrt{R^2-x_2^2})/d_1$)");
  claim("height", 1663,
        R"(The height of the chute is $h(x_1,x_2)=(LR-Hx_1-L\sqrt{R^2-x_2^2})/(L\cos\theta)$)", x3,
        R"($(LR-Hx_1-L\sqrt{R^2-x_2^2})/(L\cos\theta)$)");
}

// ---- the height's derivatives -----------------------------------------------------------------------------

void derivatives(Claims& claims, ChuteTable& table, const std::vector<OnChute>& samples) {
  const auto claim = table.over(samples);
  claim("h1", 1673, R"(The derivative $h_{x_1}$ is $-H/(L\cos\theta)$)",
        {.truth = {"$h$ by dual numbers", [](const auto& s) { return s.slope(1, 0); }},
         .printed = R"($-HL\cos\theta$)",
         .meant = R"($-H/(L\cos\theta)$)",
         .why = filled(
             "The fraction's bar is lost. For the default chute the quotient is $@2$, and the product $@2$.",
             {-3.0 / (5 * 0.8), -3.0 * 5 * 0.8})});
  claim(
      "h2", 1677, R"(The derivative $h_{x_2}$ is $x_2/\big((R^2-x_2^2)^{1/2}\cos\theta\big)$)",
      {.truth = {"$h$ by dual numbers", [](const auto& s) { return s.slope(0, 1); }},
       .printed = R"($x_2(R^2-x_2^2)^{1/2}\cos\theta$)",
       .meant = R"($x_2/\big((R^2-x_2^2)^{1/2}\cos\theta\big)$)",
       .why =
           "The fraction's bar is lost. Towards the rim this slope becomes infinite, and the product zero."});
  claims.statement<OnChute>("h11_h12", 1679, "$h_{x_1x_1}=h_{x_1x_2}=0$", samples,
                            {.printed = {"$h_{x_1x_1}=h_{x_1x_2}=0$"}, .near_misses = {{"$h_{x_2x_2}=0$"}}});
  claim.equation("h22", 1681, R"($h_{x_2x_2}=R^2/\big((R^2-x_2^2)^{3/2}\cos\theta\big)$)",
                 {"$h$ by nested dual numbers", [](const auto& s) { return s.second(2, 2); }});
}

// ---- the equations of motion ------------------------------------------------------------------------------

/// The equations of motion, with a square in the numerator and the slope along x1.
std::string equations(const std::string& square, const std::string& slope) {
  return R"($-\frac{R^2)" + square +
         R"(/\left((R^2-x_2^2)^{3/2}\cos\theta\right)+g}{1+H^2/(L^2\cos^2\theta)+x_2^2/\left((R^2-x_2^2)\cos^2\theta\right)}\left()" +
         slope + R"(,\ \frac{x_2}{(R^2-x_2^2)^{1/2}\cos\theta}\right)$)";
}
const std::string equations_meant = equations(R"(\dot x_2^2)", R"(-\frac{H}{L\cos\theta})");

void motion(ChuteTable& table, const std::vector<OnChute>& samples) {
  table.over(samples)(
      "equations", 1691, R"(The equations of motion are $(\ddot x_1,\ddot x_2)=)" + equations_meant.substr(1),
      {.truth = {"Lagrange's equations by nested dual numbers",
                 [](const auto& s) { return s.accelerations(); }},
       .other_routes = {{"Lagrange's equations along and about the axis, mapped by dual numbers",
                         [](const OnChute& s) { return s.accelerations_about_axis(); }}},
       .printed = equations("x_2^2", R"(-HL\cos\theta)"),
       .meant = equations_meant,
       .why =
           R"(A dot and a bar are lost: the numerator has $R^2\dot x_2^2$, and the vector is the gradient )"
           R"($(-H/(L\cos\theta),\,x_2/((R^2-x_2^2)^{1/2}\cos\theta))$. So read, it follows from Lagrange's )"
           R"(equations, in the coordinates of the plane and in those of the cylinder.)"});
}

/// A component of Lagrange's accelerations, with `friction` times the sample's.
Form lagrange(std::size_t i, double friction = 0) {
  return {"Lagrange's equations", [=](const auto& s) { return s.accelerations(friction * s.k)[i]; },
          [=](const OnChute& s) { return size_of(s.accelerations(friction * s.k)); }};
}

/// Claims about a ball on the center line without speed across.
void center(ChuteTable& table, const std::vector<OnChute>& samples) {
  const auto claim = table.over(samples);
  const auto forms = [](const std::string& numerator) {
    return R"($\left(\frac{)" + numerator +
           R"(}{1+H^2/(L^2\cos^2\theta)},\ \frac{g\tan\theta}{1+\tan^2\theta},\ \frac g2\sin2\theta\right)$)";
  };
  claim("x2_zero", 1715, "$x_2(t)=0$ for all time solves the second equation of motion",
        {.quantity = R"($\ddot x_2$ at $x_2=\dot x_2=0$)",
         .truth = lagrange(1),
         .printed = R"($\ddot x_2=0$)",
         .near_misses = {{R"($\ddot x_2$ at $x_2=0.05$, $\dot x_2=0$)", [](OnChute s) {
                            s.x2 = 0.05;
                            return s.accelerations()[1];
                          }}}});
  claim(
      "center_acceleration", 1717,
      R"(On the center line $\ddot x_1=\frac{gt}{1+t^2}=\frac{g\tan\theta}{1+\tan^2\theta}=\frac g2\sin2\theta$, )"
      R"($t=\frac H{L\cos\theta}$)",
      {.truth = lagrange(0),
       .printed = forms(R"(gHL\cos\theta)"),
       .meant = forms(R"(gH/(L\cos\theta))"),
       .why = filled(
           R"(The bar of the numerator, $H/(L\cos\theta)$, is lost; that of the denominator is there. For the )"
           R"(default chute the numerator is @2 and its product @2: @2 m/s$^2$ for @3.)",
           {0.75, 12, 9.81 * 12 / (1 + 0.75 * 0.75), 9.81 * 0.75 / (1 + 0.75 * 0.75)})});
  claim("center_motion", 1735, R"(On the center line $x_1(t)=x_1(0)+\dot x_1(0)t+\frac{g\sin2\theta}4t^2$)",
        {"the constant acceleration by Lagrange's equations",
         [](const auto& s) { return s.x1 + s.v1 * s.t + s.accelerations()[0] * s.t * s.t / 2; }},
        R"($x_1(0)+\dot x_1(0)t+\frac{g\sin2\theta}4t^2$)");
  claim("friction_center", 1739,
        "With viscous friction $x_2(t)=0$ is still a solution, and the ball stays in the center",
        {.quantity = R"($\ddot x_2$ at $x_2=\dot x_2=0$ with friction)",
         .truth = lagrange(1, 1),
         .printed = R"($\ddot x_2=0$)",
         .near_misses = {{"with friction and a wind across",
                          [](const OnChute& s) { return s.accelerations(s.k, 0.1)[1]; }}}});
}

/// Claims about a ball that crosses the center line with friction.
void crossing(ChuteTable& table, const std::vector<OnChute>& samples) {
  table.over(samples)(
      "friction_form", 1739,
      R"(With viscous friction the second equation is still $\ddot x_2=Sx_2$, $S$ a scalar)",
      {.truth = lagrange(1, 1),
       .printed = R"($\ddot x_2=Sx_2$)",
       .corrected = R"($\ddot x_2=Sx_2-k\dot x_2$)",
       .root = "friction across",
       .why =
           R"(Friction adds $-k\dot x_2$, a term without $x_2$. Where the ball crosses the center line the )"
           R"(printed form gives $\ddot x_2=0$, but friction slows the ball. In the corrected equation $S$ is )"
           R"(the same as without friction, and $k$ is the friction over the mass.)"});
}

// ---- statements about the motion --------------------------------------------------------------------------

void statements(Claims& claims, const std::vector<OnChute>& samples) {
  using S = const OnChute&;
  const auto claim = claims.over(samples);
  const auto after_a_second = [](S s, double across) {
    const InPlane<double> ball{s.chute, s.g, {s.x1, 0, s.v1, across}};
    return values(ode::integrate<ode::Fehlberg78>(ball, ball.start(), 0, 1, 1e-10).value[1]);
  };
  claims.formula<OnChute>(
      "stays_in_center", 1715, "A ball that starts in the center without speed across stays in the center",
      {samples.begin(), samples.begin() + 20},
      {.quantity = "$x_2$ after 1 s",
       .truth = {"Fehlberg 7(8) on the height field", [=](S s) { return after_a_second(s, 0); },
                 [](S s) { return s.chute.R; }},
       .printed = {"$x_2=0$"},
       .near_misses = {{"with speed across as well", [=](S s) { return after_a_second(s, 0.01); }}}});

  const auto elsewhere = [](const std::string& text, double moved) -> Formula<OnChute> {
    return {R"($\ddot x_1$ at another place and speed, and that it is positive, )" + text, [=](S s) {
              OnChute other = s.on_center();
              other.x1 = 1 - s.x1, other.x2 = moved * s.x2, other.v1 = 2 - s.v1;
              return values(other.accelerations()[0], 1);
            }};
  };
  claim("positive", 1733, R"(On the center line $\ddot x_1$ is a positive constant)",
        {.quantity = R"($\ddot x_1$, and whether it is positive)",
         .truth = {"at one place and speed",
                   [](S s) {
                     const double a = s.on_center().accelerations()[0];
                     return values(a, a > 0);
                   }},
         .printed = elsewhere("in a chute neither level nor vertical (our condition)", 0),
         .near_misses = {elsewhere("off the center line as well", 1)}});
  claims.statement<OnChute>("always_positive", 1733,
                            R"(The acceleration along $x_1$ is always positive: $\ddot x_1>0$)", samples,
                            {.printed = {R"($\ddot x_1>0$)"}, .near_misses = {{R"($\ddot x_2>0$)"}}});

  std::vector<OnChute> centered;
  for (S s : samples) centered.push_back(s.on_center());
  claims.statement<OnChute>(
      "speed_increases", 1733, R"(On the center line the speed $|\dot x_1|$ and the position $x_1$ increase)",
      centered,
      {.printed = {R"($(\frac{d}{dt}|\dot x_1|,\ \dot x_1)>0$)"},
       .corrected = {R"($\ddot x_1>0$)"},
       .in_view = {R"(for $\dot x_1(0)\ge0$, a ball let go or sent down)", [](S s) { return s.v1 >= 0; }},
       .near_misses = {{R"($\dot x_1>0$)"}},
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
}

namespace {

/// The tables, which are by the points that they are about.
struct Tables {
  CylinderTable about_axis;
  ChuteTable chute, placed, centered, crossed;

  Tables(Claims& all, const std::vector<OnCylinder>& points, const std::vector<OnChute>& samples)
      : about_axis(all), chute(all), placed(all), centered(all), crossed(all) {
    std::vector<OnChute> on_chute, on_center, at_times_on_center = samples;
    for (const OnChute& s : samples) on_chute.push_back(s.placed()), on_center.push_back(s.on_center());
    for (std::size_t i = 0; i < samples.size(); i += 2) at_times_on_center[i].x2 = 0;
    cylinder(about_axis, points);
    axis(chute, samples);
    solved(chute, samples);
    on_the_chute(placed, on_chute);
    derivatives(all, chute, samples);
    motion(chute, samples);
    center(centered, on_center);
    crossing(crossed, at_times_on_center);
  }
};

/// Writes squares of texts as products.
const std::string in_products = "rewrite <- ?Rsqr_pow2; unfold Rsqr; ";
/// Squares of the lengths of vectors.
const std::string of_lengths = "rewrite ?pow2_sqrt by (repeat apply Rplus_le_le_0_compat; apply Rle_0_sqr); ";

/// The axis' direction D, U and the direction W to the point are unit vectors; U and W are perpendicular to
/// D.
ForAll<OnCylinderOf> any_cylinder() {
  const auto vector = [letter = Shortened::letter](const std::string& x) {
    return Three<Shortened>{letter(x + "1"), letter(x + "2"), letter(x + "3")};
  };
  const auto product = [](const auto& a, const auto& b, double is) { return dot(a, b).expression() == is; };
  const auto P = vector("p"), D = vector("d"), U = vector("u"), W = vector("w");
  OnCylinderOf<Shortened> any;
  any.R = Shortened::letter("R"), any.t = Shortened::letter("t"), any.P = P, any.D = D, any.U = U;
  any.V = cross(D, U);
  any.Y = sum(sum({}, D, any.t), W, any.R);
  any.X = sum(P, any.Y);
  return {.any = any,
          .letters = "(R t p1 p2 p3 d1 d2 d3 u1 u2 u3 w1 w2 w3 : R)",
          .given = {product(D, D, 1), product(U, U, 1), product(W, W, 1), product(U, D, 0), product(W, D, 0)},
          .tactic = of_lengths + in_products + "on_cylinder",
          .says = "it holds for every point of every cylinder",
          .preamble = coq_source({"cylinder"})};
}

ForAll<OnChuteOf> any_chute() {
  auto all = for_all<OnChuteOf>(in_products + "on_chute",
                                "it holds for every chute that is neither level nor vertical",
                                {2, 5, 3, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 2.75, 3, 3.25});
  const auto& [R, L, H] = all.any.chute;
  all.given = positive({R, H, L - H, R * R - all.any.x2 * all.any.x2, cos(all.any.phi), all.any.g});
  all.preamble = coq_source({"chute"});
  return all;
}

Lemma lemma(std::string name, const ForAll<OnChuteOf>& all, const auto& left, const auto& right) {
  return {std::move(name), all.letters, all.given,
          equal(detail::recorded_value(left), detail::recorded_value(right)), all.tactic};
}
Provable provable(const std::string& slug, const ForAll<OnChuteOf>& all, std::vector<Lemma> lemmas) {
  return {.claim = "3.13-" + slug, .says = all.says, .lemmas = std::move(lemmas), .preamble = all.preamble};
}

/// The derivatives of the slope along x1, by x1 and by x2, are zero.
Provable bends(const ForAll<OnChuteOf>& all) {
  const auto& s = all.any;
  const auto height = [&](const std::string& x1, const std::string& x2) {
    return s.chute.height(Shortened::letter(x1), Shortened::letter(x2)).expression().coq();
  };
  const auto slope_at = [&](const std::string& x1, const std::string& x2) {
    return "Derive (fun w => " + height("w", x2) + ") " + x1;
  };
  const std::string slope = (-s.chute.H / (s.chute.L * s.cosine())).expression().coq();
  return provable("h11_h12", all,
                  {{"printed",
                    all.letters,
                    all.given,
                    {{slope_at("x1", "x2") + " = " + slope},
                     {"Derive (fun z => " + slope_at("z", "x2") + ") x1 = 0"},
                     {"Derive (fun z => " + slope_at("x1", "z") + ") x2 = 0"}},
                    "bends_of (fun x y => " + height("x", "y") + ") (" + slope + ") x1 x2"}});
}

/// On the center line the acceleration is the same at another place and speed, and positive.
Provable of_positive(const ForAll<OnChuteOf>& all) {
  auto elsewhere = all.any;
  elsewhere.x1 = all.any.x3, elsewhere.v1 = all.any.k;
  const Shortened a = all.any.accelerations()[0];
  return provable("positive", all,
                  {lemma("constant", all, a, elsewhere.accelerations()[0]),
                   {"positive", all.letters, all.given, {above(a.expression(), 0)}, "subst; slides_down"}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims all("3.13");
  const auto samples = draw<OnChute>(200, seed);
  Tables(all, draw<OnCylinder>(200, seed), samples);
  statements(all, samples);
  return all.in_order();
}

Provables proofs() {
  Claims claims("3.13");
  const Tables tables(claims, {}, {});
  const ForAll<OnChuteOf> any_place = any_chute();
  ForAll<OnChuteOf> on_it = any_place, on_center = any_place, crossing = any_place;
  on_it.any = on_it.any.placed();
  for (const Shortened& x : {on_center.any.x2, on_center.any.v2})
    on_center.given.push_back(x.expression() == 0);
  on_center.tactic = "subst; " + on_center.tactic;
  on_center.example = on_center.example.on_center();
  crossing.example.x2 = 0;
  Provables all = tables.about_axis.proofs("3.13", any_cylinder());
  append(all, tables.chute.proofs("3.13", any_place));
  append(all, tables.placed.proofs("3.13", on_it));
  append(all, tables.centered.proofs("3.13", on_center));
  append(all, tables.crossed.proofs("3.13", crossing));
  append(all, {bends(any_place), of_positive(on_center)});
  std::vector<Lemma>& motion = proof_of(all, "3.13-equations").lemmas;
  motion.insert(motion.begin() + 1,
                lemma("about_axis", any_place, Form(equations_meant).recorded(any_place.any),
                      any_place.any.accelerations_about_axis()));
  for (Provable& proof : all)  // cosines of angles with known sines
    if (Lemma& last = proof.lemmas.back(); last.tactic == "interval")
      last.tactic = "rewrite ?cos_asin by lra; unfold Rsqr; interval";
  return all;
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
