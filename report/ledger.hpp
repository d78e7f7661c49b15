#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/tried.hpp"

/// The least model that a scene needs, and the value of its hard parameter at which each lesser model stops
/// being enough.
namespace oddity {

/// The first model of the ladder, from the least on, that holds for a need by any algorithm, with the least
/// work.
struct LeastModel {
  std::string says;  ///< "1 degree", "10 digits"
  Need need;
  std::optional<Tried> least;  ///< none: nothing here holds
};

/// Where a model stops being enough for what a game asks, to one in a thousand; both ends are judged by the
/// reference.
struct BreakEven {
  std::string model;
  double holds = 0, fails = 0;              ///< values of the scene's hard parameter
  double error_holds = 0, error_fails = 0;  ///< the model's at its best there, in the observables' unit
};

struct Ledger {
  std::string unit;  ///< of the observables
  std::string parameter, parameter_unit;
  double from = 0, to = 0;        ///< the values between which the break-evens were looked for
  std::vector<LeastModel> least;  ///< over 10 s at 60 frames a second: for a game, and for 10 digits
  std::vector<BreakEven> break_evens;
};

/// The ledger of the task's scene; nothing when it has no motion. Throws BadInput when no true motion is
/// known for the task's parameters.
std::optional<Ledger> ledger(const Task&, const Reference&);

}  // namespace oddity
