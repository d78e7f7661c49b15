#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "reference/reference.hpp"

/// The integrators compared with loops written by hand: the same arithmetic on plain arrays, every loop over
/// components unrolled, nothing counted or checked. Both are compiled in one file with the same flags.
namespace oddity {

/// The state at the end, and the number of right-hand sides evaluated.
struct Run {
  std::vector<double> state;
  long evaluations = 0;
};

/// One algorithm on one model: by hand, with integrate_inlined, and as the scenes run it, with algorithm and
/// model compiled apart.
struct Race {
  std::string model;
  int states = 0;
  std::string algorithm;
  double limit = 0;  ///< largest ratio allowed; 0: no limit
  std::function<Run()> by_hand, inlined, precompiled;
};

/// Every algorithm with a fixed step, and Fehlberg 7(8), on models of 2, 4 and 6 states.
std::vector<Race> races();

/// A motion, the methods to compute it, and its closed form.
struct Contest {
  std::string says;
  std::string hand;  ///< the model of `races` whose right-hand side is the unit of cost
  Quantity to_end;   ///< integrated straight to the end: for the time and the final error
  Quantity through;  ///< these methods judged at many times of the motion: for the worst error
  double limit;      ///< the most right-hand sides' time that the best method may take
  std::string closed_form;
  std::function<double(double t)> at;  ///< the first observable by the closed form, prepared once for all
                                       ///< times
  double closed_limit;                 ///< likewise for one time
  double end;                          ///< s
};

/// The pendulum from 30 degrees over 10 s, and 3.2 orbits of eccentricity 0.9, at an error of 1e-9.
std::vector<Contest> contests(const Reference& truth);

}  // namespace oddity
