#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <map>

#include "extras/engines/adapters/bullet.hpp"
#include "extras/engines/adapters/tree.hpp"

namespace oddity::engines {

/// A link at the start. Links between those of two bodies are massless.
struct Link {
  btTransform place = btTransform::getIdentity();
  btVector3 velocity{0, 0, 0}, spin{0, 0, 0};
  btScalar mass = 0;
  btVector3 inertia{0, 0, 0};
  int index = -1;

  Link() = default;
  explicit Link(const Body& b)
      : place(engines::place(b.start)),
        velocity(vector(b.start.velocity)),
        spin(vector(b.start.spin)),
        mass(btScalar(b.mass)),
        inertia(vector(b.inertia)) {}
  Link between(const btVector3& at, const btVector3& added_spin) const {
    Link link = *this;
    link.place.setOrigin(at), link.mass = 0, link.inertia.setZero();
    link.spin += added_spin;
    return link;
  }
  btVector3 velocity_at(const btVector3& at) const { return velocity + spin.cross(at - place.getOrigin()); }
};

/// The limbs of each multibody: a free body, or one on the ground, with everything that hangs on it.
std::vector<std::vector<Limb>> trees(const World&);

/// A multibody under construction.
class BulletTree {
 public:
  BulletTree(const World&, const std::vector<Limb>&);
  std::unique_ptr<btMultiBody> finished();
  const Link& link(int body) const { return links_.at(body); }

 private:
  void add(const Joint&, const Link& a, Link& b);
  void revolute(const Link& a, Link& b, const btVector3& at, const btVector3& axis);
  void spherical(const Link& a, Link& b, const btVector3& at);
  void started(Link&, const btVector3& speed);

  std::map<int, Link> links_;
  Link base_;
  std::unique_ptr<btMultiBody> body_;
  int next_ = 0;
  std::vector<btVector3> speeds_;
};

}  // namespace oddity::engines
