#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "report/study/candidate.hpp"

namespace oddity {

/// Passes with the need's margin.
bool holds_with_margin(const Candidate&, const Need&);

/// A candidate that broke off has no comparable cost.
bool came_to_an_end(const Candidate&);

/// A method that goes through its settings, from coarse to fine, to the first that passes with the margin.
class Ladder {
 public:
  Ladder(const Method&, const Need&);

  /// Continues while a setting is expected to take at most so many evaluations per frame. One that takes far
  /// more, or more than `most_of_all`, is given up, and tried again when so many are allowed. Tries the
  /// hardest starts first, named by their `says`.
  void go_on(double most_evaluations, const std::vector<Start>&, const Need&,
             const std::vector<std::string>& hardest = {},
             double most_of_all = std::numeric_limits<double>::infinity());

  const Method& method() const { return *method_; }
  /// A setting passes with the margin, or no finer one can help.
  bool is_over() const { return is_over_; }
  /// The last candidate was given up: its cost is not known.
  bool is_given_up() const { return given_up_at_ > 0; }
  /// Cost of the next setting, per frame.
  double expected_evaluations() const;
  /// Time of one of the candidates per frame, or an estimate from its evaluations and the nearest timed one.
  /// NaN if none was timed.
  double expected_seconds(const Candidate&) const;
  /// Time of the next setting per frame.
  double expected_seconds() const;
  /// False if no setting did on fewer starts.
  bool may_hold_with_margin() const { return !has_no_margin_; }
  /// Returns to the first passing setting, to try it on more starts: a failure on some is a failure on more.
  void again(const Need&);

  std::vector<Candidate> candidates;  ///< one per setting, from coarse to fine

  /// The candidates that matter.
  struct Found {
    Candidate *first = nullptr, *with_margin = nullptr;  ///< the coarsest passing settings
    Candidate* best = nullptr;                           ///< the smallest error among those that finished
    Candidate* representative() const { return with_margin ? with_margin : first ? first : best; }
  };
  Found found(const Need&);

 private:
  void step_back();
  /// First the start on which the last candidate failed, unless it was the requested one; then the hardest
  /// ones.
  Order order_of(const std::vector<Start>&) const;
  bool changed_nothing() const;
  void skip_what_cannot_hold(const Need&);
  /// Bisects between a failing candidate and the last one, which passes, for the coarsest that passes.
  void look_among_skipped(const std::vector<Start>&, const Need&);

  const Method* method_;
  double power_;              ///< the error falls at most by this power of the setting
  std::vector<double> left_;  ///< settings, in reverse order
  std::vector<std::string> hardest_;
  std::vector<double> skipped_;  ///< finer than the last failing one, from coarse to fine
  bool is_over_ = false, has_no_margin_ = false;
  double given_up_at_ = 0;  ///< evaluations per frame
};

}  // namespace oddity
