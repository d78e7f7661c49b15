// The claims of exercise 2.5. Every line of the proof is checked by the quaternion and dual numbers, at
// moments with |D'| = 1, which the proof assumes, and with any |D'|.
//   U1 = D, U2 = D', U3 = D x D', S = Skew(D), sigma = sin(theta), gamma = cos(theta), lambda = |D'|,
//   W = R' R^T

#include "chapters/claims.hpp"
#include "chapters/provable_claims.hpp"

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"
#include "reference/text.hpp"

namespace oddity::rotating_axis {

namespace {

using namespace space;
using limits::joined;

// ---- moments of motions -----------------------------------------------------------------------------------

/// Axis and angle as functions of time.
struct Turning {
  Vector3 p, q, r;  ///< D is along p + q sin(t) + r t^2
  double a, b, c;   ///< theta = a + b t + c cos(t)

  template <class T>
  Vector<T> axis(const T& t) const {
    using std::sin;
    const auto along = [&](std::size_t i) { return T(p[i]) + T(q[i]) * sin(t) + T(r[i]) * t * t; };
    return unit(Vector<T>{along(0), along(1), along(2)});
  }
  template <class T>
  T angle(const T& t) const {
    using std::cos;
    return T(a) + T(b) * t + T(c) * cos(t);
  }
};

/// A moment of such a motion, in the letters of the text.
template <class T>
struct MomentOf {
  T theta, theta_dot, sigma, gamma, lambda;
  Vector<T> U1, U2, U3, w;
  Matrix<T> I = identity<T>(), U, S, S_dot, S2_dot, R, R_dot,
            W;  ///< R from the quaternion, derivatives by dual numbers

  MomentOf(const Vector<Dual<T>>& axis, const Dual<T>& angle) {
    using std::cos, std::sin;
    const Quaternion<Dual<T>> q = quaternion(axis, angle);
    const Matrix<Dual<T>> skew_axis = skew(axis), turned = matrix(q);
    theta = angle.value, theta_dot = angle.slope, sigma = sin(theta), gamma = cos(theta);
    U1 = value_of(axis), U2 = slope_of(axis), U3 = cross(U1, U2), lambda = length(U2), w = turning(q);
    U = Matrix<T>::columns(U1, U2, U3);
    S = value_of(skew_axis), S_dot = slope_of(skew_axis), S2_dot = slope_of(skew_axis * skew_axis);
    R = value_of(turned), R_dot = slope_of(turned), W = R_dot * transpose(R);
  }

  /// Concatenates the numbers of all parts.
  template <class... Parts>
  static std::vector<T> row(const Parts&... parts) {
    std::vector<T> all;
    const auto append = [&](const auto& part) {
      if constexpr (std::convertible_to<decltype(part), T>)
        all.push_back(part);
      else
        for (const auto& x : part) all.push_back(T(x));
    };
    (append(parts), ...);
    return all;
  }
};

struct Moment : MomentOf<double> {
  double t;
  Solved<Value> S_slope;  ///< S' by differences, extrapolated
  double size;            ///< size of the terms in R' R^T, on unit vectors
  double frame_size;      ///< size of these terms on the vectors U

  /// The moment `at`, with time running `rate` times as fast.
  Moment(const Turning& turning_axis, double at, double rate)
      : MomentOf(turning_axis.axis(Dual<double>(at, rate)), turning_axis.angle(Dual<double>(at, rate))),
        t(at) {
    size = (1 + std::abs(theta)) * (1 + lambda + std::abs(theta_dot));
    frame_size = (1 + lambda * lambda) * size;
    const double step = 0.25 / (1 + std::abs(rate));
    const auto difference = [&](double h) {
      const auto then = [&](double s) { return skew(turning_axis.axis(t + rate * s)); };
      return Value(0.5 / h * (then(h) - then(-h)));
    };
    S_slope = limits::limit_at_zero(difference, step, 8);
    S_slope.error_estimate += 0x1p-48 * std::ldexp(1 / step, 8);
  }
  /// Empty: the sizes of terms are given instead.
  std::array<double*, 0> letters() { return {}; }
  TypesetLetters typeset() const { return {{"R", R}, {R"(\dot R)", R_dot}, {R"(\dot{\mathbf D})", U2}}; }
  std::string where() const {
    return "$t$ = " + format_shortest(t) + R"(, $\theta$ = )" + format_significant(theta, 4) +
           R"(, $|\dot{\mathbf D}|$ = )" + format_significant(lambda, 4);
  }
};
using M = const Moment&;

/// Moments whose tolerance is the error of the differences.
struct Differenced : Moment {
  Tolerance tolerance(double) const { return {S_slope.error_estimate, "the extrapolation's error estimate"}; }
};

/// Moments of random motions: with any |D'|; with time scaled so that |D'| = 1; both of these; and all
/// including those about a fixed axis.
struct Moments {
  std::vector<Moment> any, unit_speed, moving, all;
  explicit Moments(double seed) {
    Random random(seed);
    const auto vector = [](const std::array<double, 3>& x) { return Vector3{x[0], x[1], x[2]}; };
    for (int i = 0; i < 200; ++i) {
      Turning motion{3.0 * vector(random.direction()), vector(random.point(0.8)),
                     vector(random.point(0.8)),        random.between(-7, 7),
                     random.magnitude(0.01, 10),       random.between(-1, 1)};
      const double t = random.between(-1, 1);
      if (i % 20 == 9) motion.a += 0.01 - motion.angle(t);
      any.emplace_back(motion, t, random.magnitude(0.1, 10));
      unit_speed.emplace_back(motion, t, 1 / Moment(motion, t, 1).lambda);
      motion.q = motion.r = {0, 0, 0};
      if (i % 20 == 19) all.emplace_back(motion, t, 1);
    }
    moving = any;
    moving.insert(moving.end(), unit_speed.begin(), unit_speed.end());
    all.insert(all.begin(), moving.begin(), moving.end());
  }
};

// ---- lines of the proof -----------------------------------------------------------------------------------

using Form = Formula<Moment>;
double of_turn(M m) { return 1 + std::abs(m.theta); }
double of_squares(M m) { return m.size * m.size; }

/// A formula in the letters of a moment and optionally a number k: computed, and recorded for proofs.
struct InLetters {
  std::function<Value(M, double k)> of;
  std::function<Expressions(const MomentOf<Shortened>&, double k)> recorded;

