// Writes the sources of the models' module, which are made from the scenes' listings: write_players FILE...
// Leaves unchanged files alone, so that they are not compiled again.

#include <fstream>
#include <sstream>

#include "reference/files.hpp"
#include "report/site/players.hpp"

namespace {

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  const auto texts = oddity::module_source(static_cast<std::size_t>(argc - 1));
  for (int i = 1; i < argc; ++i) {
    const std::string& text = texts[static_cast<std::size_t>(i - 1)];
    if (text_of(argv[i]) != text) oddity::write_whole(argv[i], text);
  }
}
