#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "solvers/world.hpp"

/// What an adapter gives of its engine. runner.cpp makes a program of it, which oddity runs as a child.
namespace oddity::engines {

inline const Body& body_of(const World& world, int body) {
  return world.bodies[static_cast<std::size_t>(body)];
}
/// Where a body starts; the ground at the origin.
inline State start(const World& world, int body) {
  return body == ground ? State{} : body_of(world, body).start;
}

/// What an engine has for each of the bodies, and for the ground.
template <class T>
class Handles {
 public:
  explicit Handles(T of_ground = {}) : ground_(of_ground) {}
  void add(T body) { bodies_.push_back(body); }
  T operator[](int body) const { return body == ground ? ground_ : bodies_[static_cast<std::size_t>(body)]; }
  int size() const { return static_cast<int>(bodies_.size()); }

 private:
  T ground_;
  std::vector<T> bodies_;
};

/// A world in an engine's hands.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;
  /// m/s^2, from now on.
  virtual void set_gravity(const Vector&) = 0;
  /// A force [N] on a point of the world that belongs to the body, during the next step alone.
  virtual void push(int body, const Vector& force, const Vector& at) = 0;
  virtual void step(double seconds) = 0;
  virtual State state(int body) const = 0;
  /// The engine has the world's springs itself: nobody pushes for them.
  virtual bool has_springs() const { return false; }
  /// Keeps what is needed to go on from here; false where the engine offers nothing for it.
  virtual bool save() { return false; }
  /// Back to what was saved.
  virtual void restore() {}
};

/// Throws NotExpressible. The variant is one of those that variants.json has of the engine.
template <class In>
std::unique_ptr<Simulation> make(const World& world, const std::string& variant, double step) {
  if constexpr (std::is_constructible_v<In, const World&, const std::string&, double>)
    return std::make_unique<In>(world, variant, step);
  else
    return std::make_unique<In>(world, variant);
}

struct Engine {
  std::string name;       ///< "Bullet"
  std::string version;    ///< as the library says it
  std::string precision;  ///< "float", "double"
  bool plane = false;     ///< it knows x and y alone
  std::unique_ptr<Simulation> (*make)(const World&, const std::string& variant, double step) = nullptr;
  bool ropes = false;  ///< it has slides and ropes; else it is not asked for them
};

/// The engine lacks what the world asks for: "no joint that keeps a distance".
struct NotExpressible : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each adapter defines it.
Engine engine();

}  // namespace oddity::engines
