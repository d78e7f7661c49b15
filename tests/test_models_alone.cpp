#include "chapters/03_rigid_body_motion/17_foucault/models.hpp"
#include "chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"
#include "chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"
#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/models.hpp"
// These headers are self-contained, so the others come after them.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/17_foucault/foucault.hpp"
#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

/// x + h dx.
template <class State>
State moved(State x, double h, const State& dx) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * dx[i];
  return x;
}

/// A model's observables at h, after one step of Runge-Kutta 4 unless it is a closed form.
template <class Model>
Value observed(const Model& model, double h) {
  if constexpr (requires { model.at(h); }) {
    return model.at(h);
  } else {
    using State = typename Model::State;
    const State x = model.start();
    State a, b, c, d;
    model(x, a, 0.0);
    model(moved(x, h / 2, a), b, h / 2);
    model(moved(x, h / 2, b), c, h / 2);
    model(moved(x, h, c), d, h);
    const State end = moved(moved(moved(moved(x, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    return model.observe(end, h);
  }
}

std::string without_spaces(std::string_view text) {
  std::string rest(text);
  std::erase(rest, ' ');
  return rest;
}

/// A scene, and its listed models that have been tried.
class Listed {
 public:
  explicit Listed(std::string_view number)
      : exercise_(std::ranges::find(registry(), exercise_number(number), &Entry::number)->exercise),
        parameters_(exercise_.parameters) {}

  double operator[](std::string_view name) const { return parameters_[name]; }

  /// Requires that the model is listed with this expression, and moves like the scene's.
  template <class Model>
  void have(const std::string& name, const std::string& expression, const Model& model) {
    INFO(exercise_.title << ", " << name);
    const auto& all = exercise_.scene->listing.models;
    const auto listed = std::ranges::find(all, name, &std::pair<std::string_view, std::string_view>::first);
    REQUIRE(listed != all.end());
    CHECK(without_spaces(listed->second) == without_spaces(expression));
    const double h = 0x1p-6;
    const Quantity motion = exercise_.scene->motion(parameters_, {h, 1}, Reference::nothing());
    const auto method = std::ranges::find_if(motion.methods, [&](const Method& m) {
      return m.model + ", " + m.algorithm == name ||
             (m.model == name && (m.algorithm == "closed form" || m.algorithm == "Runge-Kutta 4"));
    });
    REQUIRE(method != motion.methods.end());
    const Value own = observed(model, h), scenes = method->run(h).value;
    CHECK(distance(own, scenes) <= 1e-15 * size_of(scenes));
    tried_.insert(name);
  }

  void have_all() const { CHECK(tried_.size() == exercise_.scene->listing.models.size()); }

 private:
  Exercise exercise_;
  Parameters parameters_;
  std::set<std::string> tried_;
};

#define HAS(name, ...) listed.have(name, #__VA_ARGS__, __VA_ARGS__)

}  // namespace

TEST_CASE("The models of 3.17 are self-contained and listed", "[models]") {
  Listed listed("3.17");
  const double lambda = listed["lambda"], L = listed["L"], omega = listed["omega"], g = listed["g"],
               theta = listed["theta"], phi = listed["phi"], theta_dot = listed["theta_dot"],
               phi_dot = listed["phi_dot"];
  HAS("averaged", foucault::SmallAngle<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}, true});
  HAS("small angle", foucault::SmallAngle<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}});
  HAS("two angles as published",
      foucault::TwoAngles<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}, 0});
  HAS("two angles", foucault::TwoAngles<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}});
  HAS("Cartesian with constraint",
      foucault::Cartesian<double>{{lambda, L, omega, g, theta, phi, theta_dot, phi_dot}});
  listed.have_all();
}

