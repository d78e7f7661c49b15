#pragma once

// Simbody's headers are C++17: in C++20 several == fit its indices equally well, unless this one exists.
namespace SimTK {
template <class Index>
requires requires(const Index& i) { i.isValidExtended(); }
bool operator==(const Index& a, const Index& b) { return int(a) == int(b); }
}  // namespace SimTK

#undef NDEBUG  // Debian's library is built without it, which makes some of its objects larger
#pragma GCC diagnostic ignored "-Warray-bounds"  // gcc 12 takes rows of its matrices for matrices
#include <Simbody.h>

#include "extras/engines/adapters/simulation.hpp"
#include "extras/engines/adapters/tree.hpp"

namespace oddity::engines {

inline SimTK::Vec3 vec(const Vector& a) { return {a[0], a[1], a[2]}; }
inline Vector vector(const SimTK::Vec3& a) { return {a[0], a[1], a[2]}; }

/// A world in Simbody's terms, with its topology realized.
class SimbodyWorld {
 public:
  explicit SimbodyWorld(const World&);
  const SimTK::MultibodySystem& system() const { return system_; }
  SimTK::MultibodySystem& system() { return system_; }
  const SimTK::Force::Gravity& gravity() const { return gravity_; }
  const SimTK::Force::DiscreteForces& pushes() const { return pushes_; }
  const SimTK::MobilizedBody& operator[](int body) const {
    return body == ground ? matter_.getGround() : bodies_[static_cast<std::size_t>(body)];
  }
  /// Initial state for an integrator.
  SimTK::State start(const World&) const;

 private:
  SimTK::MobilizedBody& of(int body) {
    return body == ground ? matter_.updGround() : bodies_[static_cast<std::size_t>(body)];
  }
  SimTK::MobilizedBody joined(const Limb&, const Body&, const SimTK::Transform& parent);
  void add(const Spring&, const World&);
  void lay(SimTK::MobilizedBody&, const Shape&, const World&);

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::Force::Gravity gravity_;
  SimTK::Force::DiscreteForces pushes_;
  std::vector<SimTK::MobilizedBody> bodies_;
};

}  // namespace oddity::engines
