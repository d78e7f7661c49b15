// The claims of exercise 2.5. Every line of the proof is checked by the quaternion and dual numbers, at
// moments with |D'| = 1, which the proof assumes, and with any |D'|.
//   U1 = D, U2 = D', U3 = D x D', S = Skew(D), sigma = sin(theta), gamma = cos(theta), lambda = |D'|

#include "chapters/claims.hpp"
#include "chapters/provable_claims.hpp"

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/02_basic_concepts/shared/rotation_matrices.hpp"

namespace oddity::rotating_axis {

namespace {

using namespace space;

// ---- moments of motions -----------------------------------------------------------------------------------

/// Axis and angle as functions of time.
struct Turning {
  Vector3 p, q, r;  ///< D is along p + q sin(t) + r t^2
  double a, b, c;   ///< theta = a + b t + c cos(t)

  template <class T>
  Vector<T> axis(const T& t) const {
    const auto along = [&](std::size_t i) { return p[i] + q[i] * sin(t) + r[i] * t * t; };
    return unit(Vector<T>{along(0), along(1), along(2)});
  }
  template <class T>
  T angle(const T& t) const {
    return a + b * t + c * cos(t);
  }
};

/// A moment of such a motion: R from the quaternion, derivatives by dual numbers. M is any matrix.
template <class T>
struct MomentOf {
  Vector<Dual<T>> axis;
  Dual<T> angle;
  Matrix<T> M, U, S, S_dot, S2_dot, R, R_dot;
  T lambda;
  Vector<T> w;

  MomentOf() = default;
  MomentOf(const Vector<Dual<T>>& axis_, const Dual<T>& angle_, const Matrix<T>& M_)
      : axis(axis_), angle(angle_), M(M_) {
    const Quaternion<Dual<T>> q = quaternion(axis, angle);
    const Matrix<Dual<T>> skew_axis = skew(axis), turned = matrix(q);
    const Vector<T> U1 = value_of(axis), U2 = slope_of(axis);
    U = Matrix<T>::columns(U1, U2, cross(U1, U2)), lambda = length(U2), w = turning(q);
    S = value_of(skew_axis), S_dot = slope_of(skew_axis), S2_dot = slope_of(skew_axis * skew_axis);
    R = value_of(turned), R_dot = slope_of(turned);
  }
  Matrix<T> W() const { return R_dot * transpose(R); }
  /// Returns the moment with time running twice as fast.
  MomentOf twice_as_fast() const {
    auto faster = axis;
    for (auto& component : faster.e) component.slope = 2 * component.slope;
    return {faster, {angle.value, 2 * angle.slope}, M};
  }
  /// Empty: the sizes of terms are given instead.
  std::array<T*, 0> letters() { return {}; }
  double turn() const { return 1 + std::abs(angle.value); }
  /// Size of the terms in R' R^T, on unit vectors.
  double rates() const { return turn() * (1 + lambda + std::abs(angle.slope)); }
  /// Size of these terms on the vectors U.
  double size() const { return (1 + lambda * lambda) * rates(); }
  TypesetIn<T> typeset() const {
    return {{R"(\theta)", angle.value},
            {R"(\dot\theta)", angle.slope},
            {R"(\lambda)", lambda},
            {R"(\mathbf D)", U.column(0).e},
            {R"(\dot{\mathbf D})", U.column(1).e},
            {R"(\mathbf U_1)", U.column(0).e},
            {R"(\mathbf U_2)", U.column(1).e},
            {R"(\mathbf U_3)", U.column(2).e},
            {R"(\mathbf w)", w.e},
            {R"(\sigma)", sin(angle.value)},
            {R"(\gamma)", cos(angle.value)},
            {"I", identity<T>().e},
            {"S", S.e},
            {"S^2", (S * S).e},
            {R"(\dot S)", S_dot.e},
            {"R", R.e},
            {R"(\dot R)", R_dot.e},
            {"U", U.e},
            {"M", M.e},
            {"A", (M * U).e}};
  }
};
using Moment = MomentOf<double>;
using Table = ProvableClaims<MomentOf>;
using Of = ProvableFormula<MomentOf>;

/// Any matrix and three vectors.
template <class T>
struct AnyOf {
  Matrix<T> M;
  Vector<T> A, B, C;

