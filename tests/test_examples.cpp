#include "report/cli/examples.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"

using namespace oddity;
using namespace program;

TEST_CASE("the help's examples are each listed once, and every mark belongs to one", "[commands]") {
  const Ran examples = run("--examples");
  CHECK(examples.status == 0);
  CHECK(examples.output.starts_with("-\toddity list\n"));
  CHECK(says(examples, "\n-\toddity choose 3.5 a=60deg --error 1deg --budget 5us\n"));
  CHECK(says(examples, "\n-\toddity help choose\n"));
  for (const Mark& mark : marks_of_examples())
    CHECK(says(examples, std::string(mark.says) + "\t" + std::string(mark.example) + "\n"));
  const std::string shown = "oddity sweep run /tmp/map\n";
  CHECK(examples.output.find("\t" + shown) == examples.output.rfind("\t" + shown));
  for (const std::string verb : {"solve", "verify", "new", "sweep run"}) {
    const std::string help = run(verb + " --help").output;
    std::size_t at = help.find("Examples:\n");
    REQUIRE(at != std::string::npos);
    for (at = help.find("\n  oddity ", at); at != std::string::npos; at = help.find("\n  oddity ", at + 1))
      CHECK(says(examples, help.substr(at + 3, help.find('\n', at + 3) - at - 3)));
  }
}