  template <class F>
  InLetters(const F& f)
      : of([f](M m, double k) { return Value(at(f, static_cast<const MomentOf<double>&>(m), k)); }),
        recorded(
            [f](const MomentOf<Shortened>& m, double k) { return detail::recorded_value(at(f, m, k)); }) {}

 private:
  template <class F, class Letters>
  static auto at(const F& f, const Letters& m, double k) {
    if constexpr (std::invocable<const F&, const Letters&, double>)
      return f(m, k);
    else
      return f(m);
  }
};

/// A line that contains a number k, which is 1 as printed.
struct Line {
  std::string_view slug;
  int number;
  std::string says, quantity;
  InLetters truth, text;
  std::function<double(M)> size = &Moment::frame_size;
  std::string by = "quaternion and dual numbers";
  double near = -1;
  std::string miss = {};  ///< the line with `near` for k, unless that is a sign or a term
};

Reading reading(const Line& line, const std::string& text, double k, const std::vector<Moment>& moments) {
  const Form with_k{text, [&](M m) { return line.text.of(m, k); }, line.size};
  const Form truth{line.by, [&](M m) { return line.truth.of(m, 1); }};
  return {text, {compare(line.quantity, with_k, truth, moments)}};
}

/// The claims, and the lines that have proofs.
struct Statements : Claims {
  using Claims::Claims;
  std::vector<Line> for_any, for_unit_speed;
};

/// Claims lines that hold at all these moments.
void lines(Statements& claims, const std::vector<Moment>& moments, const std::vector<Line>& all,
           bool unit_speed = false) {
  for (const Line& line : all) {
    const std::string miss = !line.miss.empty() ? line.miss
                             : line.near == -1  ? "a sign flipped"
                             : line.near == 0   ? "a term dropped"
                                                : format_shortest(line.near) + " in the place of 1";
    claims.add(line.slug, line.number, line.says,
               {.printed = reading(line, "as printed", 1, moments),
                .near_misses = {reading(line, miss, line.near, moments)}});
    (unit_speed ? claims.for_unit_speed : claims.for_any).push_back(line);
  }
}
/// Claims lines that need |D'| = 1.
void unit_lines(Statements& claims, const Moments& moments, const std::vector<Line>& all) {
  claims.for_unit_speed.insert(claims.for_unit_speed.end(), all.begin(), all.end());
  for (const Line& line : all)
    claims.add(line.slug, line.number, line.says + R"( (our condition: $|\dot{\mathbf D}|=1$))",
               {.printed = reading(line, R"(where $|\dot{\mathbf D}|=1$)", 1, moments.unit_speed),
                .near_misses = {
                    reading(line, R"(where $|\dot{\mathbf D}|=1$, a sign flipped)", -1, moments.unit_speed),
                    reading(line, R"(for any $|\dot{\mathbf D}|$)", 1, moments.any)}});
}

template <class T>
std::vector<T> twice(const Vector<T>& x) {
  return MomentOf<T>::row(x, x);
}
template <class T>
Vector<T> back(const MomentOf<T>& m, const Vector<T>& x) {
  return transpose(m.R) * x;
}

void rotation_and_derivative(Statements& claims, const Moments& moments) {
  claims.formula<Moment>(
      "skew_of_w", 317, R"($\mathrm{Skew}(\mathbf w)=\dot RR^T$)", moments.all,
      {.truth =
           {R"($\mathrm{Skew}(\mathbf w)$, $\mathbf w=2\dot qq^*$ in dual numbers, $q$ the quaternion of )"
            R"($R$)",
            [](const auto& m) { return skew(m.w); }, &Moment::size},
       .printed = {R"($\dot RR^T$)"},
       .near_misses = {{R"($R^T\dot R$, which has $\mathbf w$ in the body's frame)",
                        [](const auto& m) { return transpose(m.R) * m.R_dot; }}}});
  claims.for_any.push_back(
      {"skew_of_w", 317, {}, {}, [](const auto& m) { return skew(m.w); }, [](const auto& m) { return m.W; }});
  lines(claims, moments.all,
        {{"rotation_matrix", 319, R"($R=I+\sigma S+(1-\gamma)S^2$)", "$R$", [](const auto& m) { return m.R; },
          [](const auto& m, double k) { return m.I + k * m.sigma * m.S + (1 - m.gamma) * (m.S * m.S); },
          of_turn},
         {"transpose", 319, R"($R^T=I-\sigma S+(1-\gamma)S^2$)", "$R^T$",
          [](const auto& m) { return transpose(m.R); },
          [](const auto& m, double k) { return m.I - k * m.sigma * m.S + (1 - m.gamma) * (m.S * m.S); },
          of_turn}});
  std::vector<Differenced> differenced;
  for (M m : moments.moving) differenced.push_back({m});
  claims.formula<Differenced>("derivative_of_s", 321, R"($\dot S=\mathrm{Skew}(\dot{\mathbf D})$)",
                              differenced,
                              {.quantity = R"($\dot S$)",
                               .truth = {R"(differences of $\mathrm{Skew}(\mathbf D(t))$, extrapolated)",
                                         [](const auto& m) { return m.S_slope.value; }},
                               .printed = {R"($\mathrm{Skew}(\dot{\mathbf D})$)"}});
  lines(claims, moments.moving,
        {{"derivative_of_r", 323,
          R"($\dot R=\sigma\dot S+\dot\theta\gamma S+(1-\gamma)(S\dot S+\dot SS)+\dot\theta\sigma S^2$)",
          R"($\dot R$)", [](const auto& m) { return m.R_dot; },
          [](const auto& m, double k) {
            return m.sigma * m.S_dot + m.theta_dot * m.gamma * m.S +
                   (1 - m.gamma) * (m.S * m.S_dot + m.S_dot * m.S) + k * m.theta_dot * m.sigma * (m.S * m.S);
          },
          &Moment::size},
         {"no_power_rule", 325,
          R"($\frac{d}{dt}S^2$ is not generally $2S\dot S$ (our check: it is $S\dot S+\dot SS$).)",
          R"($\frac{d}{dt}S^2$)", [](const auto& m) { return m.S2_dot; },
          [](const auto& m, double k) { return (2 - k) * (m.S * m.S_dot) + k * (m.S_dot * m.S); },
          &Moment::size, "dual numbers", 0, "twice the term"}});
}

/// Reconstructs the matrix from its images of a, b and c.
template <class T>
Matrix<T> from_images(const Matrix<T>& matrix, const Vector<T>& a, const Vector<T>& b, const Vector<T>& c,
                      double k) {
  return 1 / dot(a, cross(b, c)) *
         (outer(matrix * a, cross(b, c)) + outer(matrix * b, cross(c, a)) +
          k * outer(matrix * c, cross(a, b)));
}

void matrices_by_images(Statements& claims, const Moments& moments) {
  const std::string itself = "the matrix itself";
  lines(claims, moments.unit_speed,
        {{"determined_by_images", 327,
          "An invertible matrix is determined by the images of three linearly independent vectors.", "$M$",
          [](const auto& m) { return m.R_dot + 2.0 * m.I; },
          [](const auto& m, double k) {
            return from_images(m.R_dot + 2.0 * m.I, m.U1 + m.U2, m.U2 + 2.0 * m.U3, m.U3 - m.U1, k);
          },
          [](const auto& m) { return 10 * m.size; }, itself, 0},
         {"frame_is_a_rotation", 331,
          R"(Where $|\dot{\mathbf D}|=1$, $U$ is a rotation matrix: its inverse is its transpose.)",
          R"($U^TU$, $\det U$)", [](const auto& m) { return m.row(m.I, 1); },
          [](const auto& m, double k) {
            const auto U = m.U.columns(m.U1, m.U2, k * m.U3);
            return m.row(transpose(U) * U, determinant(U));
          },
          [](M) { return 4.0; }, "a rotation"},
         {"matrix_from_images", 333, R"($M=AU^T$ where $|\dot{\mathbf D}|=1$)", "$M$",
          [](const auto& m) { return m.R_dot; },
          [](const auto& m, double k) { return m.R_dot * m.U * (k == 1 ? transpose(m.U) : m.U); },
          &Moment::size, itself, 0, "$U$ in the place of its transpose"}},
        true);
  const auto determinants = [&](const std::string& text, double unit) {
    const Form shifted{"the determinant", [=](M m) { return determinant(m.W + unit * m.I); },
                       [](const auto& m) { return std::pow(m.size, 3); }};
    return compare(text, shifted, {"0", [](M) { return 0.0; }}, moments.all);
  };
  const Form invariants{
      R"($|\mathbf w|$ times the trace of $\dot RR^T$, and the sum of its principal minors)",
      [](M m) {
        const auto minor = [&](std::size_t i, std::size_t j) {
          return m.W(i, i) * m.W(j, j) - m.W(i, j) * m.W(j, i);
        };
        return values(length(m.w) * (m.W(0, 0) + m.W(1, 1) + m.W(2, 2)),
                      minor(0, 1) + minor(0, 2) + minor(1, 2));
      },
      of_squares};
  const Form from_images{"$AU^T$", [](const auto& m) { return m.W * m.U * transpose(m.U); },
                         &Moment::frame_size};
  const Form from_shifted_images{"$AU^T$", [](const auto& m) { return (m.W + m.I) * m.U * transpose(m.U); },
                                 &Moment::frame_size};
  claims.add(
      "applied_to_singular", 335,
      R"(What is said of an invertible matrix (line 327) is applied to $\dot RR^T$.)",
      {.printed = {R"($\dot RR^T$ is invertible)",
                   {in_all<Moment>(R"($\dot RR^T$ is regular)", moments.all,
                                   [](const auto& m) {
                                     return std::abs(determinant(m.W)) > 1e-9 * std::pow(length(m.w), 3);
                                   })}},
       .corrected = {R"($\dot RR^T$ is singular, and determined by its images all the same)",
                     {determinants(R"($\det\dot RR^T$)", 0),
                      compare(R"(with it, what makes the eigenvalues $0,\pm i|\mathbf w|$)", invariants,
                              {R"($(0,|\mathbf w|^2)$)", [](M m) { return values(0, dot(m.w, m.w)); }},
                              moments.all),
                      compare(R"($\dot RR^T$ from its images, $AU^T$)", from_images,
                              {R"($\dot RR^T$)", [](const auto& m) { return m.W; }}, moments.unit_speed)}},
       .in_view = {R"(for an invertible matrix, such as $\dot RR^T+I$)",
                   {in_all<Moment>(R"($\dot RR^T+I$ is regular)", moments.all,
                                   [](const auto& m) { return std::abs(determinant(m.W + m.I)) > 0.5; }),
                    compare(R"($\dot RR^T+I$ from its images, $AU^T$)", from_shifted_images,
                            {R"($\dot RR^T+I$)", [](const auto& m) { return m.W + m.I; }},
                            moments.unit_speed)}},
       .near_misses = {{R"(so is $\dot RR^T+I$)", {determinants(R"($\det(\dot RR^T+I)$)", 1)}}},
       .why =
           "The rule is right for the matrices that it speaks of, and leaves out the one that it is needed for: a "
           "skew $3\\times3$ matrix $K$ has $\\det K=\\det K^T=-\\det K$, which is 0. The eigenvalues of "
           "$\\dot RR^T$ are $0,\\pm i|\\mathbf w|$ at every moment. The conclusion is right: $M=AU^T$ follows "
           "from $MU=A$ for every $M$; it is $U$ that has to be invertible.",
       .kind = Fault::left_out,
       .root = "a singular matrix"});
}

/// D, D' and D x D', the last two optionally divided by |D'|.
template <class T>
Matrix<T> frame_of(const MomentOf<T>& m, bool second, bool third) {
  const T one = 1.0;
  return Matrix<T>::columns(m.U1, m.U2 / (second ? m.lambda : one), m.U3 / (third ? m.lambda : one));
}

void frame(Statements& claims, const Moments& moments) {
  const auto gram = [](const std::string& text, bool second, bool third) {
    const auto frame = [=](M m) { return frame_of<double>(m, second, third); };
    return Form{text, [=](M m) { return transpose(frame(m)) * frame(m); },
                [=](M m) { return 1 + size_of(frame(m)) * size_of(frame(m)); }};
  };
  claims.formula<Moment>(
      "orthonormal_frame", 337,
      R"($\mathbf U_1=\mathbf D$, $\mathbf U_2=\dot{\mathbf D}$ and $\mathbf U_3=\mathbf D\times\dot{\mathbf D}$ )"
      R"(are unit vectors at right angles.)",
      moments.any,
      {.quantity = "$U^TU$",
       .truth = {"the unit matrix", [](const auto& m) { return m.I; }},
       .printed = gram(R"($\mathbf U_2=\dot{\mathbf D}$, $\mathbf U_3=\mathbf D\times\dot{\mathbf D}$)",
                       false, false),
       .corrected = gram(
           R"($\mathbf U_2=\dot{\mathbf D}/|\dot{\mathbf D}|$, $\mathbf U_3=\mathbf D\times\mathbf U_2$)",
           true, true),
       .near_misses = {gram(
           R"($\mathbf U_2=\dot{\mathbf D}/|\dot{\mathbf D}|$, $\mathbf U_3=\mathbf D\times\dot{\mathbf D}$)",
           true, false)},
       .kind = Fault::formula,
       .root = "length of the axis' rate",
       .why =
           "$\\dot{\\mathbf D}$ is perpendicular to $\\mathbf D$, but its length $\\lambda=|\\dot{\\mathbf "
           "D}|$ is $1$ only when the axis moves so; it is $0$ when the axis is fixed, and then there is no "
           "such frame at all. With the printed vectors $\\mathbf U_2\\times\\mathbf U_3$ and $\\dot "
           "S\\mathbf U_3$ are $\\lambda^2\\mathbf U_1$, and the lines that use them fail for "
           "$\\lambda\\ne1$. With $\\mathbf U_2=\\dot{\\mathbf D}/\\lambda$ every $\\sigma$ and every "
           "$1-\\gamma$ of the last steps gets a factor $\\lambda$, which $\\lambda\\mathbf "
           "U_2=\\dot{\\mathbf D}$ takes up again: the result holds for every $\\lambda$, zero included."});
  unit_lines(claims, moments,
             {{"cross_products", 341,
               R"($\mathbf U_1=\mathbf U_2\times\mathbf U_3$, $\mathbf U_2=\mathbf U_3\times\mathbf U_1$, )"
               R"($\mathbf U_3=\mathbf U_1\times\mathbf U_2$)",
               R"($\mathbf U_1$, $\mathbf U_2$, $\mathbf U_3$)",
               [](const auto& m) { return m.row(m.U1, m.U2, m.U3); },
               [](const auto& m, double k) {
                 return m.row(k * cross(m.U2, m.U3), cross(m.U3, m.U1), cross(m.U1, m.U2));
               },
               &Moment::frame_size, R"($\mathbf D$ and $\dot{\mathbf D}$ by dual numbers)"},
              {"images_under_s_dot", 345,
               R"($\dot S\mathbf U_1=-\mathbf U_3$, $\dot S\mathbf U_2=0$, $\dot S\mathbf U_3=\mathbf U_1$)",
               R"($\dot S\mathbf U_1$, $\dot S\mathbf U_2$, $\dot S\mathbf U_3$)",
               [](const auto& m) { return m.row(m.S_dot * m.U1, m.S_dot * m.U2, m.S_dot * m.U3); },
               [](const auto& m, double k) { return m.row(-m.U3, Vector3{}, k * m.U1); }, &Moment::frame_size,
               R"(products with the matrix $\dot S$ by dual numbers)"}});
  lines(
      claims, moments.moving,
      {{"images_under_s", 343, R"($S\mathbf U_1=0$, $S\mathbf U_2=\mathbf U_3$, $S\mathbf U_3=-\mathbf U_2$)",
        R"($S\mathbf U_1$, $S\mathbf U_2$, $S\mathbf U_3$)",
        [](const auto& m) { return m.row(m.S * m.U1, m.S * m.U2, m.S * m.U3); },
        [](const auto& m, double k) { return m.row(Vector3{}, m.U3, -k * m.U2); }, &Moment::frame_size,
        "products with the matrix $S$"}});
}

void images_of_the_frame(Statements& claims, const Moments& moments) {
  lines(claims, moments.moving,
        {{"rt_u1", 349,
          R"($R^T\mathbf U_1=\mathbf U_1-\sigma S\mathbf U_1+(1-\gamma)S^2\mathbf U_1=\mathbf U_1$)",
          R"($R^T\mathbf U_1$)", [](const auto& m) { return twice(back(m, m.U1)); },
          [](const auto& m, double k) {
            return m.row(m.U1 - m.sigma * (m.S * m.U1) + (1 - m.gamma) * (m.S * (m.S * m.U1)), k * m.U1);
          }},
         {"rt_u2",
          351,
          R"($R^T\mathbf U_2=\mathbf U_2-\sigma\mathbf U_3-(1-\gamma)\mathbf U_2=\gamma\mathbf U_2)"
          R"(-\sigma\mathbf U_3$)",
          R"($R^T\mathbf U_2$)",
          [](const auto& m) { return twice(back(m, m.U2)); },
          [](const auto& m, double k) {
            return m.row(m.U2 - m.sigma * m.U3 - (1 - m.gamma) * m.U2, m.gamma * m.U2 - k * m.sigma * m.U3);
          },
          {}},
         {"rt_u3",
          353,
          R"($R^T\mathbf U_3=\mathbf U_3+\sigma\mathbf U_2-(1-\gamma)\mathbf U_3=\sigma\mathbf U_2)"
          R"(+\gamma\mathbf U_3$)",
          R"($R^T\mathbf U_3$)",
          [](const auto& m) { return twice(back(m, m.U3)); },
          [](const auto& m, double k) {
            return m.row(m.U3 + m.sigma * m.U2 - (1 - m.gamma) * m.U3, k * m.sigma * m.U2 + m.gamma * m.U3);
          },
          {}},
         {"r_dot_u1", 357, R"($\dot R\mathbf U_1=(1-\gamma)\mathbf U_2-\sigma\mathbf U_3$)",
          R"($\dot R\mathbf U_1$)", [](const auto& m) { return m.R_dot * m.U1; },
          [](const auto& m, double k) { return (1 - m.gamma) * m.U2 - k * m.sigma * m.U3; }},
         {"composed_u1", 367,
          R"($\dot RR^T\mathbf U_1=\dot R\mathbf U_1=(1-\gamma)\mathbf U_2-\sigma\mathbf U_3$)",
          R"($\dot RR^T\mathbf U_1$)", [](const auto& m) { return twice(m.R_dot * back(m, m.U1)); },
          [](const auto& m, double k) {
            return m.row(m.R_dot * m.U1, (1 - m.gamma) * m.U2 - k * m.sigma * m.U3);
          }}});
  unit_lines(
      claims, moments,
      {{"r_dot_u2", 359,
        R"($\dot R\mathbf U_2=(1-\gamma)\mathbf U_1-\dot\theta\sigma\mathbf U_2)"
        R"(+\dot\theta\gamma\mathbf U_3$)",
        R"($\dot R\mathbf U_2$)", [](const auto& m) { return m.R_dot * m.U2; },
        [](const auto& m, double k) {
          return (1 - m.gamma) * m.U1 + m.theta_dot * (m.gamma * m.U3 - k * m.sigma * m.U2);
        }},
       {"r_dot_u3", 361,
        R"($\dot R\mathbf U_3=\sigma\mathbf U_1-\dot\theta\gamma\mathbf U_2-\dot\theta\sigma\mathbf U_3$)",
        R"($\dot R\mathbf U_3$)", [](const auto& m) { return m.R_dot * m.U3; },
        [](const auto& m, double k) {
          return m.sigma * m.U1 - m.theta_dot * (m.gamma * m.U2 + k * m.sigma * m.U3);
        }},
       {"composed_u2", 369,
        R"($\dot RR^T\mathbf U_2=\dot R(\gamma\mathbf U_2-\sigma\mathbf U_3)=-(1-\gamma)\mathbf U_1)"
        R"(+\dot\theta\mathbf U_3$)",
        R"($\dot RR^T\mathbf U_2$)", [](const auto& m) { return twice(m.R_dot * back(m, m.U2)); },
        [](const auto& m, double k) {
          return m.row(m.R_dot * (m.gamma * m.U2 - m.sigma * m.U3),
                       -(1 - m.gamma) * m.U1 + k * m.theta_dot * m.U3);
        }},
       {"composed_u3", 371,
        R"($\dot RR^T\mathbf U_3=\dot R(\sigma\mathbf U_2+\gamma\mathbf U_3)=\sigma\mathbf U_1)"
        R"(-\dot\theta\mathbf U_2$)",
        R"($\dot RR^T\mathbf U_3$)", [](const auto& m) { return twice(m.R_dot * back(m, m.U3)); },
        [](const auto& m, double k) {
          return m.row(m.R_dot * (m.sigma * m.U2 + m.gamma * m.U3), m.sigma * m.U1 - k * m.theta_dot * m.U2);
        }}});
}

/// The columns of R' R^T U by the text's formulas.
template <class T>
Matrix<T> columns_of_the_text(const MomentOf<T>& m, double k) {
  const T g = 1 - m.gamma, s = m.sigma, w = m.theta_dot;
  return Matrix<T>::columns(g * m.U2 - s * m.U3, -g * m.U1 + k * w * m.U3, s * m.U1 - w * m.U2);
}
/// Two vectors A and B.
constexpr auto first = [](const auto& m) { return m.w; };
constexpr auto second = [](const auto& m) { return m.R.column(0) + m.U2; };
constexpr auto product = [](const auto& m) { return cross(first(m), second(m)); };
constexpr auto difference = [](const auto& m) {
  return outer(second(m), first(m)) - outer(first(m), second(m));
};

void skew_matrices(Statements& claims, const Moments& moments) {
  unit_lines(
      claims, moments,
      {{"columns", 375,
        R"($\dot RR^TU=[(1-\gamma)\mathbf U_2-\sigma\mathbf U_3\ |\ {-(1-\gamma)}\mathbf U_1+\dot\theta\mathbf U_3\ |\ \sigma\mathbf U_1-\dot\theta\mathbf U_2]$)",
        R"($\dot RR^TU$)", [](const auto& m) { return m.W * m.U; },
        [](const auto& m, double k) { return columns_of_the_text(m, k); }},
       {"inverted", 379,
        R"($\dot RR^T=[(1-\gamma)\mathbf U_2-\sigma\mathbf U_3\ |\ {-(1-\gamma)}\mathbf U_1+\dot\theta\mathbf U_3\ |\ \sigma\mathbf U_1-\dot\theta\mathbf U_2]\,U^T$)",
        R"($\dot RR^T$)", [](const auto& m) { return m.W; },
        [](const auto& m, double k) { return columns_of_the_text(m, k) * transpose(m.U); }},
       {"outer_products", 389,
        R"($\dot RR^T=\dot\theta(\mathbf U_3\mathbf U_2^T-\mathbf U_2\mathbf U_3^T))"
        R"(+\sigma(\mathbf U_1\mathbf U_3^T-\mathbf U_3\mathbf U_1^T))"
        R"(+(1-\gamma)(\mathbf U_2\mathbf U_1^T-\mathbf U_1\mathbf U_2^T)$)",
        R"($\dot RR^T$)", [](const auto& m) { return m.W; },
        [](const auto& m, double k) {
          return m.theta_dot * (outer(m.U3, m.U2) - outer(m.U2, m.U3)) +
                 m.sigma * (outer(m.U1, m.U3) - outer(m.U3, m.U1)) +
                 k * (1 - m.gamma) * (outer(m.U2, m.U1) - outer(m.U1, m.U2));
        }},
       {"sum_of_cross_products", 465,
        R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf U_2\times\mathbf U_3))"
        R"(+\sigma\,\mathrm{Skew}(\mathbf U_3\times\mathbf U_1))"
        R"(+(1-\gamma)\,\mathrm{Skew}(\mathbf U_1\times\mathbf U_2)$)",
        R"($\mathrm{Skew}(\mathbf w)$)", [](const auto& m) { return m.W; },
        [](const auto& m, double k) {
          return m.theta_dot * skew(cross(m.U2, m.U3)) + k * m.sigma * skew(cross(m.U3, m.U1)) +
                 (1 - m.gamma) * skew(cross(m.U1, m.U2));
        }}});
  lines(claims, moments.moving,
        {{"skew_entries", 453,
          R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T$ has the entries of $\mathbf A\times\mathbf B$, )"
          R"(in the places of a skew matrix.)",
          R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T$)", difference,
          [](const auto& m, double k) {
            const auto [x, y, z] = product(m).e;
            return decltype(m.R){0.0, -z, k * y, z, 0.0, -x, -k * y, x, 0.0};
          },
          of_squares, "outer products"},
         {"skew_identity", 459,
          R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T=\mathrm{Skew}(\mathbf A\times\mathbf B)$)",
          R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T$)", [](const auto& m) { return skew(product(m)); },
          [](const auto& m, double k) { return k * difference(m); }, of_squares,
          R"($\mathrm{Skew}(\mathbf A\times\mathbf B)$)"},
         {"skew_is_one_to_one", 473,
          R"($\mathrm{Skew}(\mathbf A)=\mathrm{Skew}(\mathbf B)$ implies $\mathbf A=\mathbf B$: the squares )"
          R"(of the entries' differences add up to $2|\mathbf A-\mathbf B|^2$)",
          R"($2|\mathbf A-\mathbf B|^2$)",
          [](const auto& m) {
            auto squares = 0 * m.theta;
            for (const auto& entry : skew(first(m)) - skew(second(m))) squares += entry * entry;
            return squares;
          },
          [](const auto& m, double k) { return 2 * k * dot(first(m) - second(m), first(m) - second(m)); },
          of_squares, R"(squared entries of $\mathrm{Skew}(\mathbf A)-\mathrm{Skew}(\mathbf B)$)", 0.5}});
}

