#include "problem/measure.hpp"

#include <algorithm>

#include "reference/quantity_text.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

constexpr std::array<std::string_view, 6> bases{"m", "s", "kg", "A", "solar mass", "bins"};

Measure combined(const Measure& a, const Measure& b, double power) {
  Measure c;
  for (std::size_t i = 0; i < c.powers.size(); ++i) c.powers[i] = a.powers[i] + power * b.powers[i];
  c.fits_all = a.fits_all || (b.fits_all && power > 0);
  c.span = a.span | b.span;
  return c;
}

bool is_pure(const Measure& x) {
  return x.fits_all || std::ranges::all_of(x.powers, [](double power) { return power == 0; });
}

}  // namespace

std::string name_of(const Measure& measure) {
  for (std::string_view usual : {"N", "N/m", "N s/m", "J", "W", "V", "Ohm", "H", "Pa"})
    if (measure_of(usual)->powers == measure.powers) return std::string(usual);
  std::string above, below;
  int count = 0;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    const double power = measure.powers[i];
    if (power == 0) continue;
    std::string& side = power > 0 ? above : below;
    count += power < 0;
    side += (side.empty() ? "" : " ") + std::string(bases[i]);
    if (std::abs(power) != 1) side += "^" + format_shortest(std::abs(power));
  }
  if (above.empty() && below.empty()) return "a pure number";
  if (below.empty()) return above;
  return (above.empty() ? "1" : above) + "/" + (count > 1 ? "(" + below + ")" : below);
}

std::optional<Measure> measure_of(std::string_view unit) {
  if (unit.empty() || unit == "1") return Measure();
  const auto known = unit_of(unit);
  if (!known) return std::nullopt;
  Measure measure;
  const auto& p = known->powers;
  measure.powers = {double(p[0]), double(p[1]), double(p[2]), double(p[3]), double(p[5]), double(p[6])};
  return measure;
}

bool fit(const Measure& a, const Measure& b) { return a.fits_all || b.fits_all || a.powers == b.powers; }

Measure operator+(const Measure& a, const Measure& b) {
  if (!fit(a, b))
    throw Mismatch(name_of(a) + " and " + name_of(b) + " do not add up", b.span.is_known() ? b.span : a.span);
  Measure sum = a.fits_all ? b : a;
  sum.span = a.span | b.span;
  return sum;
}
Measure operator*(const Measure& a, const Measure& b) { return combined(a, b, 1); }
Measure operator/(const Measure& a, const Measure& b) { return combined(a, b, -1); }
Measure sqrt(const Measure& x) {
  Measure root = x;
  for (double& power : root.powers) power /= 2;
  return root;
}
Measure pure(const Measure& x) {
  if (!is_pure(x)) throw Mismatch("a pure number is expected here, and this is " + name_of(x), x.span);
  Measure one = 1.0;
  one.span = x.span;
  return one;
}

}  // namespace oddity::problem
