#include "report/pages/claims.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <set>

#include "chapters/typeset.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/text_view.hpp"
#include "report/text/markup.hpp"
#include "report/text/readable.hpp"

namespace oddity {

namespace {

// ---- evidence ---------------------------------------------------------------------------------------------

double scale_of(const Check& c) {
  return c.scale > 0 ? c.scale : std::max(size_of(c.left.value), size_of(c.right.value));
}

std::string difference_of(const Check& c) {
  const double difference = c.difference();
  if (c.tolerance.allowed == 0) return difference == 0 ? "equal" : "differ by " + shown_error(difference);
  const std::string scale = scale_of(c) > 0 ? " at a scale of " + format_significant(scale_of(c), 3) : "";
  return (std::isfinite(difference) ? "differ by " + shown_error(difference) + scale : "cannot be compared") +
         ", allowed " + shown_error(c.tolerance.allowed);
}

/// The part of its tolerance that a check uses; failing checks rank above those that pass.
double tightness(const Check& c) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double used = c.tolerance.allowed > 0 ? c.difference() / c.tolerance.allowed : 0;
  return c.holds() ? std::min(used, 1.0) : std::isfinite(used) && used > 1 ? used : infinity;
}

const Check& tightest(const Reading& reading) {
  return *std::ranges::max_element(reading.checks, {}, tightness);
}

/// The reading's check of the same quantity as `other`, otherwise its tightest check.
const Check& beside(const Check& other, const Reading& reading) {
  const auto same = std::ranges::find(reading.checks, other.quantity, &Check::quantity);
  return same != reading.checks.end() ? *same : tightest(reading);
}

std::string in_words(const std::string& text) {
  return with_powers(escaped(with_short_numbers(text), false));
}

/// "It fails in 30 of 201 samples."
std::string failures(const Check& c) {
  return "It fails in " + format_significant(c.left.value[0], 12) + " of" +
         c.left.by.substr(std::string("violations in").size()) + ".\n\n";
}

/// "off by 1.5", "equal".
std::string deviation(const Check& c) {
  const double difference = c.difference();
  return difference == 0             ? "equal"
         : std::isfinite(difference) ? "off by " + error_cell(difference)
                                     : "no number";
}

/// "by 1.5" of "off by 1.5".
std::string without_off(const std::string& deviation) {
  return deviation.starts_with("off ") ? deviation.substr(4) : deviation;
}

/// "√2 K by the arithmetic-geometric mean (2.260114): print off by 1.5, correction by 9.4×10⁻⁸." Shows the
/// value only for a single sample. Empty if the meaning was plain.
std::string numbers_of(const JudgedClaim& judged) {
  const Claim& claim = judged.claim;
  if (claim.printed.checks.empty() || was_meant(judged.verdict)) return "";
  const Check& printed = tightest(claim.printed);
  if (counts_violations(printed)) return failures(printed);
  const bool one = printed.where.empty() && printed.right.value.size() == 1;
  std::string text = "*" + in_words(printed.right.by) + "*" +
                     (one ? " (" + value_cell(printed.right.value, 7) + ")" : "") + ": print " +
                     deviation(printed);
  if (is_erratum(judged.verdict) && !claim.corrected.checks.empty()) {
    const Check& corrected = beside(printed, claim.corrected);
    if (!counts_violations(corrected)) text += ", correction " + without_off(deviation(corrected));
  }
  return text + ".\n\n";
}

// ---- claims -----------------------------------------------------------------------------------------------

/// A claim's anchor: its id, with '-' for characters that anchors cannot have.
std::string anchor_of(const Claim& claim) {
  std::string anchor;
  for (char c : claim.id)
    anchor += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '_' ? c : '-';
  return anchor;
}

std::string title_of(Verdict verdict) {
  std::string name(name_of(verdict));
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

/// Whether the claim's sentence contains its formula.
bool has_equation(const Claim& claim) { return claim.says.find('=') != std::string::npos; }

/// Whether the claim's sentence already contains the reading.
bool is_shown_above(const Claim& claim, const Reading& reading) {
  std::string text = reading.text;
  if (text.size() > 2 && text.front() == '$' && text.back() == '$') text = text.substr(1, text.size() - 2);
  return text.empty() || claim.says.find(text) != std::string::npos;
}

/// The text up to the first full stop outside of formulas.
std::string first_sentence(const std::string& text) {
  bool in_formula = false;
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    in_formula = in_formula != (text[i] == '$');
    if (!in_formula && text[i] == '.' && text[i + 1] == ' ' &&
        std::isupper(static_cast<unsigned char>(text[i + 2])))
      return text.substr(0, i + 1);
  }
  return text;
}

/// An erratum: the right reading unless a table shows it, the reason, and the numbers. A sentence is enough
/// for signs that our copy has lost.
std::string in_full(const JudgedClaim& judged, bool in_table, const ProvedClaims& proved) {
  const Claim& claim = judged.claim;
  const std::string kind = claim.kind == Fault::none ? "" : std::string(name_of(claim.kind)) + ", ";
  const auto shown = [&](const std::string& what, const Reading& reading) {
    return is_shown_above(claim, reading) || in_table
               ? ""
               : " *" + what + ":* " + escaped(as_sentence(reading.text), false);
  };
  const bool meant = was_meant(judged.verdict);
  const std::string as_printed = judged.verdict == Verdict::lost ? "In our copy" : "As printed";
  const std::string readings = (meant && !has_equation(claim) ? shown(as_printed, claim.printed) : "") +
                               shown(meant ? "Meant" : "Right", right_reading(judged));
  return "<a id=\"" + anchor_of(claim) + "\"></a>**" + title_of(judged.verdict) + " " + code(claim.id) +
         "** (" + kind + escaped(place_of(claim), false) + (proved.contains(claim.id) ? ", proved" : "") +
         "): " + escaped(as_sentence(claim.says), false) + readings + "\n\n" +
         prose(judged.verdict == Verdict::lost ? first_sentence(claim.why) : claim.why) + "\n\n" +
         numbers_of(judged);
}

/// The other side of a confirmed claim's comparison: a route, or samples. For a comparison with zero, the
/// route to the value.
std::string compared_with(const JudgedClaim& judged) {
  const Reading& reading = right_reading(judged);
  if (reading.checks.empty()) return "";
  const Check& c = tightest(reading);
  return counts_violations(c)
             ? "In " + c.left.by.substr(std::string("violations in ").size())
             : (c.right.by == "zero" && c.left.by != judged.claim.says ? c.left.by : c.right.by);
}

/// A line for each confirmed claim, in groups that were compared with the same route.
std::string confirmed_lines(const ExerciseResult& e, const ProvedClaims& proved) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const JudgedClaim& c : e.claims) {
    if (c.verdict != Verdict::confirmed) continue;
    const std::string mark = proved.contains(c.claim.id) ? "†" : "";
    const Reading& printed = c.claim.printed;
    const bool formula = is_formula(printed.text) && !shows_each_form(c.claim);
    const std::string line = "<br>" + mark + std::to_string(c.claim.line) + ":&nbsp;" +
                             escaped(c.claim.says, false) +
                             (formula ? ": " + escaped(printed.text, false) : "");
    const std::string with = compared_with(c);
    const auto same = std::ranges::find(groups, with, &std::pair<std::string, std::string>::first);
    if (same == groups.end())
      groups.emplace_back(with, line);
    else
      same->second += line;
  }
  std::string text;
  for (const auto& [with, lines] : groups) text += "*" + in_words(with) + ":*" + lines + "\n\n";
  return text;
}

