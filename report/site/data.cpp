// Data of an exercise for the page's scripts, as oddity.exercise({...}), packed (script.hpp).
// Numbers have as many digits as a reader can use; those that are not finite are null. An outcome is its
// letter on the maps of stability.
// - number, title
// - outcomes: `{letter: name}`.
// - parameters, of a scene: `[{name, value, unit, says, least, most, whole}]`.
// - units, accepted for numbers of the scene: `{unit: {name: its size in the unit}}`.
// - styles, as in the static charts: `{colours: {model: place}, marks: {algorithm: place}, families:
//   {algorithm: name}}`. Places are in the order of their palettes (charts/chart_style.hpp).
// - quantities:
//     `[{name, unit, says, samples, need, floor, size, charts, models: [name], algorithms: [name],
//     resolutions:
//     [{name, settings}], methods}]`. Errors below `floor` mean nothing. `size` is that of the true value.
//     `charts` are the axes of its error: "evaluations", "setting", "time". A method is `[model, algorithm,
//     resolution, in float?, trials]`, the first three by index. A trial of each setting is `[error,
//     evaluations, ns, spread, outcome]`, the time and its spread in nanoseconds. page.js makes `{model,
//     algorithm, resolution, precision, trials}` of a method, with the setting first in each trial.
// - scene: null, or
//     `{quantity: its index, horizon, time_unit, close: {unit: error}, observables: [name], norms: [{unit,
//     components}], varied, over: [value], truth, paths}`. The norms are those that judge the quantity's
//     trials.
//   - truth: `{end, frames, values}`, the reference's observables at frame 0, 1, ..., frames, time after
//     time. Values are floats, least significant byte first, in base64.
//   - paths:
//       `[{model, algorithm, resolution, setting, error, outcome, frames, least, most, values}]`. These are
//       motions that the module lacks, and third-party engines' with their precision, from frame 1 to their
//       end. Values are whole numbers of 16 bits, from 0 for the observable's `least` to 65535 for its
//       `most`. Each is less that of the frame before, in base64: first all low bytes, then all high ones.
// - stability: null, or
//     `{limits: [{model, algorithm, shown, stable, unstable, theory, within, tongues: [[from, to]]}],
//     parameter, unit, steps: [step], map: [{model, algorithm, rows: [[value, theory, outcomes, fragile],
//     ...]}]}`. `shown` is the largest stable step in words. If `theory` is null, every step is stable.
//     `outcomes` are the letters of the steps. `fragile` has a star for each that roundings decide and a dot
//     for each other, and is empty if they decide none.
// - least: null, or `[{model, algorithm, setting}]`, the cheapest model for a game, and for ten digits.
// - example, only for the example: `{truth, opening: [...]}`, the reference for other parameters, and the
//   player's initial methods: `{model, algorithm, precision, setting}`.
//
// Data of all scenes, as oddity.scenes([...]), has for each
// `{number, title, parameters, units, styles, horizon, time_unit, close, observables, norms, exact, faulted,
// resolutions: {resolution: [setting]}}`. `exact` are the models whose motion is ok in the book's case, the
// truest first. `faulted` are those that the scene's own page shows to be wrong.

#include "report/site/data.hpp"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "chapters/scene.hpp"
#include "reference/quantity_text.hpp"
#include "report/charts/chart.hpp"
#include "report/pages/stability_view.hpp"
#include "report/site/example.hpp"
#include "report/site/script.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"
#include "report/text/readable.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

using Json = nlohmann::ordered_json;

