#include "extras/sweep/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <tuple>

#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/study/choose.hpp"
#include "report/study/earlier_results.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/kicks.hpp"
#include "report/study/sibling_program.hpp"
#include "report/study/whole_in_json.hpp"
#include "solvers/ode/steps_in.hpp"

namespace oddity::sweep {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// Maps up to this size are computed completely. One cell in a thousand of so few predicts nothing about the
/// others, and all of them take no longer than one tile of a large map.
constexpr long small_map = 4096;
/// A merged map takes 19 bytes a cell, all in memory: this many take 38 GB, and a year on one thread at 16 ms
/// each.
constexpr double most_cells = 2e9;
constexpr int format = 1;

/// "exercise 3.5", or a file's name.
std::string name_of(const Asked& asked) {
  return asked.problem.empty() ? "exercise " + asked.exercise : asked.exercise;
}

const Scene& scene_of(const Asked& asked) {
  const auto& scene = entry_of(asked).exercise.scene;
  if (!scene) throw BadInput(name_of(asked) + " has no motion to sweep over");
  return *scene;
}

Task task_of(const Asked& asked) {
  Task task(entry_of(asked));
  for (const auto& [name, value] : asked.parameters) task.parameters.set(name, value);
  return task;
}

Horizon horizon_of(const Asked& asked) {
  return asked.looks == 0 ? oddity::horizon_of(asked.need) : Horizon{asked.need.horizon, asked.looks};
}

/// Whether the axis is a method's step or tolerance.
bool is_setting(const Axis& axis) { return axis.name == "step" || axis.name == "tolerance"; }

/// Cost of a method in evaluations.
Time counted_price(const Method& method, double setting) {
  return {1e-9 * static_cast<double>(method.run(setting).evaluations), 0};
}

class Looks {
 public:
  Looks(const Asked& asked, const Reference& truth) : asked_(asked), truth_(truth) {}

  Ended operator()(int x, int y) {
    Task task = task_of(asked_);
    double setting = asked_.setting;
    std::vector<double> key;
    for (std::size_t i = 0; i < asked_.axes.size(); ++i) {
      const double value = asked_.axes[i].at(i == 0 ? x : y);
      if (is_setting(asked_.axes[i])) {
        setting = value;
      } else {
        task.parameters.set(asked_.axes[i].name, value);
        key.push_back(value);
      }
    }
    try {
      return asked_.algorithm.empty() ? chosen(task) : tried(task, key, setting);
    } catch (const OutOfTime&) {
      throw;
    } catch (const std::bad_alloc&) {  // lack of memory belongs to this machine, not to the cell
      throw;
    } catch (const std::exception&) {
      return {std::string(no_truth)};
    }
  }

 private:
  Ended chosen(const Task& task) const {
    const Choice choice = choose(task, asked_.need, truth_, counted_price);
    if (!choice.chosen) return {std::string(nothing_holds)};
    return {choice.chosen->model + ", " + choice.chosen->algorithm, choice.chosen->error,
            choice.chosen->evaluations_per_frame};
  }

  Ended tried(const Task& task, const std::vector<double>& key, double setting) {
    const Quantity& seen = *motion_at(task.parameters, key);
    const Method* method = method_of(seen, asked_.model, asked_.algorithm);
    if (!method) return {std::string(no_method)};
    const Trial trial = run(seen, *method, setting);
    const double known_to = asked_.need.kicks ? seen.reference_error / seen.need.allowed : 0;
    return {std::string(name_of(trial.outcome)), std::max(trial.in_needs, known_to),
            static_cast<double>(trial.answer.evaluations)};
  }

  std::shared_ptr<const Quantity> motion_at(const Parameters& parameters, const std::vector<double>& key) {
    constexpr std::size_t most_kept = 256;
    if (const auto known = motions_.find(key); known != motions_.end()) return known->second;
    if (motions_.size() >= most_kept) motions_.clear();
    return motions_[key] = std::make_shared<const Quantity>(
               known_motion(scene_of(asked_), parameters, horizon_of(asked_), asked_.need, truth_));
  }

