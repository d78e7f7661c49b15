#include "report/pages/text_view.hpp"

#include <cmath>
#include <regex>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/study/findings.hpp"
#include "report/text/readable.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

std::string as_sentence(std::string says) {
  if (!says.ends_with('.')) says += '.';
  return says;
}

Style style_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return Style::good;
    case Verdict::misprint:
    case Verdict::incomplete:
      return Style::doubtful;
    case Verdict::lost:
    case Verdict::not_checkable:
      return Style::aside;
    default:
      return Style::bad;
  }
}

namespace {

/// Short enough for a narrow column.
std::string short_name_of(Verdict verdict) {
  return verdict == Verdict::lost ? "lost" : std::string(name_of(verdict));
}

std::string claims_text(const ExerciseResult& e, const Screen& screen) {
  std::vector<std::vector<std::string>> rows{{"claim", "verdict", "the solution says"}};
  for (const JudgedClaim& c : e.claims)
    rows.push_back(
        {c.claim.id, screen.styled(style_of(c.verdict), short_name_of(c.verdict)), readable(c.claim.says)});
  return rows.size() == 1 ? "" : "\n" + aligned(rows, screen, {{"the solution says", "claim"}, {}});
}

/// Marks in the style's colour, or brackets that no formula contains.
formula::Marks marks(const Screen& screen, Style style) {
  if (!screen.colour) return {"⟦", "⟧"};
  const std::string styled = screen.styled(style, "|");
  const std::size_t bar = styled.find('|');
  return {styled.substr(0, bar), styled.substr(bar + 1)};
}

/// Printed and right formulas of errata and misprints, with their differences marked.
std::string differences_text(const ExerciseResult& e, const Screen& screen) {
  std::string text;
  for (const JudgedClaim& c : e.claims) {
    if (!is_erratum(c.verdict) && c.verdict != Verdict::misprint) continue;
    const auto both = formulas_that_differ(c.claim.printed.text, right_reading(c).text,
                                           marks(screen, Style::bad), marks(screen, Style::good));
    if (both)
      text += "\n  " + c.claim.id + "\n" + wrapped("    printed  " + both->first + "\n", screen, 13) +
              wrapped("    right    " + both->second + "\n", screen, 13);
  }
  return text;
}

const std::vector<std::string> trial_columns{"model", "algorithm", "resolution", "value",
                                             "error", "evals",     "time",       "outcome"};
const Fitting trial_fit{{"model", "algorithm", "outcome"}, {"value", "evals", "time", "resolution"}, true};

std::vector<std::string> trial_row(const TimedTrial& t, const Screen& screen) {
  return {t.model,
          t.algorithm,
          shown_resolution(t),
          shown(t.value),
          shown_error(t.error),
          std::to_string(t.evaluations),
          shown_time(t.time.seconds),
          shown(t.outcome, screen) + (t.message.empty() ? "" : ": " + t.message)};
}

/// A row per trial of the methods.
std::string trials_text(const auto& methods, const Screen& screen) {
  std::vector<std::vector<std::string>> rows{trial_columns};
  for (const auto& m : methods)
    for (const TimedTrial& t : m.trials) rows.push_back(trial_row(t, screen));
  return aligned(rows, screen, trial_fit);
}

std::string with_unit(const std::string& unit) { return unit.empty() || unit == "1" ? "" : " " + unit; }

std::string reference_text(const QuantityResult& q) {
  if (!finite(q.reference.value))
    return "none: " + readable(q.reference.by) +
           "\n  so no error is known, and no outcome below means anything";
  return shown(q.reference.value, 17) + with_unit(q.unit) + " +- " + shown_error(q.reference_error) + " (" +
         readable(q.reference.by) + ")";
}

std::string quantity_text(const QuantityResult& q, const Screen& screen) {
  std::string text =
      "\n" +
      wrapped(screen.styled(Style::heading, q.name) + ": " + readable(q.says) + "\n  reference " +
                  reference_text(q) + "\n  needed to " + shown_error(q.need.allowed) + " (" +
                  readable(q.need.reason) + ")" + (q.samples > 1 ? ", " + instants(q) : "") + "\n",
              screen, 4) +
      trials_text(q.methods, screen);
  if (!q.in_float.empty()) text += "  in float\n" + trials_text(q.in_float, screen);
  for (const BreakdownResult& b : q.breakdowns)
    text +=
        wrapped("  " + std::string(b.as_expected() ? "breaks: " : "does not break so here: ") +
                    readable(b.says) + "\n",
                screen, 4) +
        aligned({trial_columns, trial_row(b.broken, screen), trial_row(b.cured, screen)}, screen, trial_fit);
  return text;
}

}  // namespace

std::string with_short_numbers(const std::string& text) {
  static const std::regex number(R"((\d+\.\d+)(e[-+]?\d+)?)");
  std::string out;
  auto from = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    out.append(from, text.begin() + found->position());
    const std::string digits = found->str(), significand = found->str(1);
    const auto value = parse_number(digits);
    out += value && significand.size() > 10 ? format_significant(*value, 6) : digits;
    from = text.begin() + found->position() + found->length();
  }
  return out.append(from, text.end());
}

std::string instants(const QuantityResult& q) {
  return q.samples > 1 ? "judged at these " + std::to_string(q.samples) + " times alone" : "";
}

std::string shown(Outcome outcome, const Screen& screen) {
  const Style style = outcome == Outcome::ok           ? Style::good
                      : outcome == Outcome::inaccurate ? Style::doubtful
                                                       : Style::bad;
  return screen.styled(style, std::string(name_of(outcome)));
}

std::string heading_of(const ExerciseResult& e, const Screen& screen) {
  return wrapped(screen.styled(Style::heading, "Exercise " + to_string(e.number) + ": " + e.title) + "\n",
                 screen, 2);
}

std::string text_view(const ExerciseResult& e, const Screen& screen) {
  std::string text = heading_of(e, screen);
  for (const ParameterValue& p : e.parameters)
    text += wrapped(
        "  " + p.name + " = " + format_shortest(p.value) + with_unit(p.unit) + "  " + readable(p.says) + "\n",
        screen, 6);
  if (!e.failure.empty()) text += "  " + screen.styled(Style::bad, "FAILED") + ": " + e.failure + "\n";
  text += claims_text(e, screen) + differences_text(e, screen);
  for (const QuantityResult& q : e.quantities) text += quantity_text(q, screen);
  return text;
}

}  // namespace oddity
