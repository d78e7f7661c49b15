// MuJoCo 2.2 [manual: mujoco.readthedocs.io]: reduced coordinates, contacts as springs, in double.

#include <mujoco/mujoco.h>

#include <limits>
#include <sstream>

#include "solvers/engines/tree.hpp"

namespace oddity::engines {

namespace {

template <std::size_t n>
std::string text(const std::array<double, n>& numbers) {
  std::ostringstream out;
  out.precision(17);
  out << '"';
  for (const double x : numbers) out << x << ' ';
  out << "\" ";
  return out.str();
}
std::string text(double x) { return text(std::array{x}); }

/// A slide's coordinate. A tendon's length of -1 would mean none given: here lengths are far from that.
double slide_at_start(int body) { return 100.0 * (1 + body); }

/// A rod is two hinges across it at its one end and a ball joint at its other, in series: it has no mass.
/// What a slide turns is its armature.
std::string joint(const Joint& j) {
  const std::string anchor = "pos=" + text(j.at), axis = anchor + "axis=" + text(j.axis);
  if (j.kind == Joint::hinge) return "<joint type='hinge' " + axis + "/>";
  if (j.kind == Joint::cylinder)
    return "<joint type='slide' " + axis + "/><joint type='hinge' " + axis + "/>";
  if (j.kind == Joint::slide)
    return "<joint type='slide' name='" + std::to_string(j.b) + "' ref=" + text(slide_at_start(j.b)) +
           "armature=" + text(j.wheel) + axis + "/>";
  if (j.kind == Joint::ball) return "<joint type='ball' " + anchor + "/>";
  const Universal across(j);
  return "<joint type='hinge' " + anchor + "axis=" + text(across.first) + "/><joint type='hinge' " + anchor +
         "axis=" + text(across.second) + "/><joint type='ball' pos=" + text(j.end) + "/>";
}

/// The springs' ends on a body.
std::string sites(const World& world, int body) {
  std::string out;
  for (std::size_t i = 0; i < world.springs.size(); ++i) {
    const Spring& s = world.springs[i];
    if (s.a == body) out += "<site name='a" + std::to_string(i) + "' pos=" + text(s.at) + "/>";
    if (s.b == body) out += "<site name='b" + std::to_string(i) + "' pos=" + text(s.end) + "/>";
  }
  return out;
}

std::string springs(const World& world) {
  std::string out;
  for (std::size_t i = 0; i < world.springs.size(); ++i)
    out += "<spatial stiffness=" + text(world.springs[i].stiffness) +
           "springlength=" + text(world.springs[i].rest) + "><site site='a" + std::to_string(i) +
           "'/><site site='b" + std::to_string(i) + "'/></spatial>";
  return out;
}

std::string ropes(const World& world) {
  std::string out;
  for (const Rope& rope : world.ropes) {
    std::string slides;
    double at_start = 0;
    for (const auto& [body, factor] : rope.parts) {
      slides += "<joint joint='" + std::to_string(body) + "' coef=" + text(factor) + "/>";
      at_start += factor * slide_at_start(body);
    }
    out += "<fixed stiffness=" + text(rope.stiffness) +
           "springlength=" + text(rope.rest - rope.length + at_start) + ">" + slides + "</fixed>";
  }
  return out;
}

std::string body(const World& world, const Limb& limb) {
  const Body& b = world.bodies[static_cast<std::size_t>(limb.body)];
  const std::string pose = "pos=" + text(b.start.position) + "quat=" + text(b.start.orientation);
  std::string out = "<body name='" + std::to_string(limb.body) + "' " + pose + "><inertial " + pose +
                    "mass=" + text(b.mass) + "diaginertia=" + text(b.inertia) + "/>" +
                    (limb.joint ? joint(*limb.joint) : "<freejoint/>") + sites(world, limb.body);
  if (b.shape.kind == Shape::none) return out;
  return out + (b.shape.kind == Shape::ball ? "<geom type='sphere' " : "<geom type='box' ") + pose +
         "size=" + text(b.shape.half) + "friction=" + text(world.friction) + "/>";
}

/// All that hangs on a body. Elements may not be nested deeper than 100: what would be is in a file of its
/// own.
std::string limbs(const World& world, const std::vector<Limb>& all, int parent,
                  std::vector<std::string>& files, int depth = 1) {
  std::string out;
  for (const Limb& limb : all)
    if (limb.parent == parent)
      out += body(world, limb) + limbs(world, all, limb.body, files, depth + 1) + "</body>";
  if (depth % 50 || out.empty()) return out;
  files.push_back("<mujoco>" + out + "</mujoco>");
  return "<include file='" + std::to_string(files.size() - 1) + "'/>";
}

/// The last of the files is the whole.
std::vector<std::string> xml(const World& world, const std::string& options) {
  std::vector<std::string> files;
  std::string out = "<mujoco><compiler coordinate='global'/><option " + options + "/><worldbody>";
  if (world.floor != Vector{})
    out += "<geom type='plane' size='1 1 1' zaxis=" + text(world.floor) + "friction=" + text(world.friction) +
           "/>";
  files.push_back(out + sites(world, ground) + limbs(world, tree(world), ground, files) +
                  "</worldbody><tendon>" + springs(world) + ropes(world) + "</tendon></mujoco>");
  return files;
}

/// At the start.
double slide_speed(const World& world, const Joint& j) {
  const auto along = [&](int body) {
    const Vector& v = world.bodies[static_cast<std::size_t>(body)].start.velocity;
    return j.axis[0] * v[0] + j.axis[1] * v[1] + j.axis[2] * v[2];
  };
  return along(j.b) - (j.a == ground ? 0 : along(j.a));
}

/// As the manual's chapter on solver settings has them against slip.
std::string options(const std::string& variant) {
  if (variant == "defaults") return "";
  return "integrator='" + variant + "' cone='elliptic' impratio='10' tolerance='1e-12'";
}

mjModel* compiled(const std::vector<std::string>& sources) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    mj_makeEmptyFileVFS(files.get(), std::to_string(i).c_str(), static_cast<int>(sources[i].size()));
    std::ranges::copy(sources[i], static_cast<char*>(files->filedata[i]));
  }
  char error[500];
  mjModel* const model =
      mj_loadXML(std::to_string(sources.size() - 1).c_str(), files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (!model) throw NotExpressible(error);
  return model;
}

class InMuJoCo final : public Simulation {
 public:
  InMuJoCo(const World& world, const std::string& variant)
      : m_(compiled(xml(world, options(variant)))), d_(mj_makeData(m_)) {
    if (world.restitution != 0 && world.floor != Vector{})
      throw NotExpressible("no coefficient of restitution: contacts are springs with dampers");
    mju_user_warning = [](const char*) {};
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
      bodies_.push_back(mj_name2id(m_, mjOBJ_BODY, std::to_string(i).c_str()));
    set_gravity(world.gravity);
    start(world);
  }
  ~InMuJoCo() override {
    for (mjData* d : {d_, saved_})
      if (d) mj_deleteData(d);
    mj_deleteModel(m_);
  }
  InMuJoCo(const InMuJoCo&) = delete;
  InMuJoCo& operator=(const InMuJoCo&) = delete;

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
    // It starts anew from the world's start where it diverges, and warns.
    for (const int bad : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (d_->warning[bad].number) v[0] = std::numeric_limits<double>::quiet_NaN();
    return {{x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}, {v[3], v[4], v[5]}, {v[0], v[1], v[2]}};
  }
  bool has_springs() const override { return true; }
  bool save() override { return (saved_ = mj_copyData(saved_, m_, d_)) != nullptr; }
  void restore() override { mj_copyData(d_, m_, saved_), seen_ = false; }