  Letters<T> table() {
    return {{"M", M.e, {}, "m"},
            {R"(\mathbf A)", A.e, {}, "a"},
            {R"(\mathbf B)", B.e, {}, "b"},
            {R"(\mathbf C)", C.e, {}, "c"}};
  }
  T volume() const { return dot(A, cross(B, C)); }
  TypesetIn<T> typeset() const {
    const auto [x, y, z] = cross(A, B).e;
    return {{"x", x}, {"y", y}, {"z", z}};
  }
};

/// The rate of an axis, and that of S by differences, extrapolated.
struct Differenced {
  Vector3 rate;
  Solved<Value> S_slope;

  Differenced(const Turning& turning, double t, double speed)
      : rate(slope_of(turning.axis(Dual<double>(t, speed)))) {
    const double step = 0.25 / (1 + std::abs(speed));
    const auto difference = [&](double h) {
      const auto then = [&](double s) { return skew(turning.axis(t + speed * s)); };
      return Value(0.5 / h * (then(h) - then(-h)));
    };
    S_slope = limits::limit_at_zero(difference, step, 8);
    S_slope.error_estimate += 0x1p-48 * std::ldexp(1 / step, 8);
  }
  TypesetLetters typeset() const { return {{R"(\dot{\mathbf D})", rate}}; }
  Tolerance tolerance(double) const { return {S_slope.error_estimate, "the extrapolation's error estimate"}; }
};

/// Moments of random motions: with any |D'|; with time scaled so that |D'| = 1; and all, including those
/// about a fixed axis.
struct Moments {
  std::vector<Moment> any, unit_speed, all;
  std::vector<Differenced> differenced;
  std::vector<AnyOf<double>> vectors;

  Moments() = default;
  explicit Moments(double seed) {
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
      Turning motion{
          3.0 * Vector3{random.direction()}, {random.point(0.8)},  {random.point(0.8)}, random.between(-7, 7),
          random.magnitude(0.01, 10),        random.between(-1, 1)};
      const double t = random.between(-1, 1);
      if (i % 20 == 9) motion.a += 0.01 - motion.angle(t);
      const auto some = [&] { return Vector3{random.point(2)}; };
      const Matrix3 M = Matrix3::columns(some(), some(), some());
      vectors.push_back({M, some(), some(), some()});
      for (AnyOf<double>& one = vectors.back(); std::abs(one.volume()) < 1;)
        one = {M, some(), some(), some()};
      const auto at = [&](double rate) {
        const Dual<double> time(t, rate);
        return Moment(motion.axis(time), motion.angle(time), M);
      };
      const double rate = random.magnitude(0.1, 10), unit_rate = 1 / at(1).lambda;
      any.push_back(at(rate)), unit_speed.push_back(at(unit_rate));
      for (const double speed : {rate, unit_rate}) differenced.emplace_back(motion, t, speed);
      motion.q = motion.r = {0, 0, 0};
      if (i % 20 == 19) all.push_back(at(1));
    }
    for (const auto& some : {any, unit_speed}) all.insert(all.begin(), some.begin(), some.end());
  }
};

// ---- lines of the proof -----------------------------------------------------------------------------------

const std::string by = "quaternion and dual numbers";
using Size = std::function<double(const Moment&)>;
const Size turn = [](const Moment& m) { return m.turn(); };
const Size rates = [](const Moment& m) { return m.rates(); };

/// The value of a formula, in letters by the quaternion and dual numbers.
Of route(const std::string& formula, const Size& size, const std::string& text = by) {
  Of route("$" + formula + "$");
  static_cast<Formula<Moment>&>(route) = computed<Moment>(route);
  route.text = text, route.terms = size;
  return route;
}

/// The claims, and tables of those with proofs: for any axis, for |D'| = 1, and for any vectors.
struct Tables {
  const Moments& moments;
  Claims claims{"2.5"};
  Table any_axis{claims}, unit_speed{claims};
  ProvableClaims<AnyOf> any_vectors{claims};

