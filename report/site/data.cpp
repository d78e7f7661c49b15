// What the page's scripts get of an exercise, as oddity.exercise({...}). Numbers that are not finite are
// null.
//   number, title
//   parameters   [{name, value, unit, says, least, most, whole}]
//   quantities   [{name, unit, says, samples, need, reason, reference, reference_error, methods}]; a method
//   is
//                {model, algorithm, precision: "double"|"float", knob: "step"|"tolerance"|...|"", expected,
//                why, trials: [[setting, error, evaluations, seconds, spread, outcome, drift], ...]}
//   scene        null, or {quantity: its index, horizon, time_unit, close: {unit: error}, observables:
//   [name],
//                norms: [{unit, components}], varied, over: [value], truth, paths}
//     truth      {end, frames, values}: the true observables at frame 0, 1, ..., frames, one time after the
//                other, by the reference; values are floats, least byte first, in base64
//     paths      [{model, algorithm, knob, setting, error, outcome, frames, values}]: recorded motions
//   stability    null, or {limits: [{model, algorithm, stable, unstable, theory, within, tongues: [[from,
//                to]]}], parameter, unit, steps: [step], map: [{model, algorithm, value, theory, outcomes}]}
//   least        null, or [{says, horizon, fps, unit, model, algorithm, knob, setting, errors, evaluations}]

#include "report/site/data.hpp"

#include <bit>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "chapters/scene.hpp"
#include "report/site/script.hpp"
#include "report/study/starts.hpp"

namespace oddity {

using Json = nlohmann::ordered_json;

namespace {

Json from(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
/// With as many digits as a reader can use.
Json brief(double x) { return std::isfinite(x) ? Json(std::stod(rounded(x, 4))) : Json(nullptr); }

std::string in_base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Letters(bytes.begin()), Letters(bytes.end()));
  return text.append((4 - text.size() % 4) % 4, '=');
}

template <class Range>
Json as_floats(const Range& numbers) {
  std::string bytes;
  for (double x : numbers) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(x));
    for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(bits >> 8 * byte & 0xff);
  }
  return in_base64(bytes);
}

Json parameters_of(const Entry& entry) {
  Json all = Json::array();
  for (const Parameter& p : entry.exercise.parameters)
    all.push_back({{"name", p.name},
                   {"value", p.value},
                   {"unit", p.unit},
                   {"says", p.says},
                   {"least", from(p.least)},
                   {"most", from(p.most)},
                   {"whole", p.whole}});
  return all;
}

Json from(const TimedTrial& t) {
  return Json::array({t.setting, brief(t.error), t.evaluations, brief(t.time.seconds), brief(t.time.spread),
                      name_of(t.outcome), brief(t.drift)});
}

Json from(const std::string& model, const std::string& algorithm, Precision precision, Outcome expected,
          const std::string& why, const std::vector<TimedTrial>& trials) {
  Json rows = Json::array();
  for (const TimedTrial& t : trials) rows.push_back(from(t));
  return {{"model", model},
          {"algorithm", algorithm},
          {"precision", name_of(precision)},
          {"knob", trials.empty() ? "" : trials.front().knob},
          {"expected", name_of(expected)},
          {"why", why},
          {"trials", rows}};
}

Json from(const QuantityResult& q) {
  Json methods = Json::array();
  for (const MethodResult& m : q.methods)
    methods.push_back(from(m.model, m.algorithm, Precision::in_double, m.expected, m.why, m.trials));
  for (const FloatResult& m : q.in_float)
    methods.push_back(from(m.model, m.algorithm, Precision::in_float, Outcome::ok, "", m.trials));
  return {{"name", q.name},
          {"unit", q.unit},
          {"says", q.says},
          {"samples", q.samples},
          {"need", q.need.allowed},
          {"reason", q.need.reason},
          {"reference", q.reference.by},
          {"reference_error", from(q.reference_error)},
          {"methods", methods}};
}

/// 60 frames a second where the time is in seconds, and as many in all as ten seconds have where it is not.
Horizon frames_of(const Scene& scene) {
  return {scene.horizon, 1, scene.axes.time == "s" ? 60 : 600 / scene.horizon};
}

Json truth_of(const Scene& scene, const Parameters& parameters, const Reference& truth) {
  const Quantity seen = motion(scene, parameters, frames_of(scene), truth.to_digits(14));
  const std::size_t frames = frames_of(scene).times().size() - 1,
                    count = seen.reference.value.size() / frames;
  // Frame 0 is where every motion starts: the first of a model that is there at the time 0.
  std::vector<double> all(count, std::nan(""));
  all.insert(all.end(), seen.reference.value.begin(), seen.reference.value.end());
  return {{"end", scene.horizon}, {"frames", frames}, {"values", as_floats(all)}};
}

