#include "report/cli/prove.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/proofs.hpp"
#include "reference/text.hpp"
#include "report/study/progress.hpp"
#include "report/study/prove.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/table_text.hpp"

namespace oddity::verbs {

namespace {

std::string exercise_of(const Provable& p) { return p.claim.substr(0, p.claim.find('-')); }

Provables provables_of(const std::vector<Task>& tasks, bool all) {
  Provables of_these = provables();
  if (all) return of_these;
  std::string known;
  for (const Provable& p : of_these)
    if (known.find(" " + exercise_of(p) + ",") == std::string::npos) known += " " + exercise_of(p) + ",";
  for (const Task& task : tasks)
    if (const std::string number = to_string(task.entry->number);
        std::ranges::none_of(of_these, [&](const Provable& p) { return exercise_of(p) == number; }))
      throw BadInput("exercise " + number +
                     " has no proofs; exercises with proofs:" + known.substr(0, known.size() - 1));
  std::erase_if(of_these, [&](const Provable& p) {
    return std::ranges::none_of(tasks,
                                [&](const Task& t) { return to_string(t.entry->number) == exercise_of(p); });
  });
  return of_these;
}

/// Writes proofs.csv: with these proofs only if `all`, otherwise with these in place of older ones.
void approve(const Provables& these, bool all, const fs::path& folder) {
  ProvedClaims record;
  if (!all && fs::exists(folder / "proofs.csv")) record = read_proofs(folder);
  for (const Provable& p : these) record[p.claim] = {proof_hash(coq_file(p)), p.says, p.margin};
  write_whole(folder / "proofs.csv", proofs_csv(record));
  std::cerr << "approved: " << (folder / "proofs.csv").string() << "\n";
}

Table table_of(const Provables& these, const std::vector<Checked>& checked) {
  Table table{{"claim", "proved", "margin", "outcome", "seconds", "message"}, {}};
  for (std::size_t i = 0; i < these.size(); ++i)
    table.rows.push_back({these[i].claim, these[i].says, these[i].margin,
                          std::string(checked[i].kept     ? "proved before"
                                      : checked[i].proved ? "proved"
                                                          : "NOT PROVED"),
                          checked[i].seconds, checked[i].message});
  return table;
}

std::string text_of(const Provables& these, const std::vector<Checked>& checked) {
  std::vector<std::vector<std::string>> rows{{"claim", "what is proved", "outcome"}};
  std::string failures;
  long proved = 0;
  for (std::size_t i = 0; i < these.size(); ++i) {
    const Checked& c = checked[i];
    proved += c.proved;
    rows.push_back({c.claim, these[i].says, c.kept ? "proved before" : c.proved ? "proved" : "NOT PROVED"});
    if (!c.proved) failures += "\n" + c.claim + ": " + c.message + "\n";
  }
  return aligned(rows, screen_of(STDOUT_FILENO), {.shorten = {"what is proved"}}) + failures + "\n" +
         std::to_string(proved) + " of " + std::to_string(these.size()) + " proved\n";
}

}  // namespace

int prove(const fs::path& folder, const AskedProofs& asked, Format format) {
  const bool all = asked.exercises.empty();
  const Provables these = provables_of(tasks_of(asked.exercises), all);
  if (needs_are_all({{"coq", "libcoq-interval", "libcoq-coquelicot"}})) return 0;
  take_to_write(asked.out, asked.overwrite);
  write_proofs(these, asked.out);
  if (!coq_is_there())
    throw BadInput(std::to_string(these.size()) + " files are written to " + asked.out.string() +
                   ", and not checked: Coq or one of its libraries is missing; '" +
                   (own_tree().empty() ? "apt-get install" : "./oddity packages") +
                   " coq libcoq-interval libcoq-coquelicot' installs them");
  const auto checked =
      with_progress([&](const Progress& progress) { return oddity::prove(these, asked.out, progress); });
  std::cout << (format == Format::json  ? to_json(table_of(these, checked))
                : format == Format::csv ? to_csv(table_of(these, checked))
                                        : text_of(these, checked));
  if (!std::ranges::all_of(checked, &Checked::proved)) return 1;
  if (asked.approve) approve(these, all, folder / "approved");
  return 0;
}

}  // namespace oddity::verbs
