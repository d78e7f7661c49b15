#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/study/results.hpp"

/// Approved limits and maps of stability.
namespace oddity {

/// The outcomes in the order of a map's legend.
inline constexpr std::array outcomes_of_a_map{
    Outcome::ok,      Outcome::inaccurate, Outcome::drifted, Outcome::diverged,   Outcome::non_finite,
    Outcome::stalled, Outcome::deceived,   Outcome::raised,  Outcome::chattering, Outcome::grazing};
/// An outcome's letter on a map.
char letter_of(Outcome);
/// The outcome of a letter; empty if it has none.
std::optional<Outcome> outcome_of(char letter);
/// The letters of a row's outcomes, from the coarsest step to the finest.
std::string letters(const MapRow&);
/// "..*.........": a star for each of a row's outcomes that a few roundings of the start decide; empty: none.
std::string fragile_cells(const MapRow&);
/// "0.464 to 0.555, from 0.882 on".
std::string shown_tongues(const Limit&);
/// Tongues from their text, to three digits; nothing if the text is not one of theirs.
std::optional<std::vector<ode::Tongue>> tongues_shown_as(std::string_view text);
/// Range in which other observers find a limit that is not sharp: "0.4 to 0.5".
std::string shown_soft(const Between&);
/// The range from its text, to three digits. Nothing if the text is no range.
std::optional<Between> soft_shown_as(std::string_view text);
/// How the motion ends just above the limit, or "stable" when nothing breaks the method.
std::string beyond(const Limit&);

/// The rows of limits.csv and stability_maps.csv that would approve these results.
std::string limit_rows(const Results&);
std::string limit_row(const ExerciseResult&, const Limit&);
std::string map_rows(const Results&);
std::string map_row(const ExerciseResult&, const MapRow&);

}  // namespace oddity
