#include "report/pages/trust.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/pages/markdown.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/evidence_pages.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/sample_results.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

const std::filesystem::path tables = std::filesystem::path(ODDITY_SOURCE) / "reference";
constexpr const char* one_proof = "claim,hash,proved,margin\n9.9-y,0,\"it is two\",1\n";
constexpr const char* header = "claims,stated,standing,why\n";

/// The folder of the reference tables, with other records of the long tests.
struct WithRecords : ScratchFolder {
  WithRecords(std::initializer_list<std::pair<std::string, std::string>> records) {
    for (const auto& entry : std::filesystem::directory_iterator(tables))
      if (entry.is_directory() && entry.path().filename() != "trust")
        create_directory_symlink(entry.path(), path() / entry.path().filename());
    for (const auto& [name, text] : records) file("trust/" + name, text);
  }
};

Trust trust_with(const WithRecords& folder) {
  const ScratchFolder reference;
  reference.file("proofs.csv", one_proof);
  reference.file("unproved.csv",
                 std::string(header) + "9.9,numbers,provable,so\nall,words,wording,as said\n");
  Trust trust = read_trust(folder.path());
  trust.standings = Standings(reference.path());
  return trust;
}

}  // namespace

TEST_CASE("every claim is proved, or has a recorded reason why not", "[trust]") {
  const Standings standings(tables / "approved");
  const Reference truth(tables);
  std::set<std::string> asked;
  for (const Entry& entry : registry()) {
    if (!of_the_book(entry.number)) continue;
    for (const Claim& claim : entry.exercise.study(Parameters(entry.exercise.parameters), truth).claims) {
      const Basis basis = standings.of(claim);
      INFO(claim.id << ": give it a row in reference/approved/unproved.csv, or give one to all "
                    << stated_in(claim) << " of " << to_string(entry.number));
      CHECK(basis.standing != Standing::unclassed);
      asked.insert(basis.row);
    }
  }
  for (const auto& [row, basis] : standings.rows()) {
    INFO("no claim needs the row '" << row << "' of reference/approved/unproved.csv: take it out");
    CHECK(asked.contains(row));
  }
}

TEST_CASE("a broken row of unproved.csv is named", "[trust]") {
  const auto said = [](const std::string& rows) {
    const ScratchFolder folder;
    folder.file("proofs.csv", one_proof);
    const std::string file = folder.file("unproved.csv", header + rows).string();
    const std::string all = complaint([&] { Standings{folder.path()}; });
    return all.starts_with(file) ? all.substr(file.size()) : all;
  };
  CHECK(said("1.1,cases,guessed,so\n") == ":2: 'guessed' is not one of provable, computed and wording");
  CHECK(said("1.1,signs,computed,so\n") == ":2: 'signs' is not one of formulas, numbers, cases and words");
  CHECK(said("1.1,cases,computed,so\n1.1,cases,provable,so\n") == ":3: a second row of 1.1 cases");
}

TEST_CASE("trust counts the records, and lists missing ones", "[trust]") {
  const Trust trust = trust_with(WithRecords{
      {"mutation.csv",
       "date,commit,room,mutants,tried,killed,with_reason,survived,first_tried,first_killed\n"
       "2026-01-02,abc,chapters,30,20,17,2,1,21,15\n2026-01-03,def,solvers,10,10,9,0,1,10,8\n"},
      {"fuzz.csv", "date,commit,target,inputs,seconds,crashes\n2026-01-02,abc,plan,1000,2.5,1\n"}});
  const std::string text = to_csv(trust_table(sample(), trust));
  const auto has = [&](const std::string& row) {
    INFO(row << " in\n" << text);
    CHECK(text.find("\n" + row + ",") != std::string::npos);
  };
  long judged = 0, assertions = 0;
  for (const Entry& entry : registry())
    for (const Assertion& one : read_ledger(tables, to_string(entry.number)))
      ++assertions, judged += !one.claims.empty();
  has("judged,assertions of the solutions," + std::to_string(judged) + "," + std::to_string(assertions) +
      ",each of the others has its reason");
  has("proved,claims,1,3,1 printed value is proved wrong");
  has("provable,so,1,3");
  has("wording,as said,1,3");
  has("witnessed,errata,0,1");  // the book's errata are not these results
  has("killed,mutants tried,26,30,23 of 31 as first drawn,2026-01-03");
  has("killed,chapters,17,20,\"2 survived with a reason, 1 without; as first drawn 15 of 21 killed; 30 in all\"");
  has("fuzzed,plan,999,1000,in 2.5 s,2026-01-02,abc");
  has("survived,faults,0,0,not on record");
  CHECK(
      trust_page(sample(), trust)
          .find(
              "- **killed**: 26 of 30 mutants tried, 23 of 31 as first drawn (2026-01-03, several commits): chapters 17; solvers 9. *By") !=
      std::string::npos);
}

TEST_CASE("a record without a column is named", "[trust]") {
  const WithRecords folder{{"faults.csv", "date,commit,verb,fault,trials\n2026-01-02,abc,solve,killed,10\n"}};
  CHECK(complaint([&] { read_trust(folder.path()); }).ends_with("faults.csv:1: there is no column failures"));
}

TEST_CASE("proofs are mentioned in the report and on the site", "[trust]") {
  const ProvedClaims proved{{"9.9-x", {"0", "it is one"}}, {"9.9-y", {"0", "it is two", 1}}};
  const Results results = sample();
  const std::string page = exercise_page_text(results, results.exercises[0], proved);
  CHECK(page.find("`9.9-y`** (line 2, proved)") != std::string::npos);
  CHECK(page.find("1 confirmed claim, 1 proved (†)") != std::string::npos);
  CHECK(exercise_page_text(results, results.exercises[0]).find("Coq") == std::string::npos);
  CHECK(claims_section(results.exercises[0], proved).find("<small>line 1, proved</small>") !=
        std::string::npos);
}

TEST_CASE("the site's page of trust explains each of its words", "[trust]") {
  const std::string page =
      trust_html(sample(), read_trust(std::filesystem::path(ODDITY_SOURCE) / "reference"));
  for (const char* part :
       {"judged", "enclosed", "agreed", "as typeset", "witnessed", "killed", "fuzzed", "survived"}) {
    INFO(part);
    CHECK(page.find("<th scope=\"row\">" + std::string(part) + "</th>") != std::string::npos);
  }
  CHECK(page.find("<td></td><td>Coq") == std::string::npos);  // a row without an explanation
  for (auto at = page.find("<tr><th scope=\"row\">"); at != std::string::npos;
       at = page.find("<tr><th scope=\"row\">", at + 1))
    CHECK(page.substr(at, page.find("</tr>", at) - at).find("<td></td><td>") == std::string::npos);
}
