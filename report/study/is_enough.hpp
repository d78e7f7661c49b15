#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/study/choose.hpp"

/// Whether what someone runs is good enough: a method of their own at a step of their own.
namespace oddity {

/// A method as it was named: its algorithm, and a word of its model, or none for all models.
struct MethodAsked {
  std::string algorithm, model = {};
  double setting = 0;  ///< the step, in the scene's unit of time, or the tolerance
};

/// The algorithms of a scene's methods that a name may mean, as people call them: "RK4", "semi-implicit
/// Euler".
std::vector<std::string> algorithms_meant(const std::string& name, const std::vector<Method>&);

/// How the method does on one model of the scene.
struct Judgement {
  Candidate run;                 ///< on all starts, and its time
  bool faulted = false;          ///< the scene's own page shows the model to be wrong
  int failing = 0;               ///< of the starts
  double growth = not_a_number;  ///< from half the time to the end, of the error on the start asked for
  double drift = not_a_number;   ///< there, of what the model conserves, as a part of what moves in it
  double energy = not_a_number;  ///< there, how far what is seen is off its true energy, as a part of that
  std::optional<double> stable_to = {};  ///< the longest stable step; 0: none; infinity: every one
};

struct IsEnough {
  Need need;  ///< as asked, at so many frames a second that the step divides a frame, or is one
  std::string exercise, time_unit;
  std::vector<std::string> units = {};   ///< of the motion's errors
  std::vector<Judgement> models = {};    ///< from the smallest error on; those shown to be wrong are last
  std::vector<std::string> starts = {};  ///< the first is the one asked for

  bool holds() const { return models.front().run.holds(); }
};

/// Throws BadInput where no model has the method, and OutOfTime when the need's time limit is over.
IsEnough is_enough(const Task&, const Need&, const MethodAsked&, const Reference&,
                   const Price& = measured_price, const Progress& = {});

}  // namespace oddity
