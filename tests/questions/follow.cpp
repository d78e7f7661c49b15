// Collocation at Gauss's points: on each step the acceleration is a polynomial through its values at the
// points, found by Picard's iteration, velocity first. The last coefficients in Legendre's polynomials
// estimate the remainder uniformly over the step, so that the polynomial is as good at frames as at the ends.

#include "tests/questions/follow.hpp"

#include <chrono>
#include <ctime>
#include <numbers>
#include <span>

namespace questions {

namespace {

constexpr Real never = 1e30L;  ///< larger than any change

/// P_0(x) to P_n(x).
Values legendre(int n, Real x) {
  Values P(static_cast<std::size_t>(n) + 1);
  P[0] = 1;
  if (n > 0) P[1] = x;
  for (int k = 1; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    P[i + 1] = ((2 * k + 1) * x * P[i] - k * P[i - 1]) / (k + 1);
  }
  return P;
}

/// The integrals of P_0(2c - 1) to P_(n-1)(2c - 1) from 0 to c.
Values integrals(int n, Real c) {
  const Values P = legendre(n, 2 * c - 1);
  Values I(static_cast<std::size_t>(n));
  I[0] = c;
  for (std::size_t k = 1; k < I.size(); ++k)
    I[k] = (P[k + 1] - P[k - 1]) / (2 * (2 * static_cast<Real>(k) + 1));
  return I;
}

class Follower {
 public:
  Follower(const Motion& motion, const Way& way)
      : motion_(motion),
        way_(way),
        s_(static_cast<std::size_t>(way.points)),
        n_(motion.q.size()),
        gauss_(way.points) {
    to_modes_.assign(s_, Values(s_));
    A_.assign(s_, Values(s_));
    for (std::size_t j = 0; j < s_; ++j) {
      const Values P = legendre(way.points, 2 * gauss_.at[j] - 1);
      for (std::size_t k = 0; k < s_; ++k)
        to_modes_[k][j] = (2 * static_cast<Real>(k) + 1) * gauss_.weight[j] * P[k];
    }
    for (std::size_t i = 0; i < s_; ++i) {
      const Values I = integrals(way.points, gauss_.at[i]);
      for (std::size_t j = 0; j < s_; ++j)
        for (std::size_t k = 0; k < s_; ++k) A_[i][j] += I[k] * to_modes_[k][j];
    }
    q_ = motion.q;
    v_ = motion.v;
    size_q_.assign(n_, 0);
    size_v_.assign(n_, 0);
    Q_.assign(s_, Values(n_));
    V_ = a_ = Q_;
  }

  std::vector<Values> at(std::span<const double> times) {
    std::vector<Values> seen;
    const std::clock_t begin = std::clock();
    h_ = static_cast<Real>(times.back()) / 64;
    bool rests = q_.empty() || motion_.at_rest(v_.data());
    for (std::size_t i = 0; i < times.size();) {
      if (rests) {
        seen.push_back(look(q_, Values(n_), times[i++]));
        continue;
      }
      if (!step() || static_cast<double>(std::clock() - begin) > way_.seconds * CLOCKS_PER_SEC) break;
      for (; i < times.size() && times[i] <= t_ + taken_; ++i)
        seen.push_back(look(inside((times[i] - t_) / taken_, q_, modes_v_),
                            inside((times[i] - t_) / taken_, v_, modes_a_), times[i]));
      end_step();
      rests = motion_.at_rest(v_.data());
    }
    return seen;
  }

 private:
  /// Finds the polynomials of the next step, and shortens it if needed; false if it would become too short.
  bool step() {
    for (int tries = 0; tries < 200; ++tries) {
      const Real h = h_;
      if (!(h > 1e-17L * (std::abs(t_) + 1e-3L))) return false;
      const Real left_out = solve(h);
      const Real tolerance = way_.tolerance * motion_.tolerance;
      const Real room =
          std::pow(tolerance / std::max(left_out, tolerance * 1e-30L), 1 / static_cast<Real>(s_));
      if (left_out <= tolerance) {
        taken_ = h;
        h_ = h * std::min<Real>(2, std::max<Real>(0.7L, 0.9L * room)) * (iterations_ > 25 ? 0.8L : 1);
        return true;
      }
      h_ = h * (left_out < 1 ? std::min<Real>(0.8L, std::max<Real>(0.3L, 0.9L * room)) : 0.4L);
    }
    return false;
  }

  /// Remainder of the polynomials relative to the motion's size; infinite if Picard's iteration does not end.
  Real solve(Real h) {
    Values acceleration(n_);
    motion_.acceleration(q_.data(), v_.data(), t_, acceleration.data());
    for (std::size_t j = 0; j < s_; ++j)
      for (std::size_t i = 0; i < n_; ++i) {
        const Real c = h * gauss_.at[j];
        V_[j][i] = v_[i] + c * acceleration[i];
        Q_[j][i] = q_[i] + c * (v_[i] + c / 2 * acceleration[i]);
      }
    Real before = never;
    for (iterations_ = 1; iterations_ <= 60; ++iterations_) {
      for (std::size_t j = 0; j < s_; ++j)
        motion_.acceleration(Q_[j].data(), V_[j].data(), t_ + h * gauss_.at[j], a_[j].data());
      Real change = 0;
      for (std::size_t i = 0; i < n_; ++i) {
        change = std::max(change, integrate(a_, v_[i], h, i, V_, size_v_[i]));
        change = std::max(change, integrate(V_, q_[i], h, i, Q_, size_q_[i]));
      }
      if (!(change < never)) return never;
      // to the last bits: smaller than a rounding or two, or no longer falling there
      if (change < 1e-19L || (change < 1e-17L && change > before / 2)) return left_out(h);
      if (iterations_ > 8 && change > before) return never;
      before = change;
    }
    return never;
  }

