#include <array>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "chapters/judge.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/study/findings.hpp"
#include "report/study/results.hpp"
#include "report/study/whole_in_json.hpp"
#include "report/text/markup.hpp"

namespace oddity {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr int format = 14;

/// JSON has no infinities and no NaN: they are null, and read as NaN.
Json from(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

/// A written value must follow from the other written values.
template <class T>
void require_follows(const Json& written, const T& follows, const std::string& what) {
  require(written == Json(follows),
          what + " is " + written.dump() + ", but the other values give " + Json(follows).dump());
}

/// A written number must follow from the others, up to the roundings of another C library.
void require_number_follows(const Json& written, double follows, const std::string& what) {
  constexpr double roundings = 1e-12;
  const double x = number(written);
  require(std::isfinite(x) ? std::abs(x - follows) <= roundings * std::abs(x) : !std::isfinite(follows),
          what + " is " + written.dump() + ", but the other values give " + format_shortest(follows));
}

template <class Enum, std::size_t N>
Enum named(const Json& json, const std::array<Enum, N>& all) {
  for (Enum value : all)
    if (json == std::string(name_of(value))) return value;
  throw std::runtime_error("unknown name " + json.dump());
}

constexpr std::array faults{Fault::none,           Fault::number, Fault::formula, Fault::left_out,
                            Fault::counterexample, Fault::term,   Fault::listing, Fault::lost_typography};
constexpr std::array outcomes{Outcome::ok,         Outcome::inaccurate, Outcome::drifted,  Outcome::diverged,
                              Outcome::non_finite, Outcome::stalled,    Outcome::deceived, Outcome::raised,
                              Outcome::chattering, Outcome::grazing};
constexpr std::array precisions{Precision::in_double, Precision::in_float};

Json from(const Value& value) {
  if (value.size() == 1) return from(value[0]);
  Json json = Json::array();
  for (double x : value) json.push_back(from(x));
  return json;
}
Value value(const Json& json) {
  if (!json.is_array()) return number(json);
  std::vector<double> components;
  for (const Json& x : json) components.push_back(number(x));
  return components;
}

Json from(const Route& route) { return {{"by", route.by}, {"value", from(route.value)}}; }
Route route(const Json& json) { return {json.at("by"), value(json.at("value"))}; }

Json from(const Tolerance& t) { return {{"allowed", from(t.allowed)}, {"reason", t.reason}}; }
Tolerance tolerance(const Json& json) { return {number(json.at("allowed")), json.at("reason")}; }

Json from(const Check& c, const std::string& reading) {
  return {{"reading", reading},
          {"quantity", c.quantity},
          {"left", from(c.left)},
          {"right", from(c.right)},
          {"difference", from(c.difference())},
          {"tolerance", from(c.tolerance)},
          {"scale", from(c.scale)},
          {"where", c.where},
          {"holds", c.holds()}};
}
Check check(const Json& json) {
  const Check c{json.at("quantity"),      route(json.at("left")),
                route(json.at("right")),  tolerance(json.at("tolerance")),
                number(json.at("scale")), json.at("where")};
  require_number_follows(json.at("difference"), c.difference(),
                         "the difference of the check '" + c.quantity + "'");
  require_follows(json.at("holds"), c.holds(), "that the check '" + c.quantity + "' holds");
  return c;
}

Json from(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  Json readings = Json::object(), checks = Json::array(), as_typeset = Json::array();
  for_each_reading(claim, [&](const std::string& name, const Reading& reading) {
    if (reading.checks.empty()) return;
    readings[name] = reading.text;
    if (reading.as_typeset) as_typeset.push_back(name);
    for (const Check& c : reading.checks) checks.push_back(from(c, name));
  });
  return {{"id", claim.id},
          {"line", claim.line},
          {"place", claim.place},
          {"says", claim.says},
          {"verdict", name_of(judged.verdict)},
          {"why", claim.why},
          {"not_checkable", claim.not_checkable},
          {"kind", name_of(claim.kind)},
          {"root", claim.root},
          {"readings", readings},
          {"as_typeset", as_typeset},
          {"checks", checks}};
}
JudgedClaim claim(const Json& json) {
  JudgedClaim judged{{.id = json.at("id"), .line = whole<int>(json.at("line")), .says = json.at("says")}};
  judged.claim.place = json.at("place");
  judged.claim.why = json.at("why");
  judged.claim.not_checkable = json.at("not_checkable");
  judged.claim.kind = named(json.at("kind"), faults);
  judged.claim.root = json.at("root");
  std::size_t near_misses = 0;
  for (const auto& [name, text] : json.at("readings").items()) near_misses += name.starts_with("near miss");
  judged.claim.near_misses.resize(near_misses);
  std::size_t readings = 0, checks = 0;
  for_each_reading(judged.claim, [&](const std::string& name, Reading& reading) {
    if (!json.at("readings").contains(name)) return;
    reading.text = json.at("readings").at(name);
    for (const Json& read : json.at("as_typeset")) reading.as_typeset = reading.as_typeset || read == name;
    for (const Json& c : json.at("checks"))
      if (c.at("reading") == name) reading.checks.push_back(check(c));
    require(!reading.checks.empty(), "a reading of " + judged.claim.id + " has no checks");
    ++readings;
    checks += reading.checks.size();
  });
  require(readings == json.at("readings").size() && checks == json.at("checks").size(),
          "readings or checks of " + judged.claim.id + " do not match its claim");
  judged.verdict = verdict(judged.claim);
  require_follows(json.at("verdict"), name_of(judged.verdict), "the verdict on " + judged.claim.id);
  return judged;
}

Json from(const TimedTrial& t) {
  return {{"model", t.model},
          {"algorithm", t.algorithm},
          {"resolution", t.resolution.empty() ? Json(nullptr) : Json(t.setting)},
          {"resolution_name", t.resolution},
          {"value", from(t.value)},
          {"error", from(t.error)},
          {"final_error", from(t.final_error)},
          {"error_estimate", from(t.error_estimate)},
          {"drift", from(t.drift)},
          {"drift_comes_back", t.comes_back},
          {"evaluations", t.evaluations},
          {"seconds", from(t.time.seconds)},
          {"spread", from(t.time.spread)},
          {"outcome", name_of(t.outcome)},
          {"message", t.message},
          {"precision", name_of(t.precision)},
          {"roundings", from(t.roundings)}};
}
TimedTrial trial(const Json& json) {
  TimedTrial t;
  t.model = json.at("model");
  t.algorithm = json.at("algorithm");
  t.resolution = json.at("resolution_name");
  t.setting = json.at("resolution").is_null() ? 0 : number(json.at("resolution"));
  t.value = value(json.at("value"));
  t.error = number(json.at("error"));
  t.final_error = number(json.at("final_error"));
  t.error_estimate = number(json.at("error_estimate"));
  t.drift = number(json.at("drift"));
  t.comes_back = json.at("drift_comes_back");
  t.evaluations = whole<long>(json.at("evaluations"));
  t.time.seconds = number(json.at("seconds"));
  t.time.spread = number(json.at("spread"));
  t.outcome = named(json.at("outcome"), outcomes);
  t.message = json.at("message");
  t.precision = named(json.at("precision"), precisions);
  t.roundings = number(json.at("roundings"));
  return t;
}

/// The reference has the same number of values at each time, and those that form a point or an angle.
bool has_all_components(const QuantityResult& q) {
  const std::size_t size = q.reference.value.size(), times = static_cast<std::size_t>(q.samples);
  return size % times == 0 && std::ranges::all_of(q.norms, [&](const auto& components) {
           return std::ranges::all_of(components, [&](std::size_t i) { return i < size / times; });
         });
}

/// The parts of the quantity that judge its trials.
Quantity judging(const QuantityResult& q) {
  Quantity quantity{q.name, q.unit, q.says, q.reference, q.reference_error, q.need};
  quantity.samples = q.samples;
  for (const auto& components : q.norms) quantity.norms.push_back({"", components});
  return quantity;
}

/// The method's own ending for an outcome; otherwise it reached the end.
Ending ending_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::raised:
      return Ending::raised;
    case Outcome::stalled:
      return Ending::stalled;
    case Outcome::non_finite:
      return Ending::non_finite;
    case Outcome::chattering:
      return Ending::chattering;
    case Outcome::grazing:
      return Ending::grazing;
    default:
      return Ending::reached;
  }
}

