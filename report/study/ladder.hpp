#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/study/candidate.hpp"

namespace oddity {

/// Holds, and as much better than asked as the need's margin wants it.
bool holds_with_margin(const Candidate&, const Need&);

/// What broke off has no cost to compare.
bool came_to_an_end(const Candidate&);

/// A method on its way through its settings, from coarse to fine, to the first that holds with the margin.
class Ladder {
 public:
  Ladder(const Method&, const Need&);

  /// Goes on while a setting is expected to take no more than so many evaluations per frame. One that takes
  /// far more is given up, and tried again when so many are allowed. The starts that are the hardest to
  /// others, by what they say, are tried first.
  void go_on(double most_evaluations, const std::vector<Start>&, const Need&,
             const std::vector<std::string>& hardest = {});

  const Method& method() const { return *method_; }
  /// It holds with the margin, or no finer setting can help.
  bool is_over() const { return is_over_; }
  /// The last candidate was: its cost is not known.
  bool is_given_up() const { return given_up_at_ > 0; }
  /// Of the next setting, per frame.
  double expected_evaluations() const;
  /// Of one of the candidates, per frame: its time, or, by its evaluations, that of the nearest that was
  /// timed. NaN where none was.
  double expected_seconds(const Candidate&) const;
  /// Of the next setting.
  double expected_seconds() const;
  /// Unless on fewer starts no setting did.
  bool may_hold_with_margin() const { return !has_no_margin_; }
  /// Back to the first setting that holds, to be tried again on more starts: what failed on some fails on
  /// more.
  void again(const Need&);

  std::vector<Candidate> candidates;  ///< a setting each, from coarse to fine

  /// What is worth knowing of them.
  struct Found {
    Candidate *first = nullptr, *with_margin = nullptr;  ///< the coarsest settings that hold
    Candidate* best = nullptr;                           ///< the least error of those that came to an end
    Candidate* representative() const { return with_margin ? with_margin : first ? first : best; }
  };
  Found found(const Need&);

 private:
  void step_back();
  /// That on which the last candidate failed, unless it was the one asked for; then the hardest to others.
  Order order_of(const std::vector<Start>&) const;
  bool changed_nothing() const;
  void skip_what_cannot_hold(const Need&);
  /// Between one that fails and one that holds, the last candidate: the coarsest that holds, by bisection.
  void look_among_skipped(const std::vector<Start>&, const Need&);

  const Method* method_;
  double power_;              ///< of the setting by which an error falls at most
  std::vector<double> left_;  ///< settings, the next last
  std::vector<std::string> hardest_;
  std::vector<double> skipped_;  ///< finer than the last that fails, from coarse to fine
  bool is_over_ = false, has_no_margin_ = false;
  double given_up_at_ = 0;  ///< evaluations per frame
};

}  // namespace oddity