namespace {

/// A whole number is written without a point.
Json from(double x) {
  if (!std::isfinite(x)) return nullptr;
  return std::abs(x) < 1e9 && x == std::round(x) ? Json(std::lround(x)) : Json(x);
}
Json brief(double x, int digits = 4) {
  return std::isfinite(x) ? from(parse_number(format_significant(x, digits)).value()) : Json(nullptr);
}
Json brief_all(const std::vector<double>& numbers, int digits = 4) {
  Json all = Json::array();
  for (double x : numbers) all.push_back(brief(x, digits));
  return all;
}
std::string letter(Outcome outcome) { return {letter_of(outcome)}; }

Json as_floats(const std::vector<double>& numbers) {
  std::string bytes;
  for (double x : numbers) append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
  return in_base64(bytes);
}

Json parameters_of(const Entry& entry) {
  Json all = Json::array();
  for (const Parameter& p : entry.exercise.parameters)
    all.push_back({{"name", p.name},
                   {"value", p.value},
                   {"unit", typeset_unit(p.unit)},
                   {"says", readable(std::string(p.says))},
                   {"least", from(p.least)},
                   {"most", from(p.most)},
                   {"whole", p.whole}});
  return all;
}

/// The units accepted for a scene's numbers: {unit: {name: its size in the unit}}.
Json units_of(const Entry& entry) {
  const std::string time(entry.exercise.scene->axes.time);
  std::set<std::string> units{time, "1/" + time};
  for (const Parameter& p : entry.exercise.parameters) units.emplace(p.unit);
  Json all = Json::object();
  for (const std::string& unit : units)
    for (const auto& [name, size] : units_like(unit)) all[typeset_unit(unit)][name] = size;
  return all;
}

Json outcomes() {
  Json names;
  for (Outcome outcome : outcomes_of_a_map) names[letter(outcome)] = name_of(outcome);
  return names;
}

Json from(const TimedTrial& t) {
  return Json::array({brief(t.error, 3), t.evaluations, brief(1e9 * t.time.seconds, 3),
                      brief(1e9 * t.time.spread, 2), letter(t.outcome)});
}

/// A quantity's methods, with the lists that they share.
struct Methods {
  Json methods = Json::array(), models = Json::array(), algorithms = Json::array(),
       resolutions = Json::array();

  void add(const std::string& model, const std::string& algorithm, Precision precision,
           const std::vector<TimedTrial>& trials) {
    Json rows = Json::array(), settings = Json::array();
    for (const TimedTrial& t : trials) {
      rows.push_back(from(t));
      settings.push_back(from(t.setting));  // with all digits, for another run
    }
    const Json resolution{{"name", trials.empty() ? "" : trials.front().resolution}, {"settings", settings}};
    methods.push_back({place(models, model), place(algorithms, algorithm), place(resolutions, resolution),
                       precision == Precision::in_float ? 1 : 0, rows});
  }