/// The error follows from the value, and the outcome from the error, unless the method itself gave up.
TimedTrial trial(const Json& json, const Quantity& quantity) {
  const TimedTrial t = trial(json);
  const std::string of = " of " + t.model + ", " + t.algorithm;
  require_number_follows(json.at("error"), largest(quantity.errors(t.value)), "the error" + of);
  require_number_follows(
      json.at("final_error"),
      distance(last_of(t.value, quantity.samples), last_of(quantity.reference.value, quantity.samples)),
      "the final error" + of);
  const Answer answer{t.value,   t.evaluations, t.error_estimate, t.drift, ending_of(t.outcome),
                      t.message, t.comes_back};
  require_follows(json.at("outcome"), name_of(judge(quantity, answer, t.error, quantity.in_needs({t.error}))),
                  "the outcome" + of);
  return t;
}

Json from(const Candidate& t) {
  return {{"model", t.model},
          {"algorithm", t.algorithm},
          {"resolution", t.resolution},
          {"setting", from(t.setting)},
          {"error_in_needs", from(t.error)},
          {"errors", from(Value(t.errors))},
          {"outcome", name_of(t.outcome)},
          {"evaluations_per_frame", from(t.evaluations_per_frame)}};
}
Candidate candidate(const Json& json) {
  Candidate t{json.at("model"), json.at("algorithm"), json.at("resolution"), number(json.at("setting")),
              number(json.at("error_in_needs"))};
  for (double error : value(json.at("errors"))) t.errors.push_back(error);
  t.outcome = named(json.at("outcome"), outcomes);
  t.evaluations_per_frame = number(json.at("evaluations_per_frame"));
  require(!t.holds() || t.error <= 1,
          t.model + ", " + t.algorithm + " is marked as holding, but its error exceeds the need");
  return t;
}

