#pragma once

#include <array>

namespace oddity {

/// A conserved quantity, and what moves in it: the part that is exchanged with the rest, such as the kinetic
/// energy, which does not depend on where a potential is counted from.
struct Conserved {
  double value, moving;
};

using OneConserved = std::array<Conserved, 1>;

/// The energy; its kinetic part moves.
inline OneConserved energy_of(double kinetic, double potential) { return {{{kinetic + potential, kinetic}}}; }

}  // namespace oddity
