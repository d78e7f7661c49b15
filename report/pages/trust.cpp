#include "report/pages/trust.hpp"

#include <algorithm>
#include <map>

#include "chapters/typeset.hpp"
#include "reference/text.hpp"
#include "report/study/findings.hpp"
#include "report/study/prove.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

/// A count out of a total.
struct Share {
  std::string subject;
  long count = 0, of = 0;
  std::string says = {};
  std::string date = {}, commit = {};
};

struct Part {
  std::string name;
  Share all;
  std::string rests_on;
  std::vector<Share> shares = {};
};
using Parts = std::vector<Part>;

const std::string not_on_record = "not on record";

// ---- claims -----------------------------------------------------------------------------------------------

std::string axioms() {
  std::string text;
  for (const std::string_view axiom : known_axioms())
    text += (text.empty() ? "" : ", ") + std::string(axiom) + (axiom.ends_with('.') ? "*" : "");
  return text;
}

std::string rests_on(Standing standing) {
  switch (standing) {
    case Standing::proved:
      return "Coq's kernel and these axioms: " + axioms();
    case Standing::provable:
    case Standing::computed:
      return "two routes and near misses over samples";
    case Standing::wording:
      return "reading";
    case Standing::unclassed:
      return "nothing: approved/unproved.csv needs a row";
  }
  return "";
}

std::string printed_off(const Results& results, const ProvedClaims& proved) {
  long off = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (const auto found = proved.find(c.claim.id); found != proved.end()) off += found->second.margin > 0;
  return off == 0 ? "" : counted(off, "printed value is", "printed values are") + " proved wrong";
}

/// Claims counted by standing, and by the reason why they are not proved.
Parts claims_by_standing(const Results& results, const Standings& standings) {
  std::map<Standing, std::map<std::string, long>> whys;
  long all = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims) {
      const Basis basis = standings.of(c.claim);
      ++whys[basis.standing][basis.why];
      ++all;
    }
  Parts parts;
  for (const auto& [standing, counts] : whys) {
    Part part{std::string(name_of(standing)), {"claims", 0, all}, rests_on(standing)};
    for (const auto& [why, count] : counts) {
      part.all.count += count;
      if (standing != Standing::proved) part.shares.push_back({why, count, all});
    }
    std::ranges::stable_sort(part.shares, std::ranges::greater(), &Share::count);
    if (standing == Standing::proved) part.all.says = printed_off(results, standings.proved());
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Formulas of the readings, and how many of them the reader of TeX has confirmed.
Part formulas_as_typeset(const Results& results) {
  long formulas = 0, read = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      for_each_reading(c.claim, [&](const std::string& name, const Reading& reading) {
        if (name == "in view") return;
        formulas += is_formula(reading.text);
        read += reading.as_typeset;
      });
  return {"as typeset", {"formulas of claims", read, formulas}, "a reader of TeX, at samples"};
}

/// Assertions of the solutions, and how many of them claims judge.
Part assertions_judged(const std::vector<Assertion>& assertions) {
  const auto judged = std::ranges::count_if(assertions, [](const Assertion& a) { return !a.claims.empty(); });
  return {
      "judged",
      {"assertions of the solutions", judged, std::ssize(assertions), "each of the others has its reason"},
      "the ledgers of assertions, line by line"};
}

// ---- records ----------------------------------------------------------------------------------------------

Parts values_by_bound(const Bounds& bounds) {
  const auto all = static_cast<long>(bounds.values), enclosed = static_cast<long>(bounds.enclosed);
  Part agreed{"agreed", {"values of the tables", all - enclosed, all}, "two routes in 60 digits that agree"};
  for (const std::string& table : bounds.agreed)
    agreed.all.says += (agreed.all.says.empty() ? "" : ", ") + table;
  return {{"enclosed",
           {"values of the tables", enclosed, all,
            enclosed == 0 ? "" : "within " + format_significant(bounds.widest, 1) + " of the row's largest"},
           "Arb's ball arithmetic, and Picard's operator for motions"},
          std::move(agreed)};
}

Part errata_witnessed(const Results& results, const Witnessed& w) {
  long errata = 0, at_its_letters = 0, at_others = 0, words = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim* claim : errata_of(e)) {
      const std::string& id = claim->claim.id;
      ++errata;
      at_its_letters += w.at_its_letters.contains(id);
      at_others += w.at_others.contains(id);
      words += w.words.contains(id);
    }
  return {"witnessed",
          {"errata", at_its_letters + at_others, errata,
           words == 0 ? "" : "of " + std::to_string(words) + " there is nothing to compute"},
          "PARI/GP's own scripts",
          {{"at the suite's letters, to ten digits", at_its_letters, errata},
           {"at other letters", at_others, errata}}};
}

/// Adds up the shares of a record.
Part recorded(std::string name, const std::string& subject, std::string rests_on, std::vector<Share> shares) {
  Part part{std::move(name), {subject}, std::move(rests_on), std::move(shares)};
  for (const Share& s : part.shares) part.all.count += s.count, part.all.of += s.of;
  if (part.shares.empty()) part.all.says = not_on_record;
  for (const Share& s : part.shares) {
    const bool first = &s == &part.shares.front();
    part.all.date = std::max(part.all.date, s.date);
    part.all.commit = first || part.all.commit == s.commit ? s.commit : "several commits";
  }
  return part;
}

