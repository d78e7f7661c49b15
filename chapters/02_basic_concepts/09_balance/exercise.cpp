// Exercise 2.9: a plate of particles balances on every line through its center of mass C.
//   P = C + s D + t N, s = D . (P - C), t = N . (P - C);  M = sum of m t = N . sum of m (P - C) = 0
// The other route is the torque of the weights about the fulcrum in space, D . sum of (P - A) x (0, 0, -m),
// and knows no normal N. The lines of the derivation are algebra about any point A of the fulcrum: there they
// are checked about a random one, where M is not zero. The lamina is a half disc with the density exp(k x).

#include "chapters/02_basic_concepts/09_balance/half_disc.hpp"
#include "chapters/02_basic_concepts/shared/rotations.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex02_09 {

using rotation::Map, rotation::quaternion;
using namespace disc;

constexpr Parameter parameters[] = {
    {"k", 1, "1/m", "growth of the half disc's density, exp(k x), along its edge", 0.01, 20},
    {"phi", 0.7, "rad", "direction of the fulcrum", -7, 7},
    {"seed", 9, "", "of the random systems", 0, 1e9, whole_number},
};

// ---- particles --------------------------------------------------------------------------------------------

struct Particle {
  double m;
  Vector r;  ///< in the plane z = 0
};

struct Plate {
  std::vector<Particle> particles;
  Vector A, D, N;  ///< a point of the fulcrum, its direction, its normal

  template <class F>
  double sum(const F& f) const {
    double all = 0;
    for (const Particle& p : particles) all += f(p.m, p.r - A);
    return all;
  }
  double mass() const {
    return sum([](double m, const Vector&) { return m; });
  }
  Vector center() const {
    const Vector moment{sum([](double m, const Vector& r) { return m * r[0]; }),
                        sum([](double m, const Vector& r) { return m * r[1]; }), 0};
    return A + 1 / mass() * moment;
  }
  /// The torque about -D of the weights (0, 0, -m), the plate turned about the fulcrum by `tilt`.
  double torque(double tilt = 0) const {
    const Map turned = quaternion(D, tilt);
    return sum([&](double m, const Vector& r) { return -dot(D, cross(turned(r), {0, 0, -m})); });
  }
  double size() const {
    return sum([&](double m, const Vector& r) { return m * (length(r) + length(A)); });
  }
};
using P = const Plate&;
using V = const Vector&;

enum class Through { center, any_point, mean_of_positions };

Plate random_plate(Random& random, Through through) {
  Plate plate{{}, {}, {}, {}};
  const Vector offset = random.point(20);
  Vector mean{};
  const int n = 2 + random.below(10);
  for (int i = 0; i < n; ++i) {
    Vector r = offset + random.point(5);
    r[2] = 0;
    plate.particles.push_back({std::abs(random.magnitude(0.05, 20)), r});
    mean = mean + 1.0 / n * r;
  }
  const double angle = random.between(0, 2 * pi);
  plate.D = {cos(angle), sin(angle), 0};
  plate.N = cross({0, 0, 1}, plate.D);
  const Vector shift = random.between(1, 4) * plate.N + random.between(-5, 5) * plate.D;
  plate.A = through == Through::mean_of_positions ? mean : plate.center();
  if (through == Through::any_point) plate.A = plate.A + shift;
  return plate;
}

// ---- the claims -------------------------------------------------------------------------------------------

using Formula = std::function<Value(P)>;

struct Side {
  std::string text;
  Formula value;
  Through through = Through::any_point;
};

Reading compare(const Side& side, const Side& truth, double seed) {
  Worst worst(side.text + ", against " + truth.text, side.text, truth.text);
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const Plate plate = random_plate(random, side.through);
    worst.see(side.value(plate), truth.value(plate), plate.size(),
              "plate " + std::to_string(i) + ", D = " + shown(plate.D));
  }
  return {side.text, {worst.check()}};
}

Side zero(std::size_t n) {
  return {"zero", [n](P) { return Value(std::vector<double>(n)); }};
}

/// m (s, t) of each particle by the text's formulas.
template <class See>
Formula each(const See& see) {
  return [see](P plate) {
    std::vector<double> all;
    for (const Particle& p : plate.particles) {
      const Vector r = p.r - plate.A;
      for (double x : Value(see(plate, p.r, dot(plate.D, r), dot(plate.N, r)))) all.push_back(p.m * x);
    }
    return Value(all);
  };
}

