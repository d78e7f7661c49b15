#include "report/study/choose.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <ranges>
#include <set>
#include <span>
#include <thread>
#include <utility>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/criterion.hpp"
#include "report/study/in_time.hpp"
#include "report/study/off_by_need.hpp"
#include "report/study/parallel.hpp"
#include "report/study/time.hpp"
#include "report/study/tries.hpp"
#include "solvers/ode/catalog.hpp"
#include "solvers/stop.hpp"

namespace oddity {

namespace {

constexpr int rounds = 4;
/// Of a need's starts: those beside the one asked for on which is chosen, and those on which that is tested;
/// or, where it is judged on the one asked for alone, on which is told how it does.
int seen_beside(const Need& need) { return std::min(2, need.starts - 1); }
int unseen_starts(const Need& need) {
  constexpr int told_of = 5;
  return need.starts == 1 ? told_of : need.starts - 1 - seen_beside(need);
}
/// Costs that differ by no more are the same to an engineer, and to the clock of another machine.
constexpr double near_tie = 1.25;
/// Whatever the spread: on a busy machine it says nothing.
constexpr double noisy_tie = 2;

/// How simple an algorithm is: its place in the catalog, which goes from the plainest on; before all of them
/// what is none of it, a closed form.
std::size_t simplicity(std::string_view algorithm) {
  const auto all = ode::catalog();
  const auto found = std::ranges::find_if(all, [&](const ode::CatalogEntry& entry) {
    return entry.name == algorithm || in_float(entry.name) == algorithm;
  });
  return found == all.end() ? 0 : 1 + static_cast<std::size_t>(found - all.begin());
}

bool is_multistep(std::string_view algorithm) {
  return std::ranges::any_of(ode::catalog(), [&](const ode::CatalogEntry& entry) {
    return entry.history && (entry.name == algorithm || in_float(entry.name) == algorithm);
  });
}

bool is_simple(std::string_view knob, std::string_view algorithm) {
  return (knob.empty() || knob == "step") && !is_multistep(algorithm);
}
bool is_simple(const Candidate& t) { return is_simple(t.knob, t.algorithm); }

bool named_by(const std::vector<std::string>& words, const Method& method) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return method.model.find(word) != std::string::npos || method.algorithm.find(word) != std::string::npos;
  });
}

bool wanted(const Need& need, const Method& method) {
  if (!(method.precision == Precision::in_float ? need.in_float : need.in_double)) return false;
  if (!need.only.empty() && !named_by(need.only, method)) return false;
  return !named_by(need.exclude, method) && !(need.one_step && is_multistep(method.algorithm));
}

/// Adds the time of its life.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Everything tried, and the search through a method's settings.
class Search {
 public:
  Search(const Task& task, const Need& need, const Reference& truth, const Price& price,
         const Progress& progress, std::shared_ptr<const PartJudged> part)
      : task_(task),
        need_(need),
        price_(price),
        progress_(progress),
        truth_(truth.watched([this](double done) {
          check_stop();
          if (motions_) motions_->come_to(done);
        })),
        starts_(task, need, truth_, std::move(part)) {
    seen_.reserve(static_cast<std::size_t>(1 + seen_beside(need) +
                                           rounds * unseen_starts(need)));  // tries_ point into the first
    make_starts();
    const Quantity& motion = seen_.front().motion;
    for (const auto* methods : {&motion.methods, &motion.methods_in_float})
      for (const Method& method : *methods)
        if (wanted(need, method) && can_be_judged(need, motion, method)) tries_.emplace_back(method, need);
    if (tries_.empty()) throw BadInput("no method is left; this scene has " + names());
    std::vector<const Method*> left;
    for (const Tries& t : tries_) left.push_back(&t.method());
    require_constraint(need, motion, left);
  }

  Choice choose() {
    try_all("trying the methods");
    Picked picked;
    for (int round = 1;; ++round) {
      picked = pick_cheapest();
      if (!picked.chosen || holds_elsewhere(*picked.chosen)) break;
      picked.chosen.reset();
      if (round == rounds) break;
      take_more_starts();
      try_all("trying them on more starts");
    }
    return summary(picked);
  }

