#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "extras/mutation/schemata.hpp"

/// The test cases used to try mutants.
namespace oddity::mutation {

/// Outcome of a mutant; not_reached: no test case reaches it.
enum class Fate { killed, survived, not_reached };
std::string_view name_of(Fate);

struct Judgement {
  Fate fate = Fate::not_reached;
  std::string by;  ///< the test case that killed it, and how: "3.5, status 1"
};

/// The tests of a mutated tree: `oddity verify` by exercise, unit tests and tables made again, one at a time,
/// and whether the proofs' files match the approved ones.
class Suite {
 public:
  /// `program` is the mutated tree's. make_reference is next to it, if tables are tried, and
  /// tests/oddity_tests, if it is compiled. Times and coverage of the unmutated run are kept in `kept`, for
  /// mutants up to number `last`. Throws BadInput if a test case fails without a mutant; a unit test that
  /// fails is left out instead.
  Suite(std::filesystem::path program, std::filesystem::path kept, std::size_t last);

  /// Runs every test case for these mutants without a mutant, unless its result is kept.
  void measure(const std::vector<Mutant>&);

  /// Whether the mutant does not exist, as its place was measured only with other types.
  bool is_absent(const Mutant&) const;

  /// Runs the test cases that reach the mutant, which must be measured, the fastest first and the proofs
  /// last, until one notices. Thread-safe.
  Judgement judge(const Mutant&) const;

 private:
  struct TestCase {
    std::string tag;      ///< "3.5", "unit [3.5]", "unit NAME", "table 03_05_swing", "proofs"
    double seconds = 0;   ///< s of CPU time without a mutant
    std::string reached;  ///< one byte per mutant
  };

  TestCase measured(const std::string& tag) const;

  std::filesystem::path program_, kept_;
  std::size_t last_;
  std::vector<std::string> tags_;
  std::vector<TestCase> known_;  ///< the measured ones, the proofs last
};

}  // namespace oddity::mutation
