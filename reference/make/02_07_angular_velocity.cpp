#include "reference/make/curve_on_sphere.hpp"

// w has the components |r'| along r x u, zero along u and kappa = r.(r' x r'')/|r'|^2 along r. With the
// velocity's and the acceleration's components along east and north, v_e = pi cos(psi), v_n = psi':
//   r x r' = v_e north - v_n east,  r.(r' x r'') = v_e a_n - v_n a_e,
//   a_e = -2 pi psi' sin(psi),  a_n = psi'' + pi^2 sin(psi) cos(psi)
namespace oddity::truth {

namespace angular_velocity_02_07 {

Numbers by_angles(const std::vector<double>& in, int) {
  const curve_on_sphere::Angles a{Number(in[0])};
  const Number east = pi() * a.cosine, north = a.rate;
  const Number a_east = -2 * pi() * a.rate * a.sine, a_north = a.rate_dot + pi() * pi() * a.sine * a.cosine;
  const Number kappa = (east * a_north - north * a_east) / (east * east + north * north);
  return numbers(sum(scaled(kappa, a.r), sum(scaled(east, a.north), scaled(-north, a.east))));
}

/// Six digits are lost by subtracting the frames, at steps down to 2^-20.
Numbers by_positions(const std::vector<double>& in, int digits) {
  const auto frame = [&](const Number& t) { return curve_on_sphere::frame_by_positions(t, digits + 6); };
  return angular_velocity(frame, Number(in[0]), digits);
}

}  // namespace angular_velocity_02_07

Truth truth_02_07_angular_velocity() {
  using namespace angular_velocity_02_07;
  return {"angular velocity at t of the orientation [r u r x u] on a curve of the unit sphere, u = r'/|r'|",
          "Skew(w) = R' R^T, r = ((1 - t^2) cos(pi t), (1 - t^2) sin(pi t), t^2)/sqrt((1 - t^2)^2 + t^4)",
          {"t"},
          {{"w_x", "1"}, {"w_y", "1"}, {"w_z", "1"}},
          {{-0.5}, {0}, {0.25}, {0.5}, {0.75}, {1.5}, {4}},
          "latitude and longitude of r and their rates",
          by_angles,
          "the skew part of R(t + h) R(t - h)^T / 2h, extrapolated, R from positions",
          by_positions,
          "the first route",
          by_angles};
}

}  // namespace oddity::truth
