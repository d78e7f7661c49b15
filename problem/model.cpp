#include "problem/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "chapters/random.hpp"
#include "problem/abbreviations.hpp"
#include "problem/code.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "solvers/ode/unknowns.hpp"

namespace oddity::problem {

namespace {

constexpr int of_rest = 500'000, of_time = 1'000'000, of_parameters = 2'000'000;
constexpr std::size_t most_orders = 8;

/// Numbers of unknowns that the algorithms are compiled for.
#define ODDITY_NUMBER(n, unused) n,
constexpr std::size_t compiled[]{ODDITY_FOR_UNKNOWNS(ODDITY_NUMBER, )};
#undef ODDITY_NUMBER
constexpr std::size_t most_unknowns = *std::ranges::max_element(compiled);

int key_of(std::size_t unknown, std::size_t order) { return static_cast<int>(most_orders * unknown + order); }
/// The unknown, and the order of its rate.
std::pair<std::size_t, std::size_t> unknown_of(int key) {
  return {static_cast<std::size_t>(key) / most_orders, static_cast<std::size_t>(key) % most_orders};
}
std::string primed(const std::string& name, std::size_t order) { return name + std::string(order, '\''); }

Measure per_time(Measure measure, std::size_t times) {
  measure.powers[1] -= static_cast<double>(times);
  return measure;
}

using Rows = std::vector<std::vector<Expression>>;
using Values = formula::Matrix<Expression>;
using Measures = formula::Matrix<Measure>;

}  // namespace

/// Reads a model's formulas, and makes its expressions.
class Model::Making {
 public:
  Making(Model& model, const File& file, const ModelText& text)
      : model_(model),
        file_(file),
        text_(text),
        source_(file.source),
        abbreviations_(file, text),
        letters_(abbreviations_.letters()) {}

  void closed() {
    check_observables();
    for (const ObservableText& o : file_.observables) {
      const auto found = own(text_.closed, o);
      if (!found) source_.fail(text_.name.place, "model " + text_.name.text + " has no " + o.name);
      observe(*found, o);
    }
    for (const auto& [name, formula] : text_.closed) require_observable(name);
  }

  void motion() {
    find_unknowns();
    read_equations();
    start_units();
    check_units();
    order_state();
    model_.unknowns_ = letters_.unknowns;
    Rows matrix;
    std::vector<Expression> right;
    if (!equations_.empty()) {
      from_equations(matrix, right);
      auto highest = solved(matrix, right);
      if (lagrangian_) compare(highest, by_lagrangian(), *text_.lagrangian, "Lagrangian");
      if (hamiltonian_) compare(highest, by_hamiltonian(), *text_.hamiltonian, "Hamiltonian");
      set_rates(highest);
    } else if (hamiltonian_) {
      set_rates(by_hamiltonian());
    } else {
      from_lagrangian(matrix, right);
      set_rates(solved(matrix, right));
    }
    see_whether_linear();
    set_start();
    check_observables();
    for (const ObservableText& o : file_.observables) {
      const auto its = own(text_.observe, o);
      observe(its ? *its : o.is_of_vector ? component(o, o.formula) : formula(o.formula), o);
    }
    see_places();
    set_conserved();
    set_off();
    for (const EventText& event : text_.events) add_event(event);
  }

 private:
  // ---- letters -------------------------------------------------------------------------------------------

  /// The names with a start, in order; primes denote rates. Those that count events come behind them.
  void find_unknowns() {
    if (text_.start.empty())
      source_.fail(text_.name.place,
                   "model " + text_.name.text + " has no start: add start = { y = \"0 m\", \"y'\" = 0 }");
    for (const auto& [name, list] : text_.vectors) require_free(name, 1);
    for (const auto& [key, formula] : text_.start) require_free(key, 0);
    const auto is_started = [&](const std::string& name) {
      return std::ranges::any_of(text_.start, [&](const auto& one) { return base_of(one.first) == name; });
    };
    for (const EventText& event : text_.events) {
      if (event.counts.text.empty()) continue;
      require_free(event.counts, 0);
      if (is_started(event.counts.text))
        source_.fail(event.counts.place, event.counts.text + " has a start: a count needs another name");
    }
    moving_ = static_cast<std::size_t>(
        std::find_if_not(letters_.unknowns.begin(), letters_.unknowns.end(), is_started) -
        letters_.unknowns.begin());
    orders_.assign(letters_.unknowns.size(), 0);
  }
  /// Refuses an unknown whose name has a meaning, or is that of more abbreviations than its own.
  void require_free(const Quoted& key, std::ptrdiff_t abbreviations) const {
    const std::string base = base_of(key);
    const bool is_taken = std::ranges::find(letters_.parameters, base) != letters_.parameters.end() ||
                          std::ranges::count(letters_.given, base) > abbreviations || base == "t";
    if (is_taken)
      source_.fail(key.place, base + " is no unknown: it is a parameter, an abbreviation or the time");
  }
  static std::string base_of(const Quoted& key) { return key.text.substr(0, key.text.find('\'')); }
  bool counts_events(std::size_t i) const { return i >= moving_; }

  Formula formula(const Quoted& text) const { return {source_, text, letters_}; }

  /// As many formulas of numbers: those of a list, or the components of a formula.
  std::vector<Formula> components(const std::string& name, const Quoted& text, Size size) {
    std::vector<Formula> all;
    const auto require_size = [&](Size its) {
      if (its != size)
        source_.fail(text.place, name + " is " + name_of(size) + ", and this is " + name_of(its));
    };
    if (!text.parts.empty()) {
      require_size(text.size());
      for (const Quoted& part : text.parts) all.push_back(formula(part));
      return all;
    }
    const Formula whole = formula(text);
    const Shape its = abbreviations_.shape(whole);
    if (!whole.is_zero()) require_size(extent(its));
    for (std::size_t i = 0; i < size.entries(); ++i) all.push_back(whole.component(i));
    return all;
  }