/// The text's w.
constexpr auto result = [](const auto& m, double k) {
  return m.theta_dot * m.U1 + m.sigma * m.U2 + k * (1 - m.gamma) * cross(m.U1, m.U2);
};

void angular_velocities(Statements& claims, const Moments& moments) {
  lines(claims, moments.all,
        {{"sum_of_frame", 467,
          R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf U_1))"
          R"(+\sigma\,\mathrm{Skew}(\mathbf U_2)+(1-\gamma)\,\mathrm{Skew}(\mathbf U_3)$)",
          R"($\mathrm{Skew}(\mathbf w)$)", [](const auto& m) { return m.W; },
          [](const auto& m, double k) {
            return m.theta_dot * skew(m.U1) + k * m.sigma * skew(m.U2) + (1 - m.gamma) * skew(m.U3);
          }},
         {"sum_of_axis", 469,
          R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf D))"
          R"(+\sin\theta\,\mathrm{Skew}(\dot{\mathbf D}))"
          R"(+(1-\cos\theta)\,\mathrm{Skew}(\mathbf D\times\dot{\mathbf D})$)",
          R"($\mathrm{Skew}(\mathbf w)$)", [](const auto& m) { return m.W; },
          [](const auto& m, double k) { return skew(result(m, k)); }},
         {"angular_velocity", 475,
          R"($\mathbf w=\dot\theta\mathbf D+\sin\theta\,\dot{\mathbf D})"
          R"(+(1-\cos\theta)\,\mathbf D\times\dot{\mathbf D}$ (whatever $|\dot{\mathbf D}|$ is))",
          R"($\mathbf w$)", [](const auto& m) { return m.w; }, result, &Moment::size}});
}

}  // namespace

