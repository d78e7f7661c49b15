// A formula in TeX or plain text, with letters of every kind: read, evaluated, printed, mutated.
#include "extras/fuzz/fuzz.hpp"

#include "formula/code.hpp"
#include "formula/magnitude.hpp"
#include "formula/mutants.hpp"
#include "formula/parse.hpp"
#include "formula/print.hpp"
#include "formula/shown.hpp"

using namespace oddity::formula;

namespace {

const Names names{
    "m", "m_2", "g", R"(\theta)", R"(\dot\theta)", R"(\ddot\theta)", "x_1",    "x_2",    R"(\mathbf r)", "M",
    "N", "ds",  "F", R"(\pm)",    "a_{11}",        "a_{12}",         "a_{21}", "a_{22}", "y_1'",         "T"};

const std::vector<Matrix<double>>& values() {
  static const std::vector<Matrix<double>> all = [] {
    std::vector<Matrix<double>> made;
    for (std::size_t i = 0; i < names.size(); ++i) made.push_back({{0.5 + static_cast<double>(i)}});
    made[8] = of_letter<double>({1, 2, 3});
    made[9] = of_letter<double>({1, 2, 3, 4, 5, 6, 7, 8, 10});
    made[10] = of_letter<double>({1, 2, 3, 4});
    made[11] = {std::vector<double>(12, 0.5)};
    made[12] = {std::vector<double>(24, 1.5)};
    made[13] = {{-1}};
    return made;
  }();
  return all;
}

}  // namespace

void fuzz::read(std::string_view input) {
  if (input.empty()) return;
  const bool plain_text = input.front() % 2 != 0;
  const std::string_view text = input.substr(1);
  try {
    const Tree tree = parse_shown(text);
    mathml_in_pieces(tree), unicode(with_all_brackets(tree)), plain(tree);
    const auto [left, right] = with_differences_marked(tree, parse_shown(text.substr(text.size() / 2)));
    require(tex(left) == tex(tree) && !tex(right).empty());
  } catch (const Unreadable& error) {
    require(!error.reason().empty());
  }
  try {
    const Tree tree = plain_text ? parse_plain(text, names) : parse_tex(text, names);
    require(!tex(tree).empty() && !plain(tree).empty() && !mathml(tree).empty());
    const auto changed = mutants(tree);
    require(changed.size() <= 20'003);
    try {
      const Matrix<double> value = evaluate(tree, values());
      require(value.columns > 0 && value.entries.size() % value.columns == 0);
      magnitude(tree, values());
      code<Coq>(tree, names);
    } catch (const NoValue&) {
    }
  } catch (const Unreadable& error) {
    require(error.place() <= text.size() && !error.reason().empty());
  }
}
