// A results file: if it can be read, it is written and read again.
#include "report/study/results.hpp"

#include "extras/fuzz/fuzz.hpp"
#include "report/study/run.hpp"

void fuzz::read(std::string_view input) {
  const std::string again = to_json(oddity::results_from_json(std::string(input), "input"));
  require(to_json(oddity::results_from_json(again, "again")) == again);
}
