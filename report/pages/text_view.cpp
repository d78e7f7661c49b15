#include "report/pages/text_view.hpp"

#include <cmath>
#include <regex>

#include "reference/text.hpp"
#include "report/pages/readable.hpp"

namespace oddity {

namespace {

std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string claim_lines(const ExerciseResult& e) {
  std::vector<std::vector<std::string>> rows;
  for (const JudgedClaim& c : e.claims)
    rows.push_back({c.claim.id, std::string(name_of(c.verdict)), readable(c.claim.says)});
  return rows.empty() ? "" : "\nclaims\n" + aligned(rows);
}

std::vector<std::string> trial_row(const TimedTrial& t) {
  return {t.model,
          t.algorithm,
          shown_knob(t),
          shown(t.value),
          shown_error(t.error),
          std::to_string(t.evaluations),
          shown_time(t.time.seconds),
          std::string(name_of(t.outcome)) + (t.message.empty() ? "" : ": " + t.message)};
}

std::string reference_text(const QuantityResult& q) {
  if (!finite(q.reference.value))
    return "none: " + readable(q.reference.by) +
           "\n  so no error is known, and no outcome below means anything";
  return shown(q.reference.value, 17) + " " + q.unit + " +- " + shown_error(q.reference_error) + " (" +
         readable(q.reference.by) + ")";
}

std::string quantity_text(const QuantityResult& q) {
  std::string text = "\n" + q.name + ": " + readable(q.says) + "\n  reference " + reference_text(q) +
                     "\n  needed to " + shown_error(q.need.allowed) + " (" + readable(q.need.reason) + ")" +
                     (q.samples > 1 ? ", " + instants(q) : "") + "\n";
  std::vector<std::vector<std::string>> rows{
      {"model", "algorithm", "knob", "value", "error", "evals", "time", "outcome"}};
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials) rows.push_back(trial_row(t));
  text += aligned(rows);
  if (!q.in_float.empty()) text += "  in float\n";
  rows.resize(1);
  for (const FloatResult& m : q.in_float)
    for (const TimedTrial& t : m.trials) rows.push_back(trial_row(t));
  if (rows.size() > 1) text += aligned(rows);
  for (const BreakdownResult& b : q.breakdowns)
    text += "  " + std::string(b.as_expected() ? "breaks: " : "does not break so here: ") + readable(b.says) +
            "\n" + aligned({trial_row(b.broken), trial_row(b.cured)});
  return text;
}

}  // namespace

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (widths.size() <= i) widths.push_back(0);
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line += " " + row[i] + (i + 1 < row.size() ? std::string(widths[i] - columns_of(row[i]) + 1, ' ') : "");
    text += line + "\n";
  }
  return text;
}

std::string shown(const Value& value, int digits) {
  constexpr std::size_t most = 4;
  const auto component = [digits](double x) { return std::isnan(x) ? "nan" : rounded(x, digits); };
  if (value.size() == 1) return component(value[0]);
  std::string text = "(";
  for (std::size_t i = 0; i < std::min(value.size(), most); ++i)
    text += (i ? ", " : "") + component(value[i]);
  return text + (value.size() > most ? ", ... " + std::to_string(value.size()) + " in all)" : ")");
}

std::string with_short_numbers(const std::string& text) {
  static const std::regex number(R"((\d+\.\d+)(e[-+]?\d+)?)");
  std::string out;
  auto from = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), none; found != none; ++found) {
    out.append(from, text.begin() + found->position());
    const std::string digits = found->str(), significand = found->str(1);
    const auto value = number_in(digits);
    out += value && significand.size() > 10 ? rounded(*value, 6) : digits;
    from = text.begin() + found->position() + found->length();
  }
  return out.append(from, text.end());
}

std::string shown_error(double error) { return std::isfinite(error) ? rounded(error, 2) : "-"; }

std::string shown_time(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds < 1e-6) return rounded(seconds * 1e9, 3) + " ns";
  if (seconds < 1e-3) return rounded(seconds * 1e6, 3) + " us";
  return seconds < 1 ? rounded(seconds * 1e3, 3) + " ms" : rounded(seconds, 3) + " s";
}

std::string instants(const QuantityResult& q) {
  return q.samples > 1 ? "judged at these " + std::to_string(q.samples) + " times alone" : "";
}

std::string shown_knob(const TimedTrial& t) {
  return t.knob.empty() ? "-" : t.knob + " " + rounded(t.setting, 4);
}

std::string text_view(const ExerciseResult& e) {
  std::string text = "Exercise " + to_string(e.number) + ": " + e.title + "\n";
  for (const ParameterValue& p : e.parameters)
    text += "  " + p.name + " = " + shortest(p.value) + (p.unit.empty() ? "" : " " + p.unit) + "  " +
            readable(p.says) + "\n";
  if (!e.failure.empty()) text += "  FAILED: " + e.failure + "\n";
  text += claim_lines(e);
  for (const QuantityResult& q : e.quantities) text += quantity_text(q);
  return text;
}

}  // namespace oddity
