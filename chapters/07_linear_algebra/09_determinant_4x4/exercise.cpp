// Exercise 7.9: the determinant of a 4 x 4 matrix as a sum over permutations, and the table of its 24 terms:
//   det A = sum_s e_s a_s(1)1 a_s(2)2 a_s(3)3 a_s(4)4, e_s = +1 for an even permutation s, -1 for an odd one.
// Every row of the table is judged by the determinant of whole numbers put at its four places, zero
// elsewhere, by fraction-free elimination, which knows nothing of permutations. All of that is exact.

#include <algorithm>
#include <set>

#include "chapters/07_linear_algebra/09_determinant_4x4/determinants.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex07_09 {

using namespace determinants;

constexpr Parameter parameters[] = {
    {"s", 0, "", "shift of the Hilbert matrix 1/(i+j-1+s)", 0, 20},
    {"m", 300, "", "largest entry of the triangular factors of the matrix of determinant one", 1, 300,
     whole_number},
    {"seed", 1, "", "seed of the random matrices", 0, 1e9, whole_number},
};

struct Row {
  int line;
  std::string_view permutation, term;
};

// clang-format off
constexpr Row table[] = {
    {3939, "1234", "+ a11 a22 a33 a44"}, {3941, "3124", "+ a31 a12 a23 a44"},
    {3943, "2314", "+ a21 a32 a13 a44"}, {3945, "1324", "- a11 a32 a23 a44"},
    {3945, "3214", "- a31 a22 a13 a44"}, {3945, "2134", "- a21 a12 a33 a44"},
    {3945, "1243", "- a11 a22 a43 a34"}, {3945, "3142", "- a31 a12 a43 a24"},
    {3945, "2341", "- a21 a32 a43 a14"}, {3945, "1342", "+ a11 a32 a43 a24"},
    {3947, "3241", "+ a31 a22 a43 a14"}, {3949, "2143", "+ a21 a12 a43 a34"},
    {3953, "1423", "+ a11 a42 a23 a34"}, {3955, "3412", "+ a31 a42 a13 a24"},
    {3957, "2431", "+ a21 a42 a33 a14"}, {3959, "1432", "- a11 a42 a33 a24"},
    {3959, "3421", "- a31 a42 a23 a14"}, {3959, "2413", "- a21 a42 a13 a34"},
    {3959, "4123", "- a41 a12 a23 a34"}, {3959, "4312", "- a41 a32 a13 a24"},
    {3959, "4231", "- a41 a22 a33 a14"}, {3959, "4132", "+ a41 a12 a33 a24"},
    {3961, "4321", "+ a41 a32 a23 a14"}, {3963, "4213", "+ a41 a22 a13 a34"},
};
// clang-format on

/// A term as printed: its sign and the places (row, column) of its entries, from zero.
struct Term {
  bool negative;
  std::array<std::size_t, 4> rows, columns;
};

std::size_t digit(char c) { return static_cast<std::size_t>(c - '1'); }

Term parsed(std::string_view text) {
  Term term{text[0] == '-', {}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    term.rows[k] = digit(text[4 * k + 3]);
    term.columns[k] = digit(text[4 * k + 4]);
  }
  return term;
}

std::vector<Term> printed_terms() {
  std::vector<Term> terms;
  for (const Row& row : table) terms.push_back(parsed(row.term));
  return terms;
}

template <class T>
T term_of(const Term& t, const Matrix4<T>& m) {
  return m[t.rows[0]][t.columns[0]] * m[t.rows[1]][t.columns[1]] * m[t.rows[2]][t.columns[2]] *
         m[t.rows[3]][t.columns[3]];
}

/// The printed sum.
template <class T>
T by_terms(const std::vector<Term>& terms, const Matrix4<T>& m) {
  T sum = term_of(terms[0], m);
  for (std::size_t i = 1; i < terms.size(); ++i)
    sum = terms[i].negative ? sum - term_of(terms[i], m) : sum + term_of(terms[i], m);
  return sum;
}

// ---- the claims -------------------------------------------------------------------------------------------

/// The printed row and column numbers against those that the permutation asks for.
Check places(const Row& row) {
  const Term term = parsed(row.term);
  std::vector<double> printed, asked;
  for (std::size_t k = 0; k < 4; ++k) {
    printed.insert(printed.end(),
                   {static_cast<double>(term.rows[k] + 1), static_cast<double>(term.columns[k] + 1)});
    asked.insert(asked.end(),
                 {static_cast<double>(digit(row.permutation[k]) + 1), static_cast<double>(k + 1)});
  }
  return {"row and column numbers", {"as printed", printed}, {"s(1) 1, ..., s(4) 4", asked}, exact()};
}

