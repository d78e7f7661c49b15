#include "extras/mutation/schemata.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "reference/files.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view header = "#include \"extras/mutation/mutant.hpp\"\n";

/// A change of a file's text: `removed` characters at `at` are replaced by `text`.
struct Edit {
  unsigned at;
  long rank;  ///< order at one place: ends, beginnings, removals
  unsigned removed;
  std::string text;
};

class Edits {
 public:
  void around(const Extent& e, const std::string& before, const std::string& after) {
    ++depth_;
    all_.push_back({e.begin, depth_ - far, 0, before});
    all_.push_back({e.end, -depth_ - far, 0, after});
  }
  void instead(const Extent& e, const std::string& text) {
    all_.push_back({e.begin, 0, e.end - e.begin, text});
  }

  std::string of(const std::string& text) {
    std::ranges::stable_sort(all_, {}, [](const Edit& e) { return std::pair(e.at, e.rank); });
    std::string result;
    unsigned at = 0;
    for (const Edit& e : all_) {
      result += text.substr(at, e.at - at) + e.text;
      at = e.at + e.removed;
    }
    return result + text.substr(at);
  }

 private:
  static constexpr long far = 1L << 40;
  long depth_ = 0;  ///< inner edits come later
  std::vector<Edit> all_;
};

std::string call(const std::string& function, int mutant) {
  return "::oddity::mutation::" + function + "(" + std::to_string(mutant);
}

void edit(Edits& edits, const Point& p, int mutant) {
  switch (p.shape) {
    case Shape::operation:
    case Shape::assignment: {
      const std::string make = p.shape == Shape::operation ? ", ODDITY_OPERATION(" : ", ODDITY_ASSIGNMENT(";
      edits.around(p.whole, call(p.function, mutant) + ", ",
                   make + p.operators[0] + ")" + make + p.operators[1] + "))");
      edits.instead(p.op, ", ");
      break;
    }
    case Shape::comparison:
      edits.around(p.whole, call(p.function, mutant) + ", ", ")");
      edits.instead(p.op, ", ");
      break;
    case Shape::sign:
      edits.around(p.whole, call(p.function, mutant) + ", ", ", ODDITY_NEGATIVE)");
      edits.instead(p.op, "");
      break;
    case Shape::literal:
      edits.around(p.whole, call(p.function, mutant) + ", ", ")");
      break;
    case Shape::logic: {
      const bool both = p.function == "&&";  // a true operand decides nothing of it, a false one of ||
      const std::string open = both ? "(" : "(!", then = both ? ") || (" : ") && (";
      edits.around({p.whole.begin, p.op.begin}, open + call("chosen", mutant) + then, "))");
      edits.around({p.op.end, p.whole.end}, open + call("chosen", mutant + 1) + then, "))");
      break;
    }
    case Shape::condition:
      edits.around(p.whole, "(" + call("chosen", mutant) + ") == !(", "))");
      break;
    case Shape::statement:
      edits.around({p.whole.begin, p.whole.end + 1}, "{ if (!" + call("chosen", mutant) + ")) ", " }");
      break;
  }
}

std::string line_of(const std::string& text, unsigned at) {
  const auto end = text.find('\n', at);
  auto begin = text.rfind('\n', at);
  begin = begin == text.npos ? 0 : begin + 1;
  begin = text.find_first_not_of(' ', begin);
  return text.substr(begin, end - begin);
}

/// The near misses of a file's claims. Assumes that braces within formulas' texts are balanced.
std::vector<Extent> near_misses_in(const std::string& text) {
  std::vector<Extent> all;
  for (auto at = text.find(".near_misses ="); at != text.npos; at = text.find(".near_misses =", at + 1)) {
    const auto begin = text.find('{', at);
    auto end = begin;
    for (int open = 0; end < text.size(); ++end) {
      open += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
      if (open == 0) break;
    }
    if (begin != text.npos) all.push_back({static_cast<unsigned>(begin), static_cast<unsigned>(end)});
  }
  return all;
}

/// The texts of the tree's files except build products.
std::vector<fs::path> sources_of(const fs::path& tree) {
  static const std::set<std::string> left_out{"build", ".git", "node_modules", "book"};
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(tree), end; at != end; ++at) {
    if (left_out.contains(at->path().filename().string())) {
      at.disable_recursion_pending();
      continue;
    }
    if (at->is_regular_file()) files.push_back(fs::relative(at->path(), tree));
  }
  return files;
}

