// Exercise 3.19: a rope from a spring (c1, L1) over a fixed pulley (I1, R1) carries a second pulley (m2, I2,
// R2); a rope from another spring (c2, L2) over that one carries a mass m3. Depths below the ceiling: y2, y3.
//   S1 = y2 + K1, S2 = y3 - 2 y2 + K2                          (the ropes' lengths)
//   (m2 + I1/R1^2 + I2/R2^2) y2'' - I2/R2^2 y3'' = m2 g - c1 (S1 - L1) + 2 c2 (S2 - L2)
//   (m3 + I2/R2^2) y3'' - I2/R2^2 y2'' = m3 g - c2 (S2 - L2)
// What the text derives is compared with Lagrange's equations from the two energies, by dual numbers, and
// with Newton's laws for each body and the tensions of the ropes' four ends.

#include "chapters/03_rigid_body_motion/19_two_pulleys/two_pulleys.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex03_19 {

using namespace two_pulleys;

constexpr Parameter parameters[] = {
    {"m2", 1, "kg", "mass of the small pulley", 1e-2, 1e2},
    {"m3", 2, "kg", "mass at the end", 1e-2, 1e2},
    {"I1", 0.5, "kg m^2", "moment of inertia of the large pulley", 1e-3, 1e2},
    {"I2", 0.25, "kg m^2", "moment of inertia of the small pulley", 1e-3, 1e2},
    {"R1", 0.5, "m", "radius of the large pulley", 0.05, 10},
    {"R2", 0.5, "m", "radius of the small pulley", 0.05, 10},
    {"c1", 40, "N/m", "constant of the first spring", 0.1, 1e4},
    {"c2", 30, "N/m", "constant of the second spring", 0.1, 1e4},
    {"L1", 1, "m", "length at rest of the first spring", 0, 1e2},
    {"L2", 1, "m", "length at rest of the second spring", 0, 1e2},
    {"K1", 1, "m", "S1 - y2", -1e2, 1e2},
    {"K2", 1.5, "m", "S2 - y3 + 2 y2", -1e2, 1e2},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e3},
    {"y2", 1, "m", "depth of the small pulley at the start", -1e2, 1e2},
    {"y3", 2.5, "m", "depth of the mass at the start", -1e2, 1e2},
    {"v2", 0.25, "m/s", "y2' at the start", -1e2, 1e2},
    {"v3", -0.5, "m/s", "y3' at the start", -1e2, 1e2},
    {"seed", 319, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- samples ----------------------------------------------------------------------------------------------

/// Any two pulleys in any motion, hung between a ceiling and a floor at depth `floor`; y1 is the large one's.
struct Sample {
  Given<double> p;
  Pair q, v, a;
  double floor, y1, delta;

  explicit Sample(Random& random) {
    const auto size = [&] { return random.between(0.3, 3); };
    const auto any = [&] { return random.magnitude(0.1, 2); };
    p = {size(), size(), size(), size(), size(), size(), size(), size(), size(),
         size(), any(),  any(),  size(), any(),  any(),  any(),  any()};
    q = {p.y2, p.y3};
    v = {p.v2, p.v3};
    a = {any(), any()};
    floor = random.between(4, 8);
    y1 = random.between(0.1, 1);
    delta = any();
  }
  /// The terms of lengths, energies and forces, added up, the accelerations being the forces over a mass.
  double size() const {
    const double mass = p.m2 + p.m3 + p.turn1() + 2 * p.turn2(), speed = std::abs(v[0]) + std::abs(v[1]);
    const double pulls = (p.m2 + p.m3) * p.g + p.c1 * (std::abs(p.K1) + p.L1 + std::abs(q[0])) +
                         2 * p.c2 * (std::abs(p.K2) + p.L2 + std::abs(q[1]) + 2 * std::abs(q[0]));
    return floor + mass * (speed * speed + std::abs(a[0]) + std::abs(a[1])) +
           pulls * (1 + mass / std::min(p.m2, p.m3));
  }
  std::string where() const {
    return "m2 = " + rounded(p.m2, 4) + ", m3 = " + rounded(p.m3, 4) + ", c1 = " + rounded(p.c1, 4) +
           ", c2 = " + rounded(p.c2, 4) + ", y2 = " + rounded(q[0], 4) + ", y3 = " + rounded(q[1], 4);
  }

  /// The springs between floor and rope, from the ropes' lengths alone.
  template <class T>
  Two<T> springs(const Two<T>& y) const {
    const double rope1 = floor - 2 * y1 - p.K1, rope2 = floor - p.K2;
    return {(floor - y1) - (rope1 - (y[0] - y1)), (floor - y[0]) - (rope2 - (y[1] - y[0]))};
  }
  /// The ropes' lengths less what stays of them over the pulleys, their springs given by y - K.
  Pair ropes_after(double down2, double down3) const {
    const auto lengths = [&](double d2, double d3) {
      const double S1 = q[0] + d2 + p.K1, S2 = q[1] + d3 - 2 * (q[0] + d2) + p.K2;
      return Pair{(floor - y1 - S1) + (q[0] + d2 - y1), (floor - S2 - q[0] - d2) + (q[1] + d3 - q[0] - d2)};
    };
    const Pair before = lengths(0, 0), after = lengths(down2, down3);
    return {after[0] - before[0], after[1] - before[1]};
  }
  Pair springs_after(double down2, double down3) const {
    const Pair before = springs(q), after = springs(Pair{q[0] + down2, q[1] + down3});
    return {after[0] - before[0], after[1] - before[1]};
  }
  /// Rope that runs over each pulley's rim toward the far side, seen on the spring's side.
  Pair rim_speeds() const {
    const auto s = springs(moving(q, v));
    return {s[0].slope, s[1].slope + v[0]};
  }
  /// The same with a first spring whose length at rest is less than its length, or more.
  Sample stretched(double by = 1) const {
    Sample other = *this;
    other.p.L1 = springs(q)[0] - by * std::abs(delta);
    return other;
  }
  /// T from the ropes' lengths alone: the pulleys turn as the rope on the springs' side runs.
  auto kinetic() const {
    return [*this](const auto& y, const auto& dy) {
      using T = std::decay_t<decltype(y[0])>;
      const auto s = springs(Two<Dual<T>>{Dual<T>(y[0], dy[0]), Dual<T>(y[1], dy[1])});
      const T w1 = s[0].slope / p.R1, w2 = (s[1].slope + dy[0]) / p.R2;
      return 0.5 * (p.m2 * dy[0] * dy[0] + p.m3 * dy[1] * dy[1] + p.I1 * w1 * w1 + p.I2 * w2 * w2);
    };
  }
  Pair forces() const {  ///< generalized, from the potential energy
    const Pair dV = df_dq(PotentialEnergy{p}, q, v);
    return {-dV[0], -dV[1]};
  }
  Pair by_lagrange() const { return lagrange_accelerations(Lagrangian{p}, q, v); }
  Pair by_tensions() const {
    FourCoordinates<double>::State rate;
    FourCoordinates<double>{p}({q[0], q[1], q[0] / p.R1, (q[1] - q[0]) / p.R2, v[0], v[1], 0, 0}, rate, 0.0);
    return {rate[4], rate[5]};
  }
  double pull1() const { return p.c1 * (p.K1 - p.L1 + q[0]); }
  double pull2() const { return p.c2 * (p.K2 - p.L2 + q[1] - 2 * q[0]); }
};

using S = const Sample&;
using V = Version<Sample>;

// ---- the claims -------------------------------------------------------------------------------------------

std::vector<Claim> kinematics(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const V& printed, const V& truth,
                        const std::vector<V>& near) {
    all.push_back(formula_claim(std::string("3.19-") + id, line, what, seed, printed, truth, near));
  };
  const V rims{"rope over the rims, from the ropes' lengths on the springs' side", &Sample::rim_speeds};
  says("rolling", 2437, "R1 theta1' = y2' - y1' = y2' and R2 theta2' = y3' - y2'",
       {"(y2', y3' - y2')", [](S s) { return values(s.v[0], s.v[1] - s.v[0]); }}, rims,
       {{"(y2', y3' - 2 y2')", [](S s) { return values(s.v[0], s.v[1] - 2 * s.v[0]); }},
        {"(y2', y3')", [](S s) { return values(s.v[0], s.v[1]); }}});
  says("length_1", 2521, "S1 - y2 is constant: the spring grows by what the small pulley goes down",
       {"S1 changes by Delta when y2 does", [](S s) { return values(s.delta); }},
       {"the first rope's length", [](S s) { return values(s.springs_after(s.delta, 0)[0]); }},
       {{"S1 + y2 constant", [](S s) { return values(-s.delta); }}});
  says("length_2", 2529, "S2 - y3 + 2 y2 is constant",
       {"S2 changes by the change of y3 - 2 y2", [](S s) { return values(s.v[1] - 2 * s.v[0]); }},
       {"the second rope's length", [](S s) { return values(s.springs_after(s.v[0], s.v[1])[1]); }},
       {{"S2 - y3 + y2 constant", [](S s) { return values(s.v[1] - s.v[0]); }}});
  says("mass_down", 2531, "y2 fixed, the second spring grows by what the mass goes down",
       {"S2 changes by Delta when y3 does", [](S s) { return values(s.delta); }},
       {"the second rope's length", [](S s) { return values(s.springs_after(0, s.delta)[1]); }},
       {{"by 2 Delta", [](S s) { return values(2 * s.delta); }}});
  says("pulley_down", 2535, "S2 - Delta, y3 + Delta, y2 + Delta keeps the second rope's length",
       {"S2 changes by -Delta", [](S s) { return values(-s.delta); }},
       {"the second rope's length", [](S s) { return values(s.springs_after(s.delta, s.delta)[1]); }},
       {{"S2 changes by Delta", [](S s) { return values(s.delta); }}});
  return all;
}

