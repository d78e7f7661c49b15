#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "reference/bad_input.hpp"
#include "reference/reference.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity::ex07_01 {

namespace {

struct System {
  Rows<double> rows;
  std::vector<double> x;
};

/// Entries in 64ths from -1 to 1 and a solution of single digits, so the right-hand side is exact.
System random_system(std::size_t n, Random random) {
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

/// Multiplications and divisions are counted beforehand, so that only the bare arithmetic is timed.
Method elimination_method(std::string model, std::string algorithm, const Rows<double>& rows,
                          const auto& solve, Outcome expected = Outcome::ok, std::string why = {}) {
  const auto numbers = rows_of<Counted<double>>(rows, [](double x) { return x; });
  const long work = operations_of([&] { return solve(numbers); }).all_but_additions();
  const auto single = rows_of<float>(rows, [](double x) { return static_cast<float>(x); });
  return {std::move(model),
          std::move(algorithm),
          {"significant bits", {24, 53}},
          [=](double bits) {
            return Answer{bits < 53 ? Value(solve(single)) : Value(solve(rows)), work};
          },
          expected,
          std::move(why)};
}

/// Adds every elimination of the rows.
void add_methods(Quantity& q, const Rows<double>& s, bool large) {
  const Outcome crosswise = large ? Outcome::non_finite : Outcome::ok;
  const std::string squares =
      large ? "each column squares the size of the numbers: they underflow to $0/0$" : "";
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
  const auto size = static_cast<Eigen::Index>(s.size());
  Eigen::MatrixXd a(size, size);
  Eigen::VectorXd b(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& row = s[static_cast<std::size_t>(i)];
    a.row(i) = Eigen::Map<const Eigen::VectorXd>(row.data(), size);
    b[i] = row.back();
  }
  q.add({"pivoted", "LU, rows exchanged", no_resolution(),
         [=](double) { return answer(solve(Factorization::partial_pivot_lu, a, b)); }});
  q.add({"pivoted", "LU, rows and columns exchanged", no_resolution(),
         [=](double) { return answer(solve(Factorization::full_pivot_lu, a, b)); }});
}

/// The determinant of three columns, as that of a 4 x 4 matrix with a one in its last corner.
double determinant_of(const Rows<double>& columns, const Reference& truth) {
  std::vector<double> entries;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) entries.push_back(i < 3 && j < 3 ? columns[j][i] : i == j);
  return truth("07_09_determinant", entries).value[0];
}

}  // namespace

Quantity solution(const std::string& name, std::size_t n, bool large, const Random& random) {
  const System s = random_system(n, random);
  Quantity q{name,
             "",
             "the solution of a random system of " + std::to_string(n) + " equations",
             {"planted: whole numbers, the right-hand side exact", s.x},
             0,
             {1e-9, "nine decimals"},
             {},
             {}};
  add_methods(q, s.rows, large);
  return q;
}

/// The reference is Cramer's rule, whose determinants do not use elimination of these rows.
Quantity own_solution(const Parameters& p, const Reference& truth) {
  Rows<double> rows(3), columns(4);
  for (std::size_t i = 0; i < entries_of_own.size(); ++i) {
    rows[i / 4].push_back(p[entries_of_own[i]]);
    columns[i % 4].push_back(p[entries_of_own[i]]);
  }
  const double all = determinant_of(columns, truth);
  if (all == 0)
    throw BadInput("the equations of a11 to a34 have no single solution: their determinant is zero");
  std::vector<double> x;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Rows<double> replaced = columns;
    replaced[k] = columns[3];
    x.push_back(determinant_of(replaced, truth) / all);
    largest = std::max(largest, std::abs(x.back()));
  }
  const double size = largest > 0 ? largest : 1;
  Quantity q{"own_system",
             "",
             "the solution of the three equations of a11 to a34, the right-hand side in the last column",
             {"Cramer's rule, by determinants to 24 digits", x},
             4 * std::numeric_limits<double>::epsilon() * size,
             {1e-9 * size, "nine digits of the largest"},
             {},
             {}};
  add_methods(q, rows, false);
  return q;
}

}  // namespace oddity::ex07_01
