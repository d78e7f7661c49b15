#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

/// Text for a screen: its width and its colours.
namespace oddity {

enum class Style { heading, good, doubtful, bad, aside };

struct Screen {
  std::size_t width = 0;  ///< columns; 0 means unlimited, as in a pipe or a file
  bool colour = false;

  /// The text in the style's colour, or unchanged without colours.
  std::string styled(Style, const std::string& text) const;
  /// `n` columns, or the screen's width if that is less.
  std::size_t at_most(std::size_t n) const { return width == 0 ? n : std::min(width, n); }
};

/// The screen of a standard stream. Only terminals have colour. A non-empty NO_COLOR turns it off;
/// CLICOLOR_FORCE, if neither empty nor 0, turns it on everywhere. COLUMNS overrides the terminal's width.
Screen screen_of(int descriptor);

/// Number of columns of a text; colours and combining accents take none.
std::size_t columns_of(const std::string& text);
/// The text in at most `columns` columns; "..." marks a cut.
std::string cut(const std::string& text, std::size_t columns);
/// As cut(), but at the end of a word if that keeps more than half of the text.
std::string cut_at_word(const std::string& text, std::size_t columns);
/// Breaks lines between words to fit the screen; continued lines are indented by `indent`.
std::string wrapped(const std::string& text, const Screen&, std::size_t indent = 0);

}  // namespace oddity
