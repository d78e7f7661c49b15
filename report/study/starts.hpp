#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/study/initial_conditions.hpp"
#include "report/study/parallel.hpp"

namespace oddity {

/// The starts of one choice: those on which a method is chosen, and those on which the choice is tested.
///
///   Starts starts(task, need, truth, progress, nullptr);
///   const Candidate tried = evaluate(starts.seen(), method, setting, need);
class Starts {
 public:
  /// Makes the motions of those on which is chosen. Throws BadInput as InitialConditions does.
  Starts(const Task&, const Need&, const Reference&, const Progress&, std::shared_ptr<const PartJudged>);
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;

  /// The requested start and some next to it.
  const std::vector<Start>& seen() const { return seen_; }
  const Start& asked() const { return seen_.front(); }
  const Quantity& motion() const { return asked().motion; }
  /// Made at the first call.
  const std::vector<Start>& unseen();
  /// How many have been made so far.
  std::size_t unseen_made() const { return unseen_ ? unseen_->size() : 0; }
  /// A choice need not hold on the unseen ones: it was asked for on one start.
  bool are_unseen_reported_only() const;
  /// The unseen ones are seen from now on.
  void see_unseen();
  /// Others, drawn anew.
  std::vector<Start> more(int count) {
    return conditions_.beside(count, [] {});
  }

  /// So many frames of the requested start, without a reference.
  Quantity first_frames(int count) const { return conditions_.first_frames(count); }
  const std::map<std::string, int>& left_out() const { return conditions_.left_out(); }
  double seconds() const { return seconds_; }  ///< spent on true motions

  /// Long double itself, whose roundings are 2,048 times smaller, loses the path before its end, in chaos.
  bool are_beyond_double() const;
  const Method& method(const Candidate&) const;

 private:
  int seen_beside() const;
  int unseen_count() const;

  const Need& need_;
  const Progress& progress_;
  std::optional<Stage> motions_;
  Reference truth_;
  InitialConditions conditions_;
  std::vector<Start> seen_;
  std::optional<std::vector<Start>> unseen_;
  double seconds_ = 0;
};

}  // namespace oddity
