#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "solvers/world.hpp"

/// Interface of an adapter to its engine. runner.cpp makes a program of it, which oddity runs as a child
/// process.
namespace oddity::engines {

inline const Body& body_of(const World& world, int body) {
  return world.bodies[static_cast<std::size_t>(body)];
}
/// Initial state of a body; the ground is at the origin.
inline State start(const World& world, int body) {
  return body == ground ? State{} : body_of(world, body).start;
}

/// An engine's handles of the bodies and of the ground.
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

/// A world simulated by an engine.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;
  /// Sets gravity [m/s^2] from now on.
  virtual void set_gravity(const Vector&) = 0;
  /// A force [N] on a point of the world that belongs to the body, during the next step only.
  virtual void push(int body, const Vector& force, const Vector& at) = 0;
  virtual void step(double seconds) = 0;
  virtual State state(int body) const = 0;
  /// Whether the engine simulates the world's springs itself. Otherwise the runner pushes for them.
  virtual bool has_springs() const { return false; }
  /// Saves the state to continue from later; false if the engine has no snapshots.
  virtual bool save() { return false; }
  /// Restores the saved state.
  virtual void restore() {}
};

/// Throws NotExpressible. The variant is one of the engine's in variants.json.
template <class In>
std::unique_ptr<Simulation> make(const World& world, const std::string& variant, double step) {
  if constexpr (std::is_constructible_v<In, const World&, const std::string&, double>)
    return std::make_unique<In>(world, variant, step);
  else
    return std::make_unique<In>(world, variant);
}

struct Engine {
  std::string name;       ///< "Bullet"
  std::string version;    ///< as reported by the library
  std::string precision;  ///< "float", "double"
  bool plane = false;     ///< it has only x and y
  std::unique_ptr<Simulation> (*make)(const World&, const std::string& variant, double step) = nullptr;
  bool ropes = false;  ///< it has slides and ropes; otherwise it gets no such world
};

/// The engine lacks a feature that the world needs: "no joint that keeps a distance".
struct NotExpressible : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Defined by each adapter.
Engine engine();

}  // namespace oddity::engines
