#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pictures as SVG text: what does not change from one machine to another, and reads well on a light page and
/// on a dark one.
namespace oddity {

struct Pixel {
  double x = 0, y = 0;
};

/// Eight colours that stay apart for colour-blind readers, each with a mark of its own; after the eighth they
/// begin anew.
inline constexpr int svg_slots = 8;

/// A picture under way. Places are in pixels from the upper left corner and are written to a tenth of one.
/// Classes are those of the style at the head of svg.cpp; "c0" to "c7" are the colours.
class Svg {
 public:
  /// `title` is what a viewer shows of the picture as a whole, and what a screen reader says; `css` is added
  /// to the style.
  Svg(double width, double height, const std::string& title, const std::string& css = "");

  void line(Pixel from, Pixel to, std::string_view classes);
  /// Through the points, leaving out those that the eye would not miss; broken where one is not finite.
  void curve(const std::vector<Pixel>&, std::string_view classes);
  void area(const std::vector<Pixel>& corners, std::string_view classes);
  void rectangle(Pixel corner, double width, double height, std::string_view classes);
  /// Marks of a slot at the points.
  void marks(const std::vector<Pixel>&, int slot, std::string_view classes);
  /// A part of a path's data, in SVG's own words.
  void path(const std::string& data, std::string_view classes);

  enum class Anchor { start, middle, end };
  void text(Pixel at, const std::string& words, std::string_view classes, Anchor = Anchor::start);
  /// The same letter above each place, each as a text of its own: not every viewer places the letters of one.
  void letters(const std::vector<Pixel>&, char letter, std::string_view classes);
  /// The same from below to above.
  void upward_text(Pixel at, const std::string& words, std::string_view classes);

  /// What the picture says, in bold over two lines at most, and beneath it what it is of. Returns the place
  /// below.
  double headline(const std::string& says, const std::string& of);

  std::string str() const { return text_ + "</svg>\n"; }

 private:
  double width_;
  std::string text_;
};

/// "c3" for the slot 3.
std::string colour_class(int slot);
/// To a tenth of a pixel.
std::string px(double x);
/// At most so many letters, the last of them an ellipsis where some are left out.
std::string shortened(const std::string& text, std::size_t most);
/// In lines of at most so many letters, broken at spaces.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
/// The places of labels that would like to be at these heights: in the same order, and at least `apart` from
/// one another, between `top` and `bottom` as far as they fit.
std::vector<double> spread(const std::vector<double>& wanted, double apart, double top, double bottom);

}  // namespace oddity
