#include "report/study/prices.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <thread>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name") || line.starts_with("CPU part")) return line;
  return "processor";
}

/// Identifies the program by its file's metadata: reading all of it takes longer than many an answer.
std::string program_by_file() {
  std::error_code unreadable;
  const fs::path file = fs::read_symlink("/proc/self/exe", unreadable);
  const auto size = fs::file_size(file, unreadable);
  const auto written = fs::last_write_time(file, unreadable).time_since_epoch().count();
  return checksum(file.string() + " " + std::to_string(size) + " " + std::to_string(written));
}

/// A plausible measurement: no run takes less than a picosecond, or was watched for 11 days. A single
/// measurement has no spread.
bool is_price(const Time& time) {
  const bool spread = std::isnan(time.spread) || (time.spread >= 0 && time.spread <= 1e6);
  return time.seconds >= 1e-12 && time.seconds <= 1e6 && spread;
}

bool is_noisy(const Time& time) { return time.spread > time.seconds / 2; }

/// Noise only adds to a time: of several noisy ones the smallest counts.
Time least_noisy(const Price& measure, const Method& method, double setting) {
  constexpr int most = 5;
  Time least = measure(method, setting);
  for (int times = 1; times < most && is_noisy(least); ++times) {
    const Time again = measure(method, setting);
    if (!is_noisy(again) || again.seconds < least.seconds) least = again;
  }
  return least;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
  return cells;
}

std::string text_of(const FrameTimes& frames) {
  std::string times;
  for (const double t : frames.at) times += " " + format_shortest(t);
  return frames.says + ": " + checksum(times);
}

}  // namespace

std::string machine_and_program() {
  static const std::string text = processor() + " x " + std::to_string(std::thread::hardware_concurrency()) +
                                  ", program " + program_by_file();
  return text;
}

std::string price_key(const Task& task, const Need& need) {
  std::string key = to_string(task.entry->number) + " over " + format_shortest(need.horizon) + " at " +
                    format_shortest(need.frames_per_second) + " frames" +
                    (need.frame_times ? ", " + text_of(*need.frame_times) : "") +
                    (need.kicks ? ", kicked at " + need.kicked : "") +
                    (need.bodies == 1 ? "" : " of " + std::to_string(need.bodies) + " bodies");
  for (const Parameter& p : task.parameters.declared())
    key += ", " + std::string(p.name) + " = " + format_shortest(task.parameters[p.name]);
  if (task.entry->number.chapter == 0)
    key += ", " + std::string(task.entry->file);  // a problem's, with its text
  return key + "; " + machine_and_program();
}

KeptPrices::KeptPrices(const fs::path& folder, std::string key, bool fresh, Price measure)
    : file_(folder / (key.substr(0, key.find(' ')) + "_" + checksum(key) + ".txt")),
      key_(std::move(key)),
      fresh_(fresh),
      measure_(std::move(measure)) {
  if (!fresh) prices_ = in_file();
}

/// Reads a line with the key, and one for each price: model, algorithm, setting, seconds, spread. Returns
/// none if any is implausible: then this program did not write the file.
std::map<KeptPrices::Which, Time> KeptPrices::in_file() const {
  std::map<Which, Time> prices;
  const auto text = read_sealed(file_);
  if (!text || !text->starts_with(key_ + "\n")) return prices;
  std::istringstream lines(text->substr(key_.size() + 1));
  for (std::string line; std::getline(lines, line);) {
    const auto cells = cells_of(line);
    if (cells.size() != 5) return {};
    const auto setting = parse_number(cells[2]), seconds = parse_number(cells[3]),
               spread = parse_number(cells[4]);
    if (!setting || !std::isfinite(*setting) || !seconds || !spread || !is_price({*seconds, *spread}))
      return {};
    prices[{cells[0], cells[1], *setting}] = {*seconds, *spread};
  }
  return prices;
}

Time KeptPrices::operator()(const Method& method, double setting) {
  const Which which{method.model, method.algorithm, setting};
  if (const auto kept = prices_.find(which); kept != prices_.end()) {
    found_ = found_ || !measured_.contains(which);
    return kept->second;
  }
  measured_.insert(which);
  return prices_[which] = least_noisy(measure_, method, setting);
}

void KeptPrices::keep() {
  if (measured_.empty()) return;
  // Keeps prices that another run has added meanwhile.
  std::map<Which, Time> all = fresh_ ? std::map<Which, Time>() : in_file();
  all.insert(prices_.begin(), prices_.end());
  std::string text = key_ + "\n";
  for (const auto& [which, time] : all)
    if (is_price(time))
      text += std::get<0>(which) + "\t" + std::get<1>(which) + "\t" + format_shortest(std::get<2>(which)) +
              "\t" + format_shortest(time.seconds) + "\t" + format_shortest(time.spread) + "\n";
  try {
    write_sealed(file_, text);
  } catch (const BadInput&) {  // measured again next time
    cannot_keep_ = true;
  }
}

std::string KeptPrices::source() const {
  if (!found_)
    return "measured in this run on this machine, and " +
           (cannot_keep_ ? "not kept, as " + file_.parent_path().string() + " cannot be written"
                         : std::string("kept for the next"));
  return std::string(measured_.empty() ? "those of" : "in part those of") +
         " an earlier run of this program on this machine; --measure measures them again";
}

}  // namespace oddity
