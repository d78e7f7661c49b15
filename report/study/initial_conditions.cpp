#include "report/study/initial_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/in_long_double.hpp"
#include "reference/text.hpp"
#include "reference/truth.hpp"
#include "report/study/frames.hpp"
#include "report/study/kicks.hpp"
#include "report/study/parallel.hpp"
#include "report/study/policy.hpp"

namespace oddity {

namespace {

constexpr double nearby = 0.1;

/// Relative to the need; an error beyond the need is then known to one digit.
constexpr double well_enough = 0.1;

bool is_known_well_enough(const Quantity& motion) {
  return motion.reference_error <= well_enough * motion.need.allowed;
}

/// The routes differ widely before the end, as their roundings have grown. A tighter bound helps little.
bool is_lost(const Quantity& motion) {
  constexpr double part = 1e-2;
  return motion.reference_error > part * size_of(motion.reference.value);
}

/// Frame counts at which to check whether a path is lost already, and the whole: together these take little
/// of the whole's time.
std::vector<int> parts_of(const Need& need) {
  constexpr int shorter = 8, least = 2400;
  std::vector<int> parts{static_cast<int>(need.frames())};
  if (need.criterion == Criterion::path && !need.relative)
    while (parts.front() / shorter >= least) parts.insert(parts.begin(), parts.front() / shorter);
  return parts;
}

std::optional<Start> where_known(const std::function<Start()>& make) {
  try {
    return make();
  } catch (const OutOfTime&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // no reference
    return {};
  }
}

Quantity with_need(Quantity motion, const Need& need) {
  motion.needs = needs_of(need, motion);
  motion.need = {*std::ranges::min_element(motion.needs), "asked for"};
  return motion;
}

}  // namespace

OnStart Attempts::at(const Candidate& candidate, const std::function<OnStart()>& make) {
  const Which which{candidate.model, candidate.algorithm, candidate.setting};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = all_.find(which); found != all_.end()) return found->second;
  }
  OnStart made = make();
  const std::lock_guard lock(mutex_);
  if (made.outcome != Outcome::stalled) all_[which] = made;  // may succeed with more evaluations
  return made;
}

void Failures::add(const std::string& start, const Candidate& candidate, const OnStart& on) {
  const std::lock_guard lock(mutex_);
  all_[{start, candidate.model, candidate.algorithm, candidate.setting}] = on;
}

std::optional<OnStart> Failures::find(const std::string& start, const Candidate& candidate) const {
  const std::lock_guard lock(mutex_);
  const auto found = all_.find({start, candidate.model, candidate.algorithm, candidate.setting});
  return found == all_.end() ? std::optional<OnStart>() : found->second;
}

void Failures::add(const Failures& shorter) {
  const std::scoped_lock lock(mutex_, shorter.mutex_);
  all_.insert(shorter.all_.begin(), shorter.all_.end());
}

bool is_known_well(const Quantity& motion) {
  constexpr double part = 1e-6;
  return motion.reference_error <= part * *std::ranges::min_element(motion.needs);
}

int digits_for(const Need& need) {
  const double least = need.relative ? need.error : std::min(need.error_in("m"), need.error_in("rad"));
  return std::clamp(12 + static_cast<int>(std::ceil(-std::log10(least))), digits_in_long_double + 1,
                    truth::spot_digits);
}

Need game_need() {
  Need need{degree};
  need.errors = {{"m", centimeter}};
  return need;
}

double game_error(std::string_view unit) { return unit == "m" ? centimeter : degree; }

std::vector<double> needs_of(const Need& need, const Quantity& motion) {
  const double scale = need.relative ? size_of(motion.reference.value) : 1;
  std::vector<double> needs;
  for (std::string_view unit : motion.units()) needs.push_back(need.error_in(unit) * scale);
  return needs;
}

Quantity known_motion(const Scene& scene, const Parameters& p, const Horizon& horizon, const Need& need,
                      const Reference& truth) {
  const auto made = [&](const Reference& known) {
    return with_need(motion_at_frames(scene, p, horizon, known, need.kicks), need);
  };
  if (need.thorough) return made(truth);
  for (int digits : {digits_in_long_double, digits_for(need)}) {
    Quantity seen = made(truth.to_digits(digits));
    if (is_known_well(seen)) return seen;
  }
  return made(truth);
}