  /// Notes the arguments of tables that do not extend beyond their rows.
  void see_tables(const Formula& of) {
    of.any([&](const Letter& letter) {
      if (!letter.table || letter.table->holds) return false;
      const Expression at = value(letter.arguments[0]);
      for (std::size_t i = 0; i < model_.tables_.size(); ++i)
        if (model_.tables_[i] == letter.table && model_.looked_up_[i].in(graph()) == at.in(graph()))
          return false;
      model_.tables_.push_back(letter.table);
      model_.looked_up_.push_back(at);
      return false;
    });
  }
  Expression value(const Formula& of) { return of.number(values(of)); }
  Values values(const Formula& of) {
    if (!file_.tables.empty()) see_tables(of);
    return of.values([&](const Letter& letter) { return values(letter, of); });
  }
  Values values(const Letter& letter, const Formula& of) {
    switch (letter.is) {
      case Letter::Is::quantity:
        return {{letter.value}};
      case Letter::Is::parameter:
        return {{input(graph(), of_parameters + static_cast<int>(letter.index)) *
                 Expression(file_.parameters[letter.index].size)}};
      case Letter::Is::time:
        return {{input(graph(), of_time)}};
      case Letter::Is::unknown:
        if (letter.order > orders_[letter.index])
          of.fail(letter.span,
                  primed(letters_.unknowns[letter.index], letter.order) + " is beyond the equations' order");
        return {{input(graph(), key_of(letter.index, letter.order))}};
      case Letter::Is::given: {
        auto& known = values_of_given_[letter.index];
        if (known.empty()) {
          const Formula& abbreviation = abbreviations_[letter.index];
          const Abbreviations::Inside inside(abbreviations_, abbreviation);
          const Values x = values(abbreviation);
          known.push_back(x);
        }
        while (known.size() <= letter.order) {
          Values rates = known.back();
          for (Expression& one : rates.entries) one = rate(one);
          known.push_back(rates);
        }
        return known[letter.order];
      }
      case Letter::Is::call:
        break;
    }
    return {};
  }
  Measure measure(const Formula& of) {
    if (file_.is_plain) return 0;  // fits any unit
    return of.number(measures(of));
  }
  Measures measures(const Formula& of) {
    return of.measures([&](const Letter& letter) -> Measures {
      switch (letter.is) {
        case Letter::Is::quantity:
          return {{letter.measure}};
        case Letter::Is::parameter:
          return {{file_.parameters[letter.index].measure}};
        case Letter::Is::time: {
          Measure second;
          second.powers[1] = 1;
          return {{second}};
        }
        case Letter::Is::unknown:
          if (!units_[letter.index])
            source_.fail(text_.name.place, "the unit of " + letters_.unknowns[letter.index] +
                                               " is not known: start it with one, as in 0 m");
          return {{per_time(*units_[letter.index], letter.order)}};
        case Letter::Is::given: {
          auto& known = measures_of_given_[letter.index];
          if (!known) {
            const Formula& abbreviation = abbreviations_[letter.index];
            const Abbreviations::Inside inside(abbreviations_, abbreviation);
            const Measures its = measures(abbreviation);
            known = its;
          }
          Measures rates = *known;
          for (Measure& one : rates.entries) one = per_time(one, letter.order);
          return rates;
        }
        case Letter::Is::call:
          break;
      }
      return {};
    });
  }
  Graph& graph() { return *model_.graph_; }

  void require_order(std::size_t i, std::size_t order) const {
    if (order >= most_orders)
      source_.fail(text_.name.place, "rates are of order " + std::to_string(most_orders - 1) +
                                         " at most, and " + primed(letters_.unknowns[i], order) +
                                         " is needed");
  }
  /// Rate along the motion.
  Expression rate(const Expression& x) {
    std::map<int, Expression> along{{of_time, 1}};
    for (const int key : keys_of(std::span(&x, 1))) {
      if (key >= of_time) continue;
      const auto [i, order] = unknown_of(key);
      require_order(i, order + 1);
      along.emplace(key, input(graph(), key + 1));
    }
    return slopes(std::span(&x, 1), along)[0];
  }
  Expression slope(const Expression& x, int key) { return slopes(std::span(&x, 1), {{key, 1}})[0]; }

  // ---- equations -----------------------------------------------------------------------------------------

  void read_equations() {
    for (const auto& [of, rate] : text_.turns) components("the angular velocity of " + of.text, rate, {3, 1});
    for (const Quoted& text : text_.equations) add_equations(text, equations_);
    if (text_.lagrangian) lagrangian_ = formula(*text_.lagrangian);
    if (text_.dissipation) dissipation_ = formula(*text_.dissipation);
    for (const Quoted& text : text_.constraints) add_equations(text, constraints_);
    if (constraints_.size() >= moving_ && !constraints_.empty())
      source_.fail(text_.constraints.back().place, std::to_string(constraints_.size()) +
                                                       " constraints leave " + std::to_string(moving_) +
                                                       " unknowns no motion");
    for (const Quoted& text : text_.conditions) conditions_.push_back(formula(text));
    if (lagrangian_) std::ranges::fill(orders_, 2);
    if (text_.hamiltonian) read_hamiltonian();
    forces_.resize(orders_.size());
    for (const auto& [name, text] : text_.forces) {
      const std::vector<std::size_t> on = unknowns(name);
      const std::vector<Formula> all = components("the force on " + name.text, text, size(name));
      for (std::size_t k = 0; k < on.size(); ++k) forces_[on[k]] = all[k];
      if (hamiltonian_ && !is_place(on[0]))
        source_.fail(name.place, "a force is on a place, and " + name.text + " is a momentum");
    }
    for (const Equation& one : equations_)
      for (const Formula* side : {&one.left, &one.right}) see_orders(*side, 0);
    for (const Formula& one : conditions_) see_orders(one, 1);
    order_counts();
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      require_order(i, orders_[i]);
      if (orders_[i] == 0) {
        const bool is_found = std::ranges::find(text_.found, letters_.unknowns[i]) != text_.found.end();
        source_.fail(text_.name.place,
                     (is_found ? "no condition has " : "no equation has a rate of ") + letters_.unknowns[i]);
      }
    }
    if (!equations_.empty() && equations_.size() + conditions_.size() != moving_)
      source_.fail(text_.equations.back().place, std::to_string(equations_.size()) + " equations for " +
                                                     std::to_string(moving_) + " unknowns");
    limit_orders();
  }
  /// Counts are at rest between events, with a rate if everything else has one: the accelerations of such a
  /// motion may be functions of places alone.
  void order_counts() {
    const auto moving = std::span(orders_).first(moving_);
    const std::size_t order = std::ranges::all_of(moving, [](std::size_t one) { return one == 2; }) ? 2 : 1;
    std::ranges::fill(std::span(orders_).subspan(moving_), order);
  }
  /// An equation of vectors or matrices is one for each component.
  void add_equations(const Quoted& text, std::vector<Equation>& all) {
    const Equation whole = equation(source_, text, letters_);
    const Shape left = abbreviations_.shape(whole.left), right = abbreviations_.shape(whole.right);
    if (extent(left) != extent(right) && !whole.left.is_zero() && !whole.right.is_zero())
      whole.right.fail({}, "the left side is " + name_of(left) + ", and the right side " + name_of(right));
    for (std::size_t i = 0; i < std::max(left.entries.size(), right.entries.size()); ++i)
      all.push_back({whole.left.component(i), whole.right.component(i)});
  }
  void limit_orders() {
    const auto up_to = [](std::size_t most) {
      return [most](std::size_t, std::size_t order) { return order <= most; };
    };
    for (const Equation& one : constraints_)
      for (const Formula* side : {&one.left, &one.right})
        limit(*side, "a constraint is of places, and this is a rate", up_to(0));
    if (lagrangian_) limit(*lagrangian_, "a Lagrangian is of unknowns and their rates", up_to(1));
    if (dissipation_) limit(*dissipation_, "a dissipation function is of unknowns and their rates", up_to(1));
    if (hamiltonian_)
      limit(*hamiltonian_, "a Hamiltonian is of places and momenta, and this is a rate", up_to(0));
    for (const auto& force : forces_) {
      if (force && lagrangian_) limit(*force, "a force is of unknowns and their rates", up_to(1));
      if (force && hamiltonian_)
        limit(*force, "a force is of places, their rates and momenta: write this by them",
              [&](std::size_t i, std::size_t order) { return order == 0 || (order == 1 && is_place(i)); });
    }
  }
  /// Refuses letters with other rates of unknowns than these, also those of abbreviations.
  template <class Allowed>
  void limit(const Formula& of, const char* says, const Allowed& is_allowed) {
    of.any([&](const Letter& letter) {
      if (letter.is != Letter::Is::unknown && letter.is != Letter::Is::given) return false;
      for (const int key : keys_of(values(letter, of).entries))
        if (key < of_time && !std::apply(is_allowed, unknown_of(key))) of.fail(letter.span, says);
      return false;
    });
  }
  bool is_place(std::size_t i) const {
    return std::ranges::any_of(pairs_, [i](const auto& pair) { return pair.first == i; });
  }
  /// An unknown, or the components of one that is a vector or a matrix.
  std::vector<std::size_t> unknowns(const Quoted& name) const {
    std::vector<std::size_t> all;
    const auto found = vector_called(name);
    if (found == text_.vectors.end()) return {unknown(name)};
    for (const Quoted& part : found->second.parts) all.push_back(unknown(part));
    return all;
  }
  Size size(const Quoted& name) const {
    const auto found = vector_called(name);
    return found == text_.vectors.end() ? Size() : found->second.size();
  }
  Named::const_iterator vector_called(const Quoted& name) const {
    return std::ranges::find_if(text_.vectors, [&](const auto& one) { return one.first.text == name.text; });
  }
  std::size_t unknown(const Quoted& name) const {
    const auto found = std::ranges::find(letters_.unknowns, name.text);
    if (found == letters_.unknowns.end())
      source_.fail(name.place, "no unknown " + name.text + did_you_mean(name.text, letters_.unknowns));
    const auto i = static_cast<std::size_t>(found - letters_.unknowns.begin());
    if (counts_events(i)) source_.fail(name.place, name.text + " counts events, and nothing else changes it");
    return i;
  }
  void read_hamiltonian() {
    hamiltonian_ = formula(*text_.hamiltonian);
    std::ranges::fill(orders_, 1);
    std::vector<char> known(moving_, 0);
    for (const auto& [place, momentum] : text_.momenta) {
      const std::vector<std::size_t> places = unknowns(place), momenta = unknowns(momentum);
      if (size(place) != size(momentum))
        source_.fail(momentum.place, place.text + " is " + name_of(size(place)) + ", and " + momentum.text +
                                         " is " + name_of(size(momentum)));
      for (std::size_t k = 0; k < places.size(); ++k) {
        pairs_.emplace_back(places[k], momenta[k]);
        for (const std::size_t i : {places[k], momenta[k]})
          if (known[i]++ != 0) source_.fail(place.place, letters_.unknowns[i] + " is in two pairs");
      }
    }
    for (std::size_t i = 0; i < known.size(); ++i)
      if (known[i] == 0)
        source_.fail(text_.hamiltonian->place,
                     letters_.unknowns[i] + " is no place and no momentum: add it to momenta");
  }

