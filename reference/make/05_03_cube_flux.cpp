#include "reference/make/routes.hpp"

// The flux through a face at the distance z, over x1..x2 and y1..y2, is a sum over its corners with
// alternating signs. Its terms are atan(x y / (z r)), r = |(x, y, z)|. The second route integrates over x the
// flux density after its integral over y, z y / ((x^2 + z^2) r).
namespace oddity::truth {

namespace cube_flux_05_03 {

/// The sum of `face(z, from, to)` over the six faces: z is the distance along the outward normal, from and to
/// are the face's corners in its plane.
template <class Face>
Number over_faces(const std::vector<double>& in, const Face& face) {
  const Number h = in[0];
  const std::array<Number, 3> c{Number(in[1]), Number(in[2]), Number(in[3])};
  Number sum = 0;
  for (std::size_t n = 0; n < 3; ++n)
    for (int side : {-1, 1}) {
      const Number &x = c[(n + 1) % 3], &y = c[(n + 2) % 3];
      sum += face(Number(h + side * c[n]), std::array<Number, 2>{x - h, y - h},
                  std::array<Number, 2>{x + h, y + h});
    }
  return sum;
}

using Corner = std::array<Number, 2>;

Numbers by_corners(const std::vector<double>& in, int) {
  return {over_faces(in, [](const Number& z, const Corner& from, const Corner& to) {
    const auto angle = [&](const Number& x, const Number& y) {
      return Number(atan(x * y / (z * sqrt(x * x + y * y + z * z))));
    };
    return Number(angle(to[0], to[1]) - angle(from[0], to[1]) - angle(to[0], from[1]) +
                  angle(from[0], from[1]));
  })};
}

Numbers by_quadrature(const std::vector<double>& in, int digits) {
  return {over_faces(in, [&](const Number& z, const Corner& from, const Corner& to) {
    const auto strip = [&](const Number& x) -> Number {
      const auto below = [&](const Number& y) -> Number {
        return z * y / ((x * x + z * z) * sqrt(x * x + y * y + z * z));
      };
      return below(to[1]) - below(from[1]);
    };
    return integral(strip, from[0], to[0], digits);
  })};
}

}  // namespace cube_flux_05_03

Truth truth_05_03_cube_flux() {
  using namespace cube_flux_05_03;
  return {"flux of x / |x|^3 through the cube of half side h around c",
          "surface integral of x.dS / |x|^3",
          {"h", "c0", "c1", "c2"},
          {{"flux", "1"}},
          {{1, 0.25, -0.5, 0.125}, {1, 3, -0.5, 0.125}, {1, 0, 0, 0}},
          "arc tangents at the corners of the faces",
          by_corners,
          "double-exponential quadrature over one coordinate of each face",
          by_quadrature,
          "the first route",
          by_corners};
}

}  // namespace oddity::truth
