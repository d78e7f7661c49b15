#pragma once

#include <algorithm>
#include <limits>

#include "reference/make/checkpoints.hpp"
#include "reference/make/extrapolation.hpp"

/// A box of half sides a and b slides and turns on a rough level plane with friction mu and uniform pressure,
/// by two routes. Both stretch the time as dt = speed ds: rest is then approached exponentially, and never
/// reached. Inputs: a, b, mu, g and the initial velocities u, v, w.
namespace oddity::truth::rough_box {

struct Box {
  std::vector<double> inputs;
  Number a, b, mu_g, u, v, w;
  explicit Box(const std::vector<double>& in)
      : inputs(in), a(in[0]), b(in[1]), mu_g(Number(in[2]) * Number(in[3])), u(in[4]), v(in[5]), w(in[6]) {}
  Number inertia() const { return (a * a + b * b) / 3; }
};

/// When the instantaneous center crosses an edge, the friction has a singularity of the kind k^2 log k. The
/// steps shrink towards it and grow again, and every digit costs many of them. So a table has 31 digits, and
/// a value computed on demand 15. Both routes have similar errors there, larger than their difference. So the
/// second one works to two digits less, and their disagreement bounds the first one's error.
inline Precision worked_to(Precision asked) {
  return {asked.digits > spot_digits ? 31 : std::min(asked.digits, 15), asked.kept};
}

/// The integral of the distance from a point along an edge at the distance k, from y1 to y2.
inline Number along_edge(const Number& k, const Number& y1, const Number& y2) {
  const Number r1 = sqrt(k * k + y1 * y1), r2 = sqrt(k * k + y2 * y2);
  const Number twice = y2 * r2 - y1 * r1;
  const auto above = [&](const Number& y, const Number& r) -> Number {
    return y < 0 ? Number(k * k / (r - y)) : Number(r + y);
  };
  return (k == 0 ? twice : Number(twice + k * k * log(above(y2, r2) / above(y1, r1)))) / 2;
}

struct Node {
  Number at, weight;
};

/// Those of Gauss and Legendre on [-1, 1], by Newton's method.
inline std::vector<Node> gauss_nodes(int n) {
  const Number pi = acos(Number(-1));
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    Number x = cos(Number(pi * (i + Number(3) / 4) / (n + Number(1) / 2))), slope = 0;
    for (int tries = 0; tries < 8; ++tries) {
      Number before = 1, p = x;
      for (int k = 2; k <= n; ++k) {
        const Number next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    nodes.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

/// Means for a far centre, by Gauss's nodes: at a distance of eight boxes their error is 10^-19.
inline Numbers means_by_nodes(const Box& box, const Number& u, const Number& v, const Number& w) {
  static const std::vector<Node> nodes = gauss_nodes(8);
  Number x_mean = 0, y_mean = 0, moment = 0;
  for (const Node& i : nodes)
    for (const Node& j : nodes) {
      const Number x = box.a * i.at, y = box.b * j.at, p = u - w * y, q = v + w * x,
                   part = i.weight * j.weight / (4 * sqrt(p * p + q * q));
      x_mean += part * p;
      y_mean += part * q;
      moment += part * (x * q - y * p);
    }
  return {x_mean, y_mean, moment};
}

/// The means over the box of the unit velocity and of its moment, in the box's axes.
inline Numbers unit_means(const Box& box, const Number& u, const Number& v, const Number& w) {
  // Closed, they lose as many digits as the square of that distance has, which long double feels at once.
  const Number speed = sqrt(u * u + v * v), far = (working_digits > 30 ? 1e8 : 8) * (box.a + box.b);
  if (w == 0) return {u / speed, v / speed, 0};
  if (speed > far * abs(w)) return means_by_nodes(box, u, v, w);
  const Number cx = -v / w, cy = u / w;
  const Number right = box.a - cx, left = -box.a - cx, top = box.b - cy, bottom = -box.b - cy;
  const Number on_right = along_edge(right, bottom, top), on_left = along_edge(left, bottom, top);
  const Number on_top = along_edge(top, left, right), on_bottom = along_edge(bottom, left, right);
  const Number x = on_right - on_left, y = on_top - on_bottom;
  const Number r = (right * on_right - left * on_left + top * on_top - bottom * on_bottom) / 3;
  const Number over = (w > 0 ? Number(1) : Number(-1)) / (4 * box.a * box.b);
  return {-over * y, over * x, over * (r + cx * x + cy * y)};
}

/// Integrates until rest, or until the component `clock` of x, the time, reaches t. The speed falls at least
/// as fast as exp(-0.85 mu g s). The pieces are cached, and so short that the first steps tried stay finite.
/// Newton's method finds the length of the last piece; it converges from below, as the speed falls.
template <class Rhs>
Numbers until(const Number& t, const Rhs& rhs, const Numbers& start, std::size_t clock, const Box& box,
              Precision digits, Checkpoints& kept) {
  constexpr std::size_t pieces = 16;
  const Number piece = (digits + 2) * 3 / box.mu_g / pieces;
  std::vector<double> motion = box.inputs;
  motion.push_back(digits);
  const auto at_piece = [&](std::size_t k) {
    return kept.state(
        k, motion, [&] { return start; },
        [&](const Numbers& x, std::size_t i) {
          return solve_extrapolation(rhs, x, Number(static_cast<double>(i - 1) * piece),
                                     Number(static_cast<double>(i) * piece), digits);
        });
  };
  Numbers x = start;
  for (std::size_t k = 1; k <= pieces; ++k) {
    const Numbers next = at_piece(k);
    if (next[clock] > t) {
      const Number close =
          std::max<Number>(pow(Number(10), -digits - 4), 8 * t * std::numeric_limits<Number>::epsilon());
      for (Number left = t - x[clock]; left > close; left = t - x[clock])
        x = solve_extrapolation(rhs, x, 0, Number(left / rhs(x, 0)[clock]), digits);
      return x;
    }
    x = next;
  }
  return x;
}

/// Displacement along the initial velocity, for a box that does not turn.
inline Numbers slid(const Box& box, const Number& time, const Number& speed, const Number& distance) {
  if (speed == 0) return {time, 0, 0, 0};
  return {time, box.u / speed * distance, box.v / speed * distance, 0};
}

/// A box that starts without rotation slides straight. It slows down by mu g, and its path is the mean of the
/// first and the last speed times the time.
inline Numbers slid_by_mean_speed(const Box& box, const Number& t) {
  const Number speed = sqrt(box.u * box.u + box.v * box.v);
  const Number time = std::min<Number>(t, speed / box.mu_g);
  return slid(box, time, speed, (speed + (speed - box.mu_g * time)) / 2 * time);
}

/// Its motion by energy: the path is the loss of half the squared speed, over mu g.
inline Numbers slid_by_energy(const Box& box, const Number& t) {
  const Number speed = sqrt(box.u * box.u + box.v * box.v), later = speed - box.mu_g * t;
  if (later <= 0) return slid(box, speed / box.mu_g, speed, speed * speed / (2 * box.mu_g));
  return slid(box, t, speed, (speed * speed - later * later) / (2 * box.mu_g));
}

/// (t, x, y, theta), with velocities in space.
inline Numbers velocity_in_space(const std::vector<double>& in, const Number& t, Precision digits) {
  static Checkpoints kept;
  const Box box(in);
  if (box.w == 0) return slid_by_mean_speed(box, t);
  const Number J = box.inertia();
  const auto rhs = [&](const Numbers& x, const Number&) {
    const Number C = cos(x[2]), S = sin(x[2]);
    const Numbers e = unit_means(box, C * x[3] + S * x[4], C * x[4] - S * x[3], x[5]);
    const Number speed = sqrt(x[3] * x[3] + x[4] * x[4] + J * x[5] * x[5]), slow = -box.mu_g * speed;
    return Numbers{speed * x[3],
                   speed * x[4],
                   speed * x[5],
                   slow * (C * e[0] - S * e[1]),
                   slow * (S * e[0] + C * e[1]),
                   slow * e[2] / J,
                   speed};
  };
  const Numbers x = until(t, rhs, {Number(0), 0, 0, box.u, box.v, box.w, 0}, 6, box, worked_to(digits), kept);
  return {x[6], x[0], x[1], x[2]};
}

/// (t, x, y, theta), with scaled velocities along the box's axes, (u, v, w) = speed (p, q, r), and the
/// logarithm of the speed.
inline Numbers velocity_in_the_box(const std::vector<double>& in, const Number& t, Precision digits) {
  static Checkpoints kept;
  const Box box(in);
  if (box.w == 0) return slid_by_energy(box, t);
  const Number J = box.inertia();
  const Number speed0 = sqrt(box.u * box.u + box.v * box.v + J * box.w * box.w);
  const auto rhs = [&](const Numbers& x, const Number&) {
    const Number &p = x[3], &q = x[4], &r = x[5];
    const Number speed = exp(x[6]), C = cos(x[2]), S = sin(x[2]);
    const Numbers e = unit_means(box, p, q, r);
    const Number norm = p * p + q * q + J * r * r;  // 1; dividing by it keeps it so
    const Number loss = box.mu_g * (e[0] * p + e[1] * q + e[2] * r) / norm;
    const Number turn = speed * speed;
    return Numbers{speed * speed * (C * p - S * q),
                   speed * speed * (S * p + C * q),
                   turn * r,
                   turn * r * q - box.mu_g * e[0] + loss * p,
                   -turn * r * p - box.mu_g * e[1] + loss * q,
                   -box.mu_g * e[2] / J + loss * r,
                   -loss,
                   speed};
  };
  const Numbers x =
      until(t, rhs, {Number(0), 0, 0, box.u / speed0, box.v / speed0, box.w / speed0, log(speed0), 0}, 7, box,
            worked_to(digits) - 2, kept);
  return {x[7], x[0], x[1], x[2]};
}

}  // namespace oddity::truth::rough_box
