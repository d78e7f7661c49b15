// The claims of exercise 2.9, on random plates of particles: the text's sums checked by torques.

#include "chapters/particle_sums.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "chapters/02_basic_concepts/09_balance/balance.hpp"
#include "chapters/02_basic_concepts/shared/rotations.hpp"

namespace oddity::balance {

namespace {

using namespace basic_vectors;
using rotation::quaternion;

/// s and t of the position r relative to a point of the line: r = s D + t N by Cramer's rule.
template <class T>
std::array<T, 2> solved_by_cramer(const std::array<T, 3>& D, const std::array<T, 3>& N,
                                  const std::array<T, 3>& r) {
  const T det = D[0] * N[1] - D[1] * N[0];
  return {(r[0] * N[1] - r[1] * N[0]) / det, (D[0] * r[1] - D[1] * r[0]) / det};
}

/// Particles, and a line on which they may balance. Recorded for Coq there is one particle, and a sum is over
/// any number of them.
template <class T>
struct PlateOf {
  std::vector<ParticleOf<T>> particles;
  std::array<T, 3> A{}, D{}, N{};  ///< a point of the fulcrum, its direction and its normal

  template <class F>
  T sum(const F& f) const {
    T all(0.0);
    for (const auto& [m, r] : particles) all += f(m, r - A);
    if constexpr (std::same_as<T, Shortened>)
      return Expression::letter("(total l (fun m x y => " + all.expression().coq() + "))");
    else
      return all;
  }
  /// The sums of m x and m y, relative to A.
  std::array<T, 3> moment() const {
    return {sum([](const T& m, const auto& r) { return m * r[0]; }),
            sum([](const T& m, const auto& r) { return m * r[1]; }), T(0.0)};
  }
  T mass() const {
    return sum([](const T& m, const auto&) { return m; });
  }
  /// The torque of the weights (0, 0, -m), positive if it turns the side of N down.
  T level_torque() const {
    const std::array<T, 3> axis = cross(std::array<T, 3>{0.0, 0.0, 1.0}, N);
    return sum([&](const T& m, const auto& r) {
      return dot(axis, cross(r, std::array<T, 3>{0.0, 0.0, -m}));
    });
  }
  /// The torque about -D of one particle, with the plate turned about the fulcrum by `tilt`.
  T torque_of(const T& m, const std::array<T, 3>& r, const T& tilt) const {
    return -dot(D, cross(quaternion(D, tilt)(r), std::array<T, 3>{0.0, 0.0, -m}));
  }
  T tilted_torque(const T& tilt) const {
    return sum([&](const T& m, const auto& r) { return torque_of(m, r, tilt); });
  }
  std::vector<T*> letters() {
    std::vector<T*> all{&A[0], &A[1]};
    for (auto& [m, r] : particles) all.insert(all.end(), {&m, &r[0], &r[1]});
    return all;
  }
  /// Vectors in the plane.
  TypesetIn<T> typeset() const {
    TypesetIn<T> all{{"D", {D[0], D[1]}},
                     {"N", {N[0], N[1]}},
                     {"C", {A[0], A[1]}},
                     {R"(\bar x)", A[0]},
                     {R"(\bar y)", A[1]}};
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto& [m, r] = particles[i];
      const std::string index = "_{" + std::to_string(i + 1) + "}";
      const auto [s, t] = solved_by_cramer<T>(D, N, r - A);
      for (const auto& [letter, x] : {std::pair{"m", m}, {"x", r[0]}, {"y", r[1]}, {"s", s}, {"t", t}})
        all.emplace_back(letter + index, x);
      all.push_back({"P" + index, {r[0], r[1]}});
    }
    return all;
  }
};
using Plate = PlateOf<double>;

/// Random plates on lines through their center of mass, through the mean of their positions, or neither.
struct Plates {
  std::vector<Plate> center, mean, beside;

  explicit Plates(double seed) {
    Random random(seed);
    for (int n = 0; n < 60; ++n) {
      Plate plate;
      const Vector offset = random.point(20);
      Vector middle{};
      for (int i = 0; i < 6; ++i) {
        Vector r = offset + random.point(5);
        r[2] = 0;
        plate.particles.push_back({std::abs(random.magnitude(0.05, 20)), r});
        middle = middle + 1.0 / 6 * r;
      }
      const double angle = random.between(0, 2 * pi);
      plate.D = {cos(angle), sin(angle), 0};
      const Vector across = cross(Vector{0, 0, 1}, plate.D);
      plate.N = (random.below(2) == 0 ? 1.0 : -1.0) * across;
      const double along = random.between(-5, 5), away = random.between(1, 12);
      plate.A = bodies::center_by_lever_rule(plate.particles);
      center.push_back(plate), mean.push_back(plate), beside.push_back(plate);
      mean.back().A = middle, beside.back().A = plate.A + away * across + along * plate.D;
    }
  }
};

/// A particle's position in the plane, and a line.
template <class T>
struct PlaceOf {
  std::array<T, 3> C{}, D{}, N{}, P{};