/// Where the text has a string stretched or compressed it is the spring that is: its rope keeps its length.
struct Slip {
  const char *id, *says, *printed, *meant, *near;
  int line;
  std::size_t rope;     ///< over which pulley
  double down2, down3;  ///< what y2 and y3 grow by, over Delta
  double by;            ///< what the text says is gained, over Delta
  const char* why;
};

Claim string_for_spring(const Slip& slip, double seed) {
  const V change{"what the text says, by Delta", [=](S s) { return values(slip.by * s.delta); }};
  const V spring{"the spring, from the rope's length", [=](S s) {
                   return values(s.springs_after(slip.down2 * s.delta, slip.down3 * s.delta)[slip.rope]);
                 }};
  const V rope{"the rope, summed over its straight parts", [=](S s) {
                 return values(s.ropes_after(slip.down2 * s.delta, slip.down3 * s.delta)[slip.rope]);
               }};
  const V opposite{"by -Delta", [=](S s) { return values(-slip.by * s.delta); }};
  Claim claim{slip.id, slip.line, slip.says};
  claim.printed = {slip.printed, {compare("change of the string's length", change, rope, seed)}};
  claim.meant = {slip.meant, {compare("change of the spring's length", change, spring, seed)}};
  claim.near_misses = {{slip.near, {compare("change of the spring's length", opposite, spring, seed)}}};
  claim.why = slip.why;
  return claim;
}

