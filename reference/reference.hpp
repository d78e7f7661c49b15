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

/// True values, from the tables or computed on demand.
///
///   const Reference truth("reference");
///   const Known quarter = truth("03_05_quarter_period", {1.5});
///   std::cout << quarter.value[0] << " +- " << quarter.error << ", " << quarter.source;
namespace oddity {

/// A true value: components in the order of its table, each within `error` of the exact number.
struct Known {
  std::vector<double> value;
  double error = 0;
  std::string source;  ///< the table, or the route by which it was computed on demand
  /// For a motion, error bounds up to each of its times. Empty: only `error` is known.
  std::vector<double> error_until = {};
};

/// Proved bound on the distance of the exact values from the given ones; or infinity, and the reason.
struct Enclosed {
  double distance = std::numeric_limits<double>::infinity();
  std::string by;  ///< "enclosed by ...", "not enclosed: ..."
};

/// Values of a table that are to be enclosed: at the inputs, or, if there are times (the last input), at all
/// of these in turn.
struct ToEnclose {
  std::string_view table;
  const std::vector<double>& inputs;
  std::span<const double> times;
  std::span<const double> values;
  int digits;  ///< digits to which the distance matters
};
using Enclosing = std::function<Enclosed(const ToEnclose&, const std::function<void(double done)>& tick)>;

/// Reference values, from the CSV tables. If a table has no row for the inputs, its own generator computes
/// them on demand, in high precision and by two routes. A copy shares the tables.
class Reference {
 public:
  /// Reads every table in `folder`/tables. Motions computed on demand are kept in `cache`, if it is given and
  /// writable. Throws BadInput with file and line if a table is missing or broken.
  explicit Reference(const std::filesystem::path& folder, std::filesystem::path cache = {});

  /// The folder that was read; empty for nothing().
  const std::filesystem::path& folder() const { return folder_; }

  /// Has no values: every value is NaN, so that no result judged by it is ok. For motions that are only
  /// displayed.
  static Reference nothing() { return {}; }

  /// A copy that calls `tick` between pieces of its work, with the finished part of a motion; an exception of
  /// `tick` ends the work.
  Reference watched(std::function<void(double done)> tick) const;

  /// A copy that computes values on demand with this many digits.
  Reference to_digits(int digits) const;
  /// A copy that computes in long double, with the error of motions bounded by repeats
  /// (reference/in_long_double.hpp).
  Reference repeated() const;
  /// A copy that computes no motions on demand: those without rows in their table are NaN.
  Reference without_new_motions() const;

  /// A copy in which the error of values computed on demand is their proved distance from the exact values,
  /// if there is an enclosure; each source names it.
  Reference enclosed_by(Enclosing) const;

  /// The value of `table` at `inputs` (in the order of the table's columns). If there is no such table, a
  /// single NaN, with the file to write as its source. Throws BadInput if the number of inputs is wrong or
  /// they are not finite, and if they are not tabulated and their value cannot be computed.
  Known operator()(std::string_view table, const std::vector<double>& inputs) const;

  /// The values of `table` at ascending times (the last input) in turn: from its rows if it has all of them,
  /// or else by one integration. Throws as above.
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
  bool repeats_ = false, makes_motions_ = true;
};

}  // namespace oddity
