#include "extras/mutation/points.hpp"

#include <clang-c/Index.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <tuple>

#include "extras/mutation/kept_points.hpp"
#include "reference/bad_input.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;

namespace {

std::string text_of(CXString s) {
  const char* c = clang_getCString(s);
  std::string text = c ? c : "";
  clang_disposeString(s);
  return text;
}

std::string read(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string trimmed(const std::string& s) {
  const auto first = s.find_first_not_of(" \n");
  return first == s.npos ? "" : s.substr(first, s.find_last_not_of(" \n") + 1 - first);
}

struct Operator {
  Shape shape;
  std::string other;     ///< the operator that it becomes
  std::string function;  ///< its name in mutant.hpp
  std::vector<std::string> mutations(const std::string& op) const {
    const std::string to = op + " to " + other;
    switch (shape) {
      case Shape::operation:
        return {to, op + " to its left", op + " to its right"};
      case Shape::assignment:
        return {to, op + " left out"};
      default:
        break;
    }
    if (op == "==" || op == "!=") return {to};
    return {op + " to " + (op.size() == 1 ? op + "=" : op.substr(0, 1)), to};
  }
};

/// The operators with both operands evaluated.
const std::map<std::string, Operator> operators{
    {"+", {Shape::operation, "-", "operation"}},     {"-", {Shape::operation, "+", "operation"}},
    {"*", {Shape::operation, "/", "operation"}},     {"/", {Shape::operation, "*", "operation"}},
    {"%", {Shape::operation, "*", "operation"}},     {"+=", {Shape::assignment, "-=", "assignment"}},
    {"-=", {Shape::assignment, "+=", "assignment"}}, {"*=", {Shape::assignment, "/=", "assignment"}},
    {"/=", {Shape::assignment, "*=", "assignment"}}, {"<", {Shape::comparison, ">=", "less"}},
    {"<=", {Shape::comparison, ">", "at_most"}},     {">", {Shape::comparison, "<=", "greater"}},
    {">=", {Shape::comparison, "<", "at_least"}},    {"==", {Shape::comparison, "!=", "equal"}},
    {"!=", {Shape::comparison, "==", "unequal"}},
};

/// Collects the points of every wanted file of a translation unit.
class Collector {
 public:
  Collector(const fs::path& tree, const std::function<bool(const std::string&)>& wanted)
      : tree_(tree.string() + "/"), wanted_(wanted) {}

  /// Visits the unit's declarations in files that no earlier unit has shown, and returns these files.
  std::vector<Mutable> visit(CXTranslationUnit unit) {
    opened_ = {};
    seen_before_ = {};
    for (const auto& [name, file] : files_) seen_before_.insert(name);
    visit_children(clang_getTranslationUnitCursor(unit), {});
    std::vector<Mutable> shown;
    for (const auto& [name, file] : files_)
      if (!seen_before_.contains(name)) shown.push_back(file);
    return shown;
  }

  /// Takes the files that the unit has shown in an earlier run. Returns whether these are all that it has to
  /// show now.
  bool take(const KeptPoints::Unit& unit) {
    for (const Mutable& file : unit.shown) files_.try_emplace(file.file, file);
    return std::ranges::all_of(unit.included, [&](const auto& file) {
      const std::string name = file.first.substr(tree_.size());
      return !wanted_(name) || files_.contains(name);
    });
  }

  /// The tree's files that the unit includes.
  std::vector<std::string> included(CXTranslationUnit unit) const {
    std::pair<const std::string*, std::vector<std::string>> of_tree{&tree_, {}};
    clang_getInclusions(
        unit,
        [](CXFile file, CXSourceLocation*, unsigned, CXClientData data) {
          auto& [tree, all] = *static_cast<decltype(of_tree)*>(data);
          const std::string path = fs::weakly_canonical(text_of(clang_getFileName(file))).string();
          if (path.starts_with(*tree) && fs::exists(path)) all.push_back(path);
        },
        &of_tree);
    return of_tree.second;
  }

  std::vector<Mutable> files() {
    std::vector<Mutable> all;
    for (auto& [name, file] : files_) {
      for (const Point& p : file.points) file.free += p.free ? static_cast<int>(p.mutations.size()) : 0;
      std::erase_if(file.points, [](const Point& p) { return p.free; });
      std::ranges::stable_sort(file.points, {}, [](const Point& p) {
        return std::tuple(p.whole.begin, -static_cast<long>(p.whole.end), p.shape != Shape::statement);
      });
      all.push_back(std::move(file));
    }
    return all;
  }

 private:
  struct Around {
    CXCursor parent = clang_getNullCursor();
    std::string function;
    bool compile_time = false;
    bool free = false;  ///< whatever is written here, the results must be the same
  };

  static bool is(CXCursor c, std::initializer_list<CXCursorKind> kinds) {
    return std::ranges::find(kinds, clang_getCursorKind(c)) != kinds.end();
  }

  /// The file of the cursor, if it is wanted and this unit has to show it.
  Mutable* file_of(CXCursor c) {
    CXFile file = nullptr;
    clang_getSpellingLocation(clang_getCursorLocation(c), &file, nullptr, nullptr, nullptr);
    if (!file) return nullptr;
    const auto [known, unknown] = opened_.try_emplace(file, nullptr);
    if (unknown) known->second = open(fs::weakly_canonical(text_of(clang_getFileName(file))).string());
    return known->second;
  }

  Mutable* open(const std::string& path) {
    if (!path.starts_with(tree_)) return nullptr;
    const std::string name = path.substr(tree_.size());
    if (seen_before_.contains(name) || !wanted_(name)) return nullptr;
    auto [at, fresh] = files_.try_emplace(name);
    if (fresh) at->second = {name, read(path), {}, 0};
    return &at->second;
  }

  /// The cursor's text, unless a macro wrote it.
  static std::optional<Extent> extent_of(CXCursor c) {
    const CXSourceRange range = clang_getCursorExtent(c);
    Extent e;
    for (const auto& [place, offset] :
         {std::pair(clang_getRangeStart(range), &e.begin), std::pair(clang_getRangeEnd(range), &e.end)}) {
      unsigned expanded = 0;
      clang_getSpellingLocation(place, nullptr, nullptr, nullptr, offset);
      clang_getExpansionLocation(place, nullptr, nullptr, nullptr, &expanded);
      if (expanded != *offset) return {};
    }
    return e.begin < e.end ? std::optional(e) : std::nullopt;
  }

  static std::vector<CXCursor> children_of(CXCursor c) {
    std::vector<CXCursor> all;
    clang_visitChildren(
        c,
        [](CXCursor child, CXCursor, CXClientData data) {
          static_cast<std::vector<CXCursor>*>(data)->push_back(child);
          return CXChildVisit_Continue;
        },
        &all);
    return all;
  }

  bool if_constexpr(CXCursor c) {
    if (!is(c, {CXCursor_IfStmt})) return false;
    const Mutable* file = file_of(c);
    const auto e = extent_of(c);
    return file && e && file->text.substr(e->begin, 12) == "if constexpr";
  }

  void visit_children(CXCursor c, const Around& around) {
    const std::vector<CXCursor> children = children_of(c);
    for (std::size_t i = 0; i < children.size(); ++i) {
      Around below = around;
      below.parent = c;
      const bool label = is(c, {CXCursor_CaseStmt}) && i == 0;
      below.compile_time = around.compile_time || label || (i == 0 && if_constexpr(c));
      below.free = around.free || free_below(c, i);
      visit_one(children[i], below);
    }
  }

  void visit_one(CXCursor c, Around around) {
    if (is(around.parent, {CXCursor_TranslationUnit}) &&
        clang_Location_isInSystemHeader(clang_getCursorLocation(c)))
      return;
    if (is(c, {CXCursor_StaticAssert, CXCursor_EnumDecl, CXCursor_NonTypeTemplateParameter,
               CXCursor_TemplateTypeParameter, CXCursor_TypedefDecl, CXCursor_TypeAliasDecl,
               CXCursor_TypeAliasTemplateDecl}))
      around.compile_time = true;
    if (is(c, {CXCursor_FunctionDecl, CXCursor_CXXMethod, CXCursor_Constructor, CXCursor_FunctionTemplate,
               CXCursor_ConversionFunction})) {
      around.function = text_of(clang_getCursorSpelling(c));
      around.free |= around.function == "where";  // the text that describes a sample
    }
    Mutable* file = clang_isDeclaration(clang_getCursorKind(c)) ||
                            clang_isExpression(clang_getCursorKind(c)) ||
                            clang_isStatement(clang_getCursorKind(c))
                        ? file_of(c)
                        : nullptr;
    if (file) {
      if (const auto e = extent_of(c)) {
        if (file->text.substr(e->begin, 8) == "requires") around.compile_time = true;
        if (is(c, {CXCursor_VarDecl, CXCursor_FieldDecl}) && declared_constant(*file, *e))
          around.compile_time = true;
        consider(*file, c, *e, around);
      }
    }
    visit_children(c, around);
  }

  static std::string name_of(CXCursor c) { return text_of(clang_getCursorSpelling(c)); }

  /// The cursor's text; "" if a macro wrote it.
  static std::string written(CXCursor c) {
    CXFile file = nullptr;
    clang_getSpellingLocation(clang_getCursorLocation(c), &file, nullptr, nullptr, nullptr);
    std::size_t size = 0;
    const char* text =
        file ? clang_getFileContents(clang_Cursor_getTranslationUnit(c), file, &size) : nullptr;
    const auto e = extent_of(c);
    return text && e && e->end <= size ? std::string(text + e->begin, e->end - e->begin) : "";
  }

  /// Whether the cursor's child is free: the choice and number of samples, or a number that is only made into
  /// text. The former are arguments of Random, numbers next to a seed, and the head of a loop over a
  /// `sample`.
  static bool free_below(CXCursor c, std::size_t child) {
    if (is(c, {CXCursor_ForStmt})) {
      const auto children = children_of(c);
      return child < 3 && child + 1 < children.size() && is(children[0], {CXCursor_DeclStmt}) &&
             name_of(children_of(children[0]).at(0)) == "sample";
    }
    if (!is(c, {CXCursor_CallExpr})) return false;
    const CXCursor called = clang_getCursorReferenced(c);
    if (is(called, {CXCursor_CXXMethod, CXCursor_Constructor}) &&
        name_of(clang_getCursorSemanticParent(called)) == "Random")
      return true;
    const std::string name = name_of(c);
    if (name == "to_string" || name.starts_with("format_")) return true;
    const auto children = children_of(c);
    static const std::regex seed("seed|p\\[\"seed\"\\]"), number("-?[0-9][-+0-9a-fxp.']*");
    return std::regex_match(written(children[child]), number) &&
           std::ranges::any_of(children,
                               [&](CXCursor other) { return std::regex_match(written(other), seed); });
  }

  static bool declared_constant(const Mutable& file, Extent e) {
    const std::string head = file.text.substr(e.begin, 40);
    return head.starts_with("constexpr ") || head.starts_with("static constexpr ") ||
           head.starts_with("inline constexpr ");
  }

  /// Whether the text at this place is a template argument: between < and > without spaces, as clang-format
  /// writes them.
  static bool template_argument(const std::string& text, unsigned at) {
    int open = 0;
    for (unsigned i = at; i-- > 0;) {
      const char c = text[i];
      const bool spaced = (i > 0 && text[i - 1] == ' ') || text[i + 1] == ' ' || text[i + 1] == '=';
      if (c == ')' || c == ']' || c == '}') ++open;
      if (c == '(' || c == '[' || c == '{') {
        if (open-- == 0) return false;
      }
      if (c == ';') return false;
      if (c == '>' && i > 0 && text[i - 1] != '-' && text[i - 1] != ' ') ++open;
      if (c == '<' && !spaced && open-- == 0) return true;
    }
    return false;
  }

  void add(Mutable& file, const Around& around, Point point) {
    const bool decided = around.compile_time || template_argument(file.text, point.whole.begin);
    if (decided || around.function.empty()) {
      ++file.left_out;
      return;
    }
    const auto same = [&](const Point& p) { return p.whole == point.whole && p.shape == point.shape; };
    if (std::ranges::any_of(file.points, same)) return;
    point.within = around.function;
    point.free = around.free;
    file.points.push_back(std::move(point));
  }

  void consider(Mutable& file, CXCursor c, Extent e, const Around& around) {
    switch (clang_getCursorKind(c)) {
      case CXCursor_BinaryOperator:
      case CXCursor_CompoundAssignOperator:
        consider_operation(file, c, e, around);
        break;
      case CXCursor_CallExpr:
        if (clang_Cursor_getNumArguments(c) == 1)
          consider_sign(file, c, e, around);
        else
          consider_operation(file, c, e, around);
        break;
      case CXCursor_UnaryOperator:
        consider_sign(file, c, e, around);
        break;
      case CXCursor_IntegerLiteral:
      case CXCursor_FloatingLiteral:
        consider_literal(file, c, e, around);
        break;
      case CXCursor_IfStmt:
      case CXCursor_ConditionalOperator:
        consider_condition(file, c, e, around);
        break;
      default:
        break;
    }
    consider_statement(file, c, e, around);
  }

  void consider_sign(Mutable& file, CXCursor c, Extent e, const Around& around) {
    if (file.text[e.begin] != '-' || file.text[e.begin + 1] == '-' || !number(c)) return;
    const bool call = is(c, {CXCursor_CallExpr});
    const auto operand = extent_of(call ? clang_Cursor_getArgument(c, 0) : children_of(c).at(0));
    if (!operand || operand->begin == e.begin || operand->end != e.end) return;  // a conversion of -a + b
    add(file, around, {Shape::sign, "negative", e, {e.begin, e.begin + 1}, {}, {}, {"- left out"}});
  }

  static std::optional<std::pair<CXCursor, CXCursor>> operands_of(CXCursor c) {
    if (!is(c, {CXCursor_CallExpr})) {
      const auto children = children_of(c);
      return children.size() == 2 ? std::optional(std::pair(children[0], children[1])) : std::nullopt;
    }
    if (clang_Cursor_getNumArguments(c) != 2) return {};
    return std::pair(clang_Cursor_getArgument(c, 0), clang_Cursor_getArgument(c, 1));
  }

  /// Whether values of this type may be numbers: built-in, our own, or of a template parameter.
  static bool number(CXCursor c) {
    const CXType type = clang_getCanonicalType(clang_getCursorType(c));
    if (type.kind == CXType_Pointer || type.kind == CXType_Enum) return false;
    const std::string name = text_of(clang_getTypeSpelling(type));
    return name.find("std::") == name.npos && name.find("__gnu") == name.npos &&
           name.find("Eigen::") == name.npos;
  }

  void consider_operation(Mutable& file, CXCursor c, Extent e, const Around& around) {
    const auto operands = operands_of(c);
    if (!operands) return;
    const auto a = extent_of(operands->first), b = extent_of(operands->second);
    if (!a || !b || a->begin != e.begin || b->end != e.end || a->end > b->begin) return;
    const std::string op = trimmed(file.text.substr(a->end, b->begin - a->end));
    if (file.text[b->begin] == '{') return;
    if ((op == "&&" || op == "||") && clang_getCursorType(c).kind == CXType_Bool) {
      add(file, around,
          {Shape::logic,
           op,
           e,
           {a->end, b->begin},
           {},
           {},
           {op + " without its left", op + " without its right"}});
      return;
    }
    const auto known = operators.find(op);
    const bool equality = op == "==" || op == "!=";
    if (known == operators.end() || (!equality && (!number(operands->first) || !number(operands->second))))
      return;
    const Operator& known_op = known->second;
    add(file, around,
        {known_op.shape,
         known_op.function,
         e,
         {a->end, b->begin},
         {op, known_op.other},
         {},
         known_op.mutations(op)});
  }

  void consider_literal(Mutable& file, CXCursor c, Extent e, const Around& around) {
    const std::string literal = file.text.substr(e.begin, e.end - e.begin);
    const char before = e.begin > 0 ? file.text[e.begin - 1] : ' ';
    if (literal.empty() || !(std::isdigit(static_cast<unsigned char>(literal[0])) || literal[0] == '.'))
      return;
    const bool bound = before == '[' && is(around.parent, {CXCursor_VarDecl, CXCursor_FieldDecl,
                                                           CXCursor_ParmDecl, CXCursor_CXXNewExpr});
    if (bound || !number(c)) return;
    if (before == '[' && file.text[e.end] == ']')
      add(file, around,
          {Shape::literal,
           "index",
           e,
           {},
           {},
           {},
           {"index " + literal + (literal == "0" ? " to 1" : " less 1")}});
    else
      add(file, around, {Shape::literal, "constant", e, {}, {}, {}, {"constant " + literal}});
  }

  void consider_condition(Mutable& file, CXCursor c, Extent e, const Around& around) {
    if (is(c, {CXCursor_IfStmt}) && !file.text.substr(e.begin, 4).starts_with("if (")) return;
    const auto children = children_of(c);
    if (children.empty() || !clang_isExpression(clang_getCursorKind(children[0]))) return;
    const auto condition = extent_of(children[0]);
    if (!condition) return;
    if (is(c, {CXCursor_IfStmt}) && (condition->begin != e.begin + 4 || file.text[condition->end] != ')'))
      return;
    const CXCursorKind kind = clang_getCursorKind(children[0]);
    if (kind == CXCursor_BinaryOperator || operands_of(children[0])) return;  // its own mutants cover this
    if (clang_getCursorType(children[0]).kind != CXType_Bool) return;
    add(file, around, {Shape::condition, "", *condition, {}, {}, {}, {"the opposite condition"}});
  }

  void consider_statement(Mutable& file, CXCursor c, Extent e, const Around& around) {
    if (!is(around.parent,
            {CXCursor_CompoundStmt, CXCursor_IfStmt, CXCursor_ForStmt, CXCursor_CXXForRangeStmt}) ||
        file.text[e.end] != ';' ||
        !is(c, {CXCursor_CallExpr, CXCursor_BinaryOperator, CXCursor_UnexposedExpr}))
      return;
    const auto last = file.text.find_last_not_of(" \n", e.begin - 1);
    const char before = last == std::string::npos ? ';' : file.text[last];
    const bool in_block = is(around.parent, {CXCursor_CompoundStmt});  // otherwise it may be part of a loop's
                                                                       // head
    if (before == ')' || (in_block && (before == ';' || before == '{' || before == '}')))
      add(file, around, {Shape::statement, "", e, {}, {}, {}, {"statement left out"}});
  }

  std::string tree_;
  std::function<bool(const std::string&)> wanted_;
  std::map<std::string, Mutable> files_;
  std::set<std::string> seen_before_;
  std::map<CXFile, Mutable*> opened_;  ///< this unit's files; null for those that are not wanted
};

/// The arguments of a compile command that clang needs: language, folders, definitions.
std::vector<std::string> arguments_of(const std::string& command) {
  std::istringstream words(command);
  std::vector<std::string> kept{"clang++", "-std=c++20", "-w"};
  for (std::string word, value; words >> word;) {
    if (word.starts_with("-D") || (word.starts_with("-I") && word.size() > 2)) kept.push_back(word);
    if (word == "-isystem" && words >> value) kept.insert(kept.end(), {word, value});
  }
  return kept;
}

/// The headers that a unit includes before its text: those of a fast build, compiled once for all.
std::string included_before(const std::string& command) {
  std::istringstream words(command);
  std::string text;
  for (std::string word, value; words >> word;)
    if (word == "-include" && words >> value) text += "#include \"" + value + "\"\n";
  return text;
}

/// Whether a unit's text, or a file that it includes directly, is wanted.
bool shows_wanted(const std::string& file, const std::string& text, const std::string& tree,
                  const std::function<bool(const std::string&)>& wanted) {
  if (file.starts_with(tree) && wanted(file.substr(tree.size()))) return true;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#include \"")) continue;
    std::string name = line.substr(10, line.find('"', 10) - 10);
    if (name.starts_with(tree)) name = name.substr(tree.size());
    if (wanted(name)) return true;
  }
  return false;
}

}  // namespace