  std::array<T, 2> solved() const { return solved_by_cramer<T>(D, N, P - C); }
  std::array<T*, 8> letters() { return {&C[0], &C[1], &D[0], &D[1], &N[0], &N[1], &P[0], &P[1]}; }
  TypesetIn<T> typeset() const {
    const auto [s, t] = solved();
    return {{"C", {C[0], C[1]}},   {"D", {D[0], D[1]}}, {"N", {N[0], N[1]}},
            {"P_i", {P[0], P[1]}}, {"s_i", s},          {"t_i", t}};
  }
};
using Place = PlaceOf<double>;
using OfPlace = ProvableFormula<PlaceOf>;

/// The solution of N . (P - C) = 0, or of N . P = 0, given one coordinate of P.
Vector solution(const Place& p, bool from_origin) {
  const std::size_t i = std::abs(p.N[0]) > std::abs(p.N[1]) ? 0 : 1, given = 1 - i;
  Vector solved = p.P;
  solved[i] = ((from_origin ? 0 : dot(p.N, p.C)) - p.N[given] * p.P[given]) / p.N[i];
  return solved;
}
/// The point of the line nearest to `at`.
constexpr auto foot = [](const auto& p, const auto& at) { return p.C + dot(p.D, at - p.C) * p.D; };

const OfPlace on_line = R"($N\cdot(C+s_iD-C)=0$)";

void coordinates(ProvableClaims<PlaceOf>& table, const std::vector<Place>& places) {
  const auto claim = table.over(places);
  claim("coordinate_system", 593,
        R"($C$, $D$ and $N$ form a coordinate system of the plane: $P_i=C+s_iD+t_iN$)",
        {"the particle's place", [](const auto& p) { return values(p.P[0], p.P[1]); }}, R"($C+s_iD+t_iN$)",
        "$P_i$");
  claim("decomposition", 597, R"($s_i=D\cdot(P_i-C)$, $t_i=N\cdot(P_i-C)$)",
        {R"(Cramer's rule for $P_i=C+s_iD+t_iN$)", [](const auto& p) { return p.solved(); }},
        R"($(D\cdot(P_i-C),\ N\cdot(P_i-C))$)", R"($(s_i,t_i)$)");
  claim(
      "distance", 601, R"($t_i$ is the distance from $P_i$ to the fulcrum line.)",
      {.quantity = "the distance",
       .truth = {"twice a triangle's area over its base on the line",
                 [](const auto& p) { return length(cross(7.0 * p.D, p.P - p.C)) / 7; }},
       .printed = "$t_i$",
       .corrected = "$|t_i|$",
       .in_view = {R"(for $t_i\ge0$, a particle on the side of $N$)",
                   [](const Place& p) { return dot(p.N, p.P - p.C) >= 0; }},
       .near_misses = {"$|s_i|$"},
       .root = "distance for coordinate",
       .why =
           R"($t_i=N\cdot(P_i-C)$ has a sign, a distance has none: on the side away from $N$, $t_i$ is the distance's )"
           R"(negative, and $|t_i|$ is the distance. The proof needs the sign. With distances the moment would be )"
           R"($\sum m_i|t_i|$, which is positive as soon as one particle is off the line.)"});
}

void line_and_distance(Claims& claims, const std::vector<Place>& places) {
  const Formula<Place> zero{"zero", [](const Place&) { return 0.0; }};
  const auto solutions = [&](std::string text, bool from_origin) {
    return compare<Place>(
        "solutions of the normal form",
        {std::move(text), [=](const Place& p) { return solution(p, from_origin); }},
        {"$C+sD$ nearest to them", [=](const Place& p) { return foot(p, solution(p, from_origin)); }},
        places);
  };
  const std::string normal = R"($N\cdot(P-C)$ on the line)";
  std::vector<Reading> near_misses = single_changes<Place>(normal, on_line, zero, places, R"($N\cdot D=0$)");
  near_misses.push_back({R"(the solutions of $N\cdot P=0$)", {solutions(R"($P$ with $N\cdot P=0$)", true)}});
  claims.add("normal_form", 591, R"(The line $P(s)=C+sD$ is $N\cdot(P-C)=0$.)",
             {.printed = {on_line.text,
                          {compare<Place>(normal, computed<Place>(on_line), zero, places),
                           solutions(R"($P$ with $N\cdot(P-C)=0$)", false)},
                          true},
              .near_misses = std::move(near_misses)});
}

/// The half disc's moments about 32 lines through its center by another rule, or a uniform one's center.
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

ProvableFormula<PlateOf> sum_of(const std::string& text) { return over_particles<PlateOf>(text, "m x y"); }
const std::string factored = R"($M=N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)";

void moments(ProvableClaims<PlateOf>& beside, const std::vector<Plate>& plates,
             ProvableClaims<PlateOf>& center, const std::vector<Plate>& centered) {
  const auto line = [&](std::string_view slug, int number, const std::string& text,
                        const std::string& says = "") {
    beside.over(plates)(slug, number, says.empty() ? text : says,
                        {"the torque of the weights that turns the side of $N$ down",
                         [](const auto& p) { return p.level_torque(); }},
                        sum_of(text), "the first moment about the fulcrum");
  };
  line("first_moment", 603, R"($M=\sum m_it_i$)",
       R"(The first moment about the fulcrum is $M=\sum m_it_i$.)");
  line("with_normals", 605, R"($M=\sum m_iN\cdot(P_i-C)$)");
  line("in_coordinates", 607, R"($M=\sum m_iN\cdot(x_i-\bar x,y_i-\bar y)$)");
  line("factored", 609, factored);
  const auto vanishes = [&](std::string_view slug, int number, const std::string& says,
                            const std::string& text) {
    center.over(centered)(slug, number, says, {"zero", [](const auto&) { return 0.0; }}, sum_of(text),
                          "about the center of mass", "a multiple of zero is zero");
  };
  vanishes("zero", 611, R"($M=N\cdot(0,0)=0$)", R"($N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)=0$)");
  const std::string sums = R"($\sum m_i(x_i-\bar x,y_i-\bar y)=(0,0)$)";
  vanishes("sums", 615, sums, sums);
}

void about_lines(Claims& claims, const Plates& plates, double k) {
  const auto vanishes = [&](const std::string& what, const std::string& text, const std::vector<Plate>& all,
                            const std::function<Value(const Plate&)>& of) {
    return Reading{text, {compare<Plate>(what, {text, of}, {"zero", [](const Plate&) { return 0.0; }}, all)}};
  };
  const auto tilts = [](const Plate& p) {
    return Value{p.tilted_torque(-1), p.tilted_torque(-0.5), p.tilted_torque(0), p.tilted_torque(0.5),
                 p.tilted_torque(1)};
  };
  const std::string at_tilts = "the torque at five tilts", in_all = "moments about 32 lines";
  claims.add(
      "balance", 615,
      "As the first moment is zero, the plate must balance on the fulcrum (our check: tilted as well).",
      {.printed = vanishes(at_tilts, "about a line through the center", plates.center, tilts),
       .near_misses = {vanishes(at_tilts, "about a line next to the center", plates.beside, tilts)}});
  const auto directions = [](const Plate& p) {
    std::vector<double> all;
    const auto step = quaternion({0, 0, 1}, pi / 16);
    for (Plate turned = p; all.size() < 32; all.push_back(turned.level_torque()))
      turned.D = step(turned.D), turned.N = step(turned.N);
    return all;
  };
  Reading regardless = vanishes(in_all, "through the center", plates.center, directions);
  regardless.checks.push_back(lamina_in_all_directions("through its center", k, false).checks[0]);
  claims.add(
      "regardless", 617,
      R"(This is true whatever the direction of the line, as specified by $N$ (our check: of a lamina as well).)",
      {.printed = regardless,
       .near_misses = {vanishes(in_all, "through another point", plates.beside, directions),
                       lamina_in_all_directions("through the center of a uniform half disc", k, true)}});
}

}  // namespace