 private:
  void make_starts() {
    const Stopwatch watch(spent_.truths);
    motions_.emplace(progress_, "making the true motions", static_cast<std::size_t>(1 + seen_beside(need_)));
    for (Start& start : starts_.asked_and_beside(seen_beside(need_), [this] { motions_->add(); }))
      seen_.push_back(std::move(start));
    motions_.reset();  // what is made of them later, when a method asks for it, is part of trying that
  }

  /// Made when something holds on those seen.
  const std::vector<Start>& unseen() {
    if (unseen_) return *unseen_;
    const Stopwatch watch(spent_.truths);
    motions_.emplace(progress_, "making more true motions", static_cast<std::size_t>(unseen_starts(need_)));
    unseen_ = starts_.beside(unseen_starts(need_), [this] { motions_->add(); });
    motions_.reset();
    return *unseen_;
  }

  /// The unseen are seen from now on.
  void take_more_starts() {
    std::ranges::move(*unseen_, std::back_inserter(seen_));
    unseen_.reset();
    for (Tries& tries : tries_) tries.again(need_);
  }

  /// On the starts that it was not chosen on.
  bool holds_elsewhere(Candidate& chosen) {
    const std::vector<Start>& starts = unseen();
    const Stopwatch watch(spent_.tests);
    ++spent_.rounds;
    if (need_.starts <= 1 + seen_beside(need_)) {
      chosen.unseen_error = chosen.error;
      for (const Start& start : starts)
        failing_beside_ +=
            !oddity::evaluate(std::span(&start, 1), method(chosen), chosen.setting, need_).holds();
      return true;
    }
    const Candidate test = oddity::evaluate(starts, method(chosen), chosen.setting, need_);
    chosen.unseen_error = test.error;
    refuted_on_ = test.where;
    return test.holds() && !starts.empty();
  }

  static std::vector<double> sizes_of(const Quantity& motion) {
    const Value& truth = motion.reference.value;
    const std::size_t parts = truth.size() / static_cast<std::size_t>(motion.samples);
    std::vector<double> still;
    for (std::size_t i = 0; i < truth.size(); ++i) still.push_back(truth[i % parts]);
    return motion.errors(Value(std::move(still)));
  }

  const Method& method(const Candidate& candidate) const {
    return *method_of(seen_.front().motion, candidate.model, candidate.algorithm);
  }

  std::string names() const {
    std::string all;
    for (const Method& m : seen_.front().motion.methods)
      all += (all.empty() ? "" : "; ") + m.model + " by " + m.algorithm;
    return all;
  }

  using Which = std::function<bool(const Tries&)>;

  bool may_meet_objective(const Tries& t) const {
    const Method& m = t.method();
    return t.may_hold_with_margin() &&
           (need_.objective == Objective::cheapest || is_simple(m.knob.name, m.algorithm));
  }

  /// Where that failed which was picked last; then where those fail that hold on the start asked for, from
  /// the one with most of them on. To be known between stages, so that what is tried does not depend on which
  /// thread came first.
  std::vector<std::string> hardest_starts() const {
    std::map<std::string, int> failed;
    for (const Tries& tries : tries_)
      for (const Candidate& t : tries.candidates)
        if (!t.holds() && t.where != seen_.front().says) ++failed[t.where];
    std::vector<std::string> hardest;
    for (const auto& [says, count] : failed) hardest.push_back(says);
    std::ranges::stable_sort(hardest, std::greater(), [&](const auto& says) { return failed[says]; });
    hardest.insert(hardest.begin(), refuted_on_);
    return hardest;
  }

  /// Those methods, in parallel, on to the first setting that holds with the margin or takes more work.
  void try_all(const std::string& stage, double most_evaluations, const Which& which) {
    const Stopwatch watch(spent_.search);
    const std::vector<std::string> hardest = hardest_starts();
    std::vector<Tries*> costliest_first;
    for (Tries& tries : tries_)
      if (which(tries)) costliest_first.push_back(&tries);
    std::ranges::stable_sort(costliest_first, std::greater(), &Tries::expected_evaluations);
    Stage tally(progress_, stage, costliest_first.size());
    parallel_for_each(costliest_first, [&](Tries* tries) {
      tries->go_on(most_evaluations, seen_, need_, hardest);
      tally.add();
    });
  }

