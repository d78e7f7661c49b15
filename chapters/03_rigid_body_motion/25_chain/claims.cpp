// The claims of exercise 3.25. Positions are rotated rods. Velocities, forces and Lagrange's equations follow
// from the positions alone by nested dual numbers.

#include <Eigen/Core>
#include <concepts>
#include <numbers>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/integral_proofs.hpp"
#include "chapters/provable_claims.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"
#include "solvers/linear.hpp"
#include "solvers/quadrature.hpp"

namespace oddity::ex03_25 {

namespace {

/// The solution of n linear equations with these elements.
template <class Left, class Right>
std::vector<double> solved(std::size_t n, const Left& left, const Right& right) {
  const auto size = static_cast<Eigen::Index>(n);
  const auto at = [](Eigen::Index i) { return static_cast<std::size_t>(i); };
  const Eigen::MatrixXd M =
      Eigen::MatrixXd::NullaryExpr(size, size, [&](auto i, auto j) { return left(at(i), at(j)); });
  const Eigen::VectorXd f = Eigen::VectorXd::NullaryExpr(size, [&](auto i) { return right(at(i)); });
  const Eigen::VectorXd x = solve(Factorization::partial_pivot_lu, M, f).value;
  return {x.begin(), x.end()};
}

/// The letters of a random chain of n masses.
template <class T>
struct SampleOf {
  std::vector<T> m, r, theta, omega;
  T g, h;

  TypesetIn<T> typeset() const {
    TypesetIn<T> all{{"g", g}, {"h", h}};
    const auto places = at(theta), rates = velocities();
    for (std::size_t k = 0; k < m.size(); ++k)
      for (const auto& [letter, value] : {std::pair{"m_", m[k]},
                                          {"r_", r[k]},
                                          {R"(\theta_)", theta[k]},
                                          {R"(\dot\theta_)", omega[k]},
                                          {"x_", places[2 * k]},
                                          {"y_", places[2 * k + 1]},
                                          {R"(\dot x_)", rates[2 * k]},
                                          {R"(\dot y_)", rates[2 * k + 1]}})
        all.emplace_back(letter + std::to_string(k + 1), value);
    return all;
  }
  SampleOf<Shortened> recorded() const {
    const auto of = [](const std::vector<T>& x) { return std::vector<Shortened>(x.begin(), x.end()); };
    return {of(m), of(r), of(theta), of(omega), g, h};
  }
  std::string where() const {
    return R"($\theta$ = ()" + format_significant(theta[0], 4) + R"(, ...), $\omega$ = ()" +
           format_significant(omega[0], 4) + ", ...)";
  }

