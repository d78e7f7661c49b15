#include "problem/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include "chapters/asked_file.hpp"
#include "chapters/own_reference.hpp"
#include "problem/claims.hpp"
#include "problem/code.hpp"
#include "problem/file.hpp"
#include "problem/interpreted.hpp"
#include "problem/model.hpp"
#include "problem/ode_file.hpp"
#include "problem/staging.hpp"
#include "problem/truth.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

/// "problem::Spring{m, k}" for printed code, or the reason why it cannot be printed.
struct Construction {
  std::string code, why_not;
};

/// The data that an entry's views point to.
struct Kept {
  std::unique_ptr<const File> file;
  std::string of_text;  ///< distinguishes files of the same name
  std::vector<Model> models;
  std::vector<Parameter> parameters;
  std::vector<Construction> constructions;  ///< one per model
  std::unique_ptr<const Sheet> sheet;
  std::unique_ptr<const Staged> staged;
  std::unique_ptr<Entry> entry;
};

struct AllKept {
  std::mutex mutex;
  std::vector<std::unique_ptr<const Kept>> all;
  std::map<std::pair<std::string, std::string>, const Entry*> by_source;  ///< by name and text
};
AllKept& kept() {
  static AllKept here;
  return here;
}

const Kept& kept_with(const Parameter* parameters) {
  const std::lock_guard lock(kept().mutex);
  for (const auto& one : kept().all)
    if (one->parameters.data() == parameters) return *one;
  throw std::logic_error("these parameters are of no file");
}

/// A closed form of a file.
struct Closed {
  std::shared_ptr<const Program> observed;
  std::vector<double> at(double t) const {
    std::vector<double> values(observed->outputs().size());
    observed->run(&t, t, values.data());
    return values;
  }
};

std::vector<double> values_of(const Parameters& p) {
  std::vector<double> values;
  for (const Parameter& one : p.declared()) values.push_back(p[one.name]);
  return values;
}

/// The observables at each time except the first.
std::vector<long double> observed(const Numbers& numbers, const TrueMotion& motion,
                                  std::span<const double> times) {
  std::vector<long double> seen;
  std::vector<long double> one(numbers.observed.outputs().size());
  for (std::size_t i = 1; i < motion.states.size(); ++i) {
    numbers.observed.run(motion.states[i].data(), static_cast<long double>(times[i]), one.data());
    seen.insert(seen.end(), one.begin(), one.end());
  }
  return seen;
}

/// Throws BadInput if a table is evaluated outside its rows.
void require_known(const Model& model, const Numbers& numbers, const std::vector<long double>& state,
                   double t) {
  if (model.tables().empty()) return;
  std::vector<long double> at(model.tables().size());
  numbers.looked_up.run(state.data(), static_cast<long double>(t), at.data());
  for (std::size_t i = 0; i < at.size(); ++i)
    if (const Table& table = *model.tables()[i]; !table.knows(at[i]))
      throw BadInput("table " + table.name + " is known from " + format_shortest(table.first()) + " to " +
                     format_shortest(table.last) + " (in " + name_of(table.x) +
                     "), and at t = " + format_significant(t, 4) + " s it is asked for " +
                     format_significant(static_cast<double>(at[i]), 4) + ": add rows, or outside = \"hold\"");
}

/// The motion by both routes. The bound at a time is four times their largest difference up to the next
/// compared time, plus the rounding to double.
Known true_motion(const Model& model, const Numbers& numbers, std::span<const double> times) {
  const std::string by =
      "Taylor series of '" + model.name() + "', compared with extrapolation, both in long double";
  if (model.is_closed()) {
    std::vector<double> values;
    for (const double t : times.subspan(1)) {
      std::vector<long double> one(numbers.observed.outputs().size());
      const auto time = static_cast<long double>(t);
      require_known(model, numbers, {time}, t);
      numbers.observed.run(&time, time, one.data());
      values.insert(values.end(), one.begin(), one.end());
    }
    return {values, 1e-16 * size_of(values), "closed form '" + model.name() + "' in long double"};
  }
  const TrueMotion motion = by_series(numbers, times);
  if (!motion.trouble.empty()) throw BadInput("model '" + model.name() + "': " + motion.trouble);
  for (std::size_t i = 0; i < motion.states.size(); ++i)
    require_known(model, numbers, motion.states[i], times[i]);
  // Compares the routes at few of the times: the second has to end a step at each.
  constexpr std::size_t compared = 48;
  std::vector<double> few{times.front()};
  std::vector<std::size_t> places;
  const std::size_t frames = times.size() - 1, stride = (frames + compared - 1) / compared;
  for (std::size_t i = stride; i < frames; i += stride) places.push_back(i);
  places.push_back(frames);
  for (const std::size_t i : places) few.push_back(times[i]);
  const TrueMotion other = by_extrapolation(numbers, few);
  if (!other.trouble.empty())
    throw BadInput("model '" + model.name() + "', by extrapolation: " + other.trouble);

  const std::vector<long double> seen = observed(numbers, motion, times),
                                 second = observed(numbers, other, few);
  const std::size_t parts = numbers.observed.outputs().size();
  Known known{{seen.begin(), seen.end()}, 0, by};
  const double rounding = 2e-16 * size_of(known.value);
  double most = 0;
  std::size_t frame = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::size_t j = 0; j < parts; ++j) {
      const long double off = std::abs(seen[(places[k] - 1) * parts + j] - second[k * parts + j]);
      most = std::max(most, 4 * static_cast<double>(off));
    }
    for (; frame < places[k]; ++frame) known.error_until.push_back(most + rounding);
  }
  known.error = most + rounding;
  return known;
}

