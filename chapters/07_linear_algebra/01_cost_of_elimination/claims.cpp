#include "chapters/claims.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_formulas.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"

namespace oddity::ex07_01 {

namespace {

using Cost = CostOf<double>;

constexpr Cost entry = entry_cost<double>();

template <class Run>
Cost counted_cost(const Run& run) {
  const Operations counted = operations_of(run);
  return {static_cast<double>(counted.multiplications), static_cast<double>(counted.additions),
          static_cast<double>(counted.divisions)};
}

/// Each price is a unit vector in the counts.
TypesetLetters letters_of(double n) {
  return {{"n", n}, {R"(\mu)", {1, 0, 0}}, {R"(\alpha)", {0, 1, 0}}, {R"(\delta)", {0, 0, 1}}};
}

/// Costs of the parts of crosswise elimination for n unknowns, measured on counting numbers.
struct Counts {
  double n = 0;
  Cost one_row = {};                                           ///< one entry of the first column cleared
  Cost first_row = {}, forward_second = {}, full_second = {};  ///< one column cleared
  Cost full = {}, division = {};                               ///< all columns cleared; then the division
  Cost forward_and_back = {};

  static constexpr bool whole = true;
  TypesetLetters typeset() const { return letters_of(n); }
  std::string where() const { return "$n$ = " + format_shortest(n); }
  Cost total() const { return full + division; }
  Cost excess() const { return total() - forward_and_back; }
  bool saves_nothing_else() const { return excess().alpha >= 0 && excess().delta >= 0; }