  /// With ever more work, until something holds that the objective wants: once anything holds, by what it may
  /// want.
  void try_all(const std::string& stage) {
    constexpr double little = 16, more = 4, unlimited = std::numeric_limits<double>::infinity();
    const double most_of_all = is_beyond_double() ? more * little : unlimited;
    const auto any = [&](const std::function<bool(const Candidate&)>& is) {
      return std::ranges::any_of(tries_,
                                 [&](const Tries& t) { return std::ranges::any_of(t.candidates, is); });
    };
    Which which = [](const Tries&) { return true; };
    for (double most = need_.thorough ? unlimited : little; most <= most_of_all; most *= more) {
      try_all(stage, most, which);
      if (any([&](const Candidate& t) { return meets_objective(t); })) return;
      if (any(&Candidate::holds)) which = [this](const Tries& t) { return may_meet_objective(t); };
      if (std::ranges::all_of(tries_, [&](const Tries& t) { return t.is_over() || !which(t); })) return;
    }
  }

  /// Long double itself, whose roundings are 2,048 times smaller, loses the path before its end, in chaos.
  bool is_beyond_double() const {
    const Start& asked = seen_.front();
    return !asked.is_whole && asked.parting && (**asked.parting).is_chaotic;
  }

  /// One setting more of each that fails where that may cost so much. Whether there was one.
  bool try_on(const std::function<double(const Tries&)>& seconds_per_frame) {
    const Stopwatch watch(spent_.search);
    std::atomic<bool> any = false;
    parallel_for_each(tries_, [&](Tries& tries) {
      if (tries.is_over() || tries.is_given_up() || !(tries.expected_seconds() < seconds_per_frame(tries)))
        return;
      tries.go_on(tries.expected_evaluations(), seen_, need_);
      any = true;
    });
    return any;
  }

  struct Picked {
    std::optional<Candidate> chosen = {};
    bool by_objective = true;
  };

  Picked pick() {
    measure_to_choose_from(&Tries::Found::with_margin, true);
    if (auto chosen = pick(true)) return {chosen, true};
    measure_to_choose_from(&Tries::Found::first, false);
    return {pick(false), false};
  }

  /// When finer settings of all that fails would cost more than what is chosen, they cannot be. What may be
  /// chosen instead may tie with it; what the objective prefers to it may cost as much as the budget allows.
  Picked pick_cheapest() {
    while (true) {
      const Picked picked = pick();
      const auto limit = [&](const Tries& t) {
        if (!picked.chosen || (!picked.by_objective && may_meet_objective(t))) return need_.budget;
        const bool may_tie = may_meet_objective(t) == picked.by_objective;
        return (may_tie ? noisy_tie : 1) * picked.chosen->seconds_per_frame;
      };
      if (is_beyond_double() || !try_on(limit)) return picked;
    }
  }

  /// Of each method one setting, to tell by what others would cost; and what may be chosen, unless it is
  /// expected to cost several times as much as the cheapest.
  void measure_to_choose_from(Candidate* Tries::Found::*may_be_chosen, bool by_objective) {
    constexpr double several = 2 * noisy_tie;
    const auto may_be = [&](Tries& tries) -> Candidate* {
      Candidate* t = tries.found(need_).*may_be_chosen;
      return t && (!by_objective || meets_objective(*t)) ? t : nullptr;
    };
    measure([&](Tries& tries) -> Candidate* {
      Candidate* t = may_be(tries);
      if (!t && !tries.is_over() && !tries.is_given_up()) t = &tries.candidates.back();
      return t && std::isnan(tries.expected_seconds(*t)) ? t : nullptr;
    });
    double cheapest = std::numeric_limits<double>::infinity();
    do {
      for (Tries& tries : tries_)
        if (const Candidate* t = may_be(tries)) cheapest = std::min(cheapest, tries.expected_seconds(*t));
    } while (measure([&](Tries& tries) -> Candidate* {
      Candidate* t = may_be(tries);
      return t && tries.expected_seconds(*t) <= several * cheapest ? t : nullptr;
    }));
  }

