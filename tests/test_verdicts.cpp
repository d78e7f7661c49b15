#include "reference/verdicts.hpp"

#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

TEST_CASE("verdicts are read by claim", "[reference]") {
  const ScratchFolder folder;
  folder.file("verdicts.csv", "claim,verdict\n1.1-a,confirmed\n1.1-b,wrong\n");
  const Verdicts verdicts = read_verdicts(folder.path());
  CHECK(verdicts.size() == 2);
  CHECK(verdicts.at("1.1-b") == "wrong");
}

TEST_CASE("broken verdicts are reported with file, line and a suggestion", "[reference]") {
  const auto said = [](const std::string& text) {
    const ScratchFolder folder;
    const std::string file = folder.file("verdicts.csv", text).string();
    const std::string all = complaint([&] { read_verdicts(folder.path()); });
    return all.starts_with(file) ? all.substr(file.size()) : all;
  };
  CHECK(said("claim,verdict\n1.1-a,true\n") ==
        ":2: 'true' is no verdict; it is one of confirmed, misprint, lost in our copy, "
        "incomplete, wrong, not checkable, unsettled");
  CHECK(said("claim,verdict\n1.1-a,confirmed\n# again\n1.1-a,wrong\n") == ":4: a second verdict for 1.1-a");
  CHECK(said("claim,verdict\n1.1-a\n") == ":2: 1 cells where the header has 2");
  CHECK(said("claim,verdict,why\n1.1-a,confirmed,so\n") == ":2: the columns are claim,verdict");
  CHECK(said("claim,verdict\n") == ": the table has no rows");
  const ScratchFolder empty;
  CHECK(complaint([&] { read_verdicts(empty.path()); }).find("verdicts.csv") != std::string::npos);
}