  /// The highest rate of each unknown, those of abbreviations included.
  void see_orders(const Formula& of, std::size_t more) {
    of.any([&](const Letter& letter) {
      if (letter.is == Letter::Is::unknown)
        orders_[letter.index] = std::max(orders_[letter.index], letter.order + more);
      if (letter.is == Letter::Is::given && seen_.emplace(letter.index, more + letter.order).second) {
        const Formula& abbreviation = abbreviations_[letter.index];
        const Abbreviations::Inside inside(abbreviations_, abbreviation);
        see_orders(abbreviation, more + letter.order);
      }
      return false;
    });
  }

  /// The unknowns' units, from the observables or their start.
  void start_units() {
    units_.resize(orders_.size());
    for (std::size_t i = 0; i < units_.size(); ++i)
      for (const ObservableText& o : file_.observables)
        if (o.formula.text == letters_.unknowns[i] && !overrides(o)) units_[i] = o.measure;
    for (const auto& [key, text] : text_.start) {
      const std::string base = key.text.substr(0, key.text.find('\''));
      const std::size_t order = key.text.size() - base.size();
      const auto i =
          static_cast<std::size_t>(std::ranges::find(letters_.unknowns, base) - letters_.unknowns.begin());
      if (order >= orders_[i])
        source_.fail(key.place, "the equations are of order " + std::to_string(orders_[i]) + " in " + base +
                                    ": leave " + key.text + " out");
      Letters known = letters_;
      known.unknowns.clear();
      const Formula start(source_, text, known);
      const Measure its = measure(start);
      if (!its.fits_all && !units_[i])
        units_[i] = per_time(its, 0), units_[i]->powers[1] += static_cast<double>(order);
      if (!its.fits_all && !fit(its, per_time(*units_[i], order)))
        source_.fail(text.place, key.text + " is in " + name_of(per_time(*units_[i], order)) +
                                     ", and this is " + name_of(its));
      starts_.emplace(key_of(i, order), start);
    }
    share_units();
    for (std::size_t i = moving_; i < units_.size(); ++i) {
      if (units_[i] && !fit(*units_[i], Measure()))
        source_.fail(text_.name.place,
                     letters_.unknowns[i] + " counts events: observe it as a pure number, \"1\"");
      units_[i] = Measure();
    }
    for (std::size_t i = 0; i < moving_; ++i)
      for (std::size_t k = 0; k < orders_[i]; ++k)
        if (!starts_.contains(key_of(i, k))) {
          const auto vector = vector_of(letters_.unknowns[i]);
          const bool is_vector = vector != text_.vectors.end();
          const std::string name = primed(is_vector ? vector->first.text : letters_.unknowns[i], k);
          const char* form = !is_vector                          ? " = ..."
                             : vector->second.size().is_matrix() ? " = [[...], [...]]"
                                                                 : " = [...]";
          source_.fail(text_.name.place, "no start for " + name + ": add " +
                                             (k > 0 ? "\"" + name + "\"" : name) + form + " to start");
        }
  }

  /// A component that starts with 0 has the unit of the others.
  void share_units() {
    for (const auto& [vector, list] : text_.vectors) {
      const std::vector<std::size_t> all = unknowns(vector);
      const auto known = std::ranges::find_if(all, [&](std::size_t i) { return units_[i].has_value(); });
      for (const std::size_t i : all)
        if (!units_[i] && known != all.end()) units_[i] = units_[*known];
    }
  }

  /// The vector or matrix that an unknown is a component of.
  Named::const_iterator vector_of(const std::string& unknown) const {
    return std::ranges::find_if(text_.vectors, [&](const auto& one) {
      return std::ranges::find(one.second.parts, unknown, &Quoted::text) != one.second.parts.end();
    });
  }