namespace {

Statements stated(const Moments& moments) {
  Statements claims("2.5");
  for (auto* section : {rotation_and_derivative, matrices_by_images, frame, images_of_the_frame,
                        skew_matrices, angular_velocities})
    section(claims, moments);
  return claims;
}

/// Replaces the angle by its half, and products of the letters of an axis and its rate, as needed for
/// rewriting (Groebner bases, d2 > e2 > d1 > e1 > d0 > e0).
constexpr const char* turnings_in_coq = R"(
From Coq Require Import Nsatz.
Local Open Scope R_scope.

Lemma halves : forall x, let h := 5 / 10 * x in
  sin x = 2 * sin h * cos h /\ cos x = 1 - 2 * (sin h * sin h) /\ cos h * cos h = 1 - sin h * sin h.
Proof.
  intros x h. pose proof (sin_2a h) as s. pose proof (cos_2a h) as c. pose proof (sin2_cos2 h) as all.
  replace (2 * h) with x in * by (unfold h; field). unfold Rsqr in all. repeat split; lra.
Qed.

Section Turning.
Variables d0 d1 d2 e0 e1 e2 : R.
Hypothesis axis : d0 * d0 + d1 * d1 + d2 * d2 = 1.
Hypothesis across : d0 * e0 + d1 * e1 + d2 * e2 = 0.
Lemma axis_squared : d2 * d2 = 1 - d0 * d0 - d1 * d1.
Proof. lra. Qed.
Lemma axis_by_rate : d2 * e2 = - (d0 * e0 + d1 * e1).
Proof. lra. Qed.
Lemma axis_twice : d1 * d1 * e2 = e2 + d0 * d2 * e0 + d1 * d2 * e1 - d0 * d0 * e2.
Proof. nsatz. Qed.
End Turning.

(* as nsatz reads them *)
Ltac products :=
  repeat match goal with
         | |- context [?x ^ 2] => replace (x ^ 2) with (x * x) by ring
         | |- context [?x ^ 3] => replace (x ^ 3) with (x * x * x) by ring
         | |- context [?x ^ 4] => replace (x ^ 4) with (x * x * x * x) by ring
         end.
)";