  explicit Counts(std::size_t size) : n(static_cast<double>(size)) {
    const Rows<Counted<double>> start(size, std::vector<Counted<double>>(size + 1, 1.0));
    auto rows = start;
    if (size > 1) one_row = counted_cost([&] { clear(rows, 1, 0, Clearing::crosswise); });
    first_row = counted_cost([&] { full_step(rows, 0); });
    if (size > 1) {
      auto forward = rows;
      forward_second = counted_cost([&] { forward_step(forward, 1); });
      full_second = counted_cost([&] { full_step(rows, 1); });
    }
    full = counted_cost([&] {
      for (std::size_t k = 0; k < size; ++k) full_step(rows, k);
    });
    division = counted_cost([&] { return divide(rows); });
    forward_and_back = counted_cost([&] { return solve_forward(start, Clearing::crosswise); });
  }
};

Formula<Counts> counted(std::string text, const std::function<Cost(const Counts&)>& cost) {
  return {std::move(text), [=](const Counts& c) {
            const Cost all = cost(c);
            return Value{all.mu, all.alpha, all.delta};
          }};
}
/// The printed difference in the text's factored form.
Cost factored(double n) {
  const Value all = TypesetFormula(printed_factored)(letters_of(n));
  return {all[0], all[1], all[2]};
}

/// Multiplications of diagonal entries that are postponed to the end.
double saved_up(std::size_t n) {
  const Rows<Counted<double>> rows(n, std::vector<Counted<double>>(n + 1, 1.0));
  const auto multiplications = [&](Diagonal diagonal) {
    return counted_cost([&] { return solve_full(rows, Clearing::crosswise, diagonal); }).mu;
  };
  return multiplications(Diagonal::at_the_end) - multiplications(Diagonal::never);
}

Cost sum_over_columns(const Counts& c) {
  Cost all;
  for (double columns = c.n; columns > 0; --columns) all = all + columns * (c.n - 1) * entry;
  return all;
}

void costs(Claims& claims, const std::vector<Counts>& sizes) {
  const std::string uncounted = "diagonal entries above the pivot", sum = R"((2\mu+\alpha)(n-1)n(n+1)/2)",
                    diagonals = R"(+\mu\,n(n-1)/2$)";
  const Counts of_three(3);
  const auto claim = [&](const char* slug, int line, const std::string& says, const std::string& printed,
                         const Formula<Counts>& truth, const std::string& corrected = {},
                         const std::string& root = {}, const std::string& why = {}) {
    claims.formula<Counts>(slug, line, says, sizes,
                           {.quantity = R"(coefficients of $\mu$, $\alpha$ and $\delta$)",
                            .truth = truth,
                            .printed = {printed},
                            .corrected = {corrected},
                            .root = root,
                            .why = why});
  };
  const auto counts = [&](const char* slug, int line, const std::string& before, const std::string& formula,
                          const std::function<Cost(const Counts&)>& cost, const std::string& corrected = {},
                          const std::string& why = {}) {
    claim(slug, line, before + formula, "$" + formula, counted("the count", cost), corrected,
          corrected.empty() ? "" : uncounted, why);
  };
  // for a text with "@2\mu+@2\alpha" of each.
  const auto both = [](const Cost& one, const Cost& other) {
    return std::vector{one.mu, one.alpha, other.mu, other.alpha};
  };
  counts("one_row", 3789, "recomputing one row's entries in columns 2 to $n+1$ costs $", R"((2\mu+\alpha)n$)",
         &Counts::one_row);
  counts("first_row", 3789, "row reduction with the first row costs $", R"((2\mu+\alpha)n(n-1)$)",
         &Counts::first_row);
  counts("forward_second_row", 3789, "forward elimination with the second row costs $",
         R"((2\mu+\alpha)(n-1)(n-2)$)", &Counts::forward_second);
  counts("full_second_row", 3789, "full elimination with the second row costs $",
         R"((2\mu+\alpha)(n-1)(n-1)$)", &Counts::full_second, R"($(2\mu+\alpha)(n-1)(n-1)+\mu$)",
         filled(R"(To clear $a_{12}$, $a_{11}$ is multiplied by $a_{22}$ too: the $@2\mu+@2\alpha$ that the )"
                R"(entries right of the pivot take for $n=3$ are $@2\mu+@2\alpha$.)",
                both(printed_second_row(3.0), of_three.full_second)));
  claim("full_sum", 3791, R"($(2\mu+\alpha)[n(n-1)+(n-1)(n-1)+\ldots+1(n-1)]=)" + sum + "$", "$" + sum + "$",
        counted("the sum, entry by entry", sum_over_columns));
  counts(
      "full_cost", 3791, "full elimination costs $F=", sum + "$", &Counts::full, "$" + sum + diagonals,
      filled(
          R"(With column $k$ the diagonal entries of the $k-1$ rows above are multiplied by the pivot: )"
          R"($@2\mu+@2\alpha$ and not $@2\mu+@2\alpha$ for $n=3$. Without them the solution is wrong (see the )"
          R"(methods). Even saved up for the end, they cost $\mu(n-1)$: @1 for $n=10$.)",
          {of_three.full.mu, of_three.full.alpha, printed_full(3.0).mu, printed_full(3.0).alpha,
           saved_up(10)}));
  counts("division_cost", 3795, "to divide each row by its diagonal entry costs $B=", R"(\delta n$)",
         &Counts::division);
  counts(
      "full_total", 3797, "full elimination and division cost $C'=F+B=", sum + R"(+\delta n$)",
      &Counts::total, "$" + sum + R"(+\delta n)" + diagonals,
      filled(R"($F$ lacks the term $\mu\,n(n-1)/2$: for $n=3$ the total is $@2\mu+@2\alpha+@1\delta$, not )"
             R"($@2\mu+@2\alpha+@1\delta$.)",
             {of_three.total().mu, of_three.total().alpha, of_three.total().delta, printed_total(3.0).mu,
              printed_total(3.0).alpha, printed_total(3.0).delta}));
  counts("original_total", 3801, "forward elimination and back substitution cost $",
         R"(C=(2\mu+\alpha)(n-1)n(n+1)/3+(\mu+\alpha)n(n-1)/2+\delta n$)", &Counts::forward_and_back);

  const auto difference = [](const Counts& c) { return printed_total(c.n) - printed_original(c.n); };
  const std::string less = R"((2\mu+\alpha)(n-1)n(n+1)/6-(\mu+\alpha)n(n-1)/2$)",
                    factors = R"($C'-C=[n(n-1)/6][(2\mu+\alpha)n-\mu]$)";
  claim("difference", 3805, "$C'-C$, both as printed, is $" + less, "$" + less,
        counted("$C'$ as printed less $C$ as printed", difference));
  claim(
      "factored", 3805, factors + ", the printed difference factored", printed_factored,
      counted("$C'-C$, both as printed", difference), factored_of_totals, "lost additions",
      filled(R"($(2\mu+\alpha)(n+1)-3(\mu+\alpha)=(2\mu+\alpha)n-\mu-2\alpha$: the $2\alpha$ was lost. For )"
             R"($n=2$ the difference is $@2\mu+@2\alpha$, and as factored in print $@2\mu+@2\alpha$.)",
             both(printed_difference(2.0), factored(2))));
  claim(
      "excess", 3805, "full elimination costs " + factors + " more than forward elimination",
      printed_factored, counted("the difference of the counts", &Counts::excess), factored_of_counts,
      uncounted,
      filled(
          R"(The multiplied diagonal entries add $\mu\,n(n-1)/2$, and the factoring loses $2\alpha$: for )"
          R"($n=3$ the excess is $@2\mu+@2\alpha$, not $@2\mu+@2\alpha$. The bracket is negative for no whole )"
          R"($n>1$, so that the conclusion of the text is right.)",
          both(of_three.excess(), factored(3))));
}

// ---- which costs more -------------------------------------------------------------------------------------

/// Prices, and the number of unknowns.
struct Prices {
  double mu, alpha, n;
  Cost excess;