/// The signed product against the determinant of the matrix with nothing but its four factors.
Check sign(const Term& term, Random random) {
  Worst worst("the determinant without the other entries", "sign and product as printed",
              "fraction-free elimination");
  for (int sample = 0; sample < 8; ++sample) {
    Matrix4<Whole> m{};
    for (std::size_t k = 0; k < 4; ++k) m[term.rows[k]][term.columns[k]] = 1 + random.below(99);
    const Whole product = term_of(term, m);
    worst.see(number(term.negative ? -product : product), number(by_bareiss(m)), exact(), number(product),
              "");
  }
  return worst.check();
}

Claim row_claim(const Row& row, const Random& random) {
  const std::string name(row.permutation);
  Claim claim{"7.9-term_" + name, row.line, "permutation " + name + " has the term " + std::string(row.term)};
  Term term = parsed(row.term);
  claim.printed = {std::string(row.term), {places(row), sign(term, random)}};
  term.negative = !term.negative;
  claim.near_misses = {{"with the other sign", {sign(term, random)}}};
  return claim;
}

/// A sum of whole numbers against the determinant, over random matrices, a tenth of them singular.
Check sums(const std::string& by, Random random, const auto& sum) {
  Worst worst(by + ", against fraction-free elimination", by, "fraction-free elimination");
  for (int sample = 0; sample < 500; ++sample) {
    auto m = random_matrix(random, 999);
    if (sample % 10 == 9) m[3] = m[static_cast<std::size_t>(random.below(3))];
    worst.see(number(sum(m)), number(by_bareiss(m)), exact(), 1e12, "");
  }
  return worst.check();
}

/// The sum over all permutations, with or without their signs, their order found by counting inversions.
auto over_permutations(bool with_signs) {
  return [=](const Matrix4<Whole>& m) {
    std::array<std::size_t, 4> s{0, 1, 2, 3};
    Whole sum = 0;
    do {
      int inversions = 0;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) inversions += s[i] > s[j];
      const Whole product = m[s[0]][0] * m[s[1]][1] * m[s[2]][2] * m[s[3]][3];
      sum += with_signs && inversions % 2 == 1 ? -product : product;
    } while (std::next_permutation(s.begin(), s.end()));
    return sum;
  };
}

/// Of the 4^4 maps of {1, 2, 3, 4} into itself, those that reach every number.
double onto_maps() {
  int count = 0;
  for (int code = 0; code < 256; ++code)
    count += std::set<int>{code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6}.size() == 4;
  return count;
}

std::vector<Claim> claims(const Random& random) {
  std::vector<Term> terms = printed_terms();
  const auto table_sum = [](std::vector<Term> all) {
    return [all = std::move(all)](const Matrix4<Whole>& m) { return by_terms(all, m); };
  };

  Claim formula{"7.9-formula", 3933, "the determinant is a sum over the permutations of signed products"};
  formula.printed = {"det A = ... = e_s a_s(1)1 ..., a product alone",
                     {sums("a11 a22 a33 a44", random, [&](const auto& m) { return term_of(terms[0], m); })}};
  formula.meant = {"det A = sum of e_s a_s(1)1 ...",
                   {sums("sum over the permutations", random, over_permutations(true))}};
  formula.near_misses = {{"all signs plus", {sums("sum without signs", random, over_permutations(false))}}};
  formula.why =
      "An equals sign stands between the summation sign and the product that it sums. A "
      "product alone is one of 24 terms: 1 for a matrix of ones, whose determinant is 0.";

  Claim permutations{"7.9-permutations", 3935, "there are 4! = 24 permutations"};
  const auto number_of = [](double n) {
    return Check{
        "permutations", {"as printed", n}, {"maps of {1, 2, 3, 4} onto itself", onto_maps()}, exact()};
  };
  permutations.printed = {"24", {number_of(24)}};
  permutations.near_misses = {{"23, the identity not counted", {number_of(23)}}};

  Claim four{"7.9-four_entries", 3935, "each term has four entries, one of every row and column"};
  const auto incomplete = [](int entries) {
    long violations = 0;
    for (const Row& row : table) {
      const Term t = parsed(row.term);
      violations += std::ranges::count(row.term, 'a') != entries ||
                    std::set(t.rows.begin(), t.rows.end()).size() != 4 ||
                    std::set(t.columns.begin(), t.columns.end()).size() != 4;
    }
    return never("terms without that many entries, or with two of one row or column", violations, 24);
  };
  four.printed = {"four", {incomplete(4)}};
  four.near_misses = {{"three", {incomplete(3)}}};

  Claim all{"7.9-table", 3935, "the table shows the 24 terms and signs"};
  std::set<std::string_view> different;
  for (const Row& row : table) different.insert(row.permutation);
  all.printed = {"24 different permutations, and the sum of the terms is the determinant",
                 {{"different permutations",
                   {"in the table", static_cast<double>(different.size())},
                   {"maps of {1, 2, 3, 4} onto itself", onto_maps()},
                   exact()},
                  sums("the 24 terms as printed", random, table_sum(terms))}};
  terms.back().negative = !terms.back().negative;
  all.near_misses.push_back(
      {"the last sign flipped", {sums("the last sign flipped", random, table_sum(terms))}});
  terms.pop_back();
  all.near_misses.push_back(
      {"the last term dropped", {sums("the last term dropped", random, table_sum(terms))}});

  std::vector<Claim> claims{formula, permutations, four, all};
  for (const Row& row : table) claims.push_back(row_claim(row, random));
  return claims;
}

