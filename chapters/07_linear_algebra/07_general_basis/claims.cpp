#include "chapters/provable_claims.hpp"

#include <cmath>

#include "chapters/07_linear_algebra/07_general_basis/general_basis.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_07 {

namespace {

using namespace vectors;
using vectors::operator*;

/// A basis, p as a combination of its vectors or of their cross products, and any vector q.
template <class T>
struct LettersOf {
  static constexpr bool whole = true;
  Vector3<T> u, v, w;
  T x, y, z;
  Vector3<T> p, q;

  Vector3<T> combination() const { return x * u + y * v + z * w; }
  Vector3<T> dual_combination() const { return x * cross(u, v) + y * cross(v, w) + z * cross(w, u); }
  T volume() const { return triple(u, v, w); }

  std::array<T*, 18> quantities() {
    return {&u[0], &u[1], &u[2], &v[0], &v[1], &v[2], &w[0], &w[1], &w[2],
            &x,    &y,    &z,    &p[0], &p[1], &p[2], &q[0], &q[1], &q[2]};
  }
  TypesetIn<T> typeset() const {
    TypesetIn<T> all{{"u", u}, {"v", v}, {"w", w}, {"p", p}, {"x", x}, {"y", y}, {"z", z}, {"q", q}};
    for (std::size_t i = 0; i < 3; ++i)
      for (const auto& [letter, vector] : {std::pair{"u_", u}, {"v_", v}, {"w_", w}})
        all.emplace_back(letter + std::to_string(i + 1), vector[i]);
    return all;
  }
  std::string where() const { return listed(typeset(), 4); }
};
using Planted = LettersOf<double>;
using Table = ProvableClaims<LettersOf>;
using Route = ProvableFormula<LettersOf>;

/// Twice the unit vectors, and p with all coefficients one.
Planted twice_the_unit_vectors() {
  Planted s{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, 1, 1, 1, {}, {3, -1, 4}};
  s.p = s.dual_combination();
  return s;
}

/// In whole numbers, with every fifth basis nearly dependent; `dual`: p = x u x v + y v x w + z w x u.
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
    Planted s{vector(), vector(), vector(), digit(), digit(), digit(), {}, vector()};
    if (all.size() % 5 == 4) s.w = s.u + s.v + Vector3<double>{1, 0, 0};
    if (s.volume() == 0) continue;
    s.p = dual ? s.dual_combination() : s.combination();
    all.push_back(s);
  }
  return all;
}

const Route x{"$x$", [](const auto&s) { return s.x; }}, y{"$y$", [](const auto&s) { return s.y; }},
    z{"$z$", [](const auto&s) { return s.z; }},
    volume_times_q{R"($(u\cdot v\times w)\,q$)", [](const auto&s) { return s.volume() * s.q; }};

/// Equations for p as a combination of the basis.
void over_basis(Table& table, const std::vector<Planted>& samples) {
  const auto claim = table.over(samples);
  claim.equation("x_equation", 3863, R"($p\cdot v\times w=x\,u\cdot v\times w$)",
                 {R"($p\cdot v\times w$)", [](const auto& s) { return triple(s.p, s.v, s.w); }});
  claim.equation("y_equation", 3865, R"($p\cdot w\times u=y\,v\cdot w\times u$)",
                 {R"($p\cdot w\times u$)", [](const auto& s) { return triple(s.p, s.w, s.u); }});
  claim.equation("z_equation", 3867, R"($p\cdot u\times v=z\,w\cdot u\times v$)",
                 {R"($p\cdot u\times v$)", [](const auto& s) { return triple(s.p, s.u, s.v); }});
  claim.equation("x", 3871, R"($x=\frac{p\cdot v\times w}{u\cdot v\times w}$)", x);
  claim.equation("y", 3877, R"($y=\frac{p\cdot w\times u}{v\cdot w\times u}$)", y);
  claim.equation("y_again", 3881, R"($y=\frac{u\cdot p\times w}{u\cdot v\times w}$)", y);
  claim.equation("z", 3887, R"($z=\frac{p\cdot u\times v}{w\cdot u\times v}$)", z);
  claim.equation("z_again", 3891, R"($z=\frac{u\cdot v\times p}{u\cdot v\times w}$)", z);
  claim(
      "combination", 3857,
      R"(any vector may be written as $p=xu+yv+zw$ (our check: )"
      R"($(u\cdot v\times w)\,q=(q\cdot v\times w)u+(q\cdot w\times u)v+(q\cdot u\times v)w$ for any vector $q$))",
      volume_times_q, R"($(q\cdot v\times w)u+(q\cdot w\times u)v+(q\cdot u\times v)w$)",
      "any vector $q$ over $u$, $v$, $w$, times their volume");
}

