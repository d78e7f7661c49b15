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
  const std::string numbers = R"(((1-t^2)\cos\pi t,(1-t^2)\sin\pi t,t^2))", root = R"(\sqrt{(1-t^2)^2+t^4})";
  constexpr double outside = 2;
  at_time.formula(
      "position", 481,
      R"(The position is $((1-t^2)\cos\pi t,(1-t^2)\sin\pi t,t^2)$ times $\sqrt{(1-t^2)^2+t^4}$.)", all,
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
           R"(The bar above the root is lost in the text at hand: the three numbers are divided by their length. )"
           R"(Multiplied by it they leave the unit sphere, of which the next lines speak, at every $t$ but 0 and )"
           R"($\pm1$: at $t=@1$ they are @2 from the origin.)",
           {outside, pow(1 - pow(outside, 2), 2) + pow(outside, 4)})});
  at_time.formula("on_the_sphere", 485, R"($|\mathbf r|=1$ for all $t$)", all,
                  {.truth = {"the unit sphere", [](const auto&) { return 1.0; }},
                   .printed = "$|" + numbers + "/" + root + "|$"});
  claims.formula<Sample>("velocity_perpendicular", 485, R"($\mathbf r\cdot\dot{\mathbf r}=0$ for all $t$)",
                         all,
                         {.truth = {"zero", [](const Sample&) { return 0.0; }},
                          .printed = {perpendicular},
                          .changes_that_hold = "a multiple of zero is zero"});
  claims.statement<Sample>(
      "velocity_not_zero", 485,
      R"(Another column is $\mathbf u=\dot{\mathbf r}/|\dot{\mathbf r}|$ (our check: $\dot{\mathbf r}$ is not zero).)",
      all, {.printed = {R"($|\dot{\mathbf r}|>0$)"}, .near_misses = {{R"($|\dot{\mathbf r}|>2$)"}}});
  table.formula(
      "rotation", 485,
      R"($R=[\mathbf r\ \mathbf u\ \mathbf r\times\mathbf u]$ is an orientation matrix (our reading: a rotation).)",
      all,
      {.quantity = R"($R^TR$ and $\det R$)",
       .truth = {"the unit matrix and 1", [](const auto&) { return joined(identity(), 1); }},
       .printed = R"($(R^TR,\ \mathbf r\cdot\mathbf u\times(\mathbf r\times\mathbf u))$)"});
  table.formula("skew_of_w", 493, R"($\mathrm{Skew}(\mathbf w)=\dot RR^T$)", all,
                {.truth = {R"(Skew of )" + w_by_frame.text, [](const auto& s) { return skew(s.w); }},
                 .printed = R"($\dot RR^T$)",
                 .near_misses = {R"($R^T\dot R$)"}});
}

const std::string no_product = "parallel vectors have no cross product, whatever their lengths and order";

