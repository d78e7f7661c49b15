#include "tests/prose/prose.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace oddity::prose {

namespace {

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '\'' || (c & 0x80) != 0; }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// ---- passages ---------------------------------------------------------------------------------------------

/// Joins lines to paragraphs: an empty line, a heading, an item of a list or another indentation begins the
/// next.
class Paragraphs {
 public:
  void add(std::string_view line, std::size_t number) {
    const std::size_t start = line.find_first_not_of(" \t");
    line = line.substr(0, line.find_last_not_of(" \t") + 1);
    if (start == line.npos) return end();
    const bool is_item = line[start] == '#' || line.substr(start).starts_with("- ");
    if (is_item || is_row(line.substr(start)) || (start > indent_ + 1 && !open_.text.empty())) end();
    if (open_.text.empty()) open_ = {"", number}, indent_ = start;
    open_.text += std::string(open_.text.empty() ? "" : " ") + std::string(line.substr(start));
    if (is_row(line.substr(start)) || line[start] == '#') end();
  }
  void end() {
    if (!open_.text.empty()) done_.push_back(std::move(open_));
    open_ = {};
  }
  std::vector<Passage> all() {
    end();
    return std::move(done_);
  }

 private:
  static bool is_row(std::string_view line) { return line.starts_with('|'); }
  Passage open_{};
  std::size_t indent_ = 0;
  std::vector<Passage> done_;
};

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

std::vector<Passage> in_markdown(std::string_view text) {
  Paragraphs paragraphs;
  bool is_code = false;
  std::size_t number = 0;
  for (std::string_view line : lines_of(text)) {
    ++number;
    if (line.starts_with("```")) is_code = !is_code;
    paragraphs.add(is_code || line.starts_with("```") ? "" : line, number);
  }
  return paragraphs.all();
}

std::vector<Passage> behind_hashes(std::string_view text) {
  Paragraphs paragraphs;
  std::size_t number = 0;
  for (std::string_view line : lines_of(text)) {
    ++number;
    const std::size_t sign = line.starts_with('#') ? 0 : line.find(" # ");
    if (sign != 0) paragraphs.end();
    if (sign == line.npos || line.starts_with("#!"))
      paragraphs.end();
    else
      paragraphs.add(line.substr(std::min(line.find_first_not_of(" #", sign), line.size())), number);
    if (sign != 0) paragraphs.end();
  }
  return paragraphs.all();
}

/// Comments and quoted texts in the notation of C++, JavaScript and CSS.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Passage> passages() {
    while (at_ < text_.size()) step();
    finish_quoted();
    std::vector<Passage> all = comments_.all();
    all.insert(all.end(), quoted_.begin(), quoted_.end());
    std::ranges::stable_sort(all, {}, &Passage::line);
    return all;
  }

 private:
  void step() {
    const char c = text_[at_];
    if (starts("//")) return line_comment();
    if (starts("/*")) return block_comment();
    if (starts("R\"")) return raw();
    if (c == '"' || c == '\'' || c == '`') {
      const bool in_number = c == '\'' && at_ > 0 && is_letter(text_[at_ - 1]);
      if (!in_number) return quoted(c);
    }
    if (!is_space(c)) code();
    count(c), ++at_;
  }

  bool starts(std::string_view with) const { return starts_at(at_, with); }
  bool starts_at(std::size_t at, std::string_view with) const { return text_.substr(at).starts_with(with); }
  void count(char c) { line_ += c == '\n'; }
  void code() {
    comments_.end();
    finish_quoted();
  }

  void line_comment() {
    const bool is_behind_code = at_ > 0 && text_.substr(0, at_).find_last_not_of(" \t") != text_.npos &&
                                text_[text_.substr(0, at_).find_last_not_of(" \t")] != '\n';
    if (is_behind_code) comments_.end();
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    line.remove_prefix(std::min(line.find_first_not_of("/<!"), line.size()));
    comments_.add(line.starts_with(" ----") || line.starts_with(" clang-format") ? "" : line, line_);
    if (is_behind_code || starts_at(end, "\n\n")) comments_.end();
    at_ = end;
  }

  void block_comment() {
    const std::size_t end = std::min(text_.find("*/", at_ + 2), text_.size());
    for (std::string_view line : lines_of(text_.substr(at_ + 2, end - at_ - 2))) {
      comments_.add(line.substr(std::min(line.find_first_not_of(" *"), line.size())), line_++);
    }
    --line_;
    comments_.end();
    at_ = std::min(end + 2, text_.size());
  }

  void raw() {
    const std::size_t open = text_.find('(', at_);
    const std::string close = ")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"";
    const std::size_t end = std::min(text_.find(close, open), text_.size());
    add_quoted(text_.substr(open + 1, end - open - 1));
    for (; at_ < std::min(end + close.size(), text_.size()); ++at_) count(text_[at_]);
  }

  void quoted(char quote) {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != quote && !(text_[at_] == '\n' && quote != '`'))
      count(text_[at_]), at_ += text_[at_] == '\\' ? 2 : 1;
    at_ = std::min(at_, text_.size());
    add_quoted(text_.substr(begin, at_ - begin));
    at_ += at_ < text_.size();
  }

  void add_quoted(std::string_view text) {
    comments_.end();
    if (text_part_.text.empty()) text_part_.line = line_;
    text_part_.text += text;
  }

  /// Four words or more, with few signs among them, unlike code.
  static bool is_prose(const std::string& text) {
    const auto signs = std::ranges::count_if(text, [](char c) {
      return std::string_view("()[]{}<>=*+^\\_;&|").find(c) != std::string_view::npos;
    });
    return std::ranges::count(text, ' ') >= 3 && signs * 20 < std::ssize(text);
  }

  void finish_quoted() {
    if (is_prose(text_part_.text)) quoted_.push_back(text_part_);
    text_part_ = {};
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
  Paragraphs comments_;
  Passage text_part_{};
  std::vector<Passage> quoted_;
};

