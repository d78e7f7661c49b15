#include "reference/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "reference/bad_input.hpp"
#include "reference/interrupted.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The system's message for its last failure.
std::string last_failure() { return std::error_code(errno, std::generic_category()).message(); }

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw BadInput("cannot write " + file.string() + ": " + why);
}

void require(bool written, const fs::path& file) {
  if (!written) refuse(file, last_failure());
}

/// An open file, closed by the destructor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  operator int() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void refuse_folder(const fs::path& folder, const std::string& why) {
  throw BadInput("cannot make the folder " + folder.string() + ": " + why);
}

std::string target_of(int link) {
  std::string target(PATH_MAX, '\0');
  const ssize_t size = readlinkat(link, "", target.data(), target.size());
  target.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
  return target;
}

/// Adds the steps of the folder's path, last first.
void add_steps(std::vector<std::string>& ahead, const fs::path& path) {
  std::vector<std::string> steps;
  for (const fs::path& step : path.relative_path())
    if (!step.empty() && step != ".") steps.push_back(step.string());
  ahead.insert(ahead.end(), steps.rbegin(), steps.rend());
}

constexpr int any_step = O_PATH | O_NOFOLLOW | O_CLOEXEC;

/// Opens the folder, and creates it if it is missing. Each step starts from the previous folder. Links are
/// followed only if root or this user made them, so that nobody else can redirect output.
Descriptor opened_folder(const fs::path& folder) {
  const auto start = [](const fs::path& path) { return open(path.is_absolute() ? "/" : ".", any_step); };
  Descriptor at(start(folder));
  std::vector<std::string> ahead;
  add_steps(ahead, folder);
  for (int links = 0; !ahead.empty();) {
    const std::string step = ahead.back();
    ahead.pop_back();
    Descriptor next(openat(at, step.c_str(), any_step));
    if (next < 0 && errno == ENOENT && (mkdirat(at, step.c_str(), 0777) == 0 || errno == EEXIST))
      next = Descriptor(openat(at, step.c_str(), any_step));
    struct stat status {};
    if (next < 0 || fstat(next, &status) != 0) refuse_folder(folder, last_failure());
    if (S_ISDIR(status.st_mode)) {
      at = std::move(next);
      continue;
    }
    if (!S_ISLNK(status.st_mode)) refuse_folder(folder, step + " is not a folder");
    if (status.st_uid != 0 && status.st_uid != geteuid())
      refuse_folder(folder, step + " is another user's link: name the folder itself");
    if (++links > 40) refuse_folder(folder, step + " is a link that leads to itself");
    const fs::path target = target_of(next);
    if (target.is_absolute()) at = Descriptor(start(target));
    add_steps(ahead, target);
  }
  return at;
}

/// Removes leftovers once per run.
void tidy(const fs::path& folder, int opened) {
  static std::mutex alone;
  static std::set<fs::path> tidied;
  const std::lock_guard lock(alone);
  if (tidied.insert(folder).second) remove_leftovers(opened);
}

/// Place of a file to be written: its folder, which is created, and its name. Throws BadInput if that is
/// impossible, or if the name belongs to something other than a file. A link of this name is replaced, never
/// followed.
struct Place {
  explicit Place(const fs::path& file)
      : folder(opened_folder(file.parent_path())), name(file.filename().string()) {
    struct stat status {};
    if (fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
      require(errno == ENOENT && !name.empty(), file);
    } else {
      if (S_ISDIR(status.st_mode)) refuse(file, "it is a folder");
      if (!S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode)) refuse(file, "it is not a regular file");
    }
    tidy(file.parent_path(), folder);
  }

  Descriptor folder;
  std::string name;
};

bool took_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  const int other = dup(descriptor);  // a network disk may report only on closing a file that it is full
  return other >= 0 && close(other) == 0;
}

std::string text_of(const fs::path& file, std::size_t most, int flags = 0, Whose whose = Whose::anybodys) {
  const auto unreadable = [&](const std::string& why) {
    throw BadInput("cannot read " + file.string() + ": " + why);
  };
  const Descriptor in(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | flags));
  struct stat status {};
  if (in < 0 || fstat(in, &status) != 0) unreadable(last_failure());
  if (S_ISDIR(status.st_mode)) unreadable("it is a folder");
  if (!S_ISREG(status.st_mode)) unreadable("it is not a regular file");
  if (whose == Whose::ours && status.st_uid != geteuid()) unreadable("it is another user's");
  const auto require_small = [&](std::size_t size) {
    if (size > most)
      unreadable("it is larger than " + std::to_string(most / 1'000'000) +
                 " MB, and no file of this kind is");
  };
  require_small(static_cast<std::size_t>(status.st_size));
  std::string text;
  std::vector<char> part(1 << 16);
  for (ssize_t size; (size = read(in, part.data(), part.size())) != 0;) {
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) unreadable(last_failure());
    text.append(part.data(), static_cast<std::size_t>(size));
    require_small(text.size());
  }
  return text;
}

}  // namespace

