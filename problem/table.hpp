#pragma once

#include <array>
#include <string>
#include <vector>

#include "problem/measure.hpp"

/// Tabulated drives or forces, with a spline through their rows.
namespace oddity::problem {

enum class Spline {
  linear,
  cubic,     ///< natural: its second derivative is continuous, and zero at the ends
  monotone,  ///< Steffen's: its first derivative is continuous, and it adds no extrema
};

/// y(x), both in base units: from each knot on a polynomial in x less the knot.
struct Table {
  struct Piece {
    double from;
    std::array<double, 4> powers;
  };

  std::string name;
  Measure x, y;
  bool holds = false;  ///< constant outside its rows; otherwise undefined there
  std::vector<Piece> pieces = {};
  double last = 0;

  double first() const { return pieces.front().from; }
  /// Whether x is within its rows, up to roundings.
  bool knows(long double at) const {
    const long double little = 1e-9L * (last - first());
    return at >= first() - little && at <= last + little;
  }
};

constexpr std::size_t most_rows = 200;

/// The polynomials through (x, y), at least fewest_rows() of them. x ascends.
std::vector<Table::Piece> pieces_of(Spline, const std::vector<double>& x, const std::vector<double>& y);
/// The fewest rows for this spline.
std::size_t fewest_rows(Spline);

/// The value at x. T is a number type that supports choices.
template <class T>
T value_at(const Table& table, const T& x) {
  constexpr double little = 1e-9;
  const double span = table.last - table.first();
  // Constant beyond either end; a start at the first row is inside.
  std::vector<Table::Piece> pieces{{table.first(), {table.pieces.front().powers[0], 0, 0, 0}}};
  pieces.insert(pieces.end(), table.pieces.begin(), table.pieces.end());
  const Table::Piece& end = table.pieces.back();
  const double h = table.last - end.from;
  const auto& p = end.powers;
  pieces.push_back({table.last, {p[0] + h * (p[1] + h * (p[2] + h * p[3])), 0, 0, 0}});
  const auto begins = [&](std::size_t i) {
    return pieces[i].from + (i == 1 ? -little * span : i + 1 == pieces.size() ? little * span : 0);
  };
  // Chooses coefficients, by halves, and not polynomials, so that the slopes contain no choices.
  struct Chosen {
    T from;
    std::array<T, 4> powers;
  };
  const auto chosen = [&](const auto& self, std::size_t low, std::size_t high) -> Chosen {
    if (high - low == 1) {
      const auto& [from, powers] = pieces[low];
      return {T(from), {T(powers[0]), T(powers[1]), T(powers[2]), T(powers[3])}};
    }
    const std::size_t middle = (low + high) / 2;
    const Chosen below = self(self, low, middle), above = self(self, middle, high);
    const T beyond = x - T(begins(middle));
    Chosen both{choose_by(beyond, above.from, below.from), {}};
    for (std::size_t k = 0; k < 4; ++k) both.powers[k] = choose_by(beyond, above.powers[k], below.powers[k]);
    return both;
  };
  const Chosen at = chosen(chosen, 0, pieces.size());
  const T s = x - at.from;
  return at.powers[0] + s * (at.powers[1] + s * (at.powers[2] + s * at.powers[3]));
}

}  // namespace oddity::problem
