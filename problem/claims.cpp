#include "problem/claims.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "formula/differentiate.hpp"
#include "formula/evaluate.hpp"
#include "formula/gauss.hpp"
#include "formula/print.hpp"
#include "formula/tokens.hpp"
#include "reference/quantity_text.hpp"
#include "reference/text.hpp"

namespace oddity::problem {

namespace {

using Stated = oddity::Formula<struct Drawn>;

// ---- letters ---------------------------------------------------------------------------------------------

/// A name in TeX: theta as \theta, m1 as m_1, mass as \mathrm{mass}.
std::string as_typeset(const std::string& name) {
  const std::size_t end = std::min(name.find_first_of("_0123456789"), name.size());
  std::string stem = formula::tex_name(name.substr(0, end)), index = name.substr(end);
  if (index.starts_with('_')) index.erase(0, 1);
  if (stem.size() > 1 && stem[0] != '\\') stem = R"(\mathrm{)" + stem + "}";
  return stem + (index.empty() ? "" : index.size() == 1 ? "_" + index : "_{" + index + "}");
}
std::string unit_as_typeset(std::string unit) {
  for (auto at = unit.find(' '); at != unit.npos; at = unit.find(' ', at + 2)) unit.replace(at, 1, R"(\,)");
  if (unit == "%") unit = R"(\%)";
  return R"(\mathrm{)" + unit + "}";
}

/// Symbols of a claim's formulas: its letters, the variable of an integral or a sum, and units.
struct Alphabet {
  std::vector<LetterText> letters;
  std::string running = {};  ///< as typeset; empty: none
  TypesetLetters units = {};
  Tolerance besides = {};  ///< error of the truth itself, in base units
};

/// Random values of a claim's letters.
struct Drawn {
  std::shared_ptr<const Alphabet> of;
  std::vector<double> x;  ///< in base units
  double running = 0;

  std::string where() const {
    std::string all;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const LetterText& one = of->letters[i];
      all += (all.empty() ? "" : ", ") + one.name + " = " +
             format_shortest(static_cast<double>(x[i] / one.size)) + (one.unit.empty() ? "" : " " + one.unit);
    }
    return all;
  }
  /// The letters that can be changed a little.
  std::vector<double*> letters() {
    std::vector<double*> all;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!of->letters[i].whole) all.push_back(&x[i]);
    return all;
  }
  TypesetLetters typeset() const {
    TypesetLetters all;
    for (std::size_t i = 0; i < x.size(); ++i) all.emplace_back(as_typeset(of->letters[i].name), x[i]);
    if (!of->running.empty()) all.emplace_back(of->running, running);
    all.insert(all.end(), of->units.begin(), of->units.end());
    return all;
  }
  Tolerance tolerance(double size) const {
    Tolerance all = rounding(size);
    if (of->besides.allowed == 0) return all;
    all.allowed += of->besides.allowed;
    all.reason = of->besides.reason;
    return all;
  }
};

// ---- texts -----------------------------------------------------------------------------------------------

/// The sides of a relation, and the relations in TeX.
struct Relation {
  std::vector<Quoted> sides;
  std::vector<std::string> relations;
};
Relation relation_in(const Quoted& text) {
  Relation all;
  std::size_t begin = 0;
  const auto side = [&](std::size_t end) {
    all.sides.push_back({text.text.substr(begin, end - begin), text.at(begin)});
  };
  int depth = 0;
  for (std::size_t at = 0; at < text.text.size(); ++at) {
    const std::string_view rest = std::string_view(text.text).substr(at);
    depth += rest[0] == '(' || rest[0] == '{' ? 1 : rest[0] == ')' || rest[0] == '}' ? -1 : 0;
    if (depth > 0) continue;
    for (const auto& [written, tex] : {std::pair{"<=", R"(\le)"},
                                       {">=", R"(\ge)"},
                                       {"!=", R"(\ne)"},
                                       {R"(\le)", R"(\le)"},
                                       {R"(\ge)", R"(\ge)"},
                                       {R"(\ne)", R"(\ne)"},
                                       {"=", "="},
                                       {"<", "<"},
                                       {">", ">"}}) {
      const std::string_view sign = written;
      if (!rest.starts_with(sign)) continue;
      if (sign[0] == '\\' && rest.size() > sign.size() &&
          std::isalpha(static_cast<unsigned char>(rest[sign.size()])))
        continue;  // \left
      side(at);
      all.relations.push_back(tex);
      begin = at + sign.size();
      at = begin - 1;
      break;
    }
  }
  side(text.text.size());
  return all;
}

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

