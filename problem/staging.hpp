#pragma once

#include <array>
#include <vector>

#include "problem/expression.hpp"
#include "problem/file.hpp"
#include "solvers/world.hpp"

/// A problem's motion for third-party engines: its bodies, joints and springs, and the observables of these.
namespace oddity::problem {

class Staged {
 public:
  /// Throws WrongFile if the file's staging is wrong.
  explicit Staged(const File&);

  /// With these values of the parameters, in their units. Throws WrongFile where an engine could not take it.
  engines::Staging with(const std::vector<double>& parameters) const;

 private:
  class Making;
  struct Number {
    Expression value = 0;
    Place place = {};
  };
  using Vector = std::array<Number, 3>;
  struct Body {
    Number mass, turn;
    Vector inertia, place, velocity, spin;
  };
  struct Joint {
    engines::Joint::Kind kind;
    int a, b;
    Vector at, axis, end;
  };
  struct Spring {
    int a, b;
    Number stiffness, rest;
    Vector at, end;
  };

  const Source* source_;
  std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
  Vector gravity_;
  std::vector<Body> bodies_;
  std::vector<Joint> joints_;
  std::vector<Spring> springs_;
  std::vector<Expression> observed_;
  std::string differs_;
};

}  // namespace oddity::problem
