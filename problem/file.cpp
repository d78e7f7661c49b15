#include "problem/file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <utility>

// toml++ 3.3 has assertions that hostile texts can violate, such as a key that begins with a comma. A release
// build would continue.
#undef NDEBUG
namespace oddity::problem {
struct Impossible {};
constexpr void require(bool holds) {
  if (!holds) throw Impossible();
}
}  // namespace oddity::problem
#define TOML_ASSERT(expression) ::oddity::problem::require(static_cast<bool>(expression))
#include <toml++/toml.h>

#include "problem/abbreviations.hpp"
#include "problem/keys.hpp"
#include "reference/code_text.hpp"
#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

Place place_of(const toml::source_region& region) { return {region.begin.line, region.begin.column}; }
Place place_of(const toml::node& node) { return place_of(node.source()); }

constexpr std::size_t most_components = 24;
constexpr std::size_t most_rows_of_matrix = 9;  // R_12 has one digit for the row, and one for the column

class Reader {
 public:
  explicit Reader(File& file) : file_(file), source_(file.source) {}

  void all(const toml::table& table) {
    only(table, "", keys("file"));
    if (const auto* version = table.get("version"); version && version->value<double>() != 1.0)
      source_.fail(place_of(*version), "this program reads version 1");
    const toml::node* title = table.get("title");
    if (!title) source_.fail({1, 1}, "no title: add title = \"...\"");
    file_.title = quoted(*title).text;
    if (const auto* question = table.get("question")) file_.question = quoted(*question).text;
    for (const auto& [key, node] : in_order(table_at(table, "parameters"))) parameter(key, *node);
    for (const auto& [key, node] : in_order(table_at(table, "tables"))) rows(key, *node);
    for (const auto& [key, node] : in_order(table_at(table, "given"))) given(key, *node);
    for (const auto& [key, node] : in_order(table_at(table, "model"))) model(key, *node);
    for (const auto& [key, node] : in_order(table_at(table, "observe"))) observable(key, *node);
    if (const auto* claims = table.get("claim")) all_claims(*claims);
    if (file_.models.empty() && !file_.claims.empty()) {
      for (const char* of_motion : {"observe", "need", "sweep", "given", "tables", "staged"})
        if (const auto* node = table.get(of_motion))
          source_.fail(place_of(*node), std::string(of_motion) + " is of a motion, and there is no model");
      return;
    }
    if (file_.models.empty())
      source_.fail({1, 1}, "no model and no claim: add [model.\"its name\"], or [[claim]]");
    if (file_.observables.empty())
      source_.fail({1, 1}, "nothing is observed: add [observe] with name = \"unit\"");
    need(table_at(table, "need"));
    sweep(table_at(table, "sweep"));
    if (const auto* node = table_at(table, "staged")) staged(*node);
  }

 private:
  std::vector<std::pair<Quoted, const toml::node*>> in_order(const toml::table* table) const {
    std::vector<std::pair<Quoted, const toml::node*>> all;
    if (!table) return all;
    for (const auto& [key, node] : *table) {
      if (std::ranges::any_of(key.str(), is_control))
        source_.fail(place_of(key.source()), "a name is on one line, without control characters");
      all.push_back({{std::string(key.str()), place_of(key.source())}, &node});
    }
    std::ranges::sort(all, [](const auto& a, const auto& b) {
      return std::pair(a.first.place.line, a.first.place.column) <
             std::pair(b.first.place.line, b.first.place.column);
    });
    return all;
  }