  auto of_any() { return any_axis.over(moments.all); }
  auto of_unit() { return unit_speed.over(moments.unit_speed); }
  auto of_vectors() { return any_vectors.over(moments.vectors); }

  /// Claims the sides of $a=b$, or $a=b=c$, with terms of this size.
  void formula(std::string_view slug, int line, const std::string& text, const Size& size,
               const std::string& note = {}) {
    const auto [left, right] = sides(text);
    of_any()(slug, line, text + note, route(left, size), "$" + right + "$");
  }
  /// Claims an equation of any axis.
  void equation(std::string_view slug, int line, const std::string& text, const std::string& says = {}) {
    of_any()(slug, line, says.empty() ? text : says, of_equation(text));
  }
  /// Claims an equation that needs |D'| = 1.
  void where_unit(std::string_view slug, int line, const std::string& text, const std::string& says = {},
                  const std::vector<Of>& near_misses = {}) {
    auto claim = of_equation(text);
    claim.near_misses = near_misses;
    of_unit()(slug, line, (says.empty() ? text : says) + R"( (our condition: $|\dot{\mathbf D}|=1$))", claim);
  }

 private:
  /// The sides of $a=b=c$ as (a, a) and (b, c).
  static std::pair<std::string, std::string> sides(const std::string& text) {
    const auto all = formula::sides_of(text.substr(1, text.size() - 2)).sides;
    if (all.size() == 2) return {all[0], all[1]};
    return {"(" + all[0] + R"(,\ )" + all[0] + ")", "(" + all[1] + R"(,\ )" + all.at(2) + ")"};
  }
  static ProvableClaim<MomentOf> of_equation(const std::string& text) {
    const auto [left, right] = sides(text);
    return {.quantity = "the difference of the sides, by " + by,
            .truth = {"zero", [](const auto&) { return 0.0; }},
            .printed = "$" + left + "=" + right + "$"};
  }
};

void rotation_and_derivative(Tables& tables) {
  const auto claim = tables.of_any();
  claim("skew_of_w", 317, R"($\mathrm{Skew}(\mathbf w)=\dot RR^T$)",
        {.truth = route(R"(\mathrm{Skew}(\mathbf w))", rates,
                        R"($\mathrm{Skew}(\mathbf w)$, $\mathbf w=2\dot qq^*$ in dual numbers, )"
                        R"($q$ the quaternion of $R$)"),
         .printed = R"($\dot RR^T$)",
         .near_misses = {R"($R^T\dot R$)"}});
  tables.formula("rotation_matrix", 319, R"($R=I+\sigma S+(1-\gamma)S^2$)", turn);
  tables.formula("transpose", 319, R"($R^T=I-\sigma S+(1-\gamma)S^2$)", turn);
  tables.claims.over(tables.moments.differenced)(
      "derivative_of_s", 321, R"($\dot S=\mathrm{Skew}(\dot{\mathbf D})$)",
      {R"(differences of $\mathrm{Skew}(\mathbf D(t))$, extrapolated)",
       [](const auto& m) { return m.S_slope.value; }},
      {R"($\mathrm{Skew}(\dot{\mathbf D})$)"}, R"($\dot S$)");
  tables.formula(
      "derivative_of_r", 323,
      R"($\dot R=\sigma\dot S+\dot\theta\gamma S+(1-\gamma)(S\dot S+\dot SS)+\dot\theta\sigma S^2$)", rates);
  claim("no_power_rule", 325,
        R"($\frac{d}{dt}S^2$ is not generally $2S\dot S$ (our check: it is $S\dot S+\dot SS$).)",
        {.quantity = R"($\frac{d}{dt}S^2$)",
         .truth = {"dual numbers", [](const auto& m) { return m.S2_dot; }, rates},
         .printed = R"($S\dot S+\dot SS$)",
         .near_misses = {R"($2S\dot S$)"}});
}

void matrices_by_images(Tables& tables) {
  const auto& moments = tables.moments;
  tables.of_vectors()(
      "determined_by_images", 327,
      "An invertible matrix is determined by the images of three linearly independent vectors.",
      {"the matrix itself", [](const auto& any) { return any.M; }},
      R"($\frac{M\mathbf A(\mathbf B\times\mathbf C)^T+M\mathbf B(\mathbf C\times\mathbf A)^T)"
      R"(+M\mathbf C(\mathbf A\times\mathbf B)^T}{\mathbf A\cdot\mathbf B\times\mathbf C}$)",
      "$M$");
  const auto where_unit = tables.of_unit();
  where_unit("frame_is_a_rotation", 331,
             R"(Where $|\dot{\mathbf D}|=1$, $U$ is a rotation matrix: its inverse is its transpose.)",
             route(
                 "(I,1)", [](const Moment&) { return 4; }, "a rotation"),
             R"($(U^TU,\ \mathbf U_1\cdot\mathbf U_2\times\mathbf U_3)$)", R"($U^TU$, $\det U$)");
  where_unit("matrix_from_images", 333, R"($M=AU^T$ where $|\dot{\mathbf D}|=1$)",
             route("M", {}, "the matrix itself"), "$AU^T$", "$M$");
  const auto determinants = [&](const std::string& text, double unit) {
    WorstSample worst(text, "the determinant", "0");
    for (const Moment& m : moments.all)
      worst.add(determinant(m.W() + unit * identity()), 0, std::pow(m.rates(), 3), where_of(m));
    return worst.check();
  };
  const auto regular = [&](const std::string& text, double unit, double least) {
    return in_all<Moment>(text + " is regular", moments.all, [=](const Moment& m) {
      return std::abs(determinant(m.W() + unit * identity())) > least * std::pow(length(m.w), 3 * (1 - unit));
    });
  };
  const auto from_images = [&](const std::string& text) {
    Formula<Moment> images = computed(Formula<Moment>{"$(" + text + ")UU^T$"});
    images.text = "$AU^T$", images.terms = &Moment::size;
    return compare("$" + text + "$ from its images, $AU^T$", images,
                   computed(Formula<Moment>{"$" + text + "$"}), moments.unit_speed);
  };
  const Formula<Moment> invariants{
      R"($|\mathbf w|$ times the trace of $\dot RR^T$, and the sum of its principal minors)",
      [](const Moment& m) {
        const Matrix3 W = m.W(), square = W * W;
        const auto trace = [](const Matrix3& A) { return A(0, 0) + A(1, 1) + A(2, 2); };
        return values(length(m.w) * trace(W), (trace(W) * trace(W) - trace(square)) / 2);
      },
      [](const Moment& m) { return m.rates() * m.rates(); }};
  tables.claims.add(
      "applied_to_singular", 335,
      R"(What is said of an invertible matrix (line 327) is applied to $\dot RR^T$.)",
      {.printed = {R"($\dot RR^T$ is invertible)", {regular(R"($\dot RR^T$)", 0, 1e-9)}},
       .corrected = {R"($\dot RR^T$ is singular, and determined by its images all the same)",
                     {determinants(R"($\det\dot RR^T$)", 0),
                      compare(R"(with it, what makes the eigenvalues $0,\pm i|\mathbf w|$)", invariants,
                              {R"($(0,|\mathbf w|^2)$)",
                               [](const Moment& m) { return values(0, dot(m.w, m.w)); }},
                              moments.all),
                      from_images(R"(\dot RR^T)")}},
       .in_view = {R"(for an invertible matrix, such as $\dot RR^T+I$)",
                   {regular(R"($\dot RR^T+I$)", 1, 0.5), from_images(R"(\dot RR^T+I)")}},
       .near_misses = {{R"(so is $\dot RR^T+I$)", {determinants(R"($\det(\dot RR^T+I)$)", 1)}}},
       .why = R"(The rule is right for the matrices that it speaks of, and leaves out the one that it is )"
              R"(needed for. A skew $3\times3$ matrix $K$ has $\det K=\det K^T=-\det K$, which is 0. The )"
              R"(eigenvalues of $\dot RR^T$ are $0,\pm i|\mathbf w|$ at every moment. The conclusion is )"
              R"(right: $M=AU^T$ follows from $MU=A$ for every $M$; it is $U$ that has to be invertible.)",
       .root = "a singular matrix"});
}

const std::string printed_frame =
    R"($U=\begin{pmatrix}\mathbf D&\dot{\mathbf D}&\mathbf D\times\dot{\mathbf D}\end{pmatrix}$)";
const std::string corrected_frame =
    R"($U=\begin{pmatrix}\mathbf D&\dot{\mathbf D}/|\dot{\mathbf D}|&(\mathbf D\times\dot{\mathbf D})/|\dot{\mathbf D}|\end{pmatrix}$)";

/// The columns at right angles and of length one, by Gram and Schmidt.
Matrix3 orthonormal(const Matrix3& m) {
  const Vector3 a = unit(m.column(0)), b = unit(m.column(1) - dot(m.column(1), a) * a), c = m.column(2);
  return Matrix3::columns(a, b, unit(c - dot(c, a) * a - dot(c, b) * b));
}

void frame(Tables& tables) {
  tables.claims.over(tables.moments.any)(
      "orthonormal_frame", 337,
      R"($\mathbf U_1=\mathbf D$, $\mathbf U_2=\dot{\mathbf D}$ and $\mathbf U_3=\mathbf D\times\dot{\mathbf D}$ )"
      R"(are unit vectors at right angles.)",
      {.quantity = "$U$",
       .truth = {"its columns made orthonormal by Gram and Schmidt",
                 [](const Moment& m) { return orthonormal(m.U); }},
       .printed = {printed_frame},
       .corrected = {corrected_frame},
       .root = "length of the axis' rate",
       .why = R"($\dot{\mathbf D}$ is perpendicular to $\mathbf D$, but its length $\lambda=|\dot{\mathbf )"
              R"(D}|$ is $1$ only when the axis moves so. It is $0$ when the axis is fixed, and then there )"
              R"(is no such frame at all. With the printed vectors $\mathbf U_2\times\mathbf U_3$ and $\dot )"
              R"(S\mathbf U_3$ are $\lambda^2\mathbf U_1$, and the lines that use them fail for )"
              R"($\lambda\ne1$. With $\mathbf U_2=\dot{\mathbf D}/\lambda$ every $\sigma$ and every )"
              R"($1-\gamma$ of the last steps gets a factor $\lambda$, which $\lambda\mathbf )"
              R"(U_2=\dot{\mathbf D}$ takes up again: the result holds for every $\lambda$, zero too.)"});
  const std::string products =
      R"($(\mathbf U_1,\mathbf U_2,\mathbf U_3)=(\mathbf U_2\times\mathbf U_3,\mathbf U_3\times\mathbf U_1,\mathbf U_1\times\mathbf U_2)$)";
  tables.where_unit(
      "cross_products", 341, products,
      R"($\mathbf U_1=\mathbf U_2\times\mathbf U_3$, $\mathbf U_2=\mathbf U_3\times\mathbf U_1$, )"
      R"($\mathbf U_3=\mathbf U_1\times\mathbf U_2$)",
      {{R"(where $|\dot{\mathbf D}|=2$)",
        [is = TypesetFormula(products)](const Moment& m) { return is(m.twice_as_fast().typeset()); }}});
  tables.where_unit(
      "images_under_s_dot", 345,
      R"($(\dot S\mathbf U_1,\dot S\mathbf U_2,\dot S\mathbf U_3)=(-\mathbf U_3,(0,0,0),\mathbf U_1)$)",
      R"($\dot S\mathbf U_1=-\mathbf U_3$, $\dot S\mathbf U_2=0$, $\dot S\mathbf U_3=\mathbf U_1$)");
  tables.equation("images_under_s", 343,
                  R"($(S\mathbf U_1,S\mathbf U_2,S\mathbf U_3)=((0,0,0),\mathbf U_3,-\mathbf U_2)$)",
                  R"($S\mathbf U_1=0$, $S\mathbf U_2=\mathbf U_3$, $S\mathbf U_3=-\mathbf U_2$)");
}

void images_of_the_frame(Tables& tables) {
  const Size of_frame = &Moment::size;
  tables.of_any()("rt_u1", 349,
                  R"($R^T\mathbf U_1=\mathbf U_1-\sigma S\mathbf U_1+(1-\gamma)S^2\mathbf U_1=\mathbf U_1$)",
                  route(R"((R^T\mathbf U_1,R^T\mathbf U_1))", of_frame),
                  R"($(\mathbf U_1-\sigma S\mathbf U_1+(1-\gamma)S(S\mathbf U_1),\ \mathbf U_1)$)",
                  R"($R^T\mathbf U_1$)", R"($S\mathbf U_1=0$)");
  tables.formula(
      "rt_u2", 351,
      R"($R^T\mathbf U_2=\mathbf U_2-\sigma\mathbf U_3-(1-\gamma)\mathbf U_2=\gamma\mathbf U_2-\sigma\mathbf U_3$)",
      {});
  tables.formula(
      "rt_u3", 353,
      R"($R^T\mathbf U_3=\mathbf U_3+\sigma\mathbf U_2-(1-\gamma)\mathbf U_3=\sigma\mathbf U_2+\gamma\mathbf U_3$)",
      {});
  tables.equation("r_dot_u1", 357, R"($\dot R\mathbf U_1=(1-\gamma)\mathbf U_2-\sigma\mathbf U_3$)");
  tables.where_unit(
      "r_dot_u2", 359,
      R"($\dot R\mathbf U_2=(1-\gamma)\mathbf U_1-\dot\theta\sigma\mathbf U_2+\dot\theta\gamma\mathbf U_3$)");
  tables.where_unit(
      "r_dot_u3", 361,
      R"($\dot R\mathbf U_3=\sigma\mathbf U_1-\dot\theta\gamma\mathbf U_2-\dot\theta\sigma\mathbf U_3$)");
  tables.formula("composed_u1", 367,
                 R"($\dot RR^T\mathbf U_1=\dot R\mathbf U_1=(1-\gamma)\mathbf U_2-\sigma\mathbf U_3$)",
                 of_frame);
  tables.where_unit("composed_u2", 369,
                    R"($\dot RR^T\mathbf U_2=\dot R(\gamma\mathbf U_2-\sigma\mathbf U_3)=)"
                    R"(-(1-\gamma)\mathbf U_1+\dot\theta\mathbf U_3$)");
  tables.where_unit("composed_u3", 371,
                    R"($\dot RR^T\mathbf U_3=\dot R(\sigma\mathbf U_2+\gamma\mathbf U_3)=)"
                    R"(\sigma\mathbf U_1-\dot\theta\mathbf U_2$)");
}

void skew_matrices(Tables& tables) {
  const std::string columns =
      R"(\begin{pmatrix}(1-\gamma)\mathbf U_2-\sigma\mathbf U_3&-(1-\gamma)\mathbf U_1+\dot\theta\mathbf U_3&\sigma\mathbf U_1-\dot\theta\mathbf U_2\end{pmatrix})";
  tables.where_unit("columns", 375, R"($\dot RR^TU=)" + columns + "$");
  tables.where_unit("inverted", 379, R"($\dot RR^T=)" + columns + R"(\,U^T$)");
  tables.where_unit("outer_products", 389,
                    R"($\dot RR^T=\dot\theta(\mathbf U_3\mathbf U_2^T-\mathbf U_2\mathbf U_3^T))"
                    R"(+\sigma(\mathbf U_1\mathbf U_3^T-\mathbf U_3\mathbf U_1^T))"
                    R"(+(1-\gamma)(\mathbf U_2\mathbf U_1^T-\mathbf U_1\mathbf U_2^T)$)");
  tables.where_unit("sum_of_cross_products", 465,
                    R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf U_2\times\mathbf U_3))"
                    R"(+\sigma\,\mathrm{Skew}(\mathbf U_3\times\mathbf U_1))"
                    R"(+(1-\gamma)\,\mathrm{Skew}(\mathbf U_1\times\mathbf U_2)$)");
  const std::string outer_products = R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T$)";
  const auto of_vectors = tables.of_vectors();
  of_vectors(
      "skew_entries", 453,
      outer_products + R"( has the entries of $\mathbf A\times\mathbf B$, in the places of a skew matrix.)",
      {"outer products", [](const auto& any) { return outer(any.B, any.A) - outer(any.A, any.B); }},
      R"($\begin{pmatrix}0&-z&y\\z&0&-x\\-y&x&0\end{pmatrix}$)",
      outer_products + R"(; $(x,y,z)=\mathbf A\times\mathbf B$)");
  of_vectors("skew_identity", 459,
             R"($\mathbf B\mathbf A^T-\mathbf A\mathbf B^T=\mathrm{Skew}(\mathbf A\times\mathbf B)$)",
             {R"($\mathrm{Skew}(\mathbf A\times\mathbf B)$)",
              [](const auto& any) { return skew(cross(any.A, any.B)); }},
             outer_products, outer_products);
  of_vectors(
      "skew_is_one_to_one", 473,
      R"($\mathrm{Skew}(\mathbf A)=\mathrm{Skew}(\mathbf B)$ implies $\mathbf A=\mathbf B$: the squares )"
      R"(of the entries' differences add up to $2|\mathbf A-\mathbf B|^2$)",
      {R"(squared entries of $\mathrm{Skew}(\mathbf A)-\mathrm{Skew}(\mathbf B)$)",
       [](const auto& any) {
         auto squares = 0.0 * any.A[0];
         for (const auto& entry : skew(any.A) - skew(any.B)) squares += entry * entry;
         return squares;
       }},
      R"($2(\mathbf A-\mathbf B)\cdot(\mathbf A-\mathbf B)$)", R"($2|\mathbf A-\mathbf B|^2$)");
}