std::vector<Claim> strings(double seed) {
  const Slip first{"3.19-string_stretched",
                   "when the small pulley goes down the string is stretched",
                   "the string over the large pulley gets longer",
                   "the first spring gets longer",
                   "the first spring gets shorter",
                   2521,
                   0,
                   1,
                   0,
                   1,
                   "The string is the wire, whose length the same paragraph calls constant; what gets longer "
                   "is the spring. "
                   "The letter is right: $S_1$ is the spring's length, and grows by $\\Delta$ while the "
                   "wire's change is 0. "
                   "Line 2529 has the same word for the second spring."};
  const Slip second{
      "3.19-must_compress",
      "when the small pulley and the mass both go down by Delta the string must be compressed",
      "the string over the small pulley gets shorter",
      "the second spring gets shorter by Delta",
      "the second spring gets longer by Delta",
      2533,
      1,
      1,
      1,
      -1,
      "Again it is the spring, not the string, that gives way: $S_2$ becomes $S_2-\\Delta$ and the wire's "
      "length "
      "changes by 0. How much depends on the mass, for $y_2$ and $y_3$ are independent: with $y_3$ fixed the "
      "spring shortens by $2\\Delta$, and with $y_3\\to y_3+3\\Delta$ it gets longer by $\\Delta$. The "
      "text's "
      "example is the case in which the small pulley does not turn."};
  return {string_for_spring(first, seed), string_for_spring(second, seed)};
}