std::vector<Claim> claims(double seed, double k) {
  const Plates plates(seed);
  std::vector<Place> places;
  for (const Plate& plate : plates.beside)
    for (const Particle& p : plate.particles) places.push_back({plate.A, plate.D, plate.N, p.r});
  Claims claims("2.9");
  line_and_distance(claims, places);
  ProvableClaims<PlaceOf> of_places(claims);
  coordinates(of_places, places);
  ProvableClaims<PlateOf> of_plates(claims);
  moments(of_plates, plates.beside, of_plates, plates.center);
  about_lines(claims, plates, k);
  return claims.in_order();
}

Provables proofs() {
  const auto letter = [](const char* name) { return Shortened::letter(name); };
  PlateOf<Shortened> any{{{letter("m"), {letter("x"), letter("y"), Shortened(0.0)}}}};
  const PlateOf<Shortened> from_origin = any;
  any.A = {letter("a0"), letter("a1"), Shortened(0.0)};
  any.D = {letter("d0"), letter("d1"), Shortened(0.0)};
  any.N = cross(std::array{Shortened(0.0), Shortened(0.0), Shortened(1.0)}, any.D);
  const PlaceOf<Shortened> place{any.A, any.D, any.N, any.particles[0].r};
  const std::string letters = "(l : list (R * R * R)) (a0 a1 d0 d1 : R)",
                    of_particle = "(a0 a1 d0 d1 x y : R)", by_sums = "by_sums d0 d1",
                    by_center = "by_center l a0 a1 H H0";
  const std::vector<Proposition> unit{dot(any.D, any.D).expression() == 1},
      solves{unit[0], dot(place.N, place.P - place.C).expression() == 0};
  std::vector<Proposition> center;
  for (std::size_t i = 0; i < 2; ++i)
    center.push_back(from_origin.moment()[i].expression() == (any.A[i] * any.mass()).expression());

  Claims claims("2.9");
  ProvableClaims<PlateOf> lines(claims), at_center(claims);
  ProvableClaims<PlaceOf> places(claims);
  moments(lines, {}, at_center, {});
  coordinates(places, {});
  const auto vanishes = [&](const std::string& slug, const std::string& says, const std::string& all,
                            const Shortened& torque, const std::string& by_moments) -> Provable {
    const Expression is = torque.expression();
    const std::string by =
        "replace (" + is.coq() + ") with (" + by_moments + ")\n  by " + by_sums + "; " + by_center;
    return {"2.9-" + slug, says, {{"printed", all, center, {is == 0}, by}}};
  };
  const Shortened tilt = letter("tilt");
  const Shortened by_moments = any.torque_of(1.0, {1.0, 0.0, 0.0}, tilt) * any.moment()[0] +
                               any.torque_of(1.0, {0.0, 1.0, 0.0}, tilt) * any.moment()[1];
  Provables proved{
      vanishes("regardless",
               "the torque about the center of any number of masses vanishes, whatever the line's direction",
               letters, any.level_torque(), sum_of(factored).recorded(any)[0].coq()),
      vanishes("balance", "tilted by any angle, it is without torque about any line through its center",
               "(l : list (R * R * R)) (a0 a1 d0 d1 tilt : R)", any.tilted_torque(tilt),
               by_moments.expression().coq()),
      {"2.9-normal_form",
       "the points of any line solve it, and no others do",
       {{"printed", of_particle, unit, equal(on_line.recorded(place), {Expression(0.0)}), "field; lra"},
        {"no_other", of_particle, solves,
         equal(detail::recorded_value(place.P), detail::recorded_value(foot(place, place.P))), "nsatz"}}}};
  append(proved, lines.proofs("2.9", {any, letters, unit, by_sums,
                                      "it is the torque of any number of weights about any line"}));
  append(proved, at_center.proofs("2.9", {any, letters, center, by_center,
                                          "it vanishes about the center of any number of masses"}));
  append(proved, places.proofs("2.9", {.any = place,
                                       .letters = of_particle,
                                       .given = unit,
                                       .tactic = "first [field; lra | of_unit d0 d1; field | by_area d0 d1]",
                                       .says = "it holds of any particle and any line",
                                       .example = {.D = {1, 0, 0}, .N = {0, 1, 0}, .P = {0, -1, 0}}}));
  for (Provable& p : proved) p.preamble = coq_source({"sums"});
  return proved;
}

std::vector<Root> roots() {
  constexpr double weight = 1, aside = 1;
  const Plate pair{.particles = {{weight, {0, aside, 0}}, {weight, {0, -aside, 0}}}, .N = {0, 1, 0}};
  return {
      {"distance for coordinate",
       filled(
           "Two equal weights @1 m either side of a fulcrum balance; with distances their moment is @1 kg m "
           "for @1 kg each, and an editor calls the plate unbalanced.",
           {aside, pair.sum([&](double m, const Vector& r) { return m * std::abs(dot(pair.N, r)); }),
            weight})}};
}

}  // namespace oddity::balance