  void measure_what_is_shown() {
    measure([this](Tries& tries) { return tries.found(need_).representative(); });
  }

  /// Those wanted, unless they were timed before. Whether there were any.
  bool measure(const std::function<Candidate*(Tries&)>& wanted_of) {
    const Stopwatch watch(spent_.timing);
    std::vector<Candidate*> wanted;
    for (Tries& tries : tries_)
      if (Candidate* t = wanted_of(tries); t && std::isnan(t->seconds_per_frame)) wanted.push_back(t);
    spent_.timed += static_cast<int>(wanted.size());
    Stage tally(progress_, "timing them", wanted.size());
    for (Candidate* candidate : wanted) {
      check_stop();
      measure(*candidate);
      tally.add();
    }
    return !wanted.empty();
  }

  void measure(Candidate& candidate) const {
    const Time time = time_per_frame(candidate);
    const double with_restarts = worst_part(candidate) * (1 + restarting(candidate));
    candidate.seconds_per_frame = with_restarts * time.seconds;
    candidate.spread = std::isfinite(time.spread) ? with_restarts * time.spread : 0;
  }

  /// How many times as many evaluations a frame takes in the twentieth of the time that takes the most as on
  /// average: a budget has to hold there.
  double worst_part(const Candidate& candidate) const {
    constexpr int parts = 20;
    const auto frames = static_cast<int>(need_.frames());
    if (!std::isfinite(need_.budget) || candidate.evaluations_per_frame == 0 || frames < parts) return 1;
    double before = 0, most = 0;
    for (int part = 1, from = 0; part <= parts; ++part) {
      check_stop();
      const int to = frames * part / parts;
      const Quantity until = starts_.first_frames(to);
      const Method* method = method_of(until, candidate.model, candidate.algorithm);
      if (!method) return 1;
      const auto evaluations = static_cast<double>(run(until, *method, candidate.setting).answer.evaluations);
      most = std::max(most, (evaluations - before) / (to - from));
      before = evaluations;
      from = to;
    }
    return std::max(1.0, most / candidate.evaluations_per_frame);
  }

  /// What takes long is timed over its first frames, as an evaluation takes as long there: over a twentieth
  /// of all, or as many as take twice what is long.
  Time time_per_frame(const Candidate& candidate) const {
    constexpr long many = 10'000;
    const double enough = std::ceil(2 * many / candidate.evaluations_per_frame);
    const Quantity first_frames =
        starts_.first_frames(static_cast<int>(std::clamp(enough, 1.0, std::max(1.0, need_.frames() / 20))));
    const Method* briefly = method_of(first_frames, candidate.model, candidate.algorithm);
    const long evaluations = briefly ? run(first_frames, *briefly, candidate.setting).answer.evaluations : 0;
    if (evaluations < many)
      return part_of(price_(method(candidate), candidate.setting), seen_.front().motion.samples);
    const double frames = static_cast<double>(evaluations) / candidate.evaluations_per_frame;
    return part_of(price_(*briefly, candidate.setting), frames);
  }
  static Time part_of(const Time& time, double parts) { return {time.seconds / parts, time.spread / parts}; }

  bool meets_objective(const Candidate& t) const {
    return t.holds() && !is_faulted(t) &&
           (need_.objective == Objective::cheapest || (is_simple(t) && holds_with_margin(t, need_)));
  }

  /// One that its page shows to be wrong is not chosen.
  bool is_faulted(const Candidate& t) const {
    const auto& faulted = task_.entry->exercise.scene->faulted;
    return std::ranges::find(faulted, t.model) != faulted.end();
  }

  bool eligible(const Candidate& t, bool by_objective) const {
    return !is_faulted(t) && t.seconds_per_frame <= need_.budget &&
           (by_objective ? meets_objective(t) : t.holds());
  }

