#include "report/site/play_link.hpp"

#include <algorithm>
#include <map>

#include "reference/text.hpp"
#include "report/study/findings.hpp"

namespace oddity {

namespace {

/// Encodes a text as encodeURIComponent does.
std::string in_address(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF", plain = "-_.!~*'()";
  std::string made;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_letter || plain.find(c) != std::string_view::npos)
      made += c;
    else
      (made += '%') += {digits[byte >> 4], digits[byte & 15]};
  }
  return made;
}

}  // namespace

std::string link_to_player(const ExerciseResult& e, const std::vector<Played>& methods) {
  std::string to = to_string(e.number) + ".html#play";
  for (const Played& m : methods)
    to += "&row=" + in_address(m.model) + "/" + in_address(m.algorithm) + "/double/" +
          format_shortest(m.setting);
  return to;
}

std::string link_to_players(const ExerciseResult& e, const std::vector<std::string>& algorithms,
                            double step) {
  const auto moving =
      std::ranges::find_if(e.quantities, [](const QuantityResult& q) { return q.trajectory.has_value(); });
  if (moving == e.quantities.end()) return to_string(e.number) + ".html";
  std::map<std::string, std::vector<Played>> played;
  std::map<std::string, int> tried;
  for (const MethodResult& m : moving->methods) {
    if (is_published(m.model)) continue;
    ++tried[m.model];
    if (std::ranges::find(algorithms, m.algorithm) != algorithms.end())
      played[m.model].push_back({m.model, m.algorithm, step});
  }
  const auto most = std::ranges::max_element(tried, {}, &std::pair<const std::string, int>::second);
  return most == tried.end() ? to_string(e.number) + ".html" : link_to_player(e, played[most->first]);
}

}  // namespace oddity