/// "9.81 m/s^2" as a number; empty if there is anything else.
std::optional<Written> number_in(const Quoted& text) {
  try {
    Written number = written(trimmed(text.text));
    while (number.unit.ends_with(' ')) number.unit.pop_back();
    if (measure_of(number.unit)) return number;
  } catch (const BadInput&) {
  }
  return std::nullopt;
}

std::string opposite(const std::string& relation) {
  if (relation == "<") return R"(\ge)";
  if (relation == ">") return R"(\le)";
  if (relation == R"(\le)") return ">";
  if (relation == R"(\ge)") return "<";
  return relation == "=" ? R"(\ne)" : "=";
}

// ---- a claim ---------------------------------------------------------------------------------------------

/// A reading's text, parsed for evaluation.
struct Read {
  std::string text;  ///< "$T=2\pi\sqrt{l/g}$"
  std::vector<std::string> sides, relations;
  Measure measure;  ///< measure of the side that counts
  Quoted of;        ///< the side that counts
  std::string units_amiss = {};
};

class Reader {
 public:
  Reader(const File& file, const ClaimText& claim) : file_(file), claim_(claim) {
    auto letters = std::make_shared<Alphabet>();
    letters->letters = claim.letters;
    for (const ParameterText& p : file.parameters) {
      if (std::ranges::find(claim.letters, p.name, &LetterText::name) != claim.letters.end()) continue;
      const bool has_range = std::isfinite(p.least) && std::isfinite(p.most);
      letters->letters.push_back({p.name, p.unit, has_range ? p.least : p.value, has_range ? p.most : p.value,
                                  p.whole, p.size, p.measure});
    }
    alphabet_ = letters;
    std::vector<std::string> seen;
    for (const LetterText& one : letters->letters) {
      known_.parameters.push_back(one.name);
      measures_.push_back(one.measure);
      if (std::ranges::find(seen, as_typeset(one.name)) != seen.end())
        file.source.fail(claim.place, "on a page " + one.name + " looks as another letter does; rename one");
      seen.push_back(as_typeset(one.name));
    }
  }

  /// Each of the claim's letters has only one value.
  bool is_fixed() const {
    return std::ranges::all_of(alphabet_->letters,
                               [](const LetterText& one) { return one.least == one.most; });
  }
  Alphabet& alphabet() { return *alphabet_; }
  std::shared_ptr<const Alphabet> letters() const { return alphabet_; }

  /// Adds the variable of an integral or a sum.
  void add_running(const Quoted& name, const Measure& measure) {
    if (std::ranges::find(known_.parameters, name.text) != known_.parameters.end())
      file_.source.fail(name.place, name.text + " is a letter already; let it run through another");
    known_.parameters.push_back(name.text);
    measures_.push_back(measure);
    alphabet_->running = as_typeset(name.text);
  }

  Formula formula(const Quoted& text) const { return {file_.source, text, known_}; }
  Measure measure(const Formula& of) const {
    return of.measure([&](const Letter& letter) {
      if (letter.is == Letter::Is::quantity) return letter.measure;
      require_letter(of, letter);
      return measures_[letter.index];
    });
  }
  std::string tex(const Formula& of) {
    const auto name = [&](const Letter& letter) {
      require_letter(of, letter);
      return as_typeset(known_.parameters[letter.index]);
    };
    const auto unit = [&](const std::string& symbol) {
      const std::string typeset = unit_as_typeset(symbol);
      if (std::ranges::find(alphabet_->units, typeset, [](const auto& one) { return one.first; }) ==
          alphabet_->units.end())
        alphabet_->units.emplace_back(typeset, static_cast<double>(unit_of(symbol)->size));
      return typeset;
    };
    return formula::tex(of.tree(name, unit));
  }

