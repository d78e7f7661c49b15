#include "formula/program.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <numbers>

#include "formula/code.hpp"

namespace oddity::formula {

namespace {

using Term = Code<CSharp>;

constexpr std::size_t line_length = 104;
constexpr std::size_t long_term = 60;  ///< letters; longer operands get names
constexpr int worth_a_constant = 2;    ///< operations

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool is_condition(std::string_view what) {
  return what == "<" || what == ">" || what == "<=" || what == ">=" || what == "==";
}

bool is_same_call(const Operation& a, const Operation& b) {
  return a.what == "call" && b.what == "call" && a.text == b.text && a.of == b.of;
}

/// "sin_x0" of sin(x[0]).
std::string plain_letters(const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (c != '[' && c != ']') plain += c;
  return plain;
}

std::string capitalized(std::string name) {
  name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

std::string listed(const std::vector<Term>& x) {
  std::string all;
  for (const Term& one : x) all += (all.empty() ? "" : ", ") + one.text();
  return all;
}

Term called(std::string_view what, const std::vector<Term>& x) {
  return Term::function(what, Term::term(listed(x)));
}

/// Writes a whole number as a double: a choice between two integers would be an integer.
std::string in_select(const Term& x) {
  return x.text().find_first_not_of("-0123456789") == x.text().npos ? x.text() + ".0" : x.text();
}

Term written(std::string_view what, const std::vector<Term>& x) {
  if (what == "+") return x[0] + x[1];
  if (what == "-") return x[0] - x[1];
  if (what == "*") return x[0] * x[1];
  if (what == "/") return x[0] / x[1];
  if (what == "negative") return -x[0];
  if (what == "select")
    return Term::term("(" + x[0].text() + " ? " + in_select(x[1]) + " : " + in_select(x[2]) + ")");
  if (is_condition(what)) return Term::term(x[0].text() + " " + std::string(what) + " " + x[1].text());
  return called(what, x);
}

}  // namespace

std::set<std::string> letters_of(const Record& record, const std::vector<std::vector<Recorded>>& results) {
  std::vector<bool> is_needed(record.operations().size());
  for (const auto& some : results)
    for (const Recorded& result : some)
      if (!result.is_known()) is_needed[index(result.at())] = true;
  std::set<std::string> letters;
  for (std::size_t i = is_needed.size(); i-- > 0;) {
    if (!is_needed[i]) continue;
    const Operation& operation = record.operations()[i];
    for (const int of : operation.of) is_needed[index(of)] = true;
    if (operation.what == "call")
      for (const int of : record.find_function(operation.text)->results) is_needed[index(of)] = true;
    if (operation.what == "letter") letters.insert(operation.text);
  }
  return letters;
}

/// Declarations, as many a line as it has room for.
std::vector<std::string> Program::packed(const std::string& type, const Lines& lines) {
  std::vector<std::string> all;
  bool goes_on = false;
  for (const auto& [text, is_declared] : lines) {
    if (goes_on && is_declared && all.back().size() + text.size() + 1 <= line_length)
      all.back().back() = ',', all.back() += " " + text + ";";
    else
      all.push_back(is_declared ? type + text + ";" : text);
    goes_on = is_declared;
  }
  return all;
}

/// Terms of operations within a function, or among the constants.
struct ProgramWriter {
  const Program& program;
  const Program::Named& constants;
  Program::Named& in;
  bool constant;
  /// The lines of each loop that is open, by its number; those outside all of them belong to -1.
  std::map<int, Program::Lines*> open = {{-1, &in.lines}};

