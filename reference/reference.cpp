#include "reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/book.hpp"
#include "reference/csv.hpp"
#include "reference/files.hpp"
#include "reference/in_long_double.hpp"
#include "reference/table.hpp"
#include "reference/text.hpp"
#include "reference/to_write.hpp"
#include "reference/truth.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The columns of a table: the inputs, then the fixed ones.
std::vector<std::string> columns_of(const truth::Truth& truth) {
  std::vector<std::string> columns = truth.inputs;
  for (const char* column : {"component", "value", "error", "bound", "unit"}) columns.emplace_back(column);
  return columns;
}

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ",") + word;
  return list;
}

std::string listed(const std::vector<double>& numbers) {
  std::vector<std::string> words(numbers.size());
  std::ranges::transform(numbers, words.begin(), format_shortest);
  return listed(words);
}

}  // namespace

std::map<std::vector<double>, Known> read_table(const fs::path& file, const truth::Truth& truth) {
  const CsvFile csv = read_csv(file);
  if (const auto columns = columns_of(truth); csv.header.cells != columns)
    throw BadInput(csv.header.place + ": the columns must be " + listed(columns));
  std::map<std::vector<double>, Known> rows;
  const std::size_t n = truth.inputs.size();
  for (const CsvRow& row : csv.rows) {
    std::vector<double> inputs;
    for (std::size_t i = 0; i < n; ++i) inputs.push_back(row.number(i));
    const double value = row.number(n + 1), error = row.number(n + 2);
    if (!std::ranges::all_of(inputs, [](double x) { return std::isfinite(x); }) || !std::isfinite(value) ||
        !std::isfinite(error) || !(error > 0))
      throw BadInput(row.place + ": inputs and value must be finite, error finite and positive");
    if (const std::string& bound = row.cells[n + 3]; bound != "enclosure" && bound != "agreement")
      throw BadInput(row.place + ": the error is bounded by an enclosure or by agreement, not by " + bound);
    Known& known = rows[inputs];
    if (known.value.size() == truth.components.size())
      throw BadInput(row.place + ": a second row for these inputs");
    if (const std::string& name = truth.components[known.value.size()].name; row.cells[n] != name)
      throw BadInput(row.place + ": component " + row.cells[n] + " where " + name + " must be");
    known.value.push_back(value);
    known.error = std::max({known.error, error, std::abs(value) * 0x1p-53});
    known.source = "table " + file.filename().string();
  }
  for (const auto& [inputs, known] : rows)
    if (known.value.size() < truth.components.size())
      throw BadInput(file.string() + ": no row for component " + truth.components[known.value.size()].name +
                     " at " + listed(inputs));
  return rows;
}

namespace {

const truth::Entry* generator_of(std::string_view table) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  return found == all.end() ? nullptr : &*found;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// No values, and the step to take as their source.
Known without_table(std::string_view name) {
  const std::string table(name);
  return {{no_number},
          no_number,
          "no generator of the table " + table + ": write reference/make/" + table +
              ".cpp in the folder that has the exercise's chapters"};
}

Known unknown(const truth::Truth& truth) {
  return {std::vector<double>(truth.components.size(), no_number), no_number, "nothing"};
}

std::string source_of(const truth::Truth& truth) {
  return "computed on the spot: " + truth.first_route + "; and " + truth.second_route;
}

/// Number of the exercise: "3.5" for 03_05_swing.
std::string exercise_of(std::string_view table) {
  const auto number = [&](std::size_t at) {
    return format_shortest(parse_number(table.substr(at, 2)).value_or(no_number));
  };
  return number(0) + "." + number(3);
}

/// Whether it belongs to a reader's own exercise, whose values are computed on demand if there is no table.
bool of_ones_own(std::string_view table) {
  const auto number = [&](std::size_t at) {
    return static_cast<int>(parse_number(table.substr(at, 2)).value());
  };
  return !is_published(number(0), number(3));
}

/// The inputs with their names: "a = 0.5, t = 1".
std::string named(const truth::Truth& truth, const std::vector<double>& inputs) {
  std::string all;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    all += (all.empty() ? "" : ", ") + truth.inputs[i] + " = " + format_shortest(inputs[i]);
  return all;
}

/// Value computed by `make`, which takes a tick, for the table at the inputs. Exceptions of the tick are not
/// turned into bad input.
template <class Make>
Known on_the_spot(std::string_view table, const truth::Truth& truth, const std::vector<double>& inputs,
                  const truth::Tick& tick, const Make& make) {
  truth::Made made;
  bool ticking = false;
  const auto watched = [&](double done) {
    ticking = true;
    if (tick) tick(done);
    ticking = false;
  };
  try {
    made = make(watched);
  } catch (const truth::StillToWrite& error) {
    return {{no_number}, no_number, error.what()};
  } catch (const truth::BudgetSpent& error) {
    throw BadInput("exercise " + exercise_of(table) + ": the truth of its table " + std::string(table) +
                   " takes too long to make at " + named(truth, inputs) + ": " + error.what() +
                   ". Ask for parameters that make the motion slower or less stiff, or for a shorter time");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    if (ticking) throw;
    throw BadInput("table " + std::string(table) + " has no value at " + listed(inputs) + ": " +
                   error.what());
  }
  Known known{{}, static_cast<double>(made.error), source_of(truth)};
  for (const truth::Number& x : made.value) {
    known.value.push_back(static_cast<double>(x));
    known.error = std::max(known.error, std::abs(known.value.back()) * 0x1p-53);
  }
  return known;
}

}  // namespace