  /// The rod k, rotated by theta from the downward direction.
  std::array<T, 2> rod(std::size_t k) const {
    const T angle = theta[k] - pi_of<T>() / 2;
    return {r[k] * cos(angle), r[k] * sin(angle)};
  }
  /// (x_1, y_1, ...) in any number type.
  template <class X>
  std::vector<X> at(const std::vector<X>& q) const {
    using std::cos, std::sin;
    std::vector<X> all;
    X x(0.0), y(h);
    for (std::size_t k = 0; k < r.size(); ++k) {
      x += X(r[k]) * sin(q[k]);
      y -= X(r[k]) * cos(q[k]);
      all.push_back(x);
      all.push_back(y);
    }
    return all;
  }
  /// (x_1', y_1', ...) by dual numbers.
  template <class X>
  std::vector<X> velocities(const std::vector<X>& q, const std::vector<X>& v) const {
    std::vector<Dual<X>> moving;
    for (std::size_t k = 0; k < q.size(); ++k) moving.emplace_back(q[k], v[k]);
    std::vector<X> all;
    for (const auto& p : at(moving)) all.push_back(p.slope);
    return all;
  }
  std::vector<T> velocities() const { return velocities(theta, omega); }
  template <class X>
  X kinetic(const std::vector<X>& q, const std::vector<X>& v) const {
    X sum(0.0);
    const auto u = velocities(q, v);
    for (std::size_t i = 0; i < u.size(); ++i) sum += X(m[i / 2] / 2) * u[i] * u[i];
    return sum;
  }
  template <class X>
  X potential(const std::vector<X>& q) const {
    X V(0.0);
    const auto p = at(q);
    for (std::size_t k = 0; k < m.size(); ++k) V += X(m[k] * g) * p[2 * k + 1];
    return V;
  }
  /// The kinetic energy from the center of mass and the masses' relative speeds [Koenig].
  T kinetic_by_pairs() const {
    const auto v = velocities();
    T all = 0, px = 0, py = 0, pairs = 0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      all += m[i];
      px += m[i] * v[2 * i];
      py += m[i] * v[2 * i + 1];
      for (std::size_t j = 0; j < i; ++j)
        pairs += m[i] * m[j] * (pow(v[2 * i] - v[2 * j], 2) + pow(v[2 * i + 1] - v[2 * j + 1], 2));
    }
    return (px * px + py * py + pairs) / (2 * all);
  }
  /// d/dt dL/dtheta_i' - dL/dtheta_i, L = T - v_sign V, with theta'' = a, by nested dual numbers.
  T lagrange_left_side(std::size_t i, const std::vector<T>& a, double v_sign = 1) const {
    using Along = Dual<T>;
    using Outer = Dual<Along>;
    const auto value = [&](bool by_speed, bool moving) {
      std::vector<Outer> q, v;
      for (std::size_t k = 0; k < m.size(); ++k) {
        const T one(k == i ? 1.0 : 0.0), none(0.0);
        q.emplace_back(Along(theta[k], moving ? omega[k] : none), Along(by_speed ? none : one));
        v.emplace_back(Along(omega[k], moving ? a[k] : none), Along(by_speed ? one : none));
      }
      return (kinetic(q, v) - Outer(v_sign) * potential(q)).slope;
    };
    return value(true, true).slope - value(false, false).value;
  }
  /// theta'' by Lagrange's equations.
  std::vector<double> lagrange(double v_sign = 1) const {
    const std::size_t n = m.size();
    const auto left_side = [&](std::size_t i, std::size_t moving) {
      std::vector<double> a(n + 1, 0);
      a[moving] = 1;
      return lagrange_left_side(i, a, v_sign);
    };
    return solved(
        n, [&](std::size_t i, std::size_t j) { return left_side(i, j) - left_side(i, n); },
        [&](std::size_t i) { return -left_side(i, n); });
  }
  std::vector<T> newton() const {
    std::vector<T> alpha(m.size());
    chain::by_tensions(m, r, g, theta, omega, alpha);
    return alpha;
  }
  /// Work of gravity as all angles grow in proportion from zero.
  T work_of_gravity() const {
    const auto power = [&](const T& s) {
      std::vector<T> q = theta;
      for (T& x : q) x *= s;
      const auto v = velocities(q, theta);
      T sum = 0;
      for (std::size_t k = 0; k < m.size(); ++k) sum -= m[k] * g * v[2 * k + 1];
      return sum;
    };
    if constexpr (std::same_as<T, Shortened>)
      return recorded_integral(power, 0, 1);
    else
      return gauss_legendre(power, 0, 1, 32).value;
  }
};

using Sample = SampleOf<double>;
Sample random_chain(Random& random, int n = 3) {
  Sample s{{}, {}, {}, {}, random.between(1, 10), random.between(1, 5)};
  for (int k = 0; k < n; ++k) {
    s.m.push_back(random.between(0.3, 3));
    s.r.push_back(random.between(0.3, 2));
    s.theta.push_back(random.between(-3, 3));
    s.omega.push_back(random.between(-3, 3));
  }
  return s;
}
std::vector<Sample> random_chains(int count, double seed) {
  Random random(seed);
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) all.push_back(random_chain(random));
  return all;
}

using Table = ProvableClaims<SampleOf>;
using Of = ProvableFormula<SampleOf>;

/// Compares two routes to n accelerations. Solving loses digits according to the mass matrix's condition.
template <class Left, class Right>
Check accelerations(const std::string& left, const std::string& right, double seed, int least, int most,
                    const Left& by_left, const Right& by_right) {
  Random random(seed);
  WorstSample worst(R"($\ddot\theta$)", left, right);
  for (int i = 0; i < 60; ++i) {
    const int n = least + i % (most - least + 1);
    const Sample s = random_chain(random, n);
    const Value expected = by_right(s);
    const double size = std::max(size_of(expected), 10.0);
    worst.add(by_left(s), expected, {1e-10 * size, "a ten-thousandth of a millionth: condition below $10^5$"},
              size, "$n$ = " + std::to_string(n) + ", " + s.where());
  }
  return worst.check();
}