/// H and H0 are the assumptions.
constexpr const char* by_halves = R"(
  destruct (halves theta) as (sine & cosine & circle); rewrite ?sine, ?cosine;
  pose proof (axis_squared _ _ _ H) as a; pose proof (axis_by_rate _ _ _ _ _ _ H0) as b;
  pose proof (axis_twice _ _ _ _ _ _ H H0) as c; field [circle a b c])";
constexpr const char* by_halves_and_rate = R"(
  destruct (halves theta) as (sine & cosine & circle); rewrite ?sine, ?cosine; clear sine cosine;
  pose proof (axis_squared _ _ _ H) as a; pose proof (axis_by_rate _ _ _ _ _ _ H0) as b;
  field_simplify_eq [circle a b]; try ring; clear a b circle;
  generalize (cos (5 / 10 * theta)) (sin (5 / 10 * theta)); intros; products; nsatz)";

/// Proofs with other letters than the table's: the derivative of S for any differentiable axis, the images
/// for any matrix, and the frame for any moving axis.
Provables by_hand(const MomentOf<Shortened>& any, const std::string& letters,
                  std::vector<Proposition> given) {
  const auto vector = [](const std::string& x, const std::string& y, const std::string& z) {
    return Vector<Shortened>{{Shortened::letter(x), Shortened::letter(y), Shortened::letter(z)}};
  };
  const auto rate = [](const Shortened& of, const Shortened& is) -> Proposition {
    return {"derivable_pt_lim (fun t => " + of.expression().coq() + ") t (" + is.expression().coq() + ")"};
  };
  const Vector<Shortened> moving = vector("(d0 t)", "(d1 t)", "(d2 t)"), its_rate = vector("e0", "e1", "e2");
  std::vector<Proposition> rates, rates_of_skew;
  for (std::size_t i = 0; i < 3; ++i) rates.push_back(rate(moving[i], its_rate[i]));
  for (std::size_t k = 0; k < 9; ++k) rates_of_skew.push_back(rate(skew(moving).e[k], skew(its_rate).e[k]));

  Matrix<Shortened> matrix;
  for (std::size_t k = 0; k < 9; ++k) matrix.e[k] = Shortened::letter("m" + std::to_string(k));
  const Vector<Shortened> a = vector("a0", "a1", "a2"), b = vector("b0", "b1", "b2"),
                          c = vector("c0", "c1", "c2");

  const auto gram = [](const Matrix<Shortened>& frame) {
    return detail::recorded_value(transpose(frame) * frame);
  };
  given.push_back(above(dot(any.U2, any.U2).expression(), 0));
  Vector<Dual<Shortened>> twice_as_fast;
  twice_as_fast[0] = {1.0, 0.0}, twice_as_fast[1] = {0.0, 2.0};
  const MomentOf<Shortened> example(twice_as_fast, {1.0, 1.0});
  const std::string root = any.lambda.expression().coq(), square = root.substr(root.find('('));
  return {
      {"2.5-derivative_of_s",
       "it holds entry by entry of any axis that has a rate",
       {{"printed", "(d0 d1 d2 : R -> R) (t e0 e1 e2 : R)", rates, rates_of_skew,
         "first [assumption | apply derivable_pt_lim_const | now apply (derivable_pt_lim_opp d0)\n"
         "  | now apply (derivable_pt_lim_opp d1) | now apply (derivable_pt_lim_opp d2)]"}}},
      {"2.5-determined_by_images",
       "it holds of any matrix and any three independent vectors",
       {{"printed",
         "(m0 m1 m2 m3 m4 m5 m6 m7 m8 a0 a1 a2 b0 b1 b2 c0 c1 c2 : R)",
         {not_zero(dot(a, cross(b, c)).expression())},
         equal(detail::recorded_value(from_images(matrix, a, b, c, 1)), detail::recorded_value(matrix)),
         "field; exact H"}}},
      {"2.5-orthonormal_frame",
       "as corrected it holds wherever the axis moves; as printed it is off where it moves at the speed 2",
       {{"corrected", letters, given, equal(gram(frame_of(any, true, true)), detail::recorded_value(any.I)),
         "pose proof (sqrt_lt_R0 _ H1) as far;\n  assert (long : " + root + " * " + root + " = " + square +
             ") by (apply sqrt_sqrt; lra);\n  set (r := " + root +
             ") in *; clearbody r;\n"
             "  assert (unit : / r * / r * " +
             square +
             " = 1) by (rewrite <- long; field; lra);\n"
             "  unfold Rdiv; set (q := / r) in *; clearbody q; clear far long H1; nsatz"},
        {"printed_differs",
         "",
         {},
         {apart(gram(frame_of(example, false, false)).at(4), 1.0, 2.9)},
         by_arithmetic}},
       2.9,
       turnings_in_coq}};
}