TEST_CASE("The models of 3.19 are self-contained and listed", "[models]") {
  Listed listed("3.19");
  const double m2 = listed["m2"], m3 = listed["m3"], I1 = listed["I1"], I2 = listed["I2"], R1 = listed["R1"],
               R2 = listed["R2"], c1 = listed["c1"], c2 = listed["c2"], L1 = listed["L1"], L2 = listed["L2"],
               K1 = listed["K1"], K2 = listed["K2"], g = listed["g"], y2 = listed["y2"], y3 = listed["y3"],
               v2 = listed["v2"], v3 = listed["v3"];
  HAS("two coordinates", two_pulleys::TwoCoordinates<double>{
                             {m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}});
  HAS("four coordinates with tensions",
      two_pulleys::FourCoordinates<double>{
          {m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}});
  HAS("published equations", two_pulleys::TwoCoordinates<double>{
                                 {m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}, 0});
  HAS("normal modes",
      two_pulleys::Modes<double>({m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}));
  HAS("normal modes, pulleys without inertia",
      two_pulleys::Modes<double>({m2, m3, 0, 0, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3, v2, v3}));
  listed.have_all();
}

TEST_CASE("The models of 3.21 are self-contained and listed", "[models]") {
  Listed listed("3.21");
  const double m = listed["m"], L = listed["L"], r = listed["r"], phi = listed["phi"], f = listed["f"],
               k = listed["k"], theta = listed["theta"], theta_dot = listed["theta_dot"],
               psi_dot = listed["psi_dot"];
  HAS("constant speeds",
      pipe_and_disk::ConstantSpeeds<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}});
  HAS("one angle", pipe_and_disk::OneAngle<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}});
  HAS("two angles", pipe_and_disk::TwoAngles<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}});
  HAS("Cartesian center", pipe_and_disk::Center<double>{{m, L, r, phi, f, k, theta, theta_dot, psi_dot}});
  listed.have_all();
}

TEST_CASE("The models of 3.23 are self-contained and listed", "[models]") {
  Listed listed("3.23");
  const double m = listed["m"], r = listed["r"], s = listed["s"], c = listed["c"], h = listed["h"],
               g = listed["g"], ell = listed["ell"], theta0 = listed["theta0"], w0 = listed["w0"];
  HAS("small oscillation", spring_bar::SmallOscillation<double>{{m, r, s, c, h, g, ell, theta0, w0}});
  HAS("one angle", spring_bar::OneAngle<double>{{m, r, s, c, h, g, ell, theta0, w0}});
  HAS("Cartesian with constraint",
      spring_bar::CartesianWithConstraint<double>{{m, r, s, c, h, g, ell, theta0, w0}});
  listed.have_all();
}

TEST_CASE("The models of 3.25 are self-contained and listed", "[models]") {
  Listed listed("3.25");
  const double m1 = listed["m1"], m2 = listed["m2"], m3 = listed["m3"], r1 = listed["r1"], r2 = listed["r2"],
               r3 = listed["r3"], g = listed["g"], h = listed["h"], theta1 = listed["theta1"],
               theta2 = listed["theta2"], theta3 = listed["theta3"], omega1 = listed["omega1"],
               omega2 = listed["omega2"], omega3 = listed["omega3"];
  HAS("dense mass matrix",
      chain::Angles<double, chain::Equations::dense>{
          {{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, theta3}, {omega1, omega2, omega3}}});
  HAS("tensions",
      chain::Angles<double, chain::Equations::tensions>{
          {{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, theta3}, {omega1, omega2, omega3}}});
  HAS("normal modes",
      chain::Modes<double>(
          {{m1, m2, m3}, {r1, r2, r3}, g, h, {theta1, theta2, theta3}, {omega1, omega2, omega3}}));
  listed.have_all();
}

TEST_CASE("The models of 3.27 are self-contained and listed", "[models]") {
  Listed listed("3.27");
  const double G = listed["G"], m1 = listed["m1"], m2 = listed["m2"], r0 = listed["r0"],
               r0_dot = listed["r0_dot"], phi0 = listed["phi0"], phi0_dot = listed["phi0_dot"];
  HAS("Kepler's equation, Newton from pi",
      two_bodies::ByKeplersEquation<double>({G, m1, m2, r0, r0_dot, phi0, phi0_dot}));
  HAS("(r, u, phi)", two_bodies::Published<double>{{G, m1, m2, r0, r0_dot, phi0, phi0_dot}});
  HAS("two bodies", two_bodies::BothBodies<double>{{G, m1, m2, r0, r0_dot, phi0, phi0_dot}});
  listed.have_all();
}

