// The plan of a sweep: if it can be read, it is written and read again.
#include "extras/sweep/plan.hpp"

#include "extras/fuzz/fuzz.hpp"

void fuzz::read(std::string_view input) {
  const oddity::sweep::Plan plan = oddity::sweep::plan_from_json(std::string(input), "input");
  const std::string again = to_json(plan);
  require(to_json(oddity::sweep::plan_from_json(again, "again")) == again);
  const oddity::sweep::Cells last = plan.tile(plan.tiles() - 1);
  require(last.last_x == plan.width() - 1 && last.last_y == plan.height() - 1);
}
