#pragma once

#include <span>
#include <string_view>

/// The keys of a problem's file, for the reader and the schema.
namespace oddity::problem {

struct Key {
  std::string_view name, says;
  /// text, texts (one or several), components (one, several, or rows of them), flag, number, rows, or a
  /// table's name. Or "map X", user-defined names with an X each; "list X"; "X or Y".
  std::string_view is;
  bool needed = false;
};
struct KeysOf {
  std::string_view name;
  std::span<const Key> keys;
};

/// All tables, the file itself first.
std::span<const KeysOf> all_keys();
/// The keys of one table. Throws std::logic_error if there is no such table.
std::span<const Key> keys_of(std::string_view name);

}  // namespace oddity::problem
