#include "report/study/findings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

namespace oddity {

namespace {

int weight_of(Fault kind) {
  switch (kind) {
    case Fault::listing:
    case Fault::formula:
    case Fault::number:
      return 0;
    case Fault::counterexample:
      return 1;
    case Fault::term:
      return 2;
    default:
      return 3;
  }
}

/// Sorts the worst first: wrong before incomplete, scenes first, then by kind, then by number of claims.
auto rank_of(const Finding& f) {
  int kind = weight_of(Fault::none);
  for (const JudgedClaim* c : f.claims) kind = std::min(kind, weight_of(c->claim.kind));
  return std::tuple(!is_wrong(f), !f.exercise->scene, kind, -std::ssize(f.claims));
}

/// The sentence of an exercise whose author wrote none.
std::string made_of_verdicts(const ExerciseResult& e, const std::vector<Finding>& findings,
                             const InMarkup& written) {
  if (findings.empty()) {
    Counts counts = counts_of(e);
    if (counts[Verdict::confirmed] == 0) return "";
    const int misprints = counts[Verdict::misprint];
    return "The solution is right" +
           (misprints > 0 ? ", except for " + counted(misprints, "misprint", "misprints") : "") + ".";
  }
  std::string text;
  for (const Finding& f : findings) text += (text.empty() ? "" : "; ") + written.named(f, f.title());
  return "Wrong or incomplete: " + text + ".";
}

}  // namespace

std::string verdict_of(const ExerciseResult& e, const InMarkup& written) {
  const std::vector<Finding> findings = findings_of(e);
  if (e.verdict.empty()) return made_of_verdicts(e, findings, written);
  std::set<std::string> left;
  for (const Finding& f : findings) left.insert(f.root ? f.root->name : f.title());
  std::string text, after_rest;
  bool counts_rest = false;
  for (std::string_view ahead = e.verdict; !ahead.empty();) {
    const std::size_t opens = ahead.find("{{"), closes = std::min(ahead.find("}}", opens), ahead.size());
    std::string& here = counts_rest ? after_rest : text;
    const std::string_view words = ahead.substr(0, opens);
    const std::size_t blanks = std::min(words.find_first_not_of(' '), words.size());
    here += std::string(blanks, ' ') + written.text(std::string(words.substr(blanks)));
    if (opens == std::string_view::npos) break;
    const std::string inside(ahead.substr(opens + 2, closes - opens - 2));
    ahead.remove_prefix(std::min(closes + 2, ahead.size()));
    if (inside == "rest") {
      counts_rest = true;
      continue;
    }
    const std::string name = inside.substr(0, inside.find('|'));
    const auto finding =
        std::ranges::find(findings, name, [](const Finding& f) { return f.root ? f.root->name : f.title(); });
    if (finding == findings.end())
      throw std::logic_error("the verdict in a sentence names something other than a finding: " + name);
    here += written.named(*finding, name.size() < inside.size() ? inside.substr(name.size() + 1) : name);
    left.erase(name);
  }
  for (const Finding& f : findings)
    if (is_wrong(f) && left.contains(f.root ? f.root->name : f.title()))
      throw std::logic_error("the verdict in a sentence does not name a wrong claim: " +
                             (f.root ? f.root->name : f.title()));
  if (counts_rest == left.empty())
    throw std::logic_error(counts_rest ? "the verdict in a sentence counts a rest, and names all findings"
                                       : "the verdict in a sentence leaves out: " + *left.begin());
  return text + (counts_rest ? counted(std::ssize(left), "more finding", "more findings") : "") + after_rest;
}

std::string Finding::title() const {
  std::string text = root ? root->name : claims.front()->claim.says;
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[0])) != 0)
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}
std::string Finding::shows() const { return root ? root->shows : ""; }

bool is_wrong(const Finding& f) {
  return std::ranges::any_of(f.claims, [](const JudgedClaim* c) { return c->verdict == Verdict::wrong; });
}

std::vector<Finding> findings_of(const ExerciseResult& e) {
  std::vector<Finding> all;
  for (const JudgedClaim* c : errata_of(e)) {
    const auto root = std::ranges::find(e.roots, c->claim.root, &Root::name);
    const Root* of = root == e.roots.end() ? nullptr : &*root;
    const auto known = of ? std::ranges::find(all, of, &Finding::root) : all.end();
    if (known != all.end())
      known->claims.push_back(c);
    else
      all.push_back({&e, of, {c}});
  }
  std::ranges::stable_sort(all, [&](const Finding& a, const Finding& b) {
    const Root* end = e.roots.data() + e.roots.size();
    return std::less<>()(a.root ? a.root : end, b.root ? b.root : end);
  });
  return all;
}

