#include "report/charts/chart_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace oddity {

Cost cost_of(Across across) { return across == Across::time ? Cost::time : Cost::evaluations; }

std::string main_resolution(const QuantityResult& q) {
  std::map<std::string, int> methods;
  for (const MethodResult& m : q.methods) ++methods[m.trials.front().resolution];
  std::string most;
  for (const auto& [resolution, count] : methods)
    if (!resolution.empty() &&
        (most.empty() || most == "tolerance" || (resolution != "tolerance" && count > methods[most])))
      most = resolution;
  return most;
}

Frame::Frame(const QuantityResult& q, Across a)
    : across(a), resolution(main_resolution(q)), floor(error_floor(q)) {
  const double top = std::max(1e3 * size_of(q.reference.value), 10 * q.need.allowed);
  errors.see(q.need.allowed > 0 ? q.need.allowed : floor);
  for (const MethodResult& m : q.methods) {
    if (!shows(m)) continue;
    for (const TimedTrial& t : m.trials) {
      if (abscissa(t) > 0 && std::isfinite(abscissa(t))) abscissas.see(abscissa(t));
      floored |= t.error < floor;
      if (t.error <= top)
        errors.see(std::max(t.error, floor));
      else
        strip = true;
    }
  }
  if (abscissas.empty()) abscissas.see(1);
  linear = across == Across::setting && abscissas.low >= 1 && abscissas.high < 100;
  if (across == Across::setting)
    abscissas = linear ? Range{abscissas.low - 1, abscissas.high + 1}
                       : Range{abscissas.low / 1.5, abscissas.high * 1.5};
  else
    abscissas = abscissas.decades();
  errors = errors.decades();
}

void add_labels(Svg& svg, const std::vector<Label>& labels, double top, double bottom) {
  std::vector<double> wanted;
  for (const Label& label : labels) wanted.push_back(label.end.y);
  const std::vector<double> heights = spread(wanted, label_height, top + 6, bottom - 4);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Label& label = labels[i];
    svg.line({label.end.x + 5, label.end.y}, {label_left - 4, heights[i]}, "lead");
    if (label.slot >= 0) svg.marks({{label_left + 3, heights[i]}}, label.slot, "mark");
    svg.text({label_left + 12, heights[i] + 4}, shortened(label.text, longest_label),
             label.slot < 0 ? "t b" : "t");
  }
}

std::string named(const TimedTrial& t) { return t.algorithm + " (" + t.model + ")"; }

std::string with_commas(long n) {
  std::string text = std::to_string(n);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), ",");
  return text;
}

}  // namespace oddity
