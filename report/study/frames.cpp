#include "report/study/frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "chapters/random.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/findings.hpp"
#include "report/study/kicks.hpp"

namespace oddity {

namespace {

constexpr std::array steppings{std::pair{Stepping::last_step, ", last of fixed steps"},
                               std::pair{Stepping::interpolated, ", fixed steps interpolated"},
                               std::pair{Stepping::extrapolated, ", fixed steps extrapolated"}};

std::string percent(double part) { return format_significant(100 * part, 3) + " %"; }

}  // namespace

std::string says(const FramesAsked& asked, const std::string& unit) {
  std::string text =
      asked.trace.empty() ? "" : "as in a trace of " + counted(std::ssize(asked.trace), "frame", "frames");
  const auto add = [&](const std::string& one) { text += (text.empty() ? "" : ", ") + one; };
  if (asked.jitter > 0) add("each up to " + percent(asked.jitter) + " longer or shorter");
  if (asked.drop > 0) add(percent(asked.drop) + " dropped");
  if (std::isfinite(asked.longest)) add("none longer than " + shown_length(asked.longest, unit));
  return text;
}

std::shared_ptr<const FrameTimes> frame_times(const FramesAsked& asked, double frames_per_second,
                                              double horizon, const std::string& unit) {
  FrameTimes frames{.at = {}, .says = says(asked, unit), .unit = unit};
  if (frames.says.empty()) return nullptr;
  Random random(asked.seed);
  double last = 0, length = 0;
  for (std::size_t k = 0;; ++k) {
    const double usual = asked.trace.empty() ? 1 / frames_per_second : asked.trace[k % asked.trace.size()];
    length += usual * (1 + asked.jitter * random.between(-1, 1));
    if (random.between(0, 1) < asked.drop) continue;
    length = std::min(length, asked.longest);
    if (last + length > horizon * (1 + 1e-12)) break;
    frames.at.push_back(last += length);
    frames.longest = std::max(frames.longest, std::exchange(length, 0));
    if (static_cast<double>(frames.at.size()) > most_frames)
      throw BadInput("the horizon has more than " + format_shortest(most_frames) + " such frames");
  }
  if (frames.at.empty()) throw BadInput("the horizon is shorter than a frame");
  if (last < horizon / 2)
    throw BadInput(
        "the last frame within the horizon of " + format_shortest(horizon) + " " + unit + " is drawn at " +
        shown_length(last, unit) +
        ". So less than half of the motion is judged: ask for a longer horizon, or cap frames with "
        "--max-frame");
  return std::make_shared<const FrameTimes>(std::move(frames));
}

std::vector<double> frame_lengths(const FramesAsked& asked, std::size_t count) {
  FramesAsked relative = asked;
  const double usual = asked.trace.empty() ? 1
                                           : std::accumulate(asked.trace.begin(), asked.trace.end(), 0.0) /
                                                 static_cast<double>(asked.trace.size());
  for (double& length : relative.trace) length /= usual;
  const auto frames = frame_times(relative, 1, static_cast<double>(count));
  std::vector<double> lengths(frames->at.size());
  std::adjacent_difference(frames->at.begin(), frames->at.end(), lengths.begin());
  return lengths;
}

std::string shown_length(double time, const std::string& unit) {
  return unit == "s" ? format_significant(1000 * time, 3) + " ms" : format_significant(time, 3) + " " + unit;
}

Horizon first_frames(const Need& need, int count) {
  const double end = need.time_of(count);
  if (!need.frame_times) return {end, 1, need.frames_per_second};
  return {end, count, 0, {need.frame_times, &need.frame_times->at}};
}

Horizon horizon_of(const Need& need) {
  if (need.frame_times) return first_frames(need, static_cast<int>(need.frames()));
  return {need.horizon, 1, need.frames_per_second};
}

Quantity motion_at_frames(const Scene& scene, const Parameters& p, const Horizon& horizon,
                          const Reference& truth, const std::shared_ptr<const Kicks>& kicks) {
  Quantity seen = motion(scene, p, horizon, truth);
  if (kicks) seen = kicked_motion(std::move(seen), kicks);
  if (!horizon.frames) return seen;
  const std::string end = format_shortest(horizon.end);  // time of the last frame, in all its digits
  if (const auto at = seen.says.find(end); at != std::string::npos)
    seen.says.replace(at, end.size(), format_significant(horizon.end, 4));
  for (const auto& [stepping, name] : steppings) {
    Horizon stepped = horizon;
    stepped.stepping = stepping;
    for (Method& method : motion(scene, p, stepped, Reference::nothing()).methods) {
      if (!method.unstable_steps || method.resolution.name != "step") continue;
      if (kicks) method = with_kicks(std::move(method), kicks);
      method.algorithm += name;
      seen.methods.push_back(std::move(method));
    }
  }
  return seen;
}

std::string_view without_stepping(std::string_view algorithm) {
  for (const auto& [stepping, name] : steppings)
    if (algorithm.ends_with(name))
      return algorithm.substr(0, algorithm.size() - std::string_view(name).size());
  return algorithm;
}

Stepping stepping_of(std::string_view algorithm) {
  for (const auto& [stepping, name] : steppings)
    if (algorithm.ends_with(name)) return stepping;
  return Stepping::divided;
}

}  // namespace oddity
