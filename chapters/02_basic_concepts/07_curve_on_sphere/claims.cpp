// The claims of exercise 2.7. The text's formulas and its listing are compared with the frame differentiated
// by dual numbers, and with w = r x r' + (r.(r' x r'')/|r'|^2) r.

#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "chapters/02_basic_concepts/07_curve_on_sphere/curve_on_sphere.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/02_basic_concepts/shared/recorded_functions.hpp"
#include "reference/text.hpp"
#include "solvers/roots.hpp"

namespace oddity::curve_on_sphere {

using space::Vector3, space::identity, limits::joined;

template <class T>
Vector<Dual<T>> moving(const Vector<T>& x, const Vector<T>& x_dot) {
  return {Dual<T>(x[0], x_dot[0]), Dual<T>(x[1], x_dot[1]), Dual<T>(x[2], x_dot[2])};
}

template <class T>
struct SampleOf {
  T t;
  Motion<T> m;
  Matrix<T> R, R_dot;  ///< the frame and its derivative by dual numbers
  Vector<T> u, b, u_dot, b_dot, w;
  T speed = length(m.v);

  SampleOf() = default;
  explicit SampleOf(double time)
      : SampleOf(time, space::motion_of(position, time), frame(Dual<double>(time, 1))) {}
  /// A sample of any motion.
  SampleOf(const T& time, const Motion<T>& any)
      : SampleOf(time, any, frame(moving(any.r, any.v), moving(any.v, any.a))) {}
  SampleOf(const T& time, const Motion<T>& motion, const Matrix<Dual<T>>& both)
      : t(time), m(motion), R(value_of(both)), R_dot(slope_of(both)) {
    u = R.column(1), b = R.column(2), u_dot = R_dot.column(1), b_dot = R_dot.column(2);
    w = angular_velocity(m);
  }
  SampleOf<Shortened> recorded() const requires std::same_as<T, double> {
    const auto exact = [](const Vector3& x) { return Vector<Shortened>{x[0], x[1], x[2]}; };
    return {t, {exact(m.r), exact(m.v), exact(m.a)}};
  }
  TypesetIn<T> typeset() const {
    return {{"t", t},
            {R"(\mathbf r)", m.r.e},
            {R"(\dot{\mathbf r})", m.v.e},
            {R"(\ddot{\mathbf r})", m.a.e},
            {R"(\mathbf u)", u.e},
            {R"(\dot{\mathbf u})", u_dot.e},
            {"R", R.e},
            {R"(\dot R)", R_dot.e}};
  }
  /// Size of the terms of r . r'.
  double size() const { return speed; }
  std::string where() const { return "$t$ = " + format_shortest(t); }
};
using Sample = SampleOf<double>;
using AtTime = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;

namespace {

const AtTime u_dot_by_duals{"dual numbers", [](const auto& s) { return s.u_dot; }};
const AtTime w_by_frame{
    R"($\mathbf r\times\dot{\mathbf r}+(\mathbf r\cdot(\dot{\mathbf r}\times\ddot{\mathbf r})/)"
    R"(|\dot{\mathbf r}|^2)\,\mathbf r$)",
    [](const auto& s) { return s.w; }};

const std::string perpendicular = R"($\mathbf r\cdot\dot{\mathbf r}=0$)";

/// Claims that are proved for the exercise's curve, in `at_time`, and for any curve on the sphere.
void curve_and_frame(Claims& claims, Table& at_time, Table& table, const std::vector<Sample>& all) {
  const auto this_curve = at_time.over(all);
  const auto claim = table.over(all);
  const std::string numbers = R"(((1-t^2)\cos\pi t,(1-t^2)\sin\pi t,t^2))", root = R"(\sqrt{(1-t^2)^2+t^4})";
  constexpr double outside = 2;
  this_curve(
      "position", 481,
      R"(The position is $((1-t^2)\cos\pi t,(1-t^2)\sin\pi t,t^2)$ times $\sqrt{(1-t^2)^2+t^4}$.)",
      {.quantity = R"($\mathbf r$)",
       .truth = {R"(the point at the angles atan2 of $1-t^2$ and $t^2$, and $\pi t$)",
                 []<class T>(const SampleOf<T>& s) {
                   const T turn = pi_of<T>() * s.t, polar = atan2(1 - s.t * s.t, s.t * s.t);
                   return values(sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar));
                 },
                 [](const auto& s) { return std::numbers::pi * std::abs(s.t); }},
       .printed = "$" + numbers + root + "$",
       .meant = "$" + numbers + "/" + root + "$",
       .why = filled(
           R"(The bar above the root is lost: the three numbers are divided by their length. Multiplied by it they )"
           R"(leave the unit sphere at every $t$ but 0 and $\pm1$: at $t=@1$ they are @2 from the origin.)",
           {outside, pow(1 - pow(outside, 2), 2) + pow(outside, 4)})});
  this_curve("on_the_sphere", 485, R"($|\mathbf r|=1$ for all $t$)",
             {"the unit sphere", [](const auto&) { return 1.0; }}, "$|" + numbers + "/" + root + "|$");
  claims.over(all)("velocity_perpendicular", 485, R"($\mathbf r\cdot\dot{\mathbf r}=0$ for all $t$)",
                   {"zero", [](const Sample&) { return 0.0; }}, {perpendicular}, {},
                   "a multiple of zero is zero");
  claims.statement<Sample>(
      "velocity_not_zero", 485,
      R"(Another column is $\mathbf u=\dot{\mathbf r}/|\dot{\mathbf r}|$ (our check: $\dot{\mathbf r}$ is not zero).)",
      all, {.printed = {R"($|\dot{\mathbf r}|>0$)"}, .near_misses = {{R"($|\dot{\mathbf r}|>2$)"}}});
  claim(
      "rotation", 485,
      R"($R=[\mathbf r\ \mathbf u\ \mathbf r\times\mathbf u]$ is an orientation matrix (our reading: a rotation).)",
      {"the unit matrix and 1", [](const auto&) { return joined(identity(), 1); }},
      R"($(R^TR,\ \mathbf r\cdot\mathbf u\times(\mathbf r\times\mathbf u))$)", R"($R^TR$ and $\det R$)");
  claim("skew_of_w", 493, R"($\mathrm{Skew}(\mathbf w)=\dot RR^T$)",
        {.truth = {R"(Skew of )" + w_by_frame.text, [](const auto& s) { return skew(s.w); }},
         .printed = R"($\dot RR^T$)",
         .near_misses = {R"($R^T\dot R$)"}});
}

const std::string no_product = "parallel vectors have no cross product, whatever their lengths and order";

void derivative_of_frame(Table& table, const std::vector<Sample>& all) {
  const auto claim = table.over(all);
  const AtTime b_dot_by_duals{"dual numbers", [](const auto& s) { return s.b_dot; }};
  claim.equation(
      "quotient_rule", 499,
      R"($\dot{\mathbf u}=(|\dot{\mathbf r}|^2\ddot{\mathbf r}-(\dot{\mathbf r}\cdot\ddot{\mathbf r})\dot{\mathbf r})/|\dot{\mathbf r}|^3$)",
      u_dot_by_duals);
  claim.equation(
      "u_dot", 503,
      R"($\dot{\mathbf u}=(\ddot{\mathbf r}-(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
      u_dot_by_duals);
  claim.equation(
      "product_rule", 509,
      R"($\frac{d}{dt}(\mathbf r\times\mathbf u)=\dot{\mathbf r}\times\mathbf u+\mathbf r\times\dot{\mathbf u}$)",
      b_dot_by_duals, no_product);
  claim.equation("product_rule_reduced", 511,
                 R"($\frac{d}{dt}(\mathbf r\times\mathbf u)=\mathbf r\times\dot{\mathbf u}$)",
                 b_dot_by_duals);
  claim("parallel", 513, R"($\dot{\mathbf r}\times\mathbf u=0$, as they are parallel)",
        {.truth = {"zero", []<class T>(const SampleOf<T>&) { return Vector<T>{}; }},
         .printed = R"($\dot{\mathbf r}\times\mathbf u$)",
         .near_misses = {R"($\mathbf r\times\mathbf u$)"},
         .changes_that_hold = no_product});
  claim("columns", 515, R"($\dot R=[\dot{\mathbf r}\ \dot{\mathbf u}\ \mathbf r\times\dot{\mathbf u}]$)",
        {"the frame by dual numbers", [](const auto& s) { return s.R_dot; }},
        R"($\begin{pmatrix}\dot{\mathbf r}&\dot{\mathbf u}&\mathbf r\times\dot{\mathbf u}\end{pmatrix}$)");

  const AtTime product_of_frames{R"($\dot RR^T$, the frame by dual numbers)",
                                 [](const auto& s) { return s.R_dot * transpose(s.R); }};
  const std::string products =
      R"(\dot{\mathbf r}\mathbf r^T+\dot{\mathbf u}\mathbf u^T+(\mathbf r\times\dot{\mathbf u})(\mathbf r\times\mathbf u)^T)";
  claim.equation("outer_products", 531, R"($\dot RR^T=)" + products + "$", product_of_frames);
  claim("unskew_is_inverse", 533, R"(Unskew is the inverse of Skew: $\mathrm{Skew}(\mathrm{Unskew}(S))=S$.)",
        product_of_frames, R"($\mathrm{Skew}(\mathrm{Unskew}(\dot RR^T))$)", R"($\dot RR^T$)");
  claim.equation("angular_velocity", 535, R"($\mathbf w=\mathrm{Unskew}()" + products + ")$", w_by_frame);
  claim(
      "only_r_v_a", 537,
      R"(Functions for $\mathbf r$, $\dot{\mathbf r}$ and $\ddot{\mathbf r}$ are all that $\mathbf w$ needs (our formula has these alone).)",
      {R"($\mathrm{Unskew}(\dot RR^T)$, the frame by dual numbers)",
       [](const auto& s) { return unskew(s.R_dot * transpose(s.R)); }},
      w_by_frame.text, R"($\mathbf w$)");
}

// ---- the listing ------------------------------------------------------------------------------------------

/// The time at which the listing's errors are shown.
constexpr double shown_time = 0.75;

/// The declaration of the listing's `ComputeTerms`.
using ComputeTerms = void (&)(double t, Vector3& R, Vector3& V, Vector3& U, Vector3& UDot);

template <class... Arguments>
Reading callable(const std::string& text, const std::string& arguments) {
  return {text,
          {{"`ComputeTerms(" + arguments + ")` can be called",
            {"the call as it is written", 1},
            {"the function as it is declared, 1 where it can be called",
             std::is_invocable_v<ComputeTerms, Arguments...> ? 1.0 : 0.0},
            exact()}}};
}

/// The printed listing's W, with its call corrected.
Vector3 w_function(const Sample& s) { return listed_w(s.m, listed_u_dot(s.m, false)); }
double error_of_listing(const Sample& s) { return length(w_function(s) - s.w); }

/// Times of stationary speed, where a.v is zero, ascending: by Brent's method between the points of a grid
/// over arctan t.
std::vector<double> stationary_times() {
  constexpr int points = 1000;
  const auto along_velocity = [](double t) {
    const Sample s(t);
    return dot(s.m.a, s.m.v);
  };
  const auto point = [](int i) { return std::tan(std::numbers::pi * ((i + 0.5) / points - 0.5)); };
  std::vector<double> all;
  for (int i = 1; i < points; ++i)
    if (const double from = point(i - 1), to = point(i); along_velocity(from) * along_velocity(to) < 0)
      all.push_back(brent(along_velocity, from, to, 1e-15).value);
  return all;
}

/// Checks that the printed listing returns w where the speed is stationary, and at the pole.
Check right_where_stationary(std::vector<double> times) {
  const std::string text = filled(R"(error of the printed listing at $t=0$, $\pm@4$, $\pm@4$ and $\pm1$)",
                                  {std::abs(times.front()), std::abs(times[1])});
  times.insert(times.end(), {-1, 1});
  std::vector<double> errors;
  double terms = 0;
  for (const double t : times) {
    const Sample s(t);
    errors.push_back(error_of_listing(s));
    terms = std::max(terms, s.speed + 2 * length(listed_u_dot(s.m, false)));
  }
  return {text,
          {"the listing's arithmetic", errors},
          {"zero", std::vector<double>(times.size())},
          rounding(terms),
          terms};
}

/// The letters of a sentence for the position, the velocity and the acceleration.
Reading letters(const std::string& text, const std::vector<std::string>& names) {
  const std::vector<std::string> vectors{"r", "v", "a"};
  long other = 0;
  for (std::size_t i = 0; i < 3; ++i) other += names[i] != vectors[i];
  return {text,
          {no_violations(R"(names that are not the vector's letter, $\mathbf r$, $\mathbf v$ or $\mathbf a$)",
                         other, 3)}};
}

AtTime listed() {
  return {"`W` as printed", [](const auto& s) { return listed_w(s.m, listed_u_dot(s.m, false)); }};
}
AtTime mended(std::string text, double last) {
  return {std::move(text), [=](const auto& s) {
            const auto W = listed_w(s.m, listed_u_dot(s.m, true));
            return values(W[0], W[1], last * W[2]);
          }};
}
AtTime with_error() {
  return {R"($\mathbf w+c\,(r_yr_z,-r_xr_z,r_xr_y)$, $c=\ddot{\mathbf r}\cdot\mathbf u/|\dot{\mathbf r}|$)",
          []<class T>(const SampleOf<T>& s) {
            const auto [x, y, z] = s.m.r.e;
            return s.w + dot(s.m.a, s.u) / s.speed * Vector<T>{y * z, -x * z, x * y};
          }};
}

void listing(Claims& claims, Table& table, const std::vector<Sample>& all) {
  const auto claim = table.over(all);
  const Sample shown(shown_time);
  const Vector3 shown_by_listing = w_function(shown);
  const std::vector<double> stationary = stationary_times();
  const double right = static_cast<double>(stationary.size()) + 2, last = stationary.back(),
               first = stationary[stationary.size() - 2];
  double most = 0;
  for (double t = -last; t < last; t += 0.001) most = std::max(most, error_of_listing(Sample(t)));
  claims.add(
      "name_of_velocity", 537,
      R"(The functions needed are those of $\mathbf r$, 'V ectorv' and $\mathbf a$.)",
      {.printed = letters(R"($\mathbf r$, V ectorv, $\mathbf a$)", {"r", "V ectorv", "a"}),
       .meant = letters(R"($\mathbf r$, $\mathbf v$, $\mathbf a$)", {"r", "v", "a"}),
       .near_misses = {letters(R"($\mathbf r$, $\mathbf u$, $\mathbf a$)", {"r", "u", "a"})},
       .why =
           R"(Vector, probably the name of a typesetting command, is printed before the letter of the velocity )"
           R"($\mathbf v=\dot{\mathbf r}$, `VFunction` in the listing.)",
       .kind = Fault::term});
  claim(
      "listing_u_dot", 561, R"(The listing's `UDot = (A - R.Dot(U)*U)/length` is $\dot{\mathbf u}$.)",
      {.quantity = R"($\dot{\mathbf u}$)",
       .truth = u_dot_by_duals,
       .printed = R"($(\ddot{\mathbf r}-(\mathbf r\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
       .corrected = R"($(\ddot{\mathbf r}-(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
       .kind = Fault::listing,
       .root = "R.Dot(U) for A.Dot(U)",
       .why = filled(
           R"(The formula above the listing takes the acceleration's component. The listing takes that of its `R`, the )"
           R"(position, which is zero: its `UDot` is $\ddot{\mathbf r}/|\dot{\mathbf r}|$, not even perpendicular to )"
           R"($\mathbf u$. At $t=@2$ the two have the dot product $@2$. It should read `A.Dot(U)`.)",
           {shown.t, dot(listed_u_dot(shown.m, false), shown.u)})});
  using Out = Vector3&;
  claims.add(
      "listing_call", 571, "`WFunction` can call `ComputeTerms(t, R, V, A, U, UDot)`.",
      {.printed = callable<double, Out, Out, Out, Out, Out>("six arguments", "t, R, V, A, U, UDot"),
       .meant = callable<double, Out, Out, Out, Out>("five arguments", "t, R, V, U, UDot"),
       .near_misses = {callable<double, Out, Out, Out>("four arguments", "t, R, V, U")},
       .why = "`ComputeTerms` is declared with five parameters, and `WFunction` has no `A`: the listing does "
              "not compile. Without the `A` it does.",
       .kind = Fault::listing});
  const auto signs = [](double middle) {
    return [=](const auto& s) {
      const auto W = listed_w(s.m, s.u_dot);
      return values(W[0], middle * W[1], W[2]);
    };
  };
  claim("listing_signs", 579,
        R"(The listing picks $\mathbf w$ out of $\dot RR^T$ with the signs $-$, $+$, $-$.)",
        {.quantity = R"(`W` for the right `UDot`)",
         .truth = w_by_frame,
         .printed = {R"($-$, $+$, $-$)", signs(1)},
         .near_misses = {{R"($-$, $-$, $-$)", signs(-1)}}});
  const auto read = [&](const std::string& text, const AtTime& formula) {
    return Reading{text, {compare("`W`", formula, w_by_frame, all)}};
  };
  Reading corrected = read("with `A.Dot(U)`", mended("`W` with `A.Dot(U)`", 1));
  corrected.checks.push_back(compare("`W` as printed", listed(), with_error(), all));
  corrected.checks.push_back(right_where_stationary(stationary));
  claims.add(
      "listing_result", 585, "`WFunction` returns the angular velocity.",
      {.printed = read("as printed", listed()),
       .corrected = corrected,
       .near_misses = {read("with `A.Dot(U)`, and + for - in `W.Z`",
                            mended("`W` with another sign in `W.Z`", -1))},
       .why = filled(
           R"(The signs are right, but what the wrong `UDot` (see `2.7-listing_u_dot`) adds to $\dot RR^T$ is )"
           R"(symmetric: the result is off by $c\,(r_yr_z,-r_xr_z,r_xr_y)$, )"
           R"($c=\ddot{\mathbf r}\cdot\mathbf u/|\dot{\mathbf r}|$. At $t=@2$ the listing gives )"
           R"($(@4,@5,@5)$, and $\mathbf w=(@5,@5,@5)$. It is right at @1 times only: where the speed is )"
           R"(stationary, $c=0$ at $t=0$, $\pm@4$ and $\pm@5$, and at the pole, $\mathbf r=\mathbf k$ at )"
           R"($t=\pm1$. Between them it is off by up to @2.)",
           {shown.t, shown_by_listing[0], shown_by_listing[1], shown_by_listing[2], shown.w[0], shown.w[1],
            shown.w[2], right, first, last, most}),
       .kind = Fault::listing,
       .root = "R.Dot(U) for A.Dot(U)"});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{Sample(0.5), Sample(0), Sample(1), Sample(-1), Sample(20), Sample(-1000)};
  for (int i = 0; i < 200; ++i) all.emplace_back(random.between(-3, 3));
  Claims claims("2.7");
  Table table(claims);
  curve_and_frame(claims, table, table, all);
  derivative_of_frame(table, all);
  listing(claims, table, all);
  return claims.in_order();
}

std::vector<Root> roots() {
  const Sample shown(shown_time);
  const double off = error_of_listing(shown), rate = length(shown.w);
  return {
      {"R.Dot(U) for A.Dot(U)",
       filled(
           R"(A sphere turned by the listing leaves its curve: at $t=@2$ the angular velocity is off by @2 in )"
           R"(@3, up to $@2^\circ$ for every radian that the sphere turns.)",
           {shown_time, off, rate, 180 / std::numbers::pi * off / rate})}};
}

// ---- proofs -----------------------------------------------------------------------------------------------

Vector<Shortened> lettered(const std::array<std::string, 3>& names) {
  return {Shortened::letter(names[0]), Shortened::letter(names[1]), Shortened::letter(names[2])};
}

Provable proof_of_perpendicular() {
  const SampleOf<Shortened> any(0.0,
                                {lettered({"(x t)", "(y t)", "(z t)"}), lettered({"dx", "dy", "dz"}), {}});
  return {"2.7-velocity_perpendicular",
          "it holds of every curve on the sphere that has a derivative",
          {{"printed",
            "(x y z : R -> R) (t dx dy dz : R)",
            {{"(forall s, x s * x s + y s * y s + z s * z s = 1)"},
             {"is_derive x t dx"},
             {"is_derive y t dy"},
             {"is_derive z t dz"}},
            {AtTime(perpendicular).recorded(any)[0] == 0},
            "by_constant x y z t dx dy dz H"}}};
}

Provables proofs() {
  Claims claims("2.7");
  Table at_time(claims), table(claims);
  curve_and_frame(claims, at_time, table, {});
  derivative_of_frame(table, {});
  listing(claims, table, {});
  table.over({})("listing_result", 585, "",
                 {.truth = w_by_frame, .printed = listed(), .corrected = mended("with `A.Dot(U)`", 1)});
  ForAll<SampleOf> all{
      .any = {0.0,
              {lettered({"r0", "r1", "r2"}), lettered({"v0", "v1", "v2"}), lettered({"a0", "a1", "a2"})}},
      .letters = "(r0 r1 r2 v0 v1 v2 a0 a1 a2 : R)",
      .tactic = "by_frame r0 r1 r2 v0 v1 v2 a0 a1 a2 H H0 H1 H2",
      .says = "it holds for any motion on the sphere that does not rest",
      .example = {0, {{0.48, 0.6, 0.64}, {0.8, 0, -0.6}, {0.32, -0.6, -1.24}}}};
  const auto& [r, v, a] = all.any.m;
  all.given = {dot(r, r).expression() == 1, dot(r, v).expression() == 0,
               (dot(v, v) + dot(r, a)).expression() == 0, above(dot(v, v).expression(), 0)};
  Provables proved = table.proofs("2.7", all);
  Provable& result = proof_of(proved, "2.7-listing_result");
  result.says =
      "as corrected " + all.says + "; as printed it has the stated error, for any motion and at an example";
  result.lemmas.insert(result.lemmas.begin() + 1,
                       {"printed_with_error", all.letters, all.given,
                        equal(listed().recorded(all.any), with_error().recorded(all.any)), all.tactic});
  all.any.t = Shortened::letter("t"), all.letters = "(t : R)", all.given.clear();
  all.tactic = "by_length t", all.says = "it holds at all times", all.example = Sample(2);
  append(proved, at_time.proofs("2.7", all));
  proved.push_back(proof_of_perpendicular());
  for (Provable& p : proved) {
    p.preamble = coq_source({"moving_frame"});
    for (Lemma& lemma : p.lemmas)
      if (lemma.name.ends_with("differs"))
        lemma.tactic = "rewrite ?cos_atan2, ?sin_atan2 by interval; interval";
  }
  return proved;
}

}  // namespace oddity::curve_on_sphere
