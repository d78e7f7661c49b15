#pragma once

#include <string_view>
#include <utility>
#include <vector>

/// What a scene looks like at one time, in a dozen primitives: from these come the drawing of the set-up, the
/// strip of frames, and the player in the page. Needs the standard library alone.
namespace oddity {

/// In the plane x is to the right and y is up; in space z is up. In the unit of the scene's lengths.
struct Place {
  double x = 0, y = 0, z = 0;
};

class Drawing {
 public:
  enum class Kind {
    body,     ///< a ball at a point, of radius `size`: what moves, in the colour of its method
    rod,      ///< from point to point
    spring,   ///< from point to point, of width `size`
    rope,     ///< a thin line through the points
    track,    ///< a line through the points that is there from the start: a wire, a hill, the ground
    disc,     ///< about the first point, of radius `size`, square to the second point seen from the first
    plate,    ///< the polygon of the points, filled
    support,  ///< what holds: a point that does not move
    axis,     ///< an arrow of a system of coordinates, from point to point, with its letter
    arrow,    ///< a vector, from point to point
    // Of the drawing of the set-up alone:
    angle,   ///< at the first point, from the second to the third, with its letter
    length,  ///< from point to point, with its letter
    label,   ///< a letter at a point
  };
  struct Primitive {
    Kind kind;
    std::vector<Place> points;
    double size = 0;
    std::string_view letter = {};
    bool leaves_trail = false;  ///< of a body: the way that it has come is drawn
  };

  void body(const Place& at, double radius, std::string_view letter = {}) {
    add({Kind::body, {at}, radius, letter, false});
  }
  void body_with_trail(const Place& at, double radius, std::string_view letter = {}) {
    add({Kind::body, {at}, radius, letter, true});
  }
  void rod(const Place& from, const Place& to) { add({Kind::rod, {from, to}}); }
  void spring(const Place& from, const Place& to, double width) { add({Kind::spring, {from, to}, width}); }
  void rope(std::vector<Place> through) { add({Kind::rope, std::move(through)}); }
  void track(std::vector<Place> through) { add({Kind::track, std::move(through)}); }
  void disc(const Place& center, double radius, const Place& toward = {0, 0, 1}) {
    add({Kind::disc, {center, toward}, radius});
  }
  void plate(std::vector<Place> corners) { add({Kind::plate, std::move(corners)}); }
  void support(const Place& at) { add({Kind::support, {at}}); }
  void axis(const Place& from, const Place& to, std::string_view letter) {
    add({Kind::axis, {from, to}, 0, letter});
  }
  void arrow(const Place& from, const Place& to, std::string_view letter = {}) {
    add({Kind::arrow, {from, to}, 0, letter});
  }
  void angle(const Place& at, const Place& from, const Place& to, std::string_view letter) {
    add({Kind::angle, {at, from, to}, 0, letter});
  }
  void length(const Place& from, const Place& to, std::string_view letter) {
    add({Kind::length, {from, to}, 0, letter});
  }
  void label(const Place& at, std::string_view letter) { add({Kind::label, {at}, 0, letter}); }

  /// Once, first: the drawing is of space, and can be turned.
  void in_space() { in_space_ = true; }
  bool is_in_space() const { return in_space_; }
  const std::vector<Primitive>& primitives() const { return primitives_; }

 private:
  void add(Primitive primitive) { primitives_.push_back(std::move(primitive)); }

  bool in_space_ = false;
  std::vector<Primitive> primitives_;
};

}  // namespace oddity