/// A rope pulls or hangs slack: its tension and its slack are not negative, and one of them is zero.
Claim compressed(double seed) {
  const V possible{"(0, 0, 0)", [](S) { return values(0, 0, 0); }};
  const auto reading = [&](const std::string& text, double (*tension)(double)) {
    const V rope{text, [=](S s) {
                   const Sample pressed = s.stretched(-1);
                   const double S1 = pressed.springs(s.q)[0], L1 = pressed.p.L1;
                   const double T = tension(s.p.c1 * (S1 - L1)), slack = L1 + T / s.p.c1 - S1;
                   return values(std::min(T, 0.0), std::min(slack, 0.0), T * slack);
                 }};
    return Reading{text, {compare("negative tension, negative slack, their product", rope, possible, seed)}};
  };
  Claim claim{"3.19-compression", 2517,
              "the force on the small pulley is m2 g - c1 (S1 - L1) also in compression, when S1 < L1"};
  claim.printed = reading("the rope's tension is c1 (S1 - L1)", [](double pull) { return pull; });
  claim.corrected = reading("the rope's tension is c1 (S1 - L1), and 0 where that is negative",
                            [](double pull) { return std::max(pull, 0.0); });
  claim.near_misses = {
      reading("the rope's tension is c1 |S1 - L1|", [](double pull) { return std::abs(pull); })};
  claim.why =
      "Between spring and pulley is a wire, and a wire cannot push: where $S_1<L_1$ it hangs slack and the "
      "force "
      "is $m_2g$ alone; the same holds for $S_2<L_2$. With $K_1=-0.5$ m the default pulley starts at "
      "$S_1=0.5$ m, "
      "pushed down with 20 N that are not there. The equations are valid as long as both wires are taut; in "
      "the default "
      "motion they are, its springs being stretched by at least 0.94 m and 0.18 m.";
  return claim;
}

Claim two_freedoms() {
  const auto freedoms = [](bool fixed) {
    Eigen::MatrixXd ties(fixed ? 5 : 4, 7);  // of y1, y2, y3, S1, S2, theta1, theta2; R1 = 2, R2 = 3
    ties.topRows(4) << -2, 1, 0, -1, 0, 0, 0, /**/ 0, 2, -1, 0, 1, 0, 0, /**/ 1, -1, 0, 0, 0, 2, 0, /**/ 0, 1,
        -1, 0, 0, 0, 3;
    if (fixed) ties.row(4) << 1, 0, 0, 0, 0, 0, 0;
    return 7 - rank(ties);
  };
  const auto reading = [&](const std::string& text, int count, bool fixed) {
    return Reading{text,
                   {{"degrees of freedom",
                     {"as stated", count},
                     {"7 coordinates less the rank of their ties", freedoms(fixed)},
                     exact()}}};
  };
  Claim claim{"3.19-two_freedoms", 2439, "the system has two degrees of freedom, since y1 is fixed"};
  claim.printed = reading("2", 2, true);
  claim.near_misses = {reading("3", 3, true), reading("2 with y1 free", 2, false)};
  return claim;
}