 private:
  /// Index in the list; appends it if missing.
  static std::size_t place(Json& list, const Json& what) {
    const auto at = static_cast<std::size_t>(std::ranges::find(list, what) - list.begin());
    if (at == list.size()) list.push_back(what);
    return at;
  }
};

Methods methods_of(const QuantityResult& q) {
  Methods all;
  for (const MethodResult& m : q.methods) all.add(m.model, m.algorithm, Precision::in_double, m.trials);
  for (const FloatResult& m : q.in_float)
    all.add(m.model, q.methods[m.in_double].algorithm, Precision::in_float, m.trials);
  return all;
}

/// False if trials were only run and not timed.
bool is_timed(const QuantityResult& q) {
  return std::ranges::any_of(q.methods, [](const MethodResult& m) {
    return std::ranges::any_of(m.trials, [](const TimedTrial& t) { return std::isfinite(t.time.seconds); });
  });
}

std::string name_of_axis(Across across) {
  return across == Across::time ? "time" : across == Across::setting ? "setting" : "evaluations";
}

Json from(const QuantityResult& q) {
  Json charts = Json::array();
  for (Across across : charts_of(q))
    if (across != Across::time || is_timed(q)) charts.push_back(name_of_axis(across));
  const Methods shown = methods_of(q);
  Json quantity{{"name", q.name},
                {"unit", typeset_unit(q.unit)},
                {"says", readable(q.says)},
                {"samples", q.samples},
                {"need", brief(q.need.allowed)},
                {"floor", brief(error_floor(q), 3)},
                {"size", brief(size_of(q.reference.value), 3)},
                {"charts", charts},
                {"models", shown.models},
                {"algorithms", shown.algorithms},
                {"resolutions", shown.resolutions},
                {"methods", shown.methods}};
  if (q.in_operations) quantity["operations"] = true;
  return quantity;
}

Json styles_of(std::span<const QuantityResult> quantities, const Styles& styles) {
  Json colours = Json::object(), marks = Json::object(), families = Json::object();
  for (const QuantityResult& q : quantities)
    for (const MethodResult& m : q.methods) {
      colours[m.model] = styles.colour_place(m.model);
      marks[m.algorithm] = styles.mark_place(m.algorithm);
      const Family family = family_of(m.algorithm);
      if (family != Family::none) families[m.algorithm] = name_of(family);
    }
  return {{"colours", colours}, {"marks", marks}, {"families", families}};
}

/// 60 frames a second if the time is in seconds; otherwise 600 in all.
Horizon frames_of(const Scene& scene) {
  return {scene.horizon, 1, scene.axes.time == "s" ? 60 : 600 / scene.horizon};
}

/// The initial observables, by the method that is closest to the truth: its result after so short a time that
/// no float shows a motion.
Value start_of(const Scene& scene, const Parameters& parameters, const Path& truest) {
  const Quantity seen = scene.motion(parameters, {scene.horizon * 1e-30, 1}, Reference::nothing());
  for (const Method& m : seen.methods)
    if (m.model == truest.model && m.algorithm == truest.algorithm) return m.run(truest.setting).value;
  throw std::logic_error("the motion has no method '" + truest.model + ", " + truest.algorithm + "'");
}

/// The true observables at frame 0, 1, ..., time after time.
std::vector<double> true_motion(const Scene& scene, const Parameters& parameters, const Path& truest,
                                const Reference& truth) {
  const Quantity seen = motion(scene, parameters, frames_of(scene), truth.to_digits(14));
  const Value start = start_of(scene, parameters, truest);
  std::vector<double> all(start.begin(), start.end());
  all.insert(all.end(), seen.reference.value.begin(), seen.reference.value.end());
  return all;
}

/// The label of the model that has the engines' results.
constexpr const char* engine_model = "physics engine, as it comes";

/// From 0 for the least to 65535 for the most.
std::uint32_t quantized(double x, double least, double most) {
  return most > least ? static_cast<std::uint32_t>(std::lround(65535 * (x - least) / (most - least))) : 0;
}

/// A recorded motion, for display.
Json from(const Path& path, std::size_t observables, std::size_t frames) {
  std::vector<double> least(observables, INFINITY), most(observables, -INFINITY);
  for (std::size_t i = 0; i < path.value.size(); ++i) {
    least[i % observables] = std::min(least[i % observables], path.value[i]);
    most[i % observables] = std::max(most[i % observables], path.value[i]);
  }
  std::string low, high;  // slowly changing values have high bytes that compress well
  std::vector<std::uint32_t> before(observables, 0);
  for (std::size_t i = 0; i < path.value.size(); ++i) {
    const std::size_t k = i % observables;
    const std::uint32_t now = quantized(path.value[i], least[k], most[k]);
    append(low, (now - before[k]) & 0xff, 1);
    append(high, (now - before[k]) >> 8 & 0xff, 1);
    before[k] = now;
  }
  return {{"model", path.model},
          {"algorithm", path.algorithm},
          {"resolution", path.resolution},
          {"setting", path.setting},
          {"error", brief(path.error)},
          {"outcome", letter(path.outcome)},
          {"frames", frames},
          {"least", brief_all(least, 6)},
          {"most", brief_all(most, 6)},
          {"values", in_base64(low + high)}};
}

// ---- a scene ----------------------------------------------------------------------------------------------

Json close_of(const Scene& scene) {
  Json close = Json::object();
  for (const Norm& norm : scene.axes.norms)
    close[std::string(norm.unit)] =
        norm.unit == "m" || norm.unit == "rad" ? game_error(norm.unit) : scene.game_tolerance;
  return close;
}

Json from(const Norm& norm) { return {{"unit", norm.unit}, {"components", norm.components}}; }

Json norms_of(const Scene& scene) {
  Json norms = Json::array();
  for (const Norm& norm : scene.axes.norms) norms.push_back(from(norm));
  return norms;
}

/// The norms that judge the table of trials.
Json norms_of(const Scene& scene, const QuantityResult& judged) {
  if (!judged.norms.empty()) return norms_of(scene);
  Json norms = Json::array();
  for (const Norm& norm : scene.axes.norms)
    for (std::size_t i : norm.components) norms.push_back(from(Norm{norm.unit, {i}}));
  return norms;
}

auto motion_of(const ExerciseResult& e) {
  return std::ranges::find_if(e.quantities, [](const QuantityResult& q) { return q.trajectory.has_value(); });
}

/// The values of each setting from coarse to fine, by the method that has most of them.
Json resolutions_of(const QuantityResult& q) {
  Json resolutions = Json::object();
  for (const MethodResult& m : q.methods) {
    if (m.trials.size() < 2) continue;
    Json& settings = resolutions[m.trials.front().resolution];
    if (settings.size() >= m.trials.size()) continue;
    settings = Json::array();
    for (const TimedTrial& t : m.trials) settings.push_back(t.setting);
  }
  return resolutions;
}

Json exact_models(const Trajectory& shown) {
  std::vector<const Path*> exact;
  for (const Path& path : shown.paths)
    if (path.outcome == Outcome::ok) exact.push_back(&path);
  std::ranges::stable_sort(exact, {}, &Path::error);
  Json names = Json::array();
  for (const Path* path : exact) names.push_back(path->model);
  return names;
}

/// The module contains the listed models with the algorithms that run in the page.
bool in_module(const Scene& scene, const Path& path) {
  return std::ranges::none_of(ode::catalog(),
                              [&](const ode::CatalogEntry& entry) {
                                return !entry.runs_in_page() && path.algorithm.starts_with(entry.name);
                              }) &&
         (std::ranges::any_of(scene.listing.models,
                              [&](const auto& listed) {
                                return listed.first == path.model ||
                                       listed.first == path.model + ", " + path.algorithm;
                              }) ||
          std::ranges::any_of(scene.listing.with_events,
                              [&](const auto& listed) { return listed.first == path.model; }));
}

/// Engines with their defaults, at a step per frame: twenty times a second, for display.
Json engine_paths(const EngineContest& contest, const Scene& scene) {
  constexpr std::size_t every = 3;
  const std::size_t observables = scene.axes.observables.size();
  const auto frames = static_cast<std::size_t>(std::lround(scene.horizon * contest.frames_per_second));
  Json paths = Json::array();
  if (frames % every != 0) return paths;
  for (const EngineSeries& series : contest.series) {
    if (!series.defaults || series.trials.empty() || series.trials.front().path.empty()) continue;
    if (series.engine.ends_with(" in double")) continue;  // they look the same as in float
    const EngineTrial& trial = series.trials.front();
    Path path{engine_model,
              series.engine + " " + series.version,
              "step",
              1 / contest.frames_per_second,
              trial.errors.front(),
              trial.outcome,
              {}};
    std::vector<double> seen;
    const std::size_t known = std::min(frames, trial.path.size() / observables);
    for (std::size_t frame = every; frame <= known; frame += every)
      for (std::size_t i = 0; i < observables; ++i) seen.push_back(trial.path[(frame - 1) * observables + i]);
    path.value = Value(std::move(seen));
    paths.push_back(from(path, observables, frames / every));
    paths.back()["precision"] = series.precision;
  }
  return paths;
}

Json scene_of(const ExerciseResult& e, const Entry& entry, const Reference& truth, bool recorded,
              std::span<const EngineContest> contests) {
  const auto moving = motion_of(e);
  if (!entry.exercise.scene || moving == e.quantities.end()) return nullptr;
  const Scene& scene = *entry.exercise.scene;
  const Trajectory& shown = *moving->trajectory;
  const Parameters parameters(entry.exercise.parameters);
  const std::vector<double> moved = true_motion(scene, parameters, shown.paths[shown.truest], truth);
  Json paths = Json::array();
  for (const Path& path : shown.paths)
    if (recorded || !in_module(scene, path))
      paths.push_back(from(path, scene.axes.observables.size(), shown.times.size()));
  for (const EngineContest& contest : contests)
    if (!recorded && contest.scene == to_string(e.number))
      for (Json& path : engine_paths(contest, scene)) paths.push_back(std::move(path));
  Json json{{"quantity", moving - e.quantities.begin()},
            {"horizon", scene.horizon},
            {"time_unit", scene.axes.time},
            {"close", close_of(scene)},
            {"observables", scene.axes.observables},
            {"norms", norms_of(scene, *moving)},
            {"varied", scene.sweep_parameter},
            {"over", scene.sweep_values},
            {"truth",
             {{"end", scene.horizon},
              {"frames", moved.size() / scene.axes.observables.size() - 1},
              {"values", as_floats(moved)}}},
            {"paths", paths}};
  return json;
}

Json from(const Limit& limit) {
  Json tongues = Json::array();
  for (const ode::Tongue& t : limit.tongues) tongues.push_back({brief(t.from), brief(t.to)});
  return {{"model", limit.model},
          {"algorithm", limit.algorithm},
          {"shown", shown_step(limit)},
          {"stable", brief(limit.step())},
          {"unstable", brief(limit.unstable)},
          {"theory", brief(limit.theory())},
          {"within", limit.within ? brief(limit.within->setting) : Json(nullptr)},
          {"tongues", tongues}};
}

Json from(const std::optional<Stability>& stability) {
  if (!stability) return nullptr;
  Json limits = Json::array(), map = Json::array();
  for (const Limit& limit : stability->limits) limits.push_back(from(limit));
  for (const MapRow& row : stability->map) {
    if (map.empty() || map.back()["model"] != row.model || map.back()["algorithm"] != row.algorithm)
      map.push_back({{"model", row.model}, {"algorithm", row.algorithm}, {"rows", Json::array()}});
    map.back()["rows"].push_back({row.value, brief(row.theory), letters(row), fragile_cells(row)});
  }
  return {{"limits", limits},
          {"parameter", stability->parameter},
          {"unit", typeset_unit(stability->parameter_unit)},
          {"steps", stability->steps},
          {"map", map}};
}

Json from(const std::optional<CheapestModels>& cheapest_models) {
  if (!cheapest_models) return nullptr;
  Json rows = Json::array();
  for (const CheapestModel& row : cheapest_models->least) {
    if (!row.least) continue;
    rows.push_back(
        {{"model", row.least->model}, {"algorithm", row.least->algorithm}, {"setting", row.least->setting}});
  }
  return rows;
}

Json data_of(const ExerciseResult& e, const Reference& truth, const Styles& styles, bool recorded,
             std::span<const EngineContest> contests) {
  const Entry* entry = entry_of(e.number);
  Json quantities = Json::array();
  for (const QuantityResult& q : e.quantities) quantities.push_back(from(q));
  return {{"number", to_string(e.number)},
          {"title", e.title},
          {"outcomes", outcomes()},
          {"parameters", e.scene ? parameters_of(*entry) : Json::array()},
          {"units", e.scene ? units_of(*entry) : Json::object()},
          {"styles", styles_of(e.quantities, styles)},
          {"quantities", quantities},
          {"scene", scene_of(e, *entry, truth, recorded, contests)},
          {"stability", from(e.stability)},
          {"least", from(e.cheapest_models)}};
}

}  // namespace

