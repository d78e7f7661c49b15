#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/need.hpp"

/// What the program's verbs do. Each takes the folder of the reference tables, prints what is asked on
/// standard output, and throws BadInput.
namespace oddity::verbs {

namespace fs = std::filesystem;

void list();
/// `overrides` are "name=value".
void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool json);
/// 0 when something meets the need, else 1.
int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const Need&);
/// Of all chapters when `chapter` is 0.
void report(const fs::path& folder, int chapter, const fs::path& out);
/// Of all exercises when there are none.
void chart(const fs::path& folder, const std::vector<std::string>& exercises, const fs::path& out);
/// Of all scenes when there are none; `rows` prints what would put the limits and maps on record instead.
void stability(const fs::path& folder, const std::vector<std::string>& exercises, bool rows,
               const fs::path& out);
void bench(const fs::path& folder);

}  // namespace oddity::verbs
