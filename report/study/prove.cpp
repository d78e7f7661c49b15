#include "report/study/prove.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <sstream>
#include <system_error>

#include "reference/files.hpp"
#include "reference/proofs.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::minutes most_time{15};

fs::path file_of(const fs::path& folder, const std::string& claim) { return folder / (claim + ".v"); }
/// The seal contains the checksum of the proved file.
fs::path seal_of(const fs::path& folder, const std::string& claim) { return folder / (claim + ".proved"); }

/// The file with six times the time for each step of a proof. Coq limits wall time, and a busy machine needs
/// more of it.
std::string with_patience(std::string text) {
  const std::string limit = "Timeout 20 ", longer = "Timeout 120 ";
  for (std::size_t at = 0; (at = text.find(limit, at)) != std::string::npos; at += longer.size())
    text.replace(at, limit.size(), longer);
  return text;
}

/// coqc accepts only module names, and leaves compiled files and nra's results where it works.
Ended coqc(const std::string& text) {
  const PassingFolder folder;
  write_whole(folder / "proof.v", with_patience(text));
  return run_program({"coqc", "-q", "-w", "none", "proof.v"}, "", most_time, 0, folder / "");
}

Checked checked(const Provable& provable, const fs::path& folder) {
  Checked result;
  result.claim = provable.claim;
  const std::string text = coq_file(provable), hash = proof_hash(text);
  if (read_sealed(seal_of(folder, provable.claim)) == hash + "\n") {
    result.proved = result.kept = true;
    return result;
  }
  const auto begun = std::chrono::steady_clock::now();
  const Ended ended = coqc(text);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  if (!ended.ok) {
    result.message = "coqc: " + ended.how + ": " + ended.words;
    return result;
  }
  for (const std::string& axiom : unknown_axioms(ended.output))
    result.message += "it rests on " + axiom + "; ";
  result.proved = result.message.empty();
  if (result.proved) write_sealed(seal_of(folder, provable.claim), hash + "\n");
  return result;
}

constexpr std::array<std::string_view, 8> known{"ClassicalDedekindReals.sig_",
                                                "FunctionalExtensionality.functional_extensionality_dep",
                                                "Classical_Prop.classic",
                                                "Uint63.",
                                                "PrimInt63.",
                                                "FloatAxioms.",
                                                "PrimFloat.",
                                                "ClassicalEpsilon.constructive_indefinite_description"};

bool is_known(const std::string& axiom) {
  return std::ranges::any_of(known, [&](std::string_view name) { return axiom.starts_with(name); });
}

}  // namespace

std::span<const std::string_view> known_axioms() { return known; }

std::vector<std::string> unknown_axioms(const std::string& printed) {
  std::vector<std::string> unknown;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    const bool begins = !line.empty() && line[0] != ' ' && line != "Axioms:" && line[0] != ':' &&
                        line != "Closed under the global context";
    const std::string name = line.substr(0, line.find(' '));
    if (begins && !is_known(name)) unknown.push_back(name);
  }
  return unknown;
}

bool coq_is_there() {
  try {
    return coqc(coq_file({"0.0-nothing", "whether the libraries are there"})).ok;
  } catch (const std::system_error&) {
    return false;
  }
}

void write_proofs(const Provables& provables, const fs::path& folder) {
  for (const Provable& p : provables) write_whole(file_of(folder, p.claim), coq_file(p));
}

std::vector<Checked> prove(const Provables& provables, const fs::path& folder, const Progress& progress) {
  write_proofs(provables, folder);
  std::vector<Checked> all(provables.size());
  Stage stage(progress, "proofs", provables.size());
  in_parallel(provables.size(), [&](std::size_t i) {
    all[i] = checked(provables[i], folder);
    stage.add();
  });
  return all;
}

}  // namespace oddity
