// The claims of exercise 2.9, on random plates of particles: the text's sums against the torque of the
// weights.

#include "chapters/claims.hpp"
#include "chapters/provable_claims.hpp"

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

/// Particles, and a line on which they may balance. Recorded, a sum is over any number of particles (m, x,
/// y).
template <class T>
struct PlateOf {
  std::vector<Particle> particles;
  std::array<T, 3> A{}, D{}, N{};  ///< a point of the fulcrum, its direction, its normal

  template <class F>
  T sum(const F& f) const {
    if constexpr (std::same_as<T, Shortened>) {
      const auto letter = [](const char* name) { return Shortened::letter(name); };
      const std::array<T, 3> r{letter("x") - A[0], letter("y") - A[1], T(0.0)};
      return Expression::letter("(total l (fun m x y => " + T(f(letter("m"), r)).expression().coq() + "))");
    } else {
      double all = 0;
      for (const Particle& p : particles) all += f(p.m, p.r - A);
      return all;
    }
  }
  /// The sums of m x and m y, counted from A.
  std::array<T, 3> moment() const {
    return {sum([](const T& m, const auto& r) { return m * r[0]; }),
            sum([](const T& m, const auto& r) { return m * r[1]; }), T(0.0)};
  }
  T mass() const {
    return sum([](const T& m, const auto&) { return m; });
  }
  /// The torque of the weights (0, 0, -m), positive where it turns the side of N down.
  T level_torque() const {
    const std::array<T, 3> axis = cross(std::array<T, 3>{0.0, 0.0, 1.0}, N);
    return sum([&](const T& m, const auto& r) {
      return dot(axis, cross(r, std::array<T, 3>{0.0, 0.0, -m}));
    });
  }
  /// The torque about -D of one of them, the plate turned about the fulcrum by `tilt`.
  T torque_of(const T& m, const std::array<T, 3>& r, const T& tilt) const {
    return -dot(D, cross(quaternion(D, tilt)(r), std::array<T, 3>{0.0, 0.0, -m}));
  }
  T tilted_torque(const T& tilt) const {
    return sum([&](const T& m, const auto& r) { return torque_of(m, r, tilt); });
  }
};

