#include "reference/enclosures/disc.hpp"

#include <acb.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace oddity::truth {

namespace {

constexpr slong coarse = 64;  ///< precision in bits
/// Exceeds the rounding of a few operations in doubles.
constexpr double upwards = 1 + 0x1p-48;

struct Box {
  acb_t z;
  Box() { acb_init(z); }
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;
  ~Box() { acb_clear(z); }

  /// Set to all complex numbers within the distance of x.
  void set(const Number& x, double distance) {
    acb_set_arb(z, x.data());
    acb_set_round(z, z, coarse);
    arf_t by;
    arf_init(by);
    arf_set_d(by, distance);
    acb_add_error_arf(z, by);
    arf_clear(by);
  }
  double greatest_size() const {
    mag_t size;
    mag_init(size);
    acb_get_mag(size, z);
    const double all = from_above(size);
    mag_clear(size);
    return all;
  }
};

using Op = Tape::Op;

/// The right-hand side over boxes.
class Picard {
 public:
  Picard(const Recorded& problem, const Numbers& x0, const Number& t0)
      : problem_(problem), x0_(x0), t0_(t0), boxes_(problem.tape.nodes().size()) {}

  /// Bounds on the derivatives' sizes over |x - x0| <= reach, |t - t0| <= radius; none if the right-hand side
  /// may not be analytic there.
  std::optional<std::vector<double>> speeds(const std::vector<double>& reach, double radius) {
    for (std::size_t i = 0; i < x0_.size(); ++i) at(problem_.unknowns[i]).set(x0_[i], reach[i]);
    at(problem_.time).set(t0_, radius);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (!evaluate(i)) return {};
    std::vector<double> all;
    for (int derivative : problem_.derivatives) all.push_back(at(derivative).greatest_size());
    return all;
  }

 private:
  Box& at(int node) { return boxes_[static_cast<std::size_t>(node)]; }
  bool evaluate(std::size_t i);

  const Recorded& problem_;
  const Numbers& x0_;
  const Number& t0_;
  std::vector<Box> boxes_;
};

bool Picard::evaluate(std::size_t i) {
  const Tape::Node& node = problem_.tape.nodes()[i];
  const auto value = [&] { return boxes_[i].z; };
  const auto a = [&] { return at(node.a).z; };
  const auto b = [&] { return at(node.b).z; };
  switch (node.op) {
    case Op::variable:
      return true;
    case Op::constant:
      acb_set_arb(value(), node.constant.data());
      return true;
    case Op::add:
      acb_add(value(), a(), b(), coarse);
      return true;
    case Op::subtract:
      acb_sub(value(), a(), b(), coarse);
      return true;
    case Op::scale:
      acb_mul_arb(value(), a(), node.constant.data(), coarse);
      return true;
    case Op::multiply:
      acb_mul(value(), a(), b(), coarse);
      return true;
    case Op::divide:
      acb_div(value(), a(), b(), coarse);
      return !acb_contains_zero(b()) && acb_is_finite(value());
    case Op::square_root:
      acb_sqrt(value(), a(), coarse);
      return arb_is_positive(acb_realref(a())) != 0;
    case Op::sine:
      acb_sin(value(), a(), coarse);
      return acb_is_finite(value()) != 0;
    case Op::cosine:
      acb_cos(value(), a(), coarse);
      return acb_is_finite(value()) != 0;
    case Op::exponential:
      acb_exp(value(), a(), coarse);
      return acb_is_finite(value()) != 0;
  }
  return false;
}

/// The set reached after a further stride by motions that stay within `from` up to the radius. Picard's
/// operator maps it into itself, along every ray.
std::optional<std::vector<double>> after(Picard& picard, const std::vector<double>& from, double radius,
                                         double stride) {
  std::vector<double> guess = from;
  for (int tries = 0; tries < 10; ++tries) {
    const auto speeds = picard.speeds(guess, radius + stride);
    if (!speeds) return {};
    std::vector<double> image = from;
    bool inside = true;
    for (std::size_t i = 0; i < from.size(); ++i) {
      image[i] = (from[i] + stride * (*speeds)[i]) * upwards;
      if (!std::isfinite(image[i])) return {};
      inside = inside && image[i] <= guess[i];
    }
    if (inside) return image;
    for (std::size_t i = 0; i < from.size(); ++i)
      guess[i] = std::max(guess[i], image[i] + (image[i] - from[i]) / 16);
  }
  return {};
}

double largest(const std::vector<double>& all) { return *std::ranges::max_element(all); }

}  // namespace

double Disc::step(const std::vector<Limit>& limits) const {
  double part = 0.5;
  for (const Limit& limit : limits)
    part = std::min(part, std::pow(limit.tolerance / largest(reach), 1.0 / (limit.order + 1)));
  return 0.99 * part * radius;
}

double Disc::remainder(std::size_t unknown, double h, int order) const {
  const double q = h / radius * upwards;
  return reach[unknown] * std::pow(q, order + 1) / (1 - q) * (1 + 0x1p-30);
}

Disc disc_about(const Recorded& problem, const Numbers& x0, const Number& t0, double apart,
                const std::vector<Limit>& limits, double guess) {
  Picard picard(problem, x0, t0);
  Disc best, disc{0, std::vector<double>(x0.size(), apart)};
  double stride = guess / 16;
  for (int k = 0; k < 200; ++k) {
    const auto reach = after(picard, disc.reach, disc.radius, stride);
    if (reach) {
      disc = {(disc.radius + stride) / upwards, *reach};
      if (best.radius == 0 || disc.step(limits) > best.step(limits))
        best = disc;
      else
        break;
      continue;
    }
    if (disc.radius > 0 && stride < disc.radius / 30) break;
    stride /= 2;
  }
  if (best.radius == 0) throw Undecided("Picard's operator finds no disc on which the motion is analytic");
  return best;
}

}  // namespace oddity::truth
