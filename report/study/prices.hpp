#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "report/study/choose.hpp"

namespace oddity {

/// This processor and this program: what was timed with others is timed anew.
std::string machine_and_program();
/// The same with all that a method's cost over the horizon depends on.
std::string price_key(const Task&, const Need&);

/// What the methods of one question cost, kept from run to run: measured again, near ties would be broken by
/// the clock's noise, and the same question would not get the same answer.
class KeptPrices {
 public:
  /// Of the question `key`, in `folder`. Those of earlier runs are not looked at when `anew`.
  KeptPrices(const std::filesystem::path& folder, std::string key, bool anew, Price measure = measured_price);

  /// As it was kept, or else measured and remembered. Not for several threads.
  Time operator()(const Method&, double setting);
  /// For the next run; does without where the folder cannot be written.
  void keep();
  /// Where the prices given out come from, in one sentence without its end.
  std::string source() const;
  const std::filesystem::path& file() const { return file_; }

 private:
  using Which = std::tuple<std::string, std::string, double>;  ///< model, algorithm, setting
  std::map<Which, Time> in_file() const;

  std::filesystem::path file_;
  std::string key_;
  bool anew_;
  Price measure_;
  std::map<Which, Time> prices_;
  std::set<Which> measured_;  ///< in this run
  bool cannot_keep_ = false;  ///< as was found when it was tried
  bool found_ = false;        ///< one that an earlier run had kept was given out
};

}  // namespace oddity
