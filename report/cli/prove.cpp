#include "report/cli/prove.hpp"

#include <iostream>
#include <optional>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/cli/settings.hpp"
#include "report/study/proving.hpp"
#include "report/study/run_program.hpp"

namespace oddity::verbs {

namespace fs = std::filesystem;

namespace {

std::vector<Proof> proofs_of(const std::string& exercise) {
  std::vector<Proof> asked;
  std::string proved;
  for (Proof& proof : oddity::proofs()) {
    const std::string number = proof.claim.substr(0, proof.claim.find('-'));
    if (!proved.ends_with(" " + number)) proved += (proved.empty() ? " " : ", ") + number;
    if (exercise.empty() || exercise == number) asked.push_back(std::move(proof));
  }
  if (asked.empty())
    throw BadInput("no claim of '" + exercise + "' has a statement to prove; there are some of" + proved);
  return asked;
}

/// Whether PARI finds it to hold, in the script's last line.
bool witnessed(const fs::path& script) {
  const Ended ended = run_program({"gp", "-q", "-f", script.string()}, "", std::chrono::minutes(1));
  return ended.ok && ended.output.ends_with("true\n");
}

/// What one statement came to, as printed; whether anything is against it.
bool settle(const Proof& proof, const fs::path& out, bool coq, bool gp) {
  const std::string text = coq_file(proof);
  const fs::path script = out / (name_of(proof) + ".gp");
  write_whole(script, pari_script(proof));
  std::string how = "written";
  bool ok = true;
  if (coq) {
    const Proved proved = oddity::prove(out, name_of(proof), text);
    ok = proved.ok;
    how = proved.ok ? "proved" : "NOT PROVED, " + proved.why;
  } else {
    write_whole(out / (name_of(proof) + ".v"), text);
  }
  if (gp) {
    const bool agrees = witnessed(script);
    ok = ok && agrees;
    how += agrees ? ", PARI agrees" : ", PARI DISAGREES";
  }
  const std::string bound = proof.kind == Proof::Kind::identity ? "" : " by " + proof.bound;
  std::cout << proof.claim << ", " << proof.reading << ": " << to_string(proof.kind) << bound << ": " << how
            << "\n    " << proof.says << std::endl;
  return ok;
}

}  // namespace

int prove(const fs::path& tables, const std::string& exercise, const fs::path& out, bool approve) {
  const std::vector<Proof> asked = proofs_of(exercise);
  const bool coq = is_installed("coqc"), gp = is_installed("gp");
  const fs::path approved = tables / "approved";
  if (approve && !(coq && exercise.empty()))
    throw BadInput(
        "--approve takes all exercises, and coqc: apt install coq libcoq-interval libcoq-coquelicot");
  require_writable_folder(out);
  bool ok = true;
  for (const Proof& proof : asked) ok = settle(proof, out, coq, gp) && ok;
  std::cout << asked.size() << " statements in " << out.string() << "\n";
  if (!coq) std::cout << "Not checked: apt install coq libcoq-interval libcoq-coquelicot\n";
  if (!gp) std::cout << "No second witness: apt install pari-gp\n";
  if (approve && ok) write_whole(approved / "proofs.csv", proofs_csv(asked));
  if (approve || !exercise.empty()) return ok ? 0 : 1;
  for (const std::string& line : differences(asked, read_proofs(approved))) {
    std::cout << line << "\n";
    ok = false;
  }
  return ok ? 0 : 1;
}

}  // namespace oddity::verbs
