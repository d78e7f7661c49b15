#include "report/charts/sketch.hpp"

#include <algorithm>
#include <charconv>

#include "report/text/markup.hpp"

namespace oddity {

namespace {

using std::numbers::pi;
using Kind = Drawing::Kind;

constexpr double azimuth = pi / 6, elevation = pi / 8;
constexpr double font_size = 18;

bool of_set_up(Kind kind) {
  return kind == Kind::angle || kind == Kind::length || kind == Kind::direction || kind == Kind::label;
}

double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double norm(const Place& a) { return std::sqrt(dot(a, a)); }
Place cross(const Place& a, const Place& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Place middle(const Place& a, const Place& b) { return 0.5 * (a + b); }

/// The vector scaled to length 1; `otherwise` for a zero vector.
Spot unit(const Spot& a, const Spot& otherwise = {1, 0}) {
  return length(a) > 1e-9 ? 1 / length(a) * a : otherwise;
}
/// The vector turned to its left; y is down.
Spot left_of(const Spot& a) { return {a.y, -a.x}; }

std::string number(double x) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 1).ptr;
  std::string text(buffer, end);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string path(const std::vector<Spot>& line) {
  std::string d;
  for (const Spot& x : line) d += (d.empty() ? "M" : "L") + number(x.x) + " " + number(x.y);
  return d;
}

std::string faded(double opacity) { return opacity < 1 ? " opacity=\"" + number(opacity) + "\"" : ""; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A letter and its index, or a number if the text begins with a digit.
struct Written {
  std::string_view base, index;
  bool upright;

  explicit Written(std::string_view text) : base(text), upright(!text.empty() && is_digit(text[0])) {
    std::size_t end = text.size();
    while (!upright && end > 0 && is_digit(text[end - 1])) --end;
    if (!upright) base = text.substr(0, end), index = text.substr(end);
  }
  double width() const {
    const auto characters = std::ranges::count_if(base, [](char c) { return (c & 0xC0) != 0x80; });
    return font_size * (0.55 * static_cast<double>(characters) + 0.36 * static_cast<double>(index.size()));
  }
  std::string element(const Spot& center) const {
    std::string text = "<text" + std::string(upright ? " class=\"n\"" : "") + " x=\"" + number(center.x) +
                       "\" y=\"" + number(center.y + 0.3 * font_size) + "\">" + in_xml(base);
    if (!index.empty()) text += "<tspan dy=\"4\">" + std::string(index) + "</tspan>";
    return text + "</text>";
  }
};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Drawing order in the plane, from back to front.
int order_of(Kind kind) {
  constexpr Kind all[] = {Kind::plate, Kind::disc,    Kind::spring, Kind::rope,
                          Kind::rod,   Kind::support, Kind::arrow,  Kind::body};
  return static_cast<int>(std::ranges::find(all, kind) - all);
}

enum Layer { behind, thing, writing };

}  // namespace

// ---- the camera -------------------------------------------------------------------------------------------

void Box::add(const Spot& x, double margin) {
  left = std::min(left, x.x - margin);
  right = std::max(right, x.x + margin);
  top = std::min(top, x.y - margin);
  bottom = std::max(bottom, x.y + margin);
}
void Box::add(const Box& other) {
  left = std::min(left, other.left);
  right = std::max(right, other.right);
  top = std::min(top, other.top);
  bottom = std::max(bottom, other.bottom);
}

Camera::Camera(bool in_space) : in_space_(in_space), right_{1, 0, 0}, up_{0, 1, 0}, toward_{0, 0, 1} {
  if (!in_space) return;
  const double c = std::cos(azimuth), s = std::sin(azimuth), C = std::cos(elevation), S = std::sin(elevation);
  right_ = {-s, c, 0};
  up_ = {-S * c, -S * s, C};
  toward_ = {C * c, C * s, S};
}

Spot Camera::at(const Place& x) const { return {dot(x, right_), -dot(x, up_)}; }
double Camera::near(const Place& x) const { return in_space_ ? dot(x, toward_) : 0; }

Box Camera::extent(const Drawing& drawing) const {
  const Place anchor = anchor_of(drawing);
  Box box;
  for (const auto& p : drawing.primitives()) {
    if (of_set_up(p.kind)) continue;
    const bool round = p.kind == Kind::body || p.kind == Kind::sphere || p.kind == Kind::disc;
    if (round)
      box.add(at(p.points[0] - anchor), p.size);
    else
      for (const Place& x : p.points) box.add(at(x - anchor));
  }
  return box;
}

Place anchor_of(const Drawing& drawing) {
  for (const auto& p : drawing.primitives())
    if (p.kind == Kind::anchor) return p.points[0];
  return {};
}

// ---- pieces -----------------------------------------------------------------------------------------------

Sketch::Line Sketch::at(const std::vector<Place>& places) const {
  Line line;
  for (const Place& x : places) line.push_back(at(x));
  return line;
}

double Sketch::presence(double near) const {
  if (!in_space_ || !(nearest_ > farthest_)) return 1;
  return 0.4 + 0.6 * std::round(4 * (near - farthest_) / (nearest_ - farthest_)) / 4;
}

void Sketch::put(int layer, double near, std::string element) {
  pieces_.push_back({layer, near, std::move(element)});
}

void Sketch::stroke(int layer, const Line& line, std::string_view style, double near, double opacity) {
  put(layer, near,
      "<path class=\"" + std::string(style) + "\"" + faded(opacity) + " d=\"" + path(line) + "\"/>");
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Spot way = line[i + 1] - line[i];
    const int n = std::clamp(static_cast<int>(length(way) / 3), 1, 400);
    for (int k = 0; k <= n; ++k) inked_.push_back(line[i] + static_cast<double>(k) / n * way);
  }
  for (const Spot& x : line) extent_.add(x, 1);
}

void Sketch::fill(int layer, const Line& line, std::string_view style, double near) {
  put(layer, near, "<path class=\"" + std::string(style) + "\" d=\"" + path(line) + "Z\"/>");
  for (const Spot& x : line) {
    inked_.push_back(x);
    extent_.add(x, 1);
  }
}

void Sketch::ball(int layer, const Spot& x, double radius, std::string_view style, double near) {
  put(layer, near,
      "<circle class=\"" + std::string(style) + "\" cx=\"" + number(x.x) + "\" cy=\"" + number(x.y) +
          "\" r=\"" + number(radius) + "\"/>");
  const int n = std::max(8, static_cast<int>(2 * radius));
  for (int k = 0; k < n; ++k)
    inked_.push_back(x + radius * Spot{std::cos(2 * pi * k / n), std::sin(2 * pi * k / n)});
  extent_.add(x, radius + 1);
}

void Sketch::head(int layer, const Spot& tip, const Spot& along, std::string_view style, double near,
                  double size) {
  const Spot back = tip - size * along, aside = 0.38 * size * left_of(along);
  fill(layer, {tip, back + aside, back - aside}, style, near);
}

void Sketch::shaft(int layer, Spot from, const Spot& to, std::string_view style, double near) {
  const double size = std::min(9.0, 0.6 * length(to - from));
  const Spot along = unit(to - from);
  stroke(layer, {from, to - 0.8 * size * along}, style, near);
  head(layer, to, along, std::string(style) + " h", near, size);
}

void Sketch::deep_line(int layer, const std::vector<Place>& places, std::string_view style) {
  Line line;
  double now = 1;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double next = presence(near(middle(places[i], places[i + 1])));
    if (line.empty()) now = next;
    line.push_back(at(places[i]));
    if (next != now) {
      stroke(layer, line, style, 0, now);
      line = {at(places[i])};
      now = next;
    }
  }
  line.push_back(at(places.back()));
  stroke(layer, line, style, 0, now);
}

