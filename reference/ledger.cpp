#include "reference/ledger.hpp"

#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"

namespace oddity {

std::vector<Assertion> read_ledger(const std::filesystem::path& folder, const std::string& exercise) {
  const std::filesystem::path file = folder / "ledger" / (exercise + ".csv");
  if (!std::filesystem::exists(file)) return {};
  std::vector<Assertion> all;
  for (const CsvRow& row : read_csv(file).rows) {
    if (row.cells.size() != 5)
      throw BadInput(row.place + ": the columns are line,place,assertion,claims,reason");
    Assertion one{static_cast<int>(row.number(0)), row.cells[1], row.cells[2], {}, row.cells[4]};
    std::istringstream claims(row.cells[3]);
    for (std::string slug; claims >> slug;) one.claims.push_back(exercise + "-" + slug);
    if (one.place.empty() || one.assertion.empty())
      throw BadInput(row.place + ": an assertion needs a place and a text");
    if (one.claims.empty() == one.reason.empty())
      throw BadInput(row.place + ": an assertion has claims, or a reason why it has none");
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace oddity
