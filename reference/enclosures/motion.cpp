#include "reference/enclosures/motion.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/enclosures/disc.hpp"

namespace oddity::truth {

namespace {

/// What is only as large as the enclosure is wide needs few bits.
struct FewerBits {
  slong all = Ball::bits;
  FewerBits() { Ball::bits = 128; }
  FewerBits(const FewerBits&) = delete;
  FewerBits& operator=(const FewerBits&) = delete;
  ~FewerBits() { Ball::bits = all; }
};

constexpr int order_of_slopes = 22;
constexpr double largest_error_of_slopes = 1e-3;
constexpr long most_steps = 300'000;

double largest_size(const Numbers& x) {
  double size = 0;
  for (const Number& component : x) size = std::max(size, greatest_size(component));
  return size == 0 ? 1 : size;
}

/// A ball about zero.
Number up_to(double size) { return within(Number(0), Number(size)); }

}  // namespace

void Recorded::expand(const Numbers& x, const Number& t, int order) {
  tape.resize(order);
  for (std::size_t i = 0; i < x.size(); ++i) tape.set(unknowns[i], 0, x[i]);
  tape.set(time, 0, t);
  tape.set(time, 1, 1);
  for (int k = 0; k < order; ++k) {
    tape.advance(k);
    for (std::size_t i = 0; i < x.size(); ++i)
      tape.set(unknowns[i], k + 1, tape.get(derivatives[i], k) / (k + 1));
  }
}

Numbers Recorded::at(const Number& h) const {
  Numbers x;
  for (int unknown : unknowns) {
    const Numbers& c = tape.series(unknown);
    Number sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) sum = sum * h + c[k];
    x.push_back(sum);
  }
  return x;
}

/// Of the polynomials of the order of the slopes, by the starts in the hull: row i, column j is d x_i / d
/// x_j.
Rows TaylorProblem::slopes(const Numbers& hull, const Number& t, const Number& h) const {
  const std::size_t n = hull.size();
  Rows all(n, Numbers(n));
  for (std::size_t j = 0; j < n; ++j) {
    Numbers start = hull;
    start.resize(2 * n);
    start[n + j] = 1;
    slopes_.expand(start, t, order_of_slopes);
    const Numbers end = slopes_.at(h);
    for (std::size_t i = 0; i < n; ++i) all[i][j] = end[n + i];
  }
  return all;
}

/// x(t + h) = P(x(t)) + R(x(t)), P the Taylor polynomial. P is taken by its mean value form; R is bounded by
/// the disc on which all motions from near the center are analytic, and so are R's slopes, beyond the order
/// to which those of P are computed.
Number TaylorProblem::step(Parallelepiped& states, const Number& t, const Number& t1, int digits,
                           double& radius) const {
  const int order = 2 * digits;
  const Numbers center = states.center(), hull = states.hull();
  const double size = largest_size(center), apart = size * 0x1p-18;
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (!(greatest_size(hull[i] - center[i]) <= apart / 2)) throw Undecided("the enclosure becomes too wide");
  const std::vector<Limit> limits{{order, size * std::pow(10, -digits)},
                                  {order_of_slopes, largest_error_of_slopes * apart / 2}};
  const Disc disc = disc_about(motion_, center, t, apart, limits, radius);
  radius = disc.radius;
  const double longest = disc.step(limits), left = middle_of(t1 - t);
  if (longest < std::abs(left) * 1e-6) throw Undecided("the steps become too short");
  const bool last = std::abs(left) <= longest;
  const Number end = last ? t1 : t + Number(std::copysign(longest, left)), h = end - t;
  const double length = greatest_size(h);

  motion_.expand(center, t, order);
  Numbers image = motion_.at(h);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] += up_to(disc.remainder(i, length, order));

  const FewerBits few;
  Rows slope = slopes(hull, t, h);
  for (std::size_t i = 0; i < slope.size(); ++i)
    for (Number& entry : slope[i])
      entry += up_to(disc.remainder(i, length, order_of_slopes) / (apart / 2) * 1.0001);
  states.map(image, slope);
  return end;
}

Numbers TaylorProblem::solve(const Numbers& x, const Number& t0, const Number& t1, int digits) const {
  Parallelepiped states(x);
  Number t = t0;
  double radius = std::abs(middle_of(t1 - t0));
  for (long steps = 0; !arb_equal(t.data(), t1.data()); ++steps) {
    if (steps == most_steps) throw Undecided("too many steps");
    t = step(states, t, t1, digits, radius);
  }
  return states.hull();
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

/// A motion as far as it has been followed; of each number of digits the last one is kept.
struct Followed {
  TaylorProblem problem;
  Numbers x0;
  Number t0;
  slong bits;
  Parallelepiped states;
  Number t;
  double radius;

  bool leads_to(const TaylorProblem& other, const Numbers& x, const Number& from, const Number& to) const {
    return bits == Ball::bits && same(x0, x) && same({t0}, {from}) && (to - t) * (t - t0) >= 0 &&
           problem == other;
  }
};

}  // namespace

bool TaylorProblem::operator==(const TaylorProblem& other) const {
  return same(motion_, other.motion_) && same(slopes_, other.slopes_);
}

Numbers enclosed_motion(const TaylorProblem& problem, const Numbers& x0, const Number& t0, const Number& t1,
                        int digits) {
  thread_local std::map<int, Followed> all;
  auto found = all.find(digits);
  if (found != all.end() && !found->second.leads_to(problem, x0, t0, t1)) {
    all.erase(found);
    found = all.end();
  }
  if (found == all.end())
    found = all.insert({digits,
                        {problem, x0, t0, Ball::bits, Parallelepiped(x0), t0, std::abs(middle_of(t1 - t0))}})
                .first;
  Followed& motion = found->second;
  for (long steps = 0; !arb_equal(motion.t.data(), t1.data()); ++steps) {
    if (steps == most_steps) throw Undecided("too many steps");
    motion.t = motion.problem.step(motion.states, motion.t, t1, digits, motion.radius);
  }
  return motion.states.hull();
}

}  // namespace oddity::truth