 private:
  /// The joints' velocities are those that the bodies' momenta give.
  void start(const World& world) {
    mj_forward(m_, d_);
    seen_ = true;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const Body& b = world.bodies[i];
      mjtNum in_body[3], momentum[3];
      mju_rotVecMatT(in_body, b.start.spin.data(), d_->ximat + 9 * bodies_[i]);
      for (std::size_t k = 0; k < 3; ++k) in_body[k] *= b.inertia[k];
      mju_rotVecMat(momentum, in_body, d_->ximat + 9 * bodies_[i]);
      const auto& v = b.start.velocity;
      apply(static_cast<int>(i), {b.mass * v[0], b.mass * v[1], b.mass * v[2]},
            {momentum[0], momentum[1], momentum[2]}, b.start.position);
    }
    for (const Joint& j : world.joints)
      if (j.kind == Joint::slide)
        d_->qfrc_applied[m_->jnt_dofadr[mj_name2id(m_, mjOBJ_JOINT, std::to_string(j.b).c_str())]] +=
            j.wheel * slide_speed(world, j);
    mj_solveM(m_, d_, d_->qvel, d_->qfrc_applied, 1);
    mju_zero(d_->qfrc_applied, m_->nv);
    seen_ = false;
  }
  void apply(int body, const Vector& force, const Vector& torque, const Vector& at) {
    see();
    mj_applyFT(m_, d_, force.data(), torque.data(), at.data(), bodies_[static_cast<std::size_t>(body)],
               d_->qfrc_applied);
  }
  /// After a step the bodies are where they were before it, until their places are asked for.
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

Engine engine() {
  const std::string contacts = "; cone elliptic, impratio 10, tolerance 1e-12 (Modeling, Solver parameters)";
  return {"MuJoCo",
          mj_versionString(),
          "double",
          false,
          {{"defaults", "semi-implicit Euler; contacts are springs of 0.02 s, their friction is a pyramid's",
            1, true, "", "friction is a pyramid's"},
           {"implicit", "integrator implicit in velocities (Computation, Numerical integration)" + contacts,
            1, false},
           {"RK4", "integrator of 4th order (Computation, Numerical integration)" + contacts, 4, false}},
          [](const World& world, const std::string& variant, double) -> std::unique_ptr<Simulation> {
            return std::make_unique<InMuJoCo>(world, variant);
          },
          true};
}

}  // namespace oddity::engines
