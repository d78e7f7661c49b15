#include "report/pages/true_values.hpp"

#include "reference/text.hpp"

namespace oddity {

std::string true_values(const Bounds& all) {
  if (all.values == 0) return "";
  std::string text =
      "## The true values\n\nOf the " + std::to_string(all.values) + " values in the reference tables " +
      std::to_string(all.enclosed) +
      " are enclosed: computed with numbers that carry a proved bound of their error, the widest " +
      format_significant(all.widest, 1) + " of the largest component beside it.";
  if (!all.agreed.empty()) {
    text += " The other " + std::to_string(all.values - all.enclosed) + " rest on two routes that agree:";
    for (const std::string& table : all.agreed)
      text += (table == *all.agreed.begin() ? " `" : ", `") + table + "`";
    text += ".";
  }
  return text + "\n";
}

}  // namespace oddity
