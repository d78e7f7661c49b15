// The approved records: verdicts, limits, errors or maps, by the first byte.
#include "extras/fuzz/fuzz.hpp"
#include "reference/errors.hpp"
#include "reference/limits.hpp"
#include "reference/verdicts.hpp"

void fuzz::read(std::string_view input) {
  if (input.empty()) return;
  const std::string_view text = input.substr(1);
  switch (input.front()) {
    case 'v':
      oddity::read_verdicts(file("verdicts.csv", text).parent_path());
      break;
    case 'l':
      oddity::read_limits(file("limits.csv", text).parent_path());
      break;
    case 'e':
      oddity::read_errors(file("errors.csv", text).parent_path());
      break;
    default:
      oddity::read_maps(file("stability_maps.csv", text).parent_path());
  }
}