namespace {

/// Place of a generator's table: in the folder, or next to the exercises outside the tree.
fs::path file_of(const truth::Entry& generator, const fs::path& folder) {
  const fs::path room = generator.home.empty() ? folder : fs::path(generator.home) / "reference";
  return room / "tables" / (std::string(generator.name) + ".csv");
}

/// Number of times at which a motion's second route is compared with the first.
constexpr std::size_t compared_times = 48;

/// Everything on which a motion computed on demand depends.
std::string motion_key(std::string_view table, const std::vector<double>& inputs,
                       std::span<const double> times, int digits) {
  return std::string(table) + " " + std::string(truth::fingerprint_of_generators) + " " + "MPFR " +
         mpfr_get_version() + " " + std::to_string(digits) + " " + std::to_string(compared_times) + " (" +
         listed(inputs) + ") at " + listed(std::vector<double>(times.begin(), times.end()));
}

fs::path kept_file(const fs::path& cache, const std::string& key) {
  return cache / (key.substr(0, key.find(' ')) + "_" + checksum(key) + ".txt");
}

/// The motion cached under the key: a line with the key, one with the error, one with each of `count` values.
/// Empty if the file is not one that this program writes. Its seal has no key: anybody who can write to the
/// cache can seal anything. So cached values are checked in other ways where possible.
std::optional<Known> kept_motion(const fs::path& cache, const std::string& key, std::size_t count) {
  const auto text = read_sealed(kept_file(cache, key));
  if (!text || !text->starts_with(key + "\n")) return {};
  std::istringstream lines(text->substr(key.size() + 1));
  std::vector<double> numbers;
  for (std::string line; std::getline(lines, line);)
    if (const auto x = parse_number(line); x && std::isfinite(*x) && numbers.size() <= count)
      numbers.push_back(*x);
    else
      return {};
  if (numbers.size() != count + 1 || !(numbers.front() > 0)) return {};
  return Known{{numbers.begin() + 1, numbers.end()}, numbers.front(), ""};
}

/// Whether both may be the same motion: they never differ by more than the sum of their errors, and the one
/// of more digits has no larger error.
bool may_be(const Known& kept, const Known& of_fewer_digits) {
  const std::size_t parts = kept.value.size() / of_fewer_digits.error_until.size();
  for (std::size_t i = 0; i < kept.value.size(); ++i)
    if (!(std::abs(kept.value[i] - of_fewer_digits.value[i]) <=
          kept.error + of_fewer_digits.error_until[i / parts]))
      return false;
  return kept.error <= of_fewer_digits.error;
}

void keep_motion(const fs::path& cache, const std::string& key, const Known& known) {
  std::string text = key + "\n" + format_shortest(known.error) + "\n";
  for (double x : known.value) text += format_shortest(x) + "\n";
  keep_sealed(kept_file(cache, key), text);
}

/// The table's rows for all these times; empty if one is missing.
template <class Table>
std::optional<Known> tabulated(const Table& rows, std::vector<double> inputs, std::span<const double> times) {
  Known all;
  inputs.push_back(0);
  for (double t : times) {
    inputs.back() = t;
    const auto row = rows.find(inputs);
    if (row == rows.end()) return {};
    all.value.insert(all.value.end(), row->second.value.begin(), row->second.value.end());
    all.error = std::max(all.error, row->second.error);
    all.source = row->second.source;
  }
  return all;
}

void require_finite(std::string_view table, std::span<const double> inputs) {
  if (!std::ranges::all_of(inputs, [](double x) { return std::isfinite(x); }))
    throw BadInput("table " + std::string(table) + " is asked at " +
                   listed(std::vector<double>(inputs.begin(), inputs.end())) + ": inputs must be finite");
}

void require_count(std::string_view table, const truth::Truth& truth, std::size_t inputs) {
  if (inputs != truth.inputs.size())
    throw BadInput("table " + std::string(table) + " takes " + std::to_string(truth.inputs.size()) +
                   " inputs (" + listed(truth.inputs) + "), not " + std::to_string(inputs));
}

}  // namespace

Reference::Reference() : digits_(truth::spot_digits) {}