/// Accelerations by the pattern, with the tail mass of the later of two links, or of the earlier one.
std::vector<double> by_pattern(const Sample& s, bool later) {
  const auto mu = mass_from_here_on(s.m);
  const auto weight = [&](std::size_t i, std::size_t j) {
    return mu[later ? std::max(i, j) : std::min(i, j)] * s.r[i] * s.r[j];
  };
  return solved(
      mu.size(),
      [&](std::size_t i, std::size_t j) { return weight(i, j) * std::cos(s.theta[i] - s.theta[j]); },
      [&](std::size_t i) {
        double f = -mu[i] * s.g * s.r[i] * std::sin(s.theta[i]);
        for (std::size_t j = 0; j < mu.size(); ++j)
          f -= weight(i, j) * std::sin(s.theta[i] - s.theta[j]) * s.omega[j] * s.omega[j];
        return f;
      });
}

/// The number of coordinates that the rods' constraints leave free.
int free_coordinates(const Sample& s) {
  Eigen::MatrixXd constraints = Eigen::MatrixXd::Zero(3, 8);  // gradients of |p_k - p_(k-1)|^2
  for (int k = 0; k < 3; ++k) {
    const auto [x, y] = s.rod(static_cast<std::size_t>(k));
    constraints.row(k).segment<4>(2 * k) << -x, -y, x, y;
  }
  return 6 - rank(constraints.rightCols(6));  // the pivot is fixed
}

// ---- the text's formulas ----------------------------------------------------------------------------------

template <class T>
std::array<T, 2> three_rods(const SampleOf<T>& s) {
  const auto a = s.rod(0), b = s.rod(1), c = s.rod(2);
  return {a[0] + b[0] + c[0], a[1] + b[1] + c[1]};
}
/// Potential energy of the chain hanging straight down, relative to the level h.
template <class T>
T potential_at_rest(const SampleOf<T>& s) {
  T V = 0, depth = 0;
  for (std::size_t k = 0; k < s.m.size(); ++k) {
    depth += s.r[k];
    V -= s.m[k] * s.g * depth;
  }
  return V;
}

