#pragma once

#include "reference/truth.hpp"

namespace oddity::truth {

using Rows = std::vector<Numbers>;

/// States known to be center + axes sides, with balls about zero as sides. As it turns with the flow, it does
/// not swell like a box [Lohner, in: Computer Arithmetic and Self-Validating Numerical Methods, 1990].
class Parallelepiped {
 public:
  explicit Parallelepiped(const Numbers& box);

  const Numbers& center() const { return center_; }
  /// The box around it.
  Numbers hull() const;
  /// The box around its image under a map, given bounds on the map's slopes over the whole set, one row per
  /// unknown.
  Numbers hull_of_image(const Numbers& image_of_center, const Rows& slopes) const;
  /// Replaces the set by that image.
  void map(const Numbers& image_of_center, const Rows& slopes);

 private:
  Numbers center_;
  Rows axes_;
  Numbers sides_;
};

}  // namespace oddity::truth
