#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
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
inline Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Place operator*(double s, const Place& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Places at(u) at n + 1 values of u, evenly spaced.
template <class At>
std::vector<Place> sampled(double from, double to, std::size_t n, const At& at) {
  std::vector<Place> all;
  for (std::size_t i = 0; i <= n; ++i)
    all.push_back(at(from + (to - from) * static_cast<double>(i) / static_cast<double>(n)));
  return all;
}
/// Level.
inline std::vector<Place> circle(const Place& center, double radius) {
  return sampled(0, 2 * std::numbers::pi, 48, [&](double u) {
    return center + radius * Place{std::cos(u), std::sin(u), 0};
  });
}

class Drawing {
 public:
  enum class Kind {
    body,     ///< a ball at a point, of radius `size`: what moves, in the colour of its method
    rod,      ///< from point to point
    spring,   ///< from point to point, of width `size`
    rope,     ///< a thin line through the points
    track,    ///< a line through the points that is there from the start: a wire, a hill, the ground
    guide,    ///< a dashed line through the points, to see by
    disc,     ///< about the first point, of radius `size`, square to the way to the second
    sphere,   ///< its outline, about a point, of radius `size`
    plate,    ///< the polygon of the points, filled
    support,  ///< what holds: a point that does not move, or a line hatched to its right
    axis,     ///< an arrow of a system of coordinates, from point to point, with its letter
    arrow,    ///< a vector, from point to point
    anchor,   ///< a point that stays in the middle of the picture; without one the picture stands still
    // Of the drawing of the set-up alone:
    angle,      ///< at the first point, from the second to the third, with its letter
    length,     ///< from point to point, measured on the left of that way, with its letter
    direction,  ///< an arrow from point to point, a velocity at the start or gravity, with its letter
    label,      ///< a letter at a point
  };
  /// In their order, as scripts call them.
  static constexpr std::array<std::string_view, 17> kind_names{
      "body",    "rod",  "spring", "rope",   "track", "guide",  "disc",      "sphere", "plate",
      "support", "axis", "arrow",  "anchor", "angle", "length", "direction", "label"};
  struct Primitive {
    Kind kind;
    std::vector<Place> points;
    double size = 0;
    std::string_view letter = {};  ///< digits at its end are an index
    bool leaves_trail = false;     ///< of a body: the way that it has come is drawn
  };

  void body(const Place& at, double radius, std::string_view letter = {}) {
    add({Kind::body, {at}, radius, letter, false});
  }
  void body_with_trail(const Place& at, double radius, std::string_view letter = {}) {
    add({Kind::body, {at}, radius, letter, true});
  }
  void rod(const Place& from, const Place& to) { add({Kind::rod, {from, to}}); }
  void spring(const Place& from, const Place& to, double width, std::string_view letter = {}) {
    add({Kind::spring, {from, to}, width, letter});
  }
  void rope(std::vector<Place> through) { add({Kind::rope, std::move(through)}); }
  void track(std::vector<Place> through) { add({Kind::track, std::move(through)}); }
  void guide(std::vector<Place> through) { add({Kind::guide, std::move(through)}); }
  void disc(const Place& center, double radius, std::string_view letter = {},
            const Place& normal = {0, 0, 1}) {
    add({Kind::disc, {center, center + normal}, radius, letter});
  }
  void sphere(const Place& center, double radius) { add({Kind::sphere, {center}, radius}); }
  void plate(std::vector<Place> corners, std::string_view letter = {}) {
    add({Kind::plate, std::move(corners), 0, letter});
  }
  void support(const Place& at) { add({Kind::support, {at}}); }
  void support(const Place& from, const Place& to) { add({Kind::support, {from, to}}); }
  void axis(const Place& from, const Place& to, std::string_view letter) {
    add({Kind::axis, {from, to}, 0, letter});
  }
  void arrow(const Place& from, const Place& to, std::string_view letter = {}) {
    add({Kind::arrow, {from, to}, 0, letter});
  }
  void anchor(const Place& at) { add({Kind::anchor, {at}}); }
  void angle(const Place& at, const Place& from, const Place& to, std::string_view letter) {
    add({Kind::angle, {at, from, to}, 0, letter});
  }
  void length(const Place& from, const Place& to, std::string_view letter) {
    add({Kind::length, {from, to}, 0, letter});
  }
  void direction(const Place& from, const Place& to, std::string_view letter) {
    add({Kind::direction, {from, to}, 0, letter});
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
