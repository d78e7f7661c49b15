#include "chapters/claims.hpp"

#include <cmath>

#include "chapters/07_linear_algebra/07_general_basis/general_basis.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_07 {

namespace {

using namespace vectors;
using vectors::operator*;

/// Whole numbers: a basis, and p put together from the vectors or from their cross products.
struct Planted {
  static constexpr bool whole = true;
  Vector3<double> u, v, w;
  double x, y, z;
  Vector3<double> p;

  std::string where() const {
    std::string all;
    for (const auto& [name, a] : {std::pair{"u", u}, {"v", v}, {"w", w}, {"p", p}})
      all += (all.empty() ? "$" : ", $") + std::string(name) + "$ = (" + shortest(a[0]) + ", " +
             shortest(a[1]) + ", " + shortest(a[2]) + ")";
    return all;
  }
};

/// Every fifth basis is nearly dependent; `dual`: p = x u x v + y v x w + z w x u.
std::vector<Planted> samples(Random random, bool dual) {
  std::vector<Planted> all;
  const auto digit = [&] { return static_cast<double>(1 + random.below(99)); };
  const auto vector = [&] {
    const double size = std::round(std::abs(random.magnitude(1, 1e3)));
    Vector3<double> a;
    for (double& component : a) component = std::round(random.between(-size, size));
    return a;
  };
  while (all.size() < 300) {
    Planted s{vector(), vector(), vector(), digit(), digit(), digit(), {}};
    if (all.size() % 5 == 4) s.w = s.u + s.v + Vector3<double>{1, 0, 0};
    if (triple(s.u, s.v, s.w) == 0) continue;
    s.p = dual ? s.x * cross(s.u, s.v) + s.y * cross(s.v, s.w) + s.z * cross(s.w, s.u)
               : s.x * s.u + s.y * s.v + s.z * s.w;
    all.push_back(s);
  }
  return all;
}

// ---- formulas, put together as they are written -----------------------------------------------------------

struct Term {
  std::string tex;
  std::function<double(const Planted&)> of;