std::string read_whole(const fs::path& file, std::size_t most) { return text_of(file, most); }

void require_writable(const fs::path& file) {
  const Place place(file);
  require(Unfinished(place.folder).descriptor() >= 0, file);
}

void require_writable_folder(const fs::path& folder) {
  const Place place(folder / "is_it_writable");
  if (Unfinished(place.folder).descriptor() < 0)
    throw BadInput("cannot write in the folder " + folder.string() + ": " + last_failure());
}

void write_whole(const fs::path& file, const std::string& text) {
  const Place place(file);
  Unfinished part(place.folder);
  require(part.descriptor() >= 0 && took_all(part.descriptor(), text) && part.rename(place.name), file);
}

std::string checksum(std::string_view text) {
  std::ostringstream hex;
  hex << std::hex << std::hash<std::string_view>()(text);
  return hex.str();
}

void write_sealed(const fs::path& file, const std::string& text) {
  write_whole(file, text + checksum(text) + "\n");
}

void keep_sealed(const fs::path& file, const std::string& text) {
  try {
    write_sealed(file, text);
  } catch (const BadInput&) {  // it will be computed again
  }
}

std::optional<std::string> read_sealed(const fs::path& file, Whose whose) {
  std::string all;
  try {
    all = text_of(file, most_read, O_NOFOLLOW, whose);
  } catch (const BadInput&) {  // it will be computed again
    return {};
  }
  if (all.size() < 2 || all.back() != '\n') return {};
  const std::size_t seal = all.rfind('\n', all.size() - 2) + 1;  // 0 for a single line
  const std::string text = all.substr(0, seal);
  if (all.substr(seal) != checksum(text) + "\n") return {};
  return text;
}

bool is_device(const fs::path& path) {
  const std::string folder = fs::absolute(path).lexically_normal().parent_path();
  std::error_code error;
  return (folder == "/dev" || folder == "/dev/fd" || folder == "/proc/self/fd") && fs::exists(path, error) &&
         !fs::is_directory(path, error);
}

void write_to_device(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  require(out.is_open(), path);
  out << text;
  out.close();
  require(!out.fail(), path);
}

void require_private(const fs::path& folder, const std::string& name) {
  std::error_code cannot;  // then the folder is missing, and nothing is cached
  fs::create_directories(folder.parent_path(), cannot);
  mkdir(folder.c_str(), 0700);
  const Descriptor opened(open(folder.c_str(), any_step));
  struct stat status {};
  if (opened < 0 || fstat(opened, &status) != 0) return;
  const auto refuse_it = [&](const fs::path& what, const std::string& why) {
    throw BadInput("nothing is kept in " + folder.string() + ", as " + what.string() + " " + why +
                   ": remove it, or have XDG_CACHE_HOME name another folder");
  };
  if (!S_ISDIR(status.st_mode)) refuse_it(folder, "is a link or no folder");
  if (status.st_uid != geteuid()) refuse_it(folder, "is another user's");
  if (status.st_mode & (S_IWGRP | S_IWOTH)) refuse_it(folder, "can be written by others");
  chmod(folder.c_str(), 0700);
  if (fstatat(opened, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return;
  if (status.st_uid != geteuid()) refuse_it(folder / name, "is another user's");
  if (S_ISLNK(status.st_mode)) refuse_it(folder / name, "is a link");
}

void take_folder(const fs::path& folder, bool over_others) {
  const fs::path mark = folder / ".oddity";
  const std::string text = "What oddity writes into this folder takes the place of what was there.\n";
  require_writable(mark);
  try {
    if (read_whole(mark) == text) return;
  } catch (const BadInput&) {  // the mark is missing
  }
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename(); !over_others && !name.starts_with(".oddity"))
      throw BadInput(folder.string() + " holds files that are not of oddity, such as " + name +
                     ": name a new folder, or write over them by --overwrite");
  write_whole(mark, text);
}

PassingFolder::PassingFolder() {
  std::error_code missing;
  const fs::path folder = fs::temp_directory_path(missing);
  if (missing) throw BadInput("there is no folder for temporary files: TMPDIR names none");
  std::string name = (folder / "oddity_XXXXXX").string();
  if (!mkdtemp(name.data())) refuse_folder(name, last_failure());
  path_ = name;
}

PassingFolder::~PassingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace oddity
