#include "chapters/claims.hpp"

#include <array>

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_formulas.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "reference/text.hpp"
#include "solvers/counted.hpp"

namespace oddity::ex07_01 {

namespace {

using Cost = CostOf<double>;

constexpr Cost mu = cost<double>(1, 0, 0), alpha = cost<double>(0, 1, 0), delta = cost<double>(0, 0, 1),
               entry = entry_cost<double>();

template <class Run>
Cost counted_cost(const Run& run) {
  const Operations counted = operations_of(run);
  return {static_cast<double>(counted.multiplications), static_cast<double>(counted.additions),
          static_cast<double>(counted.divisions)};
}

/// What the parts of crosswise elimination cost a system of n unknowns, by running them on counted numbers.
struct Counts {
  double n = 0;
  Cost first_row = {}, forward_second = {}, full_second = {};  ///< one column cleared
  Cost full = {}, division = {};                               ///< all columns cleared; then the division
  Cost forward_and_back = {};

  static constexpr bool whole = true;
  /// Prices are vectors of what is counted.
  TypesetLetters typeset() const {
    return {{"n", n}, {R"(\mu)", {1, 0, 0}}, {R"(\alpha)", {0, 1, 0}}, {R"(\delta)", {0, 0, 1}}};
  }
  std::string where() const { return "$n$ = " + format_shortest(n); }
  Cost total() const { return full + division; }
  Cost excess() const { return total() - forward_and_back; }

