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

/// Dense maps, and tables of choices: one scene over one or two of its parameters and the step, in pieces of
/// work that many threads and machines share.
namespace oddity::sweep {

/// One number that varies from cell to cell, evenly or by a factor.
struct Axis {
  std::string name;  ///< name of a parameter, or "step", or "tolerance"
  std::string unit;
  double from = 0, to = 0;
  int count = 1;
  bool by_factor = false;

  double at(int cell) const;
};

/// The question for every cell.
struct Asked {
  std::string exercise;      ///< its number, or the name of a problem's file
  std::string problem = {};  ///< the text of that file, which is part of the plan
  std::vector<std::pair<std::string, double>> parameters;  ///< all of them
  std::string model, algorithm;  ///< empty: the choice at every cell, by counted evaluations
  double setting = 0;            ///< value of the method's step or tolerance, if it is no axis
  Need need = {.error = 1};
  FramesAsked frames = {};  ///< as they come
  std::string kick = {};    ///< "t=1s,theta'=+2"; empty: none
  int looks = 0;            ///< within the horizon; 0: at every frame
  std::vector<Axis> axes;   ///< across and, if there are two, upward
  bool every_cell = false;  ///< otherwise only where neighbours have different outcomes
};

/// A plan is a file that every machine reads.
struct Plan {
  Asked asked;
  std::vector<long> first_tile;  ///< first tile of each chunk; the last entry is the number of tiles
  std::vector<double> seconds;   ///< estimate for each chunk
  std::string fingerprint;       ///< program, tables and question

  int width() const { return asked.axes[0].count; }
  int height() const { return asked.axes.size() < 2 ? 1 : asked.axes[1].count; }
  long tiles() const { return first_tile.back(); }
  Cells tile(long) const;
  std::size_t chunks() const { return seconds.size(); }
};

/// The exercise of the sweep. Throws BadInput if this program lacks it.
const Entry& entry_of(const Asked&);

/// Sets the frames and kicks of the need. Throws BadInput as `need_of` does.
void set_frames_and_kicks(Asked&);

/// Whether no cell is guessed from its neighbours: on request, and on a small map.
bool looks_at_every_cell(const Asked&);

/// Endings of a cell whose reference cannot be found, or that has no such method.
inline constexpr std::string_view no_truth = "truth not known", no_method = "no such method there";
/// Ending of a cell at which nothing is chosen.
inline constexpr std::string_view nothing_holds = "nothing holds";

/// Time between two looks at the motion, in the scene's unit of time.
double between_looks(const Asked&);

/// Largest relative shortening of a fixed step of these cells, so that a whole number of steps fills the time
/// between two looks. It is 0 if the method's steps do not end at each look.
double most_shortened(const Asked&);

/// Computes one cell after the other; neighbours share their references. Any exception of a cell except
/// OutOfTime becomes its ending.
Look looks_at(const Asked&, const Reference&);

/// Divides the sweep into chunks of about this many seconds, as estimated from a few cells measured now.
/// Throws BadInput for an impossible question: a method that is not the scene's, parameters out of their
/// ranges, a step longer than the time between two looks.
Plan planned(const Asked&, const Reference&, const std::filesystem::path& tables, double seconds_a_chunk);

/// Text in one line.
std::string to_json(const Asked&);
std::string to_json(const Plan&);
/// Throws BadInput if the text, which comes from `place`, is no plan.
Plan plan_from_json(const std::string& text, const std::string& place);
/// Throws BadInput if the file is no plan, or belongs to another program or other tables.
Plan read_plan(const std::filesystem::path& file, const std::filesystem::path& tables);

}  // namespace oddity::sweep