Need with_ways(Need need, const Task& task, const Reference& truth) {
  if (!need.kicks || !task.entry->exercise.scene) return need;
  const Quantity without = motion(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                  truth.to_digits(digits_in_long_double));
  if (finite(without.reference.value)) need.kicks = with_ways(need.kicks, without);
  return need;
}

InitialConditions::InitialConditions(const Task& task, const Need& need, const Reference& truth,
                                     std::shared_ptr<const PartJudged> part)
    : task_(task), need_(need), truth_(truth), part_(std::move(part)) {
  if (!task.entry->exercise.scene)
    throw BadInput("exercise " + to_string(task.entry->number) + " has no motion to choose a method for");
  for (const auto& [name, value] :
       {std::pair("error", need.error), std::pair("horizon", need.horizon),
        std::pair("frame rate", need.frames_per_second), std::pair("budget", need.budget)})
    if (!(value > 0))
      throw BadInput("the " + std::string(name) + " must be positive, and is " + format_shortest(value));
  if (need.frames() < 1) throw BadInput("the horizon is shorter than a frame");
}

std::string InitialConditions::says(const Parameters& p) const {
  std::string says;
  for (std::string_view name : scene().perturbed_parameters)
    says += (says.empty() ? "" : ", ") + std::string(name) + " = " + format_significant(p[name], 4);
  return says;
}

Start InitialConditions::to_judge(Start start, const Parameters& p) const {
  if (need_.criterion == Criterion::path)
    start.parting =
        std::make_shared<Lazy<Parting>>([this, p, motion = start.motion] { return parting(p, motion); });
  if (needs_energy(need_))
    start.energy =
        std::make_shared<Lazy<TrueEnergy>>([motion = start.motion] { return true_energy(motion); });
  return start;
}

Start InitialConditions::well_known(const Parameters& p) const {
  return to_judge({says(p), known_motion(scene(), p, horizon_of(need_), need_, truth_)}, p);
}

/// The start with the first frames of its motion, or all.
Start InitialConditions::known_by(const Parameters& p, const Reference& truth, int frames) const {
  const bool is_whole = frames == static_cast<int>(need_.frames());
  const Horizon span = is_whole ? horizon_of(need_) : oddity::first_frames(need_, frames);
  Start start =
      to_judge({says(p), with_need(motion_at_frames(scene(), p, span, truth, need_.kicks), need_)}, p);
  start.is_whole = is_whole;
  return start;
}

/// Over a long horizon in double, unless roundings grow too much.
Start InitialConditions::start(const Parameters& p) const {
  if (need_.thorough || need_.criterion == Criterion::period) return well_known(p);
  const std::vector<int> parts = parts_of(need_);
  if (need_.frames() < policy.least_frames ||
      std::ranges::any_of(criteria_of(need_),
                          [](Criterion criterion) { return criterion != Criterion::path; }))
    return start_in_long_double(p);
  for (const int count : parts) {
    if (part_ && part_->was_known && count != parts.back()) continue;
    Start start = known_by(p, truth_.to_digits(digits_in_double), count);
    if (start.motion.reference_error > known_very_well * start.motion.need.allowed) break;
    if (!start.is_whole) continue;
    if (!is_known_well(start.motion))
      start.sharper = std::make_shared<Lazy<Start>>([this, p] { return start_in_long_double(p); });
    return start;
  }
  return start_in_long_double(p);
}

