#include "report/pages/dialects.hpp"

#include <cctype>
#include <regex>
#include <utility>
#include <vector>

#include "chapters/listing.hpp"

namespace oddity {

namespace {

using Changes = std::vector<std::pair<std::regex, std::string>>;

std::string changed(std::string text, const Changes& changes) {
  for (const auto& [from, to] : changes) text = std::regex_replace(text, from, to);
  return text;
}

/// Replaces each match by made(match).
template <class F>
std::string replaced(const std::string& text, const std::regex& pattern, const F& made) {
  std::string all;
  auto end = text.cbegin();
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), none; found != none; ++found) {
    all.append(end, (*found)[0].first);
    all += made(*found);
    end = (*found)[0].second;
  }
  return all.append(end, text.cend());
}

std::string lower(std::string name) {
  name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
  return name;
}

const std::regex calls(
    R"(\b(Start|Rates|Acceleration|Observe|At|Moved|RungeKutta|Step|Speed|Braking|Coasted)\()");
const std::regex functions(R"(\b(Math\.|)(Hypot|Expm1|Asinh|Copysign)\()");

std::string in_lower_case(const std::string& code) {
  return replaced(code, calls, [](const std::smatch& m) { return lower(m[1].str()) + "("; });
}

/// The code with its helpers' names in lower case: of the functions that return an Array3 or the like.
std::string with_lower_helpers(std::string code) {
  static const std::regex head(R"(static Array\d+ (\w+)\()");
  std::vector<std::string> names;
  replaced(code, head, [&](const std::smatch& m) { return names.emplace_back(m[1]); });
  for (const std::string& name : names)
    code = std::regex_replace(code, std::regex("\\b" + name + "\\("), lower(name) + "(");
  return code;
}

std::string c_sharp(const std::string& code) {
  static const Changes changes{{std::regex(R"(\bcopy\((\w+)\))"), "(double[])$1.Clone()"},
                               {std::regex(R"(\bsize\((\w+)\))"), "$1.Length"},
                               {std::regex(R"(\b(State|Half|Seen|Weights|Row|Array\d+)\b)"), "double[]"},
                               {std::regex(R"(\bTable\d+\b)"), "double[][]"},
                               {std::regex(R"(\bTotal\b)"), "double"},
                               {std::regex(R"(\bPlaces\b)"), "int[]"}};
  return changed(code, changes);
}

std::string javascript(const std::string& code) {
  static const std::regex head(R"(static \w+ (\w+)\(([^)]*)\) \{)"), type(R"((State|Half|double) )"),
      math(R"(Math\.([A-Z]\w*)\()");
  static const Changes changes{{std::regex(R"(\bcopy\((\w+)\))"), "$1.slice()"},
                               {std::regex(R"(\bsize\((\w+)\))"), "$1.length"},
                               {std::regex(R"(new Table\d+ \{((\s*new Row \{[^}]*\},?)*)\})"), "[$1]"},
                               {std::regex(R"(new \w+ \{([^}]*)\})"), "[$1]"},
                               {std::regex(R"(\bTotal )"), "let "},
                               {std::regex(R"(foreach \(Row (\w+) in )"), "for (const $1 of "},
                               {std::regex(R"((static readonly|const) \w+ (\w+ =))"), "const $2"},
                               {std::regex(R"(\bdouble (\w+ =))"), "const $1"},
                               {std::regex(R"(static bool (\w+);)"), "let $1 = false;"},
                               {std::regex(R"(static (State|Half|int|double) )"), "let "},
                               {std::regex(R"(foreach \(var (\w+) in )"), "for (const $1 of "},
                               {std::regex(R"(\bvar (\w+ = (?!0;)))"), "const $1"},
                               {std::regex(R"(\bvar )"), "let "},
                               {std::regex(R"(Math\.iEEERemainder)"), "remainder"}};
  std::string text = replaced(code, head, [&](const std::smatch& m) {
    return "function " + m[1].str() + "(" + std::regex_replace(m[2].str(), type, "") + ") {";
  });
  text = replaced(text, functions, [](const std::smatch& m) { return "Math." + m[2].str() + "("; });
  text = replaced(text, math, [](const std::smatch& m) { return "Math." + lower(m[1].str()) + "("; });
  text = changed(text, changes);
  static const std::regex sign(R"(Math\.copysign\()");
  return in_lower_case(std::regex_replace(text, sign, "copysign("));
}

