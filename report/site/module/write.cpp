// Writes the sources of the models' module that are made of the scenes' listings: write_players FILE...

#include "reference/files.hpp"
#include "report/site/players.hpp"

int main(int argc, char** argv) {
  const auto texts = oddity::module_source(static_cast<std::size_t>(argc - 1));
  for (int i = 1; i < argc; ++i) oddity::write_whole(argv[i], texts[static_cast<std::size_t>(i - 1)]);
}