// ---- the methods ------------------------------------------------------------------------------------------

auto printed_sum() {
  return [terms = printed_terms()](const auto& m) { return by_terms(terms, m); };
}

Quantity hilbert(std::string name, double s, const Reference& truth) {
  Matrix4<double> m;
  std::vector<double> entries;
  for (int i = 1; i <= 4; ++i)
    for (int j = 1; j <= 4; ++j) {
      entries.push_back(1 / (i + j - 1 + s));
      m[static_cast<std::size_t>(i - 1)][static_cast<std::size_t>(j - 1)] = entries.back();
    }
  const Known known = truth("07_09_determinant", entries);
  Quantity q =
      quantity(std::move(name), "",
               "determinant of the Hilbert matrix 1/(i+j-1+" + shortest(s) + "), its entries rounded", known,
               {1e-9 * std::abs(known.value[0]), "nine significant digits"});
  add_methods(q, m, printed_sum(), Outcome::ok, "");
  return q;
}

Quantity determinant_one(int size, Random random) {
  const Matrix4<Whole> first = triangular(random, size, false), second = triangular(random, size, true);
  const Matrix4<Whole> m = product(product(first, second), triangular(random, size, false));
  Quantity q{"determinant_one",
             "",
             "determinant of a matrix of large whole numbers",
             {"1: the product of triangular matrices with ones on their diagonals", 1.0},
             0,
             {1e-9, "nine significant digits"},
             {},
             {}};
  add_methods(q, cast<double>(m, number), printed_sum(), Outcome::diverged,
              "the last pivot is rounding error: the condition is far above 1/eps");
  const auto counted = cast<Counted<Whole>>(m, [](Whole x) { return x; });
  const long work = operations_of([&] { return printed_sum()(counted); }).all_but_additions();
  q.add({"exact", "24 terms, whole numbers of 128 bits", no_knob(), [m, work, sum = printed_sum()](double) {
           return Answer{number(sum(m)), work};
         }});
  const std::string says =
      "The terms are up to 10^23 and cancel to 1; in doubles what is left is their rounding. In whole "
      "numbers nothing is lost, and twice the digits are enough too.";
  q.add(Breakdown{says, "expansion, 24 terms", 53, Outcome::diverged,
                  "exact, 24 terms, whole numbers of 128 bits", 0});
  q.add(Breakdown{says, "elimination, LU, rows exchanged", 0, Outcome::diverged, "expansion, 2 x 2 minors",
                  106});
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  Quantity shifted = hilbert("hilbert_shifted", 8, truth);
  shifted.add(
      Breakdown{"The 24 terms are up to 5e-5 and cancel to 9e-16; every expansion loses digits with them. "
                "Elimination of this positive definite matrix keeps them.",
                "expansion, 24 terms", 53, Outcome::inaccurate, "elimination, LU, rows exchanged", 0});
  return {claims(random),
          {hilbert("hilbert", p["s"], truth), shifted, determinant_one(static_cast<int>(p["m"]), random)}};
}

}  // namespace ex07_09

Exercise exercise_7_9() {
  using namespace ex07_09;
  return {"The 24 terms of a determinant",
          "Write out $\\det A=\\sum_\\sigma\\varepsilon_\\sigma "
          "a_{\\sigma(1)1}a_{\\sigma(2)2}a_{\\sigma(3)3}a_{\\sigma(4)4}$ for a $4\\times4$ matrix: all 24 "
          "terms with their signs.",
          parameters,
          {},
          study};
}

}  // namespace oddity
