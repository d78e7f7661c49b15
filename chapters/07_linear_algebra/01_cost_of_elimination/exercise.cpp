// Exercise 7.1: what full elimination (every column cleared below and above its pivot) costs more than
// forward elimination with back substitution; mu, alpha, delta are the prices of a multiplication, an
// addition and a division. The book clears crosswise, row_i <- a_kk row_i - a_ik row_k, which is 2 mu + alpha
// an entry. The counts come from eliminations run on counted numbers, never from a formula, and are compared
// exactly, as coefficients of mu, alpha and delta; that the eliminations are right is seen modulo a prime.

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_laws.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/systems.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex07_01 {

using namespace elimination;

constexpr Parameter parameters[] = {
    {"n", 6, "", "unknowns of the system", 2, 8, whole_number},
    {"N", 32, "", "unknowns of the larger system", 16, 96, whole_number},
    {"seed", 1, "", "seed of the random systems", 0, 1e9, whole_number},
};

// ---- what it costs ----------------------------------------------------------------------------------------

constexpr Cost mu{1, 0, 0}, alpha{0, 1, 0}, delta{0, 0, 1}, entry = 2 * mu + alpha;

Cost printed_full(double n) { return (n - 1) * n * (n + 1) / 2 * entry; }
Cost printed_total(double n) { return printed_full(n) + n * delta; }
Cost printed_original(double n) {
  return (n - 1) * n * (n + 1) / 3 * entry + n * (n - 1) / 2 * (mu + alpha) + n * delta;
}
Cost printed_difference(double n) {
  return (n - 1) * n * (n + 1) / 6 * entry - n * (n - 1) / 2 * (mu + alpha);
}
/// n(n-1) times a bracket: six times [n(n-1)/6][...], so that all stays whole.
Cost six_times(double n, Cost bracket) { return n * (n - 1) * bracket; }
Cost diagonals(double n) { return n * (n - 1) / 2 * mu; }

Cost sum_over_columns(const Counts& c) {
  Cost all;
  for (double columns = c.n; columns > 0; --columns) all = all + columns * (c.n - 1) * entry;
  return all;
}
Cost total(const Counts& c) { return c.full + c.division; }
Cost excess(const Counts& c) { return total(c) - c.forward_and_back; }

std::vector<Law> laws() {
  const std::string counted = "the count", printed = "C' - C, both as printed";
  return {
      {"7.1-first_row",
       3789,
       "row reduction with the first row costs (2 mu + alpha) n (n-1)",
       counted,
       &Counts::first_row,
       {"(2 mu + alpha) n (n-1)", [](double n) { return n * (n - 1) * entry; }},
       {},
       {"n+1 entries a row", [](double n) { return (n + 1) * (n - 1) * entry; }}},
      {"7.1-forward_second_row",
       3789,
       "forward elimination with the second row costs (2 mu + alpha)(n-1)(n-2)",
       counted,
       &Counts::forward_second,
       {"(2 mu + alpha)(n-1)(n-2)", [](double n) { return (n - 1) * (n - 2) * entry; }},
       {},
       {"the row above cleared too", [](double n) { return (n - 1) * (n - 1) * entry; }}},
      {"7.1-full_second_row",
       3789,
       "full elimination with the second row costs (2 mu + alpha)(n-1)(n-1)",
       counted,
       &Counts::full_second,
       {"(2 mu + alpha)(n-1)(n-1)", [](double n) { return (n - 1) * (n - 1) * entry; }},
       {"(2 mu + alpha)(n-1)(n-1) + mu", [](double n) { return (n - 1) * (n - 1) * entry + mu; }},
       {"(2 mu + alpha)(n-1)(n-1) + 2 mu", [](double n) { return (n - 1) * (n - 1) * entry + 2 * mu; }},
       "To clear $a_{12}$, row one becomes $a_{22}$ row one $-\\,a_{12}$ row two. This multiplies $a_{11}$ "
       "by $a_{22}$ too: one $\\mu$ more than the entries to the right of the pivot take."},
      {"7.1-full_sum",
       3791,
       "n(n-1) + (n-1)(n-1) + ... + 1(n-1) = (n-1)n(n+1)/2",
       "the sum",
       sum_over_columns,
       {"(2 mu + alpha)(n-1)n(n+1)/2", printed_full},
       {},
       {"(2 mu + alpha)(n-1)n(n+1)/3", [](double n) { return (n - 1) * n * (n + 1) / 3 * entry; }}},
      {"7.1-full_cost",
       3791,
       "full elimination costs F = (2 mu + alpha)(n-1)n(n+1)/2",
       counted,
       &Counts::full,
       {"(2 mu + alpha)(n-1)n(n+1)/2", printed_full},
       {"(2 mu + alpha)(n-1)n(n+1)/2 + mu n(n-1)/2", [](double n) { return printed_full(n) + diagonals(n); }},
       {"(2 mu + alpha)(n-1)n(n+1)/2 + mu n(n+1)/2",
        [](double n) { return printed_full(n) + n * (n + 1) / 2 * mu; }},
       "With column $k$ the diagonal entries of the $k-1$ rows above are multiplied by the pivot: "
       "$\\mu\\,n(n-1)/2$ in all, $27\\mu+12\\alpha$ and not $24\\mu+12\\alpha$ for $n=3$. Without them the "
       "solution is wrong (see the methods). If they are multiplied once at the end, by one product a row, "
       "they "
       "still cost $\\mu(n-1)$."},
      {"7.1-division_cost",
       3795,
       "to divide each row by its diagonal entry costs B = delta n",
       counted,
       &Counts::division,
       {"delta n", [](double n) { return n * delta; }},
       {},
       {"delta (n-1)", [](double n) { return (n - 1) * delta; }}},
      {"7.1-full_total",
       3797,
       "full elimination and division cost C' = (2 mu + alpha)(n-1)n(n+1)/2 + delta n",
       counted,
       total,
       {"F + B as printed", printed_total},
       {"F + B + mu n(n-1)/2", [](double n) { return printed_total(n) + diagonals(n); }},
       {"F + B + mu n(n+1)/2", [](double n) { return printed_total(n) + n * (n + 1) / 2 * mu; }},
       "$F$ leaves out $\\mu\\,n(n-1)/2$: for $n=3$ the total is $27\\mu+12\\alpha+3\\delta$, not "
       "$24\\mu+12\\alpha+3\\delta$."},
      {"7.1-original_total",
       3801,
       "forward elimination and back substitution cost C = (2 mu + alpha)(n-1)n(n+1)/3 + (mu + "
       "alpha)n(n-1)/2 + delta n",
       counted,
       &Counts::forward_and_back,
       {"C as printed", printed_original},
       {},
       {"(mu + alpha)n(n+1)/2", [](double n) { return printed_original(n) + n * (mu + alpha); }}},
      {"7.1-difference",
       3805,
       "C' - C, as printed, is (2 mu + alpha)(n-1)n(n+1)/6 - (mu + alpha)n(n-1)/2",
       printed,
       [](const Counts& c) { return printed_total(c.n) - printed_original(c.n); },
       {"as printed", printed_difference},
       {},
       {"+ (mu + alpha)n(n-1)/2",
        [](double n) { return printed_difference(n) + n * (n - 1) * (mu + alpha); }}},
      {"7.1-factored",
       3805,
       "this is [n(n-1)/6][(2 mu + alpha) n - mu]",
       printed + ", six times",
       [](const Counts& c) { return 6 * (printed_total(c.n) - printed_original(c.n)); },
       {"n(n-1)[(2 mu + alpha) n - mu]", [](double n) { return six_times(n, n * entry - mu); }},
       {"n(n-1)[(2 mu + alpha) n - mu - 2 alpha]",
        [](double n) { return six_times(n, n * entry - mu - 2 * alpha); }},
       {"n(n-1)[(2 mu + alpha) n - mu - alpha]",
        [](double n) { return six_times(n, n * entry - mu - alpha); }},
       "$(2\\mu+\\alpha)(n+1)-3(\\mu+\\alpha)=(2\\mu+\\alpha)n-\\mu-2\\alpha$: the $2\\alpha$ was lost. For "
       "$n=2$ the left side is $\\mu$, the right side as printed $\\mu+\\tfrac23\\alpha$."},
      {"7.1-excess",
       3805,
       "full elimination costs [n(n-1)/6][(2 mu + alpha) n - mu] more",
       "the count, six times",
       [](const Counts& c) { return 6 * excess(c); },
       {"n(n-1)[(2 mu + alpha) n - mu]", [](double n) { return six_times(n, n * entry - mu); }},
       {"n(n-1)[(2 mu + alpha) n + 2 mu - 2 alpha]",
        [](double n) { return six_times(n, n * entry + 2 * mu - 2 * alpha); }},
       {"n(n-1)[(2 mu + alpha) n + mu - 2 alpha]",
        [](double n) { return six_times(n, n * entry + mu - 2 * alpha); }},
       "The multiplied diagonal entries add $\\mu\\,n(n-1)/2$, and the factoring loses $2\\alpha$. For $n=3$ "
       "the excess is $8\\mu+\\alpha$, not $5\\mu+3\\alpha$."},
  };
}

// ---- which costs more -------------------------------------------------------------------------------------

/// Six times the excess at a real n: the cubic through the counts at n = 1, 2, 3, 4 by Newton;
/// exact for dyadic n.
Cost six_excess(const Table& table, double n) {
  Cost d[4];
  for (std::size_t i = 0; i < 4; ++i) d[i] = excess(table[table.size() - 1 - i]);
  for (int order = 1; order < 4; ++order)
    for (int i = 3; i >= order; --i) d[i] = d[i] - d[i - 1];
  return 6 * d[0] + (n - 1) * (6 * d[1] + (n - 2) * (3 * d[2] + (n - 3) * d[3]));
}

double paid(Cost c, double m, double a) { return c.mu * m + c.alpha * a; }

/// Prices of 1 to 12 each, and n in eighths above 1: how many violate.
Check at_prices(std::string what, const auto& violates) {
  long violations = 0, samples = 0;
  std::string where;
  for (double m = 1; m <= 12; ++m)
    for (double a = 1; a <= 12; ++a)
      for (double n = 1.125; n <= 6; n += 0.125) {
        ++samples;
        if (!violates(n, m, a)) continue;
        if (violations++ == 0)
          where = "mu = " + shortest(m) + ", alpha = " + shortest(a) + ", n = " + shortest(n);
      }
  return never(std::move(what), violations, samples, where);
}

Check at_sizes(std::string what, const Table& table, double least, const auto& violates) {
  long violations = 0, samples = 0;
  for (const Counts& c : table)
    if (c.n >= least) ++samples, violations += violates(c);
  return never(std::move(what), violations, samples, "n = " + shortest(least) + " to 200");
}

std::vector<Claim> comparisons(const Table& t) {
  Claim positive{"7.1-factor_positive", 3807, "n(n-1)/6 is positive for n > 1"};
  const auto not_positive = [](const Counts& c) { return !(c.n * (c.n - 1) / 6 > 0); };
  positive.printed = {"n > 1", {at_sizes("n with n(n-1)/6 not positive", t, 2, not_positive)}};
  positive.near_misses = {{"n >= 1", {at_sizes("n with n(n-1)/6 not positive", t, 1, not_positive)}}};

  Claim threshold{"7.1-threshold", 3807, "C' >= C when n >= mu/(2 mu + alpha)"};
  const auto holds = [&](double n, double m, double a) { return paid(six_excess(t, n), m, a) >= 0; };
  threshold.printed = {
      "n >= mu/(2 mu + alpha) is enough, n > 1",
      {at_prices("prices and n >= mu/(2 mu + alpha) with C' < C",
                 [&](double n, double m, double a) { return n * (2 * m + a) >= m && !holds(n, m, a); })}};
  threshold.corrected = {
      "exactly when n >= 2 (alpha - mu)/(2 mu + alpha), n > 1",
      {at_prices("prices and n that this judges wrongly", [&](double n, double m, double a) {
        return (n * (2 * m + a) >= 2 * (a - m)) != holds(n, m, a);
      })}};
  threshold.near_misses = {
      {"exactly when n >= (alpha - mu)/(2 mu + alpha)",
       {at_prices("prices and n that this judges wrongly", [&](double n, double m, double a) {
         return (n * (2 * m + a) >= a - m) != holds(n, m, a);
       })}}};
  threshold.why =
      "The bracket is $(2\\mu+\\alpha)n-\\mu-2\\alpha$ by the printed totals and "
      "$(2\\mu+\\alpha)n+2\\mu-2\\alpha$ by the count. With $\\mu=1$, $\\alpha=12$ the latter is negative up "
      "to $n=11/7$, and not only up to $1/14$. Its zero is below 2 for all prices, so that no whole $n>1$ is "
      "affected.";

  Claim half{"7.1-half", 3807, "mu/(2 mu + alpha) is smaller than 1/2"};
  half.printed = {"< 1/2",
                  {at_prices("prices with mu/(2 mu + alpha) of 1/2 or more",
                             [](double, double m, double a) { return !(2 * m < 2 * m + a); })}};
  half.near_misses = {{"< 1/3",
                       {at_prices("prices with mu/(2 mu + alpha) of 1/3 or more",
                                  [](double, double m, double a) { return !(3 * m < 2 * m + a); })}}};

  Claim always{"7.1-all_n", 3807, "C' >= C for all n >= 1"};
  always.printed = {"coefficient by coefficient: whatever the prices",
                    {at_sizes("n with C' < C at some prices", t, 1, [](const Counts& c) {
                      return excess(c).mu < 0 || excess(c).alpha < 0 || excess(c).delta < 0;
                    })}};
  always.near_misses = {{"C' > C for all n >= 1", {at_sizes("n without C' > C", t, 1, [](const Counts& c) {
                           return !(excess(c).mu > 0);
                         })}}};

  Claim cheaper{"7.1-cheaper", 3807, "forward elimination, not full elimination, keeps the costs down"};
  cheaper.printed = {"fewer multiplications and no more additions and divisions, n > 1",
                     {at_sizes("n for which forward does not cost less", t, 2, [](const Counts& c) {
                       return !(excess(c).mu > 0 && excess(c).alpha >= 0 && excess(c).delta >= 0);
                     })}};
  cheaper.near_misses = {{"fewer additions as well",
                          {at_sizes("n without fewer additions", t, 2,
                                    [](const Counts& c) { return !(excess(c).alpha > 0); })}}};
  return {positive, threshold, half, always, cheaper};
}

Claim diagonal_claim(const Random& random) {
  Claim claim{"7.1-diagonal", 3793,
              "full elimination leaves a diagonal matrix, and dividing by it solves the system"};
  claim.printed = {"all entries off the diagonal are zero",
                   {off_diagonal("entries off the diagonal", true, random),
                    unsolved("equations solved", Diagonal::row_by_row, random)}};
  claim.near_misses = {
      {"after forward elimination", {off_diagonal("entries off the diagonal", false, random)}},
      {"the diagonal entries above left as they were",
       {unsolved("equations solved", Diagonal::never, random)}}};
  return claim;
}

Claim pivot_claim(const Random& random) {
  const auto reading = [&](const char* text, Exchange exchange) {
    return Reading{
        text, {unsolved_without_pivot("systems with a zero pivot that are not solved", exchange, random)}};
  };
  Claim claim{"7.1-zero_pivot", 3793,
              "a system that has one solution can be divided by its diagonal entries"};
  claim.printed = reading("the rows as they stand", Exchange::never);
  claim.corrected = reading("rows exchanged where a pivot is zero", Exchange::always);
  claim.near_misses = {reading("the first row alone exchanged", Exchange::at_the_first)};
  claim.why =
      "Where a pivot is zero, crosswise clearing multiplies the other rows by it, and the diagonal entries "
      "that are divided by at the end are 0: $x_2=2$, $x_1=3$, written as two rows in this order, ends in "
      "$0/0$. An exchange with a lower row cures it and costs no arithmetic, so that the totals stand. The "
      "solution has none, for forward elimination neither.";
  return claim;
}

Findings study(const Parameters& p, const Reference&) {
  const Random random(p["seed"]);
  const Table table = counted_sizes();
  std::vector<Claim> claims;
  for (const Law& law : laws()) claims.push_back(claim(table, law));
  claims.push_back(diagonal_claim(random));
  claims.push_back(pivot_claim(random));
  for (Claim& claim : comparisons(table)) claims.push_back(std::move(claim));
  Quantity large = solution("larger_system", random_system(static_cast<std::size_t>(p["N"]), random), true);
  large.add(Breakdown{
      "Crosswise clearing never divides, and so squares the size of the entries column by column: after a "
      "dozen columns they are out of the range of a double. Division by the pivot keeps their size.",
      "crosswise, forward and back", 53, Outcome::non_finite, "pivoted, LU, rows exchanged", 0});
  return {claims,
          {solution("system", random_system(static_cast<std::size_t>(p["n"]), random), false), large}};
}

}  // namespace ex07_01

Exercise exercise_7_1() {
  using namespace ex07_01;
  return {"Forward and full elimination",
          "An augmented $n\\times(n+1)$ matrix is made diagonal by clearing every column below *and above* "
          "its pivot. How many multiplications ($\\mu$), additions ($\\alpha$) and divisions ($\\delta$) is "
          "that, and is it ever cheaper than forward elimination with back substitution?",
          parameters,
          {},
          study};
}

}  // namespace oddity
