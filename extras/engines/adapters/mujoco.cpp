// MuJoCo 2.2 [manual: mujoco.readthedocs.io]: reduced coordinates, contacts as springs, in double.

#include <algorithm>
#include <limits>

#include "extras/engines/adapters/mujoco_model.hpp"
#include "extras/engines/adapters/simulation.hpp"
#include "solvers/turns.hpp"

namespace oddity::engines {

namespace {

class InMuJoCo final : public Simulation {
 public:
  InMuJoCo(const World& world, const std::string& variant)
      : m_(mujoco_model(world, variant)), d_(mj_makeData(m_)) {
    mju_user_warning = [](const char*) {};
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
      bodies_.push_back(mj_name2id(m_, mjOBJ_BODY, std::to_string(i).c_str()));
    set_gravity(world.gravity);
    set_off(world);
  }
  ~InMuJoCo() override {
    for (mjData* d : {d_, saved_})
      if (d) mj_deleteData(d);
    mj_deleteModel(m_);
  }

  void set_gravity(const Vector& g) override { std::ranges::copy(g, m_->opt.gravity); }
  void push(int body, const Vector& force, const Vector& at) override { apply(body, force, {}, at); }
  void step(double seconds) override {
    m_->opt.timestep = seconds;
    mj_step(m_, d_);
    mju_zero(d_->qfrc_applied, m_->nv);
    seen_ = false;
  }
  State state(int body) const override {
    see();
    const int i = bodies_[static_cast<std::size_t>(body)];
    const mjtNum *x = d_->xipos + 3 * i, *q = d_->xquat + 4 * i;
    mjtNum v[6];
    mj_objectVelocity(m_, d_, mjOBJ_BODY, i, v, 0);
    // MuJoCo restarts from the world's start where it diverges, and warns.
    for (const int bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (d_->warning[bad].number) v[0] = std::numeric_limits<double>::quiet_NaN();
    return {{x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}, {v[3], v[4], v[5]}, {v[0], v[1], v[2]}};
  }
  bool has_springs() const override { return true; }
  bool save() override { return (saved_ = mj_copyData(saved_, m_, d_)) != nullptr; }
  void restore() override { mj_copyData(d_, m_, saved_), seen_ = false; }

 private:
  /// Sets the joints' velocities from the bodies' momenta.
  void set_off(const World& world) {
    mj_forward(m_, d_);
    seen_ = true;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const Body& b = world.bodies[i];
      mjtNum in_body[3], momentum[3];
      mju_rotVecMatT(in_body, b.start.spin.data(), d_->ximat + 9 * bodies_[i]);
      for (std::size_t k = 0; k < 3; ++k) in_body[k] *= b.inertia[k];
      mju_rotVecMat(momentum, in_body, d_->ximat + 9 * bodies_[i]);
      apply(static_cast<int>(i), b.mass * b.start.velocity, {momentum[0], momentum[1], momentum[2]},
            b.start.position);
    }
    for (const Joint& j : world.joints)
      if (j.kind == Joint::slide)
        d_->qfrc_applied[m_->jnt_dofadr[mj_name2id(m_, mjOBJ_JOINT, std::to_string(j.b).c_str())]] +=
            j.wheel * (dot(j.axis, start(world, j.b).velocity) - dot(j.axis, start(world, j.a).velocity));
    mj_solveM(m_, d_, d_->qvel, d_->qfrc_applied, 1);
    mju_zero(d_->qfrc_applied, m_->nv);
    seen_ = false;
  }
  void apply(int body, const Vector& force, const Vector& torque, const Vector& at) {
    see();
    mj_applyFT(m_, d_, force.data(), torque.data(), at.data(), bodies_[static_cast<std::size_t>(body)],
               d_->qfrc_applied);
  }
  /// Updates the bodies' places, which lag a step behind otherwise.
  void see() const {
    if (!seen_) mj_kinematics(m_, d_), mj_comPos(m_, d_), mj_comVel(m_, d_);
    seen_ = true;
  }

  mjModel* m_;
  mjData* d_;
  mjData* saved_ = nullptr;
  mutable bool seen_ = false;
  std::vector<int> bodies_;
};

}  // namespace

Engine engine() { return {"MuJoCo", mj_versionString(), "double", false, make<InMuJoCo>, true}; }

}  // namespace oddity::engines