/// The axis and its rate are letters, perpendicular to each other.
Provables proved_of(const Statements& claims) {
  const auto lettered = [](const std::string& name) {
    return Vector<Shortened>{
        {Shortened::letter(name + "0"), Shortened::letter(name + "1"), Shortened::letter(name + "2")}};
  };
  const Vector<Shortened> D = lettered("d"), rate = lettered("e");
  Vector<Dual<Shortened>> axis;
  for (std::size_t i = 0; i < 3; ++i) axis[i] = {D[i], rate[i]};
  const MomentOf<Shortened> any(axis, {Shortened::letter("theta"), Shortened::letter("omega")});
  std::vector<Proposition> given{dot(D, D).expression() == 1, dot(D, rate).expression() == 0};
  Provables proved;
  const std::string letters = "(d0 d1 d2 e0 e1 e2 theta omega : R)";
  const auto prove = [&](const std::vector<Line>& lines, const std::string& says, const char* tactic) {
    for (const Line& line : lines) {
      if (line.slug == "determined_by_images") continue;  // by_hand() proves it for any vectors
      proved.push_back({"2.5-" + std::string(line.slug),
                        says,
                        {{"printed", letters, given,
                          equal(line.text.recorded(any, 1), line.truth.recorded(any, 1)), tactic}},
                        0,
                        turnings_in_coq});
    }
  };
  prove(claims.for_any, "it holds at any moment of any turning about a moving axis", by_halves);
  const Lemma singular{
      "corrected_determinant", letters, given, {determinant(any.W).expression() == 0}, by_halves};
  Provables more = by_hand(any, letters, given);
  given.push_back(dot(rate, rate).expression() == 1);
  prove(claims.for_unit_speed, "it holds at any moment at which the axis moves at the speed 1",
        by_halves_and_rate);
  Matrix<Shortened> matrix;
  for (std::size_t k = 0; k < 9; ++k) matrix.e[k] = Shortened::letter("m" + std::to_string(k));
  proved.push_back(
      {"2.5-applied_to_singular",
       "its determinant is zero, and it is its images', as any matrix is, where the axis moves "
       "at the speed 1",
       {singular,
        {"corrected_images", "(m0 m1 m2 m3 m4 m5 m6 m7 m8 d0 d1 d2 e0 e1 e2 theta : R)", given,
         equal(detail::recorded_value(matrix * any.U * transpose(any.U)), detail::recorded_value(matrix)),
         by_halves_and_rate}},
       0,
       turnings_in_coq});
  std::ranges::move(more, std::back_inserter(proved));
  return proved;
}

}  // namespace

std::vector<Claim> claims(double seed) { return stated(Moments(seed)).in_order(); }

Provables proofs() { return proved_of(stated(Moments(1))); }

std::vector<Root> roots() {
  const Vector<double> axis{1, 0, 0}, rate{0, 0.5, 0};
  const double volume = determinant(Matrix<double>::columns(axis, rate, cross(axis, rate)));
  return {
      {"length of the axis' rate",
       filled(
           R"(An axis that moves at half a radian per second has $|\dot{\mathbf D}|=@2$. The determinant of )"
           R"(the printed frame is @2, and a body that is drawn in it loses @2 % of its volume.)",
           {length(rate), volume, 100 * (1 - volume)})},
      {"a singular matrix",
       filled(
           R"(A program that inverts $\dot RR^T$ divides by its determinant, which is @1 at every moment.)",
           {determinant(skew(rate))})}};
}

}  // namespace oddity::rotating_axis

namespace oddity {

Provables proofs_2_5() { return rotating_axis::proofs(); }

}  // namespace oddity
