// The claims of exercise 8.1: the printed matrix is compared with elimination on the frames' axes.

#include <cmath>

#include "chapters/08_affine_algebra/01_change_of_coordinates/change_of_coordinates.hpp"
#include "chapters/numbers.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"

namespace oddity::ex08_01 {

namespace {

/// The printed matrix as it is meant.
template <class T>
Matrix2<T> printed_matrix() {
  Matrix2<T> m;
  m << T(1.0), T(1.0), T(-1.0), T(1.0);
  return m / sqrt(T(2.0));
}

/// Columns are the axes: 1 and i rotated by `share` times pi.
template <class T>
Matrix2<T> turned_axes(double share) {
  const T angle = pi_of<T>() * share, c = cos(angle), s = sin(angle);
  Matrix2<T> axes;
  axes << c, -s, s, c;
  return axes;
}
/// By elimination; the first axis must not be along the second coordinate.
template <class T>
Vector2<T> on_axes(const Matrix2<T>& axes, const Vector2<T>& vector) {
  const T multiple = axes(1, 0) / axes(0, 0);
  const T second = (vector[1] - multiple * vector[0]) / (axes(1, 1) - multiple * axes(0, 1));
  return {(vector[0] - axes(0, 1) * second) / axes(0, 0), second};
}

/// A point, and two frames whose origins differ by a multiple of `offset` that each claim sets.
template <class T>
struct FramesOf {
  double largest = 0;
  Vector2<T> origin, offset, a;

  FramesOf() = default;
  explicit FramesOf(Random& random) : largest(std::abs(random.magnitude(1e-3, 1e3))) {
    for (T* x : letters()) *x = random.between(-largest, largest);
  }
  std::array<T*, 6> letters() { return {&origin[0], &origin[1], &offset[0], &offset[1], &a[0], &a[1]}; }
  double size() const { return largest; }
  std::string where() const { return "size " + format_significant(largest, 3); }
};

/// Coordinates of the first frame's origin on the axes of the second. The origins differ by apart * offset.
ProvableFormula<FramesOf> constants(std::string text, double apart) {
  return {std::move(text), [=]<class T>(const FramesOf<T>& f) {
            const Vector2<T> second = f.origin + T(apart) * f.offset;
            return Vector2<T>(on_axes<T>(turned_axes<T>(0.25), f.origin + f.a - second) -
                              printed_matrix<T>() * f.a);
          }};
}

/// Coordinates on the first frame's axes.
template <class T>
struct PointOf {
  T a1, a2;

  PointOf() = default;
  explicit PointOf(Random& random) : a1(random.magnitude(1e-3, 1e3)), a2(random.magnitude(1e-3, 1e3)) {}
  std::array<T*, 2> letters() { return {&a1, &a2}; }
  Vector2<T> a() const { return {a1, a2}; }
  TypesetIn<T> typeset() const { return {{"a", {a1, a2}}}; }
  std::string where() const {
    return "$a$ = (" + format_significant(a1, 4) + ", " + format_significant(a2, 4) + ")";
  }
};

struct Tables {
  ProvableClaims<FramesOf> frames;
  ProvableClaims<PointOf> points;
  explicit Tables(Claims& claims) : frames(claims), points(claims) {}
};

void formulas(Tables& tables, const std::vector<FramesOf<double>>& frames,
              const std::vector<PointOf<double>>& points) {
  tables.frames.formula(
      "origin", 3977,
      "with equal origins $(c_1,c_2)=(0,0)$, and nothing else changes in example 8.1 (our reading, as that is not "
      "in the solutions: in $b=R^Ta+(c_1,c_2)$)",
      frames,
      {.quantity = R"($(c_1,c_2)=b-R^Ta$ for a random point, $b$ by elimination)",
       .truth = {"$(0,0)$", []<class T>(const FramesOf<T>&) { return Vector2<T>(T(0.0), T(0.0)); }},
       .printed = constants("equal origins", 0),
       .near_misses = {constants("origins a thousandth apart", 1e-3)}});
  const std::string transposed = R"($\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$)",
                    clockwise = R"($\frac1{\sqrt2}\begin{pmatrix}1&-1\\1&1\end{pmatrix}a$)";
  tables.points.formula(
      "matrix", 3981,
      R"($b=\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$, the fraction bar lost (our reading, as )"
      R"(example 8.1 is not in the solutions: of axes that are turned counterclockwise by $\pi/4$))",
      points,
      {.quantity = "$(b_1,b_2)$",
       .truth = {R"(elimination on axes turned by $\pi/4$)",
                 []<class T>(const PointOf<T>& p) { return on_axes<T>(turned_axes<T>(0.25), p.a()); }},
       .printed = R"($1\,\sqrt2\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$)",
       .meant = transposed,
       .near_misses = {clockwise},
       .why = filled(
           R"(The fraction bar is lost in the text at hand: $\tfrac1{\sqrt2}$. With the product the matrix )"
           R"(is no rotation, and every point is @1 times as far from the origin.)",
           {(2 * printed * Vector2d(1, 0)).norm()})});
  tables.points.formula(
      "transpose", 3991,
      R"($\frac1{\sqrt2}\begin{pmatrix}1&1\\-1&1\end{pmatrix}=R^T$, $R$ the counterclockwise rotation by $\pi/4$)",
      points,
      {.quantity = "$R^Ta$ for a random $a$",
       .truth = {R"(dot products with the columns of $R$, the axes turned by $\pi/4$)",
                 []<class T>(const PointOf<T>& p) {
                   const Matrix2<T> axes = turned_axes<T>(0.25);
                   return values(axes(0, 0) * p.a1 + axes(1, 0) * p.a2,
                                 axes(0, 1) * p.a1 + axes(1, 1) * p.a2);
                 }},
       .printed = transposed,
       .near_misses = {clockwise, R"($\begin{pmatrix}0&1\\-1&0\end{pmatrix}a$)"}});
}

/// Sine and cosine of pi/4 through the square root of two, a letter with a known square.
constexpr const char* by_root =
    R"(replace (PI * (25 / 100)) with (PI / 4) by field; rewrite ?cos_PI4, ?sin_PI4;
  pose proof (sqrt_lt_R0 2 ltac:(lra)); pose proof (sqrt_sqrt 2 ltac:(lra)) as square;
  set (root := sqrt 2) in *; clearbody root; field [square]; lra)";

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("8.1");
  Tables tables(claims);
  formulas(tables, draw<FramesOf<double>>(100, seed), draw<PointOf<double>>(100, seed));
  return claims.in_order();
}

Provables proofs() {
  Claims claims("8.1");
  Tables tables(claims);
  formulas(tables, {}, {});
  const std::vector<std::string> of_frames{"o1", "o2", "d1", "d2", "a1", "a2"}, of_point{"a1", "a2"};
  Provables proved = tables.frames.proofs("8.1", {.any = lettered<FramesOf>(of_frames),
                                                  .letters = quantified(of_frames),
                                                  .tactic = by_root,
                                                  .says = "it holds of any point and any origin"});
  ForAll<PointOf> at_any{.any = lettered<PointOf>(of_point),
                         .letters = quantified(of_point),
                         .tactic = by_root,
                         .says = "it holds of any point"};
  at_any.example.a1 = at_any.example.a2 = 1;
  for (Provable& p : tables.points.proofs("8.1", at_any)) proved.push_back(std::move(p));
  return proved;
}

}  // namespace oddity::ex08_01
