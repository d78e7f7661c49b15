// Exercise 7.7: the coefficients of p over a basis u, v, w, and over u x v, v x w, w x u, by triple products:
//   p = x u + y v + z w,             x = p.v x w / D, y = p.w x u / D, z = p.u x v / D,   D = u.v x w.
//   p = x u x v + y v x w + z w x u, x = w.p / D,     y = u.p / D,     z = v.p / D.
// The coefficients are known in advance: p is combined with whole numbers, and every line must return them
// exactly. Triple products are Cramer's rule; Higham, Accuracy and Stability, 2nd ed., 1.10.1.

#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/07_general_basis/general_basis.hpp"
#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/07_linear_algebra/shared/vectors.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex07_07 {

using namespace vectors;

constexpr Parameter parameters[] = {
    {"gap", 1e-3, "", "distance of $w$ from the plane of $u$ and $v$, about", 1e-13, 1},
    {"seed", 1, "", "seed of the random bases", 0, 1e9, whole_number},
};

// ---- the methods ------------------------------------------------------------------------------------------

struct Basis {
  Vector3<double> a, b, c, p;
};

/// A basis u, v, w, with w out of the plane of u and v by about the gap.
Basis nearly_dependent(double gap) {
  return {{0.83, -0.41, 0.57},
          {0.29, 0.91, -0.33},
          {0.6 * 0.83 + 0.3 * 0.29 + gap, 0.6 * -0.41 + 0.3 * 0.91 - gap, 0.6 * 0.57 + 0.3 * -0.33 + 2 * gap},
          {0.71, 0.37, 1.13}};
}

/// Coefficients over a, b, c.
template <class T>
Vector3<T> cramer(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c, const Vector3<T>& q) {
  const Vector3<T> bc = cross(b, c);
  const T d = dot(a, bc);
  return {dot(q, bc) / d, dot(q, cross(c, a)) / d, dot(q, cross(a, b)) / d};
}

/// Coefficients over a x b, b x c, c x a.
template <class T>
Vector3<T> dual_cramer(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c, const Vector3<T>& q) {
  const T d = triple(a, b, c);
  return {dot(c, q) / d, dot(a, q) / d, dot(b, q) / d};
}

Method triple_products(const Basis& s, const auto& formula) {
  const auto in = [=]<class T>(T) { return formula(cast<T>(s.a), cast<T>(s.b), cast<T>(s.c), cast<T>(s.p)); };
  const long work = operations_of([&] { return in(Counted<double>()); }).all_but_additions();
  return {"triple products", "Cramer", {"significant bits", {24, 53, 106}}, [=](double bits) {
            const auto by = [&](auto zero) { return Value(cast<double>(in(zero))); };
            return Answer{bits == 24 ? by(float{}) : bits == 53 ? by(0.0) : by(DoubleDouble()), work};
          }};
}

Eigen::Vector3d dense(const Vector3<double>& a) { return {a[0], a[1], a[2]}; }
Eigen::MatrixXd columns(const Vector3<double>& a, const Vector3<double>& b, const Vector3<double>& c) {
  Eigen::MatrixXd m(3, 3);
  m << dense(a), dense(b), dense(c);
  return m;
}

/// The residual of p, in the number type T.
template <class T>
Vector3<T> residual_in(const Basis& s, const Eigen::VectorXd& k) {
  const auto term = [](double factor, const Vector3<double>& a) { return T(factor) * cast<T>(a); };
  return cast<T>(s.p) - term(k[0], s.a) - term(k[1], s.b) - term(k[2], s.c);
}
/// The residual in twice the digits.
Vector3<double> residual(const Basis& s, const Eigen::VectorXd& k) {
  return cast<double>(residual_in<DoubleDouble>(s, k));
}

/// LU, with corrections from the residual in twice the digits.
Answer refined(const Basis& s, int corrections) {
  const Eigen::MatrixXd m = columns(s.a, s.b, s.c);
  auto solved = solve(Factorization::partial_pivot_lu, m, dense(s.p));
  const long work =
      operations_of([&] { return residual_in<Counted<double>>(s, solved.value); }).all_but_additions();
  for (int i = 0; i < corrections; ++i) {
    const auto correction = solve(Factorization::partial_pivot_lu, m, dense(residual(s, solved.value)));
    solved.value += correction.value;
    solved.evaluations += work + correction.evaluations;
  }
  return answer(solved);
}