/// Checks that the file's conserved quantities are constant along the motion.
void require_conserved(const File& file, const ModelText& text, const Model& model) {
  std::vector<double> values, times;
  for (const ParameterText& p : file.parameters) values.push_back(p.value);
  for (int i = 0; i <= 8; ++i) times.push_back(file.end * i / 8);
  const Numbers numbers = model.with(values);
  if (!text.kinetic) return;
  const TrueMotion motion = by_series(numbers, times);
  std::array<long double, 2> first{}, now{};
  long double most = 0, moving = 0;
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    numbers.conserved.run(motion.states[i].data(), static_cast<long double>(times[i]), now.data());
    if (i == 0) first = now;
    most = std::max(most, std::abs(now[0] - first[0]));
    moving = std::max(moving, std::abs(now[1]));
  }
  if (!(most <= 1e-9L * moving))
    file.source.fail(text.kinetic->place, "this energy is not conserved: it changes by " +
                                              format_significant(static_cast<double>(most), 2) + " within " +
                                              format_shortest(file.end) + " s");
}

/// About a hundredth of the time; a power of two, so that steps of several files are comparable.
double longest_step(double end) { return std::exp2(std::floor(std::log2(end / 64))); }

/// Limits the operations of a trial by its evaluations, so that none of a long model takes minutes.
void limit_work(Quantity& motion, std::size_t in_an_evaluation) {
  constexpr double most_operations = 5e8;
  const double most = most_operations / static_cast<double>(in_an_evaluation + 1);
  for (auto* methods : {&motion.methods, &motion.methods_in_float})
    for (Method& method : *methods)
      method.run = [run = std::move(method.run), most](double setting) {
        const ode::EvaluationLimit limited(most);
        return run(setting);
      };
}

Quantity motion_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Kept& here = kept_with(p.declared().data());
  const File& file = *here.file;
  const std::vector<double> values = values_of(p);
  Known known{
      {std::numeric_limits<double>::quiet_NaN()}, std::numeric_limits<double>::quiet_NaN(), "not asked for"};
  if (!truth.folder().empty())
    known = true_motion(here.models.back(), here.models.back().with(values), horizon.times());
  Quantity motion =
      quantity("motion", file.observables.front().unit, file.title + " at " + times_up_to(horizon), known,
               {*std::ranges::min_element(file.errors),
                file.error_reason.empty() ? "the error that the file asks for" : file.error_reason});
  motion.needs = file.errors;
  std::vector<double> rounded(values);
  for (double& value : rounded) value = static_cast<double>(static_cast<float>(value));
  std::vector<std::string_view> names;
  std::vector<std::shared_ptr<const ModelInFloat>> in_float;
  std::size_t operations = 0;
  SceneMethods methods(motion, horizon, halving("step", longest_step(horizon.end), 9), tolerances());
  for (const Model& model : here.models) {
    const auto numbers = std::make_shared<const Numbers>(model.with(values));
    if (model.is_closed()) {
      methods.closed_form(model.name(), Closed{std::shared_ptr<const Program>(numbers, &numbers->observed)});
      continue;
    }
    operations = std::max(operations, numbers->rates.code().size());
    const AnyModel any = interpreted(numbers);
    methods.by_engine_integrators(model.name(), any);
    if (&model == &here.models.back()) methods.by_remaining_integrators(model.name(), any);
    if (model.has_events()) continue;
    names.push_back(model.name());
    in_float.push_back(
        interpreted_in_float(horizon, numbers, std::make_shared<const Numbers>(model.with(rounded))));
  }
  detail::add_in_float(motion, names, in_float, Outcome::ok);
  limit_work(motion, operations);
  return motion;
}