Json from(const CheapestModel& row) {
  Json json{{"for", row.says},
            {"error_asked", from(row.need.error)},
            {"relative", row.need.relative},
            {"horizon", from(row.need.horizon)},
            {"frames_per_second", from(row.need.frames_per_second)}};
  if (row.least) json["least"] = from(*row.least);
  if (row.in_float) json["in_float"] = from(*row.in_float);
  return json;
}
CheapestModel cheapest_model(const Json& json) {
  CheapestModel row{json.at("for"),
                    {number(json.at("error_asked")), json.at("relative"), number(json.at("horizon")),
                     number(json.at("frames_per_second"))},
                    {}};
  if (json.contains("least")) row.least = candidate(json.at("least"));
  if (json.contains("in_float")) {
    row.in_float = candidate(json.at("in_float"));
    row.in_float->precision = Precision::in_float;
  }
  return row;
}

Json from(const Interval& interval) { return Json::array({from(interval.from), from(interval.to)}); }
Interval interval(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }

/// A list even for one number; infinite ones stay so.
Json listed(const std::vector<double>& numbers) {
  Json json = Json::array();
  for (double x : numbers) json.push_back(std::isinf(x) ? Json("infinite") : from(x));
  return json;
}
std::vector<double> numbers(const Json& json) {
  std::vector<double> all;
  for (const Json& x : json)
    all.push_back(x == "infinite" ? std::numeric_limits<double>::infinity() : number(x));
  return all;
}

Json from(const BreakEven& b) {
  Json enough = Json::array();
  for (const Interval& i : b.enough) enough.push_back(from(i));
  return {{"model", b.model},
          {"parameter", b.parameter},
          {"parameter_unit", b.parameter_unit},
          {"looked", from(b.looked)},
          {"enough", enough},
          {"holding", listed(b.holding)},
          {"failing", listed(b.failing)},
          {"coarse", b.coarse},
          {"why", b.why}};
}
BreakEven break_even(const Json& json) {
  BreakEven b{
      json.at("model"), json.at("parameter"), json.at("parameter_unit"), interval(json.at("looked")), {}};
  for (const Json& i : json.at("enough")) b.enough.push_back(interval(i));
  b.holding = numbers(json.at("holding"));
  b.failing = numbers(json.at("failing"));
  b.coarse = json.at("coarse").get<bool>();
  b.why = json.at("why");
  return b;
}