  void check_units() {
    for (const Equation& one : equations_) {
      const Measure left = measure(one.left), right = measure(one.right);
      if (!fit(left, right))
        one.right.fail({}, "the left side is " + name_of(left) + ", and the right side " + name_of(right) +
                               one.left.meant() + one.right.meant());
    }
    for (const Equation& one : constraints_)
      if (const Measure left = measure(one.left), right = measure(one.right); !fit(left, right))
        one.right.fail({}, "the left side is " + name_of(left) + ", and the right side " + name_of(right));
    if (!lagrangian_ && !hamiltonian_) return;
    const Measure energy = measure(lagrangian_ ? *lagrangian_ : *hamiltonian_);
    for (const auto& [place, momentum] : pairs_)
      if (!fit(per_time(*units_[place] * *units_[momentum], 1), energy))
        hamiltonian_->fail({}, "the unit of the energy is to be that of " + letters_.unknowns[place] +
                                   "' times " + letters_.unknowns[momentum] + ", and is " + name_of(energy));
    for (std::size_t i = 0; i < forces_.size(); ++i)
      if (forces_[i] && !fit(measure(*forces_[i]) * *units_[i], energy))
        forces_[i]->fail(
            {}, "the force on " + letters_.unknowns[i] + " is to be in " + name_of(energy / *units_[i]));
    if (dissipation_ && !fit(measure(*dissipation_), per_time(energy, 1)))
      dissipation_->fail({}, "a dissipation function is to be in " + name_of(per_time(energy, 1)));
  }

  /// Orders the state: all unknowns, then all their rates.
  void order_state() {
    for (std::size_t k = 0; k < most_orders; ++k)
      for (std::size_t i = 0; i < orders_.size(); ++i)
        if (k < orders_[i]) model_.state_.push_back(key_of(i, k));
    if (model_.state_.size() > most_unknowns)
      source_.fail(text_.name.place, "model " + text_.name.text + " has " +
                                         std::to_string(model_.state_.size()) +
                                         " unknowns and rates, and the algorithms are compiled for at most " +
                                         std::to_string(most_unknowns));
    for (const int key : model_.state_) {
      const auto found = std::ranges::find(model_.state_, key + 1);
      const auto [i, order] = unknown_of(key);
      const bool is_highest = order + 1 == orders_[i];
      model_.rate_of_.push_back(is_highest ? -1 : static_cast<int>(found - model_.state_.begin()));
    }
  }

  int highest(std::size_t i) const { return key_of(i, orders_[i]); }
  std::string highest_name(std::size_t i) const { return primed(letters_.unknowns[i], orders_[i]); }

  void from_equations(Rows& matrix, std::vector<Expression>& right) {
    std::map<int, Expression> none;
    for (std::size_t i = 0; i < orders_.size(); ++i) none.emplace(highest(i), 0);
    std::vector<std::pair<Expression, const Formula*>> zeros;
    for (const Equation& one : equations_) zeros.emplace_back(value(one.left) - value(one.right), &one.left);
    for (const Formula& one : conditions_) zeros.emplace_back(rate(value(one)), &one);
    for (const auto& [off, where] : zeros) {
      std::vector<Expression>& row = matrix.emplace_back();
      for (std::size_t i = 0; i < moving_; ++i) {
        row.push_back(slope(off, highest(i)));
        for (const int key : keys_of(std::span(&row.back(), 1)))
          if (none.contains(key))
            where->fail({}, "the equation is not linear in " + highest_name(i) + ", which it is solved for");
      }
      right.push_back(Expression(0) - replaced(std::span(&off, 1), none)[0]);
    }
  }

  /// The multipliers of the constraints come behind the unknowns, with a row for each constraint: its second
  /// rate is zero.
  void from_lagrangian(Rows& matrix, std::vector<Expression>& right) {
    const Expression L = value(*lagrangian_);
    std::map<int, Expression> along{{of_time, 1}};
    for (std::size_t j = 0; j < orders_.size(); ++j)
      along.emplace(key_of(j, 0), input(graph(), key_of(j, 1)));
    const std::vector<Expression> off = off_constraints();
    for (std::size_t i = 0; i < moving_; ++i) {
      const Expression p = slope(L, key_of(i, 1));
      std::vector<Expression>& row = matrix.emplace_back();
      for (std::size_t j = 0; j < moving_; ++j) row.push_back(slope(p, key_of(j, 1)));
      for (const Expression& one : off) row.push_back(-slope(one, key_of(i, 0)));
      Expression force = slope(L, key_of(i, 0)) - slopes(std::span(&p, 1), along)[0];
      if (forces_[i]) force = force + value(*forces_[i]);
      if (dissipation_) force = force - slope(value(*dissipation_), key_of(i, 1));
      right.push_back(force);
    }
    for (const Expression& one : off) {
      std::vector<Expression>& row = matrix.emplace_back();
      for (std::size_t j = 0; j < moving_; ++j) row.push_back(slope(one, key_of(j, 0)));
      row.resize(moving_ + off.size(), 0);
      const Expression rate = slopes(std::span(&one, 1), along)[0];
      right.push_back(-slopes(std::span(&rate, 1), along)[0]);
    }
  }
  std::vector<Expression> by_lagrangian() {
    Rows matrix;
    std::vector<Expression> right;
    from_lagrangian(matrix, right);
    return solved(matrix, right);
  }
  std::vector<Expression> by_hamiltonian() {
    const Expression H = value(*hamiltonian_);
    std::vector<Expression> rates(orders_.size());
    for (const auto& [place, momentum] : pairs_) {
      rates[place] = slope(H, key_of(momentum, 0));
      rates[momentum] = -slope(H, key_of(place, 0));
      rates_of_places_.emplace(key_of(place, 1), rates[place]);
    }
    for (const auto& [place, momentum] : pairs_)
      if (forces_[place]) rates[momentum] = rates[momentum] + by_momenta(value(*forces_[place]));
    return rates;
  }
  /// With a Hamiltonian, the places' rates in terms of the momenta.
  Expression by_momenta(const Expression& x) const {
    return rates_of_places_.empty() ? x : replaced(std::span(&x, 1), rates_of_places_)[0];
  }
  std::vector<Expression> off_constraints() {
    std::vector<Expression> off;
    for (const Equation& one : constraints_) off.push_back(value(one.left) - value(one.right));
    return off;
  }
  /// Each constraint over the length of its gradient, which is a distance if the unknowns are lengths; and
  /// its rate.
  void set_off() {
    std::vector<Expression> rates;
    for (const Expression& one : off_constraints()) {
      Expression square = 0;
      for (std::size_t i = 0; i < moving_; ++i) {
        const Expression along = slope(one, key_of(i, 0));
        square = square + along * along;
      }
      model_.off_.push_back(one / sqrt(square));
      rates.push_back(rate(one) / sqrt(square));
    }
    model_.off_.insert(model_.off_.end(), rates.begin(), rates.end());
  }

  // ---- the highest rates ---------------------------------------------------------------------------------