/// Energy of the last model's state. Makes its numbers again when the parameters change.
Energy energy_of(const Parameters& p, std::span<const double> places_and_rates) {
  thread_local const Model* of = nullptr;
  thread_local std::vector<double> values;
  thread_local Numbers numbers;
  const Model& model = kept_with(p.declared().data()).models.back();
  if (const auto now = values_of(p); of != &model || now != values) {
    of = &model;
    values = now;
    numbers = model.with(values);
  }
  const std::size_t half = places_and_rates.size() / 2;
  std::vector<double> state;
  for (const std::size_t i : model.seen_as()) state.push_back(places_and_rates[i]);
  for (const std::size_t i : model.seen_as()) state.push_back(places_and_rates[half + i]);
  std::array<double, 2> both{};
  numbers.conserved.run(state.data(), 0.0, both.data());
  return {both[0], both[1]};
}

engines::Staging staging_of(const Parameters& p) {
  return kept_with(p.declared().data()).staged->with(values_of(p));
}

Construction construction_of(const Model& model, const File& file) {
  if (model.has_events()) return {"", "as the printed loops look for no events"};
  try {
    const Model::Code code = model.code(file, false);
    std::string members;
    for (const std::string& one : code.members) members += (members.empty() ? "" : ", ") + one;
    return {"problem::" + code.type + "{" + members + "}", ""};
  } catch (const BadInput& error) {
    return {"", std::string("as ") + error.what()};
  }
}

Findings study(const Parameters& p, const Reference& truth) {
  const Kept& here = kept_with(p.declared().data());
  Findings findings;
  findings.claims = here.sheet->judged();
  if (here.entry->exercise.scene)
    findings.quantities.push_back(motion(*here.entry->exercise.scene, p, truth));
  return findings;
}

std::vector<Norm> norms_of(const File& file) {
  std::vector<Norm> norms;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < file.observables.size(); ++i) {
    const ObservableText& o = file.observables[i];
    const auto same = std::ranges::find(points, o.point);
    if (!o.point.empty() && same != points.end()) {
      norms[static_cast<std::size_t>(same - points.begin())].components.push_back(i);
      continue;
    }
    norms.push_back({o.unit, {i}});
    points.push_back(o.point);
  }
  return norms;
}

/// The parameters that differ from start to start: those that the file names, otherwise those in the start,
/// otherwise all.
std::vector<std::string_view> varied(const Kept& here) {
  std::vector<std::string_view> names;
  for (const std::string& name : here.file->vary) names.emplace_back(name);
  if (!names.empty()) return names;
  for (const std::size_t i : here.models.back().starts_with()) names.push_back(here.parameters[i].name);
  if (!names.empty()) return names;
  for (const Parameter& p : here.parameters)
    if (!p.whole) names.push_back(p.name);
  return names;
}

std::string code_of(const Parameters& p, std::string_view model) {
  const Kept& here = kept_with(p.declared().data());
  const auto its = std::ranges::find(here.models, model, &Model::name);
  const ModelText& text = here.file->models[static_cast<std::size_t>(its - here.models.begin())];
  return "namespace oddity::problem {\n\n" + comment_of(*here.file, text) +
         its->code(*here.file, its->with(values_of(p)).partitioned).text +
         "\n}  // namespace oddity::problem\n";
}

Scene scene_of(const Kept& here) {
  const File& file = *here.file;
  Scene scene{.motion = motion_of,
              .horizon = file.end,
              .game_tolerance = *std::ranges::min_element(file.errors),
              .sweep_parameter = {},
              .sweep_values = {},
              .perturbed_parameters = varied(here)};
  scene.sweep_parameter =
      file.sweep.empty() ? scene.perturbed_parameters.front() : std::string_view(file.sweep);
  scene.sweep_values = file.sweep_values;
  if (scene.sweep_values.empty()) {
    const Parameter& p = *std::ranges::find(here.parameters, scene.sweep_parameter, &Parameter::name);
    for (const double part : {0.5, 0.75, 1.25, 1.5, 2.0}) {
      const double value = p.value * part;
      if (value != 0 && p.least <= value && value <= p.most && !p.whole) scene.sweep_values.push_back(value);
    }
  }
  for (const ObservableText& o : file.observables) scene.axes.observables.emplace_back(o.name);
  scene.axes.norms = norms_of(file);
  if (here.models.back().conserves() && !here.models.back().seen_as().empty()) scene.laws.energy = energy_of;
  scene.is_linear = here.models.back().is_linear();
  if (here.staged) scene.staging = staging_of;
  scene.listing.text = code_of;
  for (std::size_t i = 0; i < here.models.size(); ++i)
    if (const Construction& made = here.constructions[i]; made.code.empty())
      scene.listing.not_printable.emplace_back(here.models[i].name(), made.why_not);
    else
      scene.listing.models.emplace_back(here.models[i].name(), made.code);
  return scene;
}