  /// Fails if the table has other keys than these.
  void only(const toml::table& table, const std::string& where, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : in_order(&table))
      if (std::ranges::find(known, key.text) == known.end()) {
        std::string all;
        for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
        const std::string near = did_you_mean(key.text, known);
        source_.fail(key.place, "no key " + key.text + (where.empty() ? "" : " in " + where) +
                                    (near.empty() ? "; the keys are " + all : near));
      }
  }

  static std::vector<std::string> keys(std::string_view of) {
    std::vector<std::string> names;
    for (const Key& key : keys_of(of)) names.emplace_back(key.name);
    return names;
  }

  const toml::table* table_at(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (!node) return nullptr;
    if (!node->is_table())
      source_.fail(place_of(*node), std::string(key) + " is a table: [" + std::string(key) + "]");
    return node->as_table();
  }

  /// A text, or a number's text. The place is that of its first character.
  Quoted quoted(const toml::node& node) const {
    Place place = place_of(node);
    if (const auto* text = node.as_string()) {
      const std::size_t at = offset_of(place);
      const std::string_view opening = std::string_view(source_.text).substr(at, 3);
      const bool is_long = opening == "\"\"\"" || opening == "'''";
      place.column += is_long ? 3 : 1;
      if (is_long && at + 3 < source_.text.size() && source_.text[at + 3] == '\n')
        ++place.line, place.column = 1;
      std::string line = text->get();
      for (char& c : line)
        if (is_control(c)) c = ' ';
      return {line, place};
    }
    if (node.is_number()) return {format_shortest(*node.value<double>()), place};
    source_.fail(place, "expected a text, in quotes");
  }
  std::size_t offset_of(Place place) const {
    std::size_t at = 0;
    for (std::size_t line = 1; line < place.line; ++line) at = source_.text.find('\n', at) + 1;
    return std::min(at + place.column - 1, source_.text.size());
  }

  std::vector<Quoted> texts(const toml::node& node) const {
    std::vector<Quoted> all;
    if (const auto* array = node.as_array()) {
      for (const auto& one : *array) all.push_back(quoted(one));
    } else {
      all.push_back(quoted(node));
    }
    return all;
  }

  // ---- vectors and matrices ------------------------------------------------------------------------------

  /// A text, a list of them for a vector, or a list of lists for a matrix.
  Quoted quoted_or_list(const toml::node& node) const {
    const auto* array = node.as_array();
    if (!array) return quoted(node);
    const bool is_matrix =
        std::any_of(array->begin(), array->end(), [](const toml::node& row) { return row.is_array(); });
    std::vector<Quoted> entries;
    std::size_t columns = 1;
    for (const auto& one : *array) {
      if (is_matrix && !one.is_array())
        source_.fail(place_of(one), "this is no list, and the other rows of this matrix are lists");
      const std::vector<Quoted> row = texts(one);
      if (entries.empty()) columns = row.size();
      if (row.size() != columns)
        source_.fail(place_of(one), "this row has " + std::to_string(row.size()) +
                                        " components, and the first " + std::to_string(columns));
      entries.insert(entries.end(), row.begin(), row.end());
    }
    require_size({array->size(), columns}, is_matrix, place_of(node));
    return list_of(entries, columns, place_of(node));
  }
  void require_size(Size size, bool is_matrix, Place place) const {
    const std::size_t most = is_matrix ? most_rows_of_matrix : most_components;
    if (size.rows >= 2 && size.rows <= most && (!is_matrix || (size.columns >= 2 && size.columns <= most)))
      return;
    source_.fail(place, (is_matrix ? "a matrix has 2 to " : "a vector has 2 to ") + std::to_string(most) +
                            (is_matrix ? " rows and columns" : " components"));
  }
  /// The names of the components: "r_1'", "r_2'" for r'.
  static std::vector<Quoted> components_of(const Quoted& whole, Size size) {
    std::vector<Quoted> names;
    for (std::size_t i = 0; i < size.entries(); ++i)
      names.push_back({component_name(whole.text, i, size), whole.place, true});
    return names;
  }
  /// A vector or matrix of these components.
  static Quoted list_of(const std::vector<Quoted>& entries, std::size_t columns, Place place) {
    Quoted list{"(", place, true, entries, columns};
    for (std::size_t i = 0; i < entries.size(); ++i)
      list.text += (i == 0 ? "" : columns > 1 && i % columns == 0 ? "; " : ", ") + entries[i].text;
    list.text += ")";
    return list;
  }

  void given(const Quoted& key, const toml::node& node) {
    const Quoted text = quoted_or_list(node);
    if (text.parts.empty()) {
      file_.given.push_back({name(key), text});
      return;
    }
    const std::vector<Quoted> names = components_of(key, text.size());
    for (std::size_t i = 0; i < names.size(); ++i) file_.given.push_back({name(names[i]), text.parts[i]});
    file_.given.push_back({name(key), list_of(names, text.columns, text.place)});
  }

  /// The unknowns are numbers, those of vectors and matrices their components.
  void start(const toml::table* table, ModelText& m) const {
    const auto entries = in_order(table);
    const auto base = [](const Quoted& key) { return key.text.substr(0, key.text.find('\'')); };
    std::map<std::string, Size> sizes;
    for (const auto& [key, node] : entries) {
      if (!node->is_array()) continue;
      const Size size = quoted_or_list(*node).size();
      const auto [known, is_new] = sizes.emplace(base(key), size);
      if (known->second != size)
        source_.fail(place_of(*node),
                     base(key) + " is " + name_of(known->second) + ", and this is " + name_of(size));
      if (!is_new) continue;
      const Quoted whole{base(key), key.place};
      m.vectors.push_back({whole, list_of(components_of(whole, size), size.columns, key.place)});
    }
    const auto add = [&](const Quoted& key, const Quoted& text) {
      for (const auto& [known, its] : m.start)
        if (known.text == key.text) source_.fail(key.place, key.text + " is started twice");
      m.start.push_back({key, text});
    };
    for (const auto& [key, node] : entries) {
      const Quoted text = quoted_or_list(*node);
      const auto size = sizes.find(base(key));
      if (size == sizes.end()) {
        add(key, text);
        continue;
      }
      const bool is_matrix = size->second.is_matrix();
      if (text.parts.empty() && text.text != "0")
        source_.fail(text.place, base(key) + (is_matrix ? " is a matrix: start " : " is a vector: start ") +
                                     key.text + (is_matrix ? " with a list of lists" : " with a list") +
                                     ", or with 0");
      const std::vector<Quoted> names = components_of(key, size->second);
      for (std::size_t i = 0; i < names.size(); ++i) add(names[i], text.parts.empty() ? text : text.parts[i]);
    }
  }

  /// Adds the equation q' = q w/2 of a quaternion.
  void turn(const Quoted& key, const toml::node& node, ModelText& m) const {
    const auto* table = node.as_table();
    if (table) only(*table, "a turn", keys("turn"));
    const auto* rate = table ? table->get("rate") : &node;
    if (!rate) source_.fail(key.place, key.text + " turns: rate = \"w\" is its angular velocity");
    const bool in_body = !table || text_in(*table, "axes", {"body", "space"}, "body") == "body";
    const auto vector = std::ranges::find_if(m.vectors, [&](const auto& one) {
      return one.first.text == key.text && one.second.size() == Size{4, 1};
    });
    if (vector == m.vectors.end())
      source_.fail(key.place,
                   key.text + " turns: start it with a quaternion, as " + key.text + " = [1, 0, 0, 0]");
    const Quoted w = quoted_or_list(*rate);
    if (w.text.find('\\') != w.text.npos) source_.fail(w.place, "write this angular velocity in plain text");
    m.turns.push_back({key, w});
    const std::string pure = "(0, " + w.text + ")";
    const std::string factors = in_body ? key.text + ", " + pure : pure + ", " + key.text;
    m.equations.push_back({key.text + "' = composed(" + factors + ")/2", w.place, true});
  }

  // --------------------------------------------------------------------------------------------------------

  /// A name for use in formulas.
  Quoted name(const Quoted& key) {
    require_name(key, false);
    if (!names_.insert(key.text).second)
      source_.fail(key.place, key.text + " is there twice; take another name");
    return key;
  }
  void require_name(const Quoted& key, bool without_time) const {
    const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    const bool is_name = !key.text.empty() && std::ranges::all_of(key.text, in_name) &&
                         !std::isdigit(static_cast<unsigned char>(key.text[0]));
    if (!is_name)
      source_.fail(key.place, "a letter's name has letters, digits and _, and is '" + key.text + "'");
    const auto taken = names_with_meaning();
    if (std::ranges::find(taken, key.text) != taken.end() && !(without_time && key.text == "t"))
      source_.fail(key.place, key.text + " has a meaning already; take another name");
  }

  double number_in(const Quoted& text, std::string_view number, const std::string& unit) const {
    try {
      return in_unit(number, unit);
    } catch (const BadInput& error) {
      source_.fail(text.place, error.what());
    }
  }

  void measure(const Quoted& at, const std::string& unit, long double& size, Measure& measure) const {
    const auto known = measure_of(unit);
    if (!known)
      source_.fail(at.place, "no unit '" + unit +
                                 "'; units are m, s, kg, rad, N, J, W, A, V, Ohm, H, deg, "
                                 "rpm ... and their products: kN s/m");
    measure = *known;
    size = unit.empty() || unit == "1" ? 1.0L : unit_of(unit)->size;
  }

  /// "30 kN/m, 1 to 100".
  void parameter(const Quoted& key, const toml::node& node) {
    ParameterText p;
    p.name = name(key).text;
    const toml::node* value = &node;
    if (const auto* table = node.as_table()) {
      only(*table, "parameter " + p.name, keys("parameter"));
      value = table->get("value");
      if (!value) source_.fail(key.place, p.name + " has no value: value = \"1 m\"");
      if (const auto* says = table->get("says")) p.says = quoted(*says).text;
      if (const auto* whole = table->get("whole")) p.whole = flag(*whole);
    }
    const Quoted text = quoted(*value);
    const auto comma = text.text.find(',');
    const Written written_value = [&] {
      try {
        return written(std::string_view(text.text).substr(0, comma));
      } catch (const BadInput& error) {
        source_.fail(text.place, error.what());
      }
    }();
    p.value = written_value.number;
    p.unit = written_value.unit;
    while (p.unit.ends_with(' ')) p.unit.pop_back();
    measure(text, p.unit, p.size, p.measure);
    p.least = -std::numeric_limits<double>::infinity();
    p.most = std::numeric_limits<double>::infinity();
    if (comma != std::string::npos) {
      const Quoted range{text.text.substr(comma + 1), text.at(comma + 1)};
      const auto to = range.text.find(" to ");
      if (to == std::string::npos) source_.fail(range.place, "expected a range: 1 to 100");
      const auto end = [&](std::string_view part) {
        part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
        return number_in(range, part, p.unit);
      };
      p.least = end(std::string_view(range.text).substr(0, to));
      p.most = end(std::string_view(range.text).substr(to + 4));
      if (!(p.least <= p.value && p.value <= p.most))
        source_.fail(range.place, p.name + " is outside its range");
    }
    if (!std::isfinite(p.value)) source_.fail(text.place, p.name + " is not finite");
    if (p.says.empty()) p.says = p.name;
    file_.parameters.push_back(std::move(p));
  }

  // ---- tables --------------------------------------------------------------------------------------------

  /// The cells of "0, 1.5" or 0 1.5, and whether each is a number.
  static std::vector<std::optional<double>> cells_of(std::string_view line) {
    constexpr std::string_view between = " \t,;\r\"";
    std::vector<std::optional<double>> cells;
    for (std::size_t at = 0; (at = line.find_first_not_of(between, at)) != line.npos;) {
      const std::size_t end = std::min(line.find_first_of(between, at), line.size());
      cells.push_back(parse_number(line.substr(at, end - at)));
      at = end;
    }
    return cells;
  }
  std::array<double, 2> pair_of(const std::vector<std::optional<double>>& cells, Place place) const {
    if (cells.size() != 2) source_.fail(place, "a row has two numbers");
    for (const auto& one : cells)
      if (!one || !std::isfinite(*one)) source_.fail(place, "expected two numbers, as 0.1, 5");
    return {*cells[0], *cells[1]};
  }
  /// An array of pairs, or lines of comma-separated values.
  std::vector<std::pair<std::array<double, 2>, Place>> pairs_of(const toml::node& node) const {
    std::vector<std::pair<std::array<double, 2>, Place>> all;
    if (const auto* array = node.as_array()) {
      for (const auto& one : *array) {
        const auto* row = one.as_array();
        if (!row || row->size() != 2 || !(*row)[0].is_number() || !(*row)[1].is_number())
          source_.fail(place_of(one), "a row has two numbers: [0.1, 5]");
        all.push_back({{*(*row)[0].value<double>(), *(*row)[1].value<double>()}, place_of(one)});
      }
      return all;
    }
    const auto* text = node.as_string();
    if (!text) source_.fail(place_of(node), "rows are pairs, [[0, 0], [0.1, 5]], or lines of text");
    Place place = quoted(node).place;
    std::istringstream lines(text->get());
    for (std::string line; std::getline(lines, line); place = {place.line + 1, 1}) {
      const auto cells = cells_of(line);
      const bool is_heading =
          all.empty() && std::ranges::none_of(cells, [](const auto& one) { return one.has_value(); });
      if (!is_heading && !cells.empty()) all.push_back({pair_of(cells, place), place});
    }
    return all;
  }

  void rows(const Quoted& key, const toml::node& node) {
    const auto* table = node.as_table();
    if (!table)
      source_.fail(key.place, key.text + " is a table: { x = \"s\", y = \"cm\", rows = [[0, 0], [0.1, 5]] }");
    only(*table, "table " + key.text, keys("table"));
    Table made;
    made.name = name(key).text;
    std::array<long double, 2> sizes{};
    const auto unit = [&](const char* which, Measure& its, long double& size) {
      const auto* text = table->get(which);
      if (!text)
        source_.fail(key.place, made.name + " has no unit of its " + which + ": " + which + " = \"m\"");
      measure(quoted(*text), quoted(*text).text, size, its);
    };
    unit("x", made.x, sizes[0]), unit("y", made.y, sizes[1]);
    const std::string spline = text_in(*table, "spline", {"linear", "cubic", "monotone"}, "cubic");
    made.holds = text_in(*table, "outside", {"refuse", "hold"}, "refuse") == "hold";
    const auto* written = table->get("rows");
    if (!written) source_.fail(key.place, made.name + " has no rows: rows = [[0, 0], [0.1, 5]]");
    std::vector<double> x, y;
    const auto pairs = pairs_of(*written);
    for (const auto& [pair, place] : pairs) {
      if (x.size() == most_rows)
        source_.fail(place, "a table has at most " + std::to_string(most_rows) + " rows");
      x.push_back(static_cast<double>(pair[0] * sizes[0]));
      y.push_back(static_cast<double>(pair[1] * sizes[1]));
      if (!(std::abs(x.back()) < 1e100 && std::abs(y.back()) < 1e100))
        source_.fail(place, "this is no finite number");
      if (x.size() > 1 && !(x.back() > x[x.size() - 2])) source_.fail(place, "x goes up from row to row");
    }
    const Spline through = spline == "linear"  ? Spline::linear
                           : spline == "cubic" ? Spline::cubic
                                               : Spline::monotone;
    if (x.size() < fewest_rows(through))
      source_.fail(place_of(*written), "a " + spline + " spline takes at least " +
                                           std::to_string(fewest_rows(through)) + " rows");
    made.pieces = pieces_of(through, x, y);
    for (const Table::Piece& piece : made.pieces)
      if (!std::ranges::all_of(piece.powers, [](double one) { return std::isfinite(one); }))
        source_.fail(pairs[closest(x) + 1].second,
                     "this row is too close to the one before for a curve through both: leave one out");
    made.last = x.back();
    file_.tables.push_back(std::make_shared<const Table>(std::move(made)));
  }
  /// The row that is closest to the next.
  static std::size_t closest(const std::vector<double>& x) {
    std::size_t best = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
      if (x[i + 1] - x[i] < x[best + 1] - x[best]) best = i;
    return best;
  }
  /// One of these words.
  std::string text_in(const toml::table& table, const char* key, const std::vector<std::string>& words,
                      const char* usual) const {
    const auto* node = table.get(key);
    if (!node) return usual;
    const Quoted text = quoted(*node);
    if (std::ranges::find(words, text.text) != words.end()) return text.text;
    std::string all;
    for (const std::string& one : words) all += (all.empty() ? "" : ", ") + one;
    source_.fail(text.place, std::string(key) + " is one of: " + all);
  }

  void observable(const Quoted& key, const toml::node& node) {
    ObservableText o;
    o.name = key.text;
    o.place = key.place;
    o.formula = key;
    Quoted unit;
    if (const auto* table = node.as_table()) {
      only(*table, "observable " + o.name, keys("observable"));
      if (const auto* is = table->get("is")) o.formula = quoted_or_list(*is);
      if (const auto* point = table->get("point")) o.point = quoted(*point).text;
      const auto* its = table->get("unit");
      if (!its) source_.fail(key.place, o.name + " has no unit: unit = \"m\"");
      unit = quoted(*its);
    } else {
      unit = quoted(node);
    }
    o.unit = unit.text;
    measure(unit, o.unit, o.size, o.measure);
    o.vector_size = size_in_models(o);
    if (o.vector_size == Size())
      add(std::move(o));
    else
      add_vector(o);
  }
  void add(ObservableText o) {
    if (std::ranges::find(file_.observables, o.name, &ObservableText::name) != file_.observables.end())
      source_.fail(o.place, o.name + " is observed twice");
    file_.observables.push_back(std::move(o));
  }
  /// A vector or matrix is seen as its components, of one point.
  void add_vector(const ObservableText& vector) {
    if (vector.vector_size.is_matrix()) require_size(vector.vector_size, true, vector.formula.place);
    const Quoted& formula = vector.formula;
    const bool is_name = std::ranges::all_of(
        formula.text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
    for (std::size_t i = 0; i < vector.vector_size.entries(); ++i) {
      ObservableText o = vector;
      o.vector = vector.name;
      o.component = i;
      o.name = component_name(vector.name, i, vector.vector_size);
      if (o.point.empty()) o.point = vector.name;
      if (!formula.parts.empty())
        o.formula = formula.parts[i];
      else if (is_name)
        o.formula = {component_name(formula.text, i, vector.vector_size), formula.place, true};
      else
        o.is_of_vector = true;
      add(std::move(o));
    }
  }
  /// Its size in the first model with a vector or matrix for it; otherwise that of a number.
  Size size_in_models(const ObservableText& o) const {
    if (!o.formula.parts.empty()) return o.formula.size();
    for (const ModelText& model : file_.models) {
      const Quoted* text = model.closed.empty() ? &o.formula : nullptr;
      for (const auto& [name, own] : model.closed.empty() ? model.observe : model.closed)
        if (name.text == o.name) text = &own;
      if (!text) continue;
      if (!text->parts.empty()) return text->size();
      try {
        Abbreviations letters(file_, model);
        const Shape its = letters.shape(Formula(source_, *text, letters.letters()));
        if (!its.is_number()) return extent(its);
      } catch (const WrongFile&) {  // The model reports it, behind errors that come before it.
      }
    }
    return {};
  }

  Named pairs(const toml::table* table) const {
    Named all;
    for (const auto& [key, node] : in_order(table)) all.push_back({key, quoted_or_list(*node)});
    return all;
  }

  void model(const Quoted& key, const toml::node& node) {
    const auto* table = node.as_table();
    if (!table) source_.fail(key.place, "a model is a table: [model.\"" + key.text + "\"]");
    only(*table, "model " + key.text, keys("model"));
    ModelText m{key};
    if (const auto* equations = table->get("equations")) m.equations = texts(*equations);
    if (const auto* constraints = table->get("constraints")) m.constraints = texts(*constraints);
    if (const auto* lagrangian = table->get("lagrangian")) m.lagrangian = quoted(*lagrangian);
    if (const auto* hamiltonian = table->get("hamiltonian")) m.hamiltonian = quoted(*hamiltonian);
    if (const auto* dissipation = table->get("dissipation")) m.dissipation = quoted(*dissipation);
    m.momenta = pairs(table_at(*table, "momenta"));
    m.forces = pairs(table_at(*table, "forces"));
    start(table_at(*table, "start"), m);
    for (const auto& [name, its] : in_order(table_at(*table, "turns"))) turn(name, *its, m);
    m.closed = pairs(table_at(*table, "closed"));
    m.observe = pairs(table_at(*table, "observe"));
    if (const auto* conserves = table_at(*table, "conserves")) {
      only(*conserves, "conserves", keys("conserves"));
      for (const auto& [name, text] : in_order(conserves))
        (name.text == "kinetic" ? m.kinetic : m.potential) = quoted(*text);
      if (!m.kinetic || !m.potential)
        source_.fail(place_of(*conserves), "conserves has kinetic and potential");
    }
    if (const auto* events = table->get("events")) m.events = all_events(*events);
    if (!m.events.empty() && !m.closed.empty())
      source_.fail(m.events.front().when.place, "a closed form has no events");
    const int kinds = !m.closed.empty() + (!m.equations.empty() || m.lagrangian || m.hamiltonian);
    if (kinds != 1)
      source_.fail(key.place,
                   kinds == 0 ? "model " + key.text + " has no equations, lagrangian, hamiltonian or closed"
                              : "model " + key.text + " is a closed form, or has equations");
    require_parts(m, key);
    file_.models.push_back(std::move(m));
  }

  /// Requires that the parts of a model fit each other.
  void require_parts(const ModelText& m, const Quoted& key) const {
    if (m.hamiltonian && m.lagrangian)
      source_.fail(
          m.hamiltonian->place,
          "its unknowns are places and momenta, and those of a lagrangian places: make two models of them, "
          "which are then compared");
    if (m.hamiltonian.has_value() == m.momenta.empty())
      source_.fail(key.place, "a hamiltonian has momenta = { x = \"p\" }, the momentum of each place");
    if (!m.lagrangian && (m.dissipation || !m.constraints.empty()))
      source_.fail(key.place,
                   "dissipation and constraints go with a lagrangian; put them into the equations");
    if ((m.lagrangian || m.hamiltonian) && !m.turns.empty())
      source_.fail(m.turns.front().of.place, "turns go with equations");
    if (!m.lagrangian && !m.hamiltonian && !m.forces.empty())
      source_.fail(key.place, "forces go with a lagrangian or a hamiltonian; put them into the equations");
  }

  std::vector<EventText> all_events(const toml::node& node) const {
    const auto* array = node.as_array();
    const std::string form = R"(events are tables: events = [{ when = "y", then = { "y'" = "-e y'" } }])";
    if (!array) source_.fail(place_of(node), form);
    std::vector<EventText> all;
    for (const auto& one : *array) {
      const auto* table = one.as_table();
      if (!table) source_.fail(place_of(one), form);
      only(*table, "an event", keys("event"));
      const auto* when = table->get("when");
      if (!when)
        source_.fail(place_of(*table), "an event has a formula that goes through zero: when = \"y\"");
      EventText event{quoted(*when)};
      if (const auto* direction = table->get("direction")) event.direction = this->direction(*direction);
      event.then = pairs(table_at(*table, "then"));
      if (const auto* ends = table->get("ends")) event.ends = flag(*ends);
      if (const auto* counts = table->get("counts")) event.counts = quoted(*counts);
      if (!event.counts.text.empty()) require_name(event.counts, false);
      if (event.then.empty() && !event.ends && event.counts.text.empty())
        source_.fail(
            place_of(*table),
            "nothing happens in this event: add then = { ... }, ends = true, or counts = \"its count\"");
      all.push_back(std::move(event));
    }
    return all;
  }
  Direction direction(const toml::node& node) const {
    const Quoted text = quoted(node);
    if (text.text == "falling") return Direction::falling;
    if (text.text == "rising") return Direction::rising;
    if (text.text == "both") return Direction::both;
    source_.fail(text.place, "a direction is falling, rising or both");
  }
  bool flag(const toml::node& node) const {
    if (const auto value = node.value_exact<bool>()) return *value;
    source_.fail(place_of(node), "expected true or false, without quotes");
  }

  void need(const toml::table* table) {
    std::vector<std::string> units;
    for (const ObservableText& o : file_.observables)
      if (std::ranges::find(units, o.unit) == units.end()) units.push_back(o.unit);
    file_.errors.assign(units.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < units.size(); ++i)
      if (const auto one = measure_of(units[i])) {
        if (units[i] == "m") file_.errors[i] = 0.01;
        if (units[i] == "rad") file_.errors[i] = static_cast<double>(unit_of("deg")->size);
      }
    if (table) {
      only(*table, "need", keys("need"));
      if (const auto* error = table->get("error")) errors(texts(*error), units);
      if (const auto* horizon = table->get("horizon")) {
        const Quoted text = quoted(*horizon);
        file_.horizon = text.text;
        file_.end = number_in(text, text.text, "s");
        if (!(file_.end > 0 && file_.end <= 1e9)) source_.fail(text.place, "a horizon is positive, as 10 s");
      }
      if (const auto* fps = table->get("fps")) {
        const Quoted text = quoted(*fps);
        file_.frames_per_second = text.text;
        if (!(number_in(text, text.text, "1/s") > 0))
          source_.fail(text.place, "a frame rate is positive, as 60");
      }
      if (const auto* vary = table->get("vary"))
        for (const Quoted& one : texts(*vary)) file_.vary.push_back(parameter_named(one));
    }
    for (std::size_t i = 0; i < units.size(); ++i)
      if (std::isnan(file_.errors[i]))
        source_.fail({1, 1}, "no error is asked for in " + (units[i].empty() ? "pure numbers" : units[i]) +
                                 ": add [need] with error = \"...\"");
    for (std::size_t i = 0; i < units.size(); ++i)
      file_.error += (i == 0 ? "" : ",") + format_shortest(file_.errors[i]) +
                     (units.size() == 1 || is_pure(units[i]) ? "" : units[i]);
  }

  static bool is_pure(const std::string& unit) { return unit.empty() || unit == "1"; }
  void errors(const std::vector<Quoted>& texts, const std::vector<std::string>& units) {
    for (const Quoted& text : texts) {
      const auto fits = std::ranges::find_if(units, [&](const std::string& unit) {
        try {
          const bool needs_unit = units.size() > 1 && !is_pure(unit);
          return in_unit(text.text, unit) > 0 && !(needs_unit && written(text.text).unit.empty());
        } catch (const BadInput&) {
          return false;
        }
      });
      if (fits == units.end()) source_.fail(text.place, "this is no error of an observable, such as 1 mm");
      file_.errors[static_cast<std::size_t>(fits - units.begin())] = in_unit(text.text, *fits);
    }
  }

  std::string parameter_named(const Quoted& text) const {
    std::vector<std::string> names;
    for (const ParameterText& p : file_.parameters) names.push_back(p.name);
    if (std::ranges::find(names, text.text) == names.end())
      source_.fail(text.place, "no parameter " + text.text + did_you_mean(text.text, names));
    return text.text;
  }

  void sweep(const toml::table* table) {
    if (!table) return;
    only(*table, "sweep", keys("sweep"));
    const auto *parameter = table->get("parameter"), *values = table->get("values");
    if (!parameter || !values) source_.fail(place_of(*table), "sweep has a parameter and its values");
    file_.sweep = parameter_named(quoted(*parameter));
    const auto p = std::ranges::find(file_.parameters, file_.sweep, &ParameterText::name);
    for (const Quoted& one : texts(*values)) {
      file_.sweep_values.push_back(number_in(one, one.text, p->unit));
      if (!(p->least <= file_.sweep_values.back() && file_.sweep_values.back() <= p->most))
        source_.fail(one.place, "this is outside the range of " + file_.sweep);
    }
  }

  // ---- bodies and joints ---------------------------------------------------------------------------------

  void staged(const toml::table& table) {
    only(table, "staged", keys("staged"));
    StagedText made{place_of(table)};
    made.gravity = vector_in(table, "gravity");
    each_in(table, "body", [&](const toml::table& one) {
      made.bodies.push_back({name_of_body(one), text_of(one, "body", "mass"), text_of(one, "body", "turn"),
                             texts_in(one, "inertia"), vector_in(one, "place"), vector_in(one, "velocity"),
                             vector_in(one, "spin")});
      if (const std::size_t count = made.bodies.back().inertia.size(); count != 1 && count != 3)
        source_.fail(place_of(one), "inertia has one moment for all axes, or three");
    });
    each_in(table, "joint", [&](const toml::table& one) {
      made.joints.push_back({text_of(one, "joint", "kind"), text_of(one, "joint", "a"),
                             text_of(one, "joint", "b"), vector_in(one, "at"), vector_in(one, "axis"),
                             vector_in(one, "end")});
    });
    each_in(table, "spring", [&](const toml::table& one) {
      made.springs.push_back({text_of(one, "spring", "a"), text_of(one, "spring", "b"),
                              text_of(one, "spring", "stiffness"), text_of(one, "spring", "rest"),
                              vector_in(one, "at"), vector_in(one, "end")});
    });
    if (made.bodies.empty()) source_.fail(made.place, "nothing is staged: add [[staged.body]]");
    made.observe = pairs(table_at(table, "observe"));
    made.differs = text_of(table, "staged", "differs").text;
    file_.staged = std::move(made);
  }
  Quoted name_of_body(const toml::table& table) {
    const Quoted text = name(text_of(table, "body", "name"));
    if (text.text == "ground") source_.fail(text.place, "the ground is no body; take another name");
    return text;
  }
  template <class Take>
  void each_in(const toml::table& table, const std::string& key, const Take& take) const {
    const auto* node = table.get(key);
    if (!node) return;
    const auto* array = node->as_array();
    // Many times those that a motion of 24 unknowns and rates can have.
    constexpr std::size_t most = 100;
    if (array && array->size() > most)
      source_.fail(place_of(*node), "of [[staged." + key + "]] there are at most " + std::to_string(most));
    for (std::size_t i = 0; !array || i < array->size(); ++i) {
      const auto* one = array ? (*array)[i].as_table() : nullptr;
      if (!one) source_.fail(place_of(*node), "write these as tables: [[staged." + key + "]]");
      only(*one, "a " + key, keys(key));
      take(*one);
    }
  }
  /// Fails if a needed key is missing.
  Quoted text_of(const toml::table& table, std::string_view of, std::string_view key) const {
    if (const auto* node = table.get(key)) return quoted(*node);
    if (std::ranges::find(keys_of(of), key, &Key::name)->needed)
      source_.fail(place_of(table), "this " + std::string(of) + " has no " + std::string(key));
    return {"", place_of(table)};
  }
  std::vector<Quoted> texts_in(const toml::table& table, const char* key) const {
    const auto* node = table.get(key);
    return node ? texts(*node) : std::vector<Quoted>();
  }
  /// Three, or none.
  std::vector<Quoted> vector_in(const toml::table& table, const char* key) const {
    std::vector<Quoted> all = texts_in(table, key);
    if (!all.empty() && all.size() != 3)
      source_.fail(all.front().place,
                   std::string(key) + " has three components: [\"0 m\", \"1 m\", \"0 m\"]");
    return all;
  }

  // ---- claims --------------------------------------------------------------------------------------------

  void all_claims(const toml::node& node) {
    const auto* array = node.as_array();
    if (!array) source_.fail(place_of(node), "write claims as tables: [[claim]]");
    for (const auto& one : *array) {
      const auto* table = one.as_table();
      if (!table) source_.fail(place_of(one), "write claims as tables: [[claim]]");
      file_.claims.push_back(claim(*table));
    }
  }

  ClaimText claim(const toml::table& table) {
    only(table, "a claim", keys("claim"));
    ClaimText claim;
    claim.place = place_of(table);
    const auto text = [&](const char* key, std::string& to) {
      if (const auto* node = table.get(key)) to = quoted(*node).text;
    };
    claim.name = std::to_string(file_.claims.size() + 1);
    text("name", claim.name), text("says", claim.says), text("why", claim.why);
    text("changes_that_hold", claim.changes_that_hold);
    for (const ClaimText& other : file_.claims)
      if (other.name == claim.name)
        source_.fail(place_of(table), "two claims have the name " + claim.name + "; give one another");
    if (claim.says.empty()) source_.fail(place_of(table), "a claim says something: says = \"...\"");
    const auto formula = [&](const char* key, std::optional<Quoted>& to) {
      if (const auto* node = table.get(key)) to = quoted(*node);
    };
    formula("printed", claim.printed), formula("meant", claim.meant), formula("corrected", claim.corrected);
    formula("where", claim.where), formula("in_view", claim.in_view);
    if (!claim.printed) source_.fail(place_of(table), "what is printed? add printed = \"a formula\"");
    if (claim.in_view && !claim.corrected)
      source_.fail(claim.in_view->place, "in_view goes with corrected, which holds beyond it");
    if (const auto* lost = table.get("lost")) claim.lost = flag(*lost);
    if (claim.lost && !claim.meant)
      source_.fail(place_of(table), "what is lost was meant: add meant = \"a formula\"");
    for (const auto& [key, node] : in_order(table_at(table, "letters")))
      claim.letters.push_back(letter(key, *node));
    if (const auto* node = table.get("truth")) claim.truth = truth(*node);
    return claim;
  }

  /// "0.1 to 10 m", "1 m", "1 to 9, whole".
  LetterText letter(const Quoted& key, const toml::node& node) const {
    require_name(key, true);
    const Quoted text = quoted(node);
    LetterText letter;
    letter.name = key.text;
    std::string_view range = text.text;
    if (range.ends_with(", whole")) letter.whole = true, range.remove_suffix(7);
    const auto to = range.find(" to ");
    const std::string_view last = to == range.npos ? range : range.substr(to + 4);
    try {
      const Written most = written(last);
      letter.unit = most.unit;
      while (letter.unit.ends_with(' ')) letter.unit.pop_back();
      letter.most = most.number;
    } catch (const BadInput& error) {
      source_.fail(text.place, std::string(error.what()) + "; a letter has a value, or a range: 0.1 to 10 m");
    }
    measure(text, letter.unit, letter.size, letter.measure);
    letter.least = to == range.npos ? letter.most : number_in(text, range.substr(0, to), letter.unit);
    if (!(std::isfinite(letter.least) && std::isfinite(letter.most) && letter.least <= letter.most))
      source_.fail(text.place, "a range goes up: 0.1 to 10 m");
    const auto is_whole = [](double x) { return x == std::floor(x) && std::abs(x) < 1e9; };
    if (letter.whole && !(is_whole(letter.least) && is_whole(letter.most)))
      source_.fail(text.place, "the ends of this range are not whole");
    return letter;
  }

  /// A formula, or a table for another kind of truth.
  TruthText truth(const toml::node& node) const {
    const auto* table = node.as_table();
    if (!table) return {TruthText::Is::formula, quoted(node)};
    const auto needed = [&](const char* key) {
      const auto* its = table->get(key);
      if (!its) source_.fail(place_of(*table), std::string("this truth needs ") + key + " = \"...\"");
      return quoted(*its);
    };
    only(*table, "a truth", keys("truth"));
    TruthText truth;
    if (table->get("derivative")) {
      only(*table, "a derivative", {"derivative", "by", "times"});
      truth = {TruthText::Is::derivative, needed("derivative"), needed("by")};
      if (const auto* times = table->get("times")) {
        const Quoted text = quoted(*times);
        truth.times = static_cast<int>(number_in(text, text.text, ""));
        if (!(truth.times >= 1 && truth.times <= 4))
          source_.fail(text.place, "it is differentiated 1 to 4 times");
      }
    } else if (table->get("integral") || table->get("sum")) {
      const char* what = table->get("sum") ? "sum" : "integral";
      only(*table, what, {what, "over", "from", "to"});
      truth = {table->get("sum") ? TruthText::Is::sum : TruthText::Is::integral, needed(what), needed("over"),
               needed("from"), needed("to")};
    } else if (table->get("value")) {
      only(*table, "a value", {"value", "within", "by"});
      truth = {TruthText::Is::value, needed("value")};
      if (table->get("within")) truth.within = needed("within");
      if (table->get("by")) truth.source = needed("by").text;
    } else {
      source_.fail(place_of(*table), "a truth is a formula, or has derivative, integral, sum or value");
    }
    return truth;
  }

  File& file_;
  const Source& source_;
  std::set<std::string> names_;
};

