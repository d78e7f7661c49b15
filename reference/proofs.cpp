#include "reference/proofs.hpp"

#include <cstdint>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/text.hpp"

namespace oddity {

std::string proof_hash(std::string_view file) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : file) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
  return text;
}

ProvedClaims read_proofs(const std::filesystem::path& folder) {
  ProvedClaims proofs;
  for (const CsvRow& row : read_csv(folder / "proofs.csv").rows) {
    if (row.cells.size() != 4) throw BadInput(row.place + ": the columns are claim,hash,proved,margin");
    const double margin = row.cells[3].empty() ? 0 : row.number(3);
    if (!proofs.emplace(row.cells[0], ProvedClaim{row.cells[1], row.cells[2], margin}).second)
      throw BadInput(row.place + ": a second proof of " + row.cells[0]);
  }
  return proofs;
}

std::string proofs_csv(const ProvedClaims& proofs) {
  std::string text =
      "# Claims proved by Coq: written by oddity prove --approve once coqc has checked every file. hash: of "
      "the file, which is made of the formulas that the suite computes with; the suite is red when the file made now "
      "has another. margin: the least error of the printed value.\n"
      "claim,hash,proved,margin\n";
  for (const auto& [claim, p] : proofs)
    text += claim + "," + p.hash + ",\"" + p.proved + "\"," +
            (p.margin > 0 ? format_shortest(p.margin) : "") + "\n";
  return text;
}

}  // namespace oddity