void derivative_of_frame(Table& table, const std::vector<Sample>& all) {
  const auto line = [&](const std::string& slug, int number, const std::string& text) {
    table.formula(slug, number, R"($\dot{\mathbf u}=)" + text, all,
                  {.quantity = R"($\dot{\mathbf u}$)", .truth = u_dot_by_duals, .printed = "$" + text});
  };
  line(
      "quotient_rule", 499,
      R"((|\dot{\mathbf r}|^2\ddot{\mathbf r}-(\dot{\mathbf r}\cdot\ddot{\mathbf r})\dot{\mathbf r})/|\dot{\mathbf r}|^3$)");
  line("u_dot", 503, R"((\ddot{\mathbf r}-(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)");
  table.formula(
      "product_rule", 509,
      R"($\frac{d}{dt}(\mathbf r\times\mathbf u)=\dot{\mathbf r}\times\mathbf u+\mathbf r\times\dot{\mathbf u}$)",
      all,
      {.truth = {"dual numbers", [](const auto& s) { return s.b_dot; }},
       .printed = R"($\dot{\mathbf r}\times\mathbf u+\mathbf r\times\dot{\mathbf u}$)",
       .changes_that_hold = no_product});
  table.formula("product_rule_reduced", 511,
                R"($\frac{d}{dt}(\mathbf r\times\mathbf u)=\mathbf r\times\dot{\mathbf u}$)", all,
                {.truth = {"dual numbers", [](const auto& s) { return s.b_dot; }},
                 .printed = R"($\mathbf r\times\dot{\mathbf u}$)"});
  table.formula("parallel", 513, R"($\dot{\mathbf r}\times\mathbf u=0$, as they are parallel)", all,
                {.truth = {"zero", []<class T>(const SampleOf<T>&) { return Vector<T>{}; }},
                 .printed = R"($\dot{\mathbf r}\times\mathbf u$)",
                 .near_misses = {R"($\mathbf r\times\mathbf u$)"},
                 .changes_that_hold = no_product});
  table.formula(
      "columns", 515, R"($\dot R=[\dot{\mathbf r}\ \dot{\mathbf u}\ \mathbf r\times\dot{\mathbf u}]$)", all,
      {.truth = {"the frame by dual numbers", [](const auto& s) { return s.R_dot; }},
       .printed =
           R"($\begin{pmatrix}\dot{\mathbf r}&\dot{\mathbf u}&\mathbf r\times\dot{\mathbf u}\end{pmatrix}$)"});

  const AtTime product_of_frames{R"($\dot RR^T$, the frame by dual numbers)",
                                 [](const auto& s) { return s.R_dot * transpose(s.R); }};
  const std::string products =
      R"(\dot{\mathbf r}\mathbf r^T+\dot{\mathbf u}\mathbf u^T+(\mathbf r\times\dot{\mathbf u})(\mathbf r\times\mathbf u)^T)";
  table.formula("outer_products", 531, R"($\dot RR^T=)" + products + "$", all,
                {.truth = product_of_frames, .printed = "$" + products + "$"});
  table.formula("unskew_is_inverse", 533,
                R"(Unskew is the inverse of Skew: $\mathrm{Skew}(\mathrm{Unskew}(S))=S$.)", all,
                {.quantity = R"($\dot RR^T$)",
                 .truth = product_of_frames,
                 .printed = R"($\mathrm{Skew}(\mathrm{Unskew}(\dot RR^T))$)"});
  table.formula("angular_velocity", 535, R"($\mathbf w=\mathrm{Unskew}()" + products + ")$", all,
                {.truth = w_by_frame, .printed = R"($\mathrm{Unskew}()" + products + ")$"});
  table.formula(
      "only_r_v_a", 537,
      R"(Functions for $\mathbf r$, $\dot{\mathbf r}$ and $\ddot{\mathbf r}$ are all that $\mathbf w$ needs (our formula has these alone).)",
      all,
      {.quantity = R"($\mathbf w$)",
       .truth = {R"($\mathrm{Unskew}(\dot RR^T)$, the frame by dual numbers)",
                 [](const auto& s) { return unskew(s.R_dot * transpose(s.R)); }},
       .printed = w_by_frame.text});
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
           R"(Vector, probably the name of a typesetting command, is printed before its letter. One of the )"
           R"(three functions is that of the velocity $\mathbf v=\dot{\mathbf r}$, `VFunction` in the )"
           R"(listing.)",
       .kind = Fault::term});
  table.formula(
      "listing_u_dot", 561, R"(The listing's `UDot = (A - R.Dot(U)*U)/length` is $\dot{\mathbf u}$.)", all,
      {.quantity = R"($\dot{\mathbf u}$)",
       .truth = u_dot_by_duals,
       .printed = R"($(\ddot{\mathbf r}-(\mathbf r\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
       .corrected = R"($(\ddot{\mathbf r}-(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u)/|\dot{\mathbf r}|$)",
       .kind = Fault::listing,
       .root = "R.Dot(U) for A.Dot(U)",
       .why = filled(
           R"(The formula above the listing takes the acceleration's component, )"
           R"($(\ddot{\mathbf r}\cdot\mathbf u)\mathbf u$. The listing takes the position's, which is zero (its `R` is )"
           R"($\mathbf r$, not the orientation matrix $R$): its `UDot` is $\ddot{\mathbf r}/|\dot{\mathbf r}|$, not )"
           R"(even perpendicular to $\mathbf u$: at $t=@2$ the two have the dot product $@2$. It should read )"
           R"(`A.Dot(U)`.)",
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
  table.formula("listing_signs", 579,
                R"(The listing picks $\mathbf w$ out of $\dot RR^T$ with the signs $-$, $+$, $-$.)", all,
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
           R"(The signs and the pairing of the components are right, but `UDot` is not (see `2.7-listing_u_dot`). )"
           R"(What it adds to $\dot RR^T$ is symmetric, so that the three entries picked are no longer those of a skew )"
           R"(matrix: the result is off by $c\,(r_yr_z,-r_xr_z,r_xr_y)$, )"
           R"($c=\ddot{\mathbf r}\cdot\mathbf u/|\dot{\mathbf r}|$. At $t=@2$ the listing gives )"
           R"($(@4,@5,@5)$, and $\mathbf w=(@5,@5,@5)$. It is right at @1 times only: )"
           R"(where the speed is stationary, $c=0$ at $t=0$, $\pm@4$ and $\pm@5$, and at the pole, )"
           R"($\mathbf r=\mathbf k$ at $t=\pm1$; between them it is off by up to @2.)",
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

/// The speed as the letter l, the velocity l u, and the acceleration in the frame of r, u and b.
constexpr const char* by_frame = R"(
  rename H into rr, H0 into rv, H1 into va, H2 into vv;
  pose proof (sqrt_lt_R0 _ vv) as positive;
  assert (square : sqrt (v0 * v0 + v1 * v1 + v2 * v2) * sqrt (v0 * v0 + v1 * v1 + v2 * v2) =
      v0 * v0 + v1 * v1 + v2 * v2) by (apply sqrt_sqrt; lra);
  revert positive square; generalize (sqrt (v0 * v0 + v1 * v1 + v2 * v2)) as l; intros l positive square;
  rewrite <- ?square; rewrite <- square in va;
  set (u0 := v0 / l); set (u1 := v1 / l); set (u2 := v2 / l);
  assert (w0 : v0 = l * u0) by (unfold u0; field; lra);
  assert (w1 : v1 = l * u1) by (unfold u1; field; lra);
  assert (w2 : v2 = l * u2) by (unfold u2; field; lra);
  clearbody u0 u1 u2; subst v0 v1 v2;
  assert (uu : u0 * u0 + u1 * u1 + u2 * u2 = 1) by (apply Rmult_eq_reg_l with (l * l); [lra | nra]);
  assert (ru : r0 * u0 + r1 * u1 + r2 * u2 = 0) by (apply Rmult_eq_reg_l with l; [lra | lra]);
  destruct (orthonormal _ _ _ _ _ _ rr uu ru) as
    ((bb & rb & ub) & (x0 & x1 & x2) & (y0 & y1 & y2) & (z0 & z1 & z2) & in_frame);
  destruct (in_frame a0 a1 a2) as (f0 & f1 & f2);
  destruct (in_frame 0 0 1) as (k20 & k21 & _); destruct (in_frame 0 1 0) as (k10 & _); clear in_frame;
  replace (r0 * a0 + r1 * a1 + r2 * a2) with (- (l * l)) in f0, f1, f2 by lra;
  set (b0 := r1 * u2 - r2 * u1) in *; set (b1 := r2 * u0 - r0 * u2) in *; set (b2 := r0 * u1 - r1 * u0) in *;
  set (b := u0 * a0 + u1 * a1 + u2 * a2) in *; set (c := b0 * a0 + b1 * a1 + b2 * a2) in *;
  repeat match goal with
  | |- context [?x / (2 * l)] => replace (x / (2 * l)) with b by (unfold b; field; lra)
  | |- context [?x / (l * l)] => replace (x / (l * l)) with (c / l) by (unfold c, b0, b1, b2; field; lra)
  end;
  try replace (a0 * u0 + a1 * u1 + a2 * u2) with b by (unfold b; ring);
  try replace (l * u0 * a0 + l * u1 * a1 + l * u2 * a2) with (l * b) by (unfold b; ring);
  clearbody b c; clearbody b0 b1 b2; subst a0 a1 a2;
  repeat match goal with
  | |- context [(- (l * l) * ?r + b * ?u + c * ?n - ?x) / l] =>
    replace ((- (l * l) * r + b * u + c * n - x) / l) with (c / l * n - l * r) by (field; lra)
  end;
  try replace (r1 * (c / l * b2 - l * r2) - r2 * (c / l * b1 - l * r1)) with (- (c / l) * u0) by (field [z0]; lra);
  try replace (l * u1 * u2 + r1 * (c / l * b2 - l * r2) - (l * u2 * u1 + r2 * (c / l * b1 - l * r1))) with (- (c / l) * u0) by (field [z0]; lra);
  try replace (r2 * (c / l * b0 - l * r0) - r0 * (c / l * b2 - l * r2)) with (- (c / l) * u1) by (field [z1]; lra);
  try replace (l * u2 * u0 + r2 * (c / l * b0 - l * r0) - (l * u0 * u2 + r0 * (c / l * b2 - l * r2))) with (- (c / l) * u1) by (field [z1]; lra);
  try replace (r0 * (c / l * b1 - l * r1) - r1 * (c / l * b0 - l * r0)) with (- (c / l) * u2) by (field [z2]; lra);
  try replace (l * u0 * u1 + r0 * (c / l * b1 - l * r1) - (l * u1 * u0 + r1 * (c / l * b0 - l * r0))) with (- (c / l) * u2) by (field [z2]; lra);
  try rewrite ru;
  repeat match goal with
  | |- context [(- (l * l) * ?r + b * ?u + c * ?n - 0 * ?u) / l] =>
    replace ((- (l * l) * r + b * u + c * n - 0 * u) / l) with (b / l * u + c / l * n - l * r)
      by (field; lra)
  end;
  try replace (r1 * (b / l * u2 + c / l * b2 - l * r2) - r2 * (b / l * u1 + c / l * b1 - l * r1)) with (b / l * b0 - c / l * u0)
    by (field [x0 z0]; lra);
  try replace (r2 * (b / l * u0 + c / l * b0 - l * r0) - r0 * (b / l * u2 + c / l * b2 - l * r2)) with (b / l * b1 - c / l * u1)
    by (field [x1 z1]; lra);
  try replace (r0 * (b / l * u1 + c / l * b1 - l * r1) - r1 * (b / l * u0 + c / l * b0 - l * r0)) with (b / l * b2 - c / l * u2)
    by (field [x2 z2]; lra);
  assert (bb12 : b1 * b2 = - r1 * r2 - u1 * u2) by lra;
  assert (bb02 : b0 * b2 = - r0 * r2 - u0 * u2) by lra;
  assert (bb01 : b0 * b1 = - r0 * r1 - u0 * u1) by lra;
  assert (rr0 : r0 * r0 = 1 - r1 * r1 - r2 * r2) by lra;
  assert (uu0 : u0 * u0 = 1 - u1 * u1 - u2 * u2) by lra;
  assert (bb0 : b0 * b0 = 1 - b1 * b1 - b2 * b2) by lra;
  assert (ru0 : r0 * u0 = - r1 * u1 - r2 * u2) by lra;
  assert (rb0 : r0 * b0 = - r1 * b1 - r2 * b2) by lra;
  assert (ub0 : u0 * b0 = - u1 * b1 - u2 * b2) by lra;
  first
    [ lra | field; lra | field [z0 z1 z2 y0 y1 y2 x0 x1 x2]; lra | field [y0 y1 y2 rr0]; lra | field [x0 y0 bb12]; lra | field [x1 y1 bb02]; lra | field [x2 y2 bb01]; lra
     | field [rr0 uu0 bb0 ru0 rb0 ub0]; lra ])";

/// r.r is constant, and half its derivative is zero.
constexpr const char* by_constant = R"(
  rename H into unit;
  assert (still : x t * dx + y t * dy + z t * dz = 0)
    by (assert (changes : is_derive (fun s => x s * x s + y s * y s + z s * z s) t
                            (2 * (x t * dx + y t * dy + z t * dz)))
          by (auto_derive;
              [ repeat split; eexists; eassumption
              | change (fun s => x s) with x; change (fun s => y s) with y; change (fun s => z s) with z;
                rewrite (is_derive_unique x t dx), (is_derive_unique y t dy), (is_derive_unique z t dz)
                  by assumption; ring ]);
        assert (stays : is_derive (fun s => x s * x s + y s * y s + z s * z s) t 0)
          by (apply (is_derive_ext (fun _ => 1)); [intros; symmetry; apply unit | apply @is_derive_const]);
        apply is_derive_unique in changes; apply is_derive_unique in stays; lra);
  specialize (unit t); generalize dependent (x t); intros x'; generalize dependent (y t); intros y';
  generalize dependent (z t); intros z' *; nsatz)";

/// The root is not zero.
constexpr const char* by_length = R"(
  replace ((1 - t ^ 2) ^ 2 + t ^ 4) with (t * t * (t * t) + (1 - t * t) * (1 - t * t)) by ring;
  assert (positive : 0 < t * t * (t * t) + (1 - t * t) * (1 - t * t)) by nra;
  rewrite ?cos_atan2, ?sin_atan2 by lra;
  replace ((1 - t * t) * (1 - t * t) + t * t * (t * t)) with (t * t * (t * t) + (1 - t * t) * (1 - t * t))
    by ring;
  pose proof (sqrt_lt_R0 _ positive) as longer;
  assert (square : sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t)) *
                     sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t)) =
                   t * t * (t * t) + (1 - t * t) * (1 - t * t)) by (apply sqrt_sqrt; lra);
  set (q := sqrt (t * t * (t * t) + (1 - t * t) * (1 - t * t))) in *; clearbody q;
  assert (circle : sin (PI * t) * sin (PI * t) = 1 - cos (PI * t) * cos (PI * t))
    by (pose proof (sin2_cos2 (PI * t)) as all; unfold Rsqr in all; lra);
  try match goal with |- context [sqrt ?x] => rewrite (root_is x 1) by (try lra; field [circle square]; lra) end;
  first [reflexivity | field; lra])";