void formulas(Table& table, const std::vector<Sample>& samples) {
  const Of by_pairs{"Koenig: the center of mass, and the speeds of the masses relative to each other",
                    [](const auto& s) { return s.kinetic_by_pairs(); }};
  const auto claim = table.over(samples);
  claim("kinetic_sum", 2629, R"(The kinetic energy is $T=\sum\frac{m_k}2(\dot x_k^2+\dot y_k^2)$)", by_pairs,
        R"($\sum\frac{m_k}2(\dot x_k^2+\dot y_k^2)$)", "$T$");
  const std::string rods = "three turned rods, added as vectors", dual = "dual numbers in the time";
  claim.equation("x3", 2645, R"($x_3=r_1\sin\theta_1+r_2\sin\theta_2+r_3\sin\theta_3$)",
                 {rods, [](const auto& s) { return three_rods(s)[0]; }});
  claim.equation("y3", 2647, R"($y_3=h-r_1\cos\theta_1-r_2\cos\theta_2-r_3\cos\theta_3$)",
                 {rods, [](const auto& s) { return s.h + three_rods(s)[1]; }});
  claim.equation(
      "x3_rate", 2651,
      R"($\dot x_3=r_1\dot\theta_1\cos\theta_1+r_2\dot\theta_2\cos\theta_2+r_3\dot\theta_3\cos\theta_3$)",
      {dual, [](const auto& s) { return s.velocities()[4]; }});
  claim.equation(
      "y3_rate", 2653,
      R"($\dot y_3=r_1\dot\theta_1\sin\theta_1+r_2\dot\theta_2\sin\theta_2+r_3\dot\theta_3\sin\theta_3$)",
      {dual, [](const auto& s) { return s.velocities()[5]; }});
  const std::string substituted = R"(\sum_n\frac{m_n}2\left((\sum_{k\le n}r_k\dot\theta_k\cos\theta_k)^2)"
                                  R"(+(\sum_{k\le n}r_k\dot\theta_k\sin\theta_k)^2\right)$)";
  claim("kinetic_substituted", 2657, "With the derivatives put in, $T=" + substituted, by_pairs,
        "$" + substituted, "$T$");
  const auto brackets = [](const std::string& between) {
    const std::string two = R"(r_1^2\dot\theta_1^2+r_2^2\dot\theta_2^2)",
                      cosine_12 = R"(+2r_1r_2\dot\theta_1\dot\theta_2\cos(\theta_1-\theta_2))",
                      cosine_13 = R"(+2r_1r_3\dot\theta_1\dot\theta_3\cos(\theta_1-\theta_3))",
                      cosine_23 = R"(+2r_2r_3\dot\theta_2\dot\theta_3\cos(\theta_2-\theta_3))";
    return R"($\frac{m_1}2r_1^2\dot\theta_1^2+\frac{m_2}2\left()" + two + cosine_12 + R"(\right))" + between +
           R"(\frac{m_3}2\left()" + two + R"(+r_3^2\dot\theta_3^2)" + cosine_12 + cosine_13 + cosine_23 +
           R"(\right)$)";
  };
  claim(
      "kinetic_expanded", 2679, "Expanded, $T=" + brackets("+").substr(1),
      {.quantity = "$T$",
       .truth = by_pairs,
       .printed = brackets(""),
       .meant = brackets("+"),
       .kind = Fault::formula,
       .why = "The plus sign between the second and the third term is inside the second's parenthesis, after "
              "its last cosine, so that the two are multiplied. Every term of the sum is right."});
  claim("potential", 2713, "The potential energy is $V=-m_1g(h-y_1)-m_2g(h-y_2)-m_3g(h-y_3)$",
        {"that at rest less gravity's work on the way, by quadrature",
         [](const auto& s) { return potential_at_rest(s) - s.work_of_gravity(); }},
        "$-m_1g(h-y_1)-m_2g(h-y_2)-m_3g(h-y_3)$", "$V$, which is as printed at rest");
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("3.25");
  Table table(claims);
  formulas(table, random_chains(200, seed));
  claims.statement("three_free_variables", 2643, "Three of the six coordinates are free",
                   random_chains(100, seed),
                   {.printed = {"three, 6 less the rank of the rods' constraints",
                                [](const Sample& s) { return free_coordinates(s) == 3; }},
                    .near_misses = {{"four", [](const Sample& s) { return free_coordinates(s) == 4; }}}});
  claims.add("example_equations", 2643,
             "The construction of Example 3.15 gives equations to which a few are added",
             {.not_checkable = "the text does not repeat the example's equations"});
  const auto newton = [](const Sample& s) { return s.newton(); };
  const std::string by_lagrange = "Lagrange's equations by nested dual numbers",
                    by_newton = "Newton's law with the rods' tensions";
  const auto equation = [&](const std::string& potential, double v_sign) {
    const std::string text =
        R"($\frac{d}{dt}\frac{\partial L}{\partial\dot\theta_i}-\frac{\partial L}{\partial\theta_i}=0$ with $L=T)" +
        potential + "$";
    return Reading{text,
                   {accelerations(
                       by_lagrange + ": " + text, by_newton, seed, 3, 3,
                       [=](const Sample& s) { return s.lagrange(v_sign); }, newton)}};
  };
  claims.add(
      "equations", 2715,
      R"(The equations of motion are $\frac{d}{dt}\frac{\partial L}{\partial\dot\theta_i}-\frac{\partial )"
      R"(L}{\partial\theta_i}=0$ with $L=T-V$, one for each angle)",
      {.printed = equation("-V", 1), .near_misses = {equation("+V", -1)}});

  const auto pattern = [&](const std::string& mass, bool later) {
    const std::string text =
        R"($\sum_j\mu_{\)" + mass +
        R"((i,j)}r_ir_j(\cos(\theta_i-\theta_j)\,\ddot\theta_j+\sin(\theta_i-\theta_j)\,\dot\theta_j^2)=-\mu_igr_i\sin\theta_i$, )" +
        R"($\mu_k$ the mass from $k$ on)";
    const auto by = [=](const Sample& s) { return by_pattern(s, later); };
    return Reading{
        text,
        {accelerations(text, by_lagrange, seed, 1, 5, by, [](const Sample& s) { return s.lagrange(); }),
         accelerations(text, by_newton, seed, 20, 30, by, newton)}};
  };
  claims.add("pattern", 2753, "For $n$ masses there is a pattern that can be coded",
             {.printed = pattern("max", true), .near_misses = {pattern("min", false)}});
  return claims.in_order();
}

