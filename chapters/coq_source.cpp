#include "chapters/coq_source.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace oddity {

namespace {

/// "root" of "../../02_basic_concepts/shared/root.v".
std::string_view stem(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  return path.substr(0, path.rfind(".v"));
}

void add(std::string_view name, std::vector<std::string_view>& added, std::string& all) {
  if (std::ranges::find(added, name) != added.end()) return;
  added.push_back(name);
  const auto files = embedded_proofs();
  const auto has_name = [&](const EmbeddedFile& f) { return stem(f.path) == name; };
  const auto file = std::ranges::find_if(files, has_name);
  if (file == files.end()) throw std::logic_error("there is no file " + std::string(name) + ".v");
  if (std::ranges::count_if(files, has_name) > 1)
    throw std::logic_error("there are several files " + std::string(name) + ".v");
  std::string_view text = file->text;
  if (const std::size_t head = text.find(coq_head); head != text.npos)
    text.remove_prefix(head + coq_head.size());
  else
    throw std::logic_error(std::string(file->path) + " does not begin with coq_head");
  constexpr std::string_view load = "Load \"";
  while (text.starts_with(load)) {
    const std::string_view line = text.substr(0, text.find('\n'));
    add(stem(line.substr(load.size())), added, all);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  all += text;
}

}  // namespace

std::string coq_source(std::initializer_list<std::string_view> names) {
  std::vector<std::string_view> added;
  std::string all;
  for (const std::string_view name : names) add(name, added, all);
  return all;
}

}  // namespace oddity
