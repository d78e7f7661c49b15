#include "report/study/findings.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <string_view>

namespace oddity {

std::string Finding::title() const {
  std::string text = root ? root->name : claims.front()->claim.says;
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[0])) != 0)
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}
std::string Finding::shows() const { return root ? root->shows : ""; }

std::vector<Finding> findings_of(const ExerciseResult& e) {
  std::vector<Finding> all;
  for (const JudgedClaim* c : claims_of(e, Verdict::erratum)) {
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

std::vector<const JudgedClaim*> claims_of(const ExerciseResult& e, Verdict verdict) {
  std::vector<const JudgedClaim*> all;
  for (const JudgedClaim& c : e.claims)
    if (c.verdict == verdict) all.push_back(&c);
  return all;
}

void Tally::count(const ExerciseResult& e) {
  for (const JudgedClaim& c : e.claims) {
    confirmed += c.verdict == Verdict::confirmed;
    misprints += c.verdict == Verdict::misprint;
    errata += c.verdict == Verdict::erratum;
    not_checkable += c.verdict == Verdict::not_checkable;
    unsettled += c.verdict == Verdict::unsettled;
  }
}

const Reading& right_reading(const JudgedClaim& judged) {
  return judged.verdict == Verdict::misprint  ? judged.claim.meant
         : judged.verdict == Verdict::erratum ? judged.claim.corrected
                                              : judged.claim.printed;
}

bool says_what_is_printed(const Claim& claim) {
  std::string_view printed = claim.printed.text;
  if (printed.size() > 2 && printed.find('$', 1) == printed.size() - 1 && printed.starts_with('$'))
    printed = printed.substr(1, printed.size() - 2);
  return claim.says.find(printed) != std::string::npos;
}

const Trajectory* trajectory_of(const ExerciseResult& e) {
  for (const QuantityResult& q : e.quantities)
    if (q.trajectory && !q.trajectory->paths.empty()) return &*q.trajectory;
  return nullptr;
}

const Path& true_path(const Trajectory& t) { return t.paths[std::min(t.truest, t.paths.size() - 1)]; }

const Path* published_path(const ExerciseResult& e) {
  constexpr std::array words{"published", "as printed", "printed listing", "as proposed"};
  const Trajectory* t = trajectory_of(e);
  if (!t) return nullptr;
  for (const Path& path : t->paths)
    if (std::ranges::any_of(words,
                            [&](const char* word) { return path.model.find(word) != std::string::npos; }))
      return &path;
  return nullptr;
}

std::string counted(long n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace oddity