std::vector<Claim> derivatives(double seed) {
  std::vector<Claim> all;
  const auto says = [&](const char* id, int line, const char* what, const V& printed, const V& truth,
                        const std::vector<V>& near) {
    all.push_back(formula_claim(std::string("3.19-") + id, line, what, seed, printed, truth, near));
  };
  const auto lost = [&](const char* what, const V& as_it_stands, const V& truth, const char* why) {
    bars_lost(all.back(), what, seed, as_it_stands, truth, why);
  };
  const auto in_coordinates = [](double sign) {
    return [sign](S s) {
      const double d = s.v[1] + sign * s.v[0];
      return values(s.p.m2 / 2 * s.v[0] * s.v[0] + s.p.turn1() / 2 * s.v[0] * s.v[0] +
                    s.p.m3 / 2 * s.v[1] * s.v[1] + s.p.turn2() / 2 * d * d);
    };
  };
  const V by_rims{
      "masses by y', pulleys by the speeds of their rims", [](S s) {
        const Pair rim = s.rim_speeds();
        const double w1 = rim[0] / s.p.R1, w2 = rim[1] / s.p.R2;
        return values(
            (s.p.m2 * s.v[0] * s.v[0] + s.p.m3 * s.v[1] * s.v[1] + s.p.I1 * w1 * w1 + s.p.I2 * w2 * w2) / 2);
      }};
  says("kinetic_energy", 2443, "T in y2' and y3' alone",
       {"m2/2 y2'^2 + I1/(2 R1^2) y2'^2 + m3/2 y3'^2 + I2/(2 R2^2) (y3' - y2')^2", in_coordinates(-1)},
       by_rims, {{"(y3' + y2')^2", in_coordinates(1)}});
  lost("T is m2/2 y2'^2 + I1 2 R1^2 y2'^2 + m3/2 y3'^2 + I2 2 R2^2 (y3' - y2')^2",
       {"I1 2 R1^2 and I2 2 R2^2, as products",
        [](S s) {
          const double d = s.v[1] - s.v[0], I1 = s.p.I1 * 2 * s.p.R1 * s.p.R1,
                       I2 = s.p.I2 * 2 * s.p.R2 * s.p.R2;
          return values(s.p.m2 / 2 * s.v[0] * s.v[0] + I1 * s.v[0] * s.v[0] + s.p.m3 / 2 * s.v[1] * s.v[1] +
                        I2 * d * d);
        }},
       by_rims,
       "The fraction bars of the pulleys' terms are lost in the text at hand: $I_1/(2R_1^2)$ and "
       "$I_2/(2R_2^2)$, and before them $I_1/2$ and $I_2/2$. The default pulleys have 1 kg and 0.5 kg there, "
       "and the products are 0.25 and 0.125.");
  says("dT_dy", 2475, "T depends on neither y2 nor y3",
       {"dT/dy by dual numbers, the pulleys turned by the ropes",
        [](S s) { return Value(df_dq(s.kinetic(), s.q, s.v)); }},
       {"(0, 0)", [](S) { return values(0, 0); }},
       {{"dL/dy", [](S s) { return Value(df_dq(Lagrangian{s.p}, s.q, s.v)); }}});
  const auto momenta = [](S s, const Pair& v, double sign) {
    return values(s.p.m2 * v[0] + s.p.turn1() * v[0] + s.p.turn2() * (v[0] - v[1]),
                  s.p.m3 * v[1] + s.p.turn2() * (v[1] - sign * v[0]));
  };
  says("dT_dydot", 2483, "the derivatives of T by y2' and y3'",
       {"(m2 y2' + I1/R1^2 y2' + I2/R2^2 (y2' - y3'), m3 y3' + I2/R2^2 (y3' - y2'))",
        [=](S s) { return momenta(s, s.v, 1); }},
       {"dual numbers", [](S s) { return Value(df_dv(KineticEnergy{s.p}, s.q, s.v)); }},
       {{"y3' + y2'", [=](S s) { return momenta(s, s.v, -1); }}});
  const auto products = [](const Given<double>& p) { return Pair{p.I1 * p.R1 * p.R1, p.I2 * p.R2 * p.R2}; };
  lost(
      "the derivatives of T are m2 y2' + I1 R1^2 y2' + (I2/R2^2) (y2' - y3') and m3 y3' + I2 R2^2 (y3' - "
      "y2')",
      {"I1 R1^2 and I2 R2^2, as products",
       [=](S s) {
         const auto [I1, I2] = products(s.p);
         return values(s.p.m2 * s.v[0] + I1 * s.v[0] + s.p.turn2() * (s.v[0] - s.v[1]),
                       s.p.m3 * s.v[1] + I2 * (s.v[1] - s.v[0]));
       }},
      {"dual numbers", [](S s) { return Value(df_dv(KineticEnergy{s.p}, s.q, s.v)); }},
      "The bars of $I_1/R_1^2$ in the first and of $I_2/R_2^2$ in the second derivative are lost in the text "
      "at hand; the third one of the three is there. A pulley of a tenth of the radius would turn a hundred "
      "times more easily, where its rim is a hundred times harder to move.");
  says("momentum_rates", 2497, "their time derivatives",
       {"the same in y2'' and y3''", [=](S s) { return momenta(s, s.a, 1); }},
       {"nested dual numbers", [](S s) { return Value(rate_of_df_dv(KineticEnergy{s.p}, s.q, s.v, s.a)); }},
       {{"y3'' + y2''", [=](S s) { return momenta(s, s.a, -1); }}});
  says("force_y3", 2543, "the generalized force on y3",
       {"m3 g - c2 (K2 - L2 + y3 - 2 y2)", [](S s) { return values(s.p.m3 * s.p.g - s.pull2()); }},
       {"-dV/dy3 by dual numbers", [](S s) { return values(s.forces()[1]); }},
       {{"the spring's sign flipped", [](S s) { return values(s.p.m3 * s.p.g + s.pull2()); }}});
  const auto second = [](double sign, const Pair& a, S s) {
    return values(s.p.m3 * a[1] + s.p.turn2() * (a[1] - a[0]) + s.pull2() - sign * s.p.m3 * s.p.g);
  };
  says("equation_y3", 2553, "m3 y3'' + I2/R2^2 (y3'' - y2'') - (m3 g - c2 (K2 - L2 + y3 - 2 y2)) is zero",
       {"with y'' by Lagrange's equations", [=](S s) { return second(1, s.by_lagrange(), s); }},
       {"0", [](S) { return values(0); }}, {{"-m3 g", [=](S s) { return second(-1, s.by_lagrange(), s); }}});
  all.back().printed.checks.push_back(compare<Sample>(
      "the same", {"with y'' from the ropes' tensions", [=](S s) { return second(1, s.by_tensions(), s); }},
      {"0", [](S) { return values(0); }}, seed));
  lost("m3 y3'' + I2 R2^2 (y3'' - y2'') = m3 g - c2 (K2 - L2 + y3 - 2 y2)",
       {"I2 R2^2 as a product, y'' by Lagrange's equations",
        [=](S s) {
          const Pair a = s.by_lagrange();
          return values(s.p.m3 * a[1] + products(s.p)[1] * (a[1] - a[0]) + s.pull2() - s.p.m3 * s.p.g);
        }},
       {"0", [](S) { return values(0); }},
       "The bar of $I_2/R_2^2$ is lost in the text at hand; line 2511, from which the term is taken, has it. "
       "The default pulley would weigh in with 0.0625 kg at its rim for 1 kg.");
  return all;
}