  const Asked asked_;
  const Reference truth_;
  std::map<std::vector<double>, std::shared_ptr<const Quantity>> motions_;
};

// ---- how long it takes ------------------------------------------------------------------------------------

double seconds_of(const std::function<void()>& work) {
  const auto begun = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

/// Side of a tile, in cells. A choice takes a second in one cell and a minute in another, in chaos: many
/// small tiles are shared evenly. Cells of one method share their references.
int tile_side(const Asked& asked) {
  return !asked.algorithm.empty() ? 64 : looks_at_every_cell(asked) ? 4 : 16;
}

long tiles_of(int cells, int side) { return (cells + side - 1) / side; }

/// Time of a tile at each height, and of a column's reference: from cells of a few columns, at most a row of
/// tiles apart.
struct Speed {
  std::vector<double> tiles;  ///< s, from below
  double truth = 0;           ///< s for a column, or for each cell if no axis is the method's setting

  Speed(const Asked& asked, const Reference& truth_source, int width, int height) {
    const auto look = looks_at(asked, truth_source);
    const bool shared = std::ranges::any_of(asked.axes, is_setting);
    const int side = tile_side(asked);
    const long rows = tiles_of(height, side), probes = std::min<long>(rows, 8);
    std::vector<double> at_probe;
    for (long probe = 0; probe < probes; ++probe) {
      const int y = probes == 1 ? height / 2 : static_cast<int>((height - 1) * probe / (probes - 1));
      const int x = static_cast<int>((2 * probe + 1) * width / (2 * probes));
      const double first = seconds_of([&] { look(x, y); });
      const double again = seconds_of([&] { look(x, y); });  // the reference is known now
      truth += std::max(0.0, first - again) / static_cast<double>(probes);
      at_probe.push_back(std::max(1e-9, shared ? again : first));
    }
    const bool every_cell = looks_at_every_cell(asked);
    const double looked = every_cell ? 1 : 0.02;
    const double cells = std::min(width, side) * std::min(height, side);
    for (long row = 0; row < rows; ++row)
      tiles.push_back(between(at_probe, (static_cast<double>(row) + 0.5) / static_cast<double>(rows)) *
                      std::max(4.0, looked * cells));
    truth *= shared ? (every_cell ? 1 : 0.3) : 0;
  }

 private:
  /// Interpolates geometrically at a part of the way from the first to the last, as steps do.
  static double between(const std::vector<double>& seconds, double part) {
    const double place = part * static_cast<double>(seconds.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), seconds.size() - 1);
    const double next = seconds[std::min(i + 1, seconds.size() - 1)];
    return seconds[i] * std::pow(next / seconds[i], place - static_cast<double>(i));
  }
};

void divide(Plan& plan, const Speed& speed, double seconds_a_chunk) {
  const int side = tile_side(plan.asked);
  const long columns = tiles_of(plan.width(), side), rows = tiles_of(plan.height(), side);
  double all = 0;
  for (double tile : speed.tiles) all += tile;
  const double column = all + side * speed.truth;
  const double most =
      std::clamp(column * static_cast<double>(columns) / 64, std::min(1.0, seconds_a_chunk), seconds_a_chunk);
  double seconds = 0;
  plan.first_tile = {0};
  for (long tile = 0; tile < columns * rows; ++tile) {
    const bool enters = seconds == 0 || tile % rows == 0;  // a new column, whose references have to be found
    seconds += speed.tiles[static_cast<std::size_t>(tile % rows)] + (enters ? side * speed.truth : 0);
    if (seconds < most && tile + 1 < columns * rows) continue;
    plan.first_tile.push_back(tile + 1);
    plan.seconds.push_back(seconds);
    seconds = 0;
  }
}

// ---- what may be requested ------------------------------------------------------------------------------

void require_axis(const Asked& asked, const Axis& axis, const Method* method) {
  const std::string name = "the axis " + axis.name;
  if (axis.count < 2 || axis.count > 1'000'000) throw BadInput(name + " needs from 2 to 1000000 cells");
  if (!(axis.from < axis.to))
    throw BadInput(name + " goes upward, and not from " + format_shortest(axis.from) + " to " +
                   format_shortest(axis.to));
  if (axis.by_factor && !(axis.from > 0 && axis.to > 0))
    throw BadInput(name + " goes by a factor, and needs ends above zero");
  if (is_setting(axis)) {
    if (!method || method->resolution.name != axis.name)
      throw BadInput(
          name + ": " +
          (method ? asked.algorithm + " has " +
                        (method->resolution.name.empty() ? "no setting" : "a " + method->resolution.name)
                  : "the chosen method has its own setting"));
    if (!(axis.from > 0 && axis.to > 0)) throw BadInput(name + " needs ends above zero");
    return;
  }
  Task task = task_of(asked);
  for (int cell = 0; cell < axis.count; ++cell) task.parameters.set(axis.name, axis.at(cell));
}

/// The requested method of the scene's motion; null if cells show the chosen one.
const Method* method_asked(const Asked& asked, const Quantity& seen) {
  return asked.algorithm.empty() ? nullptr : method_of(seen, asked.model, asked.algorithm);
}

Quantity motion_asked(const Asked& asked) {
  return motion_at_frames(scene_of(asked), task_of(asked).parameters, horizon_of(asked), Reference::nothing(),
                          asked.need.kicks);
}

/// Whether the method's steps end at each look. Then a step of twice the time between looks is shortened to
/// it, and does the same work. Other methods step in another variable than time.
bool ends_at_looks(const Quantity& seen, const Method& method, double between) {
  return run(seen, method, 2 * between).answer.evaluations == run(seen, method, between).answer.evaluations;
}

/// All steps of the cells; empty for a method without steps.
std::vector<double> steps_of(const Asked& asked, const Method* method) {
  if (!method || method->resolution.name != "step") return {};
  const auto axis = std::ranges::find_if(asked.axes, is_setting);
  if (axis == asked.axes.end()) return {asked.setting};
  std::vector<double> steps;
  for (int cell = 0; cell < axis->count; ++cell) steps.push_back(axis->at(cell));
  return steps;
}

/// Refuses longer steps: they would be shortened, and the map would show them at the wrong place.
void require_steps_between_looks(const Asked& asked, const Quantity& seen, const Method* method) {
  const std::vector<double> steps = steps_of(asked, method);
  if (steps.empty()) return;
  const double between = between_looks(asked), longest = *std::ranges::max_element(steps);
  if (longest <= between * (1 + 1e-12) || !ends_at_looks(seen, *method, between)) return;
  const std::string unit = " " + std::string(scene_of(asked).axes.time);
  const double looks = std::floor(asked.need.horizon / longest * (1 + 1e-12));
  throw BadInput(
      (std::ranges::any_of(asked.axes, is_setting) ? "the axis step goes up to " : "--setting is ") +
      format_significant(longest, 6) + unit + ", and a step is no longer than the " +
      format_significant(between, 3) + unit + " between two looks at the motion: " +
      (looks >= 1 ? "ask for shorter steps, or for --looks " + format_shortest(looks)
                  : "it is to be no longer than the horizon either, " + format_shortest(asked.need.horizon) +
                        unit + ", as with --looks 1"));
}

bool is_positive(double x) { return x > 0 && std::isfinite(x); }

/// Checks a need that may come from a file made elsewhere, like one from the command line.
void require_need(const Asked& asked) {
  const Need& need = asked.need;
  const double frames = need.horizon * need.frames_per_second;
  if (!is_positive(need.horizon) || !is_positive(need.frames_per_second) || !(frames >= 1) ||
      frames > most_frames || asked.looks > most_frames)
    throw BadInput("a horizon of " + format_shortest(need.horizon) + " at " +
                   format_shortest(need.frames_per_second) + " frames in a unit of time, or with " +
                   std::to_string(asked.looks) + " looks, is not from one look at the motion to a million");
  if (!is_positive(need.error) ||
      !std::ranges::all_of(need.errors, is_positive, [](const auto& e) { return e.second; }))
    throw BadInput("an error that is asked for must be positive");
  if (!(asked.setting >= 0) || !std::isfinite(asked.setting))
    throw BadInput("a setting must be positive, and is " + format_shortest(asked.setting));
  if (asked.looks > 0 && asked.algorithm.empty())
    throw BadInput(
        "--looks is of a method, given by --model and --algorithm; a chosen method is judged at every frame: "
        "--fps is their rate");
}

void require_cells(const Asked& asked) {
  double cells = 1;
  for (const Axis& axis : asked.axes) cells *= axis.count;
  if (cells > most_cells)
    throw BadInput(
        "a map of " + format_significant(cells, 3) + " cells is too large: of more than " +
        format_significant(most_cells, 3) +
        " it takes over 38 GB of memory to put the chunks together; ask for fewer, or for maps of parts");
}

void require_sense(const Asked& asked) {
  require_need(asked);
  require_cells(asked);
  if (asked.axes.empty() || asked.axes.size() > 2) throw BadInput("a sweep is over one or two numbers");
  if (asked.axes.size() == 2 && asked.axes[0].name == asked.axes[1].name)
    throw BadInput("the axis " + asked.axes[0].name + " is given twice");
  const Quantity seen = motion_asked(asked);
  const Method* method = method_asked(asked, seen);
  if (!asked.algorithm.empty() && !method) {
    std::string names;
    for (const Method& m : seen.methods)
      names += "\n  --model \"" + m.model + "\" --algorithm \"" + m.algorithm + "\"";
    throw BadInput(name_of(asked) + " has no method \"" + asked.model + ", " + asked.algorithm +
                   "\"; it has:" + names);
  }
  for (const Axis& axis : asked.axes) require_axis(asked, axis, method);
  if (method && !method->resolution.name.empty() && std::ranges::none_of(asked.axes, is_setting) &&
      !(asked.setting > 0))
    throw BadInput(asked.algorithm + " needs a " + method->resolution.name + ": as an axis, or by --setting");
  require_steps_between_looks(asked, seen, method);
}

// ---- the file ---------------------------------------------------------------------------------------------

std::string fingerprint_of(const std::string& asked, const fs::path& tables) {
  return made_by(tables) + ", asked " + checksum(asked);
}

Json from(const Axis& axis) {
  return {{"name", axis.name}, {"unit", axis.unit},   {"from", axis.from},
          {"to", axis.to},     {"count", axis.count}, {"by_factor", axis.by_factor}};
}

Json from(const Asked& asked) {
  Json json{{"exercise", asked.exercise}, {"parameters", Json::object()}};
  if (!asked.problem.empty()) json["problem"] = asked.problem;
  for (const auto& [name, value] : asked.parameters) json["parameters"][name] = value;
  json["model"] = asked.model;
  json["algorithm"] = asked.algorithm;
  json["setting"] = asked.setting;
  json["criterion"] = criterion_names[static_cast<std::size_t>(asked.need.criterion)];
  json["error"] = asked.need.error;
  json["errors"] = Json::object();
  for (const auto& [unit, error] : asked.need.errors) json["errors"][unit] = error;
  json["horizon"] = asked.need.horizon;
  json["frames_per_second"] = asked.need.frames_per_second;
  if (!says(asked.frames).empty())
    json["frames"] = {{"jitter", asked.frames.jitter},
                      {"drop", asked.frames.drop},
                      {"longest", std::isfinite(asked.frames.longest) ? Json(asked.frames.longest) : Json()},
                      {"trace", asked.frames.trace},
                      {"seed", std::lround(asked.frames.seed)}};
  if (!asked.kick.empty()) json["kick"] = asked.kick;
  json["looks"] = asked.looks;
  json["every_cell"] = asked.every_cell;
  for (const Axis& axis : asked.axes) json["axes"].push_back(from(axis));
  return json;
}

Criterion criterion_in(const Json& json) {
  const auto found = std::ranges::find(criterion_names, json.at("criterion").get<std::string>());
  if (found == criterion_names.end()) throw std::runtime_error("its criterion is unknown");
  return static_cast<Criterion>(found - criterion_names.begin());
}

FramesAsked frames_in(const Json& json) {
  FramesAsked frames{.jitter = json.at("jitter"), .drop = json.at("drop")};
  if (!json.at("longest").is_null()) frames.longest = json.at("longest");
  frames.trace = json.at("trace").get<std::vector<double>>();
  frames.seed = whole<int>(json.at("seed"));
  const auto is_part = [](double x) { return x == 0 || (x >= least_part && x <= most_part); };
  const auto is_length = [](double x) { return x >= least_frame && x <= most_frame; };
  const bool sensible = is_part(frames.jitter) && is_part(frames.drop) &&
                        (std::isinf(frames.longest) || is_length(frames.longest)) &&
                        std::ranges::all_of(frames.trace, is_length) && frames.seed >= 0 &&
                        frames.seed <= most_seed;
  if (!sensible) throw std::runtime_error("its frames are not valid");
  return frames;
}

Asked asked_in(const Json& json) {
  Asked asked;
  asked.exercise = json.at("exercise");
  asked.problem = json.value("problem", "");
  for (const auto& [name, value] : json.at("parameters").items()) asked.parameters.emplace_back(name, value);
  asked.model = json.at("model");
  asked.algorithm = json.at("algorithm");
  asked.setting = json.at("setting");
  asked.need.criterion = criterion_in(json);
  asked.need.error = json.at("error");
  for (const auto& [unit, error] : json.at("errors").items()) asked.need.errors[unit] = error;
  asked.need.horizon = json.at("horizon");
  asked.need.frames_per_second = json.at("frames_per_second");
  asked.need.objective = Objective::simple;
  if (json.contains("frames")) asked.frames = frames_in(json.at("frames"));
  asked.kick = json.value("kick", "");
  asked.looks = whole<int>(json.at("looks"));
  asked.every_cell = json.at("every_cell");
  for (const Json& axis : json.at("axes"))
    asked.axes.push_back({axis.at("name"), axis.at("unit"), axis.at("from"), axis.at("to"),
                          whole<int>(axis.at("count")), axis.at("by_factor")});
  const bool sensible = (asked.axes.size() == 1 || asked.axes.size() == 2) && asked.looks >= 0 &&
                        std::ranges::all_of(asked.axes, [](const Axis& axis) { return axis.count >= 2; });
  if (!sensible) throw std::runtime_error("it has not one or two axes of two cells or more");
  return asked;
}

std::vector<long> wholes(const Json& json) {
  std::vector<long> all;
  for (const Json& one : json) all.push_back(whole<long>(one));
  return all;
}

/// The text's plan, without its frames and kicks.
Plan plan_in(const std::string& text) {
  Json json = Json::parse(text);
  const std::string problem = json.at("asked").value("problem", "");  // its line breaks must stay
  show_controls(json);
  if (!problem.empty()) json["asked"]["problem"] = problem;
  if (json.at("format") != format) throw std::runtime_error("of another format");
  return {asked_in(json.at("asked")), wholes(json.at("first_tile")), json.at("seconds"),
          json.at("fingerprint")};
}

/// With its frames and kicks. Throws if it makes no sense.
Plan made_ready(Plan plan) {
  scene_of(plan.asked);
  require_need(plan.asked);
  set_frames_and_kicks(plan.asked);
  require_cells(plan.asked);
  const bool whole = plan.first_tile.size() == plan.seconds.size() + 1 && !plan.seconds.empty() &&
                     plan.first_tile.front() == 0 && std::ranges::is_sorted(plan.first_tile) &&
                     plan.tiles() == tiles_of(plan.width(), tile_side(plan.asked)) *
                                         tiles_of(plan.height(), tile_side(plan.asked));
  if (!whole) throw std::runtime_error("its chunks are not those of its cells");
  if (!std::ranges::all_of(plan.seconds, [](double s) { return s >= 0 && std::isfinite(s); }))
    throw std::runtime_error("a chunk takes no time that can be");
  return plan;
}

/// The plan that comes from `place`. Throws BadInput if it is not a plan.
template <class Make>
Plan as_plan(const std::string& place, const Make& make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BadInput(place + " is no plan of a sweep: " + without_exception_name(error.what()));
  }
}

}  // namespace