  /// Random numbers near the parameters and for the state, to distinguish zero from other numbers.
  std::map<int, long double> some_state(Random& random) const {
    std::map<int, long double> values{{of_time, random.between(0.1, 1)}};
    for (std::size_t i = 0; i < file_.parameters.size(); ++i) {
      const double x = file_.parameters[i].value;
      values[of_parameters + static_cast<int>(i)] = x == 0 ? 0 : x * random.between(0.95, 1.05);
    }
    for (std::size_t i = 0; i < orders_.size(); ++i)
      for (std::size_t k = 0; k <= orders_[i]; ++k) values[key_of(i, k)] = random.between(0.2, 1.2);
    return values;
  }
  static long double number(const Expression& x, const std::map<int, long double>& values) {
    const std::vector<int> keys = keys_of(std::span(&x, 1));
    if (keys.empty()) return x.is_number() ? x.number() : replaced(std::span(&x, 1), {})[0].number();
    std::vector<long double> in;
    for (const int key : keys) in.push_back(values.at(key));
    long double result = 0;
    Program(std::span(&x, 1), keys).run(in.data(), in.back(), &result);
    return result;
  }

  using Pivot = std::optional<std::pair<std::size_t, std::size_t>>;

  static int entries(const std::vector<Expression>& row, const std::vector<std::size_t>& columns) {
    return static_cast<int>(std::ranges::count_if(columns, [&](std::size_t c) { return !row[c].is(0); }));
  }
  /// Pivot for equations in any order: the largest next to its row, in the sparsest rows.
  static Pivot strong_pivot(const Rows& a, const std::vector<std::size_t>& rows,
                            const std::vector<std::size_t>& columns,
                            const std::map<int, long double>& values) {
    Pivot best;
    long double most = 0;
    int fewest = 1'000;
    for (const std::size_t r : rows) {
      long double size = 0;
      const int others = entries(a[r], columns);
      for (const std::size_t c : columns) size = std::max(size, std::abs(number(a[r][c], values)));
      for (const std::size_t c : columns) {
        const long double share = size > 0 ? std::abs(number(a[r][c], values)) / size : 0;
        // Sparse rows first, then strong pivots, then the diagonal.
        const bool better =
            share > 0.01L &&
            (others < fewest || (others == fewest && share > most * 1.5L) ||
             (others == fewest && share > most * 0.9L && r == c && (!best || best->first != best->second)));
        if (better) best = {r, c}, most = share, fewest = others;
      }
    }
    return best;
  }
  /// Pivot in the sparsest row: first masses, which are positive at every state, then the constraints'
  /// multipliers, whose block is regular if the constraints are independent.
  Pivot diagonal_pivot(const Rows& a, const std::vector<std::size_t>& rows, std::vector<long double>& sizes,
                       const std::map<int, long double>& values) const {
    const bool masses = rows.front() < moving_;
    Pivot best;
    int fewest = 1'000;
    for (const std::size_t r : rows) {
      if (masses && r >= moving_) continue;
      const long double size = std::abs(number(a[r][r], values));
      sizes[r] = std::max(sizes[r], size);
      if (const int others = entries(a[r], rows); size > 1e-12L * sizes[r] && others < fewest)
        best = {r, r}, fewest = others;
    }
    return best;
  }

