#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pictures as SVG text, which are the same on every machine and legible on light and dark pages.
namespace oddity {

struct Pixel {
  double x = 0, y = 0;
};

/// Eight colours that colour-blind readers can distinguish, each with its mark. After the eighth they repeat.
inline constexpr int svg_slots = 8;

/// A picture being drawn. Coordinates are in pixels from the upper left corner, written to a tenth. Classes
/// are those of the style at the head of svg.cpp; "c0" to "c7" are the colours.
class Svg {
 public:
  /// `title` is shown by viewers and read by screen readers; `css` is added to the style.
  Svg(double width, double height, const std::string& title, const std::string& css = "");

  void line(Pixel from, Pixel to, std::string_view classes);
  /// Omits points that make no visible difference; breaks the curve where a point is not finite.
  void curve(const std::vector<Pixel>&, std::string_view classes);
  void area(const std::vector<Pixel>& corners, std::string_view classes);
  void rectangle(Pixel corner, double width, double height, std::string_view classes);
  /// Draws the slot's mark at each point.
  void marks(const std::vector<Pixel>&, int slot, std::string_view classes);
  /// `data` is the path's attribute d.
  void path(const std::string& data, std::string_view classes);

  enum class Anchor { start, middle, end };
  void text(Pixel at, const std::string& words, std::string_view classes, Anchor = Anchor::start);
  /// The letter above each place, as separate texts: not every viewer supports a list of places in one text.
  void letters(const std::vector<Pixel>&, char letter, std::string_view classes);
  /// Text that reads upwards.
  void upward_text(Pixel at, const std::string& words, std::string_view classes);

  /// Draws `says` in bold on at most two lines, and `of` below it. Returns the y below both.
  double headline(const std::string& says, const std::string& of);

  std::string str() const { return text_ + "</svg>\n"; }

 private:
  double width_;
  std::string text_;
};

/// "c3" for slot 3.
std::string colour_class(int slot);
/// A length to a tenth of a pixel.
std::string px(double x);
/// At most `most` characters; the last one is an ellipsis if the text is cut.
std::string shortened(const std::string& text, std::size_t most);
/// Lines of at most `most` bytes, broken at spaces.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
/// Heights of labels near the wanted ones: in the same order, at least `apart` from each other, and between
/// `top` and `bottom` if they fit.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double top, double bottom);

}  // namespace oddity