double broken_by(const ExerciseResult& e) {
  const Path* path = published_path(e);
  if (!path) return 0;
  const double needs = path->error / trajectory_of(e)->close;
  if (!std::isfinite(needs)) return INFINITY;
  return needs > 1 ? needs : 0;
}

std::vector<Finding> errata_worst_first(const Results& results) {
  std::vector<Finding> breaking, others;
  for (const ExerciseResult& e : results.exercises) {
    std::vector<Finding> found = findings_of(e);
    std::ranges::stable_sort(found, {}, rank_of);
    for (Finding& f : found)
      (broken_by(e) > 0 && &f == &found.front() ? breaking : others).push_back(std::move(f));
  }
  std::ranges::stable_sort(breaking, std::greater(), [](const Finding& f) { return broken_by(*f.exercise); });
  std::ranges::stable_sort(others, {}, rank_of);
  std::ranges::move(others, std::back_inserter(breaking));
  return breaking;
}

std::vector<const JudgedClaim*> claims_of(const ExerciseResult& e, Verdict verdict) {
  std::vector<const JudgedClaim*> all;
  for (const JudgedClaim& c : e.claims)
    if (c.verdict == verdict) all.push_back(&c);
  return all;
}

std::vector<const JudgedClaim*> errata_of(const ExerciseResult& e) {
  std::vector<const JudgedClaim*> all;
  for (const JudgedClaim& c : e.claims)
    if (is_erratum(c.verdict)) all.push_back(&c);
  return all;
}

Counts counts_of(const ExerciseResult& e) {
  Counts counts;
  for (const JudgedClaim& c : e.claims) ++counts[c.verdict];
  return counts;
}

Counts counts_of(const Results& results) {
  Counts counts;
  for (const ExerciseResult& e : results.exercises)
    for (const auto& [verdict, n] : counts_of(e)) counts[verdict] += n;
  return counts;
}

int sum_of(const Counts& counts) {
  int all = 0;
  for (const auto& [verdict, n] : counts) all += n;
  return all;
}

const Reading& right_reading(const JudgedClaim& judged) {
  switch (judged.verdict) {
    case Verdict::misprint:
    case Verdict::lost:
      return judged.claim.meant;
    case Verdict::wrong:
    case Verdict::incomplete:
      return judged.claim.corrected;
    default:
      return judged.claim.printed;
  }
}

std::string place_of(const Claim& claim) {
  return (claim.place.empty() ? "" : claim.place + ", ") + "line " + std::to_string(claim.line);
}

bool counts_violations(const Check& c) {
  return c.right.by == "none" && c.left.by.starts_with("violations in ");
}

namespace {

/// Without the dollars of a text that is one formula.
std::string_view within_dollars(std::string_view text) {
  const bool one = text.size() > 2 && text.starts_with('$') && text.find('$', 1) == text.size() - 1;
  return one ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

bool shows_printed(const Claim& claim) {
  return claim.says.find(within_dollars(claim.printed.text)) != std::string::npos;
}

bool shows_each_form(const Claim& claim) {
  const std::string_view row = within_dollars(claim.printed.text), between = R"(,\ )";
  if (shows_printed(claim)) return true;
  if (!row.starts_with('(') || !row.ends_with(')')) return false;
  for (std::size_t from = 1, to = 0; to < row.size() - 1; from = to + between.size()) {
    to = std::min(row.find(between, from), row.size() - 1);
    const std::string_view form = row.substr(from, to - from);
    if (form.size() < 3 || claim.says.find(form) == std::string::npos) return false;
  }
  return true;
}

const Trajectory* trajectory_of(const ExerciseResult& e) {
  for (const QuantityResult& q : e.quantities)
    if (q.trajectory && !q.trajectory->paths.empty()) return &*q.trajectory;
  return nullptr;
}

const Path& true_path(const Trajectory& t) { return t.paths[std::min(t.truest, t.paths.size() - 1)]; }

bool is_published(std::string_view model) {
  constexpr std::array words{"published", "as printed", "printed listing", "as proposed"};
  return std::ranges::any_of(words,
                             [&](const char* word) { return model.find(word) != std::string_view::npos; });
}

const Path* published_path(const ExerciseResult& e) {
  const Trajectory* t = trajectory_of(e);
  if (!t) return nullptr;
  const auto published = std::ranges::find_if(t->paths, is_published, &Path::model);
  return published == t->paths.end() ? nullptr : &*published;
}

std::string counted(long n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

}  // namespace oddity