std::string folded(const std::string& summary, const std::string& text) {
  return "<details><summary>" + summary + "</summary>\n\n" + text + "</details>\n\n";
}

/// Whether all checks agree in every bit in every sample, although roundings are allowed.
bool bit_equal(const JudgedClaim& judged) {
  const auto& checks = right_reading(judged).checks;
  return !checks.empty() && std::ranges::all_of(checks, [](const Check& c) {
    return c.tolerance.allowed > 0 && c.difference() == 0;
  });
}

}  // namespace

std::string sentence(const Counts& counts) {
  std::string text;
  for_each_count(counts, [&](const VerdictNoun& noun, int n) {
    text += (text.empty() ? "" : ", ") + counted(n, noun.one, noun.many);
  });
  return text.empty() ? "no claims" : text;
}

std::string address_of(const ExerciseResult& e, const Claim& claim, Links links) {
  return (links == Links::apart ? exercise_file(e.number) : "") + "#" + anchor_of(claim);
}

std::string link_to(const ExerciseResult& e, const Claim& claim, Links links) {
  return "[" + escaped(claim.id) + "](" + address_of(e, claim, links) + ")";
}

std::string answer(const ExerciseResult& e) {
  const std::string verdict = verdict_of(e, {[&](const Finding& f, const std::string& words) {
                                               return "[" + escaped(words, false) + "](" +
                                                      address_of(e, f.claims.front()->claim, Links::within) +
                                                      ")";
                                             },
                                             [](const std::string& words) { return escaped(words, false); }});
  Counts counts = counts_of(e);
  if (counts.size() > 1) counts.erase(Verdict::confirmed);  // counted above their list
  std::string text = (verdict.empty() ? "" : verdict + "\n\n") + "**" + sentence(counts) + ".**";
  const std::vector<Finding> errata = findings_of(e);
  if (errata.empty()) return text + "\n\n";
  std::vector<std::vector<std::string>> rows;
  for (const Finding& f : errata)
    rows.push_back(
        {"[" + escaped(f.title()) + "](" + address_of(e, f.claims.front()->claim, Links::within) + ")",
         escaped(f.claims.front()->claim.printed.text), escaped(f.claims.front()->claim.corrected.text),
         escaped(f.shows())});
  return text + "\n\n" + table({"erratum", "as printed", "right", "visible effect"}, rows);
}

