#include "chapters/claims.hpp"

#include <cmath>

#include "chapters/07_linear_algebra/07_general_basis/general_basis.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "chapters/provable.hpp"
#include "reference/text.hpp"

namespace oddity::ex07_07 {

namespace {

using namespace vectors;
using vectors::operator*;

/// A basis, and p put together from the vectors or from their cross products.
template <class T>
struct Letters {
  Vector3<T> u, v, w;
  T x, y, z;
  Vector3<T> p;

  Vector3<T> combination() const { return x * u + y * v + z * w; }
  Vector3<T> dual_combination() const { return x * cross(u, v) + y * cross(v, w) + z * cross(w, u); }
};

/// Twice the unit vectors, and p of the coefficients one.
template <class T>
Letters<T> twice_the_unit_vectors() {
  Letters<T> s{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}, 1, 1, 1, {}};
  s.p = s.dual_combination();
  return s;
}

const Vector3<double> any_q{3, -1, 4};

/// Of whole numbers.
struct Planted : Letters<double> {
  static constexpr bool whole = true;

  TypesetLetters typeset() const {
    return {{"u", u}, {"v", v}, {"w", w}, {"p", p}, {"x", x}, {"y", y}, {"z", z}, {"q", any_q}};
  }
  std::string where() const { return told(typeset(), 4); }
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
    Planted s{{vector(), vector(), vector(), digit(), digit(), digit(), {}}};
    if (all.size() % 5 == 4) s.w = s.u + s.v + Vector3<double>{1, 0, 0};
    if (triple(s.u, s.v, s.w) == 0) continue;
    s.p = dual ? s.dual_combination() : s.combination();
    all.push_back(s);
  }
  return all;
}

// ---- formulas, put together as they are written -----------------------------------------------------------

/// In doubles, and as a proof has it.
struct Term {
  std::string tex;
  std::function<double(const Letters<double>&)> of;
  std::function<Expression(const Letters<Expression>&)> recorded;

  operator Formula<Planted>() const { return {"$" + tex + "$", of}; }
};

Term term(std::string tex, const auto& of) { return {std::move(tex), of, of}; }

enum class Letter { u, v, w, p };

template <class T>
const Vector3<T>& vector(const Letters<T>& s, Letter letter) {
  return letter == Letter::u ? s.u : letter == Letter::v ? s.v : letter == Letter::w ? s.w : s.p;
}
std::string name(Letter letter) { return std::string(1, "uvwp"[static_cast<int>(letter)]); }

constexpr Letter u = Letter::u, v = Letter::v, w = Letter::w, p = Letter::p;
const Term x = term("x", [](const auto&s) { return s.x; }), y = term("y", [](const auto&s) { return s.y; }),
           z = term("z", [](const auto&s) { return s.z; });

Term volume(Letter a, Letter b, Letter c) {
  return term(name(a) + "\\cdot " + name(b) + "\\times " + name(c),
              [=](const auto& s) { return vectors::triple(vector(s, a), vector(s, b), vector(s, c)); });
}
Term along(Letter a, Letter b) {
  return term(name(a) + "\\cdot " + name(b), [=](const auto& s) { return dot(vector(s, a), vector(s, b)); });
}
Term operator*(const Term& a, const Term& b) {
  const bool is_product = a.tex.find("\\cdot") != std::string::npos;
  return {(is_product ? "(" + a.tex + ")" : a.tex) + "\\," + b.tex,
          [f = a.of, g = b.of](const auto& s) { return f(s) * g(s); },
          [f = a.recorded, g = b.recorded](const auto& s) { return f(s) * g(s); }};
}
Term operator/(const Term& a, const Term& b) {
  return {"\\frac{" + a.tex + "}{" + b.tex + "}", [f = a.of, g = b.of](const auto& s) { return f(s) / g(s); },
          [f = a.recorded, g = b.recorded](const auto& s) { return f(s) / g(s); }};
}

/// The volume times any vector q, and what the coefficients make of the basis.
const Formula<Planted> volume_times_q{R"($(u\cdot v\times w)\,q$)",
                                      [](const Planted& s) { return triple(s.u, s.v, s.w) * any_q; }};

template <class T>
Vector3<T> combined(const Letters<T>& s, const Vector3<T>& q, double last) {
  return triple(q, s.v, s.w) * s.u + triple(q, s.w, s.u) * s.v + last * triple(q, s.u, s.v) * s.w;
}
template <class T>
Vector3<T> dual_combined(const Letters<T>& s, const Vector3<T>& q, double last) {
  return dot(s.w, q) * cross(s.u, s.v) + dot(s.u, q) * cross(s.v, s.w) + last * dot(s.v, q) * cross(s.w, s.u);
}
Formula<Planted> combination(std::string text, double last) {
  return {std::move(text), [=](const Planted& s) { return combined(s, any_q, last); }};
}
Formula<Planted> dual_combination(std::string text, double last) {
  return {std::move(text), [=](const Planted& s) { return dual_combined(s, any_q, last); }};
}