  operator Formula<Planted>() const { return {"$" + tex + "$", of}; }
};

struct Letter {
  std::string name;
  Vector3<double> Planted::*vector;
};

const Letter u{"u", &Planted::u}, v{"v", &Planted::v}, w{"w", &Planted::w}, p{"p", &Planted::p};
const Term x{"x", &Planted::x}, y{"y", &Planted::y}, z{"z", &Planted::z};

Term volume(const Letter& a, const Letter& b, const Letter& c) {
  return {a.name + "\\cdot " + b.name + "\\times " + c.name,
          [i = a.vector, j = b.vector, k = c.vector](const Planted& s) {
            return vectors::triple(s.*i, s.*j, s.*k);
          }};
}
Term along(const Letter& a, const Letter& b) {
  return {a.name + "\\cdot " + b.name,
          [i = a.vector, j = b.vector](const Planted& s) { return dot(s.*i, s.*j); }};
}
Term operator*(const Term& a, const Term& b) {
  return {a.tex + "\\," + b.tex, [f = a.of, g = b.of](const Planted& s) { return f(s) * g(s); }};
}
Term operator/(const Term& a, const Term& b) {
  return {"\\frac{" + a.tex + "}{" + b.tex + "}",
          [f = a.of, g = b.of](const Planted& s) { return f(s) / g(s); }};
}

/// The volume times any vector q, and what the coefficients make of the basis.
const Vector3<double> any_q{3, -1, 4};
const Formula<Planted> volume_times_q{R"($(u\cdot v\times w)\,q$)",
                                      [](const Planted& s) { return triple(s.u, s.v, s.w) * any_q; }};

Formula<Planted> combination(std::string text, double last) {
  return {std::move(text), [=](const Planted& s) {
            return triple(any_q, s.v, s.w) * s.u + triple(any_q, s.w, s.u) * s.v +
                   last * triple(any_q, s.u, s.v) * s.w;
          }};
}
Formula<Planted> dual_combination(std::string text, double last) {
  return {std::move(text), [=](const Planted& s) {
            return dot(s.w, any_q) * cross(s.u, s.v) + dot(s.u, any_q) * cross(s.v, s.w) +
                   last * dot(s.v, any_q) * cross(s.w, s.u);
          }};
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.7");
  auto planted = samples(random, false);
  const auto equation = [&](const char* slug, int line, const Term& left, const Term& right,
                            const Term& near) {
    claims.formula<Planted>(slug, line, "$" + left.tex + "=" + right.tex + "$", planted,
                            {.truth = left, .printed = right, .near_misses = {near}});
  };
  claims.formula<Planted>(
      "combination", 3857, "any vector $q$ over $u$, $v$, $w$, times their volume", planted,
      {.truth = volume_times_q,
       .printed = combination(R"($(q\cdot v\times w)u+(q\cdot w\times u)v+(q\cdot u\times v)w$)", 1),
       .near_misses = {combination(R"($(q\cdot v\times w)u+(q\cdot w\times u)v-(q\cdot u\times v)w$)", -1)}});
  equation("x_equation", 3863, volume(p, v, w), x * volume(u, v, w), x * volume(u, w, v));
  equation("y_equation", 3865, volume(p, w, u), y * volume(v, w, u), y * volume(v, u, w));
  equation("z_equation", 3867, volume(p, u, v), z * volume(w, u, v), z * volume(w, v, u));
  equation("x", 3871, x, volume(p, v, w) / volume(u, v, w), volume(p, w, v) / volume(u, v, w));
  equation("y", 3877, y, volume(p, w, u) / volume(v, w, u), volume(p, w, u) / volume(v, u, w));
  equation("y_again", 3881, y, volume(u, p, w) / volume(u, v, w), volume(u, w, p) / volume(u, v, w));
  equation("z", 3887, z, volume(p, u, v) / volume(w, u, v), volume(p, v, u) / volume(w, u, v));
  equation("z_again", 3891, z, volume(u, v, p) / volume(u, v, w), volume(v, u, p) / volume(u, v, w));

  planted = samples(random, true);
  claims.formula<Planted>(
      "dual_combination", 3897,
      R"(any vector $q$ over $u\times v$, $v\times w$, $w\times u$, times the volume)", planted,
      {.truth = volume_times_q,
       .printed =
           dual_combination(R"($(w\cdot q)\,u\times v+(u\cdot q)\,v\times w+(v\cdot q)\,w\times u$)", 1),
       .near_misses = {
           dual_combination(R"($(w\cdot q)\,u\times v+(u\cdot q)\,v\times w-(v\cdot q)\,w\times u$)", -1)}});
  equation("dual_x_equation", 3901, along(w, p), x * volume(w, u, v), x * volume(w, v, u));
  equation("dual_y_equation", 3903, along(u, p), y * volume(u, v, w), x * volume(u, v, w));
  claims.formula<Planted>(
      "dual_z_equation", 3905, R"($v\cdot p=z\,v\cdot w\cdot u$)", planted,
      {.truth = along(v, p),
       .printed = {R"($z\sum_iv_iw_iu_i$, components multiplied)",
                   [](const Planted& s) {
                     double sum = 0;
                     for (std::size_t i = 0; i < 3; ++i) sum += s.v[i] * s.w[i] * s.u[i];
                     return s.z * sum;
                   }},
       .meant = z * volume(v, w, u),
       .near_misses = {z * volume(v, u, w)},
       .kind = Fault::formula,
       .why =
           R"(A dot stands where the cross belongs: $v\cdot w\times u$. The solution for $z$ has it. With )"
           R"(twice the unit vectors for a basis the volume is 8, and no product of two dots is a number )"
           R"(at all.)"});
  equation("dual_x", 3909, x, along(w, p) / volume(w, u, v), along(u, p) / volume(w, u, v));
  const auto lost_bar = [&](const char* slug, int line, const Term& unknown, const Term& top,
                            const Term& near) {
    const Term bottom = volume(u, v, w), as_it_stands = top * bottom;
    claims.formula<Planted>(
        slug, line, "$" + unknown.tex + "=" + as_it_stands.tex + "$", planted,
        {.truth = unknown,
         .printed = as_it_stands,
         .meant = top / bottom,
         .near_misses = {near},
         .kind = Fault::lost_typography,
         .why = "The fraction bar is lost in the text at hand: $" + unknown.tex + "=(" + top.tex +
                R"()/(u\cdot v\times w)$, as in the line before it. As a product it is off by the square of )"
                R"(the volume $u\cdot v\times w$: with twice the unit vectors for a basis, 64 times.)"});
  };
  lost_bar("dual_x_again", 3913, x, along(w, p), along(w, p) / volume(v, u, w));
  equation("dual_y", 3917, y, along(u, p) / volume(u, v, w), along(v, p) / volume(u, v, w));
  equation("dual_z", 3923, z, along(v, p) / volume(v, w, u), along(w, p) / volume(v, w, u));
  lost_bar("dual_z_again", 3927, z, along(v, p), along(v, p) / volume(u, w, v));
  return claims.in_order();
}

}  // namespace oddity::ex07_07
