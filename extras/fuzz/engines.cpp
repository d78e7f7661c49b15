// Kept results of engines: if they can be read, they are written and read again.
#include "report/study/engines.hpp"

#include "extras/fuzz/fuzz.hpp"
#include "tests/scratch_folder.hpp"

void fuzz::read(std::string_view input) {
  const auto contests = oddity::read_engines(file("engines.json", input));
  const auto again = file("again.json", "");
  write(contests, again);
  const std::string text = text_of(again);
  write(oddity::read_engines(again), again);
  require(text_of(again) == text);
}
