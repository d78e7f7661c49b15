#pragma once

#include <string>
#include <vector>

#include "report/study/run.hpp"
#include "report/text/screen.hpp"

/// Taylor series beside the rest of the catalog where many digits are asked for: on each scene, the same
/// model to an error of 1e-12 of the motion's size.
namespace oddity {

/// One side: its coarsest setting whose error is small enough, there and at all finer ones that were tried.
struct SeriesEntrant {
  std::string method;
  double error = 0, seconds = 0;
  long evaluations = 0;
};

struct SeriesRace {
  std::string scene, model;
  SeriesEntrant series, other;  ///< the fastest of all others; no name: nobody gets there
  double ratio, half_width;     ///< of the times in turn, series to other; NaN where one does not get there

  bool ahead() const { return !series.method.empty() && (other.method.empty() || ratio + half_width < 1); }
};

std::vector<SeriesRace> race_series(const Reference& truth, const Progress& progress = {});
/// The table, and on how many scenes the series are ahead; empty for no races.
std::string series_text(const std::vector<SeriesRace>&, const Screen&);

}  // namespace oddity
