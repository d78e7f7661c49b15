#include "report/study/starts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "report/study/policy.hpp"
#include "report/study/stopwatch.hpp"
#include "solvers/stop.hpp"

namespace oddity {

int Starts::seen_nearby() const { return std::min(policy.seen, need_.starts) - 1; }

int Starts::unseen_count() const {
  return need_.starts == 1 ? policy.reported : need_.starts - 1 - seen_nearby();
}

Starts::Starts(const Task& task, const Need& need, const Reference& truth, const Progress& progress,
               std::shared_ptr<const PartJudged> part)
    : need_(need),
      progress_(progress),
      truth_(truth.watched([this](double done) {
        check_stop();
        if (motions_) motions_->come_to(done);
      })),
      conditions_(task, need, truth_, std::move(part)) {
  const Stopwatch watch(seconds_);
  // Methods are looked up in the first start, which may not move.
  seen_.reserve(static_cast<std::size_t>(1 + seen_nearby() + policy.rounds * unseen_count()));
  motions_.emplace(progress_, "making the true motions", static_cast<std::size_t>(1 + seen_nearby()));
  std::ranges::move(conditions_.asked_and_nearby(seen_nearby(), [this] { motions_->add(); }),
                    std::back_inserter(seen_));
  motions_.reset();  // motions made later, when a method asks for them, count as part of its trial
}

const std::vector<Start>& Starts::unseen() {
  if (unseen_) return *unseen_;
  const Stopwatch watch(seconds_);
  motions_.emplace(progress_, "making more true motions", static_cast<std::size_t>(unseen_count()));
  unseen_ = conditions_.nearby_starts(unseen_count(), [this] { motions_->add(); });
  motions_.reset();
  return *unseen_;
}

bool Starts::are_unseen_reported_only() const { return need_.starts <= 1 + seen_nearby(); }

void Starts::see_unseen() {
  std::ranges::move(*unseen_, std::back_inserter(seen_));
  unseen_.reset();
}

bool Starts::are_beyond_double() const {
  return !asked().is_whole && asked().parting && (**asked().parting).is_chaotic;
}

const Method& Starts::method(const Candidate& candidate) const {
  return *method_of(motion(), candidate.model, candidate.algorithm);
}

}  // namespace oddity