std::string exercise_data(const ExerciseResult& e, const Reference& truth, const Styles& styles,
                          bool recorded, std::span<const EngineContest> contests) {
  return packed_call("exercise", data_of(e, truth, styles, recorded, contests));
}

std::string example_data(const ExerciseResult& e, bool recorded) {
  const Results alone{.exercises = {e}};
  Json data = data_of(e, Reference::nothing(), Styles(alone), recorded, {});
  const auto row = [](const char* model, const char* algorithm, double setting) {
    return Json{{"model", model}, {"algorithm", algorithm}, {"precision", "double"}, {"setting", setting}};
  };
  constexpr double frame = 1. / 60;
  data["example"] = {{"truth", row("flights", "closed form", 0)},
                     {"opening",
                      {row("ball, at rest below 1 cm/s", "velocity Verlet", frame),
                       row("ball", "velocity Verlet", frame), row("ball", "explicit Euler", frame)}}};
  return packed_call("exercise", data);
}

std::string scenes_data(const Results& results, const Styles& styles) {
  Json scenes = Json::array();
  for (const ExerciseResult& e : results.exercises) {
    const auto entry = std::ranges::find(registry(), e.number, &Entry::number);
    const auto moving = motion_of(e);
    if (!entry->exercise.scene || moving == e.quantities.end()) continue;
    const Scene& scene = *entry->exercise.scene;
    scenes.push_back({{"number", to_string(e.number)},
                      {"title", e.title},
                      {"parameters", parameters_of(*entry)},
                      {"units", units_of(*entry)},
                      {"styles", styles_of(std::span(&*moving, 1), styles)},
                      {"horizon", scene.horizon},
                      {"time_unit", scene.axes.time},
                      {"close", close_of(scene)},
                      {"observables", scene.axes.observables},
                      {"norms", norms_of(scene)},
                      {"exact", exact_models(*moving->trajectory)},
                      {"faulted", scene.faulted},
                      {"resolutions", resolutions_of(*moving)}});
  }
  return packed_call("scenes", scenes);
}

}  // namespace oddity