const Entry& entry_of(const Asked& asked) {
  if (!asked.problem.empty()) return problem::entry_of_text(asked.exercise, asked.problem);
  for (const Entry& entry : registry())
    if (to_string(entry.number) == asked.exercise) return entry;
  throw BadInput("the sweep is of exercise " + asked.exercise + ", which this program does not have");
}

void set_frames_and_kicks(Asked& asked) {
  const Scene& scene = scene_of(asked);
  asked.need.frame_times = frame_times(asked.frames, asked.need.frames_per_second, asked.need.horizon,
                                       std::string(scene.axes.time));
  if (asked.need.frame_times && asked.looks > 0)
    throw BadInput("--looks are evenly spaced: leave it out, or the frames as they come");
  if (asked.kick.empty()) return;
  const Quantity seen = motion(scene, task_of(asked).parameters, Reference::nothing());
  std::tie(asked.need.kicks, asked.need.kicked) = kicks_of(scene, seen, asked.kick, asked.need.horizon);
}

double Axis::at(int cell) const {
  const double part = count < 2 ? 0 : static_cast<double>(cell) / (count - 1);
  if (cell == count - 1) return to;
  return by_factor ? from * std::pow(to / from, part) : from + (to - from) * part;
}

/// Column after column, each from below.
Cells Plan::tile(long number) const {
  const int side = tile_side(asked);
  const long rows = tiles_of(height(), side);
  const int x = static_cast<int>(number / rows) * side, y = static_cast<int>(number % rows) * side;
  return {x, y, std::min(x + side, width()) - 1, std::min(y + side, height()) - 1};
}