  static bool ties_with(const Candidate& t, const Candidate& fastest) {
    if (t.seconds_per_frame <= fastest.seconds_per_frame) return true;  // of 0 and infinity, too
    const double times = t.seconds_per_frame / fastest.seconds_per_frame;
    return times <= near_tie || (times <= noisy_tie && t.seconds_per_frame - t.spread <=
                                                           fastest.seconds_per_frame + fastest.spread);
  }

  static bool same_cost(const Candidate& t, const Candidate& other) {
    return ties_with(t, other) && ties_with(other, t);
  }

  /// The cheapest; of near ties the more accurate, and of those as accurate within a tenth the simpler.
  std::optional<Candidate> pick(bool by_objective) {
    ties_.clear();
    const std::vector<Candidate> all = all_tried();
    const auto fastest = least(all, [&](const Candidate& t) { return eligible(t, by_objective); });
    if (!fastest) return {};
    for (const Candidate& t : all)
      if (eligible(t, by_objective) && ties_with(t, *fastest)) ties_.push_back(t);
    const double error = std::ranges::min_element(ties_, {}, &Candidate::error)->error;
    const auto best = std::ranges::min_element(ties_, {}, [&](const Candidate& t) {
      return std::tuple(t.error > 1.1 * error, !is_simple(t), simplicity(t.algorithm), t.error);
    });
    const Candidate chosen = *best;
    ties_.erase(best);
    return chosen;
  }

  std::vector<Candidate> all_tried() const {
    std::vector<Candidate> all;
    for (const Tries& tries : tries_) std::ranges::copy(tries.candidates, std::back_inserter(all));
    return all;
  }

  template <class Range, class Predicate>
  static std::optional<Candidate> least(const Range& range, const Predicate& predicate) {
    std::optional<Candidate> best;
    for (const Candidate& candidate : range)
      if (predicate(candidate) && (!best || candidate.seconds_per_frame < best->seconds_per_frame))
        best = candidate;
    return best;
  }

  /// What comes nearest to a need that nothing meets: within the budget the smallest error, but what holds
  /// and costs too much comes first.
  std::optional<Candidate> miss(std::vector<Candidate>& all) const {
    if (all.empty() || seen_.empty()) return {};
    if (auto held = least(all, [](const Candidate& t) { return t.holds(); })) return held;
    const std::span hardest(in_order(seen_, hardest_starts()).front(), 1);
    std::set<const Candidate*> been_on_hardest, been_on_all;
    while (true) {
      Candidate& nearest = *std::ranges::min_element(all, {}, &Candidate::error);
      if (been_on_all.contains(&nearest)) return nearest;
      if (been_on_hardest.insert(&nearest).second) {
        go_through(hardest, nearest, need_);
      } else {
        judge_failure(nearest);
        been_on_all.insert(&nearest);
      }
    }
  }

  /// What does not hold was left at the first start on which it failed: now its error is that of all.
  void judge_failure(Candidate& candidate) const {
    if (!candidate.holds()) go_through(seen_, candidate, need_);
  }

  /// At 60, 120 and 240 Hz, or as soon above that a whole number of them fills the frame; each once.
  std::set<double, std::greater<>> steps_of_engines() const {
    std::set<double, std::greater<>> steps;
    for (double rate : {60.0, 120.0, 240.0})
      steps.insert(1 / (need_.frames_per_second * std::ceil(rate / need_.frames_per_second)));
    return steps;
  }

  /// Of the first model that an engine's step fits: semi-implicit Euler.
  std::vector<Candidate> engine() const {
    std::vector<Candidate> rows;
    for (const Method& m : seen_.front().motion.methods) {
      if (m.algorithm != "symplectic Euler" && m.algorithm != "semi-implicit Euler") continue;
      for (double step : steps_of_engines()) rows.push_back(oddity::evaluate(seen_, m, step, need_));
      break;
    }
    return rows;
  }

