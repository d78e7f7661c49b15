#include "report/study/search.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <ranges>
#include <span>
#include <utility>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/study/off_by_need.hpp"
#include "report/study/policy.hpp"
#include "report/study/stopwatch.hpp"

namespace oddity {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

bool named_by(const std::vector<std::string>& words, const Method& method) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return method.model.find(word) != std::string::npos || method.algorithm.find(word) != std::string::npos;
  });
}

}  // namespace

bool is_wanted(const Need& need, const Method& method) {
  if (!(method.precision == Precision::in_float ? need.in_float : need.in_double)) return false;
  if (!need.only.empty() && !named_by(need.only, method)) return false;
  if (need.takes && !need.takes(method.model, method.algorithm)) return false;
  return !named_by(need.exclude, method) && !(need.one_step && is_multistep(method.algorithm));
}

Search::Search(const Task& task, const Need& need, const Reference& truth, const Price& price,
               const Progress& progress, std::shared_ptr<const PartJudged> part)
    : need_(need),
      progress_(progress),
      starts_(task, need, truth, progress, part),
      clock_(need, starts_, price, progress),
      picker_(need, *task.entry->exercise.scene),
      costs_(part ? part->costs : std::nullopt) {
  const Quantity& motion = starts_.motion();
  for (const auto* methods : {&motion.methods, &motion.methods_in_float})
    for (const Method& method : *methods) {
      if (!is_wanted(need, method) || !can_be_judged(need, motion, method)) continue;
      ladders_.emplace_back(method, need);
    }
  if (ladders_.empty()) throw BadInput("no method is left; this scene has " + names());
  std::vector<const Method*> left;
  for (const Ladder& ladder : ladders_) left.push_back(&ladder.method());
  require_constraint(need, motion, left);
  if (!costs_) return;
  const auto costly = std::ranges::stable_partition(ladders_, [&](const Ladder& ladder) {
    const PartCosts::Cost cost = cost_over_part(ladder), &chosen = costs_->of_chosen;
    return !picker_.is_faulted(ladder.method().model) &&
           !(cost.per_frame > policy.far_costlier * chosen.per_frame &&
             cost.per_frame / cost.per_evaluation >= chosen.per_frame / chosen.per_evaluation);
  });
  too_costly_.assign(std::make_move_iterator(costly.begin()), std::make_move_iterator(costly.end()));
  ladders_.erase(costly.begin(), costly.end());
}

/// Zeros if it was not tried over a part.
PartCosts::Cost Search::cost_over_part(const Ladder& ladder) const {
  const auto found = costs_->all.find({ladder.method().model, ladder.method().algorithm});
  return found == costs_->all.end() ? PartCosts::Cost{} : found->second;
}

/// The most that a setting may cost to tie with the pick, in times of its cost: less where the times over a
/// part were steady.
double Search::most_of_a_tie(const Ladder& ladder) const {
  if (!costs_) return policy.noisy_tie;
  const double apart = (1 + costs_->of_chosen.spread) / (1 - cost_over_part(ladder).spread);
  return apart > 0 ? std::clamp(apart, policy.near_tie, policy.noisy_tie) : policy.noisy_tie;
}

/// The most evaluations per frame to try a setting with: the method chosen over a part can be picked here.
/// With more, an eligible setting could not tie with it. Any other would not be cheaper.
double Search::most_evaluations(const Ladder& ladder) const {
  if (!comparable_) return unlimited;
  constexpr double estimate = policy.near_tie;
  const double most = picker_.may_meet_objective(ladder) ? most_of_a_tie(ladder) : 1;
  return estimate * most * *comparable_ / cost_over_part(ladder).per_evaluation;
}

/// The most work that any method is allowed, in evaluations per frame.
double Search::most_work() const {
  return starts_.are_beyond_double() ? policy.more_work * policy.first_work : unlimited;
}

/// The method chosen over a part comes first, as its cost limits the work on others.
void Search::climb_chosen_over_part() {
  if (!costs_) return;
  const auto is_chosen = [&](const Ladder& ladder) {
    return PartCosts::Which(ladder.method().model, ladder.method().algorithm) == costs_->chosen;
  };
  const auto chosen = std::ranges::find_if(ladders_, is_chosen);
  if (chosen == ladders_.end()) return;
  climb("trying the method chosen over a part", most_work(), is_chosen);
  if (Candidate* t = chosen->found(need_).with_margin; t && picker_.meets_objective(*t)) {
    clock_.time_all({t});
    comparable_ = t->seconds_per_frame;
  }
}