Json from(const CheapestModels& cheapest_models) {
  Json least = Json::array(), break_evens = Json::array();
  for (const CheapestModel& row : cheapest_models.least) least.push_back(from(row));
  for (const BreakEven& b : cheapest_models.break_evens) break_evens.push_back(from(b));
  return {{"units", cheapest_models.units},
          {"recipe", from(cheapest_models.recipe)},
          {"least", least},
          {"break_evens", break_evens},
          {"never", cheapest_models.never}};
}
CheapestModels cheapest_models(const Json& json) {
  CheapestModels cheapest_models{
      json.at("units"), {}, {}, json.at("never"), cheapest_model(json.at("recipe"))};
  for (const Json& row : json.at("least")) cheapest_models.least.push_back(cheapest_model(row));
  require(!cheapest_models.least.empty(), "there are no least models");
  for (const Json& b : json.at("break_evens")) cheapest_models.break_evens.push_back(break_even(b));
  return cheapest_models;
}

Json from(const Trajectory& t) {
  Json paths = Json::array();
  for (const Path& p : t.paths)
    paths.push_back({{"model", p.model},
                     {"algorithm", p.algorithm},
                     {"resolution", p.resolution},
                     {"setting", from(p.setting)},
                     {"error", from(p.error)},
                     {"outcome", name_of(p.outcome)},
                     {"value", from(p.value)}});
  return {{"observables", t.observables},
          {"time_unit", t.time_unit},
          {"judged_at", from(Value(t.judged_at))},
          {"times", from(Value(t.times))},
          {"truest", t.truest},
          {"close", from(t.close)},
          {"paths", paths}};
}
Trajectory trajectory(const Json& json) {
  const auto numbers = [](const Json& list) {
    const Value all = value(list);
    return std::vector<double>(all.begin(), all.end());
  };
  Trajectory t{json.at("observables"),
               json.at("time_unit"),
               numbers(json.at("judged_at")),
               numbers(json.at("times")),
               {},
               whole<std::size_t>(json.at("truest")),
               number(json.at("close"))};
  for (const Json& p : json.at("paths"))
    t.paths.push_back({p.at("model"), p.at("algorithm"), p.at("resolution"), number(p.at("setting")),
                       number(p.at("error")), named(p.at("outcome"), outcomes), value(p.at("value"))});
  require(t.truest < t.paths.size(), "truest is not one of the paths");
  require(!t.judged_at.empty() && !t.times.empty() && t.times.size() % t.judged_at.size() == 0,
          "a trajectory's times do not hold those where it is judged");
  const std::size_t size = t.paths[t.truest].value.size();
  require(size > 0 && size % t.times.size() == 0, "the truest path has not as many values at each time");
  return t;
}