std::vector<Claim> forces(double seed) {
  const auto with = [](double lever) {
    return V{lever == 0 ? "m2 g - c1 (K1 - L1 + y2)"
                        : "m2 g - c1 (K1 - L1 + y2) + " + rounded(lever, 2) + " c2 (K2 - L2 + y3 - 2 y2)",
             [=](S s) { return values(s.p.m2 * s.p.g - s.pull1() + lever * s.pull2()); }};
  };

  Claim generalized{"3.19-force_y2", 2541, "the generalized force on y2 is m2 g - c1 (K1 - L1 + y2)"};
  const V by_energy{"-dV/dy2 by dual numbers", [](S s) { return values(s.forces()[0]); }};
  const auto reading = [&](const V& version, const std::string& what, const V& truth) {
    return Reading{version.text, {compare(what, version, truth, seed)}};
  };
  generalized.printed = reading(with(0), "the generalized force on y2", by_energy);
  generalized.corrected = reading(with(2), "the generalized force on y2", by_energy);
  generalized.near_misses = {reading(with(1), "the generalized force on y2", by_energy),
                             reading(with(-2), "the generalized force on y2", by_energy)};
  generalized.why =
      "When $y_2$ grows by $\\Delta$ at fixed $y_3$, the second spring shortens by $2\\Delta$ and does the "
      "work "
      "$2c_2(S_2-L_2)\\Delta$: its rope pulls the small pulley down on both sides. At rest the first spring "
      "must "
      "carry $(m_2+2m_3)g$; as published it carries $m_2 g$ alone, 9.81 N for 49.05 N with the default "
      "masses.";

  Claim first{"3.19-equation_y2", 2547,
              "m2 y2'' + I1/R1^2 y2'' + I2/R2^2 (y2'' - y3'') = m2 g - c1 (K1 - L1 + y2) (the bar of I1/R1^2 "
              "restored)"};
  const auto equation = [](double lever, bool tensions) {
    return V{
        "y'' " + std::string(tensions ? "from the ropes' tensions" : "by Lagrange's equations"), [=](S s) {
          const Pair a = tensions ? s.by_tensions() : s.by_lagrange();
          return values(s.p.m2 * a[0] + s.p.turn1() * a[0] + s.p.turn2() * (a[0] - a[1]) - lever * s.pull2());
        }};
  };
  const V right{"m2 g - c1 (K1 - L1 + y2)", [](S s) { return values(s.p.m2 * s.p.g - s.pull1()); }};
  const auto equations = [&](const std::string& text, double lever) {
    return Reading{
        text,
        {compare("the left side, less the second spring's part", equation(lever, false), right, seed),
         compare("the left side, less the second spring's part", equation(lever, true), right, seed)}};
  };
  first.printed = equations("no part of the second spring", 0);
  first.corrected = equations("2 c2 (K2 - L2 + y3 - 2 y2) added on the right", 2);
  first.near_misses = {equations("it pulls once", 1), equations("it pulls upward", -2)};
  first.why =
      "The term $+2c_2(K_2-L_2+y_3-2y_2)$ is missing. Without it energy is not conserved, and the rest "
      "position "
      "is not even stable: with the default values the two frequencies are $3.05 \\pm 1.06\\,i$ per second, "
      "and the motion grows more than a thousandfold in eight seconds. With the term they are 1.63 and 6.40 "
      "per second.";

  Claim on_pulley{"3.19-force_on_pulley", 2517,
                  "gravity and the first spring are all that acts on the pulley"};
  const V m2_a{"m2 y2'' by Lagrange's equations", [](S s) { return values(s.p.m2 * s.by_lagrange()[0]); }};
  const V both_ropes{"m2 g less the upper rope's tension plus those of the lower rope's two sides", [](S s) {
                       const Pair a = s.by_tensions();
                       return values(s.p.m2 * s.p.g - (s.pull1() + s.p.turn1() * a[0]) + s.pull2() +
                                     (s.pull2() + s.p.turn2() * (a[1] - a[0])));
                     }};
  on_pulley.printed = reading(with(0), "the force on the small pulley", m2_a);
  on_pulley.corrected = reading(both_ropes, "the force on the small pulley", m2_a);
  on_pulley.near_misses = {reading(with(2), "the force on the small pulley", m2_a)};
  on_pulley.why =
      "There are four forces: gravity, the upper rope's tension, which is $c_1(S_1-L_1)$ only if the large "
      "pulley has no inertia, and the lower rope on both sides of the small pulley.";

  Claim on_mass{"3.19-force_on_mass", 2525,
                "gravity and the second spring's pull, m3 g - c2 (S2 - L2), are the force on the mass"};
  const V m3_a{"m3 y3'' by Lagrange's equations", [](S s) { return values(s.p.m3 * s.by_lagrange()[1]); }};
  const auto on_rope = [](double sign) {
    return V{sign == 0
                 ? "m3 g - c2 (S2 - L2)"
                 : "m3 g - c2 (S2 - L2) " + std::string(sign < 0 ? "-" : "+") + " I2/R2^2 (y3'' - y2'')",
             [=](S s) {
               const Pair a = s.by_tensions();
               return values(s.p.m3 * s.p.g - s.pull2() + sign * s.p.turn2() * (a[1] - a[0]));
             }};
  };
  on_mass.printed = reading(on_rope(0), "the force on the mass", m3_a);
  on_mass.corrected = reading(on_rope(-1), "the force on the mass", m3_a);
  on_mass.near_misses = {reading(on_rope(1), "the force on the mass", m3_a)};
  on_mass.why =
      "The pulley between spring and mass has inertia: the rope pulls the mass with $c_2(S_2-L_2) + "
      "(I_2/R_2^2)(\\ddot y_3-\\ddot y_2)$, at the default start with 21.7 N for the 30 N of the spring. "
      "What "
      "the formula does give is the generalized force on $y_3$, and the equation of motion that uses it as "
      "such "
      "is right.";

  Claim spring{"3.19-stretched", 2517,
               "S1 > L1 is stretching: the first spring then pulls the small pulley up"};
  const auto sign = [](double c) {
    return V{c > 0 ? "-c1 (S1 - L1)" : "+c1 (S1 - L1)", [=](S s) {
               const Sample stretched = s.stretched();
               return values(-c * s.p.c1 * (stretched.springs(s.q)[0] - stretched.p.L1));
             }};
  };
  const V part{"what -dV/dy2 has for c1 and not for c1 = 0", [](S s) {
                 const Sample stretched = s.stretched();
                 Given<double> free = stretched.p;
                 free.c1 = 0;
                 return values(stretched.forces()[0] + df_dq(PotentialEnergy{free}, s.q, s.v)[0]);
               }};
  spring.printed = reading(sign(1), "the first spring's part", part);
  spring.near_misses = {reading(sign(-1), "the first spring's part", part)};
  return {spring, on_pulley, on_mass, generalized, first};
}