  /// Integrates component i at the points from its rate. Returns the largest change, relative to its size.
  Real integrate(const std::vector<Values>& rate, Real start, Real h, std::size_t i, std::vector<Values>& x,
                 Real size) const {
    Real change = 0, largest = std::max(size, std::abs(start));
    for (std::size_t j = 0; j < s_; ++j) {
      Real sum = 0;
      for (std::size_t k = 0; k < s_; ++k) sum += A_[j][k] * rate[k][i];
      const Real now = start + h * sum;
      largest = std::max(largest, std::abs(now));
      const Real moved = std::abs(now - x[j][i]);
      if (!(moved < never)) return never;
      change = std::max(change, moved);
      x[j][i] = now;
    }
    return change == 0 ? 0 : change / largest;
  }

  Real left_out(Real h) {
    modes_v_.assign(s_, Values(n_));
    modes_a_ = modes_v_;
    for (std::size_t k = 0; k < s_; ++k)
      for (std::size_t j = 0; j < s_; ++j)
        for (std::size_t i = 0; i < n_; ++i) {
          modes_v_[k][i] += to_modes_[k][j] * V_[j][i];
          modes_a_[k][i] += to_modes_[k][j] * a_[j][i];
        }
    Real most = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      Real q = std::max(size_q_[i], std::abs(q_[i])), v = std::max(size_v_[i], std::abs(v_[i]));
      for (std::size_t j = 0; j < s_; ++j) {
        q = std::max(q, std::abs(Q_[j][i]));
        v = std::max(v, std::abs(V_[j][i]));
      }
      const auto last = [&](const std::vector<Values>& modes) {
        return std::abs(modes[s_ - 1][i]) + std::abs(modes[s_ - 2][i]);
      };
      if (v > 0) most = std::max(most, last(modes_a_) * h / static_cast<Real>(2 * s_) / v);
      if (q > 0) most = std::max(most, last(modes_v_) * h / static_cast<Real>(2 * s_) / q);
    }
    return most;
  }

  /// x at the part `c` of the step, from its rate's modes.
  Values inside(Real c, Values x, const std::vector<Values>& modes) const {
    const Values I = integrals(way_.points, c);
    for (std::size_t k = 0; k < s_; ++k)
      for (std::size_t i = 0; i < n_; ++i) x[i] += taken_ * I[k] * modes[k][i];
    return x;
  }

  /// The observables and, on request, their rates.
  Values look(const Values& q, const Values& v, Real t) const {
    Values seen = motion_.observe(q.data(), t);
    if (!way_.rates) return seen;
    constexpr Real h = 1e-6L;
    const auto moved = [&](Real by) {
      Values x = q;
      for (std::size_t i = 0; i < n_; ++i) x[i] += by * v[i];
      return motion_.observe(x.data(), t + by);
    };
    const Values a = moved(-2 * h), b = moved(-h), c = moved(h), d = moved(2 * h);
    for (std::size_t i = 0; i < a.size(); ++i) seen.push_back((8 * (c[i] - b[i]) - (d[i] - a[i])) / (12 * h));
    return seen;
  }

  void end_step() {
    for (std::size_t j = 0; j < s_; ++j)
      for (std::size_t i = 0; i < n_; ++i) {
        size_q_[i] = std::max(size_q_[i], std::abs(Q_[j][i]));
        size_v_[i] = std::max(size_v_[i], std::abs(V_[j][i]));
      }
    for (std::size_t i = 0; i < n_; ++i) {
      q_[i] += taken_ * modes_v_[0][i];
      v_[i] += taken_ * modes_a_[0][i];
    }
    t_ += taken_;
  }

  const Motion& motion_;
  const Way way_;
  const std::size_t s_, n_;
  const Gauss gauss_;
  std::vector<Values> to_modes_, A_;
  Values q_, v_, size_q_, size_v_;  ///< now, and the largest so far
  std::vector<Values> Q_, V_, a_, modes_v_, modes_a_;
  Real t_ = 0, h_ = 0, taken_ = 0;
  int iterations_ = 0;
};

}  // namespace

Gauss::Gauss(int points) {
  for (int i = points; i-- > 0;) {
    Real x = std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.75L) /
                      (static_cast<Real>(points) + 0.5L));
    Real slope = 1;
    for (int k = 0; k < 9; ++k) {
      const Values P = legendre(points, x);
      const auto n = static_cast<std::size_t>(points);
      slope = static_cast<Real>(points) * (x * P[n] - P[n - 1]) / (x * x - 1);
      x -= P[n] / slope;
    }
    at.push_back((1 + x) / 2);
    weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
}

std::vector<Values> follow(const Motion& motion, std::span<const double> times, const Way& way) {
  return Follower(motion, way).at(times);
}

Truth truth_of(const Motion& motion, std::span<const double> times, double seconds, bool rates) {
  Truth truth{follow(motion, times, {.points = 24, .seconds = seconds, .rates = rates}), {}};
  const auto other = follow(motion, times.first(std::max<std::size_t>(1, truth.frames.size())),
                            {.points = 17, .tolerance = 4, .seconds = 2 * seconds, .rates = rates});
  truth.frames.resize(std::min(truth.frames.size(), other.size()));
  Real most = 0;
  for (std::size_t k = 0; k < truth.frames.size(); ++k) {
    for (std::size_t i = 0; i < other[k].size(); ++i)
      most = std::max(most, std::abs(truth.frames[k][i] - other[k][i]));
    truth.uncertain.push_back(2 * most);
  }
  return truth;
}

}  // namespace questions
