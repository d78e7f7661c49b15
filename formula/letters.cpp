#include "formula/letters.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "formula/tokens.hpp"

namespace oddity::formula {

namespace {

using Texts = std::vector<std::string>;

bool is_one_digit(const std::string& token) { return token.size() == 1 && is_digit(token[0]); }

/// Whether a plain-text name may contain c.
bool is_in_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '\'' ||
         static_cast<unsigned char>(c) >= 0x80;
}

Texts texts(const Tokens& tokens) {
  Texts all;
  for (const Token& token : tokens) all.push_back(token.text);
  return all;
}

/// Name of the rate: \dot x for x, \ddot x for \dot x, \dot{\mathbf r} for \mathbf r; in plain text, one more
/// prime.
Texts rate_of(Texts letter, bool plain) {
  if (plain)
    letter.front() += "'";
  else if (letter.front() == R"(\dot)")
    letter.front() = R"(\ddot)";
  else if (letter.front() == R"(\mathbf)" && letter.size() > 1)
    letter.insert(letter.begin() + 2, "}"), letter.insert(letter.begin(), {R"(\dot)", "{"});
  else
    letter.insert(letter.begin(), R"(\dot)");
  return letter;
}

/// Compares a letter's tokens with those of the text, and digits with indices.
class Comparison {
 public:
  Comparison(const Tokens& text, const std::vector<Index>& indices) : text_(text), indices_(indices) {}

  bool same(const Texts& letter, std::size_t begin) {
    at_ = begin;
    values_.clear();
    for (std::size_t k = 0; k < letter.size();) {
      if (at_ >= text_.size()) return false;
      if (text_[at_].text == letter[k])
        ++at_, ++k;
      else if (!index(letter, k))
        return false;
    }
    return at_ >= text_.size() || (text_[at_].text != "_" && text_[at_].text != "'");
  }
  std::size_t end() const { return at_; }
  const std::vector<std::pair<std::size_t, int>>& values() const { return values_; }

 private:
  /// Matches an index of the text with one digit of the letter, or with two in braces.
  bool index(const Texts& letter, std::size_t& k) {
    int value = 0;
    std::size_t length = 1;
    if (is_one_digit(letter[k])) {
      value = letter[k][0] - '0';
    } else if (k + 3 < letter.size() && letter[k] == "{" && is_one_digit(letter[k + 1]) &&
               is_one_digit(letter[k + 2]) && letter[k + 3] == "}") {
      value = 10 * (letter[k + 1][0] - '0') + (letter[k + 2][0] - '0');
      length = 4;
    } else {
      return false;
    }
    for (const Index& one : indices_) {
      // Braces around a single index are ignored.
      const std::size_t n = one.tokens.size();
      const bool braced = text_[at_].text == "{" && is_at(one, at_ + 1) && at_ + n + 1 < text_.size() &&
                          text_[at_ + n + 1].text == "}";
      if (!braced && !is_at(one, at_)) continue;
      const auto known = std::ranges::find(values_, one.slot, &std::pair<std::size_t, int>::first);
      if (known != values_.end() && known->second != value) return false;
      if (known == values_.end()) values_.emplace_back(one.slot, value);
      at_ += n + (braced ? 2 : 0);
      k += length;
      return true;
    }
    return false;
  }
  bool is_at(const Index& one, std::size_t at) const {
    if (at + one.tokens.size() > text_.size()) return false;
    for (std::size_t i = 0; i < one.tokens.size(); ++i)
      if (text_[at + i].text != one.tokens[i]) return false;
    return true;
  }

  const Tokens& text_;
  const std::vector<Index>& indices_;
  std::size_t at_ = 0;
  std::vector<std::pair<std::size_t, int>> values_;
};

std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

Vocabulary::Vocabulary(const std::vector<std::string>& names, bool plain) : names_(names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = plain ? plain_name(names[i]) : names[i];
    const Texts tokens = plain ? Texts{name} : texts(tex_tokens(name));
    if (tokens.empty() || tokens.front().empty()) continue;
    const auto first = std::ranges::find(letters_, tokens, &Letter::tokens);
    if (first != letters_.end())
      first->entry.along = static_cast<int>(i);
    else
      letters_.push_back({name, tokens, {.indices = {}, .rates = {static_cast<int>(i)}}});
  }
  for (std::size_t i = 0; i < letters_.size(); ++i) by_first_token_[letters_[i].tokens.front()].push_back(i);
  std::vector<std::vector<int>> rates;
  for (const Letter& letter : letters_) {
    std::vector<int> own;
    for (Texts tokens = letter.tokens; own.size() < 3; tokens = rate_of(tokens, plain)) {
      const auto found = std::ranges::find(letters_, tokens, &Letter::tokens);
      if (found == letters_.end()) break;
      own.push_back(found->entry.rates.front());
    }
    rates.push_back(std::move(own));
  }
  for (std::size_t i = 0; i < letters_.size(); ++i) letters_[i].entry.rates = std::move(rates[i]);
}

std::optional<Vocabulary::Found> Vocabulary::at(const Tokens& text, std::size_t begin,
                                                const std::vector<Index>& indices) const {
  std::optional<Found> longest;
  if (begin >= text.size()) return longest;
  const auto candidates = by_first_token_.find(text[begin].text);
  if (candidates == by_first_token_.end()) return longest;
  Comparison comparison(text, indices);
  for (const std::size_t candidate : candidates->second) {
    const Letter& letter = letters_[candidate];
    if (!comparison.same(letter.tokens, begin)) continue;
    const std::size_t length = comparison.end() - begin;
    if (longest && length < longest->length) continue;
    std::vector<std::size_t> slots;
    std::vector<int> values;
    for (const auto& [slot, value] : comparison.values()) {
      slots.push_back(slot);
      values.push_back(value);
    }
    const bool better = !longest || length > longest->length || slots.size() < longest->slots.size();
    if (better) longest = Found{length, slots, {}};
    if (slots != longest->slots) continue;
    Entry entry = letter.entry;
    entry.indices = std::move(values);
    longest->entries.push_back(std::move(entry));
  }
  return longest;
}

std::size_t Vocabulary::length_of_name(std::string_view text) const {
  std::size_t longest = 0;
  for (std::size_t n = 1; n <= text.size() && n <= 60; ++n) {
    const bool ends = n == text.size() || (!is_in_name(text[n]) && text[n] != ',') ||
                      (text[n] == ',' && (n + 1 == text.size() || !is_in_name(text[n + 1])));
    if (ends && by_first_token_.contains(std::string(text.substr(0, n)))) longest = n;
    if (!is_in_name(text[n - 1]) && text[n - 1] != ',') break;
  }
  return longest;
}

bool Vocabulary::has(const Texts& tokens) const {
  return std::ranges::find(letters_, tokens, &Letter::tokens) != letters_.end();
}

std::vector<std::string> Vocabulary::similar_to(const std::string& name) const {
  std::vector<std::pair<std::size_t, std::string>> near;
  const std::string begins = name.substr(0, name.find('_'));
  for (const Letter& letter : letters_) {
    const std::size_t distance = edits(name.substr(0, 40), letter.name.substr(0, 40));
    const bool same_stem = letter.name.substr(0, letter.name.find('_')) == begins;
    if (same_stem)
      near.emplace_back(distance, letter.name);
    else if (distance <= 1 && name.size() > 1)
      near.emplace_back(100 + distance, letter.name);
  }
  std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < std::min<std::size_t>(near.size(), 3); ++i) all.push_back(near[i].second);
  return all;
}

}  // namespace oddity::formula
