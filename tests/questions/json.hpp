#pragma once

#include <cctype>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace questions {

/// A JSON value. Missing members are null.
struct Json {
  enum Kind { null, boolean, number, text, list, object } kind = null;
  double value = 0;  ///< number or boolean
  std::string words = {};
  std::vector<Json> items = {};
  std::map<std::string, Json, std::less<>> members = {};

  const Json& operator[](std::string_view name) const {
    static const Json nothing{};
    const auto found = members.find(name);
    return found == members.end() ? nothing : found->second;
  }
  explicit operator bool() const { return kind != null; }
};

class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : left_(text) {}
  /// Throws std::runtime_error if the text is no JSON.
  Json whole() {
    Json json = next();
    space();
    if (!left_.empty()) fail();
    return json;
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("no JSON"); }
  void space() {
    while (!left_.empty() && std::isspace(static_cast<unsigned char>(left_[0]))) left_.remove_prefix(1);
  }
  bool take(std::string_view word) {
    space();
    if (!left_.starts_with(word)) return false;
    left_.remove_prefix(word.size());
    return true;
  }
  std::string quoted() {  // after the quote
    std::string words;
    for (; !left_.empty() && left_[0] != '"'; left_.remove_prefix(1)) {
      if (left_[0] == '\\' && left_.size() > 1) left_.remove_prefix(1);
      words += left_[0];
    }
    if (!take("\"")) fail();
    return words;
  }
  Json next() {
    Json json;
    if (take("null")) return json;
    if (take("true")) return {Json::boolean, 1};
    if (take("false")) return {Json::boolean, 0};
    if (take("\"")) return {Json::text, 0, quoted()};
    if (take("[")) {
      json.kind = Json::list;
      while (!take("]")) {
        if (!json.items.empty() && !take(",")) fail();
        json.items.push_back(next());
      }
      return json;
    }
    if (take("{")) {
      json.kind = Json::object;
      while (!take("}")) {
        if (!json.members.empty() && !take(",")) fail();
        if (!take("\"")) fail();
        const std::string name = quoted();
        if (!take(":")) fail();
        json.members[name] = next();
      }
      return json;
    }
    const std::string text(left_.substr(0, 40));
    char* end = nullptr;
    json.kind = Json::number;
    json.value = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) fail();
    left_.remove_prefix(static_cast<std::size_t>(end - text.c_str()));
    return json;
  }

  std::string_view left_;
};

}  // namespace questions