  /// Reads a formula, a named formula (T = ...), or a relation.
  Read read(const Quoted& text) {
    const Relation relation = relation_in(text);
    Read all;
    all.relations = relation.relations;
    std::optional<Measure> first;
    for (std::size_t i = 0; i < relation.sides.size(); ++i) {
      const Quoted& side = relation.sides[i];
      if (i == 0 && relation.sides.size() == 2 && relation.relations[0] == "=" && is_only_name(side.text)) {
        all.sides.push_back(name_as_typeset(trimmed(side.text)));
        continue;
      }
      const Formula formula = this->formula(side);
      all.of = side;
      try {
        all.measure = measure(formula);
        if (first && !fit(*first, all.measure))
          formula.fail({}, "one side is " + name_of(*first) + ", and this is " + name_of(all.measure));
        if (!first || first->fits_all) first = all.measure;
      } catch (const WrongFile& error) {
        if (all.units_amiss.empty()) all.units_amiss = error.what();
      }
      all.sides.push_back(tex(formula));
    }
    all.text = "$" + all.sides[0];
    for (std::size_t i = 0; i < all.relations.size(); ++i)
      all.text += all.relations[i] + (all.relations[i].size() > 1 ? " " : "") + all.sides[i + 1];
    all.text += "$";
    return all;
  }
  bool is_called(const Quoted& text) const {
    const Relation relation = relation_in(text);
    return relation.sides.size() == 1 || (relation.sides.size() == 2 && relation.relations[0] == "=" &&
                                          is_only_name(relation.sides[0].text));
  }

  std::vector<Drawn> samples(const std::optional<std::string>& condition, const Place& place) const {
    constexpr int wanted = 200, tries = 200 * wanted;
    Random random(52);
    std::vector<Drawn> all;
    for (int i = 0; i < (is_fixed() ? 1 : tries) && std::ssize(all) < wanted; ++i) {
      Drawn one{alphabet_, {}};
      for (const LetterText& letter : alphabet_->letters)
        one.x.push_back(static_cast<double>(static_cast<long double>(drawn(letter, random)) * letter.size));
      if (condition) {
        const auto so = typeset_relation(*condition, one.typeset());
        if (!so) file_.source.fail(place, "this is no condition such as a < b");
        if (!*so) continue;
      }
      all.push_back(std::move(one));
    }
    if (std::ssize(all) < (is_fixed() ? 1 : 10))
      file_.source.fail(place, "too few of the letters drawn meet this: narrow their ranges");
    return all;
  }

  const File& file() const { return file_; }
  const ClaimText& claim() const { return claim_; }

 private:
  static double drawn(const LetterText& letter, Random& random) {
    if (letter.least == letter.most) return letter.least;
    if (letter.whole) return letter.least + std::floor(random.unit() * (letter.most - letter.least + 1));
    if (letter.least > 0 && letter.most > 100 * letter.least)
      return letter.least * std::exp(random.unit() * std::log(letter.most / letter.least));
    return random.between(letter.least, letter.most);
  }
  void require_letter(const Formula& of, const Letter& letter) const {
    if (letter.is == Letter::Is::time) of.fail(letter.span, "no letter t; add it to the claim's letters");
  }
  /// T, T_1, \ddot x, v': not a letter, but only the formula's name.
  bool is_only_name(const std::string& side) const {
    const std::string text = trimmed(side);
    if (std::ranges::find(known_.parameters, text) != known_.parameters.end()) return false;
    const auto is_part = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '\'' || c == '\\' || c == '{' ||
             c == '}' || c == ' ';
    };
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) ||
        !std::ranges::all_of(text, is_part))
      return false;
    const bool is_tex = text.find('\\') != text.npos || text.find('{') != text.npos;
    if (!is_tex) return text.find(' ') == text.npos;
    const std::string symbol = formula::plain_name(text);
    return symbol.find_first_of("\\{} ") == symbol.npos &&
           std::ranges::find(known_.parameters, symbol) == known_.parameters.end();
  }
  static std::string name_as_typeset(const std::string& name) {
    if (name.find_first_of("\\{") != name.npos) return name;
    const std::size_t primes = name.find('\'');
    return as_typeset(name.substr(0, primes)) + (primes == name.npos ? "" : name.substr(primes));
  }

  const File& file_;
  const ClaimText& claim_;
  std::shared_ptr<Alphabet> alphabet_;
  Letters known_;
  std::vector<Measure> measures_;
};

// ---- the truth -------------------------------------------------------------------------------------------

struct Truth {
  Stated formula;
  Measure measure;
  std::string tex = {};  ///< for a formula, which may differ from the judged one
  bool takes_long = false;
};

