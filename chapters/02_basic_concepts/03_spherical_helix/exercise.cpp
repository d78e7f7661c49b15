// Exercise 2.3: the motion r(t) = (cos t, sin t, t)/sqrt(1 + t^2) in spherical coordinates.
//   R = r, P = k x R/|k x R|, Q = R x P: east is P, the pole lies towards Q; phi is the angle from the pole
//   v = sin(phi) P - phi' Q,  a = 2 phi' cos(phi) P + (sin(phi) cos(phi) - phi'') Q - (phi'^2 + sin^2(phi)) R
// The other route has no angle: Cartesian derivatives by dual numbers, projected on the frame of the
// position. Where the text speaks of angles, the other route is atan2 of the coordinates in dual numbers.

#include "chapters/02_basic_concepts/03_spherical_helix/spherical_helix.hpp"
#include "chapters/random.hpp"

namespace oddity {

namespace ex02_03 {

using namespace spherical_helix;

constexpr Parameter parameters[] = {
    {"t", 2, "1", "time at which the motion is computed", -1e9, 1e9},
    {"seed", 1, "", "of the random times in [-50, 50]", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

/// At how many times `size` has grown since the time before; and the angle turned about the axis.
template <class F>
std::vector<Check> spiral(std::string what, double turned, const F& size) {
  constexpr int turns = 50, steps = 40 * turns;
  long growing = 0;
  double angle = 0;
  for (int i = 1; i <= steps; ++i) {
    const Vector3 a = helix(1 + 2 * pi * turns * (i - 1) / steps), b = helix(1 + 2 * pi * turns * i / steps);
    growing += !(size(b) < size(a));
    angle += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }
  return {never("steps in which the " + std::move(what) + " grows", growing, steps),
          {"angle turned from t = 1 to t = 1 + 100 pi",
           {"the text: once in 2 pi", turned},
           {"sum of angles between positions", angle},
           rounding(2 * pi * turns, steps)}};
}

using S = const Sample&;

double slope_of_acos(double u) {
  const Dual<double> x(u, 1);
  return atan2(sqrt(Dual<double>(1) - x * x), x).slope;
}

std::vector<Claim> claims(double seed) {
  Random random(seed);
  std::vector<Sample> all{Sample(0.75), Sample(-0.75), Sample(0), Sample(50), Sample(-50)}, early, later,
      earlier;
  for (int i = 0; i < 200; ++i)
    all.emplace_back(i % 2 ? random.between(-50, 50) : random.magnitude(1e-3, 50));
  for (const Sample& s : all) {
    if (s.t != 0) (s.t > 0 ? later : earlier).push_back(s);
    if (std::abs(s.t) * sqrt(s.d) < 1) early.push_back(s);
  }

  const auto phi = [](S s) { return std::acos(s.t / sqrt(s.d)); };
  const std::string cartesian = "Cartesian dual numbers on the frame", angles = "atan2 of the position";
  const auto along = [&](std::string text, std::size_t i, bool velocity, auto component) {
    return reading(std::move(text), std::string(velocity ? "v along " : "a along ") + "PQR"[i], cartesian,
                   all, [=](S s) {
                     return Sides{component(s), velocity ? s.v[i] : s.a[i], velocity ? s.speed : s.pull};
                   });
  };
  const auto chain = [&](const char* text, const std::vector<Sample>& samples) {
    return reading(text, "z", "the position", samples, [](S s) {
      return Sides{
          {sqrt(s.t * s.t / s.d), sqrt(1 - 1 / s.d)}, {s.m.r[2], s.m.r[2]}, sqrt(s.d) / std::abs(s.t)};
    });
  };
  const auto at_end = [](const char* text, const char* what, double sign, double said, auto f) {
    return Reading{text, {limit(what, said, 0.5, [=](double s) { return f(Vector3(helix(sign / s))); })}};
  };
  const auto from_pole = [](const Vector3& r) { return length(r - pole); };
  const auto z = [](const Vector3& r) { return r[2]; };
  Reading to_the_pole{"nearer and nearer, turning on", spiral("distance from the pole", 100 * pi, from_pole)};
  to_the_pole.checks.push_back(at_end("", "distance from the pole", 1, 0, from_pole).checks.front());

  Claim v_Q{"2.3-velocity_q", 261, "v has the component -1/(1 + t^2) along Q"};
  v_Q.printed = along("-1/(1 + t^2)", 1, true, [](S s) { return -1 / s.d; });
  v_Q.corrected = along("+1/(1 + t^2)", 1, true, [](S s) { return 1 / s.d; });
  v_Q.near_misses = {along("+1/(1 + t^2)^(3/2)", 1, true, [](S s) { return pow(s.d, -1.5); })};
  v_Q.why =
      "The step before is right, $\\mathbf v=\\sin\\phi\\,\\mathbf P-\\dot\\phi\\,\\mathbf Q$, but "
      "$\\dot\\phi=-1/(1+t^2)$ is negative: $\\mathbf v=\\mathbf P/\\sqrt{1+t^2}+\\mathbf Q/(1+t^2)$. At "
      "$t=0$ the helix rises with $\\dot z=1$ and $\\mathbf Q=\\mathbf k$; the printed velocity falls.";
  Claim a_Q{"2.3-acceleration_q", 277, "a has the component -t/(1 + t^2) along Q"};
  a_Q.printed = along("-t/(1 + t^2)", 1, false, [](S s) { return -s.t / s.d; });
  a_Q.corrected =
      along("t(t^2 - 1)/(1 + t^2)^2", 1, false, [](S s) { return s.t * (s.t * s.t - 1) / (s.d * s.d); });
  a_Q.near_misses = {
      along("t(t^2 + 1)/(1 + t^2)^2", 1, false, [](S s) { return s.t * (s.t * s.t + 1) / (s.d * s.d); })};
  a_Q.why =
      "$\\sin\\phi\\cos\\phi-\\ddot\\phi=t/(1+t^2)-2t/(1+t^2)^2=t(t^2-1)/(1+t^2)^2$; the printed value "
      "forgets the square in $\\ddot\\phi$. At $t=2$ it is $0.24$, not $-0.4$; for $|t|>1$ even the sign "
      "is wrong.";
  return {
      formula("2.3-on_the_sphere", 191, "rho = 1 for all t", "rho", "the unit sphere", all, 0.5, 1,
              [](S s, double k) {
                return Sides{std::hypot(std::cos(s.t), std::sin(s.t), s.t) / pow(s.d, k), 1};
              }),
      lost_bar(
          formula("2.3-spherical_coordinates", 193,
                  "x = cos(theta) sin(phi), y = sin(theta) sin(phi), z = cos(phi), with x, y and z as given",
                  "r", "the position, the angles being atan2 of it", all, 1, -1,
                  [](S s, double k) {
                    return Sides{at_angles(s.theta[0], k * s.phi[0]), s.m.r, 1};
                  }),
          reading("x = cos t sqrt(1 + t^2)", "(x, y, z)", "the angles, atan2 of the position", all,
                  [](S s) {
                    return Sides{sqrt(s.d) * Vector3{std::cos(s.t), std::sin(s.t), s.t},
                                 at_angles(s.theta[0], s.phi[0]), s.d};
                  }),
          "The bars above the roots are lost in the text at hand: $x=\\cos t/\\sqrt{1+t^2}$. As products "
          "they leave the sphere: at $t=1$, $|(x,y,z)|$ is 2."),
      formula("2.3-sine_of_phi", 201, "sin(phi) = 1/sqrt(1 + t^2), positive", "sin(phi)", angles, all, 1, -1,
              [](S s, double k) {
                return Sides{k / sqrt(s.d), std::sin(s.phi[0]), 4};
              }),
      formula(
          "2.3-theta", 201, "cos(theta) = cos t and sin(theta) = sin t: theta = t", "(cos, sin) of theta",
          angles, all, 1, -1,
          [](S s, double k) {
            return Sides{{std::cos(s.t), std::sin(k * s.t)}, {std::cos(s.theta[0]), std::sin(s.theta[0])}, 4};
          }),
      lost_bar(formula("2.3-phi", 205, "phi is the arc cosine of z, in [0, pi]", "phi", angles, all, 1, -1,
                       [&](S s, double k) {
                         return Sides{k * phi(s), s.phi[0], sqrt(s.d)};
                       }),
               reading("phi = acos(t sqrt(1 + t^2))", "phi, where there is such an angle", angles, early,
                       [](S s) {
                         return Sides{std::acos(s.t * sqrt(s.d)), s.phi[0], 1};
                       }),
               "The bar is lost in the text at hand: $\\phi=\\cos^{-1}(t/\\sqrt{1+t^2})$. As a product, "
               "$t\\sqrt{1+t^2}$, it is above 1 from $t=0.79$ on, and no cosine."),
      formula("2.3-rates_of_rho_and_theta", 209, "rho' = rho'' = 0, theta' = 1, theta'' = 0",
              "(rho', rho'', theta', theta'')", angles, all, 1, -1,
              [](S s, double k) {
                return Sides{{0, 0, k, 0}, {s.rho[1], s.rho[2], s.theta[1], s.theta[2]}, 4};
              }),
      lost_bar(
          formula("2.3-derivative_of_acos", 211, "the derivative of acos(u)", "slope",
                  "atan2 in dual numbers", all, -1, 1,
                  [](S s, double k) {
                    const double u = s.m.r[2];
                    return Sides{k / sqrt((1 - u) * (1 + u)), slope_of_acos(u), s.d * sqrt(s.d)};
                  }),
          reading("-1 sqrt(1 - u^2)", "slope", "atan2 in dual numbers", all,
                  [](S s) {
                    const double u = s.m.r[2];
                    return Sides{-sqrt((1 - u) * (1 + u)), slope_of_acos(u), s.d * sqrt(s.d)};
                  }),
          "The bar is lost in the text at hand: $-1/\\sqrt{1-u^2}$. At $u=0.6$ that is $-1.25$, the product "
          "$-0.8$."),
      lost_bar(formula("2.3-derivative_of_z", 219, "dz/dt is (1 + t^2)^(-3/2)", "z'", "dual numbers", all,
                       -1.5, -0.5,
                       [](S s, double k) {
                         return Sides{pow(s.d, k), s.m.v[2], 1 / sqrt(s.d)};
                       }),
               reading("z = t sqrt(1 + t^2)", "z'", "dual numbers", all,
                       [](S s) {
                         const Dual<double> t(s.t, 1), product = t * sqrt(Dual<double>(1) + t * t);
                         return Sides{pow(s.d, -1.5), product.slope, sqrt(s.d)};
                       }),
               "The bar is lost in the text at hand: $z=t/\\sqrt{1+t^2}$. The derivative of the product is "
               "$(1+2t^2)/\\sqrt{1+t^2}$, 2.12 at $t=1$ for 0.354."),
      lost_bar(
          formula("2.3-chain_rule", 229, "phi' by the chain rule", "phi'", angles, all, -1, 1,
                  [](S s, double k) {
                    return Sides{k / sqrt(1 - s.t * s.t / s.d) * pow(s.d, -1.5), s.phi[1], 1};
                  }),
          reading("-1 sqrt(1 - t^2/(1 + t^2)) (1 + t^2)^(-3/2)", "phi'", angles, all,
                  [](S s) {
                    return Sides{-sqrt(1 - s.t * s.t / s.d) * pow(s.d, -1.5), s.phi[1], 1};
                  }),
          "The bar above the root is lost in the text at hand; the root divides. At $t=1$ the quotient is "
          "$-\\tfrac12$, the product $-\\tfrac14$."),
      formula("2.3-phi_dot", 229, "phi' = -1/(1 + t^2)", "phi'", angles, all, -1, 1,
              [](S s, double k) {
                return Sides{k / s.d, s.phi[1], 1 / sqrt(s.d)};
              }),
      formula("2.3-phi_double_dot", 251, "phi'' = 2t/(1 + t^2)^2", "phi''", angles, all, 2, 1,
              [](S s, double k) {
                return Sides{2 * s.t / pow(s.d, k), s.phi[2], 1 / sqrt(s.d)};
              }),
      formula("2.3-position", 257, "r = R(theta, phi)", "r", "the position", all, 1, -1,
              [&](S s, double k) {
                return Sides{of_angles(s.t, phi(s), {0, 0, k}), s.m.r, sqrt(s.d)};
              }),
      formula("2.3-velocity_formula", 261, "v = sin(phi) P - phi' Q", "v", "Cartesian dual numbers", all, -1,
              1,
              [](S s, double k) {
                return Sides{of_angles(s.theta[0], s.phi[0], {std::sin(s.phi[0]), k * s.phi[1], 0}), s.m.v,
                             1 + s.speed};
              }),
      lost_bar(
          claim("2.3-velocity_p", 261, "v has the component 1/sqrt(1 + t^2) along P",
                along("1/sqrt(1 + t^2)", 0, true, [](S s) { return 1 / sqrt(s.d); }),
                {along("1/(1 + t^2)", 0, true, [](S s) { return 1 / s.d; })}),
          along("1 sqrt(1 + t^2)", 0, true, [](S s) { return sqrt(s.d); }),
          "The bar above the root is lost in the text at hand: $\\mathbf P/\\sqrt{1+t^2}$. As it stands the "
          "speed grows with $t$; at $t=10$ the helix moves at 0.1, and the product says 10."),
      v_Q,
      formula("2.3-velocity_r", 261, "v has no component along R", "v", "Cartesian dual numbers", all, 0, 1,
              [](S s, double k) {
                return Sides{of_angles(s.theta[0], s.phi[0], {s.v[0], s.v[1], k}), s.m.v, 1 + s.speed};
              }),
      formula("2.3-acceleration_formula", 277,
              "a = 2 phi' cos(phi) P + (sin(phi) cos(phi) - phi'') Q - (phi'^2 + sin^2(phi)) R", "a",
              "Cartesian dual numbers", all, -1, 1,
              [](S s, double k) {
                const double sine = std::sin(s.phi[0]), cosine = std::cos(s.phi[0]), w = s.phi[1];
                const Vector3 parts{2 * w * cosine, sine * cosine + k * s.phi[2], -(w * w + sine * sine)};
                return Sides{of_angles(s.theta[0], s.phi[0], parts), s.m.a, 1 + s.pull};
              }),
      claim("2.3-acceleration_p", 277, "a has the component -2t/(1 + t^2)^(3/2) along P",
            along("-2t/(1 + t^2)^(3/2)", 0, false, [](S s) { return -2 * s.t / pow(s.d, 1.5); }),
            {along("-2t/(1 + t^2)^2", 0, false, [](S s) { return -2 * s.t / (s.d * s.d); })}),
      a_Q,
      claim("2.3-acceleration_r", 277, "a has the component -(2 + t^2)/(1 + t^2)^2 along R",
            along("-(2 + t^2)/(1 + t^2)^2", 2, false, [](S s) { return -(1 + s.d) / (s.d * s.d); }),
            {along("-(1 + t^2)/(1 + t^2)^2", 2, false, [](S s) { return -1 / s.d; })}),
      formula("2.3-distance_from_axis", 285, "x^2 + y^2 = 1/(1 + t^2)", "x^2 + y^2", "the position", all, 1,
              0.5,
              [](S s, double k) {
                return Sides{pow(s.d, -k), s.m.r[0] * s.m.r[0] + s.m.r[1] * s.m.r[1]};
              }),
      claim("2.3-distance_vanishes", 285, "the distance from the axis goes to 0 as t becomes infinite",
            at_end("0", "r", 1, 0, distance_from_axis), {at_end("1", "r", 1, 1, distance_from_axis)}),
      claim("2.3-spiral_in_the_plane", 285, "in the plane the path is a spiral into the origin",
            {"r shrinks, turning on", spiral("distance from the axis", 100 * pi, distance_from_axis)},
            {{"turning the other way", spiral("distance from the axis", -100 * pi, distance_from_axis)},
             {"z shrinks", spiral("height", 100 * pi, z)}}),
      lost_bar(
          claim("2.3-height_rewritten", 287,
                "t/sqrt(1 + t^2) = sqrt(t^2/(1 + t^2)) = sqrt(1 - 1/(1 + t^2)) on the way to infinity",
                chain("a quotient, for t > 0", later), {chain("for t < 0 as well", earlier)}),
          reading("t sqrt(1 + t^2)", "z", "the position", later,
                  [](S s) {
                    return Sides{s.t * sqrt(s.d), s.m.r[2], s.d};
                  }),
          "The bar above the first root is lost in the text at hand: $t/\\sqrt{1+t^2}$, as the next root "
          "has it squared. The product has no limit; at $t=10$ it is 100, and the quotient 0.995."),
      claim("2.3-height_limit", 287, "z tends to 1 as t becomes infinite", at_end("1", "z", 1, 1, z),
            {at_end("as t -> -infinity as well: there it is -1", "z", -1, 1, z)}),
      claim("2.3-spiral_to_the_pole", 311,
            "on the sphere the helix spirals about (0, 0, 1) and reaches it in the limit", to_the_pole,
            {at_end("as t -> -infinity as well: that is the other pole", "distance from the pole", -1, 0,
                    from_pole)}),
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]),
          {motion(p["t"], truth), colatitude("colatitude", p["t"], truth),
           colatitude("colatitude_near_the_north_pole", 1e8, truth),
           colatitude("colatitude_near_the_south_pole", -1e8, truth), limits_at_infinity()}};
}

}  // namespace ex02_03

Exercise exercise_2_3() {
  using namespace ex02_03;
  return {"Spherical helix",
          "The curve $(\\cos t,\\sin t,t)/\\sqrt{1+t^2}$ winds about the unit sphere: find its spherical "
          "coordinates, its velocity and acceleration in the frame $\\{\\mathbf P,\\mathbf Q,\\mathbf "
          "R\\}$, and where it ends.",
          parameters,
          {},
          study};
}

}  // namespace oddity
