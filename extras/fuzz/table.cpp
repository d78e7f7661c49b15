// A table of reference values.
#include "reference/table.hpp"

#include "extras/fuzz/fuzz.hpp"

void fuzz::read(std::string_view input) {
  static const oddity::truth::Truth truth{"angle", "", {"a", "t"}, {{"theta", "rad"}, {"x", "m"}}, {}, "",
                                          {},      "", {}};
  oddity::read_table(file("table.csv", input), truth);
}