/// The letters' values and the running variable, in long double.
class Running {
 public:
  Running(const Alphabet& of, const std::vector<std::string>& formulas) : place_(of.letters.size()) {
    Drawn any{std::make_shared<Alphabet>(of), std::vector<double>(of.letters.size(), 1)};
    for (const std::string& one : formulas)
      trees_.push_back(formula::parse_tex(one, names_of(any.typeset())));
  }
  class At {
   public:
    At(const Running& of, const Drawn& sample) : of_(of) {
      for (const auto& one : values_of(sample.typeset()))
        letters_.push_back({std::vector<long double>(one.entries.begin(), one.entries.end()), one.columns});
    }
    long double operator()(std::size_t tree, long double running = 0) {
      if (of_.place_ < letters_.size()) letters_[of_.place_].entries = {running};
      return formula::number_of(formula::evaluate(of_.trees_[tree], letters_));
    }

   private:
    const Running& of_;
    std::vector<formula::Matrix<long double>> letters_;
  };

 private:
  std::size_t place_;
  std::vector<formula::Tree> trees_;
};

/// A value, and the size of its terms.
struct Summed {
  long double value = 0, size = 0;
};

/// Gauss's rule on ever more parts, until the result no longer changes.
template <class F>
Summed integrated(const F& f, long double from, long double to) {
  Summed before{std::numeric_limits<long double>::quiet_NaN()};
  for (int parts = 1; parts <= 128; parts *= 2) {
    Summed now;
    const long double half = (to - from) / (2 * parts);
    for (int i = 0; i < parts; ++i)
      for (const auto& [node, weight] : formula::gauss_64()) {
        const long double term = half * weight * f(from + half * (2 * i + 1 + node));
        now.value += term, now.size += std::abs(term);
      }
    if (std::abs(now.value - before.value) <= 1e-15L * now.size) return now;
    before = now;
  }
  throw BadInput("its integral does not settle to 15 digits");
}

