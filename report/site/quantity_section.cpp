#include "report/site/quantity_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/text.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"
#include "report/site/findings.hpp"
#include "report/site/page.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

using html::element;
using Named = std::vector<std::pair<std::string, std::string>>;

std::string short_error(double error) { return html::escaped(with_powers(shown_error(error))); }

std::string with_unit_of(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "1" ? number : number + " " + html::escaped(unit);
}

/// "step 0.0625", "without a knob" in a page's words.
std::string setting_text(const TimedTrial& t) {
  return t.knob.empty() ? "" : ", " + html::escaped(with_powers(shown_knob(t)));
}

/// Names under the same reason together, in the order in which the reasons come.
void add_under(Named& all, const std::string& reason, const std::string& name) {
  const auto same = std::ranges::find(all, reason, &Named::value_type::first);
  if (same == all.end())
    all.emplace_back(reason, name);
  else
    same->second += "; " + name;
}

std::string no_script(const std::string& quantity, const ExerciseResult& e) {
  return "<noscript><p>The chart and the table of all trials need scripts. As text: <code>oddity solve " +
         to_string(e.number) + "</code> (" + html::escaped(quantity) + ").</p></noscript>";
}

std::string trial_text(const std::string& what, const TimedTrial& t) {
  const std::string play = "<button type=\"button\" class=\"play\" hidden data-model=\"" +
                           html::escaped(t.model) + "\" data-algorithm=\"" + html::escaped(t.algorithm) +
                           "\" data-setting=\"" + html::escaped(shortest(t.setting)) +
                           "\" data-precision=\"" + std::string(name_of(t.precision)) + "\">play</button>";
  return html::row(
      {what, html::escaped(t.model + ", " + t.algorithm) + setting_text(t) + " " + play,
       html::escaped(with_powers(shown(t.value, 7))), short_error(t.error), std::to_string(t.evaluations),
       "<span class=\"outcome " + html::anchor(name_of(t.outcome)) + "\">" + std::string(name_of(t.outcome)) +
           "</span>"},
      "34");
}

std::string breakdown_text_of(const BreakdownResult& b) {
  return "<div class=\"breakdown\">" +
         element("p", "", "<strong>Where it breaks.</strong> " + html::prose(b.says)) +
         html::table({"What breaks, and what cures it",
                      {"", "method", "value", "error", "evaluations", "outcome"},
                      {trial_text("breaks", b.broken), trial_text("cure", b.cured)}}) +
         "</div>\n";
}

std::string failures_text(const QuantityResult& q) {
  Named reasons;
  for (const MethodResult& m : q.methods)
    if (!m.why.empty() && m.expected != Outcome::ok)
      add_under(reasons, "<em>" + std::string(name_of(m.expected)) + "</em>: " + html::text(m.why),
                html::escaped(m.model + ", " + m.algorithm));
  std::string items;
  for (const auto& [reason, names] : reasons) items += element("li", "", names + ": " + reason + ".");
  return items.empty() ? ""
                       : html::folded("Expected to fail at the finest setting", element("ul", "", items));
}

std::string reference_of(const QuantityResult& q) {
  if (!finite(q.reference.value)) return "No true value is known: " + html::text(q.reference.by) + ".";
  return "True value: " +
         element("b", "", with_unit_of(html::escaped(with_powers(shown(q.reference.value, 12))), q.unit)) +
         ", known to " + short_error(q.reference_error) + " (" + html::text(q.reference.by) +
         "). Needed to " + short_error(q.need.allowed) + ": " + html::text(q.need.reason) +
         (q.samples > 1 ? "; " + instants(q) : "") + ".";
}

std::string quantity_text_of(const ExerciseResult& e, const QuantityResult& q) {
  const std::string name = html::escaped(q.name);
  std::string text = "<section class=\"quantity\" id=\"q-" + html::anchor(q.name) + "\">\n" +
                     element("h3", "", "<code>" + name + "</code> " + html::text(q.says)) + "\n" +
                     element("p", "", reference_of(q)) + "\n<figure class=\"chart\" data-quantity=\"" + name +
                     "\">" + no_script(q.name, e) + "</figure>\n<div class=\"trials\" data-quantity=\"" +
                     name + "\"></div>\n";
  for (const BreakdownResult& b : q.breakdowns) text += breakdown_text_of(b);
  return text + failures_text(q) + "</section>\n";
}