/// Equations for p as a combination of the cross products.
void over_products(Table& table, const std::vector<Planted>& samples) {
  const auto claim = table.over(samples);
  claim.equation("dual_x_equation", 3901, R"($w\cdot p=x\,w\cdot u\times v$)",
                 {R"($w\cdot p$)", [](const auto& s) { return dot(s.w, s.p); }});
  claim.equation("dual_y_equation", 3903, R"($u\cdot p=y\,u\cdot v\times w$)",
                 {R"($u\cdot p$)", [](const auto& s) { return dot(s.u, s.p); }});
  claim.equation("dual_x", 3909, R"($x=\frac{w\cdot p}{w\cdot u\times v}$)", x);
  claim.equation("dual_y", 3917, R"($y=\frac{u\cdot p}{u\cdot v\times w}$)", y);
  claim.equation("dual_z", 3923, R"($z=\frac{v\cdot p}{v\cdot w\times u}$)", z);
  claim(
      "dual_combination", 3897,
      R"(any vector may be written as $p=x\,u\times v+y\,v\times w+z\,w\times u$ (our check: )"
      R"($(u\cdot v\times w)\,q=(w\cdot q)\,u\times v+(u\cdot q)\,v\times w+(v\cdot q)\,w\times u$ for any )"
      R"(vector $q$))",
      volume_times_q, R"($(w\cdot q)\,u\times v+(u\cdot q)\,v\times w+(v\cdot q)\,w\times u$)",
      R"(any vector $q$ over $u\times v$, $v\times w$, $w\times u$, times the volume)");
  const double volume = twice_the_unit_vectors().volume();
  claim(
      "dual_z_equation", 3905, R"($v\cdot p=z\,v\cdot w\times u$, printed $z\,v\cdot w\cdot u$)",
      {.truth = {R"($v\cdot p$)", [](const auto& s) { return dot(s.v, s.p); }},
       .printed = R"($z\sum_iv_iw_iu_i$)",
       .meant = R"($z\,v\cdot w\times u$)",
       .kind = Fault::formula,
       .why = filled(
           R"($v\cdot w$ is a number, so $v\cdot w\cdot u$ is no triple product: a dot is printed for the cross of )"
           R"($v\cdot w\times u$. The solution for $z$ has the cross. With )"
           R"(twice the unit vectors for a basis the volume is @1, and no product of two dots is a number )"
           R"(at all.)",
           {volume})});
  const auto lost_bar = [&](std::string_view slug, int line, const std::string& unknown, const Route& truth,
                            const std::string& top) {
    const std::string meant = R"(\frac{)" + top + R"(}{u\cdot v\times w})";
    claim(slug, line, "$" + unknown + "=" + meant + "$, the fraction bar lost",
          {.quantity = "$" + unknown + "$",
           .truth = truth,
           .printed = "$(" + top + R"()\,u\cdot v\times w$)",
           .meant = "$" + meant + "$",
           .why = filled(
               "The fraction bar is lost in the text at hand: $" + unknown + "=(" + top +
                   R"()/(u\cdot v\times w)$, as in the line before it. As a product it is off by the )"
                   R"(square of the volume $u\cdot v\times w$: with twice the unit vectors for a basis, )"
                   "@2 times.",
               {volume * volume})});
  };
  lost_bar("dual_x_again", 3913, "x", x, R"(w\cdot p)");
  lost_bar("dual_z_again", 3927, "z", z, R"(v\cdot p)");
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.7");
  Table table(claims);
  over_basis(table, samples(random, false));
  over_products(table, samples(random, true));
  return claims.in_order();
}

/// For every basis: the nonzero condition of `field` is on the volume, in another form.
Provables proofs() {
  Claims claims("7.7");
  Table basis(claims), products(claims);
  over_basis(basis, {});
  over_products(products, {});
  const std::vector<std::string> names{"u0", "u1", "u2", "v0", "v1", "v2", "w0", "w1", "w2",
                                       "x",  "y",  "z",  "p0", "p1", "p2", "q0", "q1", "q2"};
  auto all = for_all<LettersOf>(
      names, "field; match goal with H : _ <> 0 |- _ => contradict H; etransitivity; [| exact H]; ring end",
      "it holds for every basis");
  all.example = twice_the_unit_vectors();
  all.given = {not_zero(all.any.volume().expression())};
  all.any.p = all.any.combination();
  Provables proved = basis.proofs("7.7", all);
  all.any.p = all.any.dual_combination();
  append(proved, products.proofs("7.7", all));
  return proved;
}

}  // namespace oddity::ex07_07
