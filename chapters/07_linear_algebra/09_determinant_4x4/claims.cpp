#include "chapters/claims.hpp"

#include <algorithm>
#include <set>

#include "chapters/07_linear_algebra/09_determinant_4x4/determinant_4x4.hpp"
#include "chapters/provable.hpp"

namespace oddity::ex07_09 {

namespace {

struct Row {
  int line;
  std::string_view permutation, term;
  std::string where() const { return std::string(permutation); }
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

std::size_t digit(char c) { return static_cast<std::size_t>(c - '1'); }

Term parsed(std::string_view text) {
  Term term{text[0] == '-', {}, {}};
  for (std::size_t k = 0; k < 4; ++k)
    term.rows[k] = digit(text[4 * k + 3]), term.columns[k] = digit(text[4 * k + 4]);
  return term;
}

}  // namespace

std::vector<Term> printed_terms() {
  std::vector<Term> terms;
  for (const Row& row : table) terms.push_back(parsed(row.term));
  return terms;
}

namespace {

/// Fraction-free elimination with row exchange (Bareiss 1968), whose divisions leave no remainder. For whole
/// numbers with entries below 2000.
Whole by_bareiss(Matrix4<Whole> m) {
  Whole previous = 1, sign = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (pivot < 4 && m[pivot][k] == 0) ++pivot;
    if (pivot == 4) return 0;
    if (pivot != k) std::swap(m[pivot], m[k]), sign = -sign;
    for (std::size_t i = k + 1; i < 4; ++i)
      for (std::size_t j = k + 1; j < 4; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous;
    previous = m[k][k];
  }
  return sign * m[3][3];
}

/// A matrix of whole numbers; a tenth are singular, one is zero.
struct Sample {
  static constexpr bool whole = true;
  Matrix4<Whole> m;
  TypesetLetters typeset() const {
    TypesetLetters all;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        all.emplace_back("a_{" + std::to_string(i + 1) + std::to_string(j + 1) + "}",
                         static_cast<double>(m[i][j]));
    return all;
  }
  std::string where() const { return listed(typeset(), 16); }
};

std::vector<Sample> full_matrices(Random random) {
  std::vector<Sample> all;
  for (int sample = 0; sample < 500; ++sample) {
    auto m = random_matrix(random, 999);
    if (sample % 10 == 9) m[3] = m[static_cast<std::size_t>(random.below(3))];
    all.push_back({m});
  }
  all.push_back({Matrix4<Whole>{}});  // no column has a pivot
  return all;
}

/// Whole numbers at the four places of a permutation, zero elsewhere.
std::vector<Sample> matrices_of(std::string_view permutation, Random random) {
  std::vector<Sample> all;
  for (int sample = 0; sample < 8; ++sample) {
    Matrix4<Whole> m{};
    for (std::size_t k = 0; k < 4; ++k) m[digit(permutation[k])][k] = 1 + random.below(99);
    all.push_back({m});
  }
  return all;
}

Formula<Sample> in_whole(std::string text, const std::function<Whole(const Matrix4<Whole>&)>& of) {
  return {std::move(text), [=](const Sample& s) { return values(of(s.m)); }};
}

/// For all number types with negation.
template <class T>
T sum_of(const std::vector<Term>& all, const Matrix4<T>& m) {
  T sum = 0;
  for (const Term& term : all) sum += term.negative ? -term_of(term, m) : term_of(term, m);
  return sum;
}

const Formula<Sample> elimination = in_whole("fraction-free elimination", by_bareiss);

/// The sum over all permutations, whose parity is found by counting inversions.
template <class T>
T sum_over_permutations(const Matrix4<T>& m) {
  std::array<std::size_t, 4> s{0, 1, 2, 3};
  T sum = 0;
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) inversions += s[i] > s[j];
    const T product = m[s[0]][0] * m[s[1]][1] * m[s[2]][2] * m[s[3]][3];
    sum += inversions % 2 == 1 ? -product : product;
  } while (std::next_permutation(s.begin(), s.end()));
  return sum;
}

/// "+ a11 a22" as $+a_{11}a_{22}$.
std::string typeset(std::string_view term) {
  std::string tex = "$";
  for (std::size_t i = 0; i < term.size(); ++i) {
    if (term[i] == ' ') continue;
    tex += term[i];
    if (term[i] == 'a') tex += "_{" + std::string(term.substr(i + 1, 2)) + "}", i += 2;
  }
  return tex + "$";
}

/// Counts those of the 4^4 maps of {1, 2, 3, 4} into itself that reach every number.
double onto_maps() {
  int count = 0;
  for (int code = 0; code < 256; ++code)
    count += std::set<int>{code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6}.size() == 4;
  return count;
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  Claims claims("7.9");
  const auto matrices = full_matrices(random);
  const std::vector<Term> all = printed_terms();
  claims.over(matrices)(
      "formula", 3933,
      R"($\det A=\sum_\sigma\varepsilon_\sigma a_{\sigma(1)1}a_{\sigma(2)2}a_{\sigma(3)3}a_{\sigma(4)4}$, )"
      R"(printed with an equals sign before $\varepsilon_\sigma$)",
      {.quantity = R"($\det A$)",
       .truth = elimination,
       .printed = {R"($a_{11}a_{22}a_{33}a_{44}$)"},
       .meant =
           {R"($\sum_\sigma\varepsilon_\sigma a_{\sigma(1)1}a_{\sigma(2)2}a_{\sigma(3)3}a_{\sigma(4)4}$)"},
       .kind = Fault::formula,
       .why = filled("An equals sign is printed between the summation sign and its product. A product "
                     "alone is one of @2 terms: 1 for a matrix of ones, whose determinant is 0.",
                     {onto_maps()})});
  const auto permutations = [](const std::string& what, const std::string& stated, double number) {
    return Check{what, {stated, number}, {R"(maps of $\{1,2,3,4\}$ onto itself)", onto_maps()}, exact()};
  };
  claims.add(
      "permutations", 3935, "there are $4!=24$ permutations of $(1,2,3,4)$",
      {.printed = {"24", {permutations("permutations", "as printed", 24)}},
       .near_misses = {{"23, the identity not counted", {permutations("permutations", "as printed", 23)}}}});

  std::vector<Row> rows(std::begin(table), std::end(table));
  const auto entries = [](int number) {
    return [=](const Row& row) {
      const Term t = parsed(row.term);
      return std::ranges::count(row.term, 'a') == number &&
             std::set(t.rows.begin(), t.rows.end()).size() == 4 &&
             std::set(t.columns.begin(), t.columns.end()).size() == 4;
    };
  };
  claims.statement<Row>("four_entries", 3935, "each of the 24 terms has four factors $a_{ij}$ and a sign",
                        rows,
                        {.printed = {"four, of different rows and columns", entries(4)},
                         .near_misses = {{"three, of different rows and columns", entries(3)}}});

  std::set<std::string_view> different;
  for (const Row& row : table) different.insert(row.permutation);
  std::vector<Term> flipped = all, dropped = all;
  flipped.back().negative = !flipped.back().negative;
  dropped.pop_back();
  const auto sum = [&](const std::string& text, const std::vector<Term>& some) {
    const auto of = [some](const Matrix4<Whole>& m) { return sum_of(some, m); };
    return compare(R"($\det A$)", in_whole(text, of), elimination, matrices);
  };
  claims.add("table", 3935, "the table shows the 24 terms and signs",
             {.printed = {"24 different permutations, and the sum of the terms is the determinant",
                          {permutations("different permutations", "in the table",
                                        static_cast<double>(different.size())),
                           sum("sum of the 24 terms", all)}},
              .near_misses = {{"the last sign flipped", {sum("sum, the last sign flipped", flipped)}},
                              {"the last term dropped", {sum("sum, the last term dropped", dropped)}}}});
  for (const Row& row : table) {
    const std::string name(row.permutation), tex = typeset(row.term);
    std::string listed;
    for (const char digit : name) listed += std::string(listed.empty() ? "" : ",") + digit;
    claims.over(matrices_of(name, random))(
        "term_" + name, row.line, "the permutation $(" + listed + ")$ has the term " + tex, elimination,
        {tex}, R"(the determinant with no entries but $a_{\sigma(1)1},\ldots,a_{\sigma(4)4}$)");
  }
  return claims.in_order();
}

namespace {

/// The determinant of a matrix of letters, by cofactors of the first row, is a sum. With `places`, "a11 a22",
/// all other entries are zero.
Lemma determinant_is(std::string name, const auto& sum, std::string_view places = {}) {
  std::string letters;
  Matrix4<Expression> m;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const std::string letter = "a" + std::to_string(i + 1) + std::to_string(j + 1);
      if (!places.empty() && places.find(letter) == places.npos) continue;
      letters += letter + " ";
      m[i][j] = Expression::letter(letter);
    }
  return {std::move(name), "(" + letters + ": R)", {}, {by_cofactors(m) == sum(m)}, "ring"};
}

}  // namespace

Provables proofs() {
  const std::vector<Term> all = printed_terms();
  Matrix4<Expression> ones;
  for (auto& row : ones) row.fill(1);
  Provables proofs{
      {"7.9-formula",
       "the signed sum over all permutations is the determinant; of a matrix of ones one term is not",
       {determinant_is("meant", [](const auto& m) { return sum_over_permutations(m); }),
        {.name = "printed_differs",
         .follows = {apart(sum_of({all[0]}, ones), by_cofactors(ones), 1)},
         .tactic = by_arithmetic}},
       1},
      {"7.9-table",
       "the sum of the 24 printed terms is the determinant",
       {determinant_is("printed", [&](const auto& m) { return sum_of(all, m); })}}};
  for (const Row& row : table) {
    const auto term = [&](const auto& m) { return sum_of({parsed(row.term)}, m); };
    proofs.push_back({"7.9-term_" + std::string(row.permutation),
                      "it is the determinant where all other entries are zero",
                      {determinant_is("printed", term, row.term)}});
  }
  return proofs;
}

}  // namespace oddity::ex07_09