struct Equation {
  std::string slug;
  int line;
  Term left, right, near;

  std::string tex() const { return "$" + left.tex + "=" + right.tex + "$"; }
};

/// Where p is put together from the basis, and where from its cross products.
std::vector<Equation> equations(bool dual) {
  if (!dual)
    return {{"x_equation", 3863, volume(p, v, w), x * volume(u, v, w), x * volume(u, w, v)},
            {"y_equation", 3865, volume(p, w, u), y * volume(v, w, u), y * volume(v, u, w)},
            {"z_equation", 3867, volume(p, u, v), z * volume(w, u, v), z * volume(w, v, u)},
            {"x", 3871, x, volume(p, v, w) / volume(u, v, w), volume(p, w, v) / volume(u, v, w)},
            {"y", 3877, y, volume(p, w, u) / volume(v, w, u), volume(p, w, u) / volume(v, u, w)},
            {"y_again", 3881, y, volume(u, p, w) / volume(u, v, w), volume(u, w, p) / volume(u, v, w)},
            {"z", 3887, z, volume(p, u, v) / volume(w, u, v), volume(p, v, u) / volume(w, u, v)},
            {"z_again", 3891, z, volume(u, v, p) / volume(u, v, w), volume(v, u, p) / volume(u, v, w)}};
  return {{"dual_x_equation", 3901, along(w, p), x * volume(w, u, v), x * volume(w, v, u)},
          {"dual_y_equation", 3903, along(u, p), y * volume(u, v, w), x * volume(u, v, w)},
          {"dual_x", 3909, x, along(w, p) / volume(w, u, v), along(u, p) / volume(w, u, v)},
          {"dual_y", 3917, y, along(u, p) / volume(u, v, w), along(v, p) / volume(u, v, w)},
          {"dual_z", 3923, z, along(v, p) / volume(v, w, u), along(w, p) / volume(v, w, u)}};
}

/// A quotient over the volume whose fraction bar is lost.
struct LostBar {
  std::string slug;
  int line;
  Term unknown, top, near;

  Term bottom() const { return volume(u, v, w); }
  Term as_it_stands() const { return top * bottom(); }
  Term meant() const { return top / bottom(); }
};

std::vector<LostBar> lost_bars() {
  return {{"dual_x_again", 3913, x, along(w, p), along(w, p) / volume(v, u, w)},
          {"dual_z_again", 3927, z, along(v, p), along(v, p) / volume(u, w, v)}};
}

/// z times the sum of v_i w_i u_i.
const Term products_of_components = term(R"(z\sum_iv_iw_iu_i)", [](const auto& s) {
  return s.z * (s.v[0] * s.w[0] * s.u[0] + s.v[1] * s.w[1] * s.u[1] + s.v[2] * s.w[2] * s.u[2]);
});

}  // namespace

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.7");
  const auto planted = samples(random, false), dual = samples(random, true);
  const auto twice = twice_the_unit_vectors<double>();
  for (const bool is_dual : {false, true})
    for (const Equation& e : equations(is_dual))
      claims.formula<Planted>(e.slug, e.line, e.tex(), is_dual ? dual : planted,
                              {.truth = e.left, .printed = e.right, .near_misses = {e.near}});
  claims.formula<Planted>(
      "combination", 3857,
      R"(any vector is a combination: $(u\cdot v\times w)\,q=(q\cdot v\times w)u+(q\cdot w\times u)v+(q\cdot u\times v)w$)",
      planted,
      {.quantity = "any vector $q$ over $u$, $v$, $w$, times their volume",
       .truth = volume_times_q,
       .printed = combination(R"($(q\cdot v\times w)u+(q\cdot w\times u)v+(q\cdot u\times v)w$)", 1),
       .near_misses = {combination(R"($(q\cdot v\times w)u+(q\cdot w\times u)v-(q\cdot u\times v)w$)", -1)}});
  claims.formula<Planted>(
      "dual_combination", 3897,
      R"(any vector is a combination: )"
      R"($(u\cdot v\times w)\,q=(w\cdot q)\,u\times v+(u\cdot q)\,v\times w+(v\cdot q)\,w\times u$)",
      dual,
      {.quantity = R"(any vector $q$ over $u\times v$, $v\times w$, $w\times u$, times the volume)",
       .truth = volume_times_q,
       .printed =
           dual_combination(R"($(w\cdot q)\,u\times v+(u\cdot q)\,v\times w+(v\cdot q)\,w\times u$)", 1),
       .near_misses = {
           dual_combination(R"($(w\cdot q)\,u\times v+(u\cdot q)\,v\times w-(v\cdot q)\,w\times u$)", -1)}});
  claims.formula<Planted>(
      "dual_z_equation", 3905, R"($v\cdot p=z\,v\cdot w\times u$, printed $z\,v\cdot w\cdot u$)", dual,
      {.truth = along(v, p),
       .printed = {"$" + products_of_components.tex + "$, components multiplied", products_of_components.of},
       .meant = z * volume(v, w, u),
       .near_misses = {z * volume(v, u, w)},
       .kind = Fault::formula,
       .why = filled(
           R"($v\cdot w$ is a number, so $v\cdot w\cdot u$ is no triple product: a dot stands where the cross of )"
           R"($v\cdot w\times u$ belongs. The solution for $z$ has it. With )"
           R"(twice the unit vectors for a basis the volume is @1, and no product of two dots is a number )"
           R"(at all.)",
           {triple(twice.u, twice.v, twice.w)})});
  for (const LostBar& b : lost_bars())
    claims.formula<Planted>(
        b.slug, b.line, "$" + b.unknown.tex + "=" + b.meant().tex + "$, the fraction bar lost", dual,
        {.quantity = "$" + b.unknown.tex + "$",
         .truth = b.unknown,
         .printed = b.as_it_stands(),
         .meant = b.meant(),
         .near_misses = {b.near},
         .kind = Fault::lost_typography,
         .why = filled(
             "The fraction bar is lost in the text at hand: $" + b.unknown.tex + "=(" + b.top.tex +
                 R"()/(u\cdot v\times w)$, as in the line before it. As a product it is off by the )"
                 R"(square of the volume $u\cdot v\times w$: with twice the unit vectors for a basis, )"
                 "@2 times.",
             {b.as_it_stands().of(twice) / b.meant().of(twice)})});
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

