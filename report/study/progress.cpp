#include "report/study/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

#include "reference/text.hpp"

namespace oddity {

namespace {

using namespace std::chrono_literals;

constexpr auto short_enough = 2s;

std::string shown(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  return whole < 120 ? std::to_string(whole) + " s" : std::to_string((whole + 59) / 60) + " min";
}

}  // namespace

ProgressBar::ProgressBar()
    : screen_(screen_of(STDERR_FILENO)), terminal_(screen_.width > 0), clock_([this] { watch(); }) {}

ProgressBar::~ProgressBar() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  over_.notify_all();
  clock_.join();
  wipe();
}

Progress ProgressBar::callback() {
  return [this](const std::string& stage, double done, std::size_t all) { advance(stage, done, all); };
}

void ProgressBar::advance(const std::string& stage, double done, std::size_t all) {
  const std::lock_guard lock(mutex_);
  if (stage != stage_) begun_ = Clock::now();
  stage_ = stage;
  done_ = done;
  all_ = all;
}

void ProgressBar::watch() {
  const std::chrono::milliseconds interval = terminal_ ? 500ms : 10s;
  std::unique_lock lock(mutex_);
  while (!over_.wait_for(lock, interval, [this] { return is_over_; }))
    if (!stage_.empty() && Clock::now() - begun_ >= short_enough) show();
}

std::string ProgressBar::line() const {
  const double passed = std::chrono::duration<double>(Clock::now() - begun_).count();
  const double left = passed * (static_cast<double>(all_) / done_ - 1);
  return "oddity: " + stage_ + ", " + format_significant(std::floor(done_), 9) + " of " +
         std::to_string(all_) +
         (done_ > 0 ? ", about " + shown(left) + " left" : ", " + shown(passed) + " so far");
}

void ProgressBar::show() {
  const std::string text = terminal_ ? cut(line(), screen_.width - 1) : line();
  wipe();
  std::cerr << text << (terminal_ ? "" : "\n") << std::flush;
  if (terminal_) written_ = columns_of(text);
}

void ProgressBar::wipe() {
  if (written_ > 0) std::cerr << '\r' << std::string(written_, ' ') << '\r' << std::flush;
  written_ = 0;
}

}  // namespace oddity