/// The trials of a quantity are one list; each method gives the number of its trials, in turn.
Json from(const QuantityResult& q) {
  Json methods = Json::array(), trials = Json::array(), breakdowns = Json::array(), in_float = Json::array();
  for (const MethodResult& m : q.methods) {
    methods.push_back({{"model", m.model},
                       {"algorithm", m.algorithm},
                       {"expected", name_of(m.expected)},
                       {"asserted", m.asserted},
                       {"why", m.why},
                       {"trials", m.trials.size()},
                       {"as_expected", m.as_expected()}});
    for (const TimedTrial& t : m.trials) trials.push_back(from(t));
  }
  for (const FloatResult& m : q.in_float) {
    Json of_one = Json::array();
    for (const TimedTrial& t : m.trials) of_one.push_back(from(t));
    in_float.push_back(
        {{"model", m.model}, {"algorithm", m.algorithm}, {"in_double", m.in_double}, {"trials", of_one}});
  }
  for (const BreakdownResult& b : q.breakdowns)
    breakdowns.push_back({{"says", b.says},
                          {"expected", name_of(b.expected)},
                          {"broken", from(b.broken)},
                          {"cured", from(b.cured)},
                          {"as_expected", b.as_expected()}});
  return {{"name", q.name},
          {"unit", q.unit},
          {"says", q.says},
          {"reference", from(q.reference.value)},
          {"reference_source", q.reference.by},
          {"reference_error", from(q.reference_error)},
          {"need", from(q.need)},
          {"samples", q.samples},
          {"norms", q.norms},
          {"in_operations", q.in_operations},
          {"methods", methods},
          {"trials", trials},
          {"in_float", in_float},
          {"breakdowns", breakdowns},
          {"trajectory", q.trajectory ? from(*q.trajectory) : Json(nullptr)}};
}
bool is_of_a_trial(const Path& path, const QuantityResult& q) {
  const auto like = [&](const TimedTrial& t) {
    return t.model == path.model && t.algorithm == path.algorithm && t.resolution == path.resolution &&
           t.setting == path.setting && t.outcome == path.outcome &&
           (t.error == path.error || (std::isnan(t.error) && std::isnan(path.error)));
  };
  return std::ranges::any_of(q.methods,
                             [&](const MethodResult& m) { return std::ranges::any_of(m.trials, like); });
}

QuantityResult quantity(const Json& json) {
  QuantityResult q{json.at("name"),
                   json.at("unit"),
                   json.at("says"),
                   {json.at("reference_source"), value(json.at("reference"))},
                   number(json.at("reference_error")),
                   tolerance(json.at("need")),
                   {},
                   {}};
  q.samples = whole<int>(json.at("samples"));
  require(q.samples > 0, "a motion is seen at no time");
  for (const Json& norm : json.at("norms")) {
    auto& components = q.norms.emplace_back();
    for (const Json& component : norm) components.push_back(whole<std::size_t>(component));
  }
  require(!finite(q.reference.value) || has_all_components(q),
          "the reference has not all that it is judged by");
  const Quantity quantity = judging(q);
  std::size_t next = 0;
  for (const Json& m : json.at("methods")) {
    MethodResult method{m.at("model"), m.at("algorithm"), named(m.at("expected"), outcomes), m.at("why"), {}};
    for (std::size_t i = 0; i < whole<std::size_t>(m.at("trials")); ++i)
      method.trials.push_back(trial(json.at("trials").at(next++), quantity));
    require(!method.trials.empty(), "a method has no trials");
    method.asserted = m.at("asserted");
    require_follows(m.at("as_expected"), method.as_expected(),
                    "that " + method.model + ", " + method.algorithm + " is as expected");
    q.methods.push_back(std::move(method));
  }
  require(next == json.at("trials").size(), "a trial is of no method");
  for (const Json& m : json.at("in_float")) {
    FloatResult one{m.at("model"), m.at("algorithm"), whole<std::size_t>(m.at("in_double")), {}};
    require(one.in_double < q.methods.size(), "a method in float has no like one in double");
    for (const Json& t : m.at("trials")) one.trials.push_back(trial(t, quantity));
    require(one.trials.size() == q.methods[one.in_double].trials.size(),
            "a method in float has not the settings of the like one in double");
    q.in_float.push_back(std::move(one));
  }
  for (const Json& b : json.at("breakdowns")) {
    q.breakdowns.push_back({b.at("says"), named(b.at("expected"), outcomes), trial(b.at("broken"), quantity),
                            trial(b.at("cured"), quantity)});
    require_follows(b.at("as_expected"), q.breakdowns.back().as_expected(),
                    "that '" + q.breakdowns.back().says + "' is as expected");
  }
  q.in_operations = json.at("in_operations");
  if (!json.at("trajectory").is_null()) q.trajectory = trajectory(json.at("trajectory"));
  for (const Path& path : q.trajectory ? q.trajectory->paths : std::vector<Path>())
    require(is_of_a_trial(path, q), "the path of " + path.model + ", " + path.algorithm + " is of no trial");
  return q;
}

/// A step or a limit: infinity, "every step", is a word.
Json from_limit(double x) { return std::isinf(x) ? Json("every") : from(x); }
double limit_in(const Json& json) {
  return json == "every" ? std::numeric_limits<double>::infinity() : number(json);
}