std::string wrong_claims(const ExerciseResult& e, const ProvedClaims& proved) {
  std::set<const Claim*> in_table;
  for (const Finding& f : findings_of(e)) in_table.insert(&f.claims.front()->claim);
  std::string text;
  for (Verdict verdict :
       {Verdict::wrong, Verdict::incomplete, Verdict::misprint, Verdict::unsettled, Verdict::lost})
    for (const JudgedClaim& c : e.claims)
      if (c.verdict == verdict) text += in_full(c, in_table.contains(&c.claim), proved);
  return text;
}

std::string other_claims(const ExerciseResult& e, const ProvedClaims& proved) {
  std::string open;
  int confirmed = 0, by_coq = 0;
  for (const JudgedClaim& c : e.claims) {
    if (c.verdict == Verdict::not_checkable)
      open += code(c.claim.id) + " (" + escaped(place_of(c.claim), false) +
              "): " + escaped(as_sentence(c.claim.says), false) + " Not checkable because " +
              escaped(c.claim.not_checkable, false) + ".\n\n";
    if (c.verdict != Verdict::confirmed) continue;
    ++confirmed;
    by_coq += proved.contains(c.claim.id);
  }
  if (confirmed == 0) return open;
  return open + folded(counted(confirmed, "confirmed claim", "confirmed claims") +
                           (by_coq == 0 ? "" : ", " + std::to_string(by_coq) + " proved (†)"),
                       confirmed_lines(e, proved));
}

std::string errata_table(const Results& results, Links links, Verdict verdict) {
  std::vector<std::vector<std::string>> rows;
  for (const Finding& f : errata_worst_first(results)) {
    if (is_wrong(f) != (verdict == Verdict::wrong)) continue;
    std::string claims;
    for (const JudgedClaim* c : f.claims)
      claims += (claims.empty() ? "" : ", ") + link_to(*f.exercise, c->claim, links);
    rows.push_back({claims, escaped(f.claims.front()->claim.printed.text),
                    escaped(f.claims.front()->claim.corrected.text), escaped(f.shows())});
  }
  return table({"claims", "as printed", "right", "visible effect"}, rows);
}

std::string list_of(const Results& results, Verdict verdict, Links links) {
  std::map<std::string, std::string> by_kind;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims) {
      if (c.verdict != verdict) continue;
      std::string& list = by_kind[std::string(name_of(c.claim.kind))];
      list += (list.empty() ? "" : ", ") + link_to(e, c.claim, links);
    }
  std::string text;
  for (const auto& [kind, list] : by_kind) text += (kind.empty() ? "" : "*" + kind + ":* ") + list + "\n\n";
  return text;
}

std::string bit_equal_text(const Results& results) {
  std::string list;
  int count = 0;
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims)
      if (c.verdict == Verdict::confirmed && bit_equal(c))
        list += (count++ == 0 ? "" : ", ") + code(c.claim.id);
  if (count == 0) return "";
  return folded(
      counted(count, "claim equal to the last bit", "claims equal to the last bit"),
      "The two routes of these confirmed claims never differ, though their tolerance leaves room for "
      "roundings: they do the same arithmetic in the end, or their numbers are short. Their near misses "
      "fail like all others.\n\n" +
          list + "\n\n");
}

std::string claims_evidence(const JudgedClaim& judged) {
  std::string text = judged.claim.id + " (" + place_of(judged.claim) + "): " + judged.claim.says + "\n";
  const auto add = [&](const std::string& name, const Reading& reading) {
    for (const Check& c : reading.checks)
      text += "  " + name + (c.holds() ? " holds: " : " FAILS: ") + c.quantity + ": " +
              shown(c.left.value, 17) + " (" + c.left.by + ") against " + shown(c.right.value, 17) + " (" +
              c.right.by + "), " + difference_of(c) + " (" + c.tolerance.reason + ")" +
              (c.where.empty() ? "" : ", " + c.where) + "\n";
  };
  add("printed", judged.claim.printed);
  add("meant", judged.claim.meant);
  add("corrected", judged.claim.corrected);
  for (const Reading& near : judged.claim.near_misses) add("near miss '" + near.text + "'", near);
  return readable(text);
}

}  // namespace oddity
