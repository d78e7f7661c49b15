#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/drawing.hpp"

/// A drawing seen by a fixed camera, as SVG elements.
namespace oddity {

/// A point on paper; y is down.
struct Spot {
  double x = 0, y = 0;
};
inline Spot operator+(const Spot& a, const Spot& b) { return {a.x + b.x, a.y + b.y}; }
inline Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
inline Spot operator*(double s, const Spot& a) { return {s * a.x, s * a.y}; }
inline double length(const Spot& a) { return std::hypot(a.x, a.y); }

struct Box {
  double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  void add(const Spot&, double margin = 0);
  void add(const Box&);
};

/// Axonometric projection from the azimuth and the elevation. A drawing in the plane is seen from above, with
/// x to the right.
class Camera {
 public:
  explicit Camera(bool in_space);

  /// The projected point, in the scene's lengths; y is down.
  Spot at(const Place& x) const;
  /// Depth: larger is nearer to the viewer.
  double near(const Place&) const;

  /// Bounding box of a drawing, relative to its anchor, without the parts that only the set-up shows.
  Box extent(const Drawing&) const;

 private:
  bool in_space_;
  Place right_, up_, toward_;
};

/// The point that the picture follows.
Place anchor_of(const Drawing&);

/// Draws on paper in pixels, at a scale, relative to the anchor.
class Sketch {
 public:
  Sketch(const Camera& camera, double scale) : camera_(camera), scale_(scale) {}

  enum class With { letters, motion_alone };
  void add(const Drawing&, With);
  /// A body's path so far, in the drawing's frame; older parts are paler.
  void add_trail(const std::vector<Place>& way, const Place& anchor);

  std::string elements() const;
  const Box& extent() const { return extent_; }

 private:
  using Kind = Drawing::Kind;
  using Primitive = Drawing::Primitive;
  using Line = std::vector<Spot>;
  /// Pieces are drawn in the order of layers, and within a layer from far to near.
  struct Piece {
    int layer;
    double near;
    std::string element;
  };

  Spot at(const Place& x) const { return scale_ * camera_.at(x - anchor_); }
  Line at(const std::vector<Place>&) const;
  double near(const Place& x) const { return camera_.near(x - anchor_); }
  /// Opacity, from 0.4 (far) to 1 (near).
  double presence(double near) const;

  void put(int layer, double near, std::string element);
  void stroke(int layer, const Line&, std::string_view style, double near = 0, double opacity = 1);
  void fill(int layer, const Line&, std::string_view style, double near);
  void ball(int layer, const Spot&, double radius, std::string_view style, double near);
  void shaft(int layer, Spot from, const Spot& to, std::string_view style, double near);
  void head(int layer, const Spot& tip, const Spot& along, std::string_view style, double near, double size);
  /// A line in space whose far parts are paler.
  void deep_line(int layer, const std::vector<Place>&, std::string_view style);

  void draw(const Primitive&, int order);
  void spring(const Primitive&, double near);
  void rod(const Primitive&, int order);
  void disc(const Primitive&, double near);
  void hatched(const Primitive&);
  void letters(const Drawing&);
  void angle(const Primitive&);
  void measure(const Primitive&, const Drawing&);

  /// Writes a letter where it hides least: near one of the spots, at least `off` pixels away, preferably in
  /// the direction `toward`.
  void letter(std::string_view, const std::vector<Spot>& about, Spot toward, double off);
  double hidden(const Box&) const;

  Camera camera_;
  double scale_;
  Place anchor_;
  bool in_space_ = false;
  double nearest_ = 0, farthest_ = 0;
  std::vector<Piece> pieces_;
  std::vector<Spot> inked_;  ///< points every few pixels along the lines
  std::vector<Box> written_;
  Box extent_;
};

}  // namespace oddity