void angular_velocities(Tables& tables) {
  tables.equation("sum_of_frame", 467,
                  R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf U_1))"
                  R"(+\sigma\,\mathrm{Skew}(\mathbf U_2)+(1-\gamma)\,\mathrm{Skew}(\mathbf U_3)$)");
  tables.equation("sum_of_axis", 469,
                  R"($\mathrm{Skew}(\mathbf w)=\dot\theta\,\mathrm{Skew}(\mathbf D))"
                  R"(+\sin\theta\,\mathrm{Skew}(\dot{\mathbf D}))"
                  R"(+(1-\cos\theta)\,\mathrm{Skew}(\mathbf D\times\dot{\mathbf D})$)");
  tables.formula("angular_velocity", 475,
                 R"($\mathbf w=\dot\theta\mathbf D+\sin\theta\,\dot{\mathbf D})"
                 R"(+(1-\cos\theta)\,\mathbf D\times\dot{\mathbf D}$)",
                 rates, R"( (whatever $|\dot{\mathbf D}|$ is))");
}

void state(Tables& tables) {
  for (auto* section : {rotation_and_derivative, matrices_by_images, frame, images_of_the_frame,
                        skew_matrices, angular_velocities})
    section(tables);
}

std::vector<Shortened> letters(const std::vector<std::string>& names) {
  std::vector<Shortened> all;
  for (const std::string& name : names) all.push_back(Shortened::letter(name));
  return all;
}