Json from(const std::vector<ode::Tongue>& tongues) {
  Json all = Json::array();
  for (const ode::Tongue& t : tongues) all.push_back({from(t.from), from_limit(t.to)});
  return all;
}
std::vector<ode::Tongue> tongues(const Json& json) {
  std::vector<ode::Tongue> all;
  for (const Json& t : json) all.push_back({number(t.at(0)), limit_in(t.at(1))});
  return all;
}

Json from(const std::optional<TimedTrial>& t) { return t ? from(*t) : Json(nullptr); }
std::optional<TimedTrial> maybe_trial(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(trial(json));
}

Json from(const Stability& s) {
  Json limits = Json::array(), map = Json::array();
  for (const Limit& l : s.limits)
    limits.push_back({{"model", l.model},
                      {"algorithm", l.algorithm},
                      {"step", from_limit(l.step())},
                      {"theory", from_limit(l.theory())},
                      {"tongues", from(l.tongues)},
                      {"stable", from(l.stable)},
                      {"unstable", from(l.unstable)},
                      {"longest", from(l.longest)},
                      {"lost", from(l.lost)},
                      {"outgrown", l.outgrown},
                      {"watched", from(l.watched)},
                      {"goes_on", l.goes_on},
                      {"soft", l.soft ? Json{from(l.soft->least), from(l.soft->most)} : Json(nullptr)},
                      {"at", from(l.at)},
                      {"broken", from(l.broken)},
                      {"within", from(l.within)},
                      {"cure", from(l.cure)},
                      {"why", l.why},
                      {"evidence", l.evidence}});
  for (const MapRow& row : s.map) {
    Json ends = Json::array();
    for (Outcome outcome : row.outcomes) ends.push_back(name_of(outcome));
    map.push_back({{"model", row.model},
                   {"algorithm", row.algorithm},
                   {"value", from(row.value)},
                   {"theory", from_limit(row.theory)},
                   {"outcomes", ends},
                   {"fragile", row.fragile}});
  }
  return {{"quantity", s.quantity},   {"unit", s.unit},
          {"time_unit", s.time_unit}, {"horizon", from(s.horizon)},
          {"close", from(s.close)},   {"limits", limits},
          {"parameter", s.parameter}, {"parameter_unit", s.parameter_unit},
          {"steps", s.steps},         {"map", map}};
}
std::optional<Between> maybe_between(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Between{number(json.at(0)), number(json.at(1))};
}
Stability stability(const Json& json) {
  Stability s{json.at("quantity"),      json.at("unit"),
              json.at("time_unit"),     number(json.at("horizon")),
              number(json.at("close")), {},
              json.at("parameter"),     json.at("parameter_unit"),
              json.at("steps"),         {}};
  for (const Json& l : json.at("limits")) {
    s.limits.push_back({l.at("model"), l.at("algorithm"), tongues(l.at("tongues")), number(l.at("stable")),
                        number(l.at("unstable")), number(l.at("longest")), number(l.at("lost")),
                        l.at("outgrown"), number(l.at("watched")), l.at("goes_on"),
                        maybe_between(l.at("soft")), maybe_trial(l.at("at")), maybe_trial(l.at("broken")),
                        maybe_trial(l.at("within")), maybe_trial(l.at("cure")), l.at("why"),
                        l.at("evidence")});
    const std::string of = " of " + s.limits.back().model + ", " + s.limits.back().algorithm;
    require_follows(l.at("step"), from_limit(s.limits.back().step()), "the limit" + of);
    require_follows(l.at("theory"), from_limit(s.limits.back().theory()), "theory's limit" + of);
  }
  require(!s.steps.empty(), "a map has no steps");
  for (const Json& r : json.at("map")) {
    MapRow row{r.at("model"),  r.at("algorithm"), number(r.at("value")), limit_in(r.at("theory")), {},
               r.at("fragile")};
    for (const Json& outcome : r.at("outcomes")) row.outcomes.push_back(named(outcome, outcomes));
    require(row.outcomes.size() == s.steps.size(), "a row of a map has not one outcome for each step");
    require(row.fragile.size() == s.steps.size(), "a row of a map has not one mark for each step");
    s.map.push_back(std::move(row));
  }
  return s;
}

