// The claims of exercise 2.1. The text's formulas are checked by dual numbers, its limits by Richardson
// extrapolation.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <type_traits>

#include "chapters/02_basic_concepts/01_plane_change/plane_change.hpp"
#include "chapters/02_basic_concepts/shared/limit_claims.hpp"
#include "chapters/02_basic_concepts/shared/limit_proofs.hpp"
#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"

namespace oddity::ex02_01 {

namespace {

using limits::limit;

/// The polynomial of degree n-1 through n points of a piece.
template <class T>
Vector<T> interpolated(int side, const T& t, int n) {
  Vector<T> sum{};
  for (int i = 0; i < n; ++i) {
    T weight(1.0);
    for (int j = 0; j < n; ++j)
      if (j != i) weight *= (t - 0.5 * j) / (0.5 * (i - j));
    sum = sum + weight * piece(side)(T(0.5 * i));
  }
  return sum;
}

template <class T>
struct SampleOf {
  T t;
  int of = after;  ///< the piece, if t is a letter
  std::array<T*, 1> letters() { return {&t}; }
  TypesetIn<T> typeset() const {
    const T none(0.0);
    return {{"t", t}, {"t_-", side() < 0 ? t : none}, {"t_+", side() < 0 ? none : t}};
  }
  std::string where() const { return "$t$ = " + format_shortest(t); }
  int side() const {
    if constexpr (std::same_as<T, double>)
      return t < 0 ? before : after;
    else
      return of;
  }
  LocalOf<T> local() const { return ex02_01::local(side(), t); }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;
using OfTime = ProvableFormula<SampleOf>;

constexpr auto r_at = [](int side, const auto& t) { return local(side, t).r; };
constexpr auto v_at = [](int side, const auto& t) { return local(side, t).v; };
constexpr auto a_at = [](int side, const auto& t) { return local(side, t).a; };
constexpr auto T_at = [](int side, const auto& t) { return local(side, t).T; };
constexpr auto N_at = [](int side, const auto& t) { return local(side, t).N; };

/// Difference quotients from the value at 0.
constexpr auto r_slope = [](int side, const auto& t) { return r_at(side, t) / t; };
constexpr auto v_slope = [](int side, const auto& t) {
  using T = std::decay_t<decltype(t)>;
  return (v_at(side, t) - Vector<T>{T(1.0), T(0.0), T(0.0)}) / t;
};
constexpr auto normals_apart = [](double sign, const auto& t) {
  return length(N_at(after, t) - sign * N_at(before, -t));
};
constexpr auto cosine = [](const auto& normal, const auto& t) { return dot(normal(t), N_at(before, -t)); };
constexpr auto N_after = [](const auto& t) { return N_at(after, t); };

template <class At>
OfTime by_duals(const At& at) {
  return {"dual numbers", [=](const auto& s) { return at(s.side(), s.t); }};
}
const OfTime velocity = R"($(1,3t_-^2,3t_+^2)$)", acceleration = "$(0,6t_-,6t_+)$";
OfTime normal(int side) {
  return std::string(side < 0 ? "$(-3t^2,1,0)" : "$(-3t^2,0,1)") + R"(/\sqrt{1+9t^4}$)";
}

/// The formulas of N at t, checked against the limits from both sides.
Reading normal_at(double t, double h) {
  Reading reading{R"($\mathbf N$ at $t=)" + format_shortest(t) + "$", {}};
  for (int side : {before, after})
    reading.checks.push_back(limit(R"($\mathbf N$)", computed<Sample>(normal(side)).of({t}), h,
                                   [=](double s) { return N_at(side, side * s); }));
  return reading;
}
template <class Normal>
Reading right_angle(const std::string& text, double h, const Normal& normal) {
  return {
      text,
      {limit("cosine of the normals at $t$ and $-t$", 0, h, [=](double s) { return cosine(normal, s); })}};
}

/// `samples` exclude 0, where there is no principal normal.
void frames(Table& table, int side, const std::vector<Sample>& with_0, const std::vector<Sample>& samples) {
  const std::string range = side < 0 ? " before 0" : " from 0 on",
                    T = side < 0 ? "$(1,3t^2,0)" : "$(1,0,3t^2)",
                    N = side < 0 ? "$(-3t^2,1,0)" : "$(-3t^2,0,1)", times = R"(\,\sqrt{1+9t^4}$)";
  constexpr double shown = 1;
  const Value multiplied = TypesetFormula(T + times)({{"t", shown}});
  const std::string why = filled(
      R"(The bar above the root is lost in the text at hand: the root divides. As printed it multiplies the )"
      R"(vector, and at $t=\pm@1$ the length is @2, not 1.)",
      {shown, std::hypot(multiplied[0], multiplied[1], multiplied[2])});
  table.formula(side < 0 ? "tangent_before" : "tangent_after", side < 0 ? 135 : 161,
                R"($\mathbf T=)" + T.substr(1) + times + range, with_0,
                {.quantity = R"($\mathbf T$)",
                 .truth = by_duals(T_at),
                 .printed = T + times,
                 .meant = T + R"(/\sqrt{1+9t^4}$)",
                 .why = why});
  table.formula(side < 0 ? "normal_before" : "normal_after", side < 0 ? 141 : 167,
                R"($\mathbf N=)" + N.substr(1) + times + " is a unit normal" + range, samples,
                {.quantity = R"($\mathbf N$)",
                 .truth = {std::string(side < 0 ? "minus " : "") + "the principal normal by dual numbers",
                           [](const auto& s) {
                             const auto l = s.local();
                             return double(s.side()) * unit(cross(cross(l.v, l.a), l.v));
                           }},
                 .printed = N + times,
                 .meant = normal(side),
                 .why = why});
}

void on_both_pieces(Table& table, const std::vector<Sample>& all) {
  const auto through = [](std::string text, int points) {
    return OfTime{std::move(text), [=](const auto& s) { return interpolated(s.side(), s.t, points); },
                  [](const Sample& s) { return 10 * (1 + std::abs(s.t * s.t * s.t)); }};
  };
  table.formula("polynomials", 103, "The components are polynomials in $t$.", all,
                {.quantity = R"($\mathbf r$)",
                 .truth = {"the curve", [](const auto& s) { return piece(s.side())(s.t); }},
                 .printed = through("the cubic through four of its points", 4),
                 .near_misses = {through("the parabola through three of its points", 3)}});
  table.formula("speed", 129, R"(The speed is $\sqrt{1+9t^4}$ for all $t$.)", all,
                {.quantity = R"($|\mathbf v|$)",
                 .truth = {"dual numbers", [](const auto& s) { return s.local().speed; }},
                 .printed = R"($\sqrt{1+9t^4}$)"});
}

/// Replaces the root of 1 + 9 t^4, also within other roots, by the letter q.
constexpr const char* by_root = R"(
  pose proof (Rle_0_sqr (t * t)) as fourth; unfold Rsqr in fourth;
  assert (above : 0 < 1 + 9 * t * t * t * t) by lra;
  pose proof (sqrt_lt_R0 _ above) as positive;
  assert (square : sqrt (1 + 9 * t * t * t * t) * sqrt (1 + 9 * t * t * t * t) = 1 + 9 * t * t * t * t)
    by (apply sqrt_sqrt; lra);
  set (q := sqrt (1 + 9 * t * t * t * t)) in *; clearbody q;
  try (assert (0 < t * q) by (apply Rmult_lt_0_compat; lra));
  try (assert (0 < - t * q) by (apply Rmult_lt_0_compat; lra));
  repeat match goal with |- context [sqrt ?x] =>
    lazymatch x with
    | context [sqrt _] => fail
    | _ =>
        let is y := rewrite (root_is x y) by (try lra; field [square]; repeat split; lra) in
        first [is constr:(1) | is constr:(q) | is constr:(6 * (t * q)) | is constr:(6 * (- t * q))]
    end
  end;
  field [square]; repeat split; lra)";

Shortened t() { return Shortened::letter("t"); }

ForAll<SampleOf> at_all_times(int side, std::string says) {
  return {.any = {t(), side},
          .letters = "(t : R)",
          .tactic = by_root,
          .says = std::move(says),
          .example = {side * 0.5}};
}

/// Proofs in which the sign of t matters.
Provables proofs_of_frame(int side) {
  Claims claims("2.1");
  Table table(claims);
  frames(table, side, {}, {});
  ForAll<SampleOf> tangent = at_all_times(side, "it holds at all times"), normal = tangent;
  tangent.without = {"normal_before", "normal_after"};
  normal.without = {"tangent_before", "tangent_after"};
  normal.given = {above((side * t()).expression(), 0)};
  normal.says = side < 0 ? "it holds before 0" : "it holds after 0";
  Provables proved = table.proofs("2.1", tangent);
  std::ranges::move(table.proofs("2.1", normal), std::back_inserter(proved));
  return proved;
}

void add(std::vector<Lemma>& all, int side, Lemma lemma) {
  lemma.name += side < 0 ? "_before" : "_after";
  all.push_back(std::move(lemma));
}
Provables proofs_on_both_pieces() {
  Claims claims("2.1");
  Table table(claims);
  on_both_pieces(table, {});
  Provables proved;
  for (int side : {before, after}) {
    Provables here = table.proofs("2.1", at_all_times(side, "it holds on both pieces"));
    if (proved.empty()) {
      proved = here;
      for (Provable& p : proved) p.lemmas.clear();
    }
    for (std::size_t i = 0; i < here.size(); ++i) add(proved[i].lemmas, side, here[i].lemmas.front());
  }
  return proved;
}

template <class F>
void add_limits(std::vector<Lemma>& all, const F& f, std::initializer_list<int> sides,
                const Vector<Shortened>& to) {
  for (int side : sides) {
    const Vector<Shortened> v = f(side, t());
    Lemma limit{.name = "limit", .tactic = "intros; tends"};
    for (std::size_t i = 0; i < 3; ++i)
      limit.follows.push_back(tends_at_zero(v[i].expression(), side, to[i].expression()));
    add(all, side, limit);
  }
}
template <class F>
Provable limit_of(const std::string& slug, const F& f, std::initializer_list<int> sides,
                  const Vector<Shortened>& to) {
  Provable proved{"2.1-" + slug, sides.size() == 2 ? "it is the limit from both sides" : "it is the limit"};
  add_limits(proved.lemmas, f, sides, to);
  return proved;
}
template <class F>
Provable derivative_of(const std::string& slug, const OfTime& formula, const OfTime& truth, const F& slope,
                       const Vector<Shortened>& at_0) {
  Provable proved{"2.1-" + slug,
                  "it holds on both pieces, and at 0 it is the limit of slopes from both sides"};
  for (int side : {before, after})
    add(proved.lemmas, side,
        {"printed",
         "(t : R)",
         {},
         equal(formula.recorded({t(), side}), truth.recorded({t(), side})),
         "ring"});
  add_limits(proved.lemmas, slope, {before, after}, at_0);
  return proved;
}
/// A limit from above.
Provable limit_of_number(const std::string& slug, std::string says,
                         std::initializer_list<std::pair<Shortened, Shortened>> numbers) {
  Lemma limit{.name = "limit", .tactic = "intros; tends"};
  for (const auto& [f, to] : numbers)
    limit.follows.push_back(tends_at_zero(f.expression(), after, to.expression()));
  return {"2.1-" + slug, std::move(says), {limit}};
}

}  // namespace

std::vector<Claim> claims(double h, double seed) {
  Random random(seed);
  std::vector<Sample> left{{-0.75}}, right{{0.75}};
  for (int i = 0; i < 200; ++i) {
    const Sample s{random.magnitude(1e-3, 1e2)};
    (s.t < 0 ? left : right).push_back(s);
  }
  std::vector<Sample> with_0 = right, all = left;
  with_0.push_back({0});
  all.insert(all.end(), with_0.begin(), with_0.end());
  Claims claims("2.1");
  Table table(claims);
  on_both_pieces(table, all);

  /// Claims a formula on both pieces, and at 0 as the limit of slopes.
  const auto with_limit = [&](std::string_view slug, int line, const std::string& says,
                              const std::string& what, const OfTime& formula, const OfTime& truth,
                              const std::string& slope, const auto& f) {
    Claim claim{
        .printed = {formula.text, {compare<Sample>(what, computed<Sample>(formula), truth, all)}, true},
        .near_misses = single_changes<Sample>(what, formula, truth, all, "")};
    for (int side : {before, after})
      claim.printed.checks.push_back(limit(slope + (side < 0 ? " from below" : " from above"),
                                           computed<Sample>(formula).of({0}), h,
                                           [&](double s) { return f(side, side * s); }));
    claims.add(slug, line, says, std::move(claim));
  };
  with_limit("velocity", 69, R"($\mathbf v=(1,3t^2,0)$ before 0 and $(1,0,3t^2)$ from 0 on)",
             R"($\mathbf v$; $t_-=\min(t,0)$, $t_+=\max(t,0)$)", velocity, by_duals(v_at),
             R"($(\mathbf r(t)-\mathbf r(0))/t$)", r_slope);
  with_limit("acceleration", 77, R"($\mathbf a=(0,6t,0)$ before 0 and $(0,0,6t)$ from 0 on)",
             R"($\mathbf a$; $t_-=\min(t,0)$, $t_+=\max(t,0)$)", acceleration, by_duals(a_at),
             R"($(\mathbf v(t)-\mathbf v(0))/t$)", v_slope);

  const auto vector_tends = [&](std::string_view slug, int line, const std::string& letter,
                                const std::vector<int>& sides, const std::string& to, const auto& f) {
    const std::string what = R"($\mathbf )" + letter;
    std::vector<limits::Limit> at_0;
    for (const int side : sides)
      at_0.emplace_back(side < 0 ? "from below" : "from above", h,
                        [=](double s) { return f(side, side * s); });
    limits::tends(
        claims, slug, line,
        what + "$ tends to $" + to + "$ " + (sides.size() == 2 ? "from both sides" : at_0[0].from) + ".",
        what + "$", at_0, what + R"(\to)" + to + "$");
  };
  vector_tends("position_from_below", 87, "r", {before}, "(0,0,0)", r_at);
  vector_tends("position_from_above", 105, "r", {after}, "(0,0,0)", r_at);
  vector_tends("velocity_limit", 121, "v", {before, after}, "(1,0,0)", v_at);
  vector_tends("acceleration_limit", 121, "a", {before, after}, "(0,0,0)", a_at);
  frames(table, before, left, left);
  vector_tends("normal_from_below", 147, "N", {before}, "(0,1,0)", N_at);
  claims.add(
      "normal_by_evaluation", 155,
      R"(The limit of $\mathbf N$ is computed by evaluating its components at 0, as they are continuous.)",
      {.printed = normal_at(0, h), .near_misses = {normal_at(1e-3, h)}});
  frames(table, after, with_0, right);
  vector_tends("normal_from_above", 173, "N", {after}, "(0,0,1)", N_at);
  const auto jumps = [&](std::string_view slug, const std::string& says, const std::string& what,
                         double sign) {
    limits::tends(claims, slug, 181, says, what,
                  {{"from both sides", h, [=](double s) { return normals_apart(sign, s); }}}, R"($\sqrt2$)");
  };
  jumps("one_sided_limits_differ", R"(The one-sided limits of $\mathbf N$ at $t=0$ are different.)",
        R"($|\mathbf N_+-\mathbf N_-|$)", 1);
  jumps("no_sign_helps",
        R"(Even a sign change on one of the normals does not make the one-sided limits equal.)",
        R"($|\mathbf N_++\mathbf N_-|$)", -1);
  claims.add(
      "no_continuous_normal", 181,
      "It is not possible to define a continuous normal of the curve at $t=0$ (our reading: in the curve's "
      "own plane, of either sign).",
      {.printed = right_angle("the normal in the curve's own plane, of either sign: a right angle remains", h,
                              N_after),
       .near_misses = {right_angle(
           R"(every unit vector perpendicular to $\mathbf T$: but $(0,1,0)$ continues $\mathbf N$ for $t\ge0$)",
           h, [](double) {
             return Vector3{0, 1, 0};
           })}});
  return claims.in_order();
}

Provables proofs() {
  const Vector<Shortened> none{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Provables proved = proofs_on_both_pieces();
  for (int side : {before, after}) std::ranges::move(proofs_of_frame(side), std::back_inserter(proved));
  proved.push_back(derivative_of("velocity", velocity, by_duals(v_at), r_slope, x));
  proved.push_back(derivative_of("acceleration", acceleration, by_duals(a_at), v_slope, none));
  proved.push_back(limit_of("position_from_below", r_at, {before}, none));
  proved.push_back(limit_of("position_from_above", r_at, {after}, none));
  proved.push_back(limit_of("velocity_limit", v_at, {before, after}, x));
  proved.push_back(limit_of("acceleration_limit", a_at, {before, after}, none));
  proved.push_back(limit_of("normal_from_below", N_at, {before}, y));
  proved.push_back(limit_of("normal_from_above", N_at, {after}, z));
  Provable evaluated{"2.1-normal_by_evaluation", "they are the limits from both sides"};
  for (int side : {before, after}) {
    const Expressions n = normal(side).recorded({0, side});
    add_limits(evaluated.lemmas, N_at, {side}, {n[0], n[1], n[2]});
  }
  proved.push_back(evaluated);
  const Shortened root_2 = sqrt(Shortened(2));
  for (const auto& [slug, sign] : {std::pair{"one_sided_limits_differ", 1}, {"no_sign_helps", -1}})
    proved.push_back(limit_of_number(slug, "the jump has this limit", {{normals_apart(sign, t()), root_2}}));
  proved.push_back(limit_of_number("no_continuous_normal",
                                   "the cosine of the normals at t and -t has the limit 0",
                                   {{cosine(N_after, t()), 0}}));
  for (Provable& p : proved) p.preamble = coq_source({"limits"});
  return proved;
}

}  // namespace oddity::ex02_01
