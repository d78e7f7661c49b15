#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "report/study/choose.hpp"

namespace oddity {

/// This processor and this program; times of others are measured again.
std::string machine_and_program();
/// `machine_and_program()` with everything else that a method's cost over the horizon depends on.
std::string price_key(const Task&, const Need&);

/// Prices of one question's methods, kept from run to run. Measured again, the clock's noise would break near
/// ties, and the same question would get another answer.
class KeptPrices {
 public:
  /// Prices of the question `key`, in `folder`. Ignores those of earlier runs when `fresh`.
  KeptPrices(const std::filesystem::path& folder, std::string key, bool fresh,
             Price measure = measured_price);

  /// The kept price; otherwise measures and remembers it. Not thread-safe.
  Time operator()(const Method&, double setting);
  /// Saves the prices for the next run, if the folder can be written.
  void keep();
  /// Source of the prices used, as one sentence without its full stop.
  std::string source() const;
  const std::filesystem::path& file() const { return file_; }

 private:
  using Which = std::tuple<std::string, std::string, double>;  ///< model, algorithm, setting
  std::map<Which, Time> in_file() const;

  std::filesystem::path file_;
  std::string key_;
  bool fresh_;
  Price measure_;
  std::map<Which, Time> prices_;
  std::set<Which> measured_;  ///< in this run
  bool cannot_keep_ = false;  ///< found when tried
  bool found_ = false;        ///< a price kept by an earlier run was used
};

}  // namespace oddity