/// The coefficients of s.p over the three vectors by every factorization.
void add_factorizations(Quantity& q, const Eigen::MatrixXd& m, const Vector3<double>& right, Outcome expected,
                        const std::string& why) {
  const auto add = [&](std::string algorithm, Factorization how) {
    q.add({"factorization", std::move(algorithm), no_resolution(),
           [=](double) { return answer(solve(how, m, dense(right))); }, expected, why});
  };
  add("LU, rows exchanged", Factorization::partial_pivot_lu);
  add("LU, rows and columns exchanged", Factorization::full_pivot_lu);
  add("QR", Factorization::householder_qr);
}

Known known_coefficients(const Basis& s, bool dual, const Reference& truth) {
  std::vector<double> inputs;
  for (const Vector3<double>& a : {s.a, s.b, s.c, s.p}) inputs.insert(inputs.end(), a.begin(), a.end());
  Known known = truth("07_07_coefficients", inputs);
  known.value = dual ? std::vector(known.value.begin() + 3, known.value.end())
                     : std::vector(known.value.begin(), known.value.begin() + 3);
  return known;
}

Quantity coefficients(std::string name, double gap, Outcome in_doubles, const Reference& truth) {
  const Basis s = nearly_dependent(gap);
  const Eigen::MatrixXd m = columns(s.a, s.b, s.c);
  const Known known = known_coefficients(s, false, truth);
  Quantity q =
      quantity(std::move(name), "", filled("coefficients over $u$, $v$, $w$; condition @2", {condition(m)}),
               known, {1e-9 * size_of(known.value), "nine digits of the largest coefficient"});
  q.add(triple_products(s, [](const auto&... a) { return cramer(a...); }));
  add_factorizations(q, m, s.p, in_doubles,
                     in_doubles == Outcome::ok ? ""
                                               : filled("the condition @2 takes @2 of the digits of a double",
                                                        {condition(m), std::log10(condition(m))}));
  q.add({"factorization", "LU, refined", {"corrections", {0, 1, 2, 3}}, [=](double n) {
           return refined(s, static_cast<int>(n));
         }});
  return q;
}

Quantity dual_coefficients(double gap, const Reference& truth) {
  const Basis s = nearly_dependent(gap);
  const Known known = known_coefficients(s, true, truth);
  Quantity q = quantity("dual_coefficients", "", R"(coefficients over $u\times v$, $v\times w$, $w\times u$)",
                        known, {1e-9 * size_of(known.value), "nine digits of the largest coefficient"});
  q.add(triple_products(s, [](const auto&... a) { return dual_cramer(a...); }));
  add_factorizations(q, columns(cross(s.a, s.b), cross(s.b, s.c), cross(s.c, s.a)), s.p, Outcome::ok, "");
  return q;
}

/// The residual of p for the coefficients: it can be small although they are wrong.
Quantity left_over(double gap, const Reference& truth) {
  const Basis s = nearly_dependent(gap);
  const Eigen::MatrixXd m = columns(s.a, s.b, s.c);
  const double size = size_of(known_coefficients(s, false, truth).value);
  Quantity q{"left_over",
             "",
             "$p-(xu+yv+zw)$, the basis nearly dependent",
             {"zero", {0.0, 0.0, 0.0}},
             0,
             rounding(size, 16),
             {},
             {}};
  const auto seen = [s](const Answer& a) {
    Answer b = a;
    b.value = residual(s, Eigen::Vector3d(a.value[0], a.value[1], a.value[2]));
    return b;
  };
  Quantity all = coefficients("", gap, Outcome::ok, truth);
  for (Method& method : all.methods) {
    method.run = [run = method.run, seen](double setting) { return seen(run(setting)); };
    q.add(std::move(method));
  }
  return q;
}

Findings study(const Parameters& chosen, const Reference& truth) {
  constexpr double tiny = 1e-10;
  Quantity nearly = coefficients("nearly_dependent", tiny, Outcome::inaccurate, truth);
  nearly.add(
      Breakdown{R"(With $w$ within $@1$ of the plane of $u$ and $v$ the volume $u\cdot v\times w$ loses )"
                "its digits by cancellation; twice the digits restore them.",
                "triple products, Cramer",
                53,
                Outcome::inaccurate,
                "triple products, Cramer",
                106,
                {tiny}});
  nearly.add(Breakdown{
      "A factorization loses the same digits, though its residual is as small as rounding allows (see "
      "`left_over`): a small residual proves nothing. Corrected by that residual, in twice the digits, it gets "
      "them back.",
      "factorization, LU, rows exchanged", 0, Outcome::inaccurate, "factorization, LU, refined", 3});
  return {claims(Random(chosen["seed"])),
          in_operations({coefficients("coefficients", chosen["gap"], Outcome::ok, truth),
                         dual_coefficients(chosen["gap"], truth), nearly, left_over(tiny, truth)})};
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
          study,
          proofs};
}

}  // namespace oddity