  explicit Counts(std::size_t size) : n(static_cast<double>(size)) {
    const Rows<Counted<double>> start(size, std::vector<Counted<double>>(size + 1, 1.0));
    auto rows = start;
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
Formula<Counts> priced(std::string text, const std::function<Cost(double n)>& cost) {
  return counted(std::move(text), [=](const Counts& c) { return cost(c.n); });
}

/// A sixth of whole numbers that six divides, where the formula is right.
Formula<Counts> with_rest(const std::string& rest, Cost last) {
  return priced("$[n(n-1)/6][(2\\mu+\\alpha)n" + rest + "]$", [=](double n) {
    const Cost six = six_times_bracket(n, last);
    return Cost{six.mu / 6, six.alpha / 6, six.delta / 6};
  });
}

Cost sum_over_columns(const Counts& c) {
  Cost all;
  for (double columns = c.n; columns > 0; --columns) all = all + columns * (c.n - 1) * entry;
  return all;
}

void costs(Claims& claims, const std::vector<Counts>& sizes) {
  const std::string of = R"(coefficients of $\mu$, $\alpha$ and $\delta$)", count = "the count",
                    uncounted = "diagonal entries above the pivot";
  const auto claim = [&](const char* slug, int line, const char* says, FormulaClaim<Counts> parts) {
    parts.quantity = of;
    claims.formula(slug, line, says, sizes, parts);
  };
  claim("first_row", 3789, R"(row reduction with the first row costs $(2\mu+\alpha)n(n-1)$)",
        {.truth = counted(count, &Counts::first_row),
         .printed = priced(R"($(2\mu+\alpha)n(n-1)$)", [](double n) { return n * (n - 1) * entry; }),
         .near_misses = {priced(R"($(2\mu+\alpha)(n+1)(n-1)$, $n+1$ entries a row)",
                                [](double n) { return (n + 1) * (n - 1) * entry; })}});
  claim(
      "forward_second_row", 3789,
      R"(forward elimination with the second row costs $(2\mu+\alpha)(n-1)(n-2)$)",
      {.truth = counted(count, &Counts::forward_second),
       .printed = priced(R"($(2\mu+\alpha)(n-1)(n-2)$)", [](double n) { return (n - 1) * (n - 2) * entry; }),
       .near_misses = {
           priced(R"($(2\mu+\alpha)(n-1)(n-1)$, the row above cleared too)", printed_second_row<double>)}});
  claim("full_second_row", 3789, R"(full elimination with the second row costs $(2\mu+\alpha)(n-1)(n-1)$)",
        {.truth = counted(count, &Counts::full_second),
         .printed = priced(R"($(2\mu+\alpha)(n-1)(n-1)$)", printed_second_row<double>),
         .corrected = priced(R"($(2\mu+\alpha)(n-1)(n-1)+\mu$)", corrected_second_row<double>),
         .near_misses = {priced(R"($(2\mu+\alpha)(n-1)(n-1)+2\mu$)",
                                [](double n) { return (n - 1) * (n - 1) * entry + 2 * mu; })},
         .kind = Fault::left_out,
         .root = uncounted,
         .why =
             R"(To clear $a_{12}$, row one becomes $a_{22}$ row one $-\,a_{12}$ row two. This multiplies )"
             R"($a_{11}$ by $a_{22}$ too: one $\mu$ more than the entries to the right of the pivot take.)"});
  claim("full_sum", 3791, R"($n(n-1)+(n-1)(n-1)+\ldots+1(n-1)=(n-1)n(n+1)/2$)",
        {.truth = counted("the sum, entry by entry", sum_over_columns),
         .printed = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2$)", printed_full<double>),
         .near_misses = {priced(R"($(2\mu+\alpha)(n-1)n(n+1)/3$)",
                                [](double n) { return (n - 1) * n * (n + 1) / 3 * entry; })}});
  claim(
      "full_cost", 3791, R"(full elimination costs $F=(2\mu+\alpha)(n-1)n(n+1)/2$)",
      {.truth = counted(count, &Counts::full),
       .printed = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2$)", printed_full<double>),
       .corrected = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2+\mu\,n(n-1)/2$)", corrected_full<double>),
       .near_misses = {priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2+\mu\,n(n+1)/2$)",
                              [](double n) { return printed_full(n) + n * (n + 1) / 2 * mu; })},
       .kind = Fault::left_out,
       .root = uncounted,
       .why = R"(With column $k$ the diagonal entries of the $k-1$ rows above are multiplied by the pivot: )"
              R"($\mu\,n(n-1)/2$ in all, $27\mu+12\alpha$ and not $24\mu+12\alpha$ for $n=3$. Without them )"
              R"(the solution is wrong (see the methods). If they are multiplied once at the end, by one )"
              R"(product a row, they still cost $\mu(n-1)$.)"});
  claim("division_cost", 3795, R"(to divide each row by its diagonal entry costs $B=\delta n$)",
        {.truth = counted(count, &Counts::division),
         .printed = priced(R"($\delta n$)", [](double n) { return n * delta; }),
         .near_misses = {priced(R"($\delta(n-1)$)", [](double n) { return (n - 1) * delta; })}});
  claim(
      "full_total", 3797,
      R"(full elimination and division cost $C'=F+B=(2\mu+\alpha)(n-1)n(n+1)/2+\delta n$)",
      {.truth = counted(count, &Counts::total),
       .printed = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2+\delta n$)", printed_total<double>),
       .corrected = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2+\delta n+\mu\,n(n-1)/2$)", corrected_total<double>),
       .near_misses = {priced(R"($(2\mu+\alpha)(n-1)n(n+1)/2+\delta n+\mu\,n(n+1)/2$)",
                              [](double n) { return printed_total(n) + n * (n + 1) / 2 * mu; })},
       .kind = Fault::left_out,
       .root = uncounted,
       .why = R"($F$ leaves out $\mu\,n(n-1)/2$: for $n=3$ the total is $27\mu+12\alpha+3\delta$, not )"
              R"($24\mu+12\alpha+3\delta$.)"});
  claim("original_total", 3801, "forward elimination and back substitution cost $C$",
        {.truth = counted(count, &Counts::forward_and_back),
         .printed = priced(R"($C=(2\mu+\alpha)(n-1)n(n+1)/3+(\mu+\alpha)n(n-1)/2+\delta n$)",
                           printed_original<double>),
         .near_misses = {priced(R"($(2\mu+\alpha)(n-1)n(n+1)/3+(\mu+\alpha)n(n+1)/2+\delta n$)",
                                [](double n) { return printed_original(n) + n * (mu + alpha); })}});

  const auto difference = [](const Counts& c) { return printed_total(c.n) - printed_original(c.n); };
  claim(
      "difference", 3805, R"($C'-C$, both as printed, is $(2\mu+\alpha)(n-1)n(n+1)/6-(\mu+\alpha)n(n-1)/2$)",
      {.truth = counted("$C'$ as printed less $C$ as printed", difference),
       .printed = priced(R"($(2\mu+\alpha)(n-1)n(n+1)/6-(\mu+\alpha)n(n-1)/2$)", printed_difference<double>),
       .near_misses = {priced(R"($(2\mu+\alpha)(n-1)n(n+1)/6+(\mu+\alpha)n(n-1)/2$)",
                              [](double n) { return printed_difference(n) + n * (n - 1) * (mu + alpha); })}});
  claim("factored", 3805, R"(this is $[n(n-1)/6][(2\mu+\alpha)n-\mu]$)",
        {.truth = counted("$C'-C$, both as printed", difference),
         .printed = with_rest(R"(-\mu)", printed_rest<double>()),
         .corrected = with_rest(R"(-\mu-2\alpha)", rest_of_totals<double>()),
         .near_misses = {with_rest(R"(-\mu-\alpha)", -1.0 * mu - alpha)},
         .kind = Fault::formula,
         .root = "lost additions",
         .why = R"($(2\mu+\alpha)(n+1)-3(\mu+\alpha)=(2\mu+\alpha)n-\mu-2\alpha$: the $2\alpha$ was lost. )"
                R"(For $n=2$ the difference is $\mu$, and as factored in print $\mu+\tfrac23\alpha$.)"});
  claim("excess", 3805, R"(full elimination costs $[n(n-1)/6][(2\mu+\alpha)n-\mu]$ more)",
        {.truth = counted("the difference of the counts", &Counts::excess),
         .printed = with_rest(R"(-\mu)", printed_rest<double>()),
         .corrected = with_rest(R"(+2\mu-2\alpha)", rest_of_counts<double>()),
         .near_misses = {with_rest(R"(+\mu-2\alpha)", mu - 2 * alpha)},
         .kind = Fault::left_out,
         .root = uncounted,
         .why = R"(The multiplied diagonal entries add $\mu\,n(n-1)/2$, and the factoring loses $2\alpha$. )"
                R"(For $n=3$ the excess is $8\mu+\alpha$, not $5\mu+3\alpha$.)"});
}

