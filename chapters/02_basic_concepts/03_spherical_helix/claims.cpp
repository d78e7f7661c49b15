// The claims of exercise 2.3: components against Cartesian dual numbers, angles against atan2 of the
// position.

#include "chapters/claims.hpp"

#include <cmath>

#include "chapters/02_basic_concepts/03_spherical_helix/spherical_helix.hpp"
#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "reference/text.hpp"

namespace oddity::spherical_helix {

namespace {

using std::numbers::pi;

struct Sample {
  double t;
  std::array<double*, 1> letters() { return {&t}; }
  std::string where() const { return "$t$ = " + format_shortest(t); }
};
using OfTime = Formula<Sample>;

/// A formula in what is known at a time; `terms` are those that cancel whatever the time is.
template <class Of>
OfTime at(std::string text, const Of& of, double (*terms)(const At&) = nullptr) {
  OfTime formula{std::move(text), [=](const Sample& s) -> Value { return of(At(s.t)); }};
  if (terms) formula.terms = [=](const Sample& s) { return terms(At(s.t)); };
  return formula;
}
double unity(const At&) { return 4; }
double steepness(const At& k) { return sqrt(k.d); }
double of_velocity(const At& k) { return 1 + k.speed; }
double of_acceleration(const At& k) { return 1 + k.pull; }

/// Spherical coordinates as a position.
Vector3 at_angles(double theta, double phi) {
  return {cos(theta) * sin(phi), sin(theta) * sin(phi), cos(phi)};
}
/// P, Q and R of the angles, weighted.
Vector3 of_angles(double theta, double phi, const Vector3& x) {
  const Vector3 P{-sin(theta), cos(theta), 0}, R = at_angles(theta, phi);
  return x[0] * P + x[1] * cross(R, P) + x[2] * R;
}
double slope_of_acos(double u) {
  const Dual<double> x(u, 1);
  return atan2(sqrt(Dual<double>(1) - x * x), x).slope;
}

void angles(Claims& claims, const std::vector<Sample>& all) {
  const std::string by_angles = "atan2 of the position, in dual numbers";
  const auto length = [](double power) {
    return [=](const At& k) { return hypot(cos(k.t), sin(k.t), k.t) * pow(k.d, power); };
  };
  claims.formula("on_the_sphere", 191, R"($\rho=1$ for all $t$)", all,
                 {.quantity = R"($\rho$)",
                  .truth = at("the unit sphere", [](const At&) { return 1.0; }),
                  .printed = at(R"($|(\cos t,\sin t,t)|/\sqrt{1+t^2}$)", length(-0.5)),
                  .near_misses = {at(R"($|(\cos t,\sin t,t)|/(1+t^2)$)", length(-1))}});
  const auto given = [](double power) {
    return [=](const At& k) { return pow(k.d, power) * Vector3{cos(k.t), sin(k.t), k.t}; };
  };
  claims.formula(
      "spherical_coordinates", 193,
      R"($x=\cos\theta\sin\phi$, $y=\sin\theta\sin\phi$, $z=\cos\phi$, with $x=\cos t\,\sqrt{1+t^2}$, )"
      R"($y=\sin t\,\sqrt{1+t^2}$, $z=t\,\sqrt{1+t^2}$)",
      all,
      {.quantity = R"($(x,y,z)$)",
       .truth = at(R"(the products, $\theta$ and $\phi$ being atan2 of the position)",
                   [](const At& k) { return at_angles(k.theta[0], k.phi[0]); }, unity),
       .printed = at(R"($(\cos t,\sin t,t)\,\sqrt{1+t^2}$)", given(0.5)),
       .meant = at(R"($(\cos t,\sin t,t)/\sqrt{1+t^2}$)", given(-0.5)),
       .near_misses = {at(R"($(-\cos t,-\sin t,t)/\sqrt{1+t^2}$)",
                          [](const At& k) {
                            return pow(k.d, -0.5) * Vector3{-cos(k.t), -sin(k.t), k.t};
                          })},
       .kind = Fault::lost_typography,
       .why =
           R"(The bars above the roots are lost in the text at hand: $x=\cos t/\sqrt{1+t^2}$. As products they )"
           R"(leave the sphere: at $t=1$, $|(x,y,z)|$ is 2.)"});
  claims.formula("sine_of_phi", 201, R"($\sin\phi=1/\sqrt{1+t^2}$, positive)", all,
                 {.quantity = R"($\sin\phi$)",
                  .truth = at(
                      by_angles, [](const At& k) { return sin(k.phi[0]); }, unity),
                  .printed = at(R"($1/\sqrt{1+t^2}$)", [](const At& k) { return 1 / sqrt(k.d); }),
                  .near_misses = {at(R"($-1/\sqrt{1+t^2}$)", [](const At& k) { return -1 / sqrt(k.d); })}});
  const auto turned = [](double sign) {
    return [=](const At& k) { return values(cos(k.t), sin(sign * k.t)); };
  };
  claims.formula("theta", 201, R"($\cos\theta=\cos t$ and $\sin\theta=\sin t$: $\theta=t$)", all,
                 {.quantity = R"($(\cos\theta,\sin\theta)$)",
                  .truth = at(
                      by_angles, [](const At& k) { return values(cos(k.theta[0]), sin(k.theta[0])); }, unity),
                  .printed = at(R"($(\cos t,\sin t)$)", turned(1)),
                  .near_misses = {at(R"($(\cos t,-\sin t)$)", turned(-1))}});
  const auto phi = [](double sign) { return [=](const At& k) { return sign * std::acos(k.t / sqrt(k.d)); }; };
  claims.formula(
      "phi", 205, R"($\phi=\cos^{-1}(t\,\sqrt{1+t^2})$, in $[0,\pi]$)", all,
      {.quantity = R"($\phi$)",
       .truth = at(
           by_angles, [](const At& k) { return k.phi[0]; }, steepness),
       .printed =
           at(R"($\cos^{-1}(t\,\sqrt{1+t^2})$)", [](const At& k) { return std::acos(k.t * sqrt(k.d)); }),
       .meant = at(R"($\cos^{-1}(t/\sqrt{1+t^2})$)", phi(1)),
       .near_misses = {at(R"($-\cos^{-1}(t/\sqrt{1+t^2})$)", phi(-1))},
       .kind = Fault::lost_typography,
       .why = R"(The bar is lost in the text at hand: $\phi=\cos^{-1}(t/\sqrt{1+t^2})$. As a product, )"
              R"($t\sqrt{1+t^2}$, it is above 1 from $t=0.79$ on, and no cosine.)"});
  const auto rates = [](double sign) { return [=](const At&) { return values(0, 0, sign, 0); }; };
  claims.formula(
      "rates_of_rho_and_theta", 209, R"($\dot\rho=\ddot\rho=0$, $\dot\theta=1$, $\ddot\theta=0$)", all,
      {.quantity = R"($(\dot\rho,\ddot\rho,\dot\theta,\ddot\theta)$)",
       .truth = at(
           by_angles, [](const At& k) { return values(k.rho[1], k.rho[2], k.theta[1], k.theta[2]); }, unity),
       .printed = at(R"($(0,0,1,0)$)", rates(1)),
       .near_misses = {at(R"($(0,0,-1,0)$)", rates(-1))}});
  const auto by_root = [](double sign, double power) {
    return [=](const At& k) { return sign * pow((1 - k.m.r[2]) * (1 + k.m.r[2]), power); };
  };
  claims.formula(
      "derivative_of_acos", 211, R"($\frac{d}{du}\cos^{-1}u=-1\,\sqrt{1-u^2}$)", all,
      {.quantity = R"(the slope of $\cos^{-1}$ at $u=z$)",
       .truth = at(R"(atan2 of $\sqrt{1-u^2}$ and $u$ in dual numbers)",
                   [](const At& k) { return slope_of_acos(k.m.r[2]); },
                   [](const At& k) { return k.d * sqrt(k.d); }),
       .printed = at(R"($-\sqrt{1-u^2}$)", by_root(-1, 0.5)),
       .meant = at(R"($-1/\sqrt{1-u^2}$)", by_root(-1, -0.5)),
       .near_misses = {at(R"($+1/\sqrt{1-u^2}$)", by_root(1, -0.5))},
       .kind = Fault::lost_typography,
       .why =
           R"(The bar is lost in the text at hand: $-1/\sqrt{1-u^2}$. At $u=0.6$ that is $-1.25$, the product )"
           R"($-0.8$.)"});
  const auto power = [](double n) { return [=](const At& k) { return pow(k.d, n); }; };
  claims.formula(
      "derivative_of_z", 219, R"($z=t\,\sqrt{1+t^2}$ has $\dot z=(1+t^2)^{-3/2}$)", all,
      {.quantity = R"($\dot z-(1+t^2)^{-3/2}$)",
       .truth = {"zero", [](const Sample&) { return Value(0.0); }},
       .printed = at(R"($t\,\sqrt{1+t^2}$ in dual numbers)",
                     [](const At& k) {
                       const Dual<double> t(k.t, 1);
                       return (t * sqrt(Dual<double>(1) + t * t)).slope - pow(k.d, -1.5);
                     }),
       .meant =
           at(R"($t/\sqrt{1+t^2}$ in dual numbers)", [](const At& k) { return k.m.v[2] - pow(k.d, -1.5); },
              [](const At& k) { return 1 / sqrt(k.d); }),
       .near_misses = {at(R"($t/\sqrt{1+t^2}$ in dual numbers, with $(1+t^2)^{-1/2}$)",
                          [=](const At& k) { return k.m.v[2] - power(-0.5)(k); })},
       .kind = Fault::lost_typography,
       .why = R"(The bar is lost in the text at hand: $z=t/\sqrt{1+t^2}$. The derivative of the product is )"
              R"($(1+2t^2)/\sqrt{1+t^2}$, 2.12 at $t=1$ for 0.354.)"});
  const auto chain = [](double sign, double root) {
    return [=](const At& k) { return sign * pow(1 - k.t * k.t / k.d, root) * pow(k.d, -1.5); };
  };
  const auto phi_dot = at(
      by_angles, [](const At& k) { return k.phi[1]; }, unity);
  claims.formula(
      "chain_rule", 229, R"($\dot\phi=-1\,\sqrt{1-t^2/(1+t^2)}\,(1+t^2)^{-3/2}$ by the chain rule)", all,
      {.quantity = R"($\dot\phi$)",
       .truth = phi_dot,
       .printed = at(R"($-\sqrt{1-t^2/(1+t^2)}\,(1+t^2)^{-3/2}$)", chain(-1, 0.5)),
       .meant = at(R"($-(1+t^2)^{-3/2}/\sqrt{1-t^2/(1+t^2)}$)", chain(-1, -0.5)),
       .near_misses = {at(R"($+(1+t^2)^{-3/2}/\sqrt{1-t^2/(1+t^2)}$)", chain(1, -0.5))},
       .kind = Fault::lost_typography,
       .why =
           R"(The bar above the root is lost in the text at hand; the root divides. At $t=1$ the quotient is )"
           R"($-\tfrac12$, the product $-\tfrac14$.)"});
  claims.formula("phi_dot", 229, R"($\dot\phi=-1/(1+t^2)$)", all,
                 {.quantity = R"($\dot\phi$)",
                  .truth = phi_dot,
                  .printed = at(R"($-1/(1+t^2)$)", [](const At& k) { return -1 / k.d; }),
                  .near_misses = {at(R"($+1/(1+t^2)$)", [](const At& k) { return 1 / k.d; })}});
  const auto bent = [](double n) { return [=](const At& k) { return 2 * k.t / pow(k.d, n); }; };
  claims.formula("phi_double_dot", 251, R"($\ddot\phi=2t/(1+t^2)^2$)", all,
                 {.quantity = R"($\ddot\phi$)",
                  .truth = at(
                      by_angles, [](const At& k) { return k.phi[2]; }, unity),
                  .printed = at(R"($2t/(1+t^2)^2$)", bent(2)),
                  .near_misses = {at(R"($2t/(1+t^2)$)", bent(1))}});
  const auto position = [=](double sign) {
    return [=](const At& k) { return of_angles(k.t, phi(1)(k), {0, 0, sign}); };
  };
  claims.formula("position", 257, R"($\mathbf r=\mathbf R(\theta,\phi)$)", all,
                 {.quantity = R"($\mathbf r$)",
                  .truth = at(
                      "the position", [](const At& k) { return k.m.r; }, steepness),
                  .printed = at(R"($\mathbf R(\theta,\phi)$)", position(1)),
                  .near_misses = {at(R"($-\mathbf R(\theta,\phi)$)", position(-1))}});
}

/// A component along P, Q or R.
OfTime part_of_velocity(std::size_t i) {
  return at(
      "Cartesian dual numbers on the frame", [=](const At& k) { return k.v[i]; }, of_velocity);
}
OfTime part_of_acceleration(std::size_t i) {
  return at(
      "Cartesian dual numbers on the frame", [=](const At& k) { return k.a[i]; }, of_acceleration);
}

void velocity_and_acceleration(Claims& claims, const std::vector<Sample>& all) {
  const auto velocity = [](double sign) {
    return [=](const At& k) { return of_angles(k.theta[0], k.phi[0], {sin(k.phi[0]), sign * k.phi[1], 0}); };
  };
  const auto cartesian_v = at(
      "Cartesian dual numbers", [](const At& k) { return k.m.v; }, of_velocity);
  claims.formula("velocity_formula", 261, R"($\mathbf v=\sin\phi\,\mathbf P-\dot\phi\,\mathbf Q$)", all,
                 {.quantity = R"($\mathbf v$)",
                  .truth = cartesian_v,
                  .printed = at(R"($\sin\phi\,\mathbf P-\dot\phi\,\mathbf Q$)", velocity(-1)),
                  .near_misses = {at(R"($\sin\phi\,\mathbf P+\dot\phi\,\mathbf Q$)", velocity(1))}});
  const auto power = [](double sign, double n) { return [=](const At& k) { return sign * pow(k.d, n); }; };
  claims.formula(
      "velocity_p", 261, R"($\mathbf v$ has the component $1\,\sqrt{1+t^2}$ along $\mathbf P$)", all,
      {.quantity = R"($\mathbf v\cdot\mathbf P$)",
       .truth = part_of_velocity(0),
       .printed = at(R"($\sqrt{1+t^2}$)", power(1, 0.5)),
       .meant = at(R"($1/\sqrt{1+t^2}$)", power(1, -0.5)),
       .near_misses = {at(R"($1/(1+t^2)$)", power(1, -1))},
       .kind = Fault::lost_typography,
       .why =
           R"(The bar above the root is lost in the text at hand: $\mathbf P/\sqrt{1+t^2}$. As it stands the speed )"
           R"(grows with $t$; at $t=10$ the helix moves at 0.1, and the product says 10.)"});
  claims.formula(
      "velocity_q", 261, R"($\mathbf v$ has the component $-1/(1+t^2)$ along $\mathbf Q$)", all,
      {.quantity = R"($\mathbf v\cdot\mathbf Q$)",
       .truth = part_of_velocity(1),
       .printed = at(R"($-1/(1+t^2)$)", power(-1, -1)),
       .corrected = at(R"($+1/(1+t^2)$)", power(1, -1)),
       .near_misses = {at(R"($+1/(1+t^2)^{3/2}$)", power(1, -1.5))},
       .kind = Fault::formula,
       .root = R"(sign of the velocity along $\mathbf Q$)",
       .why =
           R"(The step before is right, $\mathbf v=\sin\phi\,\mathbf P-\dot\phi\,\mathbf Q$, but )"
           R"($\dot\phi=-1/(1+t^2)$ is negative: $\mathbf v=\mathbf P/\sqrt{1+t^2}+\mathbf Q/(1+t^2)$. At $t=0$ )"
           R"(the helix rises with $\dot z=1$ and $\mathbf Q=\mathbf k$; the printed velocity falls.)"});
  const auto along_R = [](double part) {
    return [=](const At& k) { return of_angles(k.theta[0], k.phi[0], {k.v[0], k.v[1], part}); };
  };
  claims.formula("velocity_r", 261, R"($\mathbf v$ has no component along $\mathbf R$)", all,
                 {.quantity = R"($\mathbf v$)",
                  .truth = cartesian_v,
                  .printed = at(R"(its parts along $\mathbf P$ and $\mathbf Q$)", along_R(0)),
                  .near_misses = {at(R"(these and $\mathbf R$)", along_R(1))}});
  const auto acceleration = [](double sign) {
    return [=](const At& k) {
      const double s = sin(k.phi[0]), c = cos(k.phi[0]), w = k.phi[1];
      return of_angles(k.theta[0], k.phi[0], {2 * w * c, s * c + sign * k.phi[2], -(w * w + s * s)});
    };
  };
  claims.formula(
      "acceleration_formula", 277,
      R"($\mathbf a=2\dot\phi\cos\phi\,\mathbf P+(\sin\phi\cos\phi-\ddot\phi)\mathbf Q-(\dot\phi^2+\sin^2\phi)\mathbf R$)",
      all,
      {.quantity = R"($\mathbf a$)",
       .truth = at(
           "Cartesian dual numbers", [](const At& k) { return k.m.a; }, of_acceleration),
       .printed = at("this sum", acceleration(-1)),
       .near_misses = {at(R"(this sum with $+\ddot\phi$)", acceleration(1))}});
  const auto falling = [](double n) { return [=](const At& k) { return -2 * k.t / pow(k.d, n); }; };
  claims.formula("acceleration_p", 277,
                 R"($\mathbf a$ has the component $-2t/(1+t^2)^{3/2}$ along $\mathbf P$)", all,
                 {.quantity = R"($\mathbf a\cdot\mathbf P$)",
                  .truth = part_of_acceleration(0),
                  .printed = at(R"($-2t/(1+t^2)^{3/2}$)", falling(1.5)),
                  .near_misses = {at(R"($-2t/(1+t^2)^2$)", falling(2))}});
  const auto along_Q = [](double one) {
    return [=](const At& k) { return k.t * (k.t * k.t + one) / (k.d * k.d); };
  };
  claims.formula(
      "acceleration_q", 277, R"($\mathbf a$ has the component $-t/(1+t^2)$ along $\mathbf Q$)", all,
      {.quantity = R"($\mathbf a\cdot\mathbf Q$)",
       .truth = part_of_acceleration(1),
       .printed = at(R"($-t/(1+t^2)$)", [](const At& k) { return -k.t / k.d; }),
       .corrected = at(R"($t(t^2-1)/(1+t^2)^2$)", along_Q(-1)),
       .near_misses = {at(R"($t(t^2+1)/(1+t^2)^2$)", along_Q(1))},
       .kind = Fault::formula,
       .root = R"(square forgotten in $\ddot\phi$)",
       .why =
           R"($\sin\phi\cos\phi-\ddot\phi=t/(1+t^2)-2t/(1+t^2)^2=t(t^2-1)/(1+t^2)^2$; the printed value forgets the )"
           R"(square in $\ddot\phi$. At $t=2$ it is $0.24$, not $-0.4$; for $|t|>1$ even the sign is wrong.)"});
  const auto along_radius = [](double one) {
    return [=](const At& k) { return -(one + k.d) / (k.d * k.d); };
  };
  claims.formula("acceleration_r", 277,
                 R"($\mathbf a$ has the component $-(2+t^2)/(1+t^2)^2$ along $\mathbf R$)", all,
                 {.quantity = R"($\mathbf a\cdot\mathbf R$)",
                  .truth = part_of_acceleration(2),
                  .printed = at(R"($-(2+t^2)/(1+t^2)^2$)", along_radius(1)),
                  .near_misses = {at(R"($-(1+t^2)/(1+t^2)^2$)", along_radius(0))}});
}

// ---- where it ends ----------------------------------------------------------------------------------------

/// At how many times `size` has grown since the time before; and the angle turned about the axis.
template <class F>
std::vector<Check> spiral(const std::string& what, double turned, const F& size) {
  constexpr int turns = 50, steps = 40 * turns;
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

template <class F>
Reading at_end(const std::string& text, const std::string& what, double sign, double said, const F& f) {
  return {text, {limits::limit(what, said, 0.5, [=](double s) { return f(Vector3(helix(sign / s))); })}};
}

void ends(Claims& claims, const std::vector<Sample>& all, const std::vector<Sample>& later,
          const std::vector<Sample>& earlier) {
  const auto from_axis = [](const Vector3& r) { return distance_from_axis(r); };
  const auto from_pole = [](const Vector3& r) { return length(r - pole); };
  const auto z = [](const Vector3& r) { return r[2]; };
  const auto power = [](double n) { return [=](const At& k) { return pow(k.d, n); }; };
  claims.formula(
      "distance_from_axis", 285, R"($x^2+y^2=1/(1+t^2)$)", all,
      {.quantity = R"($x^2+y^2$)",
       .truth = at("the position", [](const At& k) { return k.m.r[0] * k.m.r[0] + k.m.r[1] * k.m.r[1]; }),
       .printed = at(R"($1/(1+t^2)$)", power(-1)),
       .near_misses = {at(R"($1/\sqrt{1+t^2}$)", power(-0.5))}});
  const std::string distance = R"($\sqrt{x^2+y^2}$)";
  claims.add("distance_vanishes", 285, R"(the distance from the axis goes to 0 as $t$ becomes infinite)",
             {.printed = at_end("to 0", distance, 1, 0, from_axis),
              .near_misses = {at_end("to 1", distance, 1, 1, from_axis)}});
  claims.add(
      "spiral_in_the_plane", 285, "in the plane the path is a spiral into the origin",
      {.printed = {"the distance from the axis shrinks, turning on",
                   spiral("distance from the axis", 100 * pi, from_axis)},
       .near_misses = {{"turning the other way", spiral("distance from the axis", -100 * pi, from_axis)},
                       {R"($z$ shrinks)", spiral("height", 100 * pi, z)}}});
  const OfTime height = at(
      "the position", [](const At& k) { return values(k.m.r[2], k.m.r[2], k.m.r[2]); },
      [](const At& k) { return sqrt(k.d) / std::abs(k.t); });
  const auto chain = [](double n) {
    return [=](const At& k) { return values(k.t * pow(k.d, n), sqrt(k.t * k.t / k.d), sqrt(1 - 1 / k.d)); };
  };
  const auto read = [&](const std::string& text, double n, const std::vector<Sample>& samples) {
    return Reading{text,
                   {compare(R"($z$, three times)", at(R"(the three forms)", chain(n)), height, samples)}};
  };
  claims.add(
      "height_rewritten", 287,
      R"($t\,\sqrt{1+t^2}=\sqrt{t^2/(1+t^2)}=\sqrt{1-1/(1+t^2)}$ on the way to infinity)",
      {.printed = read(R"($t\,\sqrt{1+t^2}$ in the first form, for $t>0$)", 0.5, later),
       .meant = read(R"($t/\sqrt{1+t^2}$ in the first form, for $t>0$)", -0.5, later),
       .near_misses = {read(R"($t/\sqrt{1+t^2}$ in the first form, for $t<0$ as well)", -0.5, earlier)},
       .why =
           R"(The bar above the first root is lost in the text at hand: $t/\sqrt{1+t^2}$, as the next root has it )"
           R"(squared. The product has no limit; at $t=10$ it is 100, and the quotient 0.995.)",
       .kind = Fault::lost_typography});
  claims.add("height_limit", 287, R"($z$ tends to 1 as $t$ becomes infinite)",
             {.printed = at_end(R"(to 1 as $t\to\infty$)", "$z$", 1, 1, z),
              .near_misses = {at_end(R"(as $t\to-\infty$ as well: there it is $-1$)", "$z$", -1, 1, z)}});
  const std::string to_pole = "distance from the pole";
  Reading to_the_pole{"nearer and nearer, turning on", spiral(to_pole, 100 * pi, from_pole)};
  to_the_pole.checks.push_back(at_end("", to_pole, 1, 0, from_pole).checks.front());
  claims.add("spiral_to_the_pole", 311,
             R"(on the sphere the helix spirals about $(0,0,1)$ and reaches it in the limit)",
             {.printed = to_the_pole,
              .near_misses = {
                  at_end(R"(as $t\to-\infty$ as well: that is the other pole)", to_pole, -1, 0, from_pole)}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{{0.75}, {-0.75}, {0}, {50}, {-50}}, later, earlier;
  for (int i = 0; i < 200; ++i) all.push_back({i % 2 ? random.between(-50, 50) : random.magnitude(1e-3, 50)});
  for (const Sample& s : all)
    if (s.t != 0) (s.t > 0 ? later : earlier).push_back(s);
  Claims claims("2.3");
  angles(claims, all);
  velocity_and_acceleration(claims, all);
  ends(claims, all, later, earlier);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {{R"(sign of the velocity along $\mathbf Q$)",
           "At $t=0$ a model of the point sinks at speed 1 where the point itself climbs at speed 1."},
          {R"(square forgotten in $\ddot\phi$)",
           R"(In a table the northward acceleration at $t=2$ stands as $-0.4$; it is $0.24$.)"}};
}

}  // namespace oddity::spherical_helix
