#pragma once

namespace oddity {

/// While it lives, `filled` leaves the places of a text in it, on this thread. A test sees so which of a
/// text's numbers are filled in and which are typed.
class PlacesKept {
 public:
  PlacesKept();
  ~PlacesKept();
  PlacesKept(const PlacesKept&) = delete;
  PlacesKept& operator=(const PlacesKept&) = delete;
};

}  // namespace oddity
