#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chapters/07_linear_algebra/01_cost_of_elimination/elimination.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/residue.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "solvers/linear.hpp"

/// Random systems: eliminations checked modulo a prime, and as the methods of a quantity.
namespace oddity::elimination {

/// Elimination by whole rows modulo a prime: how many entries off the diagonal are left in systems of 2
/// to 12.
inline Check off_diagonal(std::string what, bool above, Random random) {
  long left = 0, samples = 0;
  for (std::size_t n = 2; n <= 12; ++n) {
    auto m = random_rows(n, [&] { return Residue{random.bits() % Residue::prime}; });
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t row = above ? 0 : k + 1; row < n; ++row) {
        if (row == k) continue;
        const Residue pivot = m[k][k], factor = m[row][k];
        for (std::size_t j = 0; j <= n; ++j) m[row][j] = pivot * m[row][j] - factor * m[k][j];
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (i != j) ++samples, left += m[i][j].value != 0;
  }
  return never(std::move(what), left, samples, "n = 2 to 12, modulo 2^31 - 1");
}

/// Full elimination and division modulo a prime: how many equations of systems of 2 to 12 are not solved.
inline Check unsolved(std::string what, Diagonal diagonal, Random random) {
  long violations = 0, samples = 0;
  for (std::size_t n = 2; n <= 12; ++n) {
    const auto m = random_rows(n, [&] { return Residue{random.bits() % Residue::prime}; });
    const auto x = solve_full(m, Clearing::crosswise, diagonal);
    for (const auto& row : m) {
      Residue sum{0};
      for (std::size_t j = 0; j < n; ++j) sum = sum + row[j] * x[j];
      ++samples, violations += sum.value != row[n].value;
    }
  }
  return never(std::move(what), violations, samples, "n = 2 to 12, modulo 2^31 - 1");
}

/// Where rows are exchanged for a pivot that is zero.
enum class Exchange { never, at_the_first, always };

/// The same for systems whose first or second pivot is zero, as long as their rows stay where they are.
inline Check unsolved_without_pivot(std::string what, Exchange exchange, Random random) {
  long violations = 0, samples = 0;
  for (std::size_t n = 2; n <= 12; ++n) {
    auto m = random_rows(n, [&] { return Residue{random.bits() % Residue::prime}; });
    if (n % 2 == 0) m[0][0] = Residue{0};
    for (std::size_t j = 0; n % 2 != 0 && j < 2; ++j) m[1][j] = m[0][j] + m[0][j];
    auto rows = m;
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t pivot = k;
      if (exchange == Exchange::always || (exchange == Exchange::at_the_first && k == 0))
        while (rows[pivot][k].value == 0 && pivot + 1 < n) ++pivot;
      std::swap(rows[k], rows[pivot]);
      full_step(rows, k);
    }
    bool solved = true;
    for (std::size_t i = 0; i < n; ++i) solved = solved && rows[i][i].value != 0;
    if (solved) {
      const auto x = divide(rows);
      for (const auto& row : m) {
        Residue sum{0};
        for (std::size_t j = 0; j < n; ++j) sum = sum + row[j] * x[j];
        solved = solved && sum.value == row[n].value;
      }
    }
    ++samples, violations += !solved;
  }
  return never(std::move(what), violations, samples, "n = 2 to 12, modulo 2^31 - 1");
}

struct System {
  Rows<double> rows;
  std::vector<double> x;
};

/// Entries in 64ths from -1 to 1 and a solution of digits: the right-hand side is exact.
inline System random_system(std::size_t n, Random random) {
  System s{random_rows(n, [&] { return (random.below(129) - 64) / 64.0; }), {}};
  for (std::size_t i = 0; i < n; ++i) s.x.push_back(1 + random.below(9));
  for (auto& row : s.rows) {
    row[n] = 0;
    for (std::size_t j = 0; j < n; ++j) row[n] += row[j] * s.x[j];
  }
  return s;
}

template <class T, class From>
Rows<T> rows_of(const Rows<From>& rows, const auto& number) {
  Rows<T> all;
  for (const auto& row : rows) {
    all.emplace_back();
    for (const From& x : row) all.back().push_back(number(x));
  }
  return all;
}

/// Multiplications and divisions counted beforehand, so that what is timed is the bare arithmetic.
Method elimination_method(std::string model, std::string algorithm, const System& s, const auto& solve,
                          Outcome expected = Outcome::ok, std::string why = {}) {
  const auto numbers = rows_of<Counted<double>>(s.rows, [](double x) { return x; });
  const long work = operations_of([&] { return solve(numbers); }).all_but_additions();
  const auto single = rows_of<float>(s.rows, [](double x) { return static_cast<float>(x); });
  return {std::move(model),
          std::move(algorithm),
          {"significant bits", {24, 53}},
          [=, rows = s.rows](double bits) {
            return Answer{bits < 53 ? Value(solve(single)) : Value(solve(rows)), work};
          },
          expected,
          std::move(why)};
}

/// The system solved by every elimination; in a `large` one the numbers of crosswise clearing leave their
/// range.
inline Quantity solution(std::string name, const System& s, bool large) {
  const std::size_t n = s.rows.size();
  Quantity q{std::move(name),
             "",
             "the solution of a random system of " + std::to_string(n) + " equations",
             {"planted: whole numbers, the right-hand side exact", s.x},
             0,
             {1e-9, "nine decimals"},
             {},
             {}};
  const Outcome crosswise = large ? Outcome::non_finite : Outcome::ok;
  const std::string squares =
      large ? "each column squares the size of the numbers: they underflow to 0/0" : "";
  const auto forward = [](Clearing how) { return [how](const auto& m) { return solve_forward(m, how); }; };
  const auto full = [](Clearing how, Diagonal when) {
    return [=](const auto& m) { return solve_full(m, how, when); };
  };
  q.add(elimination_method("crosswise", "forward and back", s, forward(Clearing::crosswise), crosswise,
                           squares));
  q.add(elimination_method("crosswise", "full", s, full(Clearing::crosswise, Diagonal::row_by_row), crosswise,
                           squares));
  q.add(elimination_method("crosswise", "full, diagonal saved up", s,
                           full(Clearing::crosswise, Diagonal::at_the_end), crosswise, squares));
  q.add(elimination_method("crosswise", "full, operations as counted in print", s,
                           full(Clearing::crosswise, Diagonal::never),
                           large ? Outcome::non_finite : Outcome::inaccurate,
                           large ? squares : "the diagonal entries above the pivot are not multiplied"));
  q.add(elimination_method("by ratio", "forward and back", s, forward(Clearing::by_ratio)));
  q.add(elimination_method("by ratio", "full", s, full(Clearing::by_ratio, Diagonal::never)));
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd a(size, size);
  Eigen::VectorXd b(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& row = s.rows[static_cast<std::size_t>(i)];
    a.row(i) = Eigen::Map<const Eigen::VectorXd>(row.data(), size);
    b[i] = row.back();
  }
  q.add({"pivoted", "LU, rows exchanged", no_knob(),
         [=](double) { return answer(solve(Factorization::partial_pivot_lu, a, b)); }});
  q.add({"pivoted", "LU, rows and columns exchanged", no_knob(),
         [=](double) { return answer(solve(Factorization::full_pivot_lu, a, b)); }});
  return q;
}

}  // namespace oddity::elimination
