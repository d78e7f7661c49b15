#pragma once

#include <chipmunk/chipmunk.h>

#include "extras/engines/adapters/simulation.hpp"

namespace oddity::engines {

inline cpVect vector(const Vector& v) { return {v[0], v[1]}; }

/// A world in Chipmunk's terms.
class ChipmunkWorld {
 public:
  explicit ChipmunkWorld(const World&);
  cpSpace* space() const { return space_.get(); }
  cpBody* operator[](int body) const { return bodies_[body]; }

 private:
  void add(const Body&);
  void add(const Joint&);
  void add(const Spring&);
  void add(cpConstraint*, int a, int b);
  void add(cpShape*);
  cpVect in(int body, const cpVect& at) const { return cpBodyWorldToLocal(bodies_[body], at); }

  template <auto free>
  struct Freed {
    void operator()(auto* it) const { free(it); }
  };
  template <class T, auto free>
  using Owned = std::vector<std::unique_ptr<T, Freed<free>>>;

  double friction_, restitution_;
  // The space must be freed before its contents.
  Owned<cpBody, cpBodyFree> owned_;
  Owned<cpShape, cpShapeFree> shapes_;
  Owned<cpConstraint, cpConstraintFree> constraints_;
  std::unique_ptr<cpSpace, Freed<cpSpaceFree>> space_{cpSpaceNew()};
  Handles<cpBody*> bodies_{cpSpaceGetStaticBody(space_.get())};
};

}  // namespace oddity::engines
