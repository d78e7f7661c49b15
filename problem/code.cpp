#include "problem/code.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "reference/bad_input.hpp"
#include "reference/code_text.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

/// A piece of C++, and the binding strength of its operator: 1 a sum, 2 a product, 3 anything whole.
struct Piece {
  std::string text;
  int binds = 3;

  std::string at_least(int strength) const { return binds < strength ? "(" + text + ")" : text; }
};

/// A floating-point literal: C++ would divide two whole numbers without a remainder.
std::string literal(double value) {
  if (!std::isfinite(value)) throw BadInput("one of its numbers is not finite");
  const std::string text = format_shortest(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

class Writer {
 public:
  Writer(const Program& program, const std::vector<std::string>& names, const std::string& indent)
      : program_(program),
        names_(names),
        indent_(indent),
        pieces_(program.registers()),
        uses_(program.registers(), 0) {
    for (const auto& one : program.code()) {
      ++uses_[at(one.a)];
      if (takes_two(one.op)) ++uses_[at(one.b)];
      if (one.op == Op::choice) ++uses_[at(one.c)];
    }
    for (const int output : program.outputs()) ++uses_[at(output)];
    const std::size_t constants = program.constants().size();
    for (std::size_t i = 0; i < constants; ++i) {
      const auto value = static_cast<double>(program.constants()[i]);
      pieces_[i] = {literal(value), value < 0 ? 1 : 3};
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      pieces_[constants + i] = {names[i]};
      written_.used.push_back(uses_[constants + i] > 0);
    }
  }

  Written all() {
    for (const auto& one : program_.code()) add(one);
    for (const int output : program_.outputs()) written_.outputs.push_back(pieces_[at(output)].text);
    return written_;
  }

 private:
  static std::size_t at(int place) { return static_cast<std::size_t>(place); }
  static bool takes_two(Op op) {
    return op == Op::add || op == Op::subtract || op == Op::multiply || op == Op::divide || op == Op::arc ||
           op == Op::choice;
  }

  Piece called(const char* function, int a) const {
    return {std::string(function) + "(" + pieces_[at(a)].text + ")"};
  }
  Piece joined(int a, const char* sign, int b, int strength) const {
    return {pieces_[at(a)].at_least(strength) + sign + pieces_[at(b)].at_least(strength + 1), strength};
  }
  bool is_zero(int a) const {
    return at(a) < program_.constants().size() && program_.constants()[at(a)] == 0;
  }
  Piece piece(const Program::Instruction& one) const {
    switch (one.op) {
      case Op::add:
        return joined(one.a, " + ", one.b, 1);
      case Op::subtract:
        if (is_zero(one.a)) return {"-" + pieces_[at(one.b)].at_least(2), 1};
        return joined(one.a, " - ", one.b, 1);
      case Op::multiply:
        return joined(one.a, " * ", one.b, 2);
      case Op::divide:
        return joined(one.a, " / ", one.b, 2);
      case Op::square_root:
        return called("std::sqrt", one.a);
      case Op::sine:
      case Op::sine_and_cosine:
        return called("std::sin", one.a);
      case Op::cosine:
        return called("std::cos", one.a);
      case Op::exponential:
        return called("std::exp", one.a);
      case Op::logarithm:
        return called("std::log", one.a);
      case Op::arc:
        return {"std::atan2(" + pieces_[at(one.a)].text + ", " + pieces_[at(one.b)].text + ")"};
      case Op::choice:
        return {"(" + pieces_[at(one.a)].text + " > 0 ? " + pieces_[at(one.b)].text + " : " +
                pieces_[at(one.c)].text + ")"};
      case Op::input:
      case Op::constant:
        break;
    }
    return {};
  }
  void add(const Program::Instruction& one) {
    keep(at(one.result), piece(one));
    if (one.op == Op::sine_and_cosine) keep(at(one.result) + 1, called("std::cos", one.a));
  }
  /// Names an operation that is used more than once, or that would make a line too long to read.
  void keep(std::size_t result, Piece made) {
    constexpr std::size_t long_line = 90;
    if (uses_[result] > 1 || made.text.size() > long_line) {
      std::string name;
      do name = "s" + std::to_string(++named_);
      while (std::ranges::find(names_, name) != names_.end());
      written_.lines += indent_ + "const double " + name + " = " + made.text + ";\n";
      made = {name};
    }
    pieces_[result] = std::move(made);
  }

  const Program& program_;
  const std::vector<std::string>& names_;
  const std::string& indent_;
  std::vector<Piece> pieces_;
  std::vector<int> uses_;
  Written written_;
  int named_ = 0;
};

}  // namespace

Written written(const Program& program, const std::vector<std::string>& names, const std::string& indent) {
  return Writer(program, names, indent).all();
}

std::string comment_of(const File& file, const ModelText& model) {
  std::string about;
  const auto add = [&](const std::string& line) { about += "/// " + in_comment(line) + "\n"; };
  const auto add_all = [&](const Named& all) {
    for (const auto& [name, formula] : all) add("  " + name.text + " = " + formula.text);
  };
  add(file.title + ": " + model.name.text + ".");
  for (const Quoted& one : model.equations) add("  " + one.text);
  if (model.equations.empty() && model.lagrangian) add("  L = " + model.lagrangian->text);
  if (model.equations.empty() && model.hamiltonian) add("  H = " + model.hamiltonian->text);
  add_all(model.vectors);
  add_all(model.closed);
  add_all(file.given);
  return about;
}

std::string type_name(const std::string& called) {
  std::string name;
  bool begins = true;
  for (const char c : called) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) == 0 || letter > 127) {
      begins = begins || c != '\'';
      continue;
    }
    name += begins ? static_cast<char>(std::toupper(letter)) : c;
    begins = false;
  }
  const bool is_name = !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0;
  return is_name && !is_taken_in_cpp(name) ? name : "Model" + name;
}

bool is_taken_in_cpp(const std::string& name) {
  constexpr auto words = std::to_array<std::string_view>(
      {"alignas", "alignof", "and", "asm", "auto", "bool", "break", "case", "catch", "char", "class", "compl",
       "concept", "const", "consteval", "constexpr", "constinit", "continue", "co_await", "co_return",
       "co_yield", "decltype", "default", "delete", "do", "double", "else", "enum", "explicit", "export",
       "extern", "false", "float", "for", "friend", "goto", "if", "inline", "int", "long", "mutable",
       "namespace", "new", "noexcept", "not", "nullptr", "operator", "or", "private", "protected", "public",
       "register", "requires", "return", "short", "signed", "sizeof", "static", "struct", "switch",
       "template", "this", "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned",
       "using", "virtual", "void", "volatile", "while", "xor", "model", "std", "oddity",
       // members of the models, and macros of the headers
       "State", "Half", "start", "acceleration", "observe", "at", "NAN", "INFINITY", "EOF", "NULL", "stdin",
       "stdout", "stderr", "assert", "errno"});
  return name.starts_with("M_") || name.starts_with("_") || name.find("__") != std::string::npos ||
         std::ranges::find(words, name) != words.end();
}

}  // namespace oddity::problem
