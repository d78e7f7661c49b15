#pragma once

#include <ode/ode.h>

#include "extras/engines/adapters/simulation.hpp"

namespace oddity::engines {

/// A world in ODE's terms.
class OdeWorld {
 public:
  OdeWorld(const World&, bool finite_rotations);
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;
  ~OdeWorld();
  dWorldID id() const { return world_; }
  dSpaceID space() const { return space_; }
  int size() const { return bodies_.size(); }
  dBodyID operator[](int body) const { return bodies_[body]; }
  void put(int body, const State&);

 private:
  void add(const Body&, bool finite_rotations);
  void add(const Joint&);

  dWorldID world_;
  dSpaceID space_;
  Handles<dBodyID> bodies_;
};

}  // namespace oddity::engines
