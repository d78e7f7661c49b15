#include "report/text/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "reference/text.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

/// The picture brings a background, so that it is legible on any page.
constexpr std::string_view style =
    R"(.paper{fill:#fff}.t{fill:#24292f}.dim{fill:#57606a}.b{font-weight:bold}.big{font-size:15px}.small{font-size:11px}
.halo{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.grid,.axis,.lead,.need,.game,.floor,.theory,.rim{fill:none;stroke:#d8dee4}.axis{stroke:#57606a}
.lead{stroke:#8c959f;stroke-width:.6;stroke-dasharray:1 2}.need{stroke:#1a7f37;stroke-width:1.4}
.game{stroke:#57606a;stroke-dasharray:6 4}.floor{stroke:#57606a;stroke-dasharray:1 3}
.good{fill:#2da44e;fill-opacity:.1}.needed{fill:#1a7f37}
.front{fill:none;stroke:#d4a72c;stroke-width:9;stroke-opacity:.38;stroke-linejoin:round;stroke-linecap:round}
.truth{fill:none;stroke:#8c959f;stroke-width:6;stroke-opacity:.45}.known{fill:none;stroke:#24292f}
.curve{fill:none;stroke:currentColor;stroke-width:1.7;stroke-linejoin:round}.thin{stroke-width:.7}
.mark{fill:currentColor;stroke:currentColor}.hollow{fill:#fff;stroke:currentColor;stroke-width:1.3}
.theory{stroke:#000;stroke-width:2.5}.rim{stroke:#fff;stroke-width:5}
.c0{color:#0072b2}.c1{color:#d55e00}.c2{color:#00805f}.c3{color:#b5449b}
.c4{color:#2f93d0}.c5{color:#a87400}.c6{color:#7a1f52}.c7{color:#50565d}
@media(prefers-color-scheme:dark){.paper,.hollow{fill:#0d1117}.t{fill:#e6edf3}.dim{fill:#9198a1}
.halo{stroke:#0d1117}.grid{stroke:#30363d}.axis,.game,.floor{stroke:#9198a1}.need{stroke:#3fb950}.needed{fill:#3fb950}.known{stroke:#e6edf3}
.c0{color:#58a6ff}.c1{color:#ff8f4f}.c2{color:#2ec49a}.c3{color:#e58bd2}
.c4{color:#9bd4ff}.c5{color:#e3b341}.c6{color:#ff7096}.c7{color:#c9d1d9}})";

constexpr double headline_left = 12;

long tenths(double x) { return std::lround(10 * x); }

std::string in_pixels(long tenths) { return format_shortest(static_cast<double>(tenths) / 10); }

bool is_finite(Pixel p) { return std::isfinite(p.x) && std::isfinite(p.y); }

double distance_from_chord(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

/// Marks the points needed to approximate the curve within the tolerance, by Douglas and Peucker's algorithm.
void keep_needed(const std::vector<Pixel>& points, std::size_t first, std::size_t last,
                 std::vector<bool>& kept) {
  constexpr double tolerance = 0.2;  // pixels
  double largest = tolerance;
  std::size_t farthest = 0;
  for (std::size_t i = first + 1; i < last; ++i)
    if (const double d = distance_from_chord(points[i], points[first], points[last]); d > largest)
      largest = d, farthest = i;
  kept[first] = kept[last] = true;
  if (farthest == 0) return;
  keep_needed(points, first, farthest, kept);
  keep_needed(points, farthest, last, kept);
}

/// Path data of the points that are needed: "M10 20l1.5 2 3 4".
std::string polyline(const std::vector<Pixel>& points) {
  if (points.size() < 2) return "";
  std::vector<bool> kept(points.size());
  keep_needed(points, 0, points.size() - 1, kept);
  std::string data;
  long x = 0, y = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!kept[i]) continue;
    const long to_x = tenths(points[i].x), to_y = tenths(points[i].y);
    if (i == 0)
      data = "M" + in_pixels(to_x) + " " + in_pixels(to_y);
    else
      data +=
          (data.find('l') == std::string::npos ? "l" : " ") + in_pixels(to_x - x) + " " + in_pixels(to_y - y);
    x = to_x, y = to_y;
  }
  return data;
}

/// Marks centred at the current point, as the rest of a path's data.
constexpr std::array<std::string_view, svg_slots> mark_shapes{
    "m-3 0a3 3 0 106 0a3 3 0 10-6 0z",
    "m-2.8-2.8h5.6v5.6h-5.6z",
    "m0-3.8l3.5 6.2h-7z",
    "m0-4l4 4-4 4-4-4z",
    "m0 3.8l3.5-6.2h-7z",
    "m-1.3-3.8h2.6v2.5h2.5v2.6h-2.5v2.5h-2.6v-2.5h-2.5v-2.6h2.5z",
    "m-3.8 0l6.2-3.5v7z",
    "m3.8 0l-6.2-3.5v7z"};

std::string attributes(std::string_view classes) { return " class=\"" + std::string(classes) + "\""; }

std::string at(Pixel p) { return " x=\"" + px(p.x) + "\" y=\"" + px(p.y) + "\""; }

}  // namespace

Svg::Svg(double width, double height, const std::string& title, const std::string& css) : width_(width) {
  const std::string w = px(width), h = px(height);
  text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
          "\" viewBox=\"0 0 " + w + " " + h +
          "\" font-family=\"Helvetica,Arial,sans-serif\" font-size=\"12\" role=\"img\">\n<title>" +
          in_xml(title) + "</title>\n<style>" + std::string(style) + css + "</style>\n";
  rectangle({0, 0}, width, height, "paper");
}

void Svg::line(Pixel from, Pixel to, std::string_view classes) {
  path("M" + px(from.x) + " " + px(from.y) + "L" + px(to.x) + " " + px(to.y), classes);
}

void Svg::curve(const std::vector<Pixel>& points, std::string_view classes) {
  std::string data;
  for (auto from = points.begin(); from != points.end();) {
    const auto to = std::find_if_not(from, points.end(), is_finite);
    data += polyline({from, to});
    from = std::find_if(to, points.end(), is_finite);
  }
  if (!data.empty()) path(data, classes);
}

void Svg::area(const std::vector<Pixel>& corners, std::string_view classes) {
  std::string data;
  for (const Pixel& p : corners) data += (data.empty() ? "M" : "L") + px(p.x) + " " + px(p.y);
  path(data + "z", classes);
}

void Svg::rectangle(Pixel corner, double width, double height, std::string_view classes) {
  text_ += "<rect" + attributes(classes) + at(corner) + " width=\"" + px(width) + "\" height=\"" +
           px(height) + "\"/>\n";
}

void Svg::marks(const std::vector<Pixel>& points, int slot, std::string_view classes) {
  std::string data;
  for (const Pixel& p : points)
    data +=
        "M" + px(p.x) + " " + px(p.y) + std::string(mark_shapes[static_cast<std::size_t>(slot % svg_slots)]);
  if (!data.empty()) path(data, std::string(classes) + " " + colour_class(slot));
}

void Svg::path(const std::string& data, std::string_view classes) {
  text_ += "<path" + attributes(classes) + " d=\"" + data + "\"/>\n";
}

void Svg::text(Pixel place, const std::string& words, std::string_view classes, Anchor anchor) {
  text_ += "<text" + attributes(classes) + at(place) +
           (anchor == Anchor::start ? ""
            : anchor == Anchor::end ? " text-anchor=\"end\""
                                    : " text-anchor=\"middle\"") +
           ">" + in_xml(words) + "</text>\n";
}

void Svg::letters(const std::vector<Pixel>& places, char letter, std::string_view classes) {
  if (places.empty()) return;
  text_ += "<g" + attributes(classes) + " text-anchor=\"middle\">";
  for (Pixel place : places) text_ += "<text" + at(place) + ">" + in_xml(std::string(1, letter)) + "</text>";
  text_ += "</g>\n";
}

void Svg::upward_text(Pixel place, const std::string& words, std::string_view classes) {
  text_ += "<text" + attributes(classes) + " text-anchor=\"middle\" transform=\"translate(" + px(place.x) +
           " " + px(place.y) + ")rotate(-90)\">" + in_xml(words) + "</text>\n";
}

double Svg::headline(const std::string& says, const std::string& of) {
  const auto letters_of = [this](double each) {
    return static_cast<std::size_t>((width_ - 2 * headline_left) / each);
  };
  double y = 6;
  std::vector<std::string> lines = wrapped(says, letters_of(8));
  if (lines.size() > 2) lines = {lines[0], shortened(lines[1] + " " + lines[2], letters_of(8))};
  for (const std::string& line : lines) text({headline_left, y += 18}, line, "t b big");
  text({headline_left, y += 18}, shortened(of, letters_of(6)), "dim");
  return y + 12;
}

std::string colour_class(int slot) { return "c" + std::to_string(slot % svg_slots); }

std::string px(double x) { return in_pixels(tenths(x)); }

std::string shortened(const std::string& text, std::size_t most) {
  std::size_t letters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = (text[i] & 0xC0) != 0x80;
    if (begins && ++letters > most) {
      std::size_t end = i;  // drops the last character that fits
      while (end > 0 && (text[--end] & 0xC0) == 0x80) {
      }
      return text.substr(0, end) + "…";
    }
  }
  return text;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    std::size_t end = text.size();
    if (end - from > most) {
      end = text.rfind(' ', from + most);
      if (end == std::string::npos || end <= from) end = std::min(text.find(' ', from + most), text.size());
    }
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::vector<double> spread(const std::vector<double>& wanted, double apart, double top, double bottom) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<double> places(wanted.size());
  double next = top;
  for (std::size_t i : order) next = (places[i] = std::max(next, wanted[i])) + apart;
  double last = bottom;
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    places[*i] = std::min(last, places[*i]);
    last = places[*i] - apart;
  }
  return places;
}

}  // namespace oddity
