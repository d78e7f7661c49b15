#pragma once

namespace oddity {

/// While an object of this class lives, `filled` leaves the places in texts unfilled on this thread. So a
/// test can distinguish the numbers that are filled in from those that are typed.
class PlacesKept {
 public:
  PlacesKept();
  ~PlacesKept();
  PlacesKept(const PlacesKept&) = delete;
  PlacesKept& operator=(const PlacesKept&) = delete;
};

}  // namespace oddity