/// Takes up methods that were left out and may cost no more than the pick, or tie with it. They cost at least
/// as much as over a part. Returns whether there are any.
bool Search::readmit(const Picked& picked) {
  const double most =
      policy.noisy_tie *
      (picked.chosen && picked.by_objective ? picked.chosen->seconds_per_frame : need_.budget);
  const auto back = std::ranges::stable_partition(too_costly_, [&](const Ladder& ladder) {
    return cost_over_part(ladder).per_frame > most || picker_.is_faulted(ladder.method().model);
  });
  const bool any = !back.empty();
  std::ranges::move(back, std::back_inserter(ladders_));
  too_costly_.erase(back.begin(), back.end());
  return any;
}

std::vector<PartCosts::Which> Search::too_costly() const {
  std::vector<PartCosts::Which> all;
  for (const Ladder& ladder : too_costly_) all.emplace_back(ladder.method().model, ladder.method().algorithm);
  return all;
}

Picked Search::run() {
  climb_chosen_over_part();
  climb("trying the methods");
  for (int round = 1;; ++round) {
    Picked picked = pick_cheapest();
    while (readmit(picked)) {
      climb("trying more methods");
      picked = pick_cheapest();
    }
    if (!picked.chosen || holds_elsewhere(*picked.chosen)) return picked;
    picked.chosen.reset();
    if (round == policy.rounds) return picked;
    starts_.see_unseen();
    comparable_.reset();
    for (Ladder& ladder : ladders_) ladder.again(need_);
    climb("trying them on more starts");
  }
}

bool Search::holds_elsewhere(Candidate& chosen) {
  const std::vector<Start>& unseen = starts_.unseen();
  const Stopwatch watch(test_seconds_);
  ++rounds_;
  if (starts_.are_unseen_reported_only()) {
    chosen.unseen_error = chosen.error;
    for (const Start& start : unseen)
      failing_nearby_ +=
          !evaluate(std::span(&start, 1), starts_.method(chosen), chosen.setting, need_).holds();
    return true;
  }
  const Candidate test = evaluate(unseen, starts_.method(chosen), chosen.setting, need_);
  chosen.unseen_error = test.error;
  refuted_on_ = test.where;
  return test.holds() && !unseen.empty();
}

std::string Search::names() const {
  std::string all;
  for (const Method& m : starts_.motion().methods)
    all += (all.empty() ? "" : "; ") + m.model + " by " + m.algorithm;
  return all;
}

std::vector<Candidate> Search::all_tried() const {
  std::vector<Candidate> all;
  for (const Ladder& ladder : ladders_) std::ranges::copy(ladder.candidates, std::back_inserter(all));
  return all;
}

/// Called between stages, so that the order of trials does not depend on which thread came first.
std::vector<std::string> Search::hardest_starts() const {
  std::map<std::string, int> failed;
  for (const Ladder& ladder : ladders_)
    for (const Candidate& t : ladder.candidates)
      if (!t.holds() && t.where != starts_.asked().says) ++failed[t.where];
  std::vector<std::string> hardest;
  for (const auto& [says, count] : failed) hardest.push_back(says);
  std::ranges::stable_sort(hardest, std::greater(), [&](const auto& says) { return failed[says]; });
  hardest.insert(hardest.begin(), refuted_on_);
  return hardest;
}

/// Moves these ladders on, in parallel, to the first setting that passes with the margin or takes more work.
void Search::climb(const std::string& stage, double most_evaluations, const Which& which) {
  const Stopwatch watch(seconds_);
  const std::vector<std::string> hardest = hardest_starts();
  std::vector<Ladder*> costliest_first;
  for (Ladder& ladder : ladders_)
    if (which(ladder)) costliest_first.push_back(&ladder);
  std::ranges::stable_sort(costliest_first, std::greater(), &Ladder::expected_evaluations);
  Stage tally(progress_, stage, costliest_first.size());
  parallel_for_each(costliest_first, [&](Ladder* ladder) {
    ladder->go_on(most_evaluations, starts_.seen(), need_, hardest, this->most_evaluations(*ladder));
    tally.add();
  });
}

