// The claims of exercise 3.35, judged against tops made of point masses, whose Lagrangian with a moving tip
// is differentiated by nested dual numbers.

#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/03_rigid_body_motion/shared/top_of_points.hpp"

namespace oddity::ex03_35 {

using namespace top;
using std::cos, std::sin;

namespace {

// ---- the points' motion along Lagrange's accelerations ----------------------------------------------------

struct Moving {
  Vector<double> x, v, a;
};

/// Position, velocity and acceleration of a body point.
Moving motion_of(const Sample& s, const Vector<double>& body_point) {
  using D = Dual<Dual<double>>;
  const auto angle = [&](std::size_t i) {
    return D(Dual<double>(s.q[i], s.v[i]), Dual<double>(s.v[i], s.truth[i]));
  };
  const auto r = rotation(angle(0), angle(1), angle(2));
  const auto x = s.body.position(PointOf<double>{1, body_point}, r, D(Dual<double>(s.t, 1), Dual<double>(1)));
  Moving moving;
  for (std::size_t i = 0; i < 3; ++i) {
    moving.x[i] = x[i].value.value;
    moving.v[i] = x[i].value.slope;
    moving.a[i] = x[i].slope.slope;
  }
  return moving;
}

Moving center_of(const Sample& s) { return motion_of(s, {0, 0, s.l}); }

Vector<double> less(const Vector<double>& a, const Vector<double>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The rate of the angular momentum about a point moving with the body, as seen from it.
Vector<double> momentum_rate_about(const Sample& s, const Vector<double>& body_point) {
  const Moving center = motion_of(s, body_point);
  Vector<double> sum{};
  for (const PointOf<double>& p : s.body.points) {
    const Moving point = motion_of(s, p.x);
    const Vector<double> moment = cross(less(point.x, center.x), less(point.a, center.a));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * moment[i];
  }
  return sum;
}

Vector<double> tip(const Sample& s) { return {s.body.A * sin(s.body.lambda * s.t), 0, 0}; }

/// The rate of the angular momentum about the center of mass, less `sign` times the torque of the force on
/// the tip: mass times the acceleration of the center of mass, less the weight.
Value unexplained(const Sample& s, double sign) {
  const Moving center = center_of(s);
  const Vector<double> force{s.m * center.a[0], s.m * center.a[1], s.m * (center.a[2] + s.body.g)};
  const Vector<double> rate = momentum_rate_about(s, {0, 0, s.l}),
                       torque = cross(less(tip(s), center.x), force);
  return values(rate[0] - sign * torque[0], rate[1] - sign * torque[1], rate[2] - sign * torque[2]);
}

/// The rates of the state of a model at the start that it has.
template <class Model>
typename Model::State rates_of(const Model& model, double t) {
  typename Model::State rates;
  model(model.start(), rates, t);
  return rates;
}
/// (theta'', phi'', psi'') of the equations of the angles, and (w1', w2', w3') of Euler's.
Value model_accelerations(const Top& top, double t) {
  const auto rates = rates_of(moving_tip::EulerAngles<double>{top}, t);
  return {rates[3], rates[4], rates[5]};
}
Value euler_equations(const Top& top, double t) {
  const auto rates = rates_of(moving_tip::RigidBody<double>{top}, t);
  return {rates[4], rates[5], rates[6]};
}

/// (w1', w2', w3') along Lagrange's accelerations.
Value body_rates_change(const Sample& s) {
  const auto w = [&](std::size_t k) {
    return rate_of(s, s.truth, [k](const auto& q, const auto& v) {
      if (k == 0) return v[1] * cos(q[2]) + v[0] * sin(q[1]) * sin(q[2]);
      if (k == 1) return v[0] * sin(q[1]) * cos(q[2]) - v[1] * sin(q[2]);
      return v[2] + v[0] * cos(q[1]);
    });
  };
  return {w(0), w(1), w(2)};
}

double vertical_momentum_rate(const Sample& s) {
  return rate_of(s, s.truth, [&](const auto& q, const auto& v) {
    return s.mu1 * v[0] * sin(q[1]) * sin(q[1]) + s.mu3 * (v[2] + v[0] * cos(q[1])) * cos(q[1]);
  });
}

Top at_rest(const Sample& s) { return moving_tip::with_fixed_tip(s.top()); }

/// The acceleration of the tip: from that of the center of mass back along the axis, a + w' x (-l d) + w x (w
/// x
/// (-l d)).
Value tip_acceleration(const Sample& s) {
  const Moving c = center_of(s);
  const auto r = rotation(s.q[0], s.q[1], s.q[2]);
  const Value body = s.body_rates(), rate = euler_equations(s.top(), s.t);
  Vector<double> w{}, dw{}, arm{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      w[i] += r[i][k] * body[k];
      dw[i] += r[i][k] * rate[k];
    }
    arm[i] = -s.l * r[i][2];
  }
  const Vector<double> swing = cross(dw, arm), pull = cross(w, cross(w, arm));
  return values(c.a[0] + swing[0] + pull[0], c.a[1] + swing[1] + pull[1], c.a[2] + swing[2] + pull[2]);
}

const std::string no_torque = "no torque of what moves the tip";

}  // namespace

std::vector<Claim> claims(double seed) {
  using Reader = Formula<Sample>;
  const std::vector<Sample> tops = random_tops(seed, 1);
  const Reader zero{"zero", [](const Sample&) { return values(0); }},
      none{"zero", [](const Sample&) { return values(0, 0, 0); }};
  const auto reading = [&](const std::string& text, const std::string& quantity, const Reader& left,
                           const Reader& right) {
    return Reading{text, {compare(quantity, left, right, tops)}};
  };
  Claims claims("3.35");

  const std::string rate =
      R"($\sum m(\mathbf x-\mathbf r)\times(\ddot{\mathbf x}-\ddot{\mathbf r})$ over the points)";
  // The accelerations are those of Lagrange's equations: what cancels is larger than the two sides.
  const auto with_torque = [&](const std::string& text, double sign) {
    return reading(
        text,
        R"(rate of the angular momentum about the center of mass, less the torque of the force on the tip)",
        {rate + ", less the torque", [=](const Sample& s) { return unexplained(s, sign); }}, none);
  };
  const std::string no_force_torque =
      "what moves the tip is a force on the center of mass: it has no torque about it";
  claims.add(
      "force_at_center", 3089, no_force_torque,
      {.printed = reading("no torque about the center of mass", no_force_torque,
                          {rate,
                           [](const Sample& s) {
                             return momentum_rate_about(s, {0, 0, s.l});
                           }},
                          none),
       .corrected = with_torque(
           R"(a force $\mathbf N=m(\ddot{\mathbf r}+g\mathbf k)$ on the tip, with the torque $(\mathbf p-\mathbf )"
           R"(r)\times\mathbf N$ about the center of mass $\mathbf r$)",
           1),
       .near_misses = {with_torque(R"(the torque $(\mathbf r-\mathbf p)\times\mathbf N$)", -1)},
       .why =
           R"(A force on the center of mass $\mathbf r$ has no torque about it, and the angular momentum about )"
           R"(it would stay as it is. The tip is moved by what holds it: a force )"
           R"($\mathbf N=m(\ddot{\mathbf r}+g\mathbf k)$ at the tip $\mathbf p$, whose torque about the center )"
           R"(of mass is $(\mathbf p-\mathbf r)\times\mathbf N$. What does act at the center of mass is the )"
           R"(inertial force $-m\ddot{\mathbf p}$ in the tip's frame; it has a torque about the tip.)",
       .kind = Fault::counterexample,
       .root = no_torque});

  claims.formula("euler_about_axis", 3089, "Euler's equation for the motion about the axis still applies",
                 tops,
                 {.quantity = R"($\dot w_3$)",
                  .truth = zero,
                  .printed = {R"($\dot w_3=0$ along Lagrange's accelerations)",
                              [](const Sample& s) { return body_rates_change(s)[2]; }},
                  .near_misses = {{R"($\ddot\psi=0$)", [](const Sample& s) { return s.truth[2]; }}}});

  const Reader change{"along Lagrange's accelerations, tip moving", body_rates_change},
      vertical{"its rate along Lagrange's accelerations, tip moving", vertical_momentum_rate};
  const std::string in_body = R"($\dot{\mathbf w}$ in body coordinates)";
  const std::string constant = R"($\mu_1\dot\theta\sin^2\phi+c\,\mu_3\cos\phi$)";
  const Check driven = compare("rate of the vertical angular momentum", vertical,
                               Reader{R"($m\ell\alpha\lambda^2\sin\lambda t\cos\theta\sin\phi$)",
                                      [](const Sample& s) {
                                        const auto& b = s.body;
                                        return s.m * s.l * b.A * b.lambda * b.lambda * sin(b.lambda * s.t) *
                                               cos(s.q[0]) * sin(s.q[1]);
                                      }},
                               tops);
  const Check by_euler =
      compare(in_body, change,
              Reader{R"(Euler's equations with the torque of $-mg\mathbf k-m\ddot{\mathbf p}$)",
                     [](const Sample& s) { return euler_equations(s.top(), s.t); }},
              tops);
  claims.add(
      "euler_about_vertical", 3089,
      "Euler's equations with the torque of gravity alone still apply about the vertical",
      {.printed = reading(constant + " is a constant", constant + ", $c$ the spin", vertical, zero),
       .corrected = {"its rate is " + driven.right.by, {driven, by_euler}},
       .near_misses = {reading("Euler's equations with gravity alone", in_body, change,
                               {R"(Euler's equations with the torque of $-mg\mathbf k$ alone)",
                                [](const Sample& s) { return euler_equations(at_rest(s), s.t); }})},
       .why =
           R"(With the tip as origin the frame is accelerated, and $-m\ddot{\mathbf p}$ acts at the center of )"
           R"(mass beside gravity. Its torque about the tip has the vertical component )"
           R"($m\ell\alpha\lambda^2\sin\lambda t\cos\theta\sin\phi$: the vertical angular momentum is not )"
           R"(conserved, nor is the tilting moment gravity's alone. Only the spin $c$ stays constant.)",
       .kind = Fault::left_out,
       .root = no_torque});

  const Reader lagrange{"nested dual numbers on the points' $T-V$, tip moving",
                        [](const Sample& s) { return s.truth; }};
  const std::string accelerations = R"($(\ddot\theta,\ddot\phi,\ddot\psi)$)";
  claims.add(
      "handled_separately", 3091, "the motion of the tip may be handled apart from that of the top",
      {.printed = reading("the angles move as with a fixed tip", accelerations,
                          {"equations of the angles, the tip fixed",
                           [](const Sample& s) { return model_accelerations(at_rest(s), s.t); }},
                          lagrange),
       .corrected =
           {R"(the angles move with the torque of $-m\ddot{\mathbf p}$ at the center of mass)",
            {compare(accelerations,
                     Reader{R"(equations of the angles with the torque of $-m\ddot{\mathbf p}$)",
                            [](const Sample& s) { return model_accelerations(s.top(), s.t); }},
                     lagrange, tops),
             compare("rate of the angular momentum about the tip",
                     Reader{R"($\ell\,\boldsymbol\xi_3\times(-mg\mathbf k-m\ddot{\mathbf p})$)",
                            [](const Sample& s) {
                              auto torque = cross(s.top().axis(), s.top().force(s.t));
                              for (double& x : torque) x *= s.l;
                              return torque;
                            }},
                     Reader{R"($\sum m(\mathbf x-\mathbf p)\times(\ddot{\mathbf x}-\ddot{\mathbf p})$ over )"
                            R"(the points)",
                            [](const Sample& s) {
                              return momentum_rate_about(s, {0, 0, 0});
                            }},
                     tops)}},
       .near_misses = {reading(R"(with the torque of $+m\ddot{\mathbf p}$)", accelerations,
                               {"equations of the angles, the tip's acceleration with the other sign",
                                [](const Sample& s) {
                                  Top other = s.top();
                                  other.A = -other.A;
                                  return model_accelerations(other, s.t);
                                }},
                               lagrange)},
       .why =
           R"(That is so only where $\ddot{\mathbf p}=0$. The accelerated tip adds to gravity a horizontal )"
           R"(acceleration $\alpha\lambda^2\sin\lambda t$ that turns the top about its tip. With the values here )"
           R"(its axis is 0.016 rad from that of the fixed top after 4 s, 0.043 rad at twice the frequency, and )"
           R"(0.73 rad at 14.17 rad/s, the frequency of the nutation.)",
       .kind = Fault::left_out,
       .root = no_torque});

  const auto along_axis = [](const std::string& text, double by) {
    return Reader{text, [by](const Sample& s) {
                    const Vector<double> d = s.top().axis(), p = tip(s);
                    return values(p[0] + by * s.l * d[0], p[1] + by * s.l * d[1], by * s.l * d[2]);
                  }};
  };
  claims.formula(
      "tip_is_center", 3091, "the tip is the center of mass", tops,
      {.quantity = "center of mass",
       .truth = {R"($\sum m\mathbf x/m$ over the points)",
                 [](const Sample& s) {
                   Vector<double> sum{};
                   for (const PointOf<double>& p : s.body.points) {
                     const Vector<double> x = motion_of(s, p.x).x;
                     for (std::size_t i = 0; i < 3; ++i) sum[i] += p.m * x[i] / s.m;
                   }
                   return sum;
                 }},
       .printed = {R"($\mathbf p(t)$)", tip},
       .corrected = along_axis(
           R"($\mathbf p+\ell\,\boldsymbol\xi_3$, $\boldsymbol\xi_3$ the unit vector along the axis)", 1),
       .near_misses = {along_axis(R"($\mathbf p-\ell\,\boldsymbol\xi_3$)", -1)},
       .kind = Fault::term,
       .root = "tip for center of mass",
       .why =
           R"(The two are $\ell$ apart, always: the center of mass is at $\mathbf p+\ell\boldsymbol\xi_3$ and has )"
           R"(the acceleration $\ddot{\mathbf p}+\ell\ddot{\boldsymbol\xi}_3$. It is the tip that the exercise )"
           R"(moves.)"});

  const auto shaken = [](const std::string& text, double sign) {
    return Reader{text, [sign](const Sample& s) {
                    const double l = s.body.lambda;
                    return values(-sign * s.body.A * l * l * sin(l * s.t), 0, 0);
                  }};
  };
  claims.formula("tip_path", 3091, R"(the tip is at $(\alpha\sin\lambda t,0,0)$)", tops,
                 {.quantity = "acceleration of the tip",
                  .truth = {"from the forces on the center of mass and Euler's equations", tip_acceleration},
                  .printed = shaken(R"($-\alpha\lambda^2\sin\lambda t$ along $x$)", 1),
                  .near_misses = {shaken(R"($+\alpha\lambda^2\sin\lambda t$ along $x$)", -1)}});
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {no_torque,
       R"(Shaken at 14.17 rad/s, the frequency of its nutation, the top has tilted 0.73 rad (42 degrees) away )"
       R"(from the published motion after 4 s: a game that carries the unshaken motion along with the tip shows )"
       R"(a top that nobody can shake.)"},
      {"tip for center of mass",
       R"(A top drawn with its center of mass at $\mathbf p$ stands $\ell=0.25$ m too low along its axis: tilted )"
       R"(by 0.5 rad, its tip is 22 cm below the floor.)"}};
}

}  // namespace oddity::ex03_35