// ---- which costs more -------------------------------------------------------------------------------------

/// Six times the excess at a real n: the cubic through the counts at n = 1, 2, 3, 4 by Newton;
/// exact for dyadic n.
Cost six_excess(const std::vector<Counts>& sizes, double n) {
  std::array<Cost, 4> d{};
  for (std::size_t i = 0; i < 4; ++i) d[i] = sizes[sizes.size() - 1 - i].excess();
  for (std::size_t order = 1; order < 4; ++order)
    for (std::size_t i = 3; i >= order; --i) d[i] = d[i] - d[i - 1];
  return 6 * d[0] + (n - 1) * (6 * d[1] + (n - 2) * (3 * d[2] + (n - 3) * d[3]));
}

/// Prices, and a number of unknowns above 1, whole or not.
struct Prices {
  double mu, alpha, n;
  Cost six_excess;

  bool full_costs_more() const { return six_excess.mu * mu + six_excess.alpha * alpha >= 0; }
  std::string where() const {
    return R"($\mu$ = )" + format_shortest(mu) + R"(, $\alpha$ = )" + format_shortest(alpha) +
           ", $n$ = " + format_shortest(n);
  }
};

void comparisons(Claims& claims, const std::vector<Counts>& sizes) {
  std::vector<Prices> prices;
  for (double m = 1; m <= 12; ++m)
    for (double a = 1; a <= 12; ++a)
      for (double n = 1.125; n <= 6; n += 0.125) prices.push_back({m, a, n, six_excess(sizes, n)});

  claims.statement<Counts>(
      "factor_positive", 3807, "$n(n-1)/6$ is positive for $n>1$", sizes,
      {.printed = {"for $n>1$", [](const Counts& c) { return c.n <= 1 || c.n * (c.n - 1) / 6 > 0; }},
       .near_misses = {{R"(for $n\ge1$)", [](const Counts& c) { return c.n * (c.n - 1) / 6 > 0; }}}});

  const auto exactly_from = [](double alphas) {
    return [=](const Prices& p) {
      return (p.n * (2 * p.mu + p.alpha) >= alphas * (p.alpha - p.mu)) == p.full_costs_more();
    };
  };
  claims.statement<Prices>(
      "threshold", 3807, R"($C'\ge C$ when $n\ge\mu/(2\mu+\alpha)$)", prices,
      {.printed = {R"($n\ge\mu/(2\mu+\alpha)$ is enough, $n>1$)",
                   [](const Prices& p) {
                     return !(p.n * (2 * p.mu + p.alpha) >= p.mu) || p.full_costs_more();
                   }},
       .corrected = {R"(exactly when $n\ge2(\alpha-\mu)/(2\mu+\alpha)$, $n>1$)", exactly_from(2)},
       .near_misses = {{R"(exactly when $n\ge(\alpha-\mu)/(2\mu+\alpha)$, $n>1$)", exactly_from(1)}},
       .kind = Fault::formula,
       .root = "lost additions",
       .why = R"(The bracket is $(2\mu+\alpha)n-\mu-2\alpha$ by the printed totals and )"
              R"($(2\mu+\alpha)n+2\mu-2\alpha$ by the count. With $\mu=1$, $\alpha=12$ the latter is )"
              R"(negative up to $n=11/7$, and not only up to $1/14$. Its zero is below 2 for all prices, so )"
              R"(that no whole $n>1$ is affected.)"});
  claims.statement<Prices>(
      "half", 3807, R"($\mu/(2\mu+\alpha)$ is smaller than $\tfrac12$)", prices,
      {.printed = {R"(below $\tfrac12$)", [](const Prices& p) { return 2 * p.mu < 2 * p.mu + p.alpha; }},
       .near_misses = {
           {R"(below $\tfrac13$)", [](const Prices& p) { return 3 * p.mu < 2 * p.mu + p.alpha; }}}});
  claims.statement<Counts>(
      "all_n", 3807, R"($C'\ge C$ for all $n\ge1$)", sizes,
      {.printed = {"coefficient by coefficient, whatever the prices",
                   [](const Counts& c) {
                     const Cost more = c.excess();
                     return more.mu >= 0 && more.alpha >= 0 && more.delta >= 0;
                   }},
       .near_misses = {{R"($C'>C$ for all $n\ge1$)", [](const Counts& c) { return c.excess().mu > 0; }}}});
  claims.statement<Counts>(
      "cheaper", 3807, "forward elimination, not full elimination, keeps the costs down", sizes,
      {.printed = {"fewer multiplications, and no more additions and divisions, for $n>1$",
                   [](const Counts& c) {
                     const Cost more = c.excess();
                     return c.n <= 1 || (more.mu > 0 && more.alpha >= 0 && more.delta >= 0);
                   }},
       .near_misses = {{"fewer additions as well, for $n>1$",
                        [](const Counts& c) { return c.n <= 1 || c.excess().alpha > 0; }}}});
}

