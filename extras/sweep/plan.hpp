#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "extras/sweep/tile.hpp"
#include "reference/reference.hpp"
#include "report/study/frames.hpp"
#include "report/study/need.hpp"
#include "report/study/run.hpp"

/// Dense maps, and tables of what to choose: one scene over one or two of its parameters and the step, in
/// pieces of work that many threads and machines share.
namespace oddity::sweep {

/// One number that varies, from cell to cell evenly, or by a factor.
struct Axis {
  std::string name;  ///< of a parameter, or "step", or "tolerance"
  std::string unit;
  double from = 0, to = 0;
  int count = 1;
  bool by_factor = false;

  double at(int cell) const;
};

/// What is asked of every cell.
struct Asked {
  std::string exercise;      ///< its number, or the name of a problem's file
  std::string problem = {};  ///< the text of that file, which is part of the plan
  std::vector<std::pair<std::string, double>> parameters;  ///< all of them
  std::string model, algorithm;  ///< empty: what is chosen at every cell, by counted evaluations
  double setting = 0;            ///< of the method's step or tolerance, where it is no axis
  Need need = {.error = 1};
  FramesAsked frames = {};  ///< as they come
  std::string kick = {};    ///< "t=1s,theta'=+2"; empty: none
  int looks = 0;            ///< within the horizon; 0: at every frame
  std::vector<Axis> axes;   ///< across and, unless there is one alone, upward
  bool every_cell = false;  ///< else only where neighbours end differently
};

/// A plan, once made, is a file that every machine reads.
struct Plan {
  Asked asked;
  std::vector<long> first_tile;  ///< of each chunk; the last one is the number of tiles
  std::vector<double> seconds;   ///< that each chunk is estimated to take
  std::string fingerprint;       ///< of the program, of the tables, and of what is asked

  int width() const { return asked.axes[0].count; }
  int height() const { return asked.axes.size() < 2 ? 1 : asked.axes[1].count; }
  long tiles() const { return first_tile.back(); }
  Cells tile(long) const;
  std::size_t chunks() const { return seconds.size(); }
};

/// The exercise that is swept over. Throws BadInput where this program does not have it.
const Entry& entry_of(const Asked&);

/// Gives the need its frames and its kicks. Throws BadInput as `need_of` does.
void set_frames_and_kicks(Asked&);

/// Whether no cell is guessed from its neighbours: where that is asked for, and on a small map.
bool looks_at_every_cell(const Asked&);

/// How a cell ends whose true motion cannot be found, or which has no such method.
inline constexpr std::string_view no_truth = "truth not known", no_method = "no such method there";
/// How one ends at which nothing is chosen.
inline constexpr std::string_view nothing_holds = "nothing holds";

/// Between two looks at the motion, in the scene's unit of time.
double between_looks(const Asked&);

/// By which part of itself a fixed step of these cells is shortened at most, so that a whole number of steps
/// fills the time between two looks; 0 where the method's step does not end at each look.
double most_shortened(const Asked&);

/// A look at one cell after the other; neighbours share their truths. Whatever a cell throws but OutOfTime is
/// how it ends.
Look looks_at(const Asked&, const Reference&);

/// In chunks of about so many seconds, by what cells here and there took just now. Throws BadInput for what
/// cannot be asked: a method that is not the scene's, parameters out of their ranges, a step that is longer
/// than the time between two looks.
Plan planned(const Asked&, const Reference&, const std::filesystem::path& tables, double seconds_a_chunk);

/// In one line.
std::string to_json(const Asked&);
std::string to_json(const Plan&);
/// Throws BadInput when the text, which is that of `place`, is no plan.
Plan plan_from_json(const std::string& text, const std::string& place);
/// Throws BadInput when the file is no plan, or is of another program or other tables.
Plan read_plan(const std::filesystem::path& file, const std::filesystem::path& tables);

}  // namespace oddity::sweep
