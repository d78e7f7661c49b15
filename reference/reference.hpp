#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace oddity {

/// A true value: components in the order of its table, each within `error` of the exact number.
struct Known {
  std::vector<double> value;
  double error = 0;
  std::string source;  ///< which table, or by which route it was computed on the spot
};

/// What is true. Values come from the CSV tables; where a table has no row for the inputs asked for, they are
/// computed on the spot by the table's own generator, in high precision and by two routes.
class Reference {
 public:
  /// Reads every table in `folder`. Throws BadInput naming file and line when one is missing or broken.
  explicit Reference(const std::filesystem::path& folder);

  /// Knows nothing: every value is NaN, so that nothing judged by it is ok. For motions that are only looked at.
  static Reference nothing() { return {}; }

  /// The value of `table` at `inputs` (in the order of the table's columns).
  /// One NaN, its source saying what to write, when there is no such table. Throws BadInput when the inputs are not as many as the table's or not
  /// finite, and when they are not tabulated and have no value that could be computed.
  Known operator()(std::string_view table, const std::vector<double>& inputs) const;

 private:
  Reference() = default;

  using Table = std::map<std::vector<double>, Known>;

  std::map<std::string, Table, std::less<>> tables_;
};

}  // namespace oddity
