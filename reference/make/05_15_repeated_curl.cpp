#include <map>

#include "reference/make/fields.hpp"

// F(x) = p sin(k.x + 1/2) + q exp(l.x), with wave vectors k and l proportional to w. The first route is the
// closed form: a curl turns p sin into (k x p) cos. The second expands F about x as a power series in three
// variables and differentiates its coefficients.
namespace oddity::truth {

namespace repeated_curl_05_15 {

const Triple<Number> p{1, -2, Number(1) / 2}, q{Number(3) / 4, 1, -1};
const Triple<Number> k{2, 1, -1}, l{Number(1) / 2, -1, Number(1) / 4};

Number dot(const Triple<Number>& a, const Triple<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Triple<Number> scaled(const Number& s, const Triple<Number>& a) { return {s * a[0], s * a[1], s * a[2]}; }

Numbers by_waves(const std::vector<double>& in, int) {
  const Triple<Number> wk = scaled(in[0], k), wl = scaled(in[0], l),
                       x{Number(in[1]), Number(in[2]), Number(in[3])};
  Triple<Number> a = p, b = q;
  for (int n = 0; n < static_cast<int>(in[4]); ++n) a = cross(wk, a), b = cross(wl, b);
  const Number wave = sin(dot(wk, x) + Number(1) / 2 + in[4] * pi() / 2), growth = exp(dot(wl, x));
  return {a[0] * wave + b[0] * growth, a[1] * wave + b[1] * growth, a[2] * wave + b[2] * growth};
}

/// A polynomial in the displacement from x: its coefficients by the powers of the three coordinates.
using Powers = std::array<int, 3>;
using Series = std::map<Powers, Number>;

/// sum_m derivatives[m] (v.d)^m / m!, the expansion of a function of v.x.
Series expanded(const Numbers& derivatives, const Triple<Number>& v) {
  Series sum, power{{{0, 0, 0}, 1}};
  for (std::size_t m = 0; m < derivatives.size(); ++m) {
    for (const auto& [at, c] : power) sum[at] += derivatives[m] * c;
    Series next;
    for (const auto& [at, c] : power)
      for (std::size_t j = 0; j < 3; ++j) {
        Powers raised = at;
        ++raised[j];
        next[raised] += c * v[j] / static_cast<int>(m + 1);
      }
    power = std::move(next);
  }
  return sum;
}

Series slope(const Series& f, std::size_t j) {
  Series result;
  for (const auto& [at, c] : f)
    if (at[j] > 0) {
      Powers lowered = at;
      --lowered[j];
      result[lowered] = c * at[j];
    }
  return result;
}

Series difference(Series a, const Series& b) {
  for (const auto& [at, c] : b) a[at] -= c;
  return a;
}

Numbers by_series(const std::vector<double>& in, int) {
  const int n = static_cast<int>(in[4]);
  const Triple<Number> wk = scaled(in[0], k), wl = scaled(in[0], l),
                       x{Number(in[1]), Number(in[2]), Number(in[3])};
  const Number phase = dot(wk, x) + Number(1) / 2;
  Numbers waves, growths;
  for (int m = 0; m <= n; ++m) {
    const Number value = m % 2 == 0 ? sin(phase) : cos(phase);
    waves.push_back(m % 4 < 2 ? value : Number(-value));
    growths.push_back(exp(dot(wl, x)));
  }
  const Series wave = expanded(waves, wk), growth = expanded(growths, wl);
  std::array<Series, 3> f;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const auto& [at, c] : wave) f[i][at] += p[i] * c;
    for (const auto& [at, c] : growth) f[i][at] += q[i] * c;
  }
  for (int m = 0; m < n; ++m)
    f = {difference(slope(f[2], 1), slope(f[1], 2)), difference(slope(f[0], 2), slope(f[2], 0)),
         difference(slope(f[1], 0), slope(f[0], 1))};
  return {f[0][{0, 0, 0}], f[1][{0, 0, 0}], f[2][{0, 0, 0}]};
}

}  // namespace repeated_curl_05_15

Truth truth_05_15_repeated_curl() {
  using namespace repeated_curl_05_15;
  std::vector<std::vector<double>> rows;
  for (std::vector<double> row : field_rows())
    for (double n : {1, 2, 3, 4}) {
      rows.push_back(row);
      rows.back().push_back(n);
    }
  return {"the curl taken n times of F(x) = p sin(k.x + 1/2) + q exp(l.x)",
          "p = (1, -2, 1/2), q = (3/4, 1, -1), k = w (2, 1, -1), l = w (1/2, -1, 1/4)",
          {"w", "x0", "x1", "x2", "n"},
          {{"c0", "1/m^n"}, {"c1", "1/m^n"}, {"c2", "1/m^n"}},
          rows,
          "closed form: (k x)^n p sin(k.x + 1/2 + n pi/2) + (l x)^n q exp(l.x)",
          by_waves,
          "curls of the power series about x, in three variables",
          by_series,
          "the first route",
          by_waves};
}

}  // namespace oddity::truth