  /// Elimination in the graph. Chooses the order of pivots once, by numbers, at a generic state.
  std::vector<Expression> solved(Rows a, std::vector<Expression> b) {
    const std::size_t n = a.size();
    Random random(52);
    const auto values = some_state(random);
    std::vector<std::size_t> rows(n), columns(n);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    columns = rows;
    std::vector<std::pair<std::size_t, std::size_t>> pivots;
    std::vector<long double> sizes(n, 0);
    while (!rows.empty()) {
      const auto best = lagrangian_ && equations_.empty() ? diagonal_pivot(a, rows, sizes, values)
                                                          : strong_pivot(a, rows, columns, values);
      if (!best) {
        std::string names;
        for (const std::size_t c : columns)
          names += (names.empty() ? "" : ", ") + (c < moving_ ? highest_name(c) : "a multiplier");
        source_.fail(text_.equations.empty() ? text_.lagrangian->place : text_.equations.front().place,
                     "this cannot be solved for " + names + ": the matrix is singular");
      }
      const auto [r, c] = *best;
      pivots.push_back(*best);
      std::erase(rows, r);
      std::erase(columns, c);
      for (const std::size_t other : rows) {
        if (a[other][c].is(0)) continue;
        const Expression factor = a[other][c] / a[r][c];
        for (const std::size_t k : columns) a[other][k] = a[other][k] - factor * a[r][k];
        a[other][c] = 0;
        b[other] = b[other] - factor * b[r];
      }
    }
    std::vector<Expression> x(n);
    std::vector<std::size_t> known;
    for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
      Expression sum = b[pivot->first];
      for (const std::size_t k : known) sum = sum - a[pivot->first][k] * x[k];
      x[pivot->second] = sum / a[pivot->first][pivot->second];
      known.push_back(pivot->second);
    }
    return x;
  }

  /// The rates of another description at random states.
  void compare(const std::vector<Expression>& by_equations, const std::vector<Expression>& others,
               const Quoted& text, const std::string& what) {
    Random random(7);
    for (int k = 0; k < 20; ++k) {
      const auto values = some_state(random);
      for (std::size_t i = 0; i < moving_; ++i) {
        const long double one = number(by_equations[i], values), other = number(others[i], values);
        if (!(std::abs(one - other) <= 1e-9L * (1 + std::abs(one))))
          source_.fail(text.place, "the " + what + "'s " + highest_name(i) +
                                       " is not that of the equations, at a random state");
      }
    }
  }

  void set_rates(const std::vector<Expression>& highest_rates) {
    for (const int key : model_.state_) {
      const auto [i, order] = unknown_of(key);
      const bool is_last = order + 1 == orders_[i];
      const Expression highest = counts_events(i) ? Expression(0) : highest_rates[i];
      model_.rates_.push_back(is_last ? highest : input(graph(), key + 1));
    }
  }

  /// Linear if no slope depends on the state.
  void see_whether_linear() {
    for (const int key : model_.state_)
      for (const int other : keys_of(slopes(model_.rates_, {{key, 1}})))
        if (other < of_time) model_.is_linear_ = false;
  }

  void set_start() {
    for (const int key : model_.state_) {
      if (counts_events(unknown_of(key).first)) {
        model_.start_.emplace_back(0);
        continue;
      }
      const Formula& start = starts_.at(key);
      const Expression x = value(start), at_zero = replaced(std::span(&x, 1), {{of_time, 0}})[0];
      for (const int other : keys_of(std::span(&at_zero, 1))) {
        if (other < of_time) start.fail({}, "a start is of parameters alone");
        const auto p = static_cast<std::size_t>(other - of_parameters);
        if (std::ranges::find(model_.starts_with_, p) == model_.starts_with_.end())
          model_.starts_with_.push_back(p);
      }
      model_.start_.push_back(at_zero);
    }
    if (!conditions_.empty()) find_start();
    for (const auto& [of, rate] : text_.turns) {
      Expression square = 0;
      for (const std::size_t i : unknowns(of)) {
        const auto place = std::ranges::find(model_.state_, key_of(i, 0)) - model_.state_.begin();
        const Expression& x = model_.start_[static_cast<std::size_t>(place)];
        square = square + x * x;
      }
      model_.lengths_.push_back(sqrt(square));
    }
  }

  /// Newton's method from the given start. Its last change has to be zero.
  void find_start() {
    constexpr int iterations = 12;  // each doubles the digits
    std::vector<Expression> off;
    for (const Formula& one : conditions_) off.push_back(value(one));
    std::vector<std::size_t> found;  // indices in the state
    for (const std::string& name : text_.found) {
      const auto i = std::ranges::find(letters_.unknowns, name) - letters_.unknowns.begin();
      const auto place = std::ranges::find(model_.state_, key_of(static_cast<std::size_t>(i), 0));
      found.push_back(static_cast<std::size_t>(place - model_.state_.begin()));
    }
    Rows slopes_of;
    for (const Expression& one : off) {
      std::vector<Expression>& row = slopes_of.emplace_back();
      for (const std::size_t i : found) row.push_back(slope(one, model_.state_[i]));
    }
    for (int k = 0; k < iterations; ++k) {
      std::map<int, Expression> now{{of_time, 0}};
      for (std::size_t i = 0; i < model_.state_.size(); ++i) now.emplace(model_.state_[i], model_.start_[i]);
      Rows matrix;
      for (const auto& row : slopes_of) matrix.push_back(replaced(row, now));
      model_.still_changing_ = solved(matrix, replaced(off, now));
      for (std::size_t i = 0; i < found.size(); ++i)
        model_.start_[found[i]] = model_.start_[found[i]] - model_.still_changing_[i];
    }
  }

  // ---- what is observed and conserved --------------------------------------------------------------------

  bool overrides(const ObservableText& o) const {
    return std::ranges::any_of(text_.observe, [&](const auto& one) {
      return one.first.text == o.name || one.first.text == o.vector;
    });
  }
  /// The model's own formula of an observable, or of the vector that it is a component of.
  std::optional<Formula> own(const Named& all, const ObservableText& o) {
    for (const auto& [name, text] : all) {
      if (name.text == o.name) return formula(text);
      if (name.text == o.vector) return component(o, text);
    }
    return std::nullopt;
  }
  Formula component(const ObservableText& o, const Quoted& of_vector) {
    return components(o.vector, of_vector, o.vector_size)[o.component];
  }
  void require_observable(const Quoted& name) const {
    std::vector<std::string> names;
    for (const ObservableText& o : file_.observables) {
      names.push_back(o.name);
      if (!o.vector.empty()) names.push_back(o.vector);
    }
    if (std::ranges::find(names, name.text) == names.end())
      source_.fail(name.place, "no observable " + name.text + did_you_mean(name.text, names));
  }
  void check_observables() const {
    for (const auto& [name, text] : text_.observe) require_observable(name);
  }
  void observe(const Formula& formula, const ObservableText& o) {
    const Measure its = measure(formula);
    if (!fit(its, o.measure))
      formula.fail({}, o.name + " is observed in " + name_of(o.measure) + ", and this is " + name_of(its));
    model_.observed_.push_back(of_state(formula, "what is observed") / Expression(o.size));
  }
  /// The value of a formula that depends on the state and the time only.
  Expression of_state(const Formula& formula, const std::string& what) {
    const Expression x = by_momenta(value(formula));
    for (const int key : keys_of(std::span(&x, 1)))
      if (key < of_time && std::ranges::find(model_.state_, key) == model_.state_.end())
        formula.fail({}, what + " is of the state and the time, and this has a highest rate");
    return x;
  }

  // ---- events --------------------------------------------------------------------------------------------

  void add_event(const EventText& text) {
    const Formula when = formula(text.when);
    measure(when);
    const Expression guard = of_state(when, "an event's guard");
    std::map<int, Expression> after;
    for (const auto& [key, formula_text] : text.then) {
      const std::string base = base_of(key);
      const std::size_t order = key.text.size() - base.size();
      const Quoted whole{base, key.place};
      const std::vector<std::size_t> changed = unknowns(whole);
      const std::vector<Formula> all = components(key.text, formula_text, size(whole));
      for (std::size_t k = 0; k < changed.size(); ++k) {
        const std::size_t i = changed[k];
        if (order >= orders_[i])
          source_.fail(key.place, key.text + " is no part of the state: the equations decide it");
        const Measure its = measure(all[k]), meant = per_time(*units_[i], order);
        if (!fit(its, meant))
          all[k].fail({}, key.text + " is in " + name_of(meant) + ", and this is " + name_of(its));
        if (!after.emplace(key_of(i, order), of_state(all[k], "the state after an event")).second)
          source_.fail(key.place, key.text + " is set twice");
      }
    }
    if (!text.counts.text.empty()) {
      const auto count = std::ranges::find(letters_.unknowns, text.counts.text) - letters_.unknowns.begin();
      const int key = key_of(static_cast<std::size_t>(count), 0);
      after.emplace(key, input(graph(), key) + Expression(1));
    }
    if (text.direction != Direction::rising) add_event(guard, after, text.ends);
    if (text.direction != Direction::falling) add_event(-guard, after, text.ends);
    model_.is_linear_ = false;
  }
  void add_event(const Expression& guard, const std::map<int, Expression>& after, bool ends) {
    model_.guards_.push_back(guard);
    for (const int key : model_.state_) {
      const auto changed = after.find(key);
      model_.afterwards_.push_back(changed == after.end() ? input(graph(), key) : changed->second);
    }
    model_.events_.push_back({ends, !touches(after, guard)});
  }
  /// Whether the event changes its guard or the guard's rate, at random states.
  bool touches(const std::map<int, Expression>& after, const Expression& guard) {
    std::map<int, Expression> highest;
    for (std::size_t i = 0; i < model_.state_.size(); ++i)
      highest.emplace(model_.state_[i] + 1, model_.rates_[i]);
    for (const int key : model_.state_) highest.erase(key);
    const Expression slope = rate(guard);
    const std::vector<Expression> before{guard, replaced(std::span(&slope, 1), highest)[0]};
    const std::vector<Expression> then = replaced(before, after);
    Random random(11);
    for (int k = 0; k < 5; ++k) {
      const auto values = some_state(random);
      for (std::size_t i = 0; i < before.size(); ++i)
        if (number(before[i], values) != number(then[i], values)) return true;
    }
    return false;
  }

  void see_places() {
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      const int place = input(graph(), key_of(i, 0)).in(graph());
      const auto seen = std::ranges::find_if(model_.observed_, [&](const Expression& one) {
        return !one.is_number() && one.in(graph()) == place;
      });
      if (orders_[i] != 2 || seen == model_.observed_.end()) return model_.seen_as_.clear();
      model_.seen_as_.push_back(static_cast<std::size_t>(seen - model_.observed_.begin()));
    }
  }

  /// A Lagrangian's energy if nothing drives or brakes; or the file's own, which has to be conserved.
  void set_conserved() {
    if (text_.kinetic) {
      const Formula kinetic = formula(*text_.kinetic), potential = formula(*text_.potential);
      if (!fit(measure(kinetic), measure(potential)))
        potential.fail({}, "the potential energy is not in the kinetic one's unit");
      const Expression T = of_state(kinetic, "an energy"), V = of_state(potential, "an energy");
      model_.conserved_ = {T + V, T};
    } else if (lagrangian_ && equations_.empty() && !dissipation_ && text_.forces.empty() &&
               text_.events.empty()) {
      const Expression L = value(*lagrangian_);
      std::vector<Expression> all = off_constraints();
      all.push_back(L);
      for (const int key : keys_of(all))
        if (key == of_time) return;
      Expression twice = 0;
      for (std::size_t i = 0; i < orders_.size(); ++i)
        twice = twice + input(graph(), key_of(i, 1)) * slope(L, key_of(i, 1));
      model_.conserved_ = {twice - L, twice / Expression(2)};
    } else if (hamiltonian_ && text_.forces.empty() && text_.events.empty()) {
      const Expression H = value(*hamiltonian_);
      Expression twice = 0;
      for (const auto& [place, momentum] : pairs_) {
        const int p = key_of(momentum, 0);
        twice = twice + input(graph(), p) * slope(H, p);
      }
      for (const int key : keys_of(std::span(&H, 1)))
        if (key == of_time) return;
      model_.conserved_ = {H, twice / Expression(2)};
    }
  }

  Model& model_;
  const File& file_;
  const ModelText& text_;
  const Source& source_;
  Abbreviations abbreviations_;
  const Letters& letters_;
  std::vector<std::optional<Formula>> forces_;
  // Abbreviations, each computed once: values with their rates, and units.
  std::map<std::size_t, std::vector<Values>> values_of_given_;
  std::map<std::size_t, std::optional<Measures>> measures_of_given_;
  std::set<std::pair<std::size_t, std::size_t>> seen_;  ///< with the order of the rate
  std::size_t moving_ = 0;                              ///< unknowns in front of those that count events
  std::vector<std::size_t> orders_;
  std::vector<std::optional<Measure>> units_;
  std::vector<Equation> equations_, constraints_;
  std::vector<Formula> conditions_;
  std::optional<Formula> lagrangian_, hamiltonian_, dissipation_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;  ///< places, and their momenta
  std::map<int, Expression> rates_of_places_;               ///< by a Hamiltonian
  std::map<int, Formula> starts_;
};