  /// Nothing where the method is in double only.
  std::optional<Candidate> chosen_in_float(const Candidate& chosen) const {
    const Method* single = method_of(seen_.front().motion, chosen.model, oddity::in_float(chosen.algorithm));
    if (!single) return {};
    return oddity::evaluate(seen_, *single, chosen.setting, need_);
  }

  /// What the first frame of a run costs beside the steady evaluations.
  double restart(const Candidate& chosen) const {
    const Quantity one_frame = starts_.first_frames(1);
    const Method* first = method_of(one_frame, chosen.model, chosen.algorithm);
    if (!first) return 0;
    return std::max(0.0, static_cast<double>(run(one_frame, *first, chosen.setting).answer.evaluations) -
                             chosen.evaluations_per_frame);
  }

  /// What the restarts asked for add to the time, as a part of it.
  double restarting(const Candidate& candidate) const {
    const double frames = need_.restart_every * need_.frames_per_second;
    if (!std::isfinite(frames) || candidate.evaluations_per_frame == 0) return 0;
    return restart(candidate) / candidate.evaluations_per_frame / frames;
  }

  /// A path alone is asked for to an error in each unit.
  std::optional<double> predictable() const {
    const Start& asked = seen_.front();
    if (need_.criterion != Criterion::path || !asked.parting) return {};
    const Parting& parting = **asked.parting;
    if (!parting.is_chaotic) return {};
    const auto lost = parting.lost_at();
    return lost ? static_cast<double>(*lost + 1) / need_.frames_per_second
                : std::numeric_limits<double>::infinity();
  }

  /// A few starts that it was not chosen on say little of chaos: on more of them.
  void try_in_chaos(Choice& choice) {
    constexpr int enough = 16;
    const Stopwatch watch(spent_.tests);
    std::vector<Start> more = starts_.beside(enough, [] {});
    for (const auto& starts : {std::span<const Start>(more), std::span<const Start>(*unseen_)})
      for (const Start& start : starts) {
        ++choice.tried_in_chaos;
        choice.holding_in_chaos +=
            oddity::evaluate(std::span(&start, 1), method(*choice.chosen), choice.chosen->setting, need_)
                .holds();
      }
  }

  /// Those tried that are expected to be cheaper and could not be chosen instead, the most expensive first.
  std::vector<Candidate> cheaper_than(const Candidate& chosen, bool by_objective) const {
    std::vector<Candidate> cheaper;
    for (const Tries& tries : tries_)
      for (Candidate t : tries.candidates) {
        t.seconds_per_frame = tries.expected_seconds(t);
        if (t.seconds_per_frame < chosen.seconds_per_frame && !eligible(t, by_objective))
          cheaper.push_back(std::move(t));
      }
    std::ranges::stable_sort(cheaper, std::greater(), &Candidate::seconds_per_frame);
    return cheaper;
  }

  /// What came to an end on the start where it failed first may not do so on another.
  std::optional<Candidate> next_cheaper(const Candidate& chosen, bool by_objective) const {
    for (Candidate& t : cheaper_than(chosen, by_objective)) {
      if (!came_to_an_end(t)) continue;
      judge_failure(t);
      if (!came_to_an_end(t)) continue;
      measure(t);
      if (t.seconds_per_frame < chosen.seconds_per_frame) return t;
    }
    return {};
  }

  /// Those tried that may hold on the start asked for, from the least work on: they do not fail there first.
  std::vector<Candidate> maybe_holding_on_asked() const {
    std::vector<Candidate> held;
    for (const Candidate& t : all_tried())
      if (t.where != seen_.front().says) held.push_back(t);
    std::ranges::stable_sort(held, {}, &Candidate::evaluations_per_frame);
    return held;
  }