/// More digits can decide only for a path: for conserved or bounded quantities the truth shows nothing. A
/// motion that is lost in its first part is computed further only if some method passes up to there.
Start InitialConditions::start_in_long_double(const Parameters& p) const {
  const int whole = static_cast<int>(need_.frames());
  const std::vector<int> parts = parts_of(need_);
  int count = parts.front();
  Start start = known_by(p, truth_.to_digits(digits_in_long_double), count);
  for (std::size_t i = 1; i < parts.size() && !is_lost(start.motion); ++i)
    start = known_by(p, truth_.to_digits(digits_in_long_double), count = parts[i]);
  if (need_.criterion != Criterion::path || is_known_well(start.motion)) return start;
  if (is_lost(start.motion)) start = as_long_as_known(start, p);
  start.sharper = std::make_shared<Lazy<Start>>([this, p, count, whole] {
    const Start repeated = known_by(p, truth_.repeated(), count);
    Start known = as_long_as_known(repeated, p);
    // The motion with more digits, a little beyond the part that long double resolves, where it is not lost
    // yet.
    const int later = std::min(whole, known.motion.samples + (known.motion.samples + 3) / 4);
    known.sharper = std::make_shared<Lazy<Start>>([this, p, repeated, later, whole] {
      const auto in_the_end = [this, p, repeated] {
        return where_known([&] { return well_known(p); }).value_or(repeated);
      };
      if (later == whole) return in_the_end();
      auto part = where_known([&] {
        return to_judge(
            {says(p), known_motion(scene(), p, oddity::first_frames(need_, later), need_, truth_)}, p);
      });
      if (!part || !is_known_well_enough(part->motion)) return in_the_end();
      part->is_whole = false;
      part->sharper = std::make_shared<Lazy<Start>>(in_the_end);
      return *part;
    });
    return known;
  });
  return start;
}

/// A method that fails on the whole of a chaotic motion nearly always fails on this part as well.
Start InitialConditions::as_long_as_known(const Start& whole, const Parameters& p) const {
  const Quantity& all = whole.motion;
  const auto known = std::ranges::count_if(
      all.reference_error_until, [&](double error) { return error <= well_enough * all.need.allowed; });
  if (need_.relative || known == 0 || known == all.samples) return whole;
  const int count = static_cast<int>(known);
  const std::size_t parts = all.reference.value.size() / static_cast<std::size_t>(all.samples);
  Quantity known_motion =
      motion_at_frames(scene(), p, oddity::first_frames(need_, count), Reference::nothing(), need_.kicks);
  const std::span<const double> value(&*all.reference.value.begin(), static_cast<std::size_t>(count) * parts);
  known_motion.reference = {all.reference.by, Value(value)};
  known_motion.reference_error = all.reference_error_until[static_cast<std::size_t>(count) - 1];
  known_motion.needs = all.needs;
  known_motion.need = all.need;
  Start start{says(p), std::move(known_motion)};
  start.is_whole = false;
  return to_judge(std::move(start), p);
}

Start InitialConditions::required(Start start) const {
  const double error = start.motion.reference_error,
               part = error == 0 ? 0 : error / size_of(start.motion.reference.value);
  if (need_.criterion == Criterion::path && start.motion.need.allowed < error)
    throw BadInput("the true motion is known to " + format_significant(error, 2) +
                   ", and the error asked for is smaller");
  if (needs_period() && need_.error_by(Criterion::period) < part)
    throw BadInput("the true motion is known to " + format_significant(part, 2) +
                   ", relative to its size; the requested error of the period is smaller");
  if (!is_comparable(start))
    throw BadInput("the motion has no two periods within the horizon: ask for a longer one");
  if (start.energy && need_.error_by(Criterion::energy) < (**start.energy).known_to)
    throw BadInput("the true motion's energy is known to " +
                   format_significant((**start.energy).known_to, 2) +
                   " relative to its moving part, and the requested error is smaller");
  const double rounding = rounding_of(Criterion::constraint, start.motion);
  if (std::ranges::count(criteria_of(need_), Criterion::constraint) > 0 &&
      need_.error_by(Criterion::constraint) < rounding)
    throw BadInput("constraints are known to " + format_significant(rounding, 2) +
                   " m, because of rounding, and the requested length is smaller");
  return start;
}

Start InitialConditions::asked() const { return required(well_known(task_.parameters)); }

Start InitialConditions::asked_to_choose() const {
  Start asked = start(task_.parameters);
  if (asked.sharper && !asked.is_whole) asked = Start(**asked.sharper);
  while (asked.sharper && !is_known_well_enough(asked.motion)) asked = Start(**asked.sharper);
  if (asked.sharper)
    asked.sharper =
        std::make_shared<Lazy<Start>>([this, known = asked.sharper] { return required(**known); });
  asked.attempts = std::make_shared<Attempts>();
  asked.part = part_;
  return required(std::move(asked));
}