TEST_CASE("The models of 3.29 are self-contained and listed", "[models]") {
  Listed listed("3.29");
  const double q = listed["q"], d = listed["d"], u = listed["u"], v = listed["v"], w = listed["w"],
               g = listed["g"];
  HAS("center alone", planar_wire::PointMass<double>{planar_wire::thrown<double>({q, d, u, v, w, g})});
  HAS("free fall", planar_wire::FreeFall<double>{planar_wire::thrown<double>({q, d, u, v, w, g})});
  HAS("x, y, theta", planar_wire::Generalized<double>{planar_wire::thrown<double>({q, d, u, v, w, g})});
  HAS("two particles and a rod",
      planar_wire::TwoParticles<double>{planar_wire::thrown<double>({q, d, u, v, w, g})});
  listed.have_all();
}

TEST_CASE("The models of 3.31 are self-contained and listed", "[models]") {
  Listed listed("3.31");
  const double a = listed["a"], b = listed["b"], mu = listed["mu"], g = listed["g"], u0 = listed["u0"],
               v0 = listed["v0"], w0 = listed["w0"];
  HAS("sliding and spinning apart", rough_box::Uncoupled<double>{{{a, b}, mu, g, u0, v0, w0}});
  HAS("friction at full speed only", rough_box::InTime<double>{{{a, b}, mu, g, u0, v0, w0}});
  HAS("friction regularized at 1 cm/s", rough_box::InTime<double>{{{a, b}, mu, g, u0, v0, w0}, double(0.01)});
  listed.have_all();
}

TEST_CASE("The models of 3.33 are self-contained and listed", "[models]") {
  Listed listed("3.33");
  const double m = listed["m"], l = listed["l"], mu1 = listed["mu1"], mu3 = listed["mu3"], g = listed["g"],
               theta = listed["theta"], phi = listed["phi"], psi = listed["psi"], dtheta = listed["dtheta"],
               dphi = listed["dphi"], dpsi = listed["dpsi"];
  HAS("mean precession of a fast top",
      heavy_top::MeanPrecession<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}});
  HAS("one angle, precession by quadrature",
      heavy_top::OneAngle<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}});
  HAS("Euler angles",
      heavy_top::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}});
  HAS("rigid body, quaternion",
      heavy_top::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}});
  HAS("axis and angular momentum",
      heavy_top::AxisAndMomentum<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}});
  listed.have_all();
}

TEST_CASE("The models of 3.35 are self-contained and listed", "[models]") {
  Listed listed("3.35");
  const double m = listed["m"], l = listed["l"], mu1 = listed["mu1"], mu3 = listed["mu3"], g = listed["g"],
               theta = listed["theta"], phi = listed["phi"], psi = listed["psi"], dtheta = listed["dtheta"],
               dphi = listed["dphi"], dpsi = listed["dpsi"], A = listed["A"], lambda = listed["lambda"];
  HAS("fixed tip, as proposed", moving_tip::AxisAndMomentum<double>{moving_tip::with_fixed_tip<double>(
                                    {m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda})});
  HAS("small tilt",
      moving_tip::SmallTilt<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}});
  HAS("first order in A",
      moving_tip::FirstOrderInA<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}});
  HAS("Euler angles",
      moving_tip::EulerAngles<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}});
  HAS("rigid body, quaternion",
      moving_tip::RigidBody<double>{{m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}});
  HAS("axis and angular momentum", moving_tip::AxisAndMomentum<double>{
                                       {m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A, lambda}});
  listed.have_all();
}

TEST_CASE("A Foucault pendulum starts with the velocity that dual numbers give", "[models]") {
  const foucault::Given<double> p{0.75, 1.25, 0.0625, 9.81, 0.5, 0.25, 1, -0.5};
  const auto v = ex03_17::axis_velocity<double>({p.theta, p.phi}, {p.theta_dot, p.phi_dot});
  for (std::size_t i = 0; i < 3; ++i) CHECK(p.cartesian()[3 + i] == p.L * v[i]);
}