Given<double> asked(const Parameters& p) {
  return {p["m2"], p["m3"], p["I1"], p["I2"], p["R1"], p["R2"], p["c1"], p["c2"], p["L1"],
          p["L2"], p["K1"], p["K2"], p["g"],  p["y2"], p["y3"], p["v2"], p["v3"]};
}

Quantity swing(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return depths(asked(p), horizon, truth);
}

Scene scene() {
  return {
      swing,
      8,
      centimeter,
      "c1",
      {10, 40, 160, 1000, 10000},
      {"y2", "y3", "v2"},
      {{"y2", "y3"}, "s", {{"m", {0}}, {"m", {1}}}},
      {{"chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"},
       {{"two coordinates",
         "two_pulleys::TwoCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}}"},
        {"four coordinates with tensions",
         "two_pulleys::FourCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}}"},
        {"published equations",
         "two_pulleys::TwoCoordinates<double>{{m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}, "
         "0}"}},
       {{"normal modes", "which needs GSL's eigenvalues"},
        {"normal modes, pulleys without inertia", "which needs GSL's eigenvalues"}}}};
}

Findings study(const Parameters& p, const Reference& truth) {
  const Given<double> pulleys = asked(p);
  std::vector<Claim> claims = kinematics(p["seed"]);
  claims.push_back(two_freedoms());
  for (const auto& more : {derivatives(p["seed"]), forces(p["seed"])})
    claims.insert(claims.end(), more.begin(), more.end());
  for (const Claim& claim : strings(p["seed"])) claims.push_back(claim);
  claims.push_back(compressed(p["seed"]));

  Given<double> stiff = pulleys;
  stiff.c1 *= 0x1p30;
  Quantity graded = frequencies("graded_frequencies", "the same with the first spring 2^30 times as stiff",
                                stiff, true, truth);
  graded.add(Breakdown{
      "The quadratic formula subtracts two nearly equal numbers, and the eigenvalue solver errs by roundings "
      "of the larger eigenvalue. The product of the roots is c1 c2/det M, without subtraction.",
      "det(K - s M) = 0, quadratic formula", 0, Outcome::inaccurate,
      "det(K - s M) = 0, larger root and product", 0});
  return {claims,
          {motion(scene(), p, truth),
           frequencies("frequencies", "angular frequencies of the two modes, by their true values", pulleys,
                       false, truth),
           graded}};
}

}  // namespace ex03_19

Exercise exercise_3_19() {
  using namespace ex03_19;
  return {
      "Two pulleys and two springs",
      "A spring holds, by a rope over a fixed pulley, a second pulley; another spring holds, by a rope over "
      "that one, a mass. Find the equations of motion for the depths $y_2$ of the second pulley and $y_3$ "
      "of the mass.",
      parameters, scene(), study};
}

}  // namespace oddity