  double bound() const { return mu / (2 * mu + alpha); }
  double costs_more() const { return excess.mu * mu + excess.alpha * alpha; }
  TypesetLetters typeset() const { return {{"n", n}, {R"(\mu)", mu}, {R"(\alpha)", alpha}}; }
};

/// The last of the sizes is one.
void comparisons(Claims& claims, const std::vector<Counts>& sizes) {
  std::vector<Prices> prices;
  for (double m = 1; m <= 12; ++m)
    for (double a = 1; a <= 12; ++a)
      for (const Counts& c : sizes)
        if (c.n <= 12) prices.push_back({m, a, c.n, c.excess()});

  claims.statement<Counts>("factor_positive", 3807, "$n(n-1)/6$ is positive for $n>1$",
                           {sizes.begin(), sizes.end() - 1},
                           {.printed = {"$n(n-1)/6>0$"}, .near_misses = {{"$n(n-2)/6>0$"}}});
  claims.statement<Prices>(
      "threshold", 3807, R"($C'\ge C$ when $n\ge\mu/(2\mu+\alpha)$)", prices,
      {.printed = {R"($n\ge\mu/(2\mu+\alpha)$ is enough, $n$ being whole)",
                   [](const Prices& p) { return p.n < p.bound() || p.costs_more() >= 0; }},
       .near_misses = {{R"(it is enough for $C'>C$)",
                        [](const Prices& p) { return p.n < p.bound() || p.costs_more() > 0; }}}});
  claims.statement<Prices>(
      "half", 3807, R"($\mu/(2\mu+\alpha)$ is smaller than $\tfrac12$)", prices,
      {.printed = {R"($\mu/(2\mu+\alpha)<\tfrac12$)"}, .near_misses = {{R"($\mu/(2\mu+\alpha)<\tfrac13$)"}}});
  claims.statement<Prices>(
      "whole_from_one", 3807, R"(the whole numbers $n\ge\mu/(2\mu+\alpha)$ are those from 1)", prices,
      {.printed = {R"($0<\mu/(2\mu+\alpha)\le1$)"}, .near_misses = {{R"($1<\mu/(2\mu+\alpha)\le2$)"}}});
  claims.statement<Counts>(
      "all_n", 3807, R"($C'\ge C$ for all $n\ge1$)", sizes,
      {.printed = {"coefficient by coefficient, whatever the prices",
                   [](const Counts& c) { return c.excess().mu >= 0 && c.saves_nothing_else(); }},
       .near_misses = {{R"($C'>C$ for all $n\ge1$)", [](const Counts& c) { return c.excess().mu > 0; }}}});
  claims.statement<Counts>(
      "cheaper", 3807, "forward elimination, not full elimination, keeps the costs to a minimum", sizes,
      {.printed = {"fewer multiplications, and no more additions and divisions, for $n>1$",
                   [](const Counts& c) { return c.n <= 1 || (c.excess().mu > 0 && c.saves_nothing_else()); }},
       .near_misses = {{"fewer additions as well, for $n>1$",
                        [](const Counts& c) { return c.n <= 1 || c.excess().alpha > 0; }}}});
}

// ---- correctness ------------------------------------------------------------------------------------------

/// The integers modulo the prime 2^31 - 1: exact, without growth.
struct Residue {
  static constexpr unsigned long long prime = 2147483647;
  unsigned long long value = 0;