Parameters InitialConditions::drawn() {
  Parameters p = task_.parameters;
  for (std::string_view name : scene().perturbed_parameters) {
    const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
    const double value = p[name], size = value == 0 ? 1 : std::abs(value);
    p.set(name, std::clamp(value + size * random_.between(-nearby, nearby), declared->least, declared->most));
  }
  return p;
}

/// Leaves out starts of another kind than the requested one, and draws again.
std::vector<Parameters> InitialConditions::draw(int count) {
  constexpr int most_draws = 1000;
  std::vector<Parameters> all;
  for (int draws = 0; all.size() < static_cast<std::size_t>(count) && draws < most_draws; ++draws) {
    Parameters p = drawn();
    if (scene().kind && scene().kind(p) != scene().kind(task_.parameters))
      ++left_out_[std::string(scene().kind(p))];
    else
      all.push_back(std::move(p));
  }
  return all;
}

Parting InitialConditions::parting(const Parameters& start, const Quantity& motion) const {
  constexpr double small = 1e-9, fine = 1e-13;
  Parameters p = start;
  const std::string_view name = scene().perturbed_parameters.front();
  const double value = p[name], change = small * (value == 0 ? 1 : std::abs(value));
  const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
  p.set(name, value + change <= declared->most ? value + change : value - change);
  const Quantity beside = motion_at_frames(scene(), p, oddity::first_frames(need_, motion.samples),
                                           Reference::nothing(), need_.kicks);
  const auto best = std::find_if(beside.methods.rbegin(), beside.methods.rend(), [this](const Method& m) {
    return m.algorithm == "Fehlberg 7(8)" &&
           std::ranges::find(scene().faulted, m.model) == scene().faulted.end();
  });
  if (best == beside.methods.rend()) return {};
  Parting parting = parting_of(motion, run(beside, *best, fine).answer.value, small);
  parting.is_chaotic = parting.is_chaotic && !scene().is_linear;
  return parting;
}

Quantity InitialConditions::first_frames(int count) const {
  return motion_at_frames(scene(), task_.parameters, oddity::first_frames(need_, count), Reference::nothing(),
                          need_.kicks);
}

std::optional<Start> InitialConditions::start_if_known(const Parameters& p) const {
  return where_known([&] {
    Start beside = start(p);
    beside.attempts = std::make_shared<Attempts>();
    beside.part = part_;
    return beside;
  });
}

bool InitialConditions::needs_period() const {
  return std::ranges::count(criteria_of(need_), Criterion::period) > 0;
}

bool InitialConditions::is_comparable(const Start& start) const {
  return !needs_period() || !start.is_whole || has_period(start.motion);
}

std::vector<Start> InitialConditions::nearby_starts(int count, const AfterEach& after_each) {
  return with_asked({}, count, after_each);
}

std::vector<Start> InitialConditions::asked_and_nearby(int count, const AfterEach& after_each) {
  return with_asked([this] { return asked_to_choose(); }, count, after_each);
}

std::vector<Start> InitialConditions::with_asked(const std::function<Start()>& asked, int count,
                                                 const AfterEach& after_each) {
  constexpr int most_draws = 4;
  std::vector<Start> all;
  for (int draws = 0, missing = count; draws == 0 || (missing > 0 && draws < most_draws); ++draws) {
    const std::vector<Parameters> drawn = draw(missing);
    std::vector<std::optional<Start>> made(drawn.size());
    std::optional<Start> first;
    in_parallel(drawn.size() + 1, [&](std::size_t i) {
      if (i > 0)
        made[i - 1] = start_if_known(drawn[i - 1]);
      else if (draws == 0 && asked)
        first = asked();
      if (draws == 0 && (i > 0 || asked)) after_each();
    });
    if (first) {
      parting_ = first->parting;
      all.push_back(std::move(*first));
    }
    missing = 0;
    for (auto& start : made) {
      if (!start) continue;
      if (parting_) start->parting = parting_;
      if (is_comparable(*start)) {
        all.push_back(std::move(*start));
      } else {
        ++left_out_["without two periods within the horizon"];
        ++missing;
      }
    }
  }
  return all;
}

}  // namespace oddity