  /// Where starts beside the one asked for decide that nothing holds.
  void tell_of_asked(Choice& choice) {
    const std::span<const Start> seen(seen_);
    for (Candidate& t : maybe_holding_on_asked()) {
      check_stop();
      const Method& tried = method(t);
      const Candidate on_asked = oddity::evaluate(seen.first(1), tried, t.setting, need_);
      if (!on_asked.holds()) continue;
      const Candidate beside =
          oddity::evaluate(t.holds() ? unseen() : seen.subspan(1), tried, t.setting, need_);
      if (beside.holds()) continue;
      if (std::isnan(t.seconds_per_frame)) measure(t);
      if (!(t.seconds_per_frame <= need_.budget)) continue;
      choice.on_asked = on_asked;
      choice.on_asked->seconds_per_frame = t.seconds_per_frame;
      choice.on_asked->spread = t.spread;
      choice.beside_asked = beside;
      return;
    }
  }

  /// Of all but the time of the rest.
  Explanation explanation() const {
    Explanation all = spent_;
    const Quantity& motion = seen_.front().motion;
    all.truth_by = motion.reference.by;
    all.truth_error = motion.reference_error / motion.need.allowed;
    all.starts = static_cast<int>(seen_.size() + (unseen_ ? unseen_->size() : 0));
    if (!seen_.front().is_whole) all.truth_until = motion.samples / need_.frames_per_second;
    all.methods = static_cast<int>(tries_.size());
    for (const Tries& tries : tries_) {
      all.settings += static_cast<int>(tries.candidates.size());
      if (!tries.is_over()) ++all.left;
      for (const Candidate& t : tries.candidates)
        all.evaluations += std::lround(t.evaluations_per_frame * need_.frames());
    }
    return all;
  }

  Choice summary(const Picked& picked) {
    const std::optional<Candidate>& chosen = picked.chosen;
    const Quantity& motion = seen_.front().motion;
    measure_what_is_shown();
    Choice choice;
    choice.need = need_;
    choice.quantity = motion.name;
    for (std::string_view unit : motion.units()) choice.units.emplace_back(unit);
    choice.needs = motion.needs;
    choice.sizes = sizes_of(motion);
    choice.rounding = rounding_of(Criterion::constraint, motion);
    choice.chosen = chosen;
    choice.by_objective = picked.by_objective;
    for (const Start& s : seen_) choice.seen.push_back(s.says);
    if (chosen)
      for (const Start& s : *unseen_) choice.unseen.push_back(s.says);
    choice.left_out = starts_.left_out();
    choice.failing_beside = failing_beside_;
    for (Tries& tries : tries_)
      if (const Candidate* t = tries.found(need_).representative()) choice.candidates.push_back(*t);
    for (const Tries& tries : tries_)
      if (!tries.is_over()) choice.left.emplace_back(tries.method().model, tries.method().algorithm);
    if (chosen)  // at another setting where its margin does not matter
      for (Candidate& t : choice.candidates)
        if (t.model == chosen->model && t.algorithm == chosen->algorithm) t = *chosen;
    std::ranges::stable_sort(choice.candidates, {}, [](const Candidate& t) {
      return std::isnan(t.seconds_per_frame) ? std::numeric_limits<double>::infinity() : t.seconds_per_frame;
    });
    for (const std::string_view model : task_.entry->exercise.scene->faulted)
      choice.faulted.emplace_back(model);
    choice.engine = engine();
    choice.predictable = predictable();
    choice.explanation = explanation();
    if (!chosen) {
      choice.nearest_miss = miss(choice.candidates);
      tell_of_asked(choice);
      return choice;
    }
    if (choice.predictable) try_in_chaos(choice);
    choice.ties = ties_;
    choice.restart = restart(*chosen);
    choice.in_float = chosen_in_float(*chosen);
    choice.next_cheaper = next_cheaper(*chosen, picked.by_objective);
    choice.next_richer = least(choice.candidates, [&](const Candidate& t) {
      return t.holds() && !is_faulted(t) && t.model != chosen->model &&
             t.seconds_per_frame > chosen->seconds_per_frame && !same_cost(t, *chosen);
    });
    return choice;
  }

  const Task& task_;
  const Need& need_;
  const Price& price_;
  const Progress& progress_;
  std::optional<Stage> motions_;
  Reference truth_;
  InitialConditions starts_;
  std::vector<Start> seen_;
  std::optional<std::vector<Start>> unseen_;
  int failing_beside_ = 0;
  std::string refuted_on_;  ///< where what was picked last failed its test
  std::vector<Tries> tries_;
  std::vector<Candidate> ties_;
  Explanation spent_;
};

}  // namespace

