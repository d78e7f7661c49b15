#include "report/choose.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <utility>

#include "report/time.hpp"

namespace oddity {

namespace {

constexpr int seen_beside = 2, unseen_starts = 3, rounds = 4;

/// Everything tried, and the search through a method's settings.
class Search {
 public:
  Search(const Task& task, const Need& need, const Reference& truth, const Price& price)
      : need_(need), price_(price), starts_(task, need, truth), seen_{starts_.asked()} {
    std::ranges::move(starts_.beside(seen_beside), std::back_inserter(seen_));
  }

  Choice choose() {
    for (const Method& method : seen_.front().motion.methods)
      for (double setting : settings(method, need_))
        if (const Tried& tried = attempt(method, setting); tried.holds() || hopeless(tried)) break;
    std::vector<Start> unseen;
    std::optional<Tried> chosen;
    for (int round = 0; round < rounds && (chosen = cheapest()); ++round) {
      unseen = starts_.beside(unseen_starts);
      const Tried test = oddity::attempt(
          unseen, *method_of(seen_.front().motion, chosen->model, chosen->algorithm), chosen->setting, need_);
      chosen->unseen_error = test.error;
      if (test.holds() && !unseen.empty()) break;
      std::ranges::move(unseen, std::back_inserter(seen_));
      try_again();
      chosen.reset();
    }
    return summary(chosen, unseen);
  }

 private:
  const Tried& attempt(const Method& method, double setting) {
    Trial first;
    Tried tried = oddity::attempt(seen_, method, setting, need_, &first);
    tried.seconds_a_frame = first.outcome == Outcome::raised
                                ? std::numeric_limits<double>::infinity()
                                : price_(method, setting, first) / need_.frames();
    return all_.emplace_back(std::move(tried));
  }

  /// The settings that held, on the starts as they are now; a method whose setting fails goes on to finer
  /// ones.
  void try_again() {
    const std::vector<Tried> before = std::exchange(all_, {});
    for (const Method& method : seen_.front().motion.methods) {
      double from = std::numeric_limits<double>::quiet_NaN();
      for (const Tried& tried : before)
        if (tried.holds() && same(tried, method)) from = tried.setting;
      bool reached = false;
      for (double setting : settings(method, need_)) {
        reached = reached || setting == from;
        if (reached)
          if (const Tried& tried = attempt(method, setting); tried.holds() || hopeless(tried)) break;
      }
    }
    for (const Tried& tried : before)
      if (!tried.holds()) all_.push_back(tried);
  }

  static bool same(const Tried& tried, const Method& method) {
    return tried.model == method.model && tried.algorithm == method.algorithm;
  }

  /// What broke off has no cost to compare.
  static bool came_to_an_end(const Tried& tried) {
    return tried.outcome != Outcome::non_finite && tried.outcome != Outcome::stalled &&
           tried.outcome != Outcome::raised;
  }

  bool affordable(const Tried& tried) const { return tried.seconds_a_frame <= need_.budget; }

  std::optional<Tried> cheapest() const {
    return least(all_, [&](const Tried& t) { return t.holds() && affordable(t); });
  }

  template <class Range, class Predicate>
  static std::optional<Tried> least(const Range& range, const Predicate& predicate) {
    std::optional<Tried> best;
    for (const Tried& tried : range)
      if (predicate(tried) && (!best || tried.seconds_a_frame < best->seconds_a_frame)) best = tried;
    return best;
  }

  /// What comes nearest to a need that nothing meets: within the budget the smallest error, but what holds
  /// and costs too much comes first.
  std::optional<Tried> miss() const {
    if (auto held = least(all_, [](const Tried& t) { return t.holds(); })) return held;
    const auto nearest = std::ranges::min_element(all_, {}, &Tried::error);
    return nearest == all_.end() ? std::nullopt : std::optional(*nearest);
  }

  Choice summary(const std::optional<Tried>& chosen, const std::vector<Start>& unseen) const {
    const Quantity& motion = seen_.front().motion;
    Choice choice{need_, motion.name, motion.unit, "s", {}, chosen, {}, {}, {}, {}, {}};
    for (const Start& s : seen_) choice.seen.push_back(s.says);
    for (const Start& s : unseen) choice.unseen.push_back(s.says);
    for (const Method& method : motion.methods) {
      std::optional<Tried> best;
      for (const Tried& tried : all_)
        if (same(tried, method) && (!best || tried.holds() || (!best->holds() && tried.error < best->error)))
          best = tried;
      if (best) choice.tried.push_back(*best);
    }
    std::ranges::stable_sort(choice.tried, {}, &Tried::seconds_a_frame);
    if (!chosen) {
      choice.nearest_miss = miss();
      return choice;
    }
    for (const Tried& tried : all_)
      if (!tried.holds() && came_to_an_end(tried) && tried.seconds_a_frame < chosen->seconds_a_frame &&
          (!choice.next_cheaper || tried.seconds_a_frame > choice.next_cheaper->seconds_a_frame))
        choice.next_cheaper = tried;
    choice.next_richer = least(choice.tried, [&](const Tried& t) {
      return t.holds() && t.model != chosen->model && t.seconds_a_frame > chosen->seconds_a_frame;
    });
    return choice;
  }

  const Need& need_;
  const Price& price_;
  Starts starts_;
  std::vector<Start> seen_;
  std::vector<Tried> all_;
};

}  // namespace

double measured_price(const Method& method, double setting, const Trial&) {
  return time(method, setting).seconds;
}

Choice choose(const Task& task, const Need& need, const Reference& truth, const Price& price) {
  Choice choice = Search(task, need, truth, price).choose();
  choice.time_unit = task.entry->exercise.scene->axes.time;
  return choice;
}

}  // namespace oddity
