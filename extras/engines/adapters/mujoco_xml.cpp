// A world in MuJoCo's own language [manual: mujoco.readthedocs.io, XML reference].

#include "extras/engines/adapters/mujoco_xml.hpp"

#include <sstream>

#include "extras/engines/adapters/tree.hpp"

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

/// Initial coordinate of a slide. For MuJoCo a tendon length of -1 means none; these lengths are far from
/// that.
double slide_at_start(int body) { return 100.0 * (1 + body); }

/// A rod has no mass: it is two hinges across it at one end and a ball joint at the other, in series. The
/// wheel that a slide turns is the slide's armature.
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

/// The ends of springs on a body.
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
  const Body& b = body_of(world, limb.body);
  const std::string pose = "pos=" + text(b.start.position) + "quat=" + text(b.start.orientation);
  std::string out = "<body name='" + std::to_string(limb.body) + "' " + pose + "><inertial " + pose +
                    "mass=" + text(b.mass) + "diaginertia=" + text(b.inertia) + "/>" +
                    (limb.joint ? joint(*limb.joint) : "<freejoint/>") + sites(world, limb.body);
  if (b.shape.kind == Shape::none) return out;
  return out + (b.shape.kind == Shape::ball ? "<geom type='sphere' " : "<geom type='box' ") + pose +
         "size=" + text(b.shape.half) + "friction=" + text(world.friction) + "/>";
}

/// Everything that hangs on a body. Elements may not be nested deeper than 100: deeper ones go into a
/// separate file.
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

}  // namespace

std::vector<std::string> mujoco_xml(const World& world, const std::string& options) {
  std::vector<std::string> files;
  std::string out = "<mujoco><compiler coordinate='global'/><option " + options + "/><worldbody>";
  if (world.floor != Vector{})
    out += "<geom type='plane' size='1 1 1' zaxis=" + text(world.floor) + "friction=" + text(world.friction) +
           "/>";
  files.push_back(out + sites(world, ground) + limbs(world, tree(world), ground, files) +
                  "</worldbody><tendon>" + springs(world) + ropes(world) + "</tendon></mujoco>");
  return files;
}

}  // namespace oddity::engines
