#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "extras/mutation/schemata.hpp"

/// The test cases that mutants are tried by.
namespace oddity::mutation {

/// What is left of a mutant by the test cases that reach it; not_reached: none does.
enum class Fate { killed, survived, not_reached };
std::string_view name_of(Fate);

struct Judgement {
  Fate fate = Fate::not_reached;
  std::string by;  ///< the test case that killed it, and how: "3.5, status 1"
};

/// The suite of a mutated tree: `oddity verify`, an exercise at a time, unit tests and tables made again, one
/// at a time, and whether the proofs' files are those on record.
class Suite {
 public:
  /// `program` is the mutated tree's, and beside it make_reference, if tables are tried, and
  /// tests/oddity_tests, if it is compiled; what the unmutated run takes and reaches is kept in `kept`, for
  /// mutants up to number `last`. Throws BadInput when a test case is red without a mutant, but for a unit
  /// test, which then judges nothing.
  Suite(std::filesystem::path program, std::filesystem::path kept, std::size_t last);

  /// Runs every test case without a mutant that these may be tried by, unless its file is kept.
  void measure(const std::vector<Mutant>&);

  /// Whether there is no such mutant, as its place has other types alone in those measured.
  bool is_absent(const Mutant&) const;

  /// Runs the test cases that reach the mutant, one of those measured, the fastest first and the proofs last,
  /// until one notices. May be called by several threads.
  Judgement judge(const Mutant&) const;

 private:
  struct TestCase {
    std::string tag;      ///< "3.5", "unit [3.5]", "unit NAME", "table 03_05_swing", "proofs"
    double seconds = 0;   ///< of processor time, without a mutant
    std::string reached;  ///< one byte a mutant
  };

  TestCase measured(const std::string& tag) const;

  std::filesystem::path program_, kept_;
  std::size_t last_;
  std::vector<std::string> tags_;
  std::vector<TestCase> known_;  ///< those measured, the proofs last
};

}  // namespace oddity::mutation