/// Allows ever more work until something passes that meets the objective. Once anything passes, continues
/// only ladders that may meet the objective.
void Search::climb(const std::string& stage) {
  const double most_of_all = most_work();
  const auto any = [&](const std::function<bool(const Candidate&)>& is) {
    return std::ranges::any_of(ladders_,
                               [&](const Ladder& l) { return std::ranges::any_of(l.candidates, is); });
  };
  Which which = [](const Ladder&) { return true; };
  for (double most = need_.thorough ? unlimited : policy.first_work; most <= most_of_all;
       most *= policy.more_work) {
    climb(stage, most, which);
    if (any([&](const Candidate& t) { return picker_.meets_objective(t); })) return;
    if (any(&Candidate::holds)) which = [this](const Ladder& l) { return picker_.may_meet_objective(l); };
    if (std::ranges::all_of(ladders_, [&](const Ladder& l) { return l.is_over() || !which(l); })) return;
  }
}

/// Tries one more setting of each unfinished ladder if its expected time is below the limit. Returns whether
/// there was one.
bool Search::climb_on(const std::function<double(const Ladder&)>& seconds_per_frame) {
  const Stopwatch watch(seconds_);
  std::atomic<bool> any = false;
  parallel_for_each(ladders_, [&](Ladder& ladder) {
    if (ladder.is_over() || ladder.is_given_up() || !(ladder.expected_seconds() < seconds_per_frame(ladder)))
      return;
    ladder.go_on(ladder.expected_evaluations(), starts_.seen(), need_);
    any = true;
  });
  return any;
}

bool Search::time(const std::function<Candidate*(Ladder&)>& wanted) {
  std::vector<Candidate*> candidates;
  for (Ladder& ladder : ladders_) candidates.push_back(wanted(ladder));
  return clock_.time_all(candidates);
}

/// Times one setting of each method, to estimate the others. Times those that may be chosen as well, unless
/// they are expected to cost several times as much as the cheapest.
void Search::time_to_pick_from(Rung may_be_chosen, bool by_objective) {
  constexpr double several = 2 * policy.noisy_tie;
  const auto may_be = [&](Ladder& ladder) -> Candidate* {
    Candidate* t = ladder.found(need_).*may_be_chosen;
    return t && (!by_objective || picker_.meets_objective(*t)) ? t : nullptr;
  };
  time([&](Ladder& ladder) -> Candidate* {
    Candidate* t = may_be(ladder);
    if (!t && !ladder.is_over() && !ladder.is_given_up()) t = &ladder.candidates.back();
    return t && std::isnan(ladder.expected_seconds(*t)) ? t : nullptr;
  });
  double cheapest = unlimited;
  do {
    for (Ladder& ladder : ladders_)
      if (const Candidate* t = may_be(ladder)) cheapest = std::min(cheapest, ladder.expected_seconds(*t));
  } while (time([&](Ladder& ladder) -> Candidate* {
    Candidate* t = may_be(ladder);
    return t && ladder.expected_seconds(*t) <= several * cheapest ? t : nullptr;
  }));
}

Picked Search::pick() {
  time_to_pick_from(&Ladder::Found::with_margin, true);
  if (Picked picked = picker_.pick(all_tried(), true); picked.chosen) return picked;
  time_to_pick_from(&Ladder::Found::first, false);
  return picker_.pick(all_tried(), false);
}

/// A pick is final when finer settings of the failing methods would cost more. A method that may be chosen
/// instead may also tie with it. One that the objective prefers may cost as much as the budget allows.
Picked Search::pick_cheapest() {
  while (true) {
    const Picked picked = pick();
    const auto limit = [&](const Ladder& ladder) {
      if (!picked.chosen || (!picked.by_objective && picker_.may_meet_objective(ladder))) return need_.budget;
      const bool may_tie = picker_.may_meet_objective(ladder) == picked.by_objective;
      return (may_tie ? most_of_a_tie(ladder) : 1) * picked.chosen->seconds_per_frame;
    };
    if (starts_.are_beyond_double() || !climb_on(limit)) return picked;
  }
}

}  // namespace oddity
