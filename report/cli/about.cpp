#include "report/cli/about.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "chapters/scene.hpp"
#include "reference/similar.hpp"

namespace oddity {

namespace {

/// Search words that are missing in the exercise's own text.
constexpr std::pair<std::string_view, std::string_view> also_called[]{
    {"2.3", "helix loxodrome sphere curve"},
    {"2.5", "rotation matrix quaternion axis angle"},
    {"2.9", "balance equilibrium lever seesaw center of mass"},
    {"2.13", "moment of inertia tensor plate"},
    {"2.15", "parallel axis Steiner moment of inertia"},
    {"3.1", "Kepler planet comet conic section gravity"},
    {"3.3", "planet comet satellite two-body gravity orbit ellipse"},
    {"3.5", "swing oscillator bob elliptic integral"},
    {"3.7", "wire roller coaster track constraint slide"},
    {"3.9", "oscillator damper damping viscous drag harmonic mass"},
    {"3.11", "slide terrain free fall"},
    {"3.13", "cylinder half-pipe slide trough"},
    {"3.15", "rotating centrifugal arm slide"},
    {"3.17", "Coriolis Earth rotation conical cone"},
    {"3.19", "Atwood rope oscillator"},
    {"3.21", "gyroscope gyro wheel precession"},
    {"3.23", "lever oscillator hinge seesaw beam"},
    {"3.25", "double pendulum rope chaos ragdoll links"},
    {"3.27", "Kepler planet orbit two-body satellite binary star comet free"},
    {"3.29", "rigid body rod planar lamina free"},
    {"3.31", "crate cuboid sliding Coulomb friction brake skid"},
    {"3.33", "gyroscope gyro spinning rigid body precession nutation Lagrange free cone"},
    {"3.35", "gyroscope gyro spinning rigid body shaken cone"},
    {"6.1", "broad phase grid hashing collision detection"},
    {"6.3", "collision balls bounce sweep continuous detection"},
    {"6.5", "collision impulse bounce restitution rest"},
    {"7.1", "Gauss elimination operations linear system"},
    {"7.5", "cross product plane"},
    {"7.9", "cofactor Laplace expansion"},
    {"9.1", "closest point distance projection collision"},
};

std::string small(std::string_view text) {
  std::string all(text);
  std::ranges::transform(all, all.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return all;
}

using Words = std::vector<std::string>;

Words words_in(std::string_view text) {
  Words words;
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (auto end = text.begin(); end != text.end();) {
    const auto begin = std::find_if(end, text.end(), in_word);
    end = std::find_if_not(begin, text.end(), in_word);
    if (end != begin) words.push_back(small({begin, end}));
  }
  return words;
}

/// An exercise's words by tier; its best-known words come first.
using Tiers = std::array<Words, 3>;

Tiers tiers_of(const Entry& entry) {
  const Exercise& exercise = entry.exercise;
  std::string title(exercise.title), parts;
  for (const auto& [number, words] : also_called)
    if (number == to_string(entry.number)) title += " " + std::string(words);
  for (const Parameter& p : exercise.parameters) parts += " " + std::string(p.says);
  if (exercise.scene) {
    const Quantity seen = motion(*exercise.scene, Parameters(exercise.parameters), Reference::nothing());
    std::set<std::string> models;
    for (const Method& m : seen.methods) models.insert(m.model);
    for (const std::string& model : models) parts += " " + model;
  }
  return {words_in(title), words_in(parts), words_in(exercise.asks)};
}

const std::vector<Tiers>& all_tiers() {
  static const std::vector<Tiers> all = [] {
    std::vector<Tiers> tiers;
    for (const Entry& entry : registry()) tiers.push_back(tiers_of(entry));
    return tiers;
  }();
  return all;
}

bool begins(std::string_view said, std::string_view word) { return said.starts_with(word); }
/// True for "bouncing" and "bounce".
bool shares_stem(std::string_view said, std::string_view word) {
  const auto parted = std::ranges::mismatch(said, word).in2;
  return static_cast<std::size_t>(parted - word.begin()) >= std::max<std::size_t>(4, word.size() - 3);
}
bool is_misspelt(std::string_view said, std::string_view word) {
  return word.size() > 3 && nearly_same(word, said, static_cast<int>(word.size()) / 4);
}

/// Search words; those of one or two letters are too common.
Words asked_words(const std::string& text) {
  Words asked = words_in(text);
  std::erase_if(asked, [](const std::string& word) { return word.size() < 3; });
  return asked;
}

using Same = bool (*)(std::string_view said, std::string_view word);

/// The first of the tiers that contain the word, or the number of tiers.
std::size_t tier_with(const Tiers& tiers, const std::string& word, Same same) {
  const auto has = [&](const Words& words) {
    return std::ranges::any_of(words, [&](const std::string& said) { return same(said, word); });
  };
  return static_cast<std::size_t>(std::ranges::find_if(tiers, has) - tiers.begin());
}

/// Exercises with all of the words (with any of them if `any`), in the order of their tiers.
std::vector<const Entry*> found(const Words& asked, Same same, bool any) {
  std::map<std::size_t, std::vector<const Entry*>> by_tier;
  for (std::size_t i = 0; i < registry().size(); ++i) {
    std::size_t first = std::tuple_size_v<Tiers>, last = 0;
    for (const std::string& word : asked) {
      const std::size_t tier = tier_with(all_tiers()[i], word, same);
      first = std::min(first, tier);
      last = std::max(last, tier);
    }
    by_tier[any ? first : last].push_back(&registry()[i]);
  }
  std::vector<const Entry*> all;
  for (std::size_t tier = 0; tier < std::tuple_size_v<Tiers>; ++tier)
    std::ranges::copy(by_tier[tier], std::back_inserter(all));
  return all;
}

}  // namespace

std::vector<const Entry*> exercises_about(const std::string& text) {
  const Words asked = asked_words(text);
  if (asked.empty()) return {};
  for (const Same same : {begins, shares_stem, is_misspelt})
    for (const bool any : {false, true})
      if (auto all = found(asked, same, any); !all.empty()) return all;
  return {};
}

std::string near_words(const std::string& text) {
  std::set<std::string> all;
  constexpr std::size_t too_short = 3;
  for (const Tiers& tiers : all_tiers())
    for (const std::string& word : tiers.front())
      if (word.size() > too_short) all.insert(word);
  const std::vector<std::string> candidates(all.begin(), all.end());
  for (const std::string& word : words_in(text))
    if (word.size() > too_short)
      if (const std::string near = did_you_mean(word, candidates); !near.empty()) return near;
  return "";
}

bool is_about(const std::string& name, const std::string& text) {
  const Words said = words_in(name);
  return std::ranges::any_of(asked_words(text), [&](const std::string& word) {
    return std::ranges::any_of(
        said, [&](const std::string& one) { return begins(one, word) || shares_stem(one, word); });
  });
}

}  // namespace oddity