// ---- primitives -------------------------------------------------------------------------------------------

void Sketch::add(const Drawing& drawing, With with) {
  anchor_ = anchor_of(drawing);
  in_space_ = drawing.is_in_space();
  nearest_ = -std::numeric_limits<double>::infinity();
  farthest_ = -nearest_;
  for (const Primitive& p : drawing.primitives())
    for (const Place& x : p.points) {
      nearest_ = std::max(nearest_, near(x) + (p.kind == Kind::sphere ? p.size : 0));
      farthest_ = std::min(farthest_, near(x) - (p.kind == Kind::sphere ? p.size : 0));
    }
  for (const Primitive& p : drawing.primitives())
    if (!of_set_up(p.kind) && p.kind != Kind::anchor) draw(p, order_of(p.kind));
  if (with == With::letters) letters(drawing);
}

void Sketch::draw(const Primitive& p, int order) {
  Place center;
  for (const Place& x : p.points) center = center + 1.0 / static_cast<double>(p.points.size()) * x;
  const Spot first = at(p.points.front()), last = at(p.points.back());
  const double depth = in_space_ ? near(p.kind == Kind::body ? p.points[0] : center) : order;
  switch (p.kind) {
    case Kind::track:
      return deep_line(behind, p.points, "t");
    case Kind::guide:
      return deep_line(behind, p.points, "g");
    case Kind::sphere:
      return ball(behind, first, p.size * scale_, "s", -1);
    case Kind::axis:
      return shaft(behind, first, last, "a", 0);
    case Kind::body:
      return ball(thing, first, std::max(3.0, p.size * scale_), "b", depth);
    case Kind::rod:
      return rod(p, order);
    case Kind::spring:
      return spring(p, depth);
    case Kind::rope:
      return stroke(thing, at(p.points), "r", depth);
    case Kind::disc:
      return disc(p, in_space_ ? near(p.points[0]) : order);
    case Kind::plate:
      return fill(thing, at(p.points), "p", depth);
    case Kind::support:
      return p.points.size() == 1 ? ball(thing, first, 3.5, "o", depth) : hatched(p);
    case Kind::arrow:
      return shaft(thing, first, last, "v", depth);
    default:
      return;
  }
}