/// Refuses texts on which toml++ 3.3 has undefined behaviour, or exhausts the stack: letters outside of
/// quotes and comments that are not ASCII, and names of very many parts.
class Readable {
 public:
  explicit Readable(const Source& source) : source_(source), text_(source.text) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  }

  void require() {
    while (at_ < text_.size()) {
      if (static_cast<unsigned char>(text_[at_]) >= 0x80)
        fail("outside of quotes a name has letters from a to z: put quotes around this one");
      if (text_[at_] == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else if (const std::string_view quote = quote_here(); !quote.empty())
        pass(quote);
      else
        see_depth(text_[at_]), ++at_;
    }
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    const std::string_view before = text_.substr(0, at_);
    const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    source_.fail({line + 1, at_ - (before.rfind('\n') + 1) + 1}, reason);
  }

  std::string_view quote_here() const {
    for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"})
      if (text_.substr(at_).starts_with(quote)) return quote;
    return {};
  }
  /// Passes a quoted text. One of several lines may end in two more quotes.
  void pass(std::string_view quote) {
    const bool has_escapes = quote[0] == '"', is_long = quote.size() > 1;
    for (at_ += quote.size(); at_ < text_.size(); ++at_) {
      if (!is_long && text_[at_] == '\n') return;
      if (text_.substr(at_).starts_with(quote)) break;
      if (has_escapes && text_[at_] == '\\' && (is_long || text_.substr(at_ + 1, 1) != "\n")) ++at_;
    }
    at_ = std::min(at_ + quote.size(), text_.size());
    for (int i = 0; is_long && i < 2 && text_.substr(at_, 1) == quote.substr(0, 1); ++i) ++at_;
  }

  /// Counts a name's dots, and those of the names around it: each nests the tables one level deeper.
  void see_depth(char c) {
    constexpr std::size_t most_dots = 256;
    if (c == '.' && ++dots_ > most_dots) fail("a name has at most " + std::to_string(most_dots) + " dots");
    if (c == '{' || c == '[') around_.push_back(dots_);
    if (c == ',' || c == '\n') dots_ = around_.empty() ? 0 : around_.back();
    if ((c == '}' || c == ']') && !around_.empty()) {
      dots_ = around_.back();
      around_.pop_back();
    }
  }

  const Source& source_;
  std::string_view text_;
  std::size_t at_ = 0, dots_ = 0;
  std::vector<std::size_t> around_;  ///< dots in front of each open bracket
};