  friend Residue operator+(Residue a, Residue b) { return {(a.value + b.value) % prime}; }
  friend Residue operator-(Residue a, Residue b) { return {(a.value + prime - b.value) % prime}; }
  friend Residue operator*(Residue a, Residue b) { return {a.value * b.value % prime}; }
  friend Residue operator/(Residue a, Residue b) {
    Residue inverse{1};
    for (auto power = prime - 2; power > 0; power >>= 1, b = b * b)
      if (power & 1) inverse = inverse * b;
    return a * inverse;
  }
};

/// A random system modulo the prime.
struct Residues {
  Rows<Residue> rows;

  std::size_t n() const { return rows.size(); }
  std::string where() const { return "$n$ = " + std::to_string(n()) + ", modulo $2^{31}-1$"; }

  /// Whether x solves every equation.
  bool solved_by(const std::vector<Residue>& x) const {
    return std::ranges::all_of(rows, [&](const auto& row) {
      return std::inner_product(x.begin(), x.end(), row.begin(), Residue{0}).value == row[n()].value;
    });
  }

  /// Whether elimination by whole rows leaves zeros off the diagonal and none on it.
  bool made_diagonal(bool above) const {
    auto m = rows;
    for (std::size_t k = 0; k < n(); ++k)
      for (std::size_t row = above ? 0 : k + 1; row < n(); ++row) {
        if (row == k) continue;
        const Residue pivot = m[k][k], factor = m[row][k];
        for (std::size_t j = 0; j <= n(); ++j) m[row][j] = pivot * m[row][j] - factor * m[k][j];
      }
    bool all = true;
    for (std::size_t i = 0; i < n(); ++i)
      for (std::size_t j = 0; j < n(); ++j) all = all && (i == j) == (m[i][j].value != 0);
    return all;
  }

