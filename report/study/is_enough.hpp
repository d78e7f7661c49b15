#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/study/choose.hpp"

/// Judges whether a user's method at a given step is good enough.
namespace oddity {

/// A method as the user named it: its algorithm, and a word of its model, empty for all models.
struct MethodAsked {
  std::string algorithm, model = {};
  double setting = 0;  ///< the step, in the scene's unit of time, or the tolerance
};

/// The algorithms of a scene's methods that a common name may mean: "RK4", "semi-implicit Euler".
std::vector<std::string> algorithms_meant(const std::string& name, const std::vector<Method>&);

/// Result of the method on one model of the scene.
struct Judgement {
  Candidate run;                 ///< on all starts, and its time
  bool faulted = false;          ///< the scene's own page shows the model to be wrong
  int failing = 0;               ///< number of failing starts
  double growth = not_a_number;  ///< error at the end over that at half time, on the requested start
  double drift = not_a_number;   ///< there, change of the conserved quantity, relative to its moving part
  double energy = not_a_number;  ///< there, error of the observed energy, relative to its moving part
  std::optional<double> stable_to = {};  ///< the longest stable step; 0: none; infinity: every one
};

struct IsEnough {
  Need need;  ///< as requested, at a frame rate for which the step divides a frame or is one
  std::string exercise, time_unit;
  std::vector<std::string> units = {};   ///< units of the motion's errors
  std::vector<Judgement> models = {};    ///< by ascending error; those shown to be wrong are last
  std::vector<std::string> starts = {};  ///< the first is the requested one

  bool holds() const { return models.front().run.holds(); }
};

/// Throws BadInput where no model has the method, and OutOfTime when the need's time limit is over.
IsEnough is_enough(const Task&, const Need&, const MethodAsked&, const Reference&,
                   const Price& = measured_price, const Progress& = {});

}  // namespace oddity
