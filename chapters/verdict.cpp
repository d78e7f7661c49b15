#include "chapters/exercise.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/text.hpp"

namespace oddity {

// ---- values -----------------------------------------------------------------------------------------------

bool finite(const Value& value) {
  return value.size() > 0 &&
         std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
}

double size_of(const Value& value) {
  double size = 0;
  for (double x : value) {
    if (std::isnan(x)) return x;
    size = std::max(size, std::abs(x));
  }
  return size;
}

double distance(const Value& a, const Value& b) {
  if (a.size() != b.size() || a.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(a[i] - b[i]);
    if (std::isnan(difference)) return difference;
    largest = std::max(largest, difference);
  }
  return largest;
}

// ---- claims -----------------------------------------------------------------------------------------------

Tolerance exact() { return {0, "exact"}; }

Tolerance printed_decimals(int decimals) {
  return {0.5 * std::pow(10.0, -decimals),
          "half a unit of decimal " + std::to_string(decimals) + ", the last one printed"};
}

Tolerance rounding(double scale, double ulps) {
  return {ulps * std::numeric_limits<double>::epsilon() * scale,
          format_significant(ulps, 4) + " roundings of terms of size " + format_significant(scale, 3)};
}

bool Check::holds() const {
  return finite(left.value) && finite(right.value) && difference() <= tolerance.allowed;
}

Check no_violations(std::string what, long violations, long samples, std::string where) {
  return {std::move(what),
          {"violations in " + std::to_string(samples) + (samples == 1 ? " sample" : " samples"),
           static_cast<double>(samples > 0 ? violations : -1)},
          {"none", 0.0},
          exact(),
          1,
          std::move(where)};
}

bool is_worse(double tolerances, double than) {
  constexpr double same = 1e-6;
  return tolerances > than + same * std::abs(than) || (tolerances > 1 && than <= 1);
}

WorstSample::WorstSample(std::string quantity, std::string left, std::string right, double ulps)
    : worst_{std::move(quantity), {std::move(left), {}}, {std::move(right), {}}, {}, 0, {}}, ulps_(ulps) {}

void WorstSample::add(const Value& left, const Value& right, double scale, const std::string& where) {
  add(left, right, rounding(scale, ulps_), scale, where);
}

void WorstSample::add(const Value& left, const Value& right, const Tolerance& tolerance, double scale,
                      const std::string& where) {
  ++samples_;
  const double difference = distance(left, right);
  const double infinity = std::numeric_limits<double>::infinity();
  const double ratio = std::isnan(difference)   ? infinity
                       : difference == 0        ? 0
                       : tolerance.allowed == 0 ? infinity
                                                : difference / tolerance.allowed;
  if (!is_worse(ratio, ratio_)) return;
  ratio_ = ratio;
  worst_.left.value = left;
  worst_.right.value = right;
  worst_.tolerance = tolerance;
  worst_.scale = scale;
  worst_.where = where;
}

Check WorstSample::check() const {
  Check check = worst_;
  check.where = "worst of " + std::to_string(samples_) + (check.where.empty() ? "" : ": " + check.where);
  return check;
}

bool Reading::holds() const {
  return !checks.empty() && std::ranges::all_of(checks, [](const Check& check) { return check.holds(); });
}

namespace {

bool has_readings(const Claim& claim) {
  return !claim.near_misses.empty() ||
         std::ranges::any_of(std::array{&claim.printed, &claim.meant, &claim.corrected},
                             [](const Reading* r) { return !r->text.empty() || !r->checks.empty(); });
}

/// Without checks of the author's view, the kind of the fault decides.
bool holds_in_view(const Claim& claim) {
  return claim.in_view.checks.empty() ? claim.kind == Fault::left_out : claim.in_view.holds();
}

}  // namespace

Verdict verdict(const Claim& claim) {
  if (!claim.not_checkable.empty()) return has_readings(claim) ? Verdict::unsettled : Verdict::not_checkable;
  if (std::ranges::any_of(claim.near_misses, [](const Reading& near) { return near.holds(); }))
    return Verdict::unsettled;
  if (claim.printed.holds()) return Verdict::confirmed;
  if (claim.meant.holds()) return claim.kind == Fault::lost_typography ? Verdict::lost : Verdict::misprint;
  if (claim.corrected.holds()) return holds_in_view(claim) ? Verdict::incomplete : Verdict::wrong;
  return Verdict::unsettled;
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::misprint:
      return "misprint";
    case Verdict::lost:
      return "lost in our copy";
    case Verdict::incomplete:
      return "incomplete";
    case Verdict::wrong:
      return "wrong";
    case Verdict::not_checkable:
      return "not checkable";
    case Verdict::unsettled:
      return "unsettled";
  }
  return "?";
}

std::string_view name_of(Fault kind) {
  switch (kind) {
    case Fault::none:
      return "";
    case Fault::number:
      return "number";
    case Fault::formula:
      return "formula";
    case Fault::left_out:
      return "case left out";
    case Fault::counterexample:
      return "statement with a counterexample";
    case Fault::term:
      return "term";
    case Fault::listing:
      return "listing";
    case Fault::lost_typography:
      return "typography lost on the way";
  }
  return "?";
}

}  // namespace oddity
