#pragma once

#include <span>
#include <string_view>

/// The keys that a problem's file may have: what the reader takes, and the schema says.
namespace oddity::problem {

struct Key {
  std::string_view name, says;
  /// text, texts (one or several), flag, number, rows, a table's name, or: "map X", names of one's own with
  /// an X each; "list X"; "X or Y".
  std::string_view is;
  bool needed = false;
};
struct KeysOf {
  std::string_view name;
  std::span<const Key> keys;
};

/// All tables, the file itself first.
std::span<const KeysOf> all_keys();
/// Those of one. Throws std::logic_error where there is none.
std::span<const Key> keys_of(std::string_view name);

}  // namespace oddity::problem
