#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

/// How text looks where it is read: in as many columns as there are, and in colour where that is wanted.
namespace oddity {

enum class Style { heading, good, doubtful, bad, aside };

struct Screen {
  std::size_t width = 0;  ///< columns; 0: as many as the text takes, as in a pipe or a file
  bool colour = false;

  /// The text in its colour, or as it is.
  std::string styled(Style, const std::string& text) const;
  /// `n` columns, or fewer where the screen has fewer.
  std::size_t at_most(std::size_t n) const { return width == 0 ? n : std::min(width, n); }
};

/// What a standard stream is read on. Colour is for terminals; NO_COLOR in the environment, if not empty,
/// takes it away, and CLICOLOR_FORCE, if neither empty nor 0, has it anywhere. COLUMNS says more than the
/// terminal.
Screen screen_of(int descriptor);

/// The columns that a text takes; colours and combining accents take none.
std::size_t columns_of(const std::string& text);
/// The text in at most so many columns, with "..." where some is left out.
std::string cut(const std::string& text, std::size_t columns);
/// The same, with nothing of a word left over where that leaves half of the columns or more.
std::string cut_at_word(const std::string& text, std::size_t columns);
/// Lines are broken between words so that they fit; what follows a break is indented by `indent`.
std::string wrapped(const std::string& text, const Screen&, std::size_t indent = 0);

}  // namespace oddity
