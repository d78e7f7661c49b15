#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/study/initial_conditions.hpp"
#include "report/study/parallel.hpp"

namespace oddity {

/// The starts of one choice: those that choose a method, and those that test the choice.
///
///   Starts starts(task, need, truth, progress, nullptr);
///   const Candidate tried = evaluate(starts.seen(), method, setting, need);
class Starts {
 public:
  /// Makes the motions of the starts to choose on. Throws BadInput as InitialConditions does.
  Starts(const Task&, const Need&, const Reference&, const Progress&, std::shared_ptr<const PartJudged>);
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;

  /// The requested start and some next to it.
  const std::vector<Start>& seen() const { return seen_; }
  const Start& asked() const { return seen_.front(); }
  const Quantity& motion() const { return asked().motion; }
  /// Made at the first call.
  const std::vector<Start>& unseen();
  /// Number of unseen starts made so far.
  std::size_t unseen_made() const { return unseen_ ? unseen_->size() : 0; }
  /// Unseen starts are only reported: the choice is for one start, and may fail on them.
  bool are_unseen_reported_only() const;
  /// Moves the unseen starts to the seen ones.
  void see_unseen();
  /// Newly drawn starts.
  std::vector<Start> more(int count) {
    return conditions_.nearby_starts(count, [] {});
  }

  /// The first frames of the requested start, without a reference.
  Quantity first_frames(int count) const { return conditions_.first_frames(count); }
  const std::map<std::string, int>& left_out() const { return conditions_.left_out(); }
  double seconds() const { return seconds_; }  ///< spent on true motions

  /// In chaos even long double, with 2,048 times smaller roundings, loses the path before its end.
  bool are_beyond_double() const;
  const Method& method(const Candidate&) const;

 private:
  int seen_nearby() const;
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