Part mutants_killed(const std::vector<Mutated>& record) {
  std::vector<Share> shares;
  for (const Mutated& m : record)
    shares.push_back({m.subject, m.killed, m.tried,
                      std::to_string(m.with_reason) + " survived with a reason, " +
                          std::to_string(m.survived) + " without; as first drawn " +
                          std::to_string(m.first_killed) + " of " + std::to_string(m.first_tried) +
                          " killed; " + std::to_string(m.mutants) + " in all",
                      m.date, m.commit});
  Part part = recorded("killed", "mutants tried", "libclang and the suite", shares);
  if (record.empty()) return part;
  long tried = 0, killed = 0;
  for (const Mutated& m : record) tried += m.first_tried, killed += m.first_killed;
  part.all.says = std::to_string(killed) + " of " + std::to_string(tried) + " as first drawn";
  return part;
}

Part inputs_survived(const std::vector<Fuzzed>& record) {
  std::vector<Share> shares;
  for (const Fuzzed& f : record)
    shares.push_back({f.subject, f.inputs - f.crashes, f.inputs,
                      "in " + format_significant(f.seconds, 3) + " s", f.date, f.commit});
  return recorded("fuzzed", "inputs read without a crash", "libFuzzer and sanitizers, and links by our own",
                  shares);
}

Part faults_survived(const std::vector<Faulted>& record) {
  std::vector<Share> shares;
  for (const Faulted& f : record)
    shares.push_back({f.subject + ", " + f.fault, f.trials - f.failures, f.trials, "", f.date, f.commit});
  return recorded("survived", "faults", "files, exit codes and messages", shares);
}

Parts parts_of(const Results& results, const Trust& trust) {
  Parts parts{assertions_judged(trust.assertions)};
  for (Part& part : claims_by_standing(results, trust.standings)) parts.push_back(std::move(part));
  for (Part& part : values_by_bound(trust.bounds)) parts.push_back(std::move(part));
  parts.push_back(formulas_as_typeset(results));
  parts.push_back(errata_witnessed(results, trust.witnessed));
  parts.push_back(mutants_killed(trust.mutated));
  parts.push_back(inputs_survived(trust.fuzzed));
  parts.push_back(faults_survived(trust.faulted));
  return parts;
}

// ---- views ------------------------------------------------------------------------------------------------

std::string amount(const Share& s) {
  return s.says == not_on_record ? "" : std::to_string(s.count) + " of " + std::to_string(s.of);
}

std::string when(const Share& s) {
  const bool one = s.commit.find(' ') == std::string::npos;
  return s.date.empty() ? "" : s.date + ", " + (one ? s.commit.substr(0, 7) : s.commit);
}

/// ": derivatives 200; limits 11; others 3".
std::string largest(const std::vector<Share>& shares) {
  constexpr std::size_t most = 2;
  if (shares.size() < 2) return "";
  std::string text;
  long others = 0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (i < most)
      text +=
          (i == 0 ? ": " : "; ") + escaped(shares[i].subject, false) + " " + std::to_string(shares[i].count);
    else
      others += shares[i].count;
  return text + (others > 0 ? "; others " + std::to_string(others) : "");
}

std::string in_a_line(const Part& part) {
  std::string text = "- **" + part.name + "**: " + amount(part.all) + (amount(part.all).empty() ? "" : " ") +
                     escaped(part.all.subject, false);
  if (!part.all.says.empty()) text += ", " + escaped(part.all.says, false);
  if (!part.all.date.empty()) text += " (" + when(part.all) + ")";
  return text + largest(part.shares) + ". *By " + escaped(part.rests_on, false) + ".*\n";
}

std::vector<Cell> cells(const Part& part, const Share& s) {
  return {part.name, s.subject, s.count, s.of, s.says, s.date, s.commit, part.rests_on};
}

}  // namespace

std::string trust_text(const Results& results, const Trust& trust, const Screen& screen) {
  std::vector<std::vector<std::string>> rows{{"", "how many", "", "", "on record"}};
  std::string rests;
  for (const Part& part : parts_of(results, trust)) {
    rows.push_back({part.name, amount(part.all), part.all.subject, part.all.says, when(part.all)});
    rests += wrapped("  " + part.name + ": " + part.rests_on + "\n", screen, 4);
  }
  return aligned(rows, screen, {.shorten = {""}}) + "\nBasis of each:\n" + rests;
}

Table trust_table(const Results& results, const Trust& trust) {
  Table table{{"part", "subject", "count", "of", "says", "date", "commit", "rests_on"}, {}};
  for (const Part& part : parts_of(results, trust)) {
    table.rows.push_back(cells(part, part.all));
    for (const Share& share : part.shares) table.rows.push_back(cells(part, share));
  }
  return table;
}

std::string trust_page(const Results& results, const Trust& trust) {
  const Parts parts = parts_of(results, trust);
  std::string text = "# The basis of the results\n\n`oddity trust --csv` has all figures.";
  if (std::ranges::find(parts, name_of(Standing::provable), &Part::name) != parts.end())
    text += " *Provable*: nobody has written the proof yet.";
  text += "\n\n";
  for (const Part& part : parts) text += in_a_line(part);
  return text + "\n[All exercises](README.md)\n";
}

}  // namespace oddity