  Term term(int i) {
    const Operation& operation = program.at(i);
    if (operation.what == "number")
      return operation.value == std::numbers::pi ? Term::term(std::string(CSharp::pi))
                                                 : Term(operation.value);
    if (operation.what == "letter") return Term::term(operation.text);
    if (!constants.names[index(i)].empty()) return Term::term(constants.names[index(i)]);
    if (operation.what == "sum" && in.names[index(i)].empty()) write_loop(i);
    if (operation.what == "call" && in.names[index(i)].empty()) write_call(i);
    const bool is_worth_a_name = !program.is_cheap(i) && !is_condition(operation.what);
    if (in.names[index(i)].empty() && in.uses[index(i)] > 1 && is_worth_a_name) name(i);
    if (!in.names[index(i)].empty()) return Term::term(in.names[index(i)]);
    return inlined(i);
  }
  Term inlined(int i) { return written(program.at(i).what, operands(i)); }
  std::vector<Term> operands(int i, std::size_t longest = long_term) {
    std::vector<Term> of;
    for (const int operand : program.at(i).of) {
      Term one = term(operand);
      if (one.text().size() > longest && !is_condition(program.at(operand).what)) {
        if (in.names[index(operand)].empty()) name(operand, one);
        one = Term::term(in.names[index(operand)]);
      }
      of.push_back(one);
    }
    return of;
  }
  void name(int i) { name(i, inlined(i)); }
  void name(int i, const Term& term) {
    in.names[index(i)] = program.name_of(i, constant, in.taken);
    open.at(program.loop_of_[index(i)])->push_back({in.names[index(i)] + " = " + term.text()});
  }
  /// With all other components of its result.
  void write_call(int call) {
    const Operation& operation = program.at(call);
    const std::vector<Term> arguments = operands(call, line_length / operation.of.size());
    const std::string& helper = program.helper_name(operation.text);
    std::string name;
    for (int number = 1; !in.taken.insert(name = helper + std::to_string(number)).second;) ++number;
    open.at(program.loop_of_[index(call)])
        ->push_back({"var " + name + " = " + capitalized(helper) + "(" + listed(arguments) + ");", false});
    for (std::size_t i = 0; i < in.names.size(); ++i)
      if (const Operation& other = program.record_.operations()[i]; is_same_call(other, operation))
        in.names[i] = name + "[" + std::to_string(other.component) + "]";
  }
  /// With all other sums of its loop that are needed at the same place.
  void write_loop(int sum) {
    const auto& loops = program.record_.loops();
    const std::string& row = program.at(sum).text;
    const auto loop = std::ranges::find(loops, row, &Loop::row);
    const int number = static_cast<int>(loop - loops.begin()), around = program.loop_of_[index(sum)];
    std::string totals;
    Program::Lines lines, added;
    open[number] = &lines;
    for (int i = 0; i < static_cast<int>(in.uses.size()); ++i) {
      if (program.at(i).what != "sum" || program.at(i).text != row || in.uses[index(i)] == 0 ||
          program.loop_of_[index(i)] != around)
        continue;
      const Term summed = term(program.at(i).of[0]);
      const std::string& name = in.names[index(i)] = program.name_of(i, constant, in.taken);
      totals += (totals.empty() ? "Total " : ", ") + name + " = 0.0";
      added.push_back({"  " + name + " += " + summed.text() + ";", false});
    }
    open.erase(number);
    for (std::size_t i = 0; i < in.names.size(); ++i)
      if (program.loop_of_[i] == number) in.names[i].clear();
    Program::Lines& outside = *open.at(around);
    outside.push_back({totals + ";", false});
    outside.push_back({"foreach (Row " + row + " in " + program.table_name(loop->table) + ") {", false});
    for (const std::string& line : Program::packed("double ", lines)) outside.push_back({"  " + line, false});
    outside.insert(outside.end(), added.begin(), added.end());
    outside.push_back({"}", false});
  }
  /// Returns early where one condition chooses all results. Gives the results in the remaining case.
  std::vector<int> return_early(std::vector<int> results) {
    const auto branch = [&](std::size_t operand) {
      std::vector<int> all;
      for (const int result : results) all.push_back(program.at(result).of[operand]);
      return all;
    };
    const auto is_chosen = [&](int result) {
      const Operation& first = program.at(results.front());
      return first.what == "select" && program.at(result).what == "select" &&
             program.at(result).of[0] == first.of[0];
    };
    while (std::ranges::all_of(results, is_chosen)) {
      const std::string condition = term(program.at(results.front()).of[0]).text();
      const std::vector<int> yes = branch(1), no = branch(2);
      if (std::ranges::all_of(no, [&](int i) { return program.is_cheap(i); })) {
        in.lines.push_back({"if (!(" + condition + ")) " + returned(no), false});
        results = yes;
      } else {
        Program::Lines inside;
        const auto names = in.names;
        open[-1] = &inside;
        const std::string last = returned(yes);
        open[-1] = &in.lines;
        in.names = names;
        in.lines.push_back({"if (" + condition + ") {", false});
        for (const std::string& line : Program::packed("double ", inside))
          in.lines.push_back({"  " + line, false});
        in.lines.push_back({"  " + last, false});
        in.lines.push_back({"}", false});
        results = no;
      }
    }
    return results;
  }
  std::string returned(const std::vector<int>& results) {
    std::vector<Term> terms;
    for (const int result : results) terms.push_back(term(result));
    return "return new Array" + std::to_string(results.size()) + " {" + listed(terms) + "};";
  }
};

/// Numbers of loops grow inwards. A sum does not depend on the row that it goes over.
void Program::find_loops() {
  const auto& operations = record_.operations();
  std::vector<std::set<int>> rows(operations.size());
  for (std::size_t i = 0; i < operations.size(); ++i) {
    for (const int of : operations[i].of) rows[i].insert(rows[index(of)].begin(), rows[index(of)].end());
    for (std::size_t k = 0; k < record_.loops().size(); ++k) {
      const std::string& row = record_.loops()[k].row;
      if (operations[i].what == "letter" && operations[i].text.starts_with(row + "["))
        rows[i].insert(static_cast<int>(k));
      if (operations[i].what == "sum" && operations[i].text == row) rows[i].erase(static_cast<int>(k));
    }
    loop_of_.push_back(rows[i].empty() ? -1 : *rows[i].rbegin());
  }
}

/// A helper's constants and tables are those that nothing else needs.
void Program::find_helpers(const Results& often, const Results& seldom) {
  const std::size_t n = record_.operations().size();
  const auto& functions = record_.functions();
  std::vector<int> uses(n);
  for (const Results* all : {&often, &seldom})
    for (const auto& results : *all)
      for (const Recorded& result : results)
        if (!result.is_known()) count(result.at(), uses);
  std::vector<std::vector<int>> uses_in(functions.size(), std::vector<int>(n));
  helper_names_.resize(functions.size());
  for (std::size_t k = functions.size(); k-- > 0;) {
    const auto calls = [&](const std::vector<int>& all) {
      for (std::size_t i = 0; i < n; ++i)
        if (all[i] > 0 && record_.operations()[i].what == "call" &&
            record_.operations()[i].text == functions[k].name)
          return true;
      return false;
    };
    if (!calls(uses) && std::ranges::none_of(uses_in, calls)) continue;
    helper_names_[k] = free_name(functions[k].name, constants_.taken);
    for (const int result : functions[k].results) count(result, uses_in[k]), count(result, constants_.uses);
  }
  helper_of_.assign(n, no_helper);
  helpers_of_table_.resize(record_.tables().size());
  for (std::size_t i = 0; i < n; ++i) {
    std::set<int> users;
    if (uses[i] > 0) users.insert(no_helper);
    for (std::size_t k = 0; k < functions.size(); ++k)
      if (uses_in[k][i] > 0) users.insert(static_cast<int>(k));
    if (users.size() == 1) helper_of_[i] = *users.begin();
    if (const Operation& sum = record_.operations()[i]; sum.what == "sum" && !users.empty())
      helpers_of_table_[std::ranges::find(record_.loops(), sum.text, &Loop::row)->table].insert(
          helper_of_[i]);
  }
}

const std::string& Program::helper_name(const std::string& function) const {
  const auto found = std::ranges::find(record_.functions(), function, &Function::name);
  return helper_names_[static_cast<std::size_t>(found - record_.functions().begin())];
}

Program::Program(const Record& record, std::set<std::string> moving, const Results& often,
                 std::set<std::string> taken, const Results& seldom)
    : record_(record) {
  const std::size_t n = record.operations().size();
  find_loops();
  for (const Loop& loop : record.loops()) {
    taken.insert({loop.row, table_name(loop.table)});
    for (std::size_t i = 0; i < record.tables()[loop.table].front().size(); ++i)
      moving.insert(loop.row + "[" + std::to_string(i) + "]");
  }
  for (const Function& function : record.functions()) {
    taken.insert(function.arguments.begin(), function.arguments.end());
    moving.insert(function.arguments.begin(), function.arguments.end());
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Operation& operation = record.operations()[i];
    const auto is_fixed = [&](int of) { return fixed_[index(of)]; };
    fixed_.push_back(operation.what == "letter"
                         ? !moving.contains(operation.text)
                         : operation.what != "call" && std::ranges::all_of(operation.of, is_fixed));
  }
  constants_ = {std::vector<std::string>(n), std::vector<int>(n), std::move(taken), {}};
  for (const auto& results : often)
    for (const Recorded& result : results)
      if (!result.is_known()) count(result.at(), constants_.uses);
  find_helpers(often, seldom);
  std::vector<bool> from_moving(n);
  for (std::size_t i = 0; i < n; ++i)
    if (!fixed_[i] && constants_.uses[i] > 0)
      for (const int of : record.operations()[i].of) from_moving[index(of)] = true;
  Named none{std::vector<std::string>(n), {}, {}, {}};
  ProgramWriter writer{*this, none, constants_, true};
  for (std::size_t i = 0; i < n; ++i) {
    const int at_i = static_cast<int>(i);
    if (!fixed_[i] || is_cheap(at_i) || is_condition(at(at_i).what)) continue;
    writer.open[-1] = helper_of_[i] == no_helper ? &constants_.lines : &constants_of_helpers_[helper_of_[i]];
    if (constants_.uses[i] > 1 ||
        (constants_.uses[i] == 1 && from_moving[i] && cost(at_i) > worth_a_constant))
      if (constants_.names[i].empty()) writer.name(at_i);
  }
}

bool Program::is_cheap(int i) const {
  return is_atom(i) || (at(i).what == "negative" && is_atom(at(i).of[0]));
}

void Program::count(int i, std::vector<int>& uses) const {
  if (uses[index(i)]++ > 0) return;
  if (at(i).what == "call")
    for (std::size_t k = 0; k < uses.size(); ++k)
      if (k != index(i) && uses[k] > 0 && is_same_call(record_.operations()[k], at(i))) return;
  for (const int of : at(i).of) count(of, uses);
}

int Program::cost(int i) const {
  int all = is_atom(i) ? 0 : 1;
  for (const int of : at(i).of) all += cost(of);
  return all;
}

std::string Program::name_of(int i, bool constant, std::set<std::string>& taken) const {
  const Operation& operation = at(i);
  std::string base = constant ? "c" : "s";
  if (operation.what.size() >= 3 && operation.of.size() == 1 && operation.what != "negative") {
    base = operation.what;
    if (const Operation& of = at(operation.of[0]); of.what == "letter")
      return free_name(base + "_" + plain_letters(of.text), taken);
  }
  for (int number = 1;; ++number)
    if (std::string name = base + std::to_string(number); taken.insert(name).second) return name;
}

std::vector<std::string> Program::constants_of(int helper) const {
  const auto own = constants_of_helpers_.find(helper);
  std::vector<std::string> lines =
      packed("static readonly double ", helper == no_helper                  ? constants_.lines
                                        : own != constants_of_helpers_.end() ? own->second
                                                                             : Lines());
  for (std::size_t table = 0; table < record_.tables().size(); ++table) {
    const std::set<int>& users = helpers_of_table_[table];
    if (users.empty() || (users.size() == 1 ? *users.begin() : no_helper) != helper) continue;
    const auto& rows = record_.tables()[table];
    const std::string type = "Table" + std::to_string(rows.front().size());
    lines.push_back("static readonly " + type + " " + table_name(table) + " = new " + type + " {");
    std::size_t length = line_length;
    for (const auto& row : rows) {
      std::string numbers;
      for (const double x : row) numbers += (numbers.empty() ? "" : ", ") + Term(x).text();
      length += numbers.size() + 4;  // in C++
      if (length > line_length) lines.emplace_back(" "), length = numbers.size() + 4;
      lines.back() += " new Row {" + numbers + "},";
    }
    lines.back().back() = '}';
    lines.back() += ";";
  }
  return lines;
}

Statements Program::function(const std::vector<Recorded>& results) {
  const std::size_t n = record_.operations().size();
  Named in{std::vector<std::string>(n), std::vector<int>(n), constants_.taken, {}};
  for (const Recorded& result : results)
    if (!result.is_known()) count(result.at(), in.uses);
  ProgramWriter writer{*this, constants_, in, false};
  Statements made;
  for (const Recorded& result : results)
    made.terms.push_back(result.is_known() ? Term(result.value()).text() : writer.term(result.at()).text());
  made.lines = packed("double ", in.lines);
  return made;
}

Statements Program::function_with_returns(const std::vector<int>& results) {
  const std::size_t n = record_.operations().size();
  Named in{std::vector<std::string>(n), std::vector<int>(n), constants_.taken, {}};
  for (const int result : results) count(result, in.uses);
  ProgramWriter writer{*this, constants_, in, false};
  Statements made;
  for (const int result : writer.return_early(results)) made.terms.push_back(writer.term(result).text());
  made.lines = packed("double ", in.lines);
  return made;
}

std::vector<Program::Helper> Program::helpers() {
  std::vector<Helper> all;
  for (std::size_t k = 0; k < helper_names_.size(); ++k)
    if (const Function& function = record_.functions()[k]; !helper_names_[k].empty())
      all.push_back({helper_names_[k], function.arguments, constants_of(static_cast<int>(k)),
                     function_with_returns(function.results)});
  return all;
}

}  // namespace oddity::formula
