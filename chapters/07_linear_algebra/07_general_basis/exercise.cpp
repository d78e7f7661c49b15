// Exercise 7.7: the coefficients of p over a basis u, v, w, and over u x v, v x w, w x u, by triple products:
//   p = x u + y v + z w,             x = p.v x w / D, y = p.w x u / D, z = p.u x v / D,   D = u.v x w
//   p = x u x v + y v x w + z w x u, x = w.p / D,     y = u.p / D,     z = v.p / D
// The coefficients are planted: p is put together from whole numbers, and every line has to give them back,
// exactly. Triple products are Cramer's rule; Higham, Accuracy and Stability, 2nd ed., 1.10.1.

#include <algorithm>
#include <functional>

#include "chapters/07_linear_algebra/07_general_basis/bases.hpp"
#include "chapters/random.hpp"

namespace oddity {

namespace ex07_07 {

using namespace bases;
using vectors::operator*;

constexpr Parameter parameters[] = {
    {"gap", 1e-3, "", "distance of w from the plane of u and v, about", 1e-13, 1},
    {"seed", 1, "", "seed of the random bases", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// Whole numbers: a basis, and p put together from the vectors or from their cross products.
struct Sample {
  Vector u, v, w;
  double x, y, z;
  Vector p;
};

Vector whole_vector(Random& random) {
  const double size = std::round(std::abs(random.magnitude(1, 1e3)));
  Vector a;
  for (double& component : a) component = std::round(random.between(-size, size));
  return a;
}

/// Every fifth basis is nearly dependent; `dual`: p = x u x v + y v x w + z w x u.
std::vector<Sample> samples(Random random, bool dual) {
  std::vector<Sample> all;
  const auto digit = [&] { return static_cast<double>(1 + random.below(99)); };
  while (all.size() < 300) {
    Sample s{whole_vector(random), whole_vector(random), whole_vector(random), digit(), digit(), digit(), {}};
    if (all.size() % 5 == 4) s.w = s.u + s.v + Vector{1, 0, 0};
    if (triple(s.u, s.v, s.w) == 0) continue;
    s.p = dual ? s.x * cross(s.u, s.v) + s.y * cross(s.v, s.w) + s.z * cross(s.w, s.u)
               : s.x * s.u + s.y * s.v + s.z * s.w;
    all.push_back(s);
  }
  return all;
}

/// What stands on one side of a line.
struct Term {
  std::string text;
  std::function<Value(const Sample&)> value;
};

struct Letter {
  std::string name;
  Vector Sample::*vector;
};
struct Unknown {
  std::string name;
  double Sample::*number;
  operator Term() const {
    return {name, [of = number](const Sample& s) { return Value(s.*of); }};
  }
};

const Letter u{"u", &Sample::u}, v{"v", &Sample::v}, w{"w", &Sample::w}, p{"p", &Sample::p};
const Unknown x{"x", &Sample::x}, y{"y", &Sample::y}, z{"z", &Sample::z};

Term volume(const Letter& a, const Letter& b, const Letter& c) {
  return {a.name + "." + b.name + "x" + c.name, [i = a.vector, j = b.vector, k = c.vector](const Sample& s) {
            return Value(triple(s.*i, s.*j, s.*k));
          }};
}
Term along(const Letter& a, const Letter& b) {
  return {a.name + "." + b.name,
          [i = a.vector, j = b.vector](const Sample& s) { return Value(dot(s.*i, s.*j)); }};
}
Term operator*(const Unknown& a, const Term& b) {
  return {a.name + " " + b.text,
          [of = a.number, f = b.value](const Sample& s) { return Value(s.*of * f(s)[0]); }};
}
Term operator/(const Term& a, const Term& b) {
  return {a.text + "/" + b.text,
          [f = a.value, g = b.value](const Sample& s) { return Value(f(s)[0] / g(s)[0]); }};
}

/// Two sides over all samples, exactly.
Reading equal(const std::vector<Sample>& all, const Term& left, const Term& right) {
  Worst worst(left.text + " = " + right.text, left.text, right.text);
  for (const Sample& s : all)
    worst.see(left.value(s), right.value(s), exact(), std::max(1.0, size_of(right.value(s))), "");
  return {left.text + " = " + right.text, {worst.check()}};
}

struct Line {
  std::string id;
  int number;
  Term left, right, near_miss;  ///< of the right side
};

Claim claim(const std::vector<Sample>& all, const Line& line) {
  Claim c{line.id, line.number, line.left.text + " = " + line.right.text};
  c.printed = equal(all, line.left, line.right);
  c.near_misses = {equal(all, line.left, line.near_miss)};
  return c;
}

/// The volume times any vector, and what the coefficients make of the basis; in the first item or the second.
Line combination(bool dual) {
  const Vector q{3, -1, 4};
  const Term left{"(u.vxw) q", [=](const Sample& s) { return Value(triple(s.u, s.v, s.w) * q); }};
  const auto sum = [=](double last) {
    return [=](const Sample& s) {
      if (dual)
        return Value(dot(s.w, q) * cross(s.u, s.v) + dot(s.u, q) * cross(s.v, s.w) +
                     last * dot(s.v, q) * cross(s.w, s.u));
      return Value(triple(q, s.v, s.w) * s.u + triple(q, s.w, s.u) * s.v + last * triple(q, s.u, s.v) * s.w);
    };
  };
  if (dual)
    return {"7.7-dual_combination",
            3897,
            left,
            {"w.q uxv + u.q vxw + v.q wxu", sum(1)},
            {"with a minus before the last", sum(-1)}};
  return {"7.7-combination",
          3857,
          left,
          {"q.vxw u + q.wxu v + q.uxv w", sum(1)},
          {"with a minus before the last", sum(-1)}};
}

std::vector<Line> first_item() {
  return {combination(false),
          {"7.7-x_equation", 3863, volume(p, v, w), x * volume(u, v, w), x * volume(u, w, v)},
          {"7.7-y_equation", 3865, volume(p, w, u), y * volume(v, w, u), y * volume(v, u, w)},
          {"7.7-z_equation", 3867, volume(p, u, v), z * volume(w, u, v), z * volume(w, v, u)},
          {"7.7-x", 3871, x, volume(p, v, w) / volume(u, v, w), volume(p, w, v) / volume(u, v, w)},
          {"7.7-y", 3877, y, volume(p, w, u) / volume(v, w, u), volume(p, w, u) / volume(v, u, w)},
          {"7.7-y_again", 3881, y, volume(u, p, w) / volume(u, v, w), volume(u, w, p) / volume(u, v, w)},
          {"7.7-z", 3887, z, volume(p, u, v) / volume(w, u, v), volume(p, v, u) / volume(w, u, v)},
          {"7.7-z_again", 3891, z, volume(u, v, p) / volume(u, v, w), volume(v, u, p) / volume(u, v, w)}};
}

std::vector<Line> second_item() {
  return {combination(true),
          {"7.7-dual_x_equation", 3901, along(w, p), x * volume(w, u, v), x * volume(w, v, u)},
          {"7.7-dual_y_equation", 3903, along(u, p), y * volume(u, v, w), x * volume(u, v, w)},
          {"7.7-dual_x", 3909, x, along(w, p) / volume(w, u, v), along(u, p) / volume(w, u, v)},
          {"7.7-dual_y", 3917, y, along(u, p) / volume(u, v, w), along(v, p) / volume(u, v, w)},
          {"7.7-dual_z", 3923, z, along(v, p) / volume(v, w, u), along(w, p) / volume(v, w, u)}};
}

Claim dual_z_equation(const std::vector<Sample>& all) {
  Claim c{"7.7-dual_z_equation", 3905, "v.p = z v.w.u"};
  const Term dots{"v.w.u, components multiplied", [](const Sample& s) {
                    double sum = 0;
                    for (std::size_t i = 0; i < 3; ++i) sum += s.v[i] * s.w[i] * s.u[i];
                    return Value(sum);
                  }};
  c.printed = equal(all, along(v, p), z * dots);
  c.meant = equal(all, along(v, p), z * volume(v, w, u));
  c.near_misses = {equal(all, along(v, p), z * volume(v, u, w))};
  c.why =
      "A dot stands where the cross belongs: $v\\cdot w\\times u$. The solution for $z$ has it. With "
      "twice the unit vectors for a basis the volume is 8, and no product of two dots is a number at all.";
  return c;
}

/// A quotient whose bar the text at hand has lost.
Claim lost_bar(const std::vector<Sample>& all, const std::string& id, int line, const Unknown& unknown,
               const Letter& letter, const Term& near_miss) {
  const Term bottom = volume(u, v, w), top = along(letter, p);
  const Term run_together{top.text + bottom.text,
                          [=](const Sample& s) { return Value(top.value(s)[0] * bottom.value(s)[0]); }};
  Claim c{id, line, unknown.name + " = " + run_together.text};
  c.printed = equal(all, unknown, run_together);
  c.meant = equal(all, unknown, top / bottom);
  c.near_misses = {equal(all, unknown, near_miss)};
  c.why = "The fraction bar is lost in the text at hand: $" + unknown.name + "=(" + letter.name +
          "\\cdot p)/(u\\cdot v\\times w)$, as in the line before it. As a product it is off by the square "
          "of the "
          "volume $u\\cdot v\\times w$: with twice the unit vectors for a basis, 64 times.";
  return c;
}

Findings study(const Parameters& chosen, const Reference& truth) {
  const Random random(chosen["seed"]);
  const auto first = samples(random, false), second = samples(random, true);
  std::vector<Claim> claims;
  for (const Line& line : first_item()) claims.push_back(claim(first, line));
  for (const Line& line : second_item()) claims.push_back(claim(second, line));
  claims.push_back(dual_z_equation(second));
  claims.push_back(lost_bar(second, "7.7-dual_x_again", 3913, x, w, along(w, p) / volume(v, u, w)));
  claims.push_back(lost_bar(second, "7.7-dual_z_again", 3927, z, v, along(v, p) / volume(u, w, v)));
  std::ranges::stable_sort(claims, {}, &Claim::line);

  Quantity nearly = coefficients("nearly_dependent", 1e-10, Outcome::inaccurate, truth);
  nearly.add(
      Breakdown{"With $w$ within $10^{-10}$ of the plane of $u$ and $v$ every triple product is what is left "
                "of a cancellation; twice the digits bring it back.",
                "triple products, Cramer", 53, Outcome::inaccurate, "triple products, Cramer", 106});
  nearly.add(Breakdown{
      "A factorization loses the same digits, though what it leaves of $p$ is as small as rounding allows "
      "(see left_over): a small remainder proves nothing. Corrected by that remainder, in twice the digits, "
      "it gets them back.",
      "factorization, LU, rows exchanged", 0, Outcome::inaccurate, "factorization, LU, refined", 3});
  return {claims,
          {coefficients("coefficients", chosen["gap"], Outcome::ok, truth),
           dual_coefficients(chosen["gap"], truth), nearly, left_over(1e-10, truth)}};
}

}  // namespace ex07_07

Exercise exercise_7_7() {
  using namespace ex07_07;
  return {"Coefficients over a general basis",
          "Write $p$ over linearly independent vectors $u$, $v$, $w$, and over $u\\times v$, $v\\times w$, "
          "$w\\times u$: the coefficients are quotients of triple products. What becomes of them when the "
          "basis is nearly dependent?",
          parameters,
          {},
          study};
}

}  // namespace oddity
