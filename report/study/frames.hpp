#pragma once

#include <limits>
#include <vector>

#include "chapters/scene.hpp"
#include "report/study/need.hpp"

/// Frames of different lengths, late, or dropped.
namespace oddity {

/// Frame times of a game.
struct FramesAsked {
  double jitter = 0;  ///< each frame is longer or shorter by up to this fraction
  double drop = 0;    ///< fraction of frames that are not drawn
  double longest = std::numeric_limits<double>::infinity();  ///< cap on the clock's advance in a frame
  std::vector<double> trace = {};  ///< lengths, repeated; empty: as the frame rate gives them
  double seed = 1;                 ///< for the random numbers
};

/// Limits of the options.
inline constexpr double least_part = 1e-9, most_part = 0.99, least_frame = 1e-9, most_frame = 1e9;
inline constexpr int most_seed = 1'000'000'000;

/// In words: "each up to 20 % longer or shorter"; empty where all are of the same length.
std::string says(const FramesAsked&, const std::string& unit = "s");

/// The frames up to the horizon, in this unit of time; null where all are of the same length. Throws BadInput
/// if there are no frames, more than a need may have, or no frame in the later half.
std::shared_ptr<const FrameTimes> frame_times(const FramesAsked&, double frames_per_second, double horizon,
                                              const std::string& unit = "s");

/// So many frames as they come, one after another, in units of a usual one.
std::vector<double> frame_lengths(const FramesAsked&, std::size_t count);

/// A length of time: "16.7 ms", in other units than seconds "0.0167 yr".
std::string shown_length(double time, const std::string& unit);

/// The first `count` of the need's frames.
Horizon first_frames(const Need&, int count);
/// All of them.
Horizon horizon_of(const Need&);

/// The scene's motion. If frames differ in length, each way to match fixed steps to them is a separate
/// algorithm: "Runge-Kutta 4, fixed steps interpolated". With kicks, unless null.
Quantity motion_at_frames(const Scene&, const Parameters&, const Horizon&, const Reference&,
                          const std::shared_ptr<const Kicks>& = {});

/// The algorithm's name in the catalog, and how its steps meet frames.
std::string_view without_stepping(std::string_view algorithm);
Stepping stepping_of(std::string_view algorithm);

}  // namespace oddity