Time measured_price(const Method& method, double setting) {
  constexpr double brief = 1e-4, lengthy = 2e-3;  // s, a run
  Time best = time(method, setting, lengthy);
  for (int more = 0; more < 2 && best.seconds < brief; ++more) {
    const Time again = time(method, setting);
    best = {std::min(best.seconds, again.seconds), std::min(best.spread, again.spread)};
  }
  return best;
}

std::pair<double, double> Choice::share_in_chaos() const {
  constexpr double z = 1.959964;
  const double n = tried_in_chaos, share = holding_in_chaos / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n),
               half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {middle - half, middle + half};
}

bool Choice::was_followed(const Candidate& t) const {
  return std::ranges::find(left, std::pair(t.model, t.algorithm)) == left.end();
}

namespace {

Choice choose(const Task& task, const Need& need, const Reference& truth, const Price& price,
              const Progress& progress, const std::shared_ptr<const PartJudged>& part) {
  double all = 0;
  Choice choice = [&] {
    const Stopwatch watch(all);
    return in_time(need.time_limit, "a shorter horizon, a lower frame rate or fewer methods (--only)",
                   [&] { return Search(task, need, truth, price, progress, part).choose(); });
  }();
  Explanation& took = choice.explanation;
  took.rest = all - took.truths - took.search - took.timing - took.tests;
  choice.exercise = to_string(task.entry->number);
  choice.time_unit = task.entry->exercise.scene->axes.time;
  return choice;
}

/// What fails over a part of the motion fails over the whole: an error at every frame of a size that does not
/// depend on the motion's.
bool a_part_decides(const Need& need) {
  return !need.relative && std::ranges::all_of(criteria_of(need), [](Criterion criterion) {
    return criterion == Criterion::path || criterion == Criterion::constraint;
  });
}

/// The need over ever longer parts of its horizon, the last of them the whole.
std::vector<Need> ever_longer(const Need& need) {
  constexpr double longer = 8, least_frames = 2400;
  std::vector<Need> all{need};
  while (all.front().frames() / longer >= least_frames) {
    Need part = all.front();
    part.horizon = std::floor(part.frames() / longer) / need.frames_per_second;
    all.insert(all.begin(), part);
  }
  return all;
}

}  // namespace

Choice choose(const Task& task, const Need& need, const Reference& truth, const Price& price,
              const Progress& progress) {
  return choose(task, need, truth, price, progress, nullptr);
}

Choice choose_in_time(const Task& task, const Need& need, const Reference& truth, const PriceOver& price_over,
                      const Progress& progress) {
  double spent = 0;
  std::optional<Choice> over_part;
  std::shared_ptr<const Failures> failed;
  for (Need& over : ever_longer(need)) {
    const Stopwatch watch(spent);
    const bool is_whole = over.horizon == need.horizon;
    over.time_limit = need.time_limit - spent;
    std::shared_ptr<PartJudged> part;
    if (a_part_decides(need))
      part =
          std::make_shared<PartJudged>(PartJudged{"the first " + format_significant(over.horizon, 4) + " " +
                                                      std::string(task.entry->exercise.scene->axes.time),
                                                  failed, std::make_shared<Failures>()});
    try {
      over_part = choose(task, over, truth, price_over(over), progress, part);
    } catch (const OutOfTime&) {
      if (!over_part) throw;
      break;
    } catch (const BadInput&) {
      if (is_whole) throw;
      continue;  // two periods, for example, may be in the whole alone
    }
    if (is_whole) return *over_part;
    over_part->asked_horizon = need.horizon;
    over_part->is_decided_by_part = !over_part->chosen && part && !std::isfinite(need.budget);
    if (over_part->is_decided_by_part) break;
    if (!part) continue;
    if (failed) part->here->add(*failed);
    failed = part->here;
  }
  return *over_part;
}

}  // namespace oddity
