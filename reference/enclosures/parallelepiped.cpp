#include "reference/enclosures/parallelepiped.hpp"

#include <arb_mat.h>

#include <Eigen/QR>
#include <algorithm>
#include <numeric>

namespace oddity::truth {

namespace {

Numbers product(const Rows& a, const Numbers& x) {
  Numbers y;
  for (const Numbers& row : a)
    y.push_back(Ball::made([&](arb_ptr sum) {
      arb_dot(sum, nullptr, 0, row.front().data(), 1, x.front().data(), 1, static_cast<slong>(x.size()),
              Ball::bits);
    }));
  return y;
}

Rows transposed(const Rows& a) {
  Rows b(a.front().size());
  for (const Numbers& row : a)
    for (std::size_t j = 0; j < row.size(); ++j) b[j].push_back(row[j]);
  return b;
}

Rows product(const Rows& a, const Rows& b) {
  Rows columns;
  for (const Numbers& column : transposed(b)) columns.push_back(product(a, column));
  return transposed(columns);
}

Rows inverse(const Rows& a) {
  const auto n = static_cast<slong>(a.size());
  arb_mat_t m;
  arb_mat_init(m, n, n);
  for (slong i = 0; i < n; ++i)
    for (slong j = 0; j < n; ++j)
      arb_set(arb_mat_entry(m, i, j), a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].data());
  const int regular = arb_mat_inv(m, m, Ball::bits);
  Rows b(a.size(), Numbers(a.size()));
  for (slong i = 0; i < n; ++i)
    for (slong j = 0; j < n; ++j)
      arb_set(b[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].data(), arb_mat_entry(m, i, j));
  arb_mat_clear(m);
  if (!regular) throw Undecided("the axes of a parallelepiped may not be independent");
  return b;
}

/// Orthogonal axes, the first along the longest of the edges. Any axes are valid; these lose little.
Rows square_axes(const Rows& edges, const Numbers& sides) {
  const auto n = static_cast<Eigen::Index>(edges.size());
  Eigen::MatrixXd all(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      all(i, j) = middle_of(edges[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  std::vector<double> lengths;
  for (Eigen::Index j = 0; j < n; ++j)
    lengths.push_back(all.col(j).norm() * greatest_size(sides[static_cast<std::size_t>(j)]));
  std::vector<Eigen::Index> order(edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{},
                           [&](auto j) { return lengths[static_cast<std::size_t>(j)]; });
  Eigen::MatrixXd sorted(n, n);
  for (Eigen::Index j = 0; j < n; ++j) sorted.col(j) = all.col(order[static_cast<std::size_t>(j)]);
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(sorted).householderQ();
  Rows axes(edges.size());
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) axes[static_cast<std::size_t>(i)].push_back(q(i, j));
  return axes;
}

}  // namespace

Parallelepiped::Parallelepiped(const Numbers& box) {
  for (std::size_t i = 0; i < box.size(); ++i) {
    center_.push_back(midpoint(box[i]));
    sides_.push_back(box[i] - center_.back());
    axes_.emplace_back(box.size());
    axes_.back()[i] = 1;
  }
}

Numbers Parallelepiped::hull() const {
  Numbers box = product(axes_, sides_);
  for (std::size_t i = 0; i < box.size(); ++i) box[i] += center_[i];
  return box;
}

Numbers Parallelepiped::hull_of_image(const Numbers& image_of_center, const Rows& slopes) const {
  Numbers box = product(product(slopes, axes_), sides_);
  for (std::size_t i = 0; i < box.size(); ++i) box[i] += image_of_center[i];
  return box;
}

void Parallelepiped::map(const Numbers& image_of_center, const Rows& slopes) {
  const Rows edges = product(slopes, axes_);
  const Rows axes = square_axes(edges, sides_), back = inverse(axes);
  Numbers center, rest;
  for (const Number& x : image_of_center) {
    center.push_back(midpoint(x));
    rest.push_back(x - center.back());
  }
  Numbers sides = product(product(back, edges), sides_);
  const Numbers turned = product(back, rest);
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] += turned[i];
  center_ = std::move(center);
  axes_ = axes;
  sides_ = std::move(sides);
}

}  // namespace oddity::truth
