// Exercise 3.1: the orbit r = e rho / (1 + e cos theta), focus at the origin, is an ellipse:
//   (x + c)^2/a^2 + y^2/b^2 = 1,   a = e rho/(1 - e^2),   b = a sqrt(1 - e^2),   c = a e.

#include <cmath>

#include "chapters/03_rigid_body_motion/01_polar_orbit/polar_orbit.hpp"
#include "reference/reference.hpp"

namespace oddity {

namespace ex03_01 {

using std::cos, std::sin, std::sqrt;

constexpr Parameter parameters[] = {
    {"e", 0.625, "", "eccentricity; from 1 on the orbit is open", 1e-3, 1.25},
    {"rho", 1.5, "", "distance from the focus to the directrix", 1e-3, 1e3},
    {"theta", 2.25, "rad", "polar angle", -2.4, 2.4},
    {"seed", 1, "", "seed of the random points", 0, 1e6, whole_number},
};

// ---- the radius by several equations of the curve ---------------------------------------------------------

struct Conic {
  double e, rho, p, theta;
};

/// The positive root of A r^2 + B r = C, the smaller if there are two.
double textbook_root(double A, double B, double C) { return (-B + sqrt(B * B + 4 * A * C)) / (2 * A); }
double stable_root(double A, double B, double C) {
  return B > 0 ? 2 * C / (B + sqrt(B * B + 4 * A * C)) : textbook_root(A, B, C);
}

double by_conic(const Conic& k, double (*root)(double, double, double)) {
  const double x = cos(k.theta), y = sin(k.theta);
  return root((1 - k.e * k.e) * x * x + y * y, 2 * k.e * k.p * x, k.p * k.p);
}
/// The radius from the ellipse with center (-sign c, 0).
double by_standard_ellipse(const Conic& k, double sign) {
  const Ellipse p{k.e, k.rho};
  const double x = cos(k.theta), y = sin(k.theta), a2 = p.a() * p.a();
  return stable_root(x * x / a2 + y * y / (p.b() * p.b()), sign * 2 * p.c() * x / a2, 1 - p.c() * p.c() / a2);
}
double by_eccentric_anomaly(const Conic& k) {
  const double E = 2 * std::atan(sqrt((1 - k.e) / (1 + k.e)) * std::tan(k.theta / 2));
  return k.e * k.rho / (1 - k.e * k.e) * (1 - k.e * cos(E));
}

struct Expected {
  Outcome polar = Outcome::ok, textbook = Outcome::ok, ellipse = Outcome::ok;
  std::string why = {};
};

Quantity radius(const std::string& name, std::string says, const Conic& k, const Reference& truth,
                const Expected& as) {
  Quantity r = quantity(name, "unit of rho", std::move(says), truth("03_01_radius", {k.e, k.p, k.theta}),
                        {1e-12 * k.p, "twelve digits of the semi-latus rectum"});
  const auto add = [&](std::string equation, std::string algorithm, auto value,
                       Outcome expected = Outcome::ok) {
    r.add({std::move(equation), std::move(algorithm), no_resolution(),
           [=](double) {
             return Answer{value(k), 1};
           },
           expected, expected == Outcome::ok ? "" : as.why});
  };
  const std::string stable = "root without cancellation";
  add(
      "polar, e and rho", "formula", [](auto& c) { return orbit(c.e, c.rho, c.theta); }, as.polar);
  add("polar, e and p = e rho", "formula", [](auto& c) { return c.p / (1 + c.e * cos(c.theta)); });
  add(
      "before the division", "textbook root", [](auto& c) { return by_conic(c, textbook_root); },
      as.textbook);
  add("before the division", stable, [](auto& c) { return by_conic(c, stable_root); });
  add(
      "standard ellipse", stable, [](auto& c) { return by_standard_ellipse(c, 1); }, as.ellipse);
  add("standard ellipse", "eccentric anomaly", by_eccentric_anomaly, as.ellipse);
  return r;
}

std::vector<Quantity> radii(const Parameters& p, const Reference& truth) {
  const Conic asked{p["e"], p["rho"], p["e"] * p["rho"], p["theta"]};
  const double almost = 1 - 0x1p-30;
  const Outcome ok = Outcome::ok, lost = Outcome::inaccurate, none = Outcome::non_finite;
  const std::string cure = "before the division, root without cancellation";
  const std::string no_ellipse = "$a$ is negative, and $b$ has the root of a negative number",
                    no_division = "$1-e^2=0$ is divided by";
  Quantity any = radius("radius", R"(distance from the focus at the angle $\theta$)", asked, truth,
                        {ok, ok, asked.e < 1 ? ok : none, asked.e > 1 ? no_ellipse : no_division});
  any.add({"ellipse of the minus sign", "root without cancellation", no_resolution(),
           [=](double) {
             return Answer{by_standard_ellipse(asked, -1), 1};
           },
           lost, "it is the mirror image"});
  Quantity circle = radius("radius_of_circle", R"($e=0$, $\rho$ infinite)", {0, HUGE_VAL, 1.5, 2.25}, truth,
                           {none, ok, none, R"($e\rho$ is zero times infinity)"});
  circle.add(Breakdown{
      R"(A circle has no directrix: with $e$ and $\rho$ its radius is zero times infinity. The semi-latus )"
      R"(rectum $p=e\rho$ is its radius.)",
      "polar, e and rho, formula", 0, none, "polar, e and p = e rho, formula", 0});
  Quantity narrow =
      radius("radius_of_narrow_ellipse", "$e=63/64$", {0.984375, 0.25 / 0.984375, 0.25, 3}, truth, {});
  const double tilt = 1.5, center = almost / (1 - almost * almost),
               radius_there = 1 / (1 + almost * cos(tilt));
  Quantity near =
      radius("radius_near_parabola", "$e=1-2^{-30}$", {almost, 1 / almost, 1, tilt}, truth,
             {ok, ok, lost,
              filled("$a$ and $c$ are $@1$ times $r$, which is found as the difference of such numbers",
                     {center / radius_there})});
  near.add(
      Breakdown{"The division by $1-e^2$ moves the center away; from one that is $@1$ radii off, @1 digits "
                "are right. Before the division nothing is lost.",
                "standard ellipse, eccentric anomaly",
                0,
                lost,
                cure,
                0,
                {center / radius_there, digits_of(Side::broken)}});
  Quantity parabola =
      radius("radius_of_parabola", "$e=1$, close to the axis", {1, 1, 1, 0x1p-10}, truth,
             {ok, lost, none, no_division + "; the textbook root subtracts nearly equal numbers"});
  parabola.add(Breakdown{
      "At $e=1$ the division by $1-e^2$ is one by zero: no center, no ellipse. The line before it is the "
      "parabola.",
      "standard ellipse, root without cancellation", 0, none, cure, 0});
  parabola.add(
      Breakdown{"Near the axis the parabola's second crossing is far away, and the textbook's root of the "
                "quadratic equation cancels.",
                "before the division, textbook root", 0, lost, cure, 0});
  Quantity hyperbola =
      radius("radius_of_hyperbola", "$e=3/2$", {1.5, 1 / 1.5, 1, 1.25}, truth, {ok, ok, none, no_ellipse});
  return {any, circle, narrow, near, parabola, hyperbola};
}

Findings study(const Parameters& p, const Reference& truth) {
  return {
      claims(p["seed"]), radii(p, truth), roots(),
      R"(The orbit is the ellipse that the solution shows, with a focus at the origin; but {{the mirror image|only one of its two signs is the orbit}}, {{the sign of the center|the center and the other focus lie on the other side}}, and {{axes for semi-axes|the axes are twice as long}}.)"};
}

}  // namespace ex03_01

Exercise exercise_3_1() {
  using namespace ex03_01;
  return {"The polar equation of an orbit is an ellipse",
          "Show that the orbit $r = e\\rho/(1+e\\cos\\theta)$ satisfies the equation of an ellipse with one "
          "focus at the origin.",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