std::vector<Claim> derivation(double seed) {
  const Side torque{"torque of the weights about the fulcrum", [](P plate) { return plate.torque(); }};
  const auto tilts = [](P plate) {
    return Value{plate.torque(-1), plate.torque(-0.5), plate.torque(), plate.torque(0.5), plate.torque(1)};
  };
  const auto directions = [](P plate) {
    std::vector<double> all;
    for (Plate turned = plate; all.size() < 32; all.push_back(turned.torque()))
      turned.D = quaternion({0, 0, 1}, pi / 16)(turned.D);
    return Value(all);
  };
  const auto first = [](P plate) {
    return plate.sum([&](double m, const Vector& r) { return m * dot(plate.N, r); });
  };
  const auto first_x = [](P plate) { return plate.sum([](double m, const Vector& r) { return m * r[0]; }); };
  const auto first_y = [](P plate) { return plate.sum([](double m, const Vector& r) { return m * r[1]; }); };
  const auto center = Through::center, mean = Through::mean_of_positions;
  const auto moments = [=](P plate) { return Value{first_x(plate), first_y(plate)}; };
  const auto turned = [=](P p) { return p.N[0] * first_x(p) + p.N[1] * first_y(p); };
  const auto exchanged = [=](P p) { return p.N[1] * first_x(p) + p.N[0] * first_y(p); };
  const auto along = [=](P p) { return p.D[0] * first_x(p) + p.D[1] * first_y(p); };
  const auto massless = [](P p) { return p.sum([&](double, V r) { return dot(p.N, r); }); };
  const auto in_coordinates = [](P p) {
    return p.sum([&](double m, V r) { return m * (p.N[0] * r[0] + p.N[1] * r[1]); });
  };
  const auto by_cramer = [](P p, V at, double, double) {
    const Vector r = at - p.A;
    const double det = p.D[0] * p.N[1] - p.D[1] * p.N[0];
    return Value{(r[0] * p.N[1] - r[1] * p.N[0]) / det, (p.D[0] * r[1] - p.D[1] * r[0]) / det};
  };
  const auto on_line = [](P p, V, double s, double) { return dot(p.N, (p.A + s * p.D) - p.A); };
  const auto off_line = [](P p, V, double, double t) { return dot(p.N, (p.A + t * p.N) - p.A); };
  const auto nothing = [](P, V, double, double) { return 0.0; };
  const auto rebuilt = [](P p, V, double s, double t) { return p.A + s * p.D + t * p.N; };
  const auto projected = [](P p, V, double s, double) { return p.A + s * p.D; };
  const auto itself = [](P, V r, double, double) { return r; };
  const auto s_and_t = [](P, V, double s, double t) { return Value{s, t}; };
  const auto t_and_s = [](P, V, double s, double t) { return Value{t, s}; };

  std::vector<Claim> claims;
  const auto add = [&](const std::string& id, int line, const std::string& says, const Side& printed,
                       const Side& truth, const Side& near) {
    claims.push_back(
        {"2.9-" + id, line, says, compare(printed, truth, seed), {}, {}, {compare(near, truth, seed)}});
  };
  add("normal_form", 591, "C + s D has N . (P - C) = 0", {"N . (C + s D - C)", each(on_line)},
      {"zero", each(nothing)}, {"N . (C + t N - C)", each(off_line)});
  add("coordinate_system", 593, "C, D and N are a coordinate system of the plane",
      {"C + s D + t N for every point", each(rebuilt)}, {"the point", each(itself)},
      {"C + s D", each(projected)});
  add("decomposition", 595, "s = D . (P - C), t = N . (P - C)", {"(s, t)", each(s_and_t)},
      {"Cramer's rule", each(by_cramer)}, {"(t, s)", each(t_and_s)});
  add("first_moment", 603, "the first moment about the fulcrum is the sum of m t", {"sum of m t", first},
      torque, {"sum of m s", along});
  add("with_normals", 605, "= sum of m N . (P - C)", {"sum of m N . (P - C)", first}, torque,
      {"sum of N . (P - C)", massless});
  add("in_coordinates", 607, "= sum of m N . (x_i - x, y_i - y)", {"in coordinates", in_coordinates}, torque,
      {"with N_x exchanged for N_y", exchanged});
  add("factored", 609, "= N . sum of m (x_i - x, y_i - y)", {"N . sums", turned}, torque,
      {"D . sums", along});
  add("zero", 611, "= N . (0, 0) = 0", {"N . sums about the center", turned, center}, zero(1),
      {"about the mean of the positions", turned, mean});
  add("sums", 615, "the sum of m (x_i - x, y_i - y) is (0, 0)", {"about the center", moments, center},
      zero(2), {"about the mean of the positions", moments, mean});
  add("balance", 615, "so the plate must balance, level or tilted",
      {"torque at five tilts about a line through the center", tilts, center}, zero(5),
      {"about a line beside the center", tilts});
  add("regardless", 617, "whatever the direction N of the line",
      {"moments about 32 lines through the center", directions, center}, zero(32),
      {"about 32 lines through another point", directions});
  return claims;
}