// ---- sentences --------------------------------------------------------------------------------------------

struct Word {
  std::string text;
  std::size_t at;
};
using Sentence = std::vector<Word>;

/// End of the code, formula or link's address that opens with the sign at `at`; npos for other signs.
std::size_t end_of_code(std::string_view text, std::size_t at) {
  if (text.substr(at).starts_with("](")) return text.find(')', at);
  if (text[at] != '`' && text[at] != '$') return text.npos;
  return text.find(text[at], at + 1);
}

/// Sentences without questions. Code and formulas are a word "`" each.
std::vector<Sentence> sentences_of(std::string_view text) {
  std::vector<Sentence> sentences(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t end = end_of_code(text, i); end != text.npos) {
      sentences.back().push_back({"`", i});
      i = end;
    } else if (text.substr(i).starts_with("\\n")) {  // a line's end in a quoted text
      ++i;
      if (!sentences.back().empty()) sentences.emplace_back();
    } else if (is_letter(text[i])) {
      Word word{"", i};
      for (; i < text.size() && (is_letter(text[i]) || text[i] == '_'); ++i)
        word.text += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
      sentences.back().push_back(word);
      --i;
    } else if (const bool is_last = i + 1 == text.size() || is_space(text[i + 1]);
               is_last && (text[i] == '.' || text[i] == '?' || text[i] == '!')) {
      if (text[i] == '?') sentences.back().clear();
      if (!sentences.back().empty()) sentences.emplace_back();
    }
  }
  return sentences;
}

bool applies(const Rule& rule, const Sentence& sentence, std::size_t at) {
  if (at + rule.words.size() > sentence.size()) return false;
  for (std::size_t i = 0; i < rule.words.size(); ++i)
    if (std::ranges::find(rule.words[i], sentence[at + i].text) == rule.words[i].end()) return false;
  return true;
}

}  // namespace

std::vector<Passage> passages_in(const std::filesystem::path& file, std::string_view text) {
  const std::string extension = file.extension().string();
  const auto is_one_of = [&](std::initializer_list<const char*> all) {
    return std::ranges::find(all, extension) != all.end();
  };
  if (extension == ".md") return in_markdown(text);
  if (is_one_of({".sh", ".cmake", ".txt"})) return behind_hashes(text);
  if (is_one_of({".cpp", ".hpp", ".js", ".mjs", ".css"})) return Scanner(text).passages();
  return {};
}

std::vector<Rule> rules_of(std::string_view text) {
  std::vector<Rule> rules;
  for (std::string_view line : lines_of(text)) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t colon = line.find(": "), arrow = line.find(" -> ");
    if (colon == line.npos || arrow == line.npos || arrow < colon + 2)
      throw std::invalid_argument("'" + std::string(line) + "' is no rule: kind: word word|other -> remedy");
    Rule rule{std::string(line.substr(0, colon)), {}, false, std::string(line.substr(arrow + 4))};
    std::istringstream words{std::string(line.substr(colon + 2, arrow - colon - 2))};
    for (std::string place; words >> place;) {
      if (place == "^") {
        rule.at_start = true;
        continue;
      }
      std::istringstream alternatives(place);
      rule.words.emplace_back();
      for (std::string word; std::getline(alternatives, word, '|');) rule.words.back().push_back(word);
    }
    rules.push_back(std::move(rule));
  }
  return rules;
}

std::vector<Accepted> accepted_in(std::string_view text) {
  std::vector<Accepted> all;
  for (std::string_view line : lines_of(text)) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t file = line.find(": "), kind = line.find(": ", file + 2), arrow = line.rfind(" -> ");
    if (file == line.npos || kind == line.npos || arrow == line.npos || arrow < kind + 2)
      throw std::invalid_argument("'" + std::string(line) + "' is not: file: kind: words -> reason");
    all.push_back({std::string(line.substr(0, file)), std::string(line.substr(file + 2, kind - file - 2)),
                   std::string(line.substr(kind + 2, arrow - kind - 2))});
  }
  return all;
}

std::vector<Fault> faults_in(const Passage& passage, const std::vector<Rule>& rules) {
  std::vector<Fault> faults;
  const auto excerpt = [&](std::size_t at) { return passage.text.substr(at, 60); };
  const std::vector<Sentence> sentences = sentences_of(passage.text);
  const bool begins = !passage.text.starts_with(' ');  // otherwise a number that the code inserts
  for (const Sentence& sentence : sentences) {
    for (std::size_t i = 0; i < sentence.size(); ++i)
      for (const Rule& rule : rules)
        if ((!rule.at_start || (begins && i == 0 && &sentence == &sentences.front())) &&
            applies(rule, sentence, i))
          faults.push_back({passage.line, rule.kind, excerpt(sentence[i].at), rule.remedy});
    if (sentence.size() > longest_sentence)
      faults.push_back({passage.line, "long", excerpt(sentence.front().at),
                        std::to_string(sentence.size()) + " words: one thought a sentence"});
  }
  return faults;
}

}  // namespace oddity::prose