std::string limit_row_of(const Limit& l, const Stability& s) {
  const auto theory = l.theory();
  return html::row(
      {html::escaped(l.algorithm), html::escaped(shown_step(l)),
       std::isinf(theory) ? "every step"
       : theory == 0      ? "none"
                          : rounded(theory, 3),
       l.within ? rounded(l.within->setting, 3) : "none found",
       l.broken ? "<span class=\"outcome " + html::anchor(beyond(l)) + "\">" + beyond(l) + "</span>"
                : "stable",
       html::escaped(with_powers(shown_cure(l, s.unit)))},
      "123");
}

/// The limits of one model after the other.
std::string limits_text_of(const Stability& s) {
  std::string text;
  const std::string unit = s.time_unit.empty() ? "" : " [" + html::escaped(s.time_unit) + "]";
  for (std::size_t i = 0; i < s.limits.size();) {
    const std::string& model = s.limits[i].model;
    html::Table table{
        "Limits of " + model,
        {"algorithm", "stable to" + unit, "theory" + unit, "needed to" + unit, "beyond", "cure there"}};
    for (; i < s.limits.size() && s.limits[i].model == model; ++i)
      table.rows.push_back(limit_row_of(s.limits[i], s));
    text += html::folded(
        html::escaped(model) + ": " + counted(static_cast<long>(table.rows.size()), "method", "methods"),
        html::table(table));
  }
  return text;
}

/// Which methods hold longest and which never: the scene's limits in a sentence or two.
std::string summary_of(const Stability& s) {
  const Limit* longest = nullptr;
  long none = 0, every = 0, all = 0;
  for (const Limit& l : s.limits) {
    ++all;
    none += l.step() == 0;
    every += std::isinf(l.step());
    if (!std::isinf(l.step()) && l.unstable > 0 && (!longest || l.step() > longest->step())) longest = &l;
  }
  std::string text = "Of " + counted(all, "method", "methods") + " of fixed step, " +
                     (none == 0 ? "every one has" : std::to_string(all - none) + " have") +
                     " steps at which a small disturbance does not grow faster than in truth";
  if (every > 0) text += ", " + std::to_string(every) + " of them at every step";
  text += ".";
  if (longest)
    text += " The longest step that is lost anywhere is that of " + html::escaped(longest->algorithm) +
            " on “" + html::escaped(longest->model) + "”: " + rounded(longest->step(), 3) + " " +
            html::escaped(s.time_unit) + ".";
  return text +
         " Stable says nothing about accuracy: <em>needed to</em> is the largest step that keeps the error within " +
         with_unit_of(short_error(s.close), s.unit) + ".";
}

std::string reasons_text(const Stability& s) {
  Named reasons;
  for (const Limit& l : s.limits)
    if (!l.why.empty()) add_under(reasons, html::text(l.why), html::escaped(l.model + ", " + l.algorithm));
  std::string items;
  for (const auto& [reason, names] : reasons) items += element("li", "", names + ": " + reason + ".");
  return items.empty() ? ""
                       : html::folded("Where theory and measurement differ by more than a quarter",
                                      element("ul", "", items));
}

}  // namespace

std::string quantities_section(const ExerciseResult& e) {
  if (e.quantities.empty()) return "";
  std::string text;
  for (const QuantityResult& q : e.quantities) text += quantity_text_of(e, q);
  return "<section id=\"quantities\">\n<h2>How to compute it</h2>\n" + text + "</section>\n";
}

std::string stability_section(const ExerciseResult& e) {
  if (!e.stability) return "";
  const Stability& s = *e.stability;
  return "<section id=\"stability\">\n<h2>Up to which step</h2>\n" + element("p", "", summary_of(s)) +
         "\n<figure class=\"map\"><noscript><p>The map needs scripts. As text: <code>oddity stability " +
         to_string(e.number) + "</code>.</p></noscript></figure>\n" + limits_text_of(s) + reasons_text(s) +
         "</section>\n";
}

}  // namespace oddity
