#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// True values, from the tables or computed on the spot.
///
///   const Reference truth("reference");
///   const Known quarter = truth("03_05_quarter_period", {1.5});
///   std::cout << quarter.value[0] << " +- " << quarter.error << ", " << quarter.source;
namespace oddity {

/// A true value: components in the order of its table, each within `error` of the exact number.
struct Known {
  std::vector<double> value;
  double error = 0;
  std::string source;  ///< which table, or by which route it was computed on the spot
  /// Of a motion, at each of its times: a bound up to there. Empty: `error` is all that is known.
  std::vector<double> error_until = {};
};

/// How far the exact values may be from those asked about, proved; or infinity, and why it is not.
struct Enclosed {
  double distance = std::numeric_limits<double>::infinity();
  std::string by;  ///< "enclosed by ...", "not enclosed: ..."
};

/// Values of a table of which a proof is asked: at the inputs, or, if there are times, which are the last
/// input, at all of these one after the other.
struct ToEnclose {
  std::string_view table;
  const std::vector<double>& inputs;
  std::span<const double> times;
  std::span<const double> values;
  int digits;  ///< to which the distance matters
};
using Enclosing = std::function<Enclosed(const ToEnclose&, const std::function<void(double done)>& tick)>;

/// What is true. Values come from the CSV tables; where a table has no row for the inputs asked for, they are
/// computed on the spot by the table's own generator, in high precision and by two routes. A copy shares the
/// tables.
class Reference {
 public:
  /// Reads every table in `folder`/tables. Motions made on the spot are kept in `cache`, if it is named and
  /// can be written. Throws BadInput naming file and line when a table is missing or broken.
  explicit Reference(const std::filesystem::path& folder, std::filesystem::path cache = {});

  /// The folder that it was read from; empty where it knows nothing.
  const std::filesystem::path& folder() const { return folder_; }

  /// Knows nothing: every value is NaN, so that nothing judged by it is ok. For motions that are only looked
  /// at.
  static Reference nothing() { return {}; }

  /// The same, which calls `tick` between pieces of its work, with the part of a motion that is done; what
  /// that throws ends it.
  Reference watched(std::function<void(double done)> tick) const;

  /// The same, with so many digits in what is computed on the spot.
  Reference to_digits(int digits) const;
  /// The same in long double, the error of motions bounded by repeats (reference/in_long_double.hpp).
  Reference repeated() const;

  /// The same, in which the error of what is computed on the spot is its proved distance from the exact
  /// values, where there is an enclosure; each source says by what.
  Reference enclosed_by(Enclosing) const;

  /// The value of `table` at `inputs` (in the order of the table's columns).
  /// One NaN, its source saying what to write, when there is no such table. Throws BadInput when the inputs
  /// are not as many as the table's or not finite, and when they are not tabulated and have no value that
  /// could be computed.
  Known operator()(std::string_view table, const std::vector<double>& inputs) const;

  /// The values of `table` at ascending times, which are its last input, one after the other: from its rows
  /// where it has all of them, or else by one integration. Throws as above.
  Known motion(std::string_view table, const std::vector<double>& inputs_but_time,
               std::span<const double> times) const;

 private:
  Reference();

  using Table = std::map<std::vector<double>, Known>;
  using Tables = std::map<std::string, Table, std::less<>>;

  const Table* table(std::string_view name) const;
  Known made_motion(std::string_view name, const std::vector<double>& inputs_but_time,
                    std::span<const double> times) const;
  Known proved(Known, const ToEnclose&) const;

  std::shared_ptr<const Tables> tables_ = std::make_shared<Tables>();
  std::filesystem::path folder_, cache_;
  std::function<void(double)> tick_;
  Enclosing enclosing_;
  int digits_;
  bool repeats_ = false;
};

}  // namespace oddity