  /// Whether full elimination solves the system, with rows exchanged for a zero pivot in the first
  /// `exchanged` columns.
  bool solved_with(std::size_t exchanged) const {
    auto m = rows;
    for (std::size_t k = 0; k < n(); ++k) {
      std::size_t pivot = k;
      while (k < exchanged && m[pivot][k].value == 0 && pivot + 1 < n()) ++pivot;
      std::swap(m[k], m[pivot]);
      full_step(m, k);
    }
    for (std::size_t i = 0; i < n(); ++i)
      if (m[i][i].value == 0) return false;
    return solved_by(divide(m));
  }
};

std::vector<Residues> systems(Random random) {
  std::vector<Residues> all;
  for (std::size_t n = 2; n <= 12; ++n)
    all.push_back({random_rows(n, [&] { return Residue{random.bits() % Residue::prime}; })});
  return all;
}

/// Systems whose first or second pivot is zero unless rows are exchanged.
std::vector<Residues> systems_without_pivot(const Random& random) {
  auto all = systems(random);
  for (auto& [m] : all) {
    if (m.size() % 2 == 0)
      m[0][0] = Residue{0};
    else
      for (std::size_t j = 0; j < 2; ++j) m[1][j] = m[0][j] + m[0][j];
  }
  return all;
}

void solutions(Claims& claims, const Random& random) {
  auto all = systems_without_pivot(random);
  for (auto& system : systems(random)) all.push_back(std::move(system));
  claims.statement<Residues>("diagonal", 3793,
                             R"(full elimination makes the first $n\times n$ part of the matrix diagonal)",
                             systems(random),
                             {.printed = {"all entries off the diagonal are zero, and none on it",
                                          [](const Residues& s) { return s.made_diagonal(true); }},
                              .near_misses = {{"forward elimination leaves a diagonal matrix",
                                               [](const Residues& s) { return s.made_diagonal(false); }}}});
  const auto solves = [](std::string text, Diagonal diagonal) {
    return Statement<Residues>{std::move(text), [=](const Residues& s) {
                                 return s.solved_by(solve_full(s.rows, Clearing::crosswise, diagonal));
                               }};
  };
  claims.statement<Residues>(
      "quotients", 3793, "each row divided by its diagonal entry gives the solution", systems(random),
      {.printed = solves("the quotients solve every equation", Diagonal::row_by_row),
       .near_misses = {
           solves("they do with the diagonal entries above left as they were", Diagonal::never)}});
  Rows<double> swapped{{0, 1, 2}, {1, 0, 3}};  // x2 = 2, x1 = 3
  full_step(swapped, 0);
  full_step(swapped, 1);
  claims.statement<Residues>(
      "zero_pivot", 3793,
      "each row can be divided by its diagonal entry (our reading: no pivot is ever zero)", all,
      {.printed = {"the rows in their given order", [](const Residues& s) { return s.solved_with(0); }},
       .corrected = {"rows exchanged where a pivot is zero",
                     [](const Residues& s) { return s.solved_with(s.n()); }},
       .in_view = {"where no pivot is zero", [](const Residues& s) { return s.made_diagonal(true); }},
       .near_misses = {{"the first row alone exchanged", [](const Residues& s) { return s.solved_with(1); }}},
       .root = "no exchange of rows",
       .why = filled(
           R"(Crosswise clearing multiplies the other rows by a pivot of zero: the system $x_2=2$, $x_1=3$, in )"
           R"(this order, ends in $@1/@1$. The text counts operations and has no such system in view. An )"
           R"(exchange with a lower row cures it and costs no arithmetic, so that no total changes.)",
           {swapped[0][2] + 0.0, swapped[0][0] + 0.0})});
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  std::vector<Counts> sizes;  // all sizes up to 64, and some larger; the largest is first
  for (std::size_t n : {200u, 150u, 100u}) sizes.emplace_back(n);
  for (std::size_t n = 64; n > 1; --n) sizes.emplace_back(n);
  Claims claims("7.1");
  costs(claims, sizes);
  sizes.emplace_back(1);
  solutions(claims, random);
  comparisons(claims, sizes);
  return claims.in_order();
}

namespace {

/// Counts of the invertible 3 x 3 matrices with entries -1, 0 and 1, and of those for which elimination in
/// order fails.
std::array<double, 2> small_matrices() {
  std::array<double, 2> count{};
  for (int code = 0; code < 19683; ++code) {
    std::array<int, 9> m{};
    for (int i = 0, rest = code; i < 9; ++i, rest /= 3) m[static_cast<std::size_t>(i)] = rest % 3 - 1;
    const int second = m[0] * m[4] - m[1] * m[3],
              det = m[8] * second - m[7] * (m[0] * m[5] - m[2] * m[3]) + m[6] * (m[1] * m[5] - m[2] * m[4]);
    if (det == 0) continue;
    ++count[0];
    count[1] += m[0] == 0 || second == 0;
  }
  return count;
}

}  // namespace

std::vector<Root> roots() {
  constexpr unsigned many = 10, few = 2;
  const double printed = printed_total<double>(many).mu, made = Counts(many).total().mu;
  const auto [invertible, failing] = small_matrices();
  return {
      {"diagonal entries above the pivot",
       filled("A table of costs has @3 multiplications for @2 unknowns, where the program makes @4; one "
              "that leaves out the @2 gets a wrong solution.",
              {printed, many, made, made - printed})},
      {"lost additions",
       filled(
           "For @1 unknowns the factored difference charges full elimination with @2 of an addition, where it "
           "needs @1 more.",
           {few, factored(few).alpha, Counts(few).excess().alpha})},
      {"no exchange of rows",
       filled(
           R"(A zero pivot occurs in @4 of the @5 invertible $3\times3$ matrices with entries $-1$, 0 and 1: )"
           R"(@2 % of them are answered with NaN.)",
           {failing, invertible, 100 * failing / invertible})}};
}

}  // namespace oddity::ex07_01
