#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

/// A picture of a scene at one time, as a few kinds of primitives. The drawing of the set-up, the strip of
/// frames and the page's player are made from it. Needs only the standard library.
namespace oddity {

/// In the unit of the scene's lengths. In the plane x points right and y up; in space z points up.
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
/// Horizontal circle.
inline std::vector<Place> circle(const Place& center, double radius) {
  return sampled(0, 2 * std::numbers::pi, 48, [&](double u) {
    return center + radius * Place{std::cos(u), std::sin(u), 0};
  });
}

class Drawing {
 public:
  enum class Kind {
    body,     ///< a ball at a point, of radius `size`: a moving body, in the colour of its method
    rod,      ///< from point to point
    spring,   ///< from point to point, of width `size`
    rope,     ///< a thin line through the points
    track,    ///< a fixed line through the points: a wire, a hill, the ground
    guide,    ///< a dashed auxiliary line through the points
    disc,     ///< about the first point, of radius `size`, perpendicular to the line to the second point
    sphere,   ///< outline about a point, of radius `size`
    plate,    ///< the polygon of the points, filled
    support,  ///< a support: a fixed point, or a line hatched to its right
    axis,     ///< an arrow of a coordinate system, from point to point, with its letter
    arrow,    ///< a vector, from point to point
    anchor,   ///< a point kept in the middle of the picture; without one the view is fixed
    // Only in the drawing of the set-up:
    angle,      ///< at the first point, from the second to the third, with its letter
    length,     ///< from point to point, with its letter; measured on the left of this line
    direction,  ///< an arrow from point to point, an initial velocity or gravity, with its letter
    label,      ///< a letter at a point
  };
  /// Names in the scripts, in the order of `Kind`.
  static constexpr std::array<std::string_view, 17> kind_names{
      "body",    "rod",  "spring", "rope",   "track", "guide",  "disc",      "sphere", "plate",
      "support", "axis", "arrow",  "anchor", "angle", "length", "direction", "label"};
  struct Primitive {
    Kind kind;
    std::vector<Place> points;
    double size = 0;
    std::string_view letter = {};  ///< trailing digits are a subscript
    bool leaves_trail = false;     ///< draw a body's past path
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

  /// Call once, first, if the drawing is in space and can be turned.
  void in_space() { in_space_ = true; }
  bool is_in_space() const { return in_space_; }
  const std::vector<Primitive>& primitives() const { return primitives_; }

 private:
  void add(Primitive primitive) { primitives_.push_back(std::move(primitive)); }

  bool in_space_ = false;
  std::vector<Primitive> primitives_;
};

}  // namespace oddity