/// Draws the rod in pieces, so that another thing may hide part of it.
void Sketch::rod(const Primitive& p, int order) {
  if (!in_space_) return stroke(thing, at(p.points), "l", order);
  const auto pieces = sampled(0, 1, 12, [&](double u) { return (1 - u) * p.points[0] + u * p.points[1]; });
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
    stroke(thing, {at(pieces[i]), at(pieces[i + 1])}, "l", near(middle(pieces[i], pieces[i + 1])));
}

void Sketch::spring(const Primitive& p, double near) {
  const Spot from = at(p.points[0]), way = at(p.points[1]) - from, aside = left_of(unit(way));
  constexpr int turns = 9;
  const double width = std::clamp(0.5 * p.size * scale_, 3.0, 9.0);
  Line line{from, from + 0.12 * way};
  for (int i = 0; i < 2 * turns; ++i)
    line.push_back(from + (0.12 + 0.76 * (i + 0.5) / (2 * turns)) * way + (i % 2 ? -width : width) * aside);
  line.push_back(from + 0.88 * way);
  line.push_back(from + way);
  stroke(thing, line, "z", near);
}

void Sketch::disc(const Primitive& p, double near) {
  if (!in_space_) return ball(thing, at(p.points[0]), p.size * scale_, "d", near);
  const Place normal = p.points[1] - p.points[0];
  const Place least = std::abs(normal.z) > 0.9 * norm(normal) ? Place{1, 0, 0} : Place{0, 0, 1};
  const Place u = cross(normal, least), v = cross(normal, u);
  Line rim;
  for (int k = 0; k < 48; ++k) {
    const double angle = 2 * pi * k / 48;
    rim.push_back(at(p.points[0] + p.size * (std::cos(angle) / norm(u) * u + std::sin(angle) / norm(v) * v)));
  }
  fill(thing, rim, "d", near);
}

void Sketch::hatched(const Primitive& p) {
  const Spot from = at(p.points[0]), way = at(p.points[1]) - from, along = unit(way);
  const Spot stroke_ = 7.0 * (-1.0 * left_of(along)) - 6.0 * along;
  stroke(behind, {from, from + way}, "w");
  for (double x = 8; x <= length(way); x += 8)
    stroke(behind, {from + x * along, from + x * along + stroke_}, "x");
}

void Sketch::add_trail(const std::vector<Place>& way, const Place& anchor) {
  anchor_ = anchor;
  constexpr std::size_t parts = 6;
  const Line line = at(way);
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t from = k * (line.size() - 1) / parts, to = (k + 1) * (line.size() - 1) / parts;
    if (from < to)
      put(behind, 1,
          "<path class=\"m\" opacity=\"" + number(0.2 + 0.1 * static_cast<double>(k)) + "\" d=\"" +
              path({line.begin() + static_cast<std::ptrdiff_t>(from),
                    line.begin() + static_cast<std::ptrdiff_t>(to) + 1}) +
              "\"/>");
  }
}

// ---- letters ----------------------------------------------------------------------------------------------

void Sketch::letters(const Drawing& drawing) {
  for (const Primitive& p : drawing.primitives())
    if (p.kind == Kind::angle) angle(p);
  for (const Primitive& p : drawing.primitives())
    if (p.kind == Kind::direction) shaft(writing, at(p.points[0]), at(p.points[1]), "q", 0);
  for (const Primitive& p : drawing.primitives())
    if (p.kind == Kind::length) measure(p, drawing);
  for (const Primitive& p : drawing.primitives()) {
    if (p.letter.empty()) continue;
    const Spot first = at(p.points.front()), last = at(p.points.back());
    switch (p.kind) {
      case Kind::axis:
      case Kind::arrow:
      case Kind::direction:
        letter(p.letter, {last}, unit(last - first), 4);
        break;
      case Kind::body:
        letter(p.letter, {first}, {0.8, 0.6}, std::max(3.0, p.size * scale_) + 4);
        break;
      case Kind::disc:
        letter(p.letter, {first}, {0.8, -0.6}, (in_space_ ? 0.6 : 1) * p.size * scale_ + 3);
        break;
      case Kind::plate: {
        Spot center;
        for (const Place& x : p.points) center = center + 1.0 / static_cast<double>(p.points.size()) * at(x);
        letter(p.letter, {center}, {1, 0}, 8);
        break;
      }
      case Kind::spring: {
        const Spot way = last - first;
        letter(p.letter, {first + 0.5 * way, first + 0.35 * way, first + 0.65 * way}, left_of(unit(way)), 11);
        break;
      }
      case Kind::label:
        letter(p.letter, {first}, {-0.7, 0.7}, 5);
        break;
      default:
        break;
    }
  }
}