/// Parameters that their function does not use lose their names.
std::string without_unused(std::string code) {
  static const std::regex parameter(R"((\w+) (\w+)(?=[,)]))");
  for (auto at = code.find("static "); at != code.npos; at = code.find("\nstatic ", at + 1)) {
    const auto open = code.find('(', at), body = code.find(" {\n", at), end = code.find("\n}\n", at);
    if (body == code.npos || end == code.npos || open > body || code.find(';', at) < body) continue;
    const std::string inside = code.substr(body, end - body);
    const std::string names = replaced(code.substr(open, body - open), parameter, [&](const std::smatch& m) {
      return mentions(inside, m[2].str()) ? m[0].str() : m[1].str();
    });
    code.replace(open, body - open, names);
  }
  return code;
}

std::string cpp(const std::string& code) {
  static const std::regex head(R"(static (\w+) (\w+)\(([^)]*)\) \{)"), type(R"(\bState\b)"),
      math(R"(Math\.([A-Z]\w*)\()");
  static const Changes changes{
      {std::regex(R"(\bvar (\w+) = copy\((\w+)\))"), "auto $1 = $2"},
      {std::regex(R"(\bsize\((\w+)\))"), "$1.size()"},
      {std::regex(R"(static readonly Table(\d+) (\w+) =)"), "const double $2[][$1] ="},
      {std::regex(R"(new (Table\d+|Row|Places) \{)"), "{"},
      {std::regex(R"(new Weights \{)"), "{"},
      {std::regex(R"(static readonly Places (\w+) =)"), "const std::size_t $1[] ="},
      {std::regex(R"(static readonly Weights (\w+) =)"), "const double $1[] ="},
      {std::regex(R"(new (\w+) \{)"), "$1{"},
      {std::regex(R"(\bArray(\d+)\b)"), "std::array<double, $1>"},
      {std::regex(R"((static readonly |const |)\bdouble (\w+ =))"), "const double $2"},
      {std::regex(R"(static (State|Half|int|double|bool) ([^;(]*);)"), "$1 $2;"},
      {std::regex(R"(foreach \(var (\w+) in )"), "for (const std::size_t $1 : "},
      {std::regex(R"(foreach \(Row (\w+) in )"), "for (const auto& $1 : "},
      {std::regex(R"(for \(var (\w+) = 0)"), "for (std::size_t $1 = 0"},
      {std::regex(R"(\bTotal )"), "double "},
      {std::regex(R"(\bvar )"), "const auto "},
      {std::regex(R"(Math\.PI\b)"), "std::numbers::pi"},
      {std::regex(R"(std::iEEERemainder)"), "std::remainder"}};
  std::string text = replaced(without_unused(code), head, [&](const std::smatch& m) {
    return m[1].str() + " " + m[2].str() + "(" + std::regex_replace(m[3].str(), type, "const State&") + ") {";
  });
  text = replaced(text, functions, [](const std::smatch& m) { return "std::" + lower(m[2].str()) + "("; });
  text = replaced(text, math, [](const std::smatch& m) { return "std::" + lower(m[1].str()) + "("; });
  return in_lower_case(changed(text, changes));
}

}  // namespace

std::string Dialect::in(Language language, const std::string& code) const {
  if (language == Language::c_sharp) return c_sharp(code);
  if (language == Language::javascript) return javascript(with_lower_helpers(code));
  const auto array = [](const char* name, std::size_t n) {
    return "using " + std::string(name) + " = std::array<double, " + std::to_string(n) + ">;\n";
  };
  std::string arrays = array("Seen", observables);
  if (code.find("Half ") != code.npos) arrays = array("Half", unknowns / 2) + arrays;
  if (unknowns > 0) arrays = array("State", unknowns) + arrays;
  return arrays + "\n" + cpp(with_lower_helpers(code));
}

}  // namespace oddity