constexpr const char* by_bounds = "rewrite ?cos_atan2, ?sin_atan2 by interval; interval";

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
            by_constant}}};
}

Provables proofs() {
  Claims claims("2.7");
  Table at_time(claims), table(claims);
  curve_and_frame(claims, at_time, table, {});
  derivative_of_frame(table, {});
  listing(claims, table, {});
  table.formula("listing_result", 585, "", {},
                {.truth = w_by_frame, .printed = listed(), .corrected = mended("with `A.Dot(U)`", 1)});
  ForAll<SampleOf> all{
      .any = {0.0,
              {lettered({"r0", "r1", "r2"}), lettered({"v0", "v1", "v2"}), lettered({"a0", "a1", "a2"})}},
      .letters = "(r0 r1 r2 v0 v1 v2 a0 a1 a2 : R)",
      .tactic = by_frame,
      .says = "it holds for any motion on the sphere that does not rest",
      .example = {0, {{0.48, 0.6, 0.64}, {0.8, 0, -0.6}, {0.32, -0.6, -1.24}}}};
  const auto& [r, v, a] = all.any.m;
  all.given = {dot(r, r).expression() == 1, dot(r, v).expression() == 0,
               (dot(v, v) + dot(r, a)).expression() == 0, above(dot(v, v).expression(), 0)};
  Provables proved = table.proofs("2.7", all);
  Provable& result = *std::ranges::find(proved, "2.7-listing_result", &Provable::claim);
  result.says =
      "as corrected " + all.says + "; as printed it has the stated error, for any motion and at an example";
  result.lemmas.insert(result.lemmas.begin() + 1,
                       {"printed_with_error", all.letters, all.given,
                        equal(listed().recorded(all.any), with_error().recorded(all.any)), all.tactic});
  all.any.t = Shortened::letter("t"), all.letters = "(t : R)", all.given.clear();
  all.tactic = by_length, all.says = "it holds at all times", all.example = Sample(2);
  std::ranges::move(at_time.proofs("2.7", all), std::back_inserter(proved));
  proved.push_back(proof_of_perpendicular());
  for (Provable& p : proved) {
    p.preamble =
        coq_source({"orthonormal", "root", "atan2"}) + "From Coquelicot Require Import AutoDerive.\n";
    for (Lemma& lemma : p.lemmas)
      if (lemma.name.ends_with("differs")) lemma.tactic = by_bounds;
  }
  return proved;
}

}  // namespace oddity::curve_on_sphere

namespace oddity {

Provables proofs_2_7() { return curve_on_sphere::proofs(); }

}  // namespace oddity
