#include <algorithm>
#include <limits>

#include "report/study/choose.hpp"

namespace oddity {

namespace {

/// The components of one frame.
Value frame_of(const Value& all, int frame, std::size_t components) {
  std::vector<double> one(components);
  for (std::size_t i = 0; i < components; ++i) one[i] = all[static_cast<std::size_t>(frame) * components + i];
  return Value(std::move(one));
}

/// How far two paths have come apart, in one unit.
struct Apart {
  std::vector<double> until;  ///< the largest distance up to each frame
  double size = 0;            ///< of the true path

  void add(double distance, double true_size) {
    until.push_back(std::max(until.empty() ? 0 : until.back(), distance));
    size = std::max(size, true_size);
  }

  /// What is less than the difference in the start, as before a first contact, has not grown yet.
  bool is_chaotic(double difference) const {
    constexpr double chaotic = 1000;
    for (std::size_t frame = 1; 2 * frame <= until.size(); ++frame)
      if (until[2 * frame - 1] > chaotic * std::max(until[frame - 1], difference * size)) return true;
    return false;
  }
};

}  // namespace

std::optional<double> predictable_until(const Quantity& motion, const Value& beside, double difference,
                                        double frames_per_second) {
  const Value& truth = motion.reference.value;
  if (beside.size() != truth.size()) return {};
  const std::size_t components = truth.size() / static_cast<std::size_t>(motion.samples);
  Quantity frame;
  frame.unit = motion.unit;
  frame.norms = motion.norms;
  const Value nothing(std::vector<double>(components, 0.0));
  std::vector<Apart> by_unit(motion.units().size());
  double lost = std::numeric_limits<double>::infinity();
  for (int k = 0; k < motion.samples; ++k) {
    const Value here = frame_of(truth, k, components);
    const std::vector<double> apart = frame.errors(frame_of(beside, k, components), here),
                              size = frame.errors(nothing, here);
    for (std::size_t unit = 0; unit < by_unit.size(); ++unit) by_unit[unit].add(apart[unit], size[unit]);
    if (motion.in_needs(apart) > 1) lost = std::min(lost, (k + 1) / frames_per_second);
  }
  if (std::ranges::none_of(by_unit, [=](const Apart& apart) { return apart.is_chaotic(difference); }))
    return {};
  return lost;
}

}  // namespace oddity