/// Whether results of the tests may depend on the file.
bool computed(const std::string& file) {
  static const std::set<std::string> rooms{"formula", "chapters", "solvers", "reference", "report"};
  return rooms.contains(file.substr(0, file.find('/')));
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::string Mutant::change() const {
  return function + ": " + line + ": " + mutation +
         (occurrence > 1 ? " (" + std::to_string(occurrence) + ")" : "");
}

std::string Mutant::name() const { return file + ": " + change(); }

std::string Mutant::id() const {
  std::ostringstream id;
  id << std::hex << std::setfill('0') << std::setw(16) << number_of(name());
  return id.str();
}

std::string Mutant::room() const { return room_of(file); }

std::string room_of(const std::string& file) {
  const auto folder = file.rfind('/'), first = file.find('/'), second = file.find('/', first + 1);
  return file.substr(0, std::min(folder, second));
}

std::uint64_t number_of(const std::string& text) {
  std::uint64_t n = 0xcbf29ce484222325u;
  for (const char c : text) n = (n ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return n;
}

void number_files(std::vector<Mutable>& files, const fs::path& kept) {
  constexpr int round = 64;
  struct Numbers {
    int first = 0, count = 0;
  };
  std::map<std::string, Numbers> known;
  std::ifstream in(kept);
  int next = 1;
  for (auto [file, numbers] = std::pair<std::string, Numbers>();
       in >> file >> numbers.first >> numbers.count;) {
    known[file] = numbers;
    next = std::max(next, numbers.first + numbers.count);
  }
  for (Mutable& file : files) {
    int count = 0;
    for (const Point& p : file.points) count += static_cast<int>(p.mutations.size());
    Numbers& numbers = known[file.file];
    if (numbers.count < count) {
      numbers = {next, (count + round - 1) / round * round};
      next += numbers.count;
    }
    file.first = numbers.first;
  }
  std::string text;
  for (const auto& [file, numbers] : known)
    text += file + " " + std::to_string(numbers.first) + " " + std::to_string(numbers.count) + "\n";
  write_whole(kept, text);
}

std::vector<Mutant> mutants_of(const std::vector<Mutable>& files) {
  std::vector<Mutant> all;
  for (const Mutable& file : files) {
    int number = file.first;
    std::map<std::string, int> alike;
    const std::vector<Extent> near_misses = near_misses_in(file.text);
    for (const Point& p : file.points)
      for (const std::string& mutation : p.mutations) {
        const unsigned at = std::max(p.op.end, p.whole.begin);  // the operator's line, if it has one
        Mutant m{number++, file.file, p.within, line_of(file.text, at), mutation};
        m.in_near_miss = std::ranges::any_of(
            near_misses, [&](const Extent& e) { return e.begin < p.whole.begin && p.whole.end <= e.end; });
        m.at = 1 + static_cast<int>(std::count(file.text.begin(), file.text.begin() + at, '\n'));
        m.occurrence = ++alike[m.name()];
        all.push_back(std::move(m));
      }
  }
  return all;
}

std::string schema(const Mutable& file) {
  Edits edits;
  int first = file.first;
  for (const Point& p : file.points) {
    edit(edits, p, first);
    first += static_cast<int>(p.mutations.size());
  }
  const std::string text = edits.of(file.text);
  const std::string_view once = "#pragma once\n";
  const auto at = text.find(once);
  return at == text.npos
             ? std::string(header) + text
             : text.substr(0, at + once.size()) + std::string(header) + text.substr(at + once.size());
}

bool write_schemata(const fs::path& tree, const std::vector<Mutable>& files, const fs::path& copy) {
  std::map<std::string, std::string> mutated;
  for (const Mutable& file : files)
    if (!file.points.empty()) mutated[file.file] = schema(file);
  bool changed = false;
  for (const fs::path& file : sources_of(tree)) {
    const auto found = mutated.find(file.string());
    const std::string text = found == mutated.end() ? read(tree / file) : found->second;
    if (fs::exists(copy / file) && read(copy / file) == text) continue;
    write_whole(copy / file, text);
    fs::permissions(copy / file, fs::status(tree / file).permissions());
    changed |= computed(file.string());
  }
  return changed;
}

}  // namespace oddity::mutation