std::vector<Mutable> mutable_files(const fs::path& tree, const fs::path& compiled,
                                   const std::function<bool(const std::string&)>& wanted,
                                   const fs::path& kept_in) {
  const fs::path commands = compiled / "compile_commands.json";
  if (!fs::exists(commands))
    throw BadInput(commands.string() + " is not there: configure with CMake first, as ./oddity does");
  Collector collector(tree, wanted);
  KeptPoints kept(kept_in);
  const CXIndex index = clang_createIndex(0, 0);
  for (const auto& entry : nlohmann::json::parse(read(commands))) {
    const std::string file = entry["file"], command = entry["command"];
    if (file.find("cmake_pch") != file.npos || file.find("/lanes/") != file.npos ||
        file.find("/walk/") != file.npos || file.find("/tests/") != file.npos ||
        file.find("/module/") != file.npos || command.find("ODDITY_LONG_DOUBLE") != command.npos)
      continue;
    if (!shows_wanted(file, read(file), tree.string() + "/", wanted)) continue;
    const std::string own_text = command + read(file);
    const KeptPoints::Unit* known = kept.of(file, own_text);
    if (known && collector.take(*known)) continue;
    std::cerr << "reading " << file << "\n";
    const std::string text = included_before(command) + "#include \"" + file + "\"\n";
    const std::string name = (compiled / "mutated_unit.cpp").string();
    CXUnsavedFile unsaved{name.c_str(), text.c_str(), static_cast<unsigned long>(text.size())};
    const std::vector<std::string> arguments = arguments_of(command);
    std::vector<const char*> argv;
    for (const std::string& a : arguments) argv.push_back(a.c_str());
    CXTranslationUnit unit = nullptr;
    if (clang_parseTranslationUnit2FullArgv(index, name.c_str(), argv.data(), static_cast<int>(argv.size()),
                                            &unsaved, 1, CXTranslationUnit_KeepGoing,
                                            &unit) != CXError_Success)
      throw BadInput("libclang cannot read " + file);
    kept.add(file, own_text, collector.included(unit), collector.visit(unit));
    clang_disposeTranslationUnit(unit);
  }
  clang_disposeIndex(index);
  kept.write();
  return collector.files();
}

}  // namespace oddity::mutation