/// The half disc's moments about 32 lines through its center by another rule, or that of a uniform one.
Reading lamina_in_all_directions(const std::string& text, double k, bool uniform) {
  const auto moments = [k](auto integral) {
    return all_of(3, [&](std::size_t which) { return integral(gauss_rule(32), k, which); }).value;
  };
  const Value by_u = moments(by_sine), m = moments(by_sectors);
  const double x = uniform ? 0 : by_u[1] / by_u[0], y = uniform ? 4 / (3 * pi) : by_u[2] / by_u[0];
  std::vector<double> all;
  for (int j = 0; j < 32; ++j)
    all.push_back(cos(j * pi / 16) * (m[2] - m[0] * y) - sin(j * pi / 16) * (m[1] - m[0] * x));
  return {text,
          {{"moments of the half disc about 32 lines",
            {text, all},
            {"zero", std::vector<double>(32)},
            rounding(m[0]),
            m[0]}}};
}

Claim distance_claim(double seed) {
  Claim claim{"2.9-distance", 601, "t is the distance of the particle from the fulcrum"};
  const Side distance{"twice a triangle's area over its base on the line",
                      each([](P p, V at, double, double) { return length(cross(7.0 * p.D, at - p.A)) / 7; })};
  claim.printed = compare({"t", each([](P, V, double, double t) { return t; })}, distance, seed);
  claim.corrected =
      compare({"|t|", each([](P, V, double, double t) { return std::abs(t); })}, distance, seed);
  claim.near_misses = {
      compare({"|s|", each([](P, V, double s, double) { return std::abs(s); })}, distance, seed)};
  claim.why =
      "$t_i=N\\cdot(P_i-C)$ has a sign, a distance has none: on the side away from $N$, $t_i$ is the "
      "distance's negative, and $|t_i|$ is the distance. The proof needs the sign. With distances the "
      "moment would be $\\sum m_i|t_i|>0$, and no plate would balance.";
  return claim;
}

/// Five particles whose center is exact, 2^30 m from the origin.
Quantity far_balance() {
  const Vector center{0x1p30, -0x1p29, 0};
  const std::vector<Particle> particles{{1, center + Vector{3, 1, 0}},
                                        {2, center + Vector{-2, 4, 0}},
                                        {4, center + Vector{1, -3, 0}},
                                        {1, center + Vector{-3, 3, 0}},
                                        {8, center}};
  Quantity q{"far_balance",
             "kg m",
             "first moments of five particles about eight lines through their center, 2^30 m away",
             {"zero: the particles are placed so", std::vector<double>(8)},
             0,
             {1e-12, "rounding of ten products"},
             {},
             {}};
  const auto add = [&](const std::string& model, const std::string& algorithm, bool relative) {
    const auto moments = [=]<class T>(T all_mass) {
      std::vector<T> all;
      for (int j = 0; j < 8; ++j) {
        const auto along = [x = T(cos(0.3 + j)), y = T(sin(0.3 + j))](const Vector& r) {
          return x * T(r[0]) + y * T(r[1]);
        };
        T sum = 0.0;
        for (const Particle& p : particles) sum = sum + T(p.m) * along(relative ? p.r - center : p.r);
        all.push_back(relative ? sum : sum - all_mass * along(center));
      }
      return all;
    };
    const long work = operations_of([&] { return moments(Counted<double>(16)); }).all_but_additions();
    q.add({model, algorithm, no_knob(),
           [=](double) {
             return Answer{moments(16.0), work};
           },
           relative ? Outcome::ok : Outcome::inaccurate, relative ? "" : "terms of size 1e10 cancel"});
  };
  add("positions relative to the center", "sum of m N . (P - C)", true);
  add("positions from the origin", "sum of m N . P - m N . C", false);
  q.add(
      Breakdown{"Far from the origin the moments of the particles and of the center lose the digits in which "
                "they differ; the text's order, which subtracts the positions first, keeps them.",
                "positions from the origin, sum of m N . P - m N . C", 0, Outcome::inaccurate,
                "positions relative to the center, sum of m N . (P - C)", 0});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  std::vector<Claim> claims = derivation(p["seed"]);
  Claim& regardless = claims.back();
  const Reading lamina = lamina_in_all_directions("through its center", p["k"], false);
  regardless.printed.checks.push_back(lamina.checks[0]);
  regardless.near_misses.push_back(lamina_in_all_directions("through that of a uniform one", p["k"], true));
  claims.push_back(distance_claim(p["seed"]));
  std::ranges::stable_sort(claims, {}, &Claim::line);
  return {claims, {half_disc(p["k"], p["phi"], p["seed"], truth), far_balance()}};
}

}  // namespace ex02_09

Exercise exercise_2_9() {
  using namespace ex02_09;
  return {
      "Balance of a plate",
      "Show that a plate of point masses $m_i$ balances on every line through its center of mass $C$. Below "
      "$D$ and $N$ are the line's direction and normal, $s$ and $t$ the coordinates of a point along them, "
      "counted from $C$.",
      parameters,
      {},
      study};
}

}  // namespace oddity
