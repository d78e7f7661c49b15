#include "reference/enclosures/motion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "solvers/stop.hpp"

namespace oddity::truth {

namespace {

/// Reduces the bits for numbers that are only as large as the enclosure is wide.
struct FewerBits {
  slong all = Ball::bits;
  FewerBits() { Ball::bits = 128; }
  FewerBits(const FewerBits&) = delete;
  FewerBits& operator=(const FewerBits&) = delete;
  ~FewerBits() { Ball::bits = all; }
};

/// Order of the slopes' series, if the states are close together.
constexpr int order_of_slopes(int order) { return 8 + order / 6; }
constexpr double largest_error_of_slopes = 1e-3;
constexpr long most_strides = 300'000;

double largest_size(const Numbers& x) {
  double size = 0;
  for (const Number& component : x) size = std::max(size, greatest_size(component));
  return size == 0 ? 1 : size;
}

/// A ball about zero.
Number up_to(double size) { return within(Number(0), Number(size)); }

int order_of(const Numbers& series) { return static_cast<int>(series.size()) - 1; }

Number sum(const Numbers& series, const Number& h) {
  Number sum = series.back();
  for (std::size_t k = series.size() - 1; k-- > 0;) sum = sum * h + series[k];
  return sum;
}

}  // namespace

bool Stride::holds(const Number& t) const { return std::abs(middle_of(t - from)) <= std::abs(length); }

Numbers Stride::image(const Number& t) const {
  const Number h = t - from;
  const double distance = greatest_size(h);
  Numbers x;
  for (std::size_t i = 0; i < center.size(); ++i)
    x.push_back(sum(center[i], h) + up_to(disc.remainder(i, distance, order_of(center[i]))));
  return x;
}

/// The disc also bounds the slopes of the remainder of the center's polynomial, beyond the order of the
/// slopes' series.
Rows Stride::slopes_at(const Number& t) const {
  const FewerBits few;
  const Number h = t - from;
  const double distance = greatest_size(h);
  Rows all(slopes.size());
  for (std::size_t i = 0; i < slopes.size(); ++i)
    for (const Numbers& series : slopes[i])
      all[i].push_back(sum(series, h) +
                       up_to(disc.remainder(i, distance, order_of(series)) / (apart / 2) * (1 + 0x1p-12)));
  return all;
}

std::vector<std::vector<Numbers>> TaylorProblem::slopes(const Numbers& hull, const Number& t,
                                                        int order) const {
  const std::size_t n = hull.size();
  std::vector<std::vector<Numbers>> all(n, std::vector<Numbers>(n));
  for (std::size_t j = 0; j < n; ++j) {
    Numbers start = hull;
    start.resize(2 * n);
    start[n + j] = 1;
    slopes_.expand(start, t, order);
    const std::vector<Numbers> series = slopes_.series();
    for (std::size_t i = 0; i < n; ++i) all[i][j] = series[n + i];
  }
  return all;
}

/// x(t + h) = P(x(t)) + R(x(t)), with the Taylor polynomial P. P is taken in its mean value form; R is
/// bounded by the disc on which all motions from near the center are analytic.
Stride TaylorProblem::stride(const Parallelepiped& states, const Number& t, const Number& t1, int digits,
                             double& radius) const {
  check_stop();
  const int order = 2 * digits, slope_order = order_of_slopes(order);
  const Numbers &center = states.center(), hull = states.hull();
  const double size = largest_size(center), apart = size * 0x1p-18;
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (!(greatest_size(hull[i] - center[i]) <= apart / 2)) throw Undecided("the enclosure becomes too wide");
  const std::vector<Limit> limits{{order, size * std::pow(10, -digits)},
                                  {slope_order, largest_error_of_slopes * apart / 2}};
  const double left = middle_of(t1 - t);
  Disc disc = disc_about(motion_, center, t, apart, limits, radius == 0 ? std::abs(left) : radius);
  radius = disc.radius;
  const double longest = disc.step(limits);
  if (longest < std::abs(left) * 1e-6) throw Undecided("the steps become too short");
  motion_.expand(center, t, order);
  Stride stride{t, std::copysign(longest, left), std::move(disc), apart, motion_.series(), {}};
  const FewerBits few;
  stride.slopes = slopes(hull, t, slope_order);
  return stride;
}

namespace {

bool same(const Numbers& a, const Numbers& b) {
  return std::ranges::equal(
      a, b, [](const Number& x, const Number& y) { return arb_equal(x.data(), y.data()) != 0; });
}

bool same(const Recorded& a, const Recorded& b) {
  return a.derivatives == b.derivatives &&
         std::ranges::equal(a.tape.nodes(), b.tape.nodes(), [](const Tape::Node& m, const Tape::Node& n) {
           return m.op == n.op && m.a == n.a && m.b == n.b && arb_equal(m.constant.data(), n.constant.data());
         });
}

}  // namespace

bool TaylorProblem::operator==(const TaylorProblem& other) const {
  return same(motion_, other.motion_) && same(slopes_, other.slopes_);
}

bool Followed::leads_to(const TaylorProblem& problem, const Numbers& x0, const Number& t0,
                        const Number& t1) const {
  const Number from = stride_ ? stride_->from : t0_;
  const double ahead = middle_of(t1 - from);
  return bits_ == Ball::bits && same(x0_, x0) && same({t0_}, {t0}) &&
         (!stride_ || stride_->length * ahead >= 0) && problem_ == problem;
}

void Followed::follow_to(const Number& t) {
  const Numbers image = stride_->image(t);
  const FewerBits few;
  states_.map(image, stride_->slopes_at(t));
}

Numbers Followed::at(const Number& t1) {
  if (arb_equal(t1.data(), t0_.data())) return x0_;
  if (!stride_) stride_ = problem_.stride(states_, t0_, t1, digits_, radius_);
  for (long strides = 0; !stride_->holds(t1); ++strides) {
    if (strides == most_strides) throw Undecided("too many steps");
    const Number end = stride_->from + Number(stride_->length);
    follow_to(end);
    stride_ = problem_.stride(states_, end, t1, digits_, radius_);
  }
  return states_.hull_of_image(stride_->image(t1), stride_->slopes_at(t1));
}

Numbers TaylorProblem::solve(const Numbers& x, const Number& t0, const Number& t1, int digits) const {
  return Followed(*this, x, t0, digits).at(t1);
}

Numbers enclosed_motion(const TaylorProblem& problem, const Numbers& x0, const Number& t0, const Number& t1,
                        int digits) {
  thread_local std::map<int, Followed> all;  // the latest motion for each number of digits
  auto found = all.find(digits);
  if (found != all.end() && !found->second.leads_to(problem, x0, t0, t1)) {
    all.erase(found);
    found = all.end();
  }
  if (found == all.end()) found = all.emplace(digits, Followed(problem, x0, t0, digits)).first;
  return found->second.at(t1);
}

}  // namespace oddity::truth