Json from(const ExerciseResult& e) {
  Json parameters = Json::array(), claims = Json::array(), quantities = Json::array();
  for (const ParameterValue& p : e.parameters)
    parameters.push_back({{"name", p.name}, {"value", from(p.value)}, {"unit", p.unit}, {"says", p.says}});
  for (const JudgedClaim& c : e.claims) claims.push_back(from(c));
  for (const QuantityResult& q : e.quantities) quantities.push_back(from(q));
  Json roots = Json::array();
  for (const Root& root : e.roots) roots.push_back({{"name", root.name}, {"shows", root.shows}});
  return {{"number", to_string(e.number)},
          {"title", e.title},
          {"asks", e.asks},
          {"scene", e.scene},
          {"made_from", e.made_from},
          {"parameters", parameters},
          {"claims", claims},
          {"roots", roots},
          {"verdict", e.verdict},
          {"quantities", quantities},
          {"failure", e.failure},
          {"stability", e.stability ? from(*e.stability) : Json(nullptr)},
          {"cheapest_models", e.cheapest_models ? from(*e.cheapest_models) : Json(nullptr)}};
}
ExerciseResult exercise(const Json& json) {
  const auto number_of = exercise_number(json.at("number").get<std::string>());
  if (!number_of) throw std::runtime_error("not an exercise number: " + json.at("number").dump());
  ExerciseResult e{*number_of, json.at("title"),  json.at("asks"), json.at("scene"), {}, {},
                   {},         json.at("failure")};
  for (const Json& p : json.at("parameters"))
    e.parameters.push_back({p.at("name"), number(p.at("value")), p.at("unit"), p.at("says")});
  for (const Json& c : json.at("claims")) e.claims.push_back(claim(c));
  for (const Json& root : json.at("roots")) e.roots.push_back({root.at("name"), root.at("shows")});
  std::set<std::string> files;
  for (const Json& q : json.at("quantities")) {
    e.quantities.push_back(quantity(q));
    require(files.insert(file_name(e.quantities.back().name)).second, "two quantities have one name");
  }
  if (!json.at("stability").is_null()) e.stability = stability(json.at("stability"));
  if (!json.at("cheapest_models").is_null()) e.cheapest_models = cheapest_models(json.at("cheapest_models"));
  e.verdict = json.at("verdict");
  if (e.failure.empty()) static_cast<void>(verdict_of(e));
  e.made_from = json.at("made_from");
  return e;
}

}  // namespace

namespace {

/// Bytes that are not UTF-8, such as a table may hold, are replaced.
std::string text_of(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace); }

Results results_in(Json json) {
  show_controls(json);
  require(json.at("format") == format, "written by another version of oddity");
  Results results{{}, number(json.at("seam")), json.at("made_by")};
  for (const Json& e : json.at("exercises")) results.exercises.push_back(exercise(e));
  return results;
}

/// Runs `read`, and rewrites its error messages for a user with a file at `place`.
template <class Read>
Results understood(const std::string& place, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BadInput(place + ": not a results file: " + without_exception_name(error.what()));
  }
}

}  // namespace

std::string to_json(const Results& results) {
  Json json{{"format", format}, {"made_by", results.made_by}, {"seam", from(results.seam)}};
  json["exercises"] = Json::array();
  for (const ExerciseResult& e : results.exercises) json["exercises"].push_back(from(e));
  json["seal"] = checksum(text_of(json));
  return text_of(json) + "\n";
}

Results results_from_json(const std::string& text, const std::string& place) {
  return understood(place, [&] { return results_in(Json::parse(text)); });
}

Results read_results(const fs::path& file) {
  const std::string text = read_whole(file);
  return understood(file.string(), [&] {
    Json json = Json::parse(text);
    require(json.at("format") == format, "written by another version of oddity");
    const Json seal = json.at("seal");
    json.erase("seal");
    require(seal == checksum(text_of(json)), "it is not as it was written");
    return results_in(std::move(json));
  });
}

}  // namespace oddity
