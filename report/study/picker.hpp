#pragma once

#include <optional>
#include <vector>

#include "report/study/ladder.hpp"

namespace oddity {

struct Picked {
  std::optional<Candidate> chosen = {};
  bool by_objective = true;          ///< otherwise nothing that meets the objective passes
  std::vector<Candidate> ties = {};  ///< those of the same cost
};

/// Chooses among candidates that were tried and timed.
class Picker {
 public:
  Picker(const Need& need, const Scene& scene) : need_(need), scene_(scene) {}

  /// The cheapest; of near ties the more accurate, and of equally accurate ones the simpler.
  Picked pick(const std::vector<Candidate>&, bool by_objective) const;

  bool meets_objective(const Candidate&) const;
  bool may_meet_objective(const Ladder&) const;
  bool is_eligible(const Candidate&, bool by_objective) const;
  /// The scene's page shows the model to be wrong.
  bool is_faulted(std::string_view model) const;

 private:
  const Need& need_;
  const Scene& scene_;
};

/// Multistep methods need a history.
bool is_multistep(std::string_view algorithm);

/// Each ties with the other.
bool have_same_cost(const Candidate&, const Candidate&);

/// The one with the least time for which the predicate holds.
template <class Predicate>
std::optional<Candidate> cheapest(const std::vector<Candidate>& candidates, const Predicate& predicate) {
  std::optional<Candidate> best;
  for (const Candidate& candidate : candidates)
    if (predicate(candidate) && (!best || candidate.seconds_per_frame < best->seconds_per_frame))
      best = candidate;
  return best;
}

}  // namespace oddity