struct Plate : PlateOf<double> {
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
    const Vector across = cross(Vector{0, 0, 1}, plate.D);
    plate.N = (random.below(2) == 0 ? 1.0 : -1.0) * across;
    const double along = random.between(-5, 5), away = random.between(1, 12);
    const Vector shift = away * across + along * plate.D;
    plate.A = bodies::center_by_lever_rule(plate.particles);
    mean = beside = plate;
    mean.A = middle, beside.A = plate.A + shift;
  }
  double size() const { return center.size(); }
  /// Of the line beside the center, all in the plane.
  TypesetLetters typeset() const {
    const auto& [particles, A, D, N] = beside;
    TypesetLetters all{{"D", {D[0], D[1]}},
                       {"N", {N[0], N[1]}},
                       {"C", {A[0], A[1]}},
                       {R"(\bar x)", A[0]},
                       {R"(\bar y)", A[1]}};
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto& [m, r] = particles[i];
      const std::string index = "_{" + std::to_string(i + 1) + "}";
      const double along = dot(D, r - A), away = dot(N, r - A);
      for (const auto& [letter, x] : {std::pair{"m", m}, {"x", r[0]}, {"y", r[1]}, {"s", along}, {"t", away}})
        all.emplace_back(letter + index, x);
      all.emplace_back("P" + index, Value{r[0], r[1]});
    }
    return all;
  }
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
  return beside(std::move(text) + ", times $m$", [=](const Plate& plate) {
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

// Of a plate, a particle's place and its s and t.
constexpr auto off_line = [](const auto& p, const auto&, const auto& s, const auto&) {
  return dot(p.N, (p.A + s * p.D) - p.A);
};
constexpr auto place = [](const auto& p, const auto&, const auto& s, const auto& t) {
  return p.A + s * p.D + t * p.N;
};
/// s and t of a particle at r from A.
constexpr auto solved_by_cramer = [](const auto& p, const auto& r) {
  const auto det = p.D[0] * p.N[1] - p.D[1] * p.N[0];
  return std::array{(r[0] * p.N[1] - r[1] * p.N[0]) / det, (p.D[0] * r[1] - p.D[1] * r[0]) / det};
};
constexpr auto by_cramer = [](const auto& p, const auto& at, const auto&, const auto&) {
  return solved_by_cramer(p, at - p.A);
};
/// The place that is nearest on the line.
constexpr auto foot = [](const auto& p, const auto& at) { return p.A + dot(p.D, at - p.A) * p.D; };
/// The solution of N . (P - A) = 0, or of N . P = 0, with one of the coordinates of `at`.
Vector solution(const Plate& p, const Vector& at, bool from_origin) {
  const std::size_t i = std::abs(p.N[0]) > std::abs(p.N[1]) ? 0 : 1, given = 1 - i;
  Vector solved = at;
  solved[i] = ((from_origin ? 0 : dot(p.N, p.A)) - p.N[given] * at[given]) / p.N[i];
  return solved;
}
constexpr auto both = [](const auto&, const auto&, const auto& s, const auto& t) { return std::array{s, t}; };
constexpr auto by_area = [](const auto& p, const auto& at, const auto&, const auto&) {
  return length(cross(7.0 * p.D, at - p.A)) / 7;
};
constexpr auto size_of_t = [](const auto&, const auto&, const auto&, const auto& t) {
  using std::abs;
  return abs(t);
};

void coordinates(Claims& claims, const std::vector<Sample>& plates) {
  using P = const Plate&;
  using V = const Vector&;
  const OfPlate none = each("zero", [](P, V, double, double) { return 0.0; });
  const auto normal = [&](const OfPlate& on_line) {
    return compare<Sample>(R"($N\cdot(P-C)$ on the line, times $m$)", on_line, none, plates);
  };
  const auto solutions = [&](std::string text, bool from_origin) {
    return compare<Sample>(
        "solutions of the normal form, times $m$",
        each(std::move(text), [=](P p, V r, double, double) { return solution(p, r, from_origin); }),
        each("$C+sD$ nearest to them",
             [=](P p, V r, double, double) { return foot(p, solution(p, r, from_origin)); }),
        plates);
  };
  claims.add("normal_form", 591, R"(The line $P(s)=C+sD$ is $N\cdot(P-C)=0$.)",
             {.printed = {"its points are solutions, and there are no others",
                          {normal(each(R"($N\cdot(C+sD-C)$)", off_line)),
                           solutions(R"($P$ with $N\cdot(P-C)=0$)", false)}},
              .near_misses = {
                  {"the points $C+tN$",
                   {normal(each(R"($N\cdot(C+tN-C)$)",
                                [](P p, V, double, double t) { return dot(p.N, (p.A + t * p.N) - p.A); }))}},
                  {R"(the solutions of $N\cdot P=0$)", {solutions(R"($P$ with $N\cdot P=0$)", true)}}}});
  claims.formula(
      "coordinate_system", 593,
      R"($C$, $D$ and $N$ form a coordinate system of the plane: $P_i=C+s_iD+t_iN$)", plates,
      {.quantity = R"($P$, times $m$)",
       .truth = each("every particle's place", [](P, V r, double, double) { return r; }),
       .printed = each(R"($C+sD+tN$)", place),
       .near_misses = {each(R"($C+sD$)", [](P p, V, double s, double) { return p.A + s * p.D; })}});
  claims.formula("decomposition", 597, R"($s_i=D\cdot(P_i-C)$, $t_i=N\cdot(P_i-C)$)", plates,
                 {.quantity = R"($(s,t)$, times $m$)",
                  .truth = each(R"(Cramer's rule for $P=C+sD+tN$)", by_cramer),
                  .printed = each(R"($(D\cdot(P-C),N\cdot(P-C))$)", both),
                  .near_misses = {each(R"($(N\cdot(P-C),D\cdot(P-C))$)", [](P, V, double s, double t) {
                    return Value{t, s};
                  })}});
  claims.formula(
      "distance", 601, R"($t_i$ is the distance from $P_i$ to the fulcrum line.)", plates,
      {.quantity = "the distance, times $m$",
       .truth = each("twice a triangle's area over its base on the line", by_area),
       .printed = each("$t$", [](P, V, double, double t) { return t; }),
       .corrected = each("$|t|$", size_of_t),
       .in_view = {R"(for $t_i\ge0$, all particles on the side of $N$)",
                   [](const Sample& s) {
                     const Plate& p = s.beside;
                     return std::ranges::all_of(p.particles,
                                                [&](const Particle& x) { return dot(p.N, x.r - p.A) >= 0; });
                   }},
       .near_misses = {each("$|s|$", [](P, V, double s, double) { return std::abs(s); })},
       .kind = Fault::left_out,
       .root = "distance for coordinate",
       .why =
           R"($t_i=N\cdot(P_i-C)$ has a sign, a distance has none: on the side away from $N$, $t_i$ is the distance's )"
           R"(negative, and $|t_i|$ is the distance. The proof needs the sign. With distances the moment would be )"
           R"($\sum m_i|t_i|$, which is positive as soon as one particle is off the line.)"});
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

constexpr auto of_t = [](const auto& p) {
  return p.sum([&](const auto& m, const auto& r) { return m * dot(p.N, r); });
};
constexpr auto of_solved_t = [](const auto& p) {
  return p.sum([&](const auto& m, const auto& r) { return m * solved_by_cramer(p, r)[1]; });
};
constexpr auto in_coordinates = [](const auto& p) {
  return p.sum([&](const auto& m, const auto& r) { return m * (p.N[0] * r[0] + p.N[1] * r[1]); });
};
constexpr auto factored = [](const auto& p) { return dot(p.N, p.moment()); };
constexpr auto both_sums = [](const auto& p) { return std::array{p.moment()[0], p.moment()[1]}; };

void moments(Claims& claims, const std::vector<Sample>& plates, double k) {
  using P = const Plate&;
  const OfPlate torque = beside("the torque of the weights that turns the side of $N$ down",
                                [](P p) { return p.level_torque(); });
  const auto of_sums = [](Vector Plate::*by) { return [=](P p) { return dot(p.*by, p.moment()); }; };
  const auto line = [&](std::string_view slug, int number, const std::string& says, const OfPlate& printed,
                        const OfPlate& near) {
    claims.formula(slug, number, says, plates,
                   {.quantity = "the first moment about the fulcrum",
                    .truth = torque,
                    .printed = printed,
                    .near_misses = {near}});
  };
  line("first_moment", 603, R"(The first moment about the fulcrum is $M=\sum m_it_i$.)",
       beside(R"($\sum m_it_i$)", of_solved_t), beside(R"($\sum m_is_i$)", of_sums(&Plate::D)));
  line("with_normals", 605, R"($M=\sum m_iN\cdot(P_i-C)$)", beside(R"($\sum m_iN\cdot(P_i-C)$)", of_t),
       beside(R"($\sum N\cdot(P_i-C)$)",
              [](P p) { return p.sum([&](double, const Vector& r) { return dot(p.N, r); }); }));
  line("in_coordinates", 607, R"($M=\sum m_iN\cdot(x_i-\bar x,y_i-\bar y)$)",
       beside(R"($\sum m_iN\cdot(x_i-\bar x,y_i-\bar y)$)", in_coordinates),
       beside(R"(the same with $N_x$ exchanged for $N_y$)",
              [](P p) { return p.N[1] * p.moment()[0] + p.N[0] * p.moment()[1]; }));
  line("factored", 609, R"($M=N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)",
       beside(R"($N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)", factored),
       beside(R"($D\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)", of_sums(&Plate::D)));

  const auto vanishes = [&](const std::string& what, std::size_t count, const OfPlate& formula) {
    return Reading{formula.text, {compare(what, formula, zero(count), plates)}};
  };
  const std::string center = "about the center of mass", mean = "about the mean of the positions";
  const std::string sums = R"($\sum m_i(x_i-\bar x,y_i-\bar y)$)",
                    product = R"($N\cdot\sum m_i(x_i-\bar x,y_i-\bar y)$)";
  claims.add("zero", 611, R"($M=N\cdot(0,0)=0$)",
             {.printed = vanishes(product, 1, about(center, &Sample::center, factored)),
              .near_misses = {vanishes(product, 1, about(mean, &Sample::mean, factored))}});
  claims.add("sums", 615, R"($\sum m_i(x_i-\bar x,y_i-\bar y)=(0,0)$)",
             {.printed = vanishes(sums, 2, about(center, &Sample::center, both_sums)),
              .near_misses = {vanishes(sums, 2, about(mean, &Sample::mean, both_sums))}});
  const auto tilts = [](P p) {
    return Value{p.tilted_torque(-1), p.tilted_torque(-0.5), p.tilted_torque(0), p.tilted_torque(0.5),
                 p.tilted_torque(1)};
  };
  claims.add("balance", 615,
             "As the first moment is zero, the plate must balance on the fulcrum (we tilt it as well).",
             {.printed = vanishes("the torque at five tilts", 5,
                                  about("about a line through the center", &Sample::center, tilts)),
              .near_misses = {
                  vanishes("the torque at five tilts", 5, beside("about a line beside the center", tilts))}});
  const auto directions = [](P p) {
    std::vector<double> all;
    const auto step = quaternion({0, 0, 1}, pi / 16);
    for (Plate turned = p; all.size() < 32; all.push_back(turned.level_torque()))
      turned.D = step(turned.D), turned.N = step(turned.N);
    return all;
  };
  const std::string in_all = "moments about 32 lines";
  Reading regardless = vanishes(in_all, 32, about("through the center", &Sample::center, directions));
  regardless.checks.push_back(lamina_in_all_directions("through its center", k, false).checks[0]);
  claims.add(
      "regardless", 617,
      R"(This is true whatever the direction of the line, as specified by $N$ (we try a lamina as well).)",
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

namespace {

constexpr const char* sums_in_coq = R"(
From Coq Require Import List.
Import ListNotations.
Local Open Scope R_scope.

(* over particles of the mass m at (x, y), however many *)
Definition total (l : list (R * R * R)) (f : R -> R -> R -> R) : R :=
  fold_right (fun p s => match p with (m, x, y) => f m x y end + s) 0 l.

Lemma total_ext : forall l f g, (forall m x y, f m x y = g m x y) -> total l f = total l g.
Proof.
  intros l f g e. unfold total. induction l as [|[[m x] y] l h]; simpl; [reflexivity | now rewrite h, e].
Qed.
Lemma total_of_two : forall l a b f g,
  total l (fun m x y => a * f m x y + b * g m x y) = a * total l f + b * total l g.
Proof. intros. unfold total. induction l as [|[[m x] y] l h]; simpl; [|rewrite h]; ring. Qed.
)";
/// What is left of m (x - c) is the sum of m x less c times the mass.
constexpr const char* by_sums =
    "first [ apply total_ext; intros; ring\n"
    "  | rewrite <- ?total_of_two, ?Rmult_0_l, ?Rplus_0_r; first [ring | apply total_ext; intros; ring] ]";
constexpr const char* by_center = R"(
  assert (apart : forall c g, total l (fun m x y => m * (g x y - c))
      = total l (fun m x y => m * g x y) - c * total l (fun m x y => m))
    by (intros c g; rewrite (total_ext l _ (fun m x y => 1 * (m * g x y) + (- c) * m)) by (intros; ring);
        rewrite (total_of_two l 1 (- c) (fun m x y => m * g x y) (fun m x y => m)); ring);
  rewrite ?(apart a0 (fun x y => x)), ?(apart a1 (fun x y => y)), ?H, ?H0; ring)";

}  // namespace

Provables proofs() {
  const auto letter = [](const char* name) { return Shortened::letter(name); };
  PlateOf<Shortened> any;
  any.A = {letter("a0"), letter("a1"), Shortened(0.0)};
  any.D = {letter("d0"), letter("d1"), Shortened(0.0)};
  any.N = cross(std::array{Shortened(0.0), Shortened(0.0), Shortened(1.0)}, any.D);
  PlateOf<Shortened> from_origin = any;
  from_origin.A = {};
  const std::string letters = "(l : list (R * R * R)) (a0 a1 d0 d1 : R)";
  Provables proved;
  const auto prove = [&](const std::string& slug, const std::string& says, const Lemma& lemma) {
    proved.push_back({"2.9-" + slug, says, {lemma}, 0, sums_in_coq});
  };
  const std::string about_any = "it is the torque of any number of weights about any line";
  const Shortened torque = any.level_torque();
  for (const auto& [slug, M] : {std::pair("with_normals", of_t(any)),
                                {"in_coordinates", in_coordinates(any)},
                                {"factored", factored(any)}})
    prove(slug, about_any, {"printed", letters, {}, {M.expression() == torque.expression()}, by_sums});
  const std::vector<Proposition> unit{dot(any.D, any.D).expression() == 1};
  prove("first_moment", about_any,
        {"printed",
         letters,
         unit,
         {of_solved_t(any).expression() == torque.expression()},
         "apply total_ext; intros; replace (d0 * d0 - d1 * - d1) with 1 by lra; field"});
  const std::vector<Proposition> center{
      from_origin.moment()[0].expression() == (any.A[0] * any.mass()).expression(),
      from_origin.moment()[1].expression() == (any.A[1] * any.mass()).expression()};
  const std::string at_center = "it vanishes about the center of any number of masses";
  prove("zero", at_center, {"printed", letters, center, {factored(any).expression() == 0}, by_center});
  prove("sums", at_center,
        {"printed",
         letters,
         center,
         {both_sums(any)[0].expression() == 0, both_sums(any)[1].expression() == 0},
         by_center});
  prove("regardless",
        "the torque about the center of any number of masses vanishes, whatever the line's direction",
        {"printed",
         letters,
         center,
         {torque.expression() == 0},
         "replace (" + torque.expression().coq() + ") with (" + factored(any).expression().coq() +
             ")\n  by (" + by_sums + ");" + by_center});

  const Shortened tilt = letter("tilt"), tilted = any.tilted_torque(tilt);
  const Shortened by_moments = any.torque_of(1.0, {1.0, 0.0, 0.0}, tilt) * any.moment()[0] +
                               any.torque_of(1.0, {0.0, 1.0, 0.0}, tilt) * any.moment()[1];
  prove("balance", "tilted by any angle, it is without torque about any line through its center",
        {"printed",
         "(l : list (R * R * R)) (a0 a1 d0 d1 tilt : R)",
         center,
         {tilted.expression() == 0},
         "replace (" + tilted.expression().coq() + ") with (" + by_moments.expression().coq() + ")\n  by (" +
             by_sums + ");" + by_center});

  const std::array<Shortened, 3> at{letter("x"), letter("y"), Shortened(0.0)};
  const Shortened s = dot(any.D, at - any.A), t = dot(any.N, at - any.A);
  const auto of = [&](const auto& f) { return detail::recorded_value(f(any, at, s, t)); };
  const std::string of_particle = "(a0 a1 d0 d1 x y : R)", at_any = "it holds of any particle and any line";
  const std::string by_unit = "assert (unit : d1 * d1 = 1 - d0 * d0) by lra; ";
  const Lemma on_line{"printed", of_particle, unit, equal(of(off_line), {Expression(0.0)}), "ring"};
  std::vector<Proposition> solves = unit;
  solves.push_back(t.expression() == 0);
  const Lemma no_other{"no_other", of_particle, solves,
                       equal(detail::recorded_value(at), detail::recorded_value(foot(any, at))), "nsatz"};
  proved.push_back({"2.9-normal_form",
                    "the points of any line solve it, and no others do",
                    {on_line, no_other},
                    0,
                    std::string("From Coq Require Import Nsatz.\n") + sums_in_coq});
  prove(
      "coordinate_system", at_any,
      {"printed", of_particle, unit, equal(of(place), detail::recorded_value(at)), by_unit + "ring [unit]"});
  prove("decomposition", at_any,
        {"printed", of_particle, unit, equal(of(both), of(by_cramer)),
         by_unit + "replace (d0 * d0 - d1 * - d1) with 1 by lra; field"});
  const Expressions area = of(by_area);
  PlateOf<Shortened> example;
  example.D = {1.0, 0.0, 0.0}, example.N = {0.0, 1.0, 0.0};
  const std::array<Shortened, 3> behind{0.0, -1.0, 0.0};
  const Shortened distance = by_area(example, behind, Shortened(0.0), Shortened(-1.0));
  proved.push_back(
      {"2.9-distance",
       "as corrected " + at_any + "; as printed it is off at an example",
       {{"corrected", of_particle, unit, equal(of(size_of_t), area),
         by_unit + "rewrite <- sqrt_Rsqr_abs; unfold Rsqr;\n  match goal with |- sqrt ?t = sqrt ?a / 7 =>"
                   " replace a with (7 * 7 * t) by ring [unit]; rewrite (sqrt_mult_alt (7 * 7)) by lra;\n"
                   "    rewrite (sqrt_square 7) by lra; field end"},
        {"printed_differs",
         "",
         {},
         {apart(dot(example.N, behind).expression(), distance.expression(), 1.9)},
         "interval"}},
       1.9,
       sums_in_coq});
  return proved;
}

std::vector<Root> roots() {
  Plate pair;
  pair.particles = {{1, {0, 1, 0}}, {1, {0, -1, 0}}}, pair.N = {0, 1, 0};
  return {
      {"distance for coordinate",
       filled(
           "Two equal weights 1 m either side of a fulcrum balance; with distances their moment is @1 kg m "
           "for 1 kg each, and an editor calls the plate unbalanced.",
           {pair.sum([&](double m, const Vector& r) { return m * std::abs(dot(pair.N, r)); })})}};
}

}  // namespace oddity::balance

namespace oddity {

Provables proofs_2_9() { return balance::proofs(); }

}  // namespace oddity
