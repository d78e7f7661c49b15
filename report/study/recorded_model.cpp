#include "report/study/recorded_model.hpp"

namespace oddity {

std::string state_letter(char name, std::size_t i) {
  return std::string(1, name) + "[" + std::to_string(i) + "]";
}

namespace detail {

std::vector<formula::Recorded> given(formula::Record& record, const ToRecord& asked) {
  std::vector<formula::Recorded> all;
  for (std::size_t i = 0; i < asked.values.size(); ++i)
    all.push_back(asked.with_letters ? formula::Recorded::letter(record, asked.names[i], asked.values[i])
                                     : formula::Recorded(asked.values[i]));
  return all;
}

void find_velocities(RecordedModel& made, std::span<const std::size_t> declared, bool are_declared) {
  const std::size_t n = made.rates.size();
  made.velocity_of.assign(n, -1);
  made.is_velocity.assign(n, false);
  for (const std::size_t i : declared) made.is_velocity[i] = true;
  if (are_declared) return;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if (i == j || made.rates[i].is_known()) continue;
      const auto& rate = made.record->operations()[static_cast<std::size_t>(made.rates[i].at())];
      if (rate.text == state_letter('x', j))
        made.velocity_of[i] = static_cast<int>(j), made.is_velocity[j] = true;
    }
}

void record_turning(RecordedModel& made, const std::array<formula::Recorded, 4>& now,
                    const std::array<formula::Recorded, 3>& w,
                    const std::array<formula::Recorded, 4>& start) {
  const auto& [q, i, j, k] = now;
  const formula::Recorded size = sqrt(q * q + i * i + j * j + k * k);
  made.orientation_at_start = listed(start);
  made.turning = {-(w[0] * i + w[1] * j + w[2] * k) / 2, (w[0] * q + w[1] * k - w[2] * j) / 2,
                  (w[1] * q + w[2] * i - w[0] * k) / 2, (w[2] * q + w[0] * j - w[1] * i) / 2};
  made.orientation = {q / size, i / size, j / size, k / size};
}

}  // namespace detail

}  // namespace oddity