// ---- whether it solves ------------------------------------------------------------------------------------

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

  /// Every equation holds.
  bool solved_by(const std::vector<Residue>& x) const {
    bool all = true;
    for (const auto& row : rows) {
      Residue sum{0};
      for (std::size_t j = 0; j < n(); ++j) sum = sum + row[j] * x[j];
      all = all && sum.value == row[n()].value;
    }
    return all;
  }

  /// Elimination by whole rows leaves no entry off the diagonal, and no zero on it.
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

  /// Full elimination, rows exchanged for a zero pivot in the first `exchanged` columns, gives the solution.
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

/// The first or the second pivot is zero as long as the rows stay where they are.
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
  claims.statement<Residues>(
      "diagonal", 3793, "full elimination leaves a diagonal matrix, and dividing by it solves the system",
      systems(random),
      {.printed = {"all entries off the diagonal are zero, and the quotients solve every equation",
                   [](const Residues& s) {
                     return s.made_diagonal(true) &&
                            s.solved_by(solve_full(s.rows, Clearing::crosswise, Diagonal::row_by_row));
                   }},
       .near_misses = {{"forward elimination leaves a diagonal matrix",
                        [](const Residues& s) { return s.made_diagonal(false); }},
                       {"the diagonal entries above left as they were, the quotients solve every equation",
                        [](const Residues& s) {
                          return s.solved_by(solve_full(s.rows, Clearing::crosswise, Diagonal::never));
                        }}}});
  claims.statement<Residues>(
      "zero_pivot", 3793, "a system that has one solution can be divided by its diagonal entries",
      systems_without_pivot(random),
      {.printed = {"the rows as they stand", [](const Residues& s) { return s.solved_with(0); }},
       .corrected = {"rows exchanged where a pivot is zero",
                     [](const Residues& s) { return s.solved_with(s.n()); }},
       .near_misses = {{"the first row alone exchanged", [](const Residues& s) { return s.solved_with(1); }}},
       .kind = Fault::left_out,
       .root = "no exchange of rows",
       .why =
           R"(Where a pivot is zero, crosswise clearing multiplies the other rows by it, and the diagonal )"
           R"(entries that are divided by at the end are 0: $x_2=2$, $x_1=3$, written as two rows in this )"
           R"(order, ends in $0/0$. An exchange with a lower row cures it and costs no arithmetic, so that )"
           R"(the totals stand. The solution has none, for forward elimination neither.)"});
}

}  // namespace

std::vector<Claim> claims(const Random& random) {
  std::vector<Counts> sizes;  // every size to 64, and some beyond; the largest first
  for (std::size_t n : {200u, 150u, 100u}) sizes.emplace_back(n);
  for (std::size_t n = 64; n > 1; --n) sizes.emplace_back(n);
  Claims claims("7.1");
  costs(claims, sizes);
  sizes.emplace_back(1);
  solutions(claims, random);
  comparisons(claims, sizes);
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"diagonal entries above the pivot",
       "A table of costs has 990 multiplications for ten unknowns, where the program makes 1035; one "
       "that leaves out the 45 gets a wrong solution."},
      {"lost additions",
       R"(For two unknowns the factored difference charges full elimination with $\tfrac23$ of an addition, where it )"
       R"(needs not one more.)"},
      {"no exchange of rows",
       R"(Of the 11808 invertible $3\times3$ matrices with entries $-1$, 0 and 1, 5528 have a zero pivot: )"
       R"(nearly half of them are answered with NaN.)"}};
}

}  // namespace oddity::ex07_01