/// The unknown with the widest range.
struct Widest {
  double range = 0;
  std::size_t unknown = 0;
};
Widest widest(std::span<const std::vector<long double>> states) {
  Widest most;
  for (std::size_t i = 0; i < states[0].size(); ++i) {
    const auto [low, high] = std::ranges::minmax(states, {}, [i](const auto& x) { return x[i]; });
    if (const auto range = static_cast<double>(high[i] - low[i]); range > most.range) most = {range, i};
  }
  return most;
}

/// A motion until it ends or is no longer known: its states at as many of the times as it reached.
struct Followed {
  std::vector<double> times;
  std::vector<std::vector<long double>> states;
  std::string why_no_longer = {};  ///< empty: it reached all
};

/// Follows the file's motion, and one disturbed by a part in 10^12.
Followed followed(const Model& model, const std::vector<double>& parameters, double longest) {
  const Numbers numbers = model.with(parameters);
  Numbers disturbed = numbers;
  for (long double& x : disturbed.start) x += 1e-12L * (x == 0 ? 1 : std::abs(x));
  constexpr std::size_t looks = 256;
  // Some seconds' work; a TOML file with an error and a horizon may take longer.
  const auto operations = static_cast<long>(numbers.rates.code().size());
  // Half of the reference's limit: its other route takes more steps on a stiff motion, and other starts may
  // be harder.
  const long steps = std::clamp(6'000'000 / (operations + 1), 1'000L, most_steps / 2);
  // Lengthens the time in a few passes, so that chaos is not computed further than necessary.
  for (double end = longest / 64;; end = std::min(4 * end, longest)) {
    Followed all;
    for (std::size_t i = 0; i <= looks; ++i) all.times.push_back(end * static_cast<double>(i) / looks);
    TrueMotion motion = by_series_within(numbers, all.times, steps),
               beside = by_series_within(disturbed, all.times, steps);
    for (const TrueMotion* one : {&motion, &beside})
      if (all.why_no_longer.empty()) all.why_no_longer = one->trouble;
    all.states = std::move(motion.states);
    all.states.resize(std::min(all.states.size(), beside.states.size()));
    const double error = widest(all.states).range / 1000;
    const auto apart = [&](std::size_t i) {
      long double off = 0;
      for (std::size_t k = 0; k < numbers.unknowns; ++k)
        off = std::max(off, std::abs(all.states[i][k] - beside.states[i][k]));
      return off > error && error > 0;
    };
    for (std::size_t i = 1; i < all.states.size(); ++i)
      if (apart(i)) {
        all.why_no_longer = "a disturbance of a part in 10^12 grows to that error soon after";
        all.states.resize(i);
      }
    if (!all.why_no_longer.empty() || end >= longest) return all;
  }
}

/// The need for a file that gives none. The error is a thousandth of the widest range of a variable. The
/// horizon ends where a disturbance of a part in 10^12 has grown to that error: no method in double could go
/// further. It also ends where the true motion does.
void ask_by_motion(File& file) {
  const Model model(file, file.models.front());
  std::vector<double> values;
  for (const ParameterText& p : file.parameters) values.push_back(p.value);
  require_start(file, file.models.front(), model);
  Followed motion = followed(model, values, file.end);
  std::span<const std::vector<long double>> states = motion.states;
  if (!motion.why_no_longer.empty()) {
    constexpr std::size_t fewest = 16;
    if (states.size() < fewest) file.source.fail(file.models.front().name.place, motion.why_no_longer);
    file.horizon_reason = " (its total is " + file.horizon + "), as " + motion.why_no_longer;
    file.end = *parse_number(format_significant(0.95 * motion.times[states.size() - 1], 2));
    file.horizon = format_shortest(file.end);
    const auto end = std::ranges::upper_bound(motion.times, file.end);
    states = states.first(std::min(states.size(), static_cast<std::size_t>(end - motion.times.begin())));
  }
  const Widest its = widest(states);
  const double error = *parse_number(format_significant(its.range > 0 ? its.range / 1000 : 1e-3, 1));
  file.errors = {error};
  file.error = format_shortest(error);
  file.error_reason = "a thousandth of the widest range, that of " + file.observables[its.unknown].name;
  file.horizon_reason = "up to " + (file.horizon_reason.empty() ? "its total of " + file.horizon
                                                                : file.horizon + file.horizon_reason);
  // A horizon is a whole number of frames: few of them could take a shortened one beyond the motion's end.
  constexpr double most_frames = 1000;
  const double least_frames = motion.why_no_longer.empty() ? 0 : 100,
               frames = *parse_number(file.frames_per_second) * file.end;
  if (!(frames >= least_frames && frames <= most_frames))
    file.frames_per_second = format_shortest(std::clamp(frames, least_frames, most_frames) / file.end);
}

std::unique_ptr<const File> file_of(const std::string& name, const std::string& text) {
  if (!is_ode_file(name)) return read(name, text);
  auto file = read_ode(name, text);
  ask_by_motion(*file);
  return file;
}

}  // namespace