Model::Model(const File& file, const ModelText& text) : name_(text.name.text) {
  for (const ParameterText& p : file.parameters) sizes_.push_back(p.size);
  Making making(*this, file, text);
  if (text.closed.empty())
    making.motion();
  else
    making.closed();
}

namespace {

void require_on_constraints(const Numbers& numbers) {
  std::vector<long double> off(numbers.off.outputs().size());
  if (off.empty()) return;
  numbers.off.run(numbers.start.data(), 0.0L, off.data());
  long double size = 0;
  for (const long double x : numbers.start) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < off.size(); ++i)
    if (!(std::abs(off[i]) <= 1e-9L * size))
      throw BadInput(std::string("the start ") + (2 * i < off.size() ? "is off" : "moves off") +
                     " constraint " + std::to_string(i % (off.size() / 2) + 1) + " by " +
                     format_significant(static_cast<double>(std::abs(off[i])), 2) +
                     (2 * i < off.size() ? "" : " a second"));
}

/// `changes`: the last changes of Newton's method.
void require_conditions(const Numbers& numbers, const std::vector<Expression>& changes) {
  long double size = 1;
  for (const long double x : numbers.start) size = std::max(size, std::abs(x));
  for (const Expression& one : changes)
    if (!(std::abs(one.number()) <= 1e-12L * size))
      throw BadInput("at the start the conditions are not met near the given values of their unknowns");
}

void require_unit_quaternions(const std::vector<Expression>& lengths) {
  for (const Expression& one : lengths)
    if (!(std::abs(one.number() - 1) <= 1e-9L))
      throw BadInput("at the start a quaternion that turns has the length 1, and this one " +
                     format_significant(static_cast<double>(one.number()), 6));
}

/// Unknowns at rest that fill a state up to the next size that the algorithms are compiled for.
class Padding {
 public:
  explicit Padding(const std::vector<int>& rate_of) : count_(rate_of.size()) {
    if (count_ > 0) more_ = *std::ranges::lower_bound(compiled, count_) - count_;
    // As many behind the places as behind the rates, if each place has a rate.
    bool has_rates = count_ % 2 == 0 && more_ % 2 == 0;
    for (std::size_t i = 0; 2 * i < count_ && has_rates; ++i)
      has_rates = rate_of[i] == static_cast<int>(count_ / 2 + i);
    if (has_rates) places_ = count_ / 2;
  }

  /// Keys of the unknowns at rest.
  std::vector<int> keys() const {
    std::vector<int> all(more_);
    std::iota(all.begin(), all.end(), of_rest);
    return all;
  }
  std::vector<int> rate_of(std::vector<int> all) const {
    std::vector<int> rest(more_, -1);
    if (places_ > 0) {
      const std::size_t more = more_ / 2;
      for (std::size_t i = 0; i < places_; ++i) all[i] += static_cast<int>(more);
      for (std::size_t i = 0; i < more; ++i) rest[i] = static_cast<int>(2 * places_ + more + i);
    }
    return with(std::move(all), rest);
  }
  /// Rates of the unknowns at rest, which are `unknowns`.
  std::vector<Expression> rates(const std::vector<Expression>& unknowns) const {
    std::vector<Expression> rest(more_, 0);
    if (places_ > 0) std::copy(unknowns.begin() + half(), unknowns.end(), rest.begin());
    return rest;
  }

  /// Pads the data of a state, or of several in a row, with data for the unknowns at rest.
  template <class T>
  std::vector<T> with(const std::vector<T>& all, const std::vector<T>& rest) const {
    std::vector<T> padded;
    const auto middle = rest.begin() + (places_ > 0 ? half() : 0);
    for (std::size_t i = 0; i < all.size(); i += count_) {
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i),
                 places_end = begin + static_cast<std::ptrdiff_t>(places_);
      padded.insert(padded.end(), begin, places_end);
      padded.insert(padded.end(), rest.begin(), middle);
      padded.insert(padded.end(), places_end, begin + static_cast<std::ptrdiff_t>(count_));
      padded.insert(padded.end(), middle, rest.end());
    }
    return padded;
  }

 private:
  std::ptrdiff_t half() const { return static_cast<std::ptrdiff_t>(more_ / 2); }

  std::size_t count_, more_ = 0, places_ = 0;
};

}  // namespace

