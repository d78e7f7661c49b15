// oddity_same A.json B.json: lists the differences between two runs' results as CSV, without times. The rows
// are
//   verdict, holds   a claim's verdict, and whether one of its checks holds.
//   expected         outcome of a method's finest trial, or the two of a breakdown.
//   outcome, count   any other trial's outcome and evaluations.
//   letter           a letter of a map.
//   limit            the largest stable step, by more than 5 %.
//   value            any number at all; the last column is the difference.
// The exit code is 1 if a verdict, a check or an expected outcome differs. The others are fragile, and only
// listed. With --bits, every number has to be equal, and any difference is an error.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/results.hpp"
#include "report/study/stability.hpp"

namespace {

using namespace oddity;

class Differences {
 public:
  Differences(const Results& a, const Results& b) {
    same_size("exercises", a.exercises, b.exercises);
    for (std::size_t i = 0; i < a.exercises.size(); ++i) exercise(a.exercises[i], b.exercises[i]);
  }

  std::string rows = "exercise,kind,where,first,second\n";
  std::map<std::string, int> counts;
  long compared = 0;

 private:
  template <class T>
  void same_size(const std::string& what, const std::vector<T>& a, const std::vector<T>& b) const {
    if (a.size() != b.size())
      throw BadInput("the two results do not have the same " + what + (at_.empty() ? "" : " in " + at_) +
                     ": " + std::to_string(a.size()) + " and " + std::to_string(b.size()));
  }

  void text(const std::string& kind, const std::string& where, std::string_view a, std::string_view b) {
    ++compared;
    if (a == b) return;
    ++counts[kind];
    rows += at_ + "," + kind + ",\"" + where + "\"," + std::string(a) + "," + std::string(b) + "\n";
  }
  void number(const std::string& kind, const std::string& where, double a, double b) {
    if (!(std::isnan(a) && std::isnan(b))) text(kind, where, format_shortest(a), format_shortest(b));
  }
  void value(const std::string& where, const Value& a, const Value& b) {
    ++compared;
    const bool same = std::ranges::equal(
        a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
    if (same) return;
    ++counts["value"];
    rows += at_ + ",value,\"" + where + "\",," + format_shortest(distance(a, b)) + "\n";
  }

  void exercise(const ExerciseResult& a, const ExerciseResult& b) {
    at_ = to_string(a.number);
    text("failure", "", a.failure, b.failure);
    same_size("claims", a.claims, b.claims);
    for (std::size_t i = 0; i < a.claims.size(); ++i) claim(a.claims[i], b.claims[i]);
    same_size("quantities", a.quantities, b.quantities);
    for (std::size_t i = 0; i < a.quantities.size(); ++i) quantity(a.quantities[i], b.quantities[i]);
    if (a.stability && b.stability) stability(*a.stability, *b.stability);
  }

  void claim(const JudgedClaim& a, const JudgedClaim& b) {
    text("verdict", a.claim.id, name_of(a.verdict), name_of(b.verdict));
    reading(a.claim.id + " as printed", a.claim.printed, b.claim.printed);
    reading(a.claim.id + " as meant", a.claim.meant, b.claim.meant);
    reading(a.claim.id + " corrected", a.claim.corrected, b.claim.corrected);
    same_size("near misses", a.claim.near_misses, b.claim.near_misses);
    for (std::size_t i = 0; i < a.claim.near_misses.size(); ++i)
      reading(a.claim.id + " near miss " + std::to_string(i + 1), a.claim.near_misses[i],
              b.claim.near_misses[i]);
  }
  void reading(const std::string& where, const Reading& a, const Reading& b) {
    same_size("checks of " + where, a.checks, b.checks);
    for (std::size_t i = 0; i < a.checks.size(); ++i) {
      text("holds", where, a.checks[i].holds() ? "yes" : "no", b.checks[i].holds() ? "yes" : "no");
      value(where + ", left", a.checks[i].left.value, b.checks[i].left.value);
      value(where + ", right", a.checks[i].right.value, b.checks[i].right.value);
    }
  }

  void trial(const std::string& kind, const std::string& where, const TimedTrial& a, const TimedTrial& b) {
    const std::string all =
        where + ", " + a.model + ", " + a.algorithm + ", " + a.resolution + " " + format_shortest(a.setting);
    text(kind, all, name_of(a.outcome), name_of(b.outcome));
    number("count", all, static_cast<double>(a.evaluations), static_cast<double>(b.evaluations));
    value(all, a.value, b.value);
  }
  void quantity(const QuantityResult& a, const QuantityResult& b) {
    same_size("methods of " + a.name, a.methods, b.methods);
    for (std::size_t i = 0; i < a.methods.size(); ++i) {
      const auto &x = a.methods[i].trials, &y = b.methods[i].trials;
      same_size("trials of " + a.name, x, y);
      for (std::size_t k = 0; k < x.size(); ++k)
        trial(k + 1 == x.size() ? "expected" : "outcome", a.name, x[k], y[k]);
    }
    same_size("breakdowns of " + a.name, a.breakdowns, b.breakdowns);
    for (std::size_t i = 0; i < a.breakdowns.size(); ++i) {
      trial("expected", a.name + " breaks", a.breakdowns[i].broken, b.breakdowns[i].broken);
      trial("expected", a.name + " is cured", a.breakdowns[i].cured, b.breakdowns[i].cured);
    }
  }

  void stability(const Stability& a, const Stability& b) {
    same_size("limits", a.limits, b.limits);
    for (std::size_t i = 0; i < a.limits.size(); ++i) {
      const std::string where = a.limits[i].model + ", " + a.limits[i].algorithm;
      const double x = a.limits[i].step(), y = b.limits[i].step();
      if (x != y && !(std::abs(x - y) <= 0.05 * x)) number("limit", where, x, y);
      number("value", where + ", limit", x, y);
    }
    same_size("rows of the map", a.map, b.map);
    for (std::size_t i = 0; i < a.map.size(); ++i) letters_of(a.map[i], b.map[i]);
  }
  void letters_of(const MapRow& a, const MapRow& b) {
    same_size("steps of the map", a.outcomes, b.outcomes);
    for (std::size_t k = 0; k < a.outcomes.size(); ++k)
      text("letter",
           a.model + ", " + a.algorithm + " at " + format_shortest(a.value) + ", letter " +
               std::to_string(k + 1),
           std::string(1, letter_of(a.outcomes[k])), std::string(1, letter_of(b.outcomes[k])));
  }

  std::string at_;
};

}  // namespace

int main(int argc, char** argv) try {
  const bool bits = argc == 4 && argv[1] == std::string("--bits");
  if (argc != 3 && !bits) throw BadInput("two files of results: oddity_same [--bits] FIRST.json SECOND.json");
  Differences found(read_results(argv[argc - 2]), read_results(argv[argc - 1]));
  std::cout << found.rows;
  bool wrong = false;
  std::cerr << found.compared << " compared";
  for (const auto& [kind, count] : found.counts) {
    std::cerr << ", " << count << " differ in " << kind;
    wrong = wrong || bits || kind == "verdict" || kind == "holds" || kind == "expected" || kind == "failure";
  }
  std::cerr << (found.counts.empty() ? ", all the same\n" : "\n");
  return wrong ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << "oddity_same: " << error.what() << "\n";
  return 2;
}