namespace {

constexpr const char* by_integral = R"(
  integrate (fun t => g * (m1 * (r1 * cos (a1 * t)) + m2 * (r1 * cos (a1 * t) + r2 * cos (a2 * t))
    + m3 * (r1 * cos (a1 * t) + r2 * cos (a2 * t) + r3 * cos (a3 * t))));
  rewrite ?Rmult_1_r, ?Rmult_0_r, ?cos_0; ring)";

std::vector<Shortened> three_letters(const std::string& name) {
  return {Shortened::letter(name + "1"), Shortened::letter(name + "2"), Shortened::letter(name + "3")};
}

SampleOf<Shortened> three_links() {
  return {three_letters("m"), three_letters("r"),     three_letters("a"),
          three_letters("w"), Shortened::letter("g"), Shortened::letter("h")};
}

}  // namespace

/// Newton's accelerations are the only ones that satisfy Lagrange's equations.
Provable proof_of_equations(const SampleOf<Shortened>& s) {
  const std::vector<Shortened> a = three_letters("b"), other = three_letters("c"), newton = s.newton();
  Lemma holds{.name = "newton",
              .letters = "(m1 m2 m3 r1 r2 r3 a1 a2 a3 w1 w2 w3 g h b1 b2 b3 : R)",
              .tactic = "by_tensions"};
  holds.given = positive({s.m[0], s.m[1], s.m[2], s.r[0], s.r[1], s.r[2]});
  Lemma alone = holds;
  alone.name = "unique";
  alone.letters = "(m1 m2 m3 r1 r2 r3 a1 a2 a3 w1 w2 w3 g h b1 b2 b3 c1 c2 c3 : R)";
  alone.tactic = "by_energy H H0 H1 H2 H3 H4 H5 H6 H7 H8 H9 H10 a1 a2 a3 b1 b2 b3 c1 c2 c3";
  Shortened apart = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Proposition solved = s.lagrange_left_side(i, a).expression() == 0;
    holds.given.push_back(a[i].expression() == newton[i].expression());
    holds.follows.push_back(solved);
    alone.given.push_back(solved);
    alone.given.push_back(s.lagrange_left_side(i, other).expression() == 0);
    apart = apart + pow(a[i] - other[i], 2);
  }
  alone.follows = {apart.expression() == 0};
  return {"3.25-equations",
          "for any three links in any motion they hold for the accelerations by Newton's law, and for no "
          "others",
          {holds, alone},
          0,
          coq_source({"tensions"})};
}

Provables proofs() {
  Claims claims("3.25");
  Table table(claims);
  formulas(table, {});
  ForAll<SampleOf> all{.any = three_links(),
                       .letters = "(m1 m2 m3 r1 r2 r3 a1 a2 a3 w1 w2 w3 g h : R)",
                       .tactic = "hanging a1 a2 a3",
                       .says = "it holds for any three links in any motion",
                       .example = {{1, 2, 3}, {1, 2, 1}, {0, 1, 2}, {1, -1, 2}, 1, 1}};
  all.given = positive({all.any.m[0], all.any.m[1], all.any.m[2]});
  Provables proved = table.proofs("3.25", all);
  for (Provable& p : proved) {
    const bool by_work = p.claim == "3.25-potential";
    p.preamble = coq_source({by_work ? "integrals" : "chain"});
    if (by_work) p.lemmas[0].tactic = by_integral;
  }
  proved.push_back(proof_of_equations(all.any));
  return proved;
}

}  // namespace oddity::ex03_25