Numbers Model::with(const std::vector<double>& parameters) const {
  const Padding padding(rate_of_);
  const std::vector<int> state = padding.with(state_, padding.keys());
  Graph graph;
  std::map<int, Expression> inputs{{of_time, input(graph, of_time)}};
  for (const int key : state) inputs.emplace(key, input(graph, key));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    inputs.emplace(of_parameters + static_cast<int>(i), parameters[i]);
  const auto made = [&](const std::vector<Expression>& all) { return replaced(all, inputs); };
  std::vector<Expression> rest;
  for (const int key : padding.keys()) rest.push_back(inputs.at(key));
  std::vector<int> of_state(state);
  of_state.push_back(of_time);

  Numbers numbers;
  numbers.unknowns = state.size();
  numbers.rate_of = padding.rate_of(rate_of_);
  for (const Expression& one : padding.with(made(start_), std::vector<Expression>(rest.size(), 0)))
    numbers.start.push_back(one.number());
  numbers.observed = Program(made(observed_), of_state);
  numbers.conserved = Program(made(conserved_), of_state);
  numbers.looked_up = Program(made(looked_up_), of_state);
  if (state.empty()) return numbers;
  const std::vector<Expression> rates = padding.with(made(rates_), padding.rates(rest)),
                                guards = made(guards_);
  numbers.rates = Program(rates, of_state);
  numbers.events = events_;
  numbers.guards = Program(guards, of_state);
  numbers.afterwards = Program(padding.with(made(afterwards_), rest), of_state);
  numbers.off = Program(made(off_), of_state);
  require_on_constraints(numbers);
  require_conditions(numbers, made(still_changing_));
  require_unit_quaternions(made(lengths_));
  std::vector<Expression> both = rates;
  both.insert(both.end(), guards.begin(), guards.end());
  numbers.rates_and_guards = Program(both, of_state);
  const std::size_t half = state.size() / 2;
  numbers.partitioned = state.size() % 2 == 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (i < half && numbers.rate_of[i] != static_cast<int>(half + i)) numbers.partitioned = false;
  for (std::size_t i = half; i < state.size() && numbers.partitioned; ++i)
    for (std::size_t k = half; k <= state.size(); ++k)
      if (numbers.rates.depends(i, k)) numbers.partitioned = false;
  if (numbers.partitioned) {
    std::vector<int> of_places(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(half));
    of_places.push_back(of_time);
    numbers.accelerations = Program(std::span(rates).subspan(half), of_places);
  }
  return numbers;
}

namespace {

/// Unique names of C++ variables.
class Names {
 public:
  /// This name, followed by as many underscores as make it free.
  const std::string& add(std::string name) {
    while (is_taken_in_cpp(name) || std::ranges::find(all_, name) != all_.end()) name += '_';
    return all_.emplace_back(std::move(name));
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

}  // namespace

/// Writes a model's member functions, and notes the parameters that they need.
class Model::Coding {
 public:
  Coding(const Model& model, const File& file) : model_(model), parameters_(file.parameters.size()) {
    for (const ParameterText& p : file.parameters) {
      if (is_taken_in_cpp(p.name)) throw BadInput("C++ has another meaning for the letter " + p.name);
      names_.add(p.name);
    }
    for (const int key : model.state_) {
      const auto [i, order] = unknown_of(key);
      const std::string& unknown = model.unknowns_[i];
      names_.add(order == 0 ? unknown : unknown + "_" + std::string(order, 'd') + "ot");
    }
    names_.add("t");
    for (std::size_t i = 0; i < parameters_; ++i) keys_.push_back(of_parameters + static_cast<int>(i));
    keys_.insert(keys_.end(), model.state_.begin(), model.state_.end());
    keys_.push_back(of_time);
    used_.assign(names_.all().size(), 0);
    Names with_arguments = names_;
    state_ = with_arguments.add("state");
    result_ = with_arguments.add("result");
  }

  Code code(bool partitioned) {
    const std::size_t n = model_.state_.size();
    const std::string seen = array(model_.observed_.size());
    std::string functions;
    if (n == 0) {
      functions = function(seen + " at($t)", model_.observed_, "return");
    } else {
      functions = "  using State = " + array(n) + ";\n" + function("State start()", model_.start_, "return") +
                  function("void operator()(const State& $x, State& $r, $t)", model_.rates_, result_ + " =");
      if (partitioned)
        functions += "  using Half = " + array(n / 2) + ";\n" +
                     function("void acceleration(const Half& $x, Half& $r)", accelerations(), result_ + " =");
      functions += function(seen + " observe(const State& $x, $t)", model_.observed_, "return");
    }
    Code code{type_name(model_.name_), {}, {}};
    std::string members;
    for (std::size_t i = 0; i < parameters_; ++i) {
      if (!used_[i]) continue;
      members += (members.empty() ? "  double " : ", ") + names_.all()[i];
      code.members.push_back(names_.all()[i]);
    }
    if (!members.empty()) members += ";\n";
    code.text = "struct " + code.type + " {\n" + members + functions + "};\n";
    return code;
  }

 private:
  static std::string array(std::size_t n) { return "std::array<double, " + std::to_string(n) + ">"; }
  static void put(std::string& text, const std::string& placeholder, const std::string& what) {
    if (const auto at = text.find(placeholder); at != std::string::npos)
      text.replace(at, placeholder.size(), what);
  }
  /// `all` with its constants computed.
  std::vector<Expression> folded(std::span<const Expression> all) const {
    std::map<int, Expression> same;
    for (const int key : keys_) same.emplace(key, input(*model_.graph_, key));
    return replaced(all, same);
  }
  /// Accelerations in terms of places only.
  std::vector<Expression> accelerations() const {
    const std::size_t half = model_.state_.size() / 2;
    std::map<int, Expression> at_rest;
    for (const int key : keys_) at_rest.emplace(key, input(*model_.graph_, key));
    for (std::size_t i = half; i < 2 * half; ++i) at_rest[model_.state_[i]] = 0;
    return replaced(std::span(model_.rates_).subspan(half), at_rest);
  }
  /// `head` has the placeholders $x, $r and $t of its arguments.
  std::string function(std::string head, std::span<const Expression> what, const std::string& returns) {
    const Written body = written(Program(folded(what), keys_), names_.all(), "    ");
    for (std::size_t i = 0; i < used_.size(); ++i) used_[i] |= body.used[i];
    std::string lines;
    for (std::size_t i = 0; i < model_.state_.size(); ++i)
      if (body.used[parameters_ + i])
        lines += "    const double " + names_.all()[parameters_ + i] + " = " + state_ + "[" +
                 std::to_string(i) + "];\n";
    put(head, " $x", lines.empty() ? "" : " " + state_);
    put(head, "$r", result_);
    put(head, "$t", body.used.back() ? "double " + names_.all().back() : "double");
    std::string values;
    for (const std::string& one : body.outputs) values += (values.empty() ? "" : ", ") + one;
    return "  " + head + " const {\n" + lines + body.lines + "    " + returns + " {" + values + "};\n  }\n";
  }

  const Model& model_;
  std::size_t parameters_;
  Names names_;
  std::vector<int> keys_;
  std::vector<char> used_;
  std::string state_, result_;
};

Model::Code Model::code(const File& file, bool partitioned) const {
  return Coding(*this, file).code(partitioned);
}

void require_start(const File& file, const ModelText& text, const Model& model) {
  if (text.constraints.empty() && text.conditions.empty() && text.turns.empty()) return;
  std::vector<double> values;
  for (const ParameterText& p : file.parameters) values.push_back(p.value);
  try {
    model.with(values);
  } catch (const BadInput& error) {
    const Place place = !text.turns.empty()         ? text.turns.front().of.place
                        : !text.constraints.empty() ? text.constraints.front().place
                                                    : text.conditions.front().place;
    file.source.fail(place, error.what());
  }
}

}  // namespace oddity::problem