/// "y'" where this is the prime in it.
std::string rate_before(const std::string& text, Place place) {
  std::size_t line = 0;
  for (std::size_t i = 1; i < place.line && line != std::string::npos; ++i) line = text.find('\n', line) + 1;
  const std::size_t at = line + place.column - 1;
  if (place.column < 2 || at >= text.size() || text[at] != '\'') return "";
  const auto in_name = [&](std::size_t i) {
    return std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_';
  };
  std::size_t begin = at;
  while (begin > line && in_name(begin - 1)) --begin;
  return begin == at ? "" : text.substr(begin, at - begin) + "'";
}

}  // namespace

std::string component_name(const std::string& whole, std::size_t index, Size size) {
  const std::size_t end = std::min(whole.find('\''), whole.size());
  const std::size_t number =
      size.is_matrix() ? 10 * (index / size.columns + 1) + index % size.columns + 1 : index + 1;
  return whole.substr(0, end) + "_" + std::to_string(number) + whole.substr(end);
}

std::unique_ptr<const File> read(const std::string& name, const std::string& text) {
  auto file = std::make_unique<File>();
  file->source = {name, text};
  if (text.size() > most_of_a_file) throw BadInput(name + ": a problem's file has at most a megabyte");
  Readable(file->source).require();
  try {
    const toml::table table = toml::parse(std::string_view(text), std::string_view(name));
    Reader(*file).all(table);
  } catch (const Impossible&) {
    file->source.fail({1, 1}, "this is no TOML");
  } catch (const toml::parse_error& error) {
    const Place place = place_of(error.source());
    const std::string rate = rate_before(text, place);
    file->source.fail(place, rate.empty() ? std::string(error.description())
                                          : "a name with a prime is in quotes: \"" + rate + "\"");
  }
  return file;
}

void require_parameters(const File& file) {
  if (file.parameters.empty() && !file.models.empty())
    file.source.fail(
        {1, 1},
        "no parameters: give a letter in [parameters] to each value that differs from start to start");
}

}  // namespace oddity::problem