/// The axis and its rate are letters, perpendicular to each other.
MomentOf<Shortened> any_moment(const std::vector<std::string>& names) {
  const auto x = letters(names);
  Matrix<Shortened> M;
  std::ranges::copy(x.begin() + 8, x.end(), M.e.begin());
  return {{{{{x[0], x[3]}, {x[1], x[4]}, {x[2], x[5]}}}}, {x[6], x[7]}, M};
}

/// The derivative of S for any differentiable axis.
Provable derivative_of_s() {
  const auto x = letters({"(d0 t)", "(d1 t)", "(d2 t)", "e0", "e1", "e2"});
  const auto rate = [](const Shortened& of, const Shortened& is) -> Proposition {
    return {"derivable_pt_lim (fun t => " + of.expression().coq() + ") t (" + is.expression().coq() + ")"};
  };
  const auto S = skew(Vector<Shortened>{x[0], x[1], x[2]}),
             S_rate = skew(Vector<Shortened>{x[3], x[4], x[5]});
  std::vector<Proposition> given, follows;
  for (std::size_t i = 0; i < 3; ++i) given.push_back(rate(x[i], x[3 + i]));
  for (std::size_t k = 0; k < 9; ++k) follows.push_back(rate(S.e[k], S_rate.e[k]));
  return {"2.5-derivative_of_s",
          "it holds entry by entry of any axis that has a rate",
          {{"printed", "(d0 d1 d2 : R -> R) (t e0 e1 e2 : R)", given, follows,
            "first [assumption | apply derivable_pt_lim_const | now apply (derivable_pt_lim_opp d0)\n"
            "  | now apply (derivable_pt_lim_opp d1) | now apply (derivable_pt_lim_opp d2)]"}}};
}

