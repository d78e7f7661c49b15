// The claims of exercise 2.9, on random plates of particles: the text's sums against the torque of the
// weights.

#include "chapters/claims.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "chapters/02_basic_concepts/09_balance/balance.hpp"
#include "chapters/02_basic_concepts/shared/rotations.hpp"

namespace oddity::balance {

namespace {

using namespace basic_vectors;
using rotation::quaternion;

/// Particles, and a line on which they may balance.
struct Plate {
  std::vector<Particle> particles;
  Vector A{}, D{}, N{};  ///< a point of the fulcrum, its direction, its normal

  template <class F>
  double sum(const F& f) const {
    double all = 0;
    for (const Particle& p : particles) all += f(p.m, p.r - A);
    return all;
  }
  /// The sums of m x and m y, counted from A.
  Vector moment() const {
    return {sum([](double m, const Vector& r) { return m * r[0]; }),
            sum([](double m, const Vector& r) { return m * r[1]; }), 0};
  }
  Vector center() const {
    return A + 1 / sum([](double m, const Vector&) { return m; }) * moment();
  }
  /// The torque about -D of the weights (0, 0, -m), the plate turned about the fulcrum by `tilt`.
  double torque(double tilt = 0) const {
    const auto turned = quaternion(D, tilt);
    return sum([&](double m, const Vector& r) { return -dot(D, cross(turned(r), Vector{0, 0, -m})); });
  }
  double size() const {
    return sum([&](double m, const Vector& r) { return m * (length(r) + length(A)); });
  }
};

/// A random plate on lines through its center of mass, through the mean of its positions, and beside both.
struct Sample {
  Plate center, mean, beside;

