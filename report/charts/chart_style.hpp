#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "report/study/results.hpp"

/// How models, algorithms and outcomes look in charts and maps.
namespace oddity {

/// Of algorithms that integrate a motion; a chart shows the best of each.
enum class Family {
  none,
  closed_form,
  explicit_steps,
  partitioned,
  step_control,
  extrapolation,
  multistep,
  implicit,
  series
};
Family family_of(std::string_view algorithm);
/// "step control"; empty for none.
std::string_view name_of(Family);

/// A colour for each model and a mark for each algorithm, the same in all charts of the site. Common
/// algorithms have marks of their own; every other name gets the first that no curve beside it has.
class Styles {
 public:
  explicit Styles(const Results&);

  /// The place of the colour among eleven.
  std::size_t colour_place(const std::string& model) const { return colours_.at(model); }
  /// The place of the mark among twelve, the dashes by twelves.
  std::size_t mark_place(const std::string& algorithm) const { return marks_.at(algorithm); }

 private:
  std::map<std::string, std::size_t> colours_, marks_;
};

/// The cells of a map: "#009E73". Colour-blind readers can tell any two apart.
std::string_view colour_of(Outcome);
/// Black or white, whichever is legible on the outcome's colour.
std::string_view colour_on(Outcome);

}  // namespace oddity