/// The frame for any moving axis.
Provable orthonormal_frame(const MomentOf<Shortened>& any, ForAll<MomentOf> all) {
  const auto gram = [](const std::string& frame, const MomentOf<Shortened>& moment) {
    Matrix<Shortened> U;
    std::ranges::copy(recorded_text(frame, moment.typeset()), U.e.begin());
    return detail::recorded_value(transpose(U) * U);
  };
  const Vector<Shortened> rate = slope_of(any.axis);
  all.given.push_back(above(dot(rate, rate).expression(), 0));
  const MomentOf<Shortened> example({{{{1.0, 0.0}, {0.0, 2.0}, {}}}}, {1.0, 1.0}, {});
  return {"2.5-orthonormal_frame",
          "as corrected it holds wherever the axis moves; as printed it is off where it moves at the speed 2",
          {{"corrected", all.letters, all.given,
            equal(gram(corrected_frame, any), detail::recorded_value(identity<Shortened>())), "by_length H1"},
           {"printed_differs", "", {}, {apart(gram(printed_frame, example).at(4), 1.0, 2.9)}, by_arithmetic}},
          2.9};
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const Moments moments(seed);
  Tables tables{moments};
  state(tables);
  return tables.claims.in_order();
}

Provables proofs() {
  const Moments none;
  Tables tables{none};
  state(tables);
  const std::vector<std::string> names{"d0", "d1", "d2", "e0", "e1", "e2", "theta", "omega", "m0",
                                       "m1", "m2", "m3", "m4", "m5", "m6", "m7",    "m8"};
  const MomentOf<Shortened> any = any_moment(names);
  const Vector<Shortened> axis = value_of(any.axis), rate = slope_of(any.axis);
  ForAll<MomentOf> all{.any = any,
                       .letters = quantified(names),
                       .given = {dot(axis, axis).expression() == 1, dot(axis, rate).expression() == 0},
                       .tactic = "by_halves theta H H0",
                       .says = "it holds at any moment of any turning about a moving axis"};
  Provables proved = tables.any_axis.proofs("2.5", all);
  proved.push_back(orthonormal_frame(any, all));
  Lemma singular{
      "corrected_determinant", all.letters, all.given, {determinant(any.W()).expression() == 0}, all.tactic};
  all.given.push_back(dot(rate, rate).expression() == 1);
  all.tactic = "by_halves_and_rate theta H H0";
  all.says = "it holds at any moment at which the axis moves at the speed 1";
  append(proved, tables.unit_speed.proofs("2.5", all));
  proved.push_back(
      {"2.5-applied_to_singular",
       "its determinant is zero, and it is its images', as any matrix is, where the axis moves at the speed 1",
       {singular,
        {"corrected_images", all.letters, all.given,
         equal(recorded_text("$AU^T$", any.typeset()), detail::recorded_value(any.M)), all.tactic}}});
  for (Provable& p : proved) p.preamble = coq_source({"turnings"});

  const auto vectors = for_all<AnyOf>("field", "it holds of any matrix and any vectors");
  append(proved, tables.any_vectors.proofs("2.5", vectors));
  Provable& images = proof_of(proved, "2.5-determined_by_images");
  images.says = "it holds of any matrix and any three independent vectors";
  images.lemmas[0].given = {not_zero(vectors.any.volume().expression())};
  images.lemmas[0].tactic = "field; exact H";
  proved.push_back(derivative_of_s());
  return proved;
}

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