  explicit Sample(Random& random) {
    Plate& plate = center;
    const Vector offset = random.point(20);
    Vector middle{};
    const int n = 2 + random.below(10);
    for (int i = 0; i < n; ++i) {
      Vector r = offset + random.point(5);
      r[2] = 0;
      plate.particles.push_back({std::abs(random.magnitude(0.05, 20)), r});
      middle = middle + 1.0 / n * r;
    }
    const double angle = random.between(0, 2 * pi);
    plate.D = {cos(angle), sin(angle), 0};
    plate.N = cross(Vector{0, 0, 1}, plate.D);
    const double along = random.between(-5, 5), away = random.between(1, 4);
    const Vector shift = away * plate.N + along * plate.D;
    plate.A = plate.center();
    mean = beside = plate;
    mean.A = middle, beside.A = plate.A + shift;
  }
  double size() const { return center.size(); }
  std::string where() const {
    return std::to_string(center.particles.size()) + " particles, $C$ = " + shown(center.A) +
           ", $D$ = " + shown(center.D);
  }
};
using OfPlate = Formula<Sample>;

template <class Of>
OfPlate about(std::string text, Plate Sample::*plate, const Of& of) {
  return {std::move(text), [=](const Sample& s) { return Value(of(s.*plate)); }};
}
template <class Of>
OfPlate beside(std::string text, const Of& of) {
  return about(std::move(text), &Sample::beside, of);
}
/// m times what is seen of each particle: of its place P and of s and t.
template <class See>
OfPlate each(std::string text, const See& see) {
  return beside(std::move(text), [=](const Plate& plate) {
    std::vector<double> all;
    for (const Particle& p : plate.particles) {
      const Vector r = p.r - plate.A;
      for (double x : Value(see(plate, p.r, dot(plate.D, r), dot(plate.N, r)))) all.push_back(p.m * x);
    }
    return all;
  });
}
OfPlate zero(std::size_t n) {
  return {"zero", [n](const Sample&) { return Value(std::vector<double>(n)); }};
}

void coordinates(Claims& claims, const std::vector<Sample>& plates) {
  using P = const Plate&;
  using V = const Vector&;
  claims.formula("normal_form", 591, R"($C+sD$ has $N\cdot(P-C)=0$)", plates,
                 {.quantity = R"($N\cdot(P-C)$, times $m$)",
                  .truth = each("zero", [](P, V, double, double) { return 0.0; }),
                  .printed = each(R"($N\cdot(C+sD-C)$)",
                                  [](P p, V, double s, double) { return dot(p.N, (p.A + s * p.D) - p.A); }),
                  .near_misses = {each(R"($N\cdot(C+tN-C)$)", [](P p, V, double, double t) {
                    return dot(p.N, (p.A + t * p.N) - p.A);
                  })}});
  claims.formula(
      "coordinate_system", 593, R"($C$, $D$ and $N$ are a coordinate system of the plane)", plates,
      {.quantity = R"($P$, times $m$)",
       .truth = each("every particle's place", [](P, V r, double, double) { return r; }),
       .printed = each(R"($C+sD+tN$)", [](P p, V, double s, double t) { return p.A + s * p.D + t * p.N; }),
       .near_misses = {each(R"($C+sD$)", [](P p, V, double s, double) { return p.A + s * p.D; })}});
  claims.formula(
      "decomposition", 595, R"($s=D\cdot(P-C)$, $t=N\cdot(P-C)$)", plates,
      {.quantity = R"($(s,t)$, times $m$)",
       .truth =
           each(R"(Cramer's rule for $P=C+sD+tN$)",
                [](P p, V at, double, double) {
                  const Vector r = at - p.A;
                  const double det = p.D[0] * p.N[1] - p.D[1] * p.N[0];
                  return Value{(r[0] * p.N[1] - r[1] * p.N[0]) / det, (p.D[0] * r[1] - p.D[1] * r[0]) / det};
                }),
       .printed = each(R"($(D\cdot(P-C),N\cdot(P-C))$)",
                       [](P, V, double s, double t) {
                         return Value{s, t};
                       }),
       .near_misses = {each(R"($(N\cdot(P-C),D\cdot(P-C))$)", [](P, V, double s, double t) {
         return Value{t, s};
       })}});
  claims.formula(
      "distance", 601, R"($t$ is the distance of the particle from the fulcrum)", plates,
      {.quantity = "the distance, times $m$",
       .truth = each("twice a triangle's area over its base on the line",
                     [](P p, V at, double, double) { return length(cross(7.0 * p.D, at - p.A)) / 7; }),
       .printed = each("$t$", [](P, V, double, double t) { return t; }),
       .corrected = each("$|t|$", [](P, V, double, double t) { return std::abs(t); }),
       .near_misses = {each("$|s|$", [](P, V, double s, double) { return std::abs(s); })},
       .kind = Fault::term,
       .root = "distance for coordinate",
       .why =
           R"($t_i=N\cdot(P_i-C)$ has a sign, a distance has none: on the side away from $N$, $t_i$ is the distance's )"
           R"(negative, and $|t_i|$ is the distance. The proof needs the sign. With distances the moment would be )"
           R"($\sum m_i|t_i|>0$, and no plate would balance.)"});
}

/// The half disc's moments about 32 lines through its center by another rule, or that of a uniform one.
Reading lamina_in_all_directions(const std::string& text, double k, bool uniform) {
  const auto moments = [k](auto integral) {
    return bodies::all_of(3, [&](std::size_t which) { return integral(bodies::gauss_rule(32), k, which); })
        .value;
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

void moments(Claims& claims, const std::vector<Sample>& plates, double k) {
  using P = const Plate&;
  const OfPlate torque =
      beside("the torque of the weights about the fulcrum", [](P p) { return p.torque(); });
  const auto of_t = [](P p) { return p.sum([&](double m, const Vector& r) { return m * dot(p.N, r); }); };
  const auto of_sums = [](Vector Plate::*by) { return [=](P p) { return dot(p.*by, p.moment()); }; };
  const auto line = [&](std::string_view slug, int number, const std::string& says, const OfPlate& printed,
                        const OfPlate& near) {
    claims.formula(slug, number, says, plates,
                   {.quantity = "the first moment about the fulcrum",
                    .truth = torque,
                    .printed = printed,
                    .near_misses = {near}});
  };
  line("first_moment", 603, R"(the first moment about the fulcrum is $M=\sum m_it_i$)",
       beside(R"($\sum m_it_i$)", of_t), beside(R"($\sum m_is_i$)", of_sums(&Plate::D)));
  line("with_normals", 605, R"($M=\sum m_iN\cdot(P_i-C)$)", beside(R"($\sum m_iN\cdot(P_i-C)$)", of_t),
       beside(R"($\sum N\cdot(P_i-C)$)",
              [](P p) { return p.sum([&](double, const Vector& r) { return dot(p.N, r); }); }));
  line("in_coordinates", 607, R"($M=\sum m_iN\cdot(x_i-\bar x,y_i-\bar y)$)",
       beside(R"($\sum m_iN\cdot(x_i-\bar x,y_i-\bar y)$)",
              [](P p) {
                return p.sum([&](double m, const Vector& r) { return m * (p.N[0] * r[0] + p.N[1] * r[1]); });
              }),
       beside(R"(the same with $N_x$ exchanged for $N_y$)",
              [](P p) { return p.N[1] * p.moment()[0] + p.N[0] * p.moment()[1]; }));
  line("factored", 609, R"($M=N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)",
       beside(R"($N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)", of_sums(&Plate::N)),
       beside(R"($D\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)", of_sums(&Plate::D)));

  const auto vanishes = [&](const std::string& what, std::size_t count, const OfPlate& formula) {
    return Reading{formula.text, {compare(what, formula, zero(count), plates)}};
  };
  const std::string center = "about the center of mass", mean = "about the mean of the positions";
  const std::string sums = R"($\sum m_i(x_i-\bar x,y_i-\bar y)$)",
                    product = R"($N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)";
  const auto both_sums = [](P p) { return Value{p.moment()[0], p.moment()[1]}; };
  claims.add("zero", 611, R"($M=N\cdot(0,0)=0$)",
             {.printed = vanishes(product, 1, about(center, &Sample::center, of_sums(&Plate::N))),
              .near_misses = {vanishes(product, 1, about(mean, &Sample::mean, of_sums(&Plate::N)))}});
  claims.add("sums", 615, R"($\sum m_i(x_i-\bar x,y_i-\bar y)=(0,0)$)",
             {.printed = vanishes(sums, 2, about(center, &Sample::center, both_sums)),
              .near_misses = {vanishes(sums, 2, about(mean, &Sample::mean, both_sums))}});
  const auto tilts = [](P p) {
    return Value{p.torque(-1), p.torque(-0.5), p.torque(), p.torque(0.5), p.torque(1)};
  };
  claims.add("balance", 615, "so the plate must balance, level or tilted",
             {.printed = vanishes("the torque at five tilts", 5,
                                  about("about a line through the center", &Sample::center, tilts)),
              .near_misses = {
                  vanishes("the torque at five tilts", 5, beside("about a line beside the center", tilts))}});
  const auto directions = [](P p) {
    std::vector<double> all;
    for (Plate turned = p; all.size() < 32; all.push_back(turned.torque()))
      turned.D = quaternion({0, 0, 1}, pi / 16)(turned.D);
    return all;
  };
  const std::string in_all = "moments about 32 lines";
  Reading regardless = vanishes(in_all, 32, about("through the center", &Sample::center, directions));
  regardless.checks.push_back(lamina_in_all_directions("through its center", k, false).checks[0]);
  claims.add(
      "regardless", 617, R"(whatever the direction $N$ of the line)",
      {.printed = regardless,
       .near_misses = {vanishes(in_all, 32, beside("through another point", directions)),
                       lamina_in_all_directions("through the center of a uniform half disc", k, true)}});
}

}  // namespace

std::vector<Claim> claims(double seed, double k) {
  const auto plates = draw<Sample>(60, seed);
  Claims claims("2.9");
  coordinates(claims, plates);
  moments(claims, plates, k);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"distance for coordinate",
       "Two equal weights 1 m either side of a fulcrum balance; with distances their moment is 2 kg m for 1 kg "
       "each, and an editor calls the plate unbalanced."}};
}

}  // namespace oddity::balance
