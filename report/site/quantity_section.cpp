#include "report/site/quantity_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/text_view.hpp"
#include "report/site/page.hpp"
#include "report/site/still_chart.hpp"
#include "report/study/findings.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;
using Named = std::vector<std::pair<std::string, std::string>>;

std::string short_error(double error) { return in_xml(with_powers(shown_error(error))); }

std::string with_unit_of(const std::string& number, const std::string& unit) {
  return unit.empty() || unit == "1" ? number : number + " " + in_xml(typeset_unit(unit));
}

/// ", step 0.0625" in HTML; empty for a method without a setting.
std::string setting_text(const TimedTrial& t) {
  return t.resolution.empty() ? "" : ", " + in_xml(with_powers(shown_resolution(t)));
}

/// Groups names by reason, in the order of the reasons.
void add_under(Named& all, const std::string& reason, const std::string& name) {
  const auto same = std::ranges::find(all, reason, &Named::value_type::first);
  if (same == all.end())
    all.emplace_back(reason, name);
  else
    same->second += "; " + name;
}

/// A button that plays this trial; the method is given by its index in the page's data.
std::string play_button(const QuantityResult& q, const TimedTrial& t) {
  const auto method = std::ranges::find_if(
      q.methods, [&](const MethodResult& m) { return m.model == t.model && m.algorithm == t.algorithm; });
  if (!q.trajectory || method == q.methods.end()) return "";
  return " <button type=\"button\" hidden data-play=\"" + std::to_string(method - q.methods.begin()) + " " +
         format_shortest(t.setting) + "\">play</button>";
}

std::string trial_text(const std::string& what, const QuantityResult& q, const TimedTrial& t) {
  return element("li", "",
                 "<b>" + what + "</b> " + in_xml(t.model + ", " + t.algorithm) + setting_text(t) + ": <i>" +
                     std::string(name_of(t.outcome)) + "</i>, error " + short_error(t.error) + ", " +
                     counted(t.evaluations, "evaluation", "evaluations") + play_button(q, t));
}

std::string breakdown_text_of(const QuantityResult& q, const BreakdownResult& b) {
  return "<div class=\"breakdown\">" +
         element("p", "", (b.as_expected() ? "" : "Does not break so here. ") + html::prose(b.says)) +
         element("ul", "", trial_text("breaks", q, b.broken) + trial_text("cure", q, b.cured)) + "</div>\n";
}

/// "one angle: explicit Euler, velocity Verlet; Cartesian: explicit Euler".
std::string methods_text(const std::vector<const MethodResult*>& methods) {
  std::string text;
  const MethodResult* last = nullptr;
  for (const MethodResult* m : methods) {
    const bool same = last && last->model == m->model;
    text += (!last ? "" : same ? ", " : "; ") + (same ? m->algorithm : m->model + ": " + m->algorithm);
    last = m;
  }
  return in_xml(text);
}

std::string failures_text(const QuantityResult& q) {
  std::vector<std::pair<std::string, std::vector<const MethodResult*>>> reasons;
  for (const MethodResult& m : q.methods) {
    if (!m.fails_as_expected()) continue;
    const std::string reason = "<em>" + std::string(name_of(m.expected)) + "</em>, " + html::text(m.why);
    const auto same =
        std::ranges::find(reasons, reason, &std::pair<std::string, std::vector<const MethodResult*>>::first);
    if (same == reasons.end())
      reasons.emplace_back(reason, std::vector{&m});
    else
      same->second.push_back(&m);
  }
  std::string items;
  for (const auto& [reason, methods] : reasons)
    items += element("li", "", methods_text(methods) + ": " + reason + ".");
  return items.empty() ? ""
                       : html::folded("Expected to fail at the finest setting", element("ul", "", items));
}

std::string reference_of(const QuantityResult& q) {
  if (!finite(q.reference.value)) return "No true value is known: " + html::text(q.reference.by) + ".";
  return "True value: " +
         element("b", "", with_unit_of(in_xml(with_powers(shown(q.reference.value, 12))), q.unit)) +
         ", known " + (q.reference_error == 0 ? "exactly" : "to " + short_error(q.reference_error)) + " (" +
         html::text(q.reference.by) + "). Needed to " + short_error(q.need.allowed) + " (" +
         html::text(q.need.reason) + ")" + (q.samples > 1 ? "; " + instants(q) : "") + ".";
}