Json from(const Path& path, std::size_t frames) {
  return {{"model", path.model},     {"algorithm", path.algorithm},    {"knob", path.knob},
          {"setting", path.setting}, {"error", brief(path.error)},     {"outcome", name_of(path.outcome)},
          {"frames", frames},        {"values", as_floats(path.value)}};
}

Json scene_of(const ExerciseResult& e, const Entry& entry, const Reference& truth) {
  if (!entry.exercise.scene) return nullptr;
  const Scene& scene = *entry.exercise.scene;
  const auto moving =
      std::ranges::find_if(e.quantities, [](const QuantityResult& q) { return q.trajectory.has_value(); });
  if (moving == e.quantities.end()) return nullptr;
  Json norms = Json::array(), paths = Json::array(), close = Json::object();
  for (const Norm& norm : scene.axes.norms) {
    norms.push_back({{"unit", norm.unit}, {"components", norm.components}});
    close[std::string(norm.unit)] =
        norm.unit == "m" || norm.unit == "rad" ? game_error(norm.unit) : scene.close;
  }
  for (const Path& path : moving->trajectory->paths)
    paths.push_back(from(path, moving->trajectory->times.size()));
  return {{"quantity", moving - e.quantities.begin()},
          {"horizon", scene.horizon},
          {"time_unit", scene.axes.time},
          {"close", close},
          {"observables", scene.axes.observables},
          {"norms", norms},
          {"varied", scene.varied},
          {"over", scene.over},
          {"truth", truth_of(scene, Parameters(entry.exercise.parameters), truth)},
          {"paths", paths}};
}

Json from(const Limit& limit) {
  Json tongues = Json::array();
  for (const ode::Tongue& t : limit.tongues) tongues.push_back({brief(t.from), brief(t.to)});
  return {{"model", limit.model},
          {"algorithm", limit.algorithm},
          {"stable", brief(limit.step())},
          {"unstable", brief(limit.unstable)},
          {"theory", brief(limit.theory())},
          {"within", limit.within ? Json(limit.within->setting) : Json(nullptr)},
          {"tongues", tongues}};
}

Json from(const std::optional<Stability>& stability) {
  if (!stability) return nullptr;
  Json limits = Json::array(), map = Json::array();
  for (const Limit& limit : stability->limits) limits.push_back(from(limit));
  for (const MapRow& row : stability->map) {
    Json outcomes = Json::array();
    for (Outcome outcome : row.outcomes) outcomes.push_back(name_of(outcome));
    map.push_back({{"model", row.model},
                   {"algorithm", row.algorithm},
                   {"value", row.value},
                   {"theory", brief(row.theory)},
                   {"outcomes", outcomes}});
  }
  return {{"limits", limits},
          {"parameter", stability->parameter},
          {"unit", stability->parameter_unit},
          {"steps", stability->steps},
          {"map", map}};
}

Json from(const std::optional<Ledger>& ledger) {
  if (!ledger) return nullptr;
  Json rows = Json::array();
  for (const LeastModel& row : ledger->least) {
    if (!row.least) continue;
    rows.push_back({{"says", row.says},
                    {"horizon", row.need.horizon},
                    {"fps", row.need.frames_per_second},
                    {"unit", ledger->unit},
                    {"model", row.least->model},
                    {"algorithm", row.least->algorithm},
                    {"knob", row.least->knob},
                    {"setting", row.least->setting},
                    {"errors", row.least->errors},
                    {"evaluations", brief(row.least->evaluations_per_frame)}});
  }
  return rows;
}

}  // namespace

std::string exercise_data(const ExerciseResult& e, const Reference& truth) {
  const auto entry = std::ranges::find(registry(), e.number, &Entry::number);
  Json quantities = Json::array();
  for (const QuantityResult& q : e.quantities) quantities.push_back(from(q));
  const Json json{{"number", to_string(e.number)},
                  {"title", e.title},
                  {"parameters", parameters_of(*entry)},
                  {"quantities", quantities},
                  {"scene", scene_of(e, *entry, truth)},
                  {"stability", from(e.stability)},
                  {"least", from(e.ledger)}};
  return "oddity.exercise(" + as_script(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + ");\n";
}

}  // namespace oddity
