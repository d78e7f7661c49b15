// A mutated source computes the original expression, or the mutant named by the environment. Also how a
// sample of mutants is judged.

#include <array>
#include <cstdio>
#include <string>

#include "extras/mutation/record.hpp"
#include "report/verify/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::mutation;

namespace {

constexpr const char* program = R"(#include "extras/mutation/mutant.hpp"

#include <cstdio>

namespace m = oddity::mutation;

int main() {
  double sum = 1;
  m::assignment(1, sum, 2.0, ODDITY_ASSIGNMENT(+=), ODDITY_ASSIGNMENT(-=));
  constexpr double compiled = m::operation(3, 1.0, 1.0, ODDITY_OPERATION(+), ODDITY_OPERATION(-));
  const double ratio = m::operation(6, 6.0, 3.0, ODDITY_OPERATION(/), ODDITY_OPERATION(*));
  const double less = m::operation(9, m::constant(12, 4), 3.0, ODDITY_OPERATION(-), ODDITY_OPERATION(+));
  std::printf("%g %g %g ", sum, ratio, less);
  std::printf("%d %d %d ", m::less(13, 2, 2), m::equal(15, 1, 1), (m::chosen(16)) || (1 > 2));
  std::printf("%g %d %g %g", m::negative(17, 5.0, ODDITY_NEGATIVE), m::index(18, 2), m::constant(19, 0.5), compiled);
}
)";

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer{};
  const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe);
  const std::string output(buffer.data(), size);
  return pclose(pipe) == 0 ? output : "failed: " + output;
}

}  // namespace

TEST_CASE(
    "a mutated source computes the original expression or its mutant, and notes the mutants that it reaches",
    "[mutation]") {
  const ScratchFolder scratch;
  const std::string source = scratch.file("schema.cpp", program).string(), compiled = source + ".out";
  REQUIRE(output_of(std::string(ODDITY_COMPILER) + " -std=c++20 -Wall -Wextra -Werror -I " + ODDITY_SOURCE +
                    " -o " + compiled + " " + source) == "");
  const auto with = [&](int mutant) {
    return output_of("ODDITY_MUTANT=" + std::to_string(mutant) + " " + compiled);
  };
  CHECK(with(0) == "3 2 1 0 1 0 -5 2 0.5 2");
  CHECK(with(1) == "-1 2 1 0 1 0 -5 2 0.5 2");  // += to -=
  CHECK(with(2) == "1 2 1 0 1 0 -5 2 0.5 2");   // += left out
  CHECK(with(3) == with(0));                    // computed by the compiler
  CHECK(with(6) == "3 18 1 0 1 0 -5 2 0.5 2");  // / to *
  CHECK(with(7) == "3 6 1 0 1 0 -5 2 0.5 2");   // / to its left
  CHECK(with(8) == "3 3 1 0 1 0 -5 2 0.5 2");   // / to its right
  CHECK(with(9) == "3 2 7 0 1 0 -5 2 0.5 2");   // - to +
  CHECK(with(10) == with(0));                   // its left is a whole number, and its difference is not
  CHECK(with(11) == "3 2 3 0 1 0 -5 2 0.5 2");  // - to its right
  CHECK(with(12) == "3 2 2 0 1 0 -5 2 0.5 2");  // constant 4
  CHECK(with(13) == "3 2 1 1 1 0 -5 2 0.5 2");  // < to <=
  CHECK(with(15) == "3 2 1 0 0 0 -5 2 0.5 2");  // == to !=
  CHECK(with(16) == "3 2 1 0 1 1 -5 2 0.5 2");  // a condition
  CHECK(with(17) == "3 2 1 0 1 0 5 2 0.5 2");   // - left out
  CHECK(with(18) == "3 2 1 0 1 0 -5 1 0.5 2");  // index less 1
  CHECK(with(19) == "3 2 1 0 1 0 -5 2 1 2");    // constant 0.5

  const auto noted = scratch.file("reached", std::string(20, '\0'));
  output_of("ODDITY_MUTANTS_REACHED=" + noted.string() + " " + compiled);
  std::string reached;
  std::ifstream in(noted, std::ios::binary);
  for (char byte = 0; in.get(byte);) reached += ".x-"[static_cast<int>(byte)];
  CHECK(reached == ".xx...xxxx-xxxxxxxxx");
}

TEST_CASE("a sample of mutants is judged by the recorded share", "[mutation]") {
  const Scores on_record{{"a", {.tried = 990, .killed = 980, .first_tried = 1000, .first_killed = 900}}};
  const auto less = [&](const std::string& room, int killed) {
    return noticed_less({{room, {.first_tried = 100, .first_killed = killed}}}, on_record);
  };
  CHECK(less("a", 90).empty());
  CHECK(less("a", 81).empty());  // 90 +- 3.1
  CHECK(less("a", 80) == std::vector<std::string>{"a"});
  CHECK(less("b", 100).empty());  // without a record
  CHECK(less("b", 99) == std::vector<std::string>{"b"});
}

TEST_CASE(
    "when only survivors were tried again, those now killed count, and those that no longer exist do not",
    "[mutation]") {
  const Score before{
      .tried = 100, .killed = 80, .with_reason = 10, .survived = 4, .first_tried = 100, .first_killed = 77};
  const Survivors left{{"1", {"a", "a/x.cpp", "f: +", "the same"}},
                       {"2", {"a", "a/x.cpp", "f: -", ""}},
                       {"3", {"b", "b/x.cpp", "f: -", ""}}};
  Survivors on_record = left;
  on_record["4"] = {"a", "a/x.cpp", "f: *", "the same"};
  on_record["5"] = on_record["6"] = {"a", "a/x.cpp", "f: /", ""};
  const Score after = after_again(before, "a", on_record, left, {"4", "5"});
  CHECK(after.tried == 99);
  CHECK(after.with_reason == 10);  // one that had no reason has one now
  CHECK(after.survived == 1);
  CHECK(after.killed == 82);
  CHECK(after.first_tried == 100);
  CHECK(after.first_killed == 77);
}
