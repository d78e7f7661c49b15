#pragma once

#include <string>
#include <vector>

#include "report/study/run.hpp"
#include "report/text/screen.hpp"

/// Taylor series compared with the rest of the catalog at high precision: on each scene, the same model to an
/// error of 1e-12 of the motion's size.
namespace oddity {

/// One side: its coarsest setting with a small enough error, there and at all finer ones that were tried.
struct SeriesEntrant {
  std::string method;
  double error = 0, seconds = 0;
  long evaluations = 0;
};

struct SeriesRace {
  std::string scene, model;
  SeriesEntrant series, other;  ///< the fastest of all others; no name: none reaches the error
  double ratio, half_width;     ///< time of the series over that of the other, measured in turn; NaN where
                                ///< one does not reach the error

  bool ahead() const { return !series.method.empty() && (other.method.empty() || ratio + half_width < 1); }
};

std::vector<SeriesRace> race_series(const Reference& truth, const Progress& progress = {});
/// The table, and the number of scenes on which the series are faster; empty without races.
std::string series_text(const std::vector<SeriesRace>&, const Screen&);

}  // namespace oddity