template <class F>
Summed added_up(const F& term, long double from, long double to) {
  const long double first = std::round(from), last = std::round(to);
  if (!(std::abs(from - first) < 1e-9L && std::abs(to - last) < 1e-9L))
    throw BadInput("a sum goes from a whole number to another");
  if (!(last - first < 10'000)) throw BadInput("a sum has at most 10,000 terms");
  Summed all;
  for (long double k = first; k <= last; ++k) {
    const long double one = term(k);
    all.value += one, all.size += std::abs(one);
  }
  return all;
}

Truth derivative(Reader& in, const TruthText& text) {
  const Formula what = in.formula(text.what);
  const Formula by = in.formula(text.by);
  const std::string tex = in.tex(what), letter = in.tex(by);
  const auto& letters = in.alphabet().letters;
  if (std::ranges::none_of(letters, [&](const LetterText& one) { return as_typeset(one.name) == letter; }))
    by.fail({}, "this is no letter of the claim");
  Truth truth;
  truth.measure = in.measure(what);
  for (int i = 0; i < text.times; ++i) truth.measure = truth.measure / in.measure(by);
  Drawn any{in.letters(), std::vector<double>(letters.size(), 1)};
  formula::Tree tree = formula::parse_tex(tex, names_of(any.typeset()));
  try {
    for (int i = 0; i < text.times; ++i) tree = formula::differentiate(tree, letter);
  } catch (const formula::NoValue& error) {
    what.fail({}, error.what());
  }
  constexpr std::array<const char*, 4> order{"", "second ", "third ", "fourth "};
  truth.formula.text = std::string("the ") + order[static_cast<std::size_t>(text.times - 1)] +
                       "derivative of $" + tex + "$ by $" + letter + "$";
  truth.formula.of = [tree](const Drawn& s) { return TypesetFormula::value({tree}, values_of(s.typeset())); };
  return truth;
}

Truth running(Reader& in, const TruthText& text) {
  const bool is_sum = text.is == TruthText::Is::sum;
  const Formula from = in.formula(text.from), to = in.formula(text.to);
  const Measure at_first = in.measure(from), at_last = in.measure(to);
  if (!fit(at_first, at_last))
    to.fail({}, "it begins at " + name_of(at_first) + ", and this is " + name_of(at_last));
  const Measure steps = at_first.fits_all ? at_last : at_first;
  const std::string first = in.tex(from), last = in.tex(to);
  if (is_sum && !fit(steps, Measure())) from.fail({}, "a sum runs through whole numbers");
  in.add_running(text.by, steps.fits_all ? Measure(1.0) : steps);
  const Formula what = in.formula(text.what);
  const std::string tex = in.tex(what);
  Truth truth;
  truth.takes_long = true;
  truth.measure = is_sum ? in.measure(what) : in.measure(what) * steps;
  truth.formula.text = std::string(is_sum ? "the sum" : "the integral") + " of $" + tex + "$ over $" +
                       in.alphabet().running + "$ from $" + first + "$ to $" + last + "$";
  const auto trees = std::make_shared<const Running>(in.alphabet(), std::vector{tex, first, last});
  const auto summed = [trees, is_sum](const Drawn& s) {
    Running::At at(*trees, s);
    const auto term = [&](long double x) { return at(0, x); };
    return is_sum ? added_up(term, at(1), at(2)) : integrated(term, at(1), at(2));
  };
  truth.formula.of = [summed](const Drawn& s) { return Value(static_cast<double>(summed(s).value)); };
  truth.formula.terms = [summed](const Drawn& s) { return static_cast<double>(summed(s).size); };
  return truth;
}

Truth truth_of(Reader& in, const TruthText& text) {
  if (text.is == TruthText::Is::derivative) return derivative(in, text);
  if (text.is == TruthText::Is::integral || text.is == TruthText::Is::sum) return running(in, text);
  const Formula what = in.formula(text.what);
  Truth truth{{}, in.measure(what)};
  truth.tex = in.tex(what);
  truth.formula.text = "$" + truth.tex + "$";
  if (text.is == TruthText::Is::formula) return truth;
  if (!text.within.text.empty()) {
    const Formula within = in.formula(text.within);
    if (!fit(in.measure(within), truth.measure)) within.fail({}, "the value is in " + name_of(truth.measure));
    const auto number = number_in(text.within);
    if (!number) within.fail({}, "expected a number, as 0.01 m/s^2");
    in.alphabet().besides = {
        number->number * (number->unit.empty() ? 1 : static_cast<double>(unit_of(number->unit)->size)),
        "the true value is known to " + trimmed(text.within.text) +
            (text.source.empty() ? "" : ", by " + text.source)};
  }
  truth.tex.clear();  // a value may come from the claim itself
  return truth;
}

// ---- what is judged --------------------------------------------------------------------------------------

/// The readings that a claim has.
struct Readings {
  std::optional<Read> printed, meant, corrected;
};

/// The formula or relation for TypesetFormula. Swaps its sides if the left one is a single letter, which
/// would count as the formula's name.
std::string as_equation(const Read& read) {
  const bool letter = formula::tex_tokens(read.sides[0]).size() == 1;
  return letter ? "$" + read.sides[1] + "=" + read.sides[0] + "$" : read.text;
}

std::function<bool(const Drawn&)> condition_of(const std::string& tex) {
  return [tex](const Drawn& s) { return typeset_relation(tex, s.typeset()).value_or(false); };
}
std::string without_dollars(const std::string& text) { return text.substr(1, text.size() - 2); }

class Making {
 public:
  Making(const File& file, const ClaimText& text) : text_(text), source_(file.source), in_(file, text) {
    if (text.where) condition_ = without_dollars(in_.read(*text.where).text);
    if (text.in_view) view_ = in_.read(*text.in_view).text;
  }

  std::function<void(Claims&)> made() {
    const auto readings = {&text_.printed, &text_.meant, &text_.corrected};
    const bool called = in_.is_called(*text_.printed);
    for (const auto* one : readings)
      if (*one && in_.is_called(**one) != called)
        source_.fail((*one)->place, "the printed one is " + std::string(called ? "a formula" : "a relation") +
                                        ", and this is " + (called ? "a relation" : "a formula"));
    if (!called && text_.truth)
      source_.fail(text_.truth->what.place,
                   "both sides of a relation are computed, and it is judged by itself: leave truth out");
    if (called && !text_.truth)
      source_.fail(text_.printed->place, "what is it judged by? add truth = \"another route to it\"");
    if (called && in_.is_fixed() &&
        std::ranges::all_of(readings, [&](const auto* one) { return !*one || number_in(last_side(**one)); }))
      return number();
    const Readings read{in_.read(*text_.printed), read_if(text_.meant), read_if(text_.corrected)};
    const bool equation =
        !called &&
        std::ranges::all_of(std::array{&read.printed, &read.meant, &read.corrected},
                            [](const std::optional<Read>* one) {
                              return !*one || ((*one)->relations.size() == 1 && (*one)->relations[0] == "=");
                            });
    if (!called && !equation) return statement(read);
    return formula(read, equation);
  }

  Verdict stated() const {
    if (text_.meant) return text_.lost ? Verdict::lost : Verdict::misprint;
    if (!text_.corrected) return Verdict::confirmed;
    return text_.in_view ? Verdict::incomplete : Verdict::wrong;
  }

 private:
  static Quoted last_side(const Quoted& text) { return relation_in(text).sides.back(); }
  std::optional<Read> read_if(const std::optional<Quoted>& text) {
    if (!text) return std::nullopt;
    const Read read = in_.read(*text);
    if (!read.units_amiss.empty()) throw BadInput(read.units_amiss);
    return read;
  }
  Fault fault(Fault usual) const {
    return stated() == Verdict::confirmed ? Fault::none
           : text_.lost                   ? Fault::lost_typography
           : text_.in_view                ? Fault::left_out
                                          : usual;
  }
  /// Fails with the reason if there is no value at a sample.
  void require_value(const Stated& formula, const std::vector<Drawn>& samples, const Place& place,
                     bool at_all) const {
    try {
      for (const Drawn& sample : samples) {
        const Value value = computed(formula).of(sample);
        if (!at_all) break;
        if (!finite(value) || value.size() != 1)
          source_.fail(place,
                       "this is no finite number at " + sample.where() + ": narrow the letters' ranges");
      }
    } catch (const WrongFile&) {
      throw;
    } catch (const std::exception& error) {
      source_.fail(place, error.what());
    }
  }

  std::function<void(Claims&)> formula(const Readings& read, bool equation) {
    const Truth truth =
        equation ? Truth{{"zero", [](const Drawn&) { return Value(0.0); }}, {}} : truth_of(in_, *text_.truth);
    const Place at_truth = equation ? text_.printed->place : text_.truth->what.place;
    std::string why = text_.why;
    FormulaClaim<Drawn> parts;
    parts.truth = truth.formula;
    std::vector<Drawn> samples = in_.samples(condition_, text_.place);
    if (truth.takes_long) samples.resize(std::min<std::size_t>(samples.size(), 50));
    require_value(parts.truth, samples, at_truth, true);
    const auto put = [&](const std::optional<Read>& one, Stated& to, bool is_printed) {
      if (!one) return;
      to = {equation ? as_equation(*one) : one->text};
      if (!equation && !truth.tex.empty() && truth.tex == one->sides.back())
        source_.fail(
            at_truth,
            "the truth is the formula that it judges; take another route: an integral, a derivative, a "
            "sum, a value");
      std::string amiss = one->units_amiss;
      if (amiss.empty() && !equation && !fit(one->measure, truth.measure))
        amiss = "it is in " + name_of(one->measure) + ", and the truth in " + name_of(truth.measure);
      if (!amiss.empty() && !is_printed) source_.fail(one->of.place, amiss);
      if (!amiss.empty())
        why +=
            (why.empty() ? "units do not fit: " : "; units do not fit: ") + amiss.substr(0, amiss.find('\n'));
      require_value(to, samples, one->of.place, false);
    };
    put(read.printed, parts.printed, true);
    put(read.meant, parts.meant, false);
    put(read.corrected, parts.corrected, false);
    if (!view_.empty()) parts.in_view = {"for " + view_, condition_of(without_dollars(view_))};
    parts.changes_that_hold = text_.changes_that_hold;
    parts.kind = fault(Fault::formula);
    parts.why = why;
    return [text = text_, samples, parts](Claims& claims) {
      claims.formula(text.name, static_cast<int>(text.place.line), text.says, samples, parts);
    };
  }

  std::function<void(Claims&)> statement(const Readings& read) {
    const std::vector<Drawn> samples = in_.samples(condition_, text_.place);
    StatementClaim<Drawn> parts;
    const auto put = [&](const std::optional<Read>& one, Statement<Drawn>& to) {
      if (!one) return;
      const std::string tex = without_dollars(one->text);
      if (!one->units_amiss.empty()) throw BadInput(one->units_amiss);
      if (!typeset_relation(tex, samples[0].typeset()))
        source_.fail(one->of.place, "this is no relation of numbers");
      to = {one->text, condition_of(tex)};
      std::string turned = "$" + one->sides[0] + opposite(one->relations[0]) + " " + one->sides[1] + "$";
      parts.near_misses = {{turned, condition_of(without_dollars(turned))}};
    };
    put(read.printed, parts.printed), put(read.meant, parts.meant), put(read.corrected, parts.corrected);
    if (!view_.empty()) parts.in_view = {"for " + view_, condition_of(without_dollars(view_))};
    parts.kind = fault(Fault::counterexample);
    parts.why = text_.why;
    return [text = text_, samples, parts](Claims& claims) {
      claims.statement(text.name, static_cast<int>(text.place.line), text.says, samples, parts);
    };
  }

  /// Compares written numbers to half a unit of their last decimal, or to the accuracy of the truth.
  std::function<void(Claims&)> number() {
    const Written printed = *number_in(last_side(*text_.printed));
    const Truth truth = truth_of(in_, *text_.truth);
    const std::vector<Drawn> sample = in_.samples(condition_, text_.place);
    require_value(truth.formula, sample, text_.truth->what.place, true);
    const double unit = printed.unit.empty() ? 1 : static_cast<double>(unit_of(printed.unit)->size);
    const Route route{truth.formula.text, computed(truth.formula).of(sample[0])[0] / unit};
    const std::string quantity = text_.says + (printed.unit.empty() ? "" : ", in " + printed.unit);
    const double besides = in_.alphabet().besides.allowed / unit;
    Claim claim{.why = text_.why, .kind = fault(Fault::number)};
    const auto reading = [&](const Quoted& text) -> Reading {
      const Quoted side = last_side(text);
      const Written written = *number_in(side);
      if (!fit(*measure_of(written.unit), truth.measure))
        source_.fail(side.place, "the truth is in " + name_of(truth.measure));
      if (written.unit != printed.unit)
        source_.fail(side.place, "the printed number is in " + (printed.unit.empty() ? "1" : printed.unit));
      const std::string whole = trimmed(side.text);
      const std::string digits = trimmed(whole.substr(0, whole.size() - written.unit.size()));
      Check check = as_written(quantity, digits, route);
      check.tolerance.allowed += besides;
      if (besides > 0) check.tolerance.reason += ", and " + in_.alphabet().besides.reason;
      return {whole, {check}};
    };
    claim.printed = reading(*text_.printed);
    if (text_.meant) claim.meant = reading(*text_.meant);
    if (text_.corrected) claim.corrected = reading(*text_.corrected);
    const Reading& right = text_.meant ? claim.meant : text_.corrected ? claim.corrected : claim.printed;
    for (const double sign : {-1, 1}) {
      Reading near = right;
      Check& check = near.checks[0];
      const double last_digit = 2 * (check.tolerance.allowed - besides);
      const double off =
          last_digit * (std::floor(2 * check.tolerance.allowed / last_digit) + (besides > 0 ? 1 : 0));
      check.left.value = Value(check.left.value[0] + sign * off);
      near.text = check.left.by = right.text + (sign < 0 ? " less " : " and ") + format_significant(off, 3);
      claim.near_misses.push_back(near);
    }
    return [text = text_, claim](Claims& claims) {
      claims.add(text.name, static_cast<int>(text.place.line), text.says, claim);
    };
  }

  const ClaimText& text_;
  const Source& source_;
  Reader in_;
  std::optional<std::string> condition_;
  std::string view_;
};

}  // namespace

Sheet::Sheet(const File& file, std::string exercise) : exercise_(std::move(exercise)) {
  for (const ClaimText& text : file.claims) {
    Making making(file, text);
    claims_.push_back(making.made());
    stated_[exercise_ + "-" + text.name] = std::string(name_of(making.stated()));
  }
}

Claim Sheet::judged(std::size_t place) const {
  Claims claims(exercise_);
  claims_[place](claims);
  return claims.in_order().front();
}

std::vector<Claim> Sheet::judged() const {
  Claims claims(exercise_);
  for (const auto& one : claims_) one(claims);
  return claims.in_order();
}

}  // namespace oddity::problem
