#pragma once

#include "chapters/03_rigid_body_motion/shared/height_field_models.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrange.hpp"

namespace oddity::height_field {

/// The Lagrangian of a unit point mass on a surface, from the height alone.
template <class Surface, class G = double>
struct Lagrangian {
  Surface surface;
  G g;

  template <class T>
  T operator()(const Two<T>& q, const Two<T>& v) const {
    const Dual<T> height = surface.height(Dual<T>(q[0], v[0]), Dual<T>(q[1], v[1]));
    return T(0.5) * (v[0] * v[0] + v[1] * v[1] + height.slope * height.slope) - T(g) * height.value;
  }
};

}  // namespace oddity::height_field
