#pragma once

#include <box2d/box2d.h>

#include "extras/engines/adapters/simulation.hpp"

namespace oddity::engines {

inline b2Vec2 vector(const Vector& v) { return {static_cast<float>(v[0]), static_cast<float>(v[1])}; }

/// A world in Box2D's terms. With `fine` there is no sleep and no skin, and slow bodies bounce too.
class Box2dWorld {
 public:
  Box2dWorld(const World&, bool fine);
  b2World& box2d() { return box2d_; }
  b2Body* operator[](int body) const { return bodies_[body]; }
  bool has_springs() const { return has_springs_; }

 private:
  void add(const Body&);
  void add(const Joint&);
  void join(auto joint, const Joint&, auto... more);
  void add(const Spring&);
  void add_floor(const b2Vec2& normal);
  void cover(b2Body*, const b2Shape&) const;

  bool fine_, has_springs_ = false;
  float friction_, restitution_;
  b2World box2d_;
  Handles<b2Body*> bodies_;
};

}  // namespace oddity::engines