Vector3<Expression> letters(const std::string& name) {
  return {Expression::letter(name + "0"), Expression::letter(name + "1"), Expression::letter(name + "2")};
}

Letters<Expression> any_letters(bool dual) {
  Letters<Expression> s{letters("u"),
                        letters("v"),
                        letters("w"),
                        Expression::letter("x"),
                        Expression::letter("y"),
                        Expression::letter("z"),
                        {}};
  s.p = dual ? s.dual_combination() : s.combination();
  return s;
}

/// For every basis: what `field` asks not to be zero is the volume, written another way.
Lemma for_every_basis(std::string name, const std::vector<Proposition>& follows) {
  const Letters<Expression> s = any_letters(false);
  return {std::move(name),
          "(u0 u1 u2 v0 v1 v2 w0 w1 w2 x y z q0 q1 q2 : R)",
          {not_zero(triple(s.u, s.v, s.w))},
          follows,
          "field; match goal with H : _ <> 0 |- _ => contradict H; etransitivity; [| exact H]; ring end"};
}
Lemma equation(std::string name, const Term& left, const Term& right, bool dual) {
  const Letters<Expression> s = any_letters(dual);
  return for_every_basis(std::move(name), {left.recorded(s) == right.recorded(s)});
}
Lemma vectors_equal(const Vector3<Expression>& a, const Vector3<Expression>& b) {
  return for_every_basis("printed", {a[0] == b[0], a[1] == b[1], a[2] == b[2]});
}
Lemma differs(const Term& printed, const Term& truth, double margin) {
  const auto s = twice_the_unit_vectors<Expression>();
  return {.name = "printed_differs",
          .follows = {apart(printed.recorded(s), truth.recorded(s), margin)},
          .tactic = by_arithmetic};
}

}  // namespace

Provables proofs() {
  const std::string holds = "it holds for every basis";
  Provables all;
  for (const bool dual : {false, true})
    for (const Equation& e : equations(dual))
      all.push_back({"7.7-" + e.slug, holds, {equation("printed", e.left, e.right, dual)}});
  const Letters<Expression> s = any_letters(false);
  const Vector3<Expression> q = letters("q"), volume_times = triple(s.u, s.v, s.w) * q;
  all.push_back({"7.7-combination", holds, {vectors_equal(combined(s, q, 1), volume_times)}});
  all.push_back({"7.7-dual_combination", holds, {vectors_equal(dual_combined(s, q, 1), volume_times)}});
  const std::string meant =
      "as meant it holds for every basis; as printed it is off for twice the unit vectors";
  all.push_back({"7.7-dual_z_equation",
                 meant,
                 {equation("meant", along(v, p), z * volume(v, w, u), true),
                  differs(products_of_components, along(v, p), 8)},
                 8});
  for (const LostBar& b : lost_bars())
    all.push_back({"7.7-" + b.slug,
                   meant,
                   {equation("meant", b.unknown, b.meant(), true), differs(b.as_it_stands(), b.unknown, 63)},
                   63});
  return all;
}

}  // namespace oddity::ex07_07

namespace oddity {

Provables proofs_7_7() { return ex07_07::proofs(); }

}  // namespace oddity