std::string quantity_text_of(const QuantityResult& q) {
  const std::string name = in_xml(q.name);
  std::string text = "<section class=\"quantity\" id=\"q-" + html::anchor(q.name) + "\">\n" +
                     element("h3", "", "<code>" + name + "</code> " + html::text(q.says)) + "\n" +
                     element("p", "", reference_of(q)) + "\n<figure class=\"chart\" data-quantity=\"" + name +
                     "\">" + still_chart(q) + "</figure>\n<div class=\"trials\" data-quantity=\"" + name +
                     "\"></div>\n";
  for (const BreakdownResult& b : q.breakdowns) text += breakdown_text_of(q, b);
  return text + failures_text(q) + "</section>\n";
}

std::string limit_row_of(const Limit& l) {
  const double theory = l.theory();
  return html::row(
      {in_xml(l.algorithm), in_xml(shown_step(l)),
       std::isinf(theory) ? "every step"
       : theory == 0      ? "none"
                          : format_significant(theory, 3),
       l.within ? format_significant(l.within->setting, 3) : "none found", beyond(l),
       !l.cure ? "" : in_xml((l.cure->model == l.model ? "" : l.cure->model + ", ") + l.cure->algorithm)},
      "123");
}

/// Limits, model by model.
std::string limits_text_of(const Stability& s) {
  const std::string unit = s.time_unit.empty() ? "" : " [" + in_xml(s.time_unit) + "]";
  html::Table table{
      "The largest steps",
      {"algorithm", "stable to" + unit, "theory" + unit, "needed to" + unit, "beyond", "cure there"}};
  const std::string* model = nullptr;
  for (const Limit& l : s.limits) {
    if (!model || *model != l.model)
      table.rows.push_back("<tr><th colspan=\"6\" scope=\"rowgroup\">" + in_xml(l.model) + "</th></tr>\n");
    model = &l.model;
    table.rows.push_back(limit_row_of(l));
  }
  return html::folded("The limits of all methods", html::table(table));
}

/// The methods with the longest limit and those that are never stable, in a sentence or two.
std::string summary_of(const Stability& s) {
  const Limit* longest = nullptr;
  long none = 0, every = 0, all = 0;
  for (const Limit& l : s.limits) {
    ++all;
    none += l.step() == 0;
    every += std::isinf(l.step());
    if (!std::isinf(l.step()) && l.unstable > 0 && (!longest || l.step() > longest->step())) longest = &l;
  }
  std::string text = "Of " + counted(all, "method of fixed step", "methods of fixed step") + ", " +
                     (none == 0 ? "every one has" : std::to_string(all - none) + " have") +
                     " steps at which a small disturbance does not grow faster than in truth";
  if (every > 0)
    text += "; " + std::to_string(every) + (every == 1 ? " is" : " are") + " stable at every step";
  text += ".";
  if (longest)
    text += (every > 0 ? " The others' largest" : " The largest") + std::string(" stable step is that of ") +
            in_xml(longest->algorithm) + " on “" + in_xml(longest->model) +
            "”: " + format_significant(longest->step(), 3) + " " + in_xml(s.time_unit) + ".";
  return text +
         " Stability is not accuracy: <em>needed to</em> is the largest step that keeps the error within " +
         with_unit_of(short_error(s.close), s.unit) + ".";
}

std::string reasons_text(const Stability& s) {
  Named reasons;
  for (const Limit& l : s.limits)
    if (!l.why.empty()) add_under(reasons, html::text(l.why), in_xml(l.model + ", " + l.algorithm));
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
  for (const QuantityResult& q : e.quantities) text += quantity_text_of(q);
  return "<section id=\"quantities\">\n<h2>How to compute it</h2>\n<noscript><p>With scripts the charts show every "
         "trial, and answer.</p></noscript>\n" +
         text + "</section>\n";
}

std::string stability_section(const ExerciseResult& e) {
  if (!e.stability) return "";
  const Stability& s = *e.stability;
  return "<section id=\"stability\">\n<h2>Up to which step</h2>\n" + element("p", "", summary_of(s)) +
         "\n<figure class=\"map\">" + still_map(s) + "</figure>\n" + limits_text_of(s) + reasons_text(s) +
         "</section>\n";
}

}  // namespace oddity