bool looks_at_every_cell(const Asked& asked) {
  long cells = 1;
  for (const Axis& axis : asked.axes) cells *= axis.count;
  return asked.every_cell || cells <= small_map;
}

double between_looks(const Asked& asked) {
  if (asked.need.frame_times) return asked.need.frame_times->longest;
  return asked.looks > 0 ? asked.need.horizon / asked.looks : 1 / asked.need.frames_per_second;
}

double most_shortened(const Asked& asked) {
  const Quantity seen = motion_asked(asked);
  const Method* method = method_asked(asked, seen);
  const std::vector<double> steps = steps_of(asked, method);
  const double between = between_looks(asked);
  if (steps.empty() || !ends_at_looks(seen, *method, between)) return 0;
  double most = 0;
  for (double step : steps) most = std::max(most, 1 - between / ode::steps_in(0, between, step) / step);
  return most;
}

Look looks_at(const Asked& asked, const Reference& truth) {
  return [looks = std::make_shared<Looks>(asked, truth)](int x, int y) { return (*looks)(x, y); };
}

Plan planned(const Asked& asked, const Reference& truth, const fs::path& tables, double seconds_a_chunk) {
  require_sense(asked);
  Plan plan{asked, {}, {}, fingerprint_of(from(asked).dump(), tables)};
  divide(plan, Speed(asked, truth, plan.width(), plan.height()), seconds_a_chunk);
  return plan;
}

std::string to_json(const Asked& asked) { return from(asked).dump(); }

std::string to_json(const Plan& plan) {
  return Json{{"format", format},
              {"fingerprint", plan.fingerprint},
              {"asked", from(plan.asked)},
              {"first_tile", plan.first_tile},
              {"seconds", plan.seconds}}
             .dump(1) +
         "\n";
}

Plan plan_from_json(const std::string& text, const std::string& place) {
  return as_plan(place, [&] { return made_ready(plan_in(text)); });
}

Plan read_plan(const fs::path& file, const fs::path& tables) {
  if (!fs::exists(file))
    throw BadInput("there is no plan " + file.string() + "; '" + program_as_typed() +
                   " sweep plan' makes one");
  const Plan plan = as_plan(file.string(), [&] { return plan_in(read_whole(file)); });
  if (const std::string here = fingerprint_of(from(plan.asked).dump(), tables); here != plan.fingerprint)
    throw BadInput(file.string() +
                   " is the plan of another program, of other tables or of another question: (" +
                   plan.fingerprint + "), and here is (" + here + "); plan it anew");
  Plan ready = as_plan(file.string(), [&] { return made_ready(plan); });
  require_sense(ready.asked);
  return ready;
}

}  // namespace oddity::sweep
