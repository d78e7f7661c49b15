#include "report/study/proving.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/files.hpp"
#include "report/study/run_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The names after "Axioms:", each of which begins a line.
std::vector<std::string> assumptions(const std::string& output) {
  std::vector<std::string> names;
  std::istringstream lines(output.substr(std::min(output.find("Axioms:"), output.size())));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && !std::isspace(static_cast<unsigned char>(line[0])) && line != "Axioms:")
      names.push_back(line.substr(0, line.find_first_of(" :")));
  return names;
}

bool tells_assumptions(const std::string& output) {
  return output.find("Axioms:") != std::string::npos ||
         output.find("Closed under the global context") != std::string::npos;
}

Proved run_coq(const fs::path& file) {
  const Ended ended = run_program({"coqc", "-q", "-w", "none", file.string()}, "", std::chrono::minutes(5));
  if (!ended.ok) return {.why = ended.how + ": " + ended.words + ended.output};
  if (!tells_assumptions(ended.output)) return {.why = "coqc did not say what the proof assumes"};
  Proved proved{.ok = true, .assumes = assumptions(ended.output)};
  for (const std::string& name : not_allowed(proved.assumes)) {
    proved.ok = false;
    proved.why += "the proof assumes " + name + ". ";
  }
  return proved;
}

}  // namespace

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    if (fs::is_regular_file(fs::path(folder) / program, ignored)) return true;
  }
  return false;
}

Proved prove(const fs::path& folder, const std::string& name, const std::string& text) {
  std::string module = name;  // Coq takes a file's name for that of a module
  for (char& c : module)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  const fs::path file = folder / ("claim_" + module + ".v"), kept = folder / "proved" / checksum(text);
  write_whole(file, text);
  Proved proved;
  if (const auto before = read_sealed(kept)) {
    proved = {.ok = true, .kept = true};
    std::istringstream names(*before);
    for (std::string line; std::getline(names, line);) proved.assumes.push_back(line);
    return proved;
  }
  proved = run_coq(file);
  if (!proved.ok) return proved;
  std::string names;
  for (const std::string& line : proved.assumes) names += line + "\n";
  keep_sealed(kept, names);
  return proved;
}

std::vector<std::string> not_allowed(const std::vector<std::string>& assumes) {
  static const std::vector<std::string> allowed{"ClassicalDedekindReals.sig_forall_dec",
                                                "ClassicalDedekindReals.sig_not_dec",
                                                "FunctionalExtensionality.functional_extensionality_dep",
                                                "Classical_Prop.classic",
                                                "sig_forall_dec",
                                                "sig_not_dec",
                                                "functional_extensionality_dep",
                                                "classic"};
  std::vector<std::string> others;
  for (const std::string& name : assumes) {
    const bool machine_integer = name.starts_with("Uint63.") || name.starts_with("PrimInt63.");
    if (!machine_integer && std::ranges::find(allowed, name) == allowed.end()) others.push_back(name);
  }
  return others;
}

std::map<std::string, ProofRow> read_proofs(const fs::path& folder) {
  std::map<std::string, ProofRow> record;
  for (const CsvRow& row : read_csv(folder / "proofs.csv").rows) {
    if (row.cells.size() != 5)
      throw BadInput(row.place + ": the columns are claim,reading,kind,bound,checksum");
    if (!record.emplace(row.cells[0] + "_" + row.cells[1], ProofRow{row.cells[4], row.cells[2], row.cells[3]})
             .second)
      throw BadInput(row.place + ": a second proof of " + row.cells[0] + ", " + row.cells[1]);
  }
  return record;
}

std::string proofs_csv(const std::vector<Proof>& proofs) {
  std::string csv =
      "# What Coq proved of claims' readings, written by oddity prove --approve: the checksum is of the whole\n"
      "# file that it accepted. A reading is near or far from what is true by the bound, or an identity.\n"
      "claim,reading,kind,bound,checksum\n";
  for (const Proof& proof : proofs)
    csv += proof.claim + "," + proof.reading + "," + to_string(proof.kind) + "," + proof.bound + "," +
           checksum(coq_file(proof)) + "\n";
  return csv;
}

std::vector<std::string> differences(const std::vector<Proof>& proofs,
                                     const std::map<std::string, ProofRow>& record) {
  std::vector<std::string> lines;
  std::map<std::string, ProofRow> left = record;
  for (const Proof& proof : proofs) {
    const auto row = left.find(name_of(proof));
    if (row == left.end()) {
      lines.push_back(name_of(proof) + ": no proof is on record");
      continue;
    }
    if (row->second.checksum != checksum(coq_file(proof)))
      lines.push_back(name_of(proof) + ": the statement is not the one that was proved");
    left.erase(row);
  }
  for (const auto& [name, row] : left) lines.push_back(name + ": proved once, and no longer stated");
  return lines;
}

}  // namespace oddity