Reference::Reference(const fs::path& folder, fs::path cache)
    : folder_(folder), cache_(std::move(cache)), digits_(truth::spot_digits) {
  Tables tables;
  for (const truth::Entry& entry : truth::registry()) {
    const std::string name(entry.name);
    const fs::path file = file_of(entry, folder), room = file.parent_path().parent_path();
    if (!fs::exists(file) && of_ones_own(name)) {
      tables[name];
      continue;
    }
    if (!fs::is_directory(room / "tables"))
      throw BadInput("cannot read " + room.string() + ": a folder with tables/ and approved/ is needed");
    if (!fs::exists(file))
      throw BadInput("cannot read " + file.string() + ": it is not there; build/release/make_reference " +
                     folder.string() + " " + name + " makes it");
    tables.emplace(name, read_table(file, entry.make()));
  }
  tables_ = std::make_shared<Tables>(std::move(tables));
}

Reference Reference::watched(std::function<void(double)> tick) const {
  Reference copy = *this;
  copy.tick_ = std::move(tick);
  return copy;
}

Reference Reference::to_digits(int digits) const {
  Reference copy = *this;
  copy.digits_ = digits;
  return copy;
}

Reference Reference::repeated() const {
  Reference copy = to_digits(digits_in_long_double);
  copy.repeats_ = true;
  return copy;
}

Reference Reference::without_new_motions() const {
  Reference copy = *this;
  copy.makes_motions_ = false;
  return copy;
}

Reference Reference::enclosed_by(Enclosing enclosing) const {
  Reference copy = *this;
  copy.enclosing_ = std::move(enclosing);
  return copy;
}

Known Reference::proved(Known known, const ToEnclose& asked) const {
  if (!enclosing_ || !std::isfinite(known.error)) return known;
  const Enclosed enclosed = enclosing_(asked, tick_);
  if (std::isfinite(enclosed.distance)) {
    known.error = enclosed.distance;
    known.error_until.clear();
  }
  known.source += "; " + enclosed.by;
  return known;
}

std::string checksum_of_tables(const fs::path& folder,
                               const std::function<bool(const truth::Entry&)>& wanted) {
  std::string all;
  for (const truth::Entry& generator : truth::registry()) {
    if (wanted && !wanted(generator)) continue;
    const fs::path file = file_of(generator, folder);
    all += std::string(generator.name) + "\n" + (fs::exists(file) ? read_whole(file) : "");
  }
  return checksum(all);
}

const Reference::Table* Reference::table(std::string_view name) const {
  const auto table = tables_->find(name);
  return table == tables_->end() || !generator_of(name) ? nullptr : &table->second;
}

Known Reference::operator()(std::string_view name, const std::vector<double>& inputs) const {
  const truth::Entry* generator = generator_of(name);
  if (generator && tables_->empty()) return unknown(generator->make());
  const Table* rows = table(name);
  if (!rows) return without_table(name);
  require_finite(name, inputs);
  if (const auto row = rows->find(inputs); row != rows->end()) return row->second;
  const truth::Truth truth = generator->make();
  require_count(name, truth, inputs.size());
  const Known known = on_the_spot(name, truth, inputs, tick_, [&](const truth::Tick&) {
    return truth::make_row(truth, inputs, digits_);
  });
  return proved(known, {name, inputs, {}, known.value, digits_});
}

Known Reference::motion(std::string_view name, const std::vector<double>& inputs,
                        std::span<const double> times) const {
  const truth::Entry* generator = generator_of(name);
  const auto no_motion = [&] {
    const Known one = unknown(generator->make());
    return Known{std::vector<double>(times.size() * one.value.size(), one.error), one.error, one.source};
  };
  if (generator && tables_->empty()) return no_motion();
  const Table* rows = table(name);
  if (!rows) return without_table(name);
  require_finite(name, inputs);
  require_finite(name, times);
  if (auto known = tabulated(*rows, inputs, times)) return *known;
  if (!makes_motions_) return no_motion();
  require_count(name, generator->make(), inputs.size() + 1);
  const Known known = made_motion(name, inputs, times);
  return proved(known, {name, inputs, times, known.value, digits_});
}

Known Reference::made_motion(std::string_view name, const std::vector<double>& inputs,
                             std::span<const double> times) const {
  const truth::Truth truth = generator_of(name)->make();
  if (digits_ <= digits_in_double)
    if (auto known = motion_in_double(name, inputs, times, compared_times, tick_)) return *known;
  if (digits_ <= digits_in_long_double)
    if (auto known = motion_in_long_double(name, inputs, times, compared_times, tick_,
                                           repeats_ ? BoundedBy::repeats : BoundedBy::routes))
      return *known;
  const std::string key = cache_.empty() ? "" : motion_key(name, inputs, times, digits_);
  if (!cache_.empty())
    if (auto kept = kept_motion(cache_, key, times.size() * truth.components.size())) {
      const auto look = motion_in_long_double(name, inputs, times, compared_times, {});
      if (!look || may_be(*kept, *look)) {
        kept->source = source_of(truth);
        return *kept;
      }
    }
  Known known = on_the_spot(name, truth, inputs, tick_, [&](const truth::Tick& tick) {
    return truth::make_motion(truth, inputs, {times.begin(), times.end()}, digits_, compared_times,
                              tick_ ? tick : truth::Tick());
  });
  if (!cache_.empty() && std::isfinite(known.error)) keep_motion(cache_, key, known);
  return known;
}

}  // namespace oddity