void Sketch::angle(const Primitive& p) {
  const Place a = p.points[1] - p.points[0], b = p.points[2] - p.points[0];
  const double between = std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0));
  if (!(between > 1e-6 && between < pi - 1e-6)) return;
  const double reach = scale_ * std::min(norm(a), norm(b));
  const double radius = std::min(0.8 * reach, std::clamp(16 / between, 26.0, 64.0)) / scale_;
  const auto along = [&](double u) {
    const double s = std::sin(between);
    return p.points[0] +
           radius * (std::sin((1 - u) * between) / s / norm(a) * a + std::sin(u * between) / s / norm(b) * b);
  };
  stroke(writing, {at(p.points[0]), at(p.points[1])}, "g");
  stroke(writing, at(sampled(0, 1, 24, along)), "c");
  const Spot arc = at(along(0.5));
  letter(p.letter, {arc}, unit(arc - at(p.points[0])), 3);
}

/// Draws a dimension line, unless the drawing has the same line; then a letter next to that is enough.
void Sketch::measure(const Primitive& p, const Drawing& drawing) {
  const Spot from = at(p.points[0]), to = at(p.points[1]), way = to - from, aside = left_of(unit(way));
  const auto same = [&](const Place& a, const Place& b) { return length(at(a) - at(b)) < 0.5; };
  const bool is_there = std::ranges::any_of(drawing.primitives(), [&](const Primitive& other) {
    if (of_set_up(other.kind) || other.kind == Kind::disc || other.kind == Kind::axis) return false;
    for (std::size_t i = 0; i + 1 < other.points.size(); ++i)
      if ((same(other.points[i], p.points[0]) && same(other.points[i + 1], p.points[1])) ||
          (same(other.points[i], p.points[1]) && same(other.points[i + 1], p.points[0])))
        return true;
    return false;
  });
  const double off = is_there ? 0 : 16;
  if (!is_there) {
    const Spot a = from + off * aside, b = to + off * aside, along = unit(way);
    const double size = std::min(7.0, length(way) / 3);
    stroke(writing, {from + 4.0 * aside, a + 3.0 * aside}, "e");
    stroke(writing, {to + 4.0 * aside, b + 3.0 * aside}, "e");
    stroke(writing, {a, b}, "c");
    head(writing, a, -1.0 * along, "c h", 0, size);
    head(writing, b, along, "c h", 0, size);
  }
  const Spot start = from + off * aside;
  letter(p.letter, {start + 0.5 * way, start + 0.38 * way, start + 0.62 * way}, aside, 4);
}

double Sketch::hidden(const Box& box) const {
  double hits = 0;
  for (const Spot& x : inked_) hits += x.x > box.left && x.x < box.right && x.y > box.top && x.y < box.bottom;
  for (const Box& other : written_)
    if (overlap(box, other)) hits += 40;
  return hits;
}

void Sketch::letter(std::string_view text, const std::vector<Spot>& about, Spot toward, double off) {
  const Written written(text);
  const double half = written.width() / 2, high = 0.4 * font_size;
  Box best;
  Spot place;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < about.size(); ++i)
    for (double more : {0, 4, 8, 13, 20, 30})
      for (int turn : {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6}) {
        const double angle = std::atan2(toward.y, toward.x) + turn * pi / 6;
        const Spot way{std::cos(angle), std::sin(angle)};
        const Spot x = about[i] + (off + more + half * std::abs(way.x) + high * std::abs(way.y)) * way;
        const Box box{x.x - half - 2, x.y - high - 2, x.x + half + 2, x.y + high + 3};
        const double cost = 8 * hidden(box) + 0.4 * more + 1.2 * std::abs(turn) + 2 * static_cast<double>(i);
        if (cost < least) {
          least = cost;
          best = box;
          place = x;
        }
      }
  put(writing, 0, written.element(place));
  written_.push_back(best);
  extent_.add(best);
}

std::string Sketch::elements() const {
  std::vector<const Piece*> order;
  for (const Piece& p : pieces_) order.push_back(&p);
  std::ranges::stable_sort(order, [](const Piece* a, const Piece* b) {
    return a->layer != b->layer ? a->layer < b->layer : a->near < b->near;
  });
  std::string all;
  for (const Piece* p : order) all += p->element + "\n";
  return all;
}

}  // namespace oddity
