#include "report/study/progress.hpp"

#include <unistd.h>

#include <algorithm>
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

void Pace::come_to(double done, double now) {
  constexpr double apart = 0.01;  // s, so that few are kept
  if (!reports_.empty() && done <= reports_.back().done) return;
  if (reports_.size() > 1 && now - reports_.end()[-2].time < apart)
    reports_.back() = {now, done};
  else
    reports_.push_back({now, done});
}

double Pace::done_at(double time) const {
  const auto after = std::ranges::upper_bound(reports_, time, {}, &Told::time);
  return after == reports_.begin() ? 0 : after[-1].done;
}

std::string Pace::line(double all, double now) const {
  const double done = done_at(now);
  bool is_even = done > 0 && done < all;
  for (int quarter = 1; quarter <= 4; ++quarter) {
    const double share = 4 * (done_at(quarter * now / 4) - done_at((quarter - 1) * now / 4)) / done;
    is_even = is_even && share >= 0.5 && share <= 2;
  }
  return format_significant(std::floor(done), 9) + " of " + format_significant(all, 9) +
         (is_even ? ", about " + shown((all - done) * now / done) + " left" : ", " + shown(now) + " so far");
}

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
  const bool was_over = done_ >= static_cast<double>(all_);
  if (stage != stage_ || all != all_ || (was_over && done < done_)) {
    begun_ = Clock::now();
    pace_ = {};
    done_ = 0;
  }
  stage_ = stage;
  all_ = all;
  done_ = std::max(done_, done);
  pace_.come_to(done_, passed());
}

double ProgressBar::passed() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }

void ProgressBar::watch() {
  const std::chrono::milliseconds interval = terminal_ ? 500ms : 10s;
  std::unique_lock lock(mutex_);
  while (!over_.wait_for(lock, interval, [this] { return is_over_; }))
    if (!stage_.empty() && Clock::now() - begun_ >= short_enough) show();
}

std::string ProgressBar::line() const {
  return "oddity: " + stage_ + ", " + pace_.line(static_cast<double>(all_), passed());
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
