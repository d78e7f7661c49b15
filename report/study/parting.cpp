#include "report/study/parting.hpp"

#include <algorithm>
#include <cmath>

namespace oddity {

namespace {

/// The components of one frame.
Value frame_of(const Value& all, int frame, std::size_t components) {
  std::vector<double> one(components);
  for (std::size_t i = 0; i < components; ++i) one[i] = all[static_cast<std::size_t>(frame) * components + i];
  return Value(std::move(one));
}

/// A motion's frames, one at a time.
class Frames {
 public:
  explicit Frames(const Quantity& motion)
      : motion_(motion),
        components_(motion.reference.value.size() / static_cast<std::size_t>(motion.samples)) {
    one_.unit = motion.unit;
    one_.norms = motion.norms;
  }

  bool has(const Value& path) const { return path.size() == motion_.reference.value.size() && finite(path); }
  /// Errors of a frame in each unit.
  std::vector<double> errors(const Value& path, int frame) const {
    return one_.errors(frame_of(path, frame, components_), true_at(frame));
  }
  std::vector<double> sizes(int frame) const {
    return one_.errors(Value(std::vector<double>(components_, 0.0)), true_at(frame));
  }

 private:
  Value true_at(int frame) const { return frame_of(motion_.reference.value, frame, components_); }

  const Quantity& motion_;
  std::size_t components_;
  Quantity one_;
};

/// Distance of two paths, in one unit.
struct Apart {
  std::vector<double> until;  ///< the largest distance up to each frame
  double size = 0;            ///< size of the true path

  void add(double distance, double true_size) {
    until.push_back(std::max(until.empty() ? 0 : until.back(), distance));
    size = std::max(size, true_size);
  }

  /// A distance below the difference of the start, as before a first contact, has not grown yet.
  bool is_chaotic(double difference) const {
    constexpr double chaotic = 1000;
    for (std::size_t frame = 1; 2 * frame <= until.size(); ++frame)
      if (until[2 * frame - 1] > chaotic * std::max(until[frame - 1], difference * size)) return true;
    return false;
  }
};

}  // namespace

std::vector<double> errors_until(const Quantity& motion, const Value& path) {
  const Frames frames(motion);
  if (!frames.has(path)) return {};
  std::vector<double> until;
  for (int k = 0; k < motion.samples; ++k) {
    const double error = motion.in_needs(frames.errors(path, k));
    until.push_back(std::max(until.empty() ? 0 : until.back(), error));
  }
  return until;
}

std::optional<std::size_t> Parting::lost_at() const {
  const auto lost = std::ranges::find_if(until, [](double error) { return error > 1; });
  if (lost == until.end()) return {};
  return static_cast<std::size_t>(lost - until.begin());
}

double Parting::in_the_end(const std::vector<double>& error_until) const {
  // An error that is not in the direction of fastest growth is smaller by this factor.
  constexpr double in_direction = 1.0 / 16;
  const double seen = error_until.back();
  if (!is_chaotic || until.size() != error_until.size()) return seen;
  const auto beyond = std::ranges::find_if(error_until, [](double error) { return error > 1; });
  if (beyond == error_until.begin() || beyond == error_until.end()) return seen;
  const auto last = static_cast<std::size_t>(beyond - error_until.begin()) - 1;
  if (!(until[last] > 0)) return seen;
  return std::max(seen, in_direction * error_until[last] * until.back() / until[last]);
}

Parting parting_of(const Quantity& motion, const Value& beside, double difference) {
  const Frames frames(motion);
  if (!frames.has(beside)) return {};
  std::vector<Apart> by_unit(motion.units().size());
  for (int k = 0; k < motion.samples; ++k) {
    const std::vector<double> apart = frames.errors(beside, k), size = frames.sizes(k);
    for (std::size_t unit = 0; unit < by_unit.size(); ++unit) by_unit[unit].add(apart[unit], size[unit]);
  }
  const bool is_chaotic =
      std::ranges::any_of(by_unit, [=](const Apart& apart) { return apart.is_chaotic(difference); });
  return {errors_until(motion, beside), is_chaotic};
}

}  // namespace oddity
