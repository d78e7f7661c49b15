// The claims of exercise 2.3: components checked by Cartesian dual numbers, angles by atan2 of the position.

#include "chapters/provable_claims.hpp"

#include <cmath>

#include "chapters/02_basic_concepts/03_spherical_helix/spherical_helix.hpp"
#include "chapters/02_basic_concepts/shared/limit_claims.hpp"
#include "chapters/02_basic_concepts/shared/limit_proofs.hpp"
#include "reference/text.hpp"

namespace oddity::spherical_helix {

using std::numbers::pi;

template <class T>
struct SampleOf {
  T t;
  Letters<T> table() { return {{"t", t}}; }
  TypesetIn<T> typeset() const {
    const AtOf<T> k(t);
    const T s = sin(k.phi[0]), c = cos(k.phi[0]);
    const Vector<T> P{-sin(t), cos(t), T(0.0)}, R{cos(t) * s, sin(t) * s, c}, Q = cross(R, P);
    return {{R"(\dot t)", T(1.0)},      {"u", k.m.r[2]},
            {R"(\phi)", k.phi[0]},      {R"(\dot\phi)", k.phi[1]},
            {R"(\ddot\phi)", k.phi[2]}, {R"(\mathbf v)", k.m.v.e},
            {R"(\mathbf P)", P.e},      {R"(\mathbf Q)", Q.e},
            {R"(\mathbf R)", R.e},      {R"(\mathbf R(\theta,\phi))", R.e}};
  }
  std::string where() const { return "$t$ = " + format_shortest(t); }
};
using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;
using OfTime = ProvableFormula<SampleOf>;

namespace {

/// A formula in the quantities at a time; `terms` are those that cancel for any time.
template <class Of>
OfTime at(std::string text, const Of& of, double (*terms)(const At&) = nullptr) {
  OfTime formula(std::move(text), [=]<class T>(const SampleOf<T>& s) { return of(AtOf<T>(s.t)); });
  if (terms) formula.terms = [=](const Sample& s) { return terms(At(s.t)); };
  return formula;
}
double unity(const At&) { return 4; }
double steepness(const At& k) { return sqrt(k.d); }
double of_velocity(const At& k) { return 1 + k.speed; }
double of_acceleration(const At& k) { return 1 + k.pull; }

template <class T>
T slope_of_acos(const T& u) {
  const Dual<T> x(u, T(1.0));
  return atan2(sqrt(Dual<T>(1.0) - x * x), x).slope;
}

void angles(Table& table, const std::vector<Sample>& all) {
  const auto by_angles = [](const auto& of, double (*terms)(const At&) = unity) {
    return at("atan2 of the position, in dual numbers", of, terms);
  };
  const auto claim = table.over(all);
  claim("on_the_sphere", 191, R"($\rho=1$ for all $t$)",
        at("the unit sphere", [](const auto&) { return 1.0; }), R"($|(\cos t,\sin t,t)|/\sqrt{1+t^2}$)",
        R"($\rho$)");
  claim(
      "spherical_coordinates", 193,
      R"($x=\cos\theta\sin\phi$, $y=\sin\theta\sin\phi$, $z=\cos\phi$, with $x=\cos t\,\sqrt{1+t^2}$, )"
      R"($y=\sin t\,\sqrt{1+t^2}$, $z=t\,\sqrt{1+t^2}$)",
      {.quantity = R"($(x,y,z)$)",
       .truth = at(R"(the products, $\theta$ and $\phi$ being atan2 of the position)",
                   [](const auto& k) {
                     const auto s = sin(k.phi[0]);
                     return values(cos(k.theta[0]) * s, sin(k.theta[0]) * s, cos(k.phi[0]));
                   },
                   unity),
       .printed = R"($(\cos t,\sin t,t)\,\sqrt{1+t^2}$)",
       .meant = R"($(\cos t,\sin t,t)/\sqrt{1+t^2}$)",
       .why = filled(
           R"(The bars above the roots are lost in the text at hand: $x=\cos t/\sqrt{1+t^2}$. As products they )"
           R"(leave the sphere: at $t=1$, $|(x,y,z)|$ is @1.)",
           {sqrt(2.0) * hypot(cos(1.0), sin(1.0), 1.0)})});
  claim.equation("sine_of_phi", 201, R"($\sin\phi=1/\sqrt{1+t^2}$)",
                 by_angles([](const auto& k) { return sin(k.phi[0]); }));
  claim("theta", 201, R"($\cos\theta=\cos t$ and $\sin\theta=\sin t$, so that $\theta=t$ may be chosen)",
        by_angles([](const auto& k) { return values(cos(k.theta[0]), sin(k.theta[0])); }),
        R"($(\cos t,\sin t)$)", R"($(\cos\theta,\sin\theta)$)");
  claim.lost("phi", 205, R"($\phi=\cos^{-1}(t\,\sqrt{1+t^2})$, in $[0,\pi]$)",
             by_angles([](const auto& k) { return k.phi[0]; }, steepness),
             R"($\phi=\cos^{-1}(t/\sqrt{1+t^2})$)",
             filled(R"(The bar is lost in the text at hand: $\phi=\cos^{-1}(t/\sqrt{1+t^2})$. As a product, )"
                    R"($t\sqrt{1+t^2}$, it is above 1 from $t=@2$ on, and no cosine.)",
                    {sqrt((sqrt(5.0) - 1) / 2)}));
  claim("rates_of_rho_and_theta", 209, R"($\dot\rho=\ddot\rho=0$, $\dot\theta=1$, $\ddot\theta=0$)",
        by_angles([](const auto& k) { return values(k.rho[1], k.rho[2], k.theta[1], k.theta[2]); }),
        "$(0,0,1,0)$", R"($(\dot\rho,\ddot\rho,\dot\theta,\ddot\theta)$)");
  claim("derivative_of_acos", 211, R"($\frac{d}{du}\cos^{-1}u=-1\,\sqrt{1-u^2}$)",
        {.quantity = R"(the slope of $\cos^{-1}$ at $u=z$)",
         .truth = at(R"(atan2 of $\sqrt{1-u^2}$ and $u$ in dual numbers)",
                     [](const auto& k) { return slope_of_acos(k.m.r[2]); },
                     [](const auto& k) { return k.d * sqrt(k.d); }),
         .printed = R"($-\sqrt{1-u^2}$)",
         .meant = R"($-1/\sqrt{1-u^2}$)",
         .why =
             filled(R"(The bar is lost in the text at hand: $-1/\sqrt{1-u^2}$. At $u=0.6$ that is $@3$, the )"
                    R"(product $@1$.)",
                    {slope_of_acos(0.6), -sqrt(1 - 0.6 * 0.6)})});
  claim("derivative_of_z", 219, R"($z=t\,\sqrt{1+t^2}$ has $\dot z=(1+t^2)^{-3/2}$)",
        {.quantity = R"($\dot z-(1+t^2)^{-3/2}$)",
         .truth = at("zero", [](const auto&) { return 0.0; }),
         .printed = R"($\frac{d}{dt}(t\,\sqrt{1+t^2})=(1+t^2)^{-3/2}$)",
         .meant = R"($\frac{d}{dt}(t/\sqrt{1+t^2})=(1+t^2)^{-3/2}$)",
         .why = filled(
             R"(The bar is lost in the text at hand: $z=t/\sqrt{1+t^2}$. The derivative of the product is )"
             R"($(1+2t^2)/\sqrt{1+t^2}$, @3 at $t=1$ for @3.)",
             {3 / sqrt(2.0), pow(2.0, -1.5)})});
  const OfTime phi_dot = by_angles([](const auto& k) { return k.phi[1]; });
  claim.lost(
      "chain_rule", 229, R"($\dot\phi=-1\,\sqrt{1-t^2/(1+t^2)}\,(1+t^2)^{-3/2}$ by the chain rule)", phi_dot,
      R"($\dot\phi=-(1+t^2)^{-3/2}/\sqrt{1-t^2/(1+t^2)}$)",
      filled(
          R"(The bar above the root is lost in the text at hand; the root divides. At $t=1$ the quotient is )"
          R"($@1$, the product $@2$.)",
          {-pow(2.0, -1.5) / sqrt(0.5), -pow(2.0, -1.5) * sqrt(0.5)}));
  claim.equation("phi_dot", 229, R"($\dot\phi=-1/(1+t^2)$)", phi_dot);
  claim.equation("phi_double_dot", 251, R"($\ddot\phi=2t/(1+t^2)^2$)",
                 by_angles([](const auto& k) { return k.phi[2]; }));
  claim.equation("position", 257, R"($\mathbf r=\mathbf R(\theta,\phi)$)",
                 at(
                     "the position", [](const auto& k) { return k.m.r; }, steepness));
}

/// A component along P, Q or R.
OfTime part_of_velocity(std::size_t i) {
  return at(
      "Cartesian dual numbers on the frame", [=](const auto& k) { return k.v[i]; }, of_velocity);
}
OfTime part_of_acceleration(std::size_t i) {
  return at(
      "Cartesian dual numbers on the frame", [=](const auto& k) { return k.a[i]; }, of_acceleration);
}

void velocity_and_acceleration(Table& table, const std::vector<Sample>& all) {
  const std::string cartesian = "Cartesian dual numbers";
  const OfTime velocity = at(
      cartesian, [](const auto& k) { return k.m.v; }, of_velocity);
  const auto claim = table.over(all);
  claim.equation("velocity_formula", 261, R"($\mathbf v=\sin\phi\,\mathbf P-\dot\phi\,\mathbf Q$)", velocity);
  claim(
      "velocity_p", 261, R"($\mathbf v$ has the component $1\,\sqrt{1+t^2}$ along $\mathbf P$.)",
      {.quantity = R"($\mathbf v\cdot\mathbf P$)",
       .truth = part_of_velocity(0),
       .printed = R"($\sqrt{1+t^2}$)",
       .meant = R"($1/\sqrt{1+t^2}$)",
       .why = filled(
           R"(The bar above the root is lost in the text at hand: $\mathbf P/\sqrt{1+t^2}$. As printed the speed )"
           R"(grows with $t$: at $t=10$ the helix moves at @2, and the product is @2.)",
           {At(10.0).speed, sqrt(101.0)})});
  claim(
      "velocity_q", 261, R"($\mathbf v$ has the component $-1/(1+t^2)$ along $\mathbf Q$.)",
      {.quantity = R"($\mathbf v\cdot\mathbf Q$)",
       .truth = part_of_velocity(1),
       .printed = R"($-1/(1+t^2)$)",
       .corrected = R"($+1/(1+t^2)$)",
       .root = R"(sign of the velocity along $\mathbf Q$)",
       .why = filled(
           R"(The step before is right, $\mathbf v=\sin\phi\,\mathbf P-\dot\phi\,\mathbf Q$, but )"
           R"($\dot\phi=-1/(1+t^2)$ is negative: $\mathbf v=\mathbf P/\sqrt{1+t^2}+\mathbf Q/(1+t^2)$. At $t=0$ )"
           R"(the helix rises with $\dot z=@1$ and $\mathbf Q=\mathbf k$; the printed velocity falls.)",
           {At(0.0).m.v[2]})});
  claim("velocity_r", 261, R"($\mathbf v$ has no component along $\mathbf R$.)", velocity,
        R"($(\mathbf v\cdot\mathbf P)\mathbf P+(\mathbf v\cdot\mathbf Q)\mathbf Q$)",
        R"($\mathbf v$, by its parts along $\mathbf P$ and $\mathbf Q$)");
  claim.equation(
      "acceleration_formula", 277,
      R"($\mathbf a=2\dot\phi\cos\phi\,\mathbf P+(\sin\phi\cos\phi-\ddot\phi)\mathbf Q-(\dot\phi^2+\sin^2\phi)\mathbf R$)",
      at(
          cartesian, [](const auto& k) { return k.m.a; }, of_acceleration));
  claim("acceleration_p", 277, R"($\mathbf a$ has the component $-2t/(1+t^2)^{3/2}$ along $\mathbf P$.)",
        part_of_acceleration(0), R"($-2t/(1+t^2)^{3/2}$)", R"($\mathbf a\cdot\mathbf P$)");
  claim(
      "acceleration_q", 277, R"($\mathbf a$ has the component $-t/(1+t^2)$ along $\mathbf Q$.)",
      {.quantity = R"($\mathbf a\cdot\mathbf Q$)",
       .truth = part_of_acceleration(1),
       .printed = R"($-t/(1+t^2)$)",
       .corrected = R"($t(t^2-1)/(1+t^2)^2$)",
       .root = R"(square forgotten in $\ddot\phi$)",
       .why = filled(
           R"($\sin\phi\cos\phi-\ddot\phi=t/(1+t^2)-2t/(1+t^2)^2=t(t^2-1)/(1+t^2)^2$; the printed value forgets the )"
           R"(square in $\ddot\phi$. At $t=2$ it is $@2$, not $@1$; for $|t|>1$ even the sign is wrong.)",
           {At(2.0).a[1], -2 / 5.0})});
  claim("acceleration_r", 277, R"($\mathbf a$ has the component $-(2+t^2)/(1+t^2)^2$ along $\mathbf R$.)",
        part_of_acceleration(2), R"($-(2+t^2)/(1+t^2)^2$)", R"($\mathbf a\cdot\mathbf R$)");
  claim.equation("distance_from_axis", 285, R"($x^2+y^2=1/(1+t^2)$)",
                 at("the position", [](const auto& k) { return k.m.r[0] * k.m.r[0] + k.m.r[1] * k.m.r[1]; }));
}

/// `later` has only times above zero.
void height(Table& table, const std::vector<Sample>& later) {
  const std::string others = R"(,\ \sqrt{t^2/(1+t^2)},\ \sqrt{1-1/(1+t^2)})$)";
  table.over(later)(
      "height_rewritten", 287,
      R"($t\,\sqrt{1+t^2}=\sqrt{t^2/(1+t^2)}=\sqrt{1-1/(1+t^2)}$ on the way to infinity)",
      {.quantity = "$z$, for $t>0$",
       .truth = at(
           "the position", [](const auto& k) { return k.m.r[2]; },
           [](const At& k) { return sqrt(k.d) / std::abs(k.t); }),
       .printed = R"($(t\,\sqrt{1+t^2})" + others,
       .meant = R"($(t/\sqrt{1+t^2})" + others,
       .why = filled(
           R"(The bar above the first root is lost in the text at hand: $t/\sqrt{1+t^2}$, whose square is )"
           R"(under the next root. The product has no limit; at $t=10$ it is @3, and the quotient @3.)",
           {10 * sqrt(101.0), 10 / sqrt(101.0)})});
}

// ---- where it ends ----------------------------------------------------------------------------------------

constexpr int turns = 50;

/// Checks that `size` grows in no step of the helix, and the angle turned about the axis.
template <class F>
std::vector<Check> spiral(const std::string& what, double turned, const F& size) {
  constexpr int steps = 40 * turns;
  long growing = 0;
  double angle = 0;
  for (int i = 1; i <= steps; ++i) {
    const Vector3 a = helix(1 + 2 * pi * turns * (i - 1) / steps), b = helix(1 + 2 * pi * turns * i / steps);
    growing += !(size(b) < size(a));
    angle += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }
  return {no_violations("steps in which the " + what + " grows", growing, steps),
          {R"(the angle turned from $t=1$ to $t=1+100\pi$)",
           {R"(a turn in $2\pi$)", turned},
           {"sum of angles between positions", angle},
           rounding(2 * pi * turns, steps)}};
}

constexpr auto from_axis = [](const auto& r) { return distance_from_axis(r); };
constexpr auto z = [](const auto& r) { return r[2]; };

void ends(Claims& claims) {
  const auto from_pole = [](const Vector3& r) { return length(r - pole); };
  const auto at_end = [&](std::string_view slug, int line, const std::string& says, const std::string& what,
                          const std::string& text, const auto& f) {
    limits::tends(claims, slug, line, says, what,
                  {{R"($t\to\infty$)", 0.5, [&](double s) { return f(Vector3(helix(1 / s))); }}}, text);
  };
  at_end("distance_vanishes", 285, R"(As $t$ becomes infinite, the distance from the axis goes to zero.)",
         R"($d=\sqrt{x^2+y^2}$)", R"($d\to0$)", from_axis);
  claims.add(
      "spiral_in_the_plane", 285,
      filled("In the $xy$-plane the path is a spiral into the origin (our check: over @2 turns).", {turns}),
      {.printed = {"the distance from the axis shrinks, turning on",
                   spiral("distance from the axis", 100 * pi, from_axis)},
       .near_misses = {{"turning the other way", spiral("distance from the axis", -100 * pi, from_axis)},
                       {R"($z$ shrinks)", spiral("height", 100 * pi, z)}}});
  at_end("height_limit", 287, R"($z$ tends to 1 as $t$ becomes infinite.)", "$z$", R"($z\to1$)", z);
  const std::string to_pole = "distance from the pole";
  claims.add("spiral_to_the_pole", 311,
             filled("On the sphere the helix spirals about $(0,0,1)$ (our check: over @2 turns).", {turns}),
             {.printed = {"nearer and nearer to the pole, turning on", spiral(to_pole, 100 * pi, from_pole)},
              .near_misses = {{"turning the other way", spiral(to_pole, -100 * pi, from_pole)},
                              {"nearer and nearer to the other pole",
                               spiral("distance from the other pole", 100 * pi,
                                      [](const Vector3& r) { return length(r + pole); })}}});
  at_end("pole_in_the_limit", 311, R"(The helix tends to $(0,0,1)$ as $t$ becomes infinite.)",
         "$d$, the distance from the pole", R"($d\to0$)", from_pole);
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{{0.75}, {-0.75}, {0}, {50}, {-50}};
  for (int i = 0; i < 200; ++i) all.push_back({i % 2 ? random.between(-50, 50) : random.magnitude(1e-3, 50)});
  std::vector<Sample> later = all;
  std::erase_if(later, [](const Sample& s) { return s.t <= 0; });
  Claims claims("2.3");
  Table table(claims);
  angles(table, all);
  velocity_and_acceleration(table, all);
  height(table, later);
  ends(claims);
  return claims.in_order();
}

std::vector<Root> roots() {
  const At start(0.0);
  return {
      {R"(sign of the velocity along $\mathbf Q$)",
       filled("At $t=0$ a model of the point sinks at speed @1 where the point itself climbs at speed @1.",
              {in_frame(start.m.r, Vector3{0, 0, 1})[1] / start.d, start.m.v[2]})},
      {R"(square forgotten in $\ddot\phi$)",
       filled(R"(A table then lists the northward acceleration at $t=2$ as $@1$; it is $@2$.)",
              {-2 / 5.0, At(2.0).a[1]})}};
}

Provables proofs_of_limits() {
  const Vector<Shortened> r = helix(Shortened::letter("t"));
  const auto tends = [](const char* name, const Shortened& f, const Shortened& limit) {
    return Lemma{.name = name,
                 .follows = {tends_at_infinity(f.expression(), limit.expression())},
                 .tactic = "by_distance"};
  };
  return {{"2.3-distance_vanishes", "the limit is 0", {tends("printed", from_axis(r), 0)}},
          {"2.3-height_limit", "the limit is 1", {tends("printed", z(r), 1)}},
          {"2.3-pole_in_the_limit",
           "the distance from the axis tends to 0, and the height to 1",
           {tends("distance", from_axis(r), 0), tends("height", z(r), 1)}}};
}

Provables proofs() {
  Claims claims("2.3");
  Table table(claims), above_zero(claims);
  angles(table, {});
  velocity_and_acceleration(table, {});
  height(above_zero, {});
  auto all = for_all<SampleOf>({"t"}, "by_helix t", "it holds at all times", {0.5});
  all.bounds = "by_bounds";
  Provables proved = table.proofs("2.3", all);
  all.given = positive({all.any.t});
  all.says += " above zero";
  append(proved, above_zero.proofs("2.3", all));
  append(proved, proofs_of_limits());
  for (Provable& p : proved) p.preamble = coq_source({"helix"});
  return proved;
}

}  // namespace oddity::spherical_helix
