#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "report/study/results.hpp"

/// Colours and marks of models, algorithms and outcomes in charts and maps.
namespace oddity {

/// Families of algorithms that integrate a motion; a chart shows the best of each.
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
/// Name of the family, "step control"; empty for none.
std::string_view name_of(Family);

/// A colour for each model and a mark for each algorithm, the same in all charts of the site. Common
/// algorithms have fixed marks; any other gets the first mark that no neighbouring curve has.
class Styles {
 public:
  explicit Styles(const Results&);

  /// Index of the colour, below eleven.
  std::size_t colour_place(const std::string& model) const { return colours_.at(model); }
  /// Index of the mark, below twelve, plus twelve times the index of the dashes.
  std::size_t mark_place(const std::string& algorithm) const { return marks_.at(algorithm); }

 private:
  std::map<std::string, std::size_t> colours_, marks_;
};

/// Colour of the outcome's cells in a map, "#009E73". Colour-blind readers can distinguish any two.
std::string_view colour_of(Outcome);
/// Black or white, whichever is legible on the outcome's colour.
std::string_view colour_on(Outcome);

}  // namespace oddity