std::string stem_of(const std::string& path) {
  std::string stem = path.substr(path.rfind('/') + 1);
  if (stem.ends_with(".toml")) stem.resize(stem.size() - 5);
  if (is_ode_file(stem)) stem.resize(stem.size() - 4);
  const bool is_name = stem.find_first_not_of('.') != std::string::npos && !stem.starts_with('-');
  return is_name ? stem : "input";
}

bool is_file(const std::string& word) { return word == "-" || word.ends_with(".toml") || is_ode_file(word); }

const Entry& entry_of_text(const std::string& name, const std::string& text) {
  {
    const std::lock_guard lock(kept().mutex);
    if (const auto known = kept().by_source.find({name, text}); known != kept().by_source.end())
      return *known->second;
  }
  auto made = std::make_unique<Kept>();
  made->file = file_of(name, text);
  made->of_text = name + " of " + std::to_string(std::hash<std::string>()(text));
  for (const ModelText& model : made->file->models) made->models.emplace_back(*made->file, model);
  for (const ParameterText& p : made->file->parameters)
    made->parameters.push_back({p.name, p.value, p.unit, p.says, p.least, p.most, p.whole});
  made->parameters.reserve(1);  // views identify a file by the addresses of these
  require_parameters(*made->file);
  for (std::size_t i = 0; i < made->models.size(); ++i)
    if (const Model& model = made->models[i]; !model.is_closed()) {
      require_start(*made->file, made->file->models[i], model);
      require_conserved(*made->file, made->file->models[i], model);
    }
  for (const Model& model : made->models) made->constructions.push_back(construction_of(model, *made->file));
  made->sheet = std::make_unique<const Sheet>(*made->file, stem_of(name));
  if (made->file->staged) made->staged = std::make_unique<const Staged>(*made->file);
  Exercise exercise{made->file->title, made->file->question, made->parameters, {}, study};
  if (!made->models.empty()) exercise.scene = scene_of(*made);
  made->entry =
      std::make_unique<Entry>(Entry{number_of_file(stem_of(name)), made->of_text, std::move(exercise)});
  const std::lock_guard lock(kept().mutex);
  kept().all.push_back(std::move(made));
  return *(kept().by_source[{name, text}] = kept().all.back()->entry.get());
}

namespace {

/// Reads a stream. Throws BadInput if it is longer than a problem's file may be.
std::string all_of(std::istream& in, const std::string& name) {
  std::string text(most_of_a_file + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > most_of_a_file) throw BadInput(name + ": a problem's file has at most a megabyte");
  return text;
}

}  // namespace

const Entry& entry_of_file(const std::string& path) {
  static std::map<std::string, const Entry*> read_already;
  const Entry*& entry = read_already[path];
  if (entry) return *entry;
  if (path != "-") return *(entry = &entry_of_text(path, read_whole(path, most_of_a_file)));
  return *(entry = &entry_of_text("standard input", all_of(std::cin, "standard input")));
}

const Source& source_of(const Entry& entry) {
  return kept_with(entry.exercise.parameters.data()).file->source;
}

const Verdicts& stated_by(const Entry& entry) {
  return kept_with(entry.exercise.parameters.data()).sheet->stated();
}

Asked asked_by(const Entry& entry) {
  const File& file = *kept_with(entry.exercise.parameters.data()).file;
  return {file.error, file.horizon, file.frames_per_second, file.error_reason, file.horizon_reason};
}

}  // namespace oddity::problem
