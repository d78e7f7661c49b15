#include "report/study/standing.hpp"

#include <algorithm>
#include <array>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "report/study/findings.hpp"

namespace oddity {

namespace {

constexpr std::array kinds{"formulas", "numbers", "cases", "words"};

Standing standing_of(const CsvRow& row) {
  for (const Standing standing : {Standing::provable, Standing::computed, Standing::wording})
    if (row.cells[2] == name_of(standing)) return standing;
  throw BadInput(row.place + ": '" + row.cells[2] + "' is not one of provable, computed and wording");
}

std::string name_of_row(const CsvRow& row) {
  const std::string& stated = row.cells[1];
  if (stated.empty()) return row.cells[0];
  if (std::ranges::find(kinds, stated) == kinds.end())
    throw BadInput(row.place + ": '" + stated + "' is not one of formulas, numbers, cases and words");
  return row.cells[0] + " " + stated;
}

}  // namespace

std::string_view name_of(Standing standing) {
  constexpr std::array names{"proved", "provable", "computed", "wording", "unclassed"};
  return names[static_cast<std::size_t>(standing)];
}

std::string_view stated_in(const Claim& claim) {
  const auto& checks = claim.printed.checks;
  if (checks.empty() || claim.kind == Fault::term) return "words";
  if (std::ranges::all_of(checks, counts_violations)) return "cases";
  const bool samples =
      std::ranges::any_of(checks, [](const Check& c) { return c.where.starts_with("worst of "); });
  return samples ? "formulas" : "numbers";
}

Standings::Standings(const std::filesystem::path& folder) : proved_(read_proofs(folder)) {
  for (const CsvRow& row : read_csv(folder / "unproved.csv").rows) {
    if (row.cells.size() != 4) throw BadInput(row.place + ": the columns are claims,stated,standing,why");
    const std::string name = name_of_row(row);
    if (!rows_.emplace(name, Basis{standing_of(row), row.cells[3], name}).second)
      throw BadInput(row.place + ": a second row of " + name);
  }
}

Basis Standings::of(const Claim& claim) const {
  if (const auto found = proved_.find(claim.id); found != proved_.end())
    return {Standing::proved, found->second.proved};
  const std::string stated = " " + std::string(stated_in(claim));
  for (const std::string& row : {claim.id, claim.id.substr(0, claim.id.find('-')) + stated, "all" + stated})
    if (const auto found = rows_.find(row); found != rows_.end()) return found->second;
  return {};
}

}  // namespace oddity
