#pragma once

#include <array>
#include <vector>

#include "problem/expression.hpp"
#include "problem/file.hpp"
#include "solvers/world.hpp"

/// A problem's motion as other people's engines have it: its bodies, joints and springs, and what is seen of
/// them.
namespace oddity::problem {

class Staged {
 public:
  /// Throws WrongFile for what is wrong in the file's staging.
  explicit Staged(const File&);

  /// With these values of the parameters, in their units.
  engines::Staging with(const std::vector<double>& parameters) const;

 private:
  class Making;
  using Vector = std::array<Expression, 3>;
  struct Body {
    Expression mass, turn;
    Vector inertia, place, velocity, spin;
  };
  struct Joint {
    engines::Joint::Kind kind;
    int a, b;
    Vector at, axis, end;
  };
  struct Spring {
    int a, b;
    Expression stiffness, rest;
    Vector at, end;
  };

  std::vector<long double> sizes_;  ///< of the parameters' units
  std::shared_ptr<Graph> graph_ = std::make_shared<Graph>();
  Vector gravity_;
  std::vector<Body> bodies_;
  std::vector<Joint> joints_;
  std::vector<Spring> springs_;
  std::vector<Expression> observed_;
  std::string differs_;
};

}  // namespace oddity::problem
