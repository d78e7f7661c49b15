#include "chapters/claims.hpp"

#include <numbers>

#include "chapters/05_fluids_and_gases/03_inverse_square_field/inverse_square_field.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"

namespace oddity::ex05_03 {

namespace {

using namespace fields;

/// A point at any distance from the origin, a rotated frame, and the exponent of the decay of a field's
/// slopes.
struct Away {
  Point x;
  Frame frame;
  double power;

  Letters<double> table() { return {{R"(\mathbf x)", x}}; }
  double size() const { return std::pow(length(x), -power); }
  TypesetLetters typeset() const { return {{"x_0", x[0]}, {"x_1", x[1]}, {"x_2", x[2]}}; }
  std::string where() const { return R"($|\mathbf x|$ = )" + format_shortest(length(x)); }
  /// The derivatives of the components by their own coordinates, summed over the frame.
  Point own_slopes() const {
    Point slopes{};
    for (const Point& u : frame) {
      const Point along_u = along(inverse_square, x, u);
      for (std::size_t i = 0; i < 3; ++i) slopes[i] += u[i] * along_u[i];
    }
    return slopes;
  }
};

/// Points whose size is between 1/range and range.
std::vector<Away> samples(Random random, double range, double power = 3) {
  std::vector<Away> all;
  for (int n = 0; n < 256; ++n) {
    const double r = std::abs(random.magnitude(1 / range, range));
    const Point u = random.direction();
    all.push_back({{r * u[0], r * u[1], r * u[2]}, random_frame(random), power});
  }
  return all;
}

const Formula<Away> differentiated{"dual numbers along a turned frame", &Away::own_slopes};

/// The three summed derivatives: by x0 of x_i / |x|^3, by x1 of x_1 / |x|^3, by x2 of x_2 / |x|^3.
Check summands(std::size_t i, const Random& random) {
  return compare<Away>("the derivatives that make up the divergence",
                       {"the three that are printed, $x_i$ being $x_" + std::to_string(i) + "$",
                        [=](const Away& a) {
                          const Matrix<double> d = jacobian(inverse_square, a.x);
                          return Value{d[i][0], d[1][1], d[2][2]};
                        }},
                       differentiated, samples(random, 1e30));
}

/// Checks that the divergence of x / |x|^power is zero.
Check divergence_is_zero(const std::string& field, const std::function<double(const Away&)>& of,
                         const std::vector<Away>& all) {
  return compare<Away>(R"($\nabla\cdot()" + field + ")$", {"dual numbers along a turned frame", of},
                       {"zero", [](const Away&) { return 0.0; }}, all);
}
Reading divergence_of_power(int power, const Random& random) {
  const std::string field = R"(\mathbf x/|\mathbf x|^)" + std::to_string(power);
  const auto of = [=](const Away& a) {
    const auto along_x = [=](const auto& x) {
      using std::pow;
      const auto scale = pow(dot(x, x), -power / 2.0);
      return std::array{x[0] * scale, x[1] * scale, x[2] * scale};
    };
    return divergence(along_x, a.frame)(a.x);
  };
  return {R"($\nabla\cdot()" + field + ")=0$ where it is defined",
          {divergence_is_zero(field, of, samples(random, 1e40, power))}};
}

/// A point with whole coordinates.
struct Whole {
  Triple<long> x;
  explicit Whole(Random& random) {
    for (long& i : x) i = random.below(2000001) - 1000000;
  }
  TypesetLetters typeset() const {
    const std::vector<double> all(x.begin(), x.end());
    return {{R"(\mathbf x)", all}, {"x_0", all[0]}, {"x_1", all[1]}, {"x_2", all[2]}};
  }
  /// Whether the brackets |x|^2 - factor x_i^2 add up to zero.
  bool cancels(long factor) const { return sum_of_brackets(x, factor) == 0; }
};

}  // namespace

std::vector<Claim> claims(const Random& random, const Reference& truth) {
  Claims claims("5.3");
  const auto derivatives = [&](const char* slug, int line, const char* says, double range,
                               const std::string& formula) {
    claims.over(samples(random, range))(slug, line, says, differentiated, {formula},
                                        R"($\partial(x_i/|\mathbf x|^3)/\partial x_i$, $i=0,1,2$)");
  };
  derivatives(
      "quotient_rule", 3135,
      R"($\partial(x_i/|\mathbf x|^3)/\partial x_i=(|\mathbf x|^3-3x_i^2|\mathbf x|)/|\mathbf x|^6$ by the quotient rule)",
      1e45, R"($(|\mathbf x|^3-3x_i^2|\mathbf x|)/|\mathbf x|^6$)");
  derivatives(
      "simplified", 3173,
      R"($\partial(x_i/|\mathbf x|^3)/\partial x_i=(|\mathbf x|^2-3x_i^2)/|\mathbf x|^5$, a factor $|\mathbf x|$ being canceled)",
      1e55, R"($(|\mathbf x|^2-3x_i^2)/|\mathbf x|^5$)");
  const Point at{0.3, -0.7, 0.9};
  Matrix<double> d = jacobian(inverse_square, at);
  for (Point& row : d)
    for (double& x : row) x *= std::pow(length(at), 3);
  claims.add(
      "divergence", 3191,
      R"($\nabla\cdot(\mathbf x/|\mathbf x|^3)=\sum_i\partial(x_i/|\mathbf x|^3)/\partial x_i$, printed with $x_i$ for $x_0$ in the first derivative)",
      {.printed = {R"($\partial(x_i/|\mathbf x|^3)/\partial x_0$, for any $i$)",
                   {summands(0, random), summands(1, random), summands(2, random)}},
       .meant = {R"($\partial(x_i/|\mathbf x|^3)/\partial x_0$ for $i=0$)", {summands(0, random)}},
       .near_misses = {{R"($\partial(x_i/|\mathbf x|^3)/\partial x_0$ for $i=1$)", {summands(1, random)}}},
       .why = filled(
           R"(The first derivative is printed of $x_i/|\mathbf x|^3$, whose index occurs nowhere else and is )"
           R"(not summed. It must be $x_0$, as in the next line. At the point $(@1,@1,@1)$, )"
           R"(times $|\mathbf x|^3$, the three derivatives are $@4$, $@4$ and $@4$, which add up to zero. )"
           R"(With $x_1$ for $x_i$ the first is $@4$ and the sum $@4$.)",
           {at[0], at[1], at[2], d[0][0], d[1][1], d[2][2], d[1][0], d[1][0] + d[1][1] + d[2][2]}),
       .kind = Fault::formula});
  derivatives(
      "common_denominator", 3239,
      R"($\nabla\cdot(\mathbf x/|\mathbf x|^3)=\sum_i(|\mathbf x|^2-3x_i^2)/|\mathbf x|^5$ over the common denominator )"
      "(our check: summand by summand, as the sum is zero)",
      1e55, R"($(|\mathbf x|^2-3x_0^2,\ |\mathbf x|^2-3x_1^2,\ |\mathbf x|^2-3x_2^2)/|\mathbf x|^5$)");
  Random digits = random;
  std::vector<Whole> whole;
  for (int n = 0; n < 1000; ++n) whole.emplace_back(digits);
  claims.statement<Whole>(
      "numerator", 3267, R"($\sum_i(|\mathbf x|^2-3x_i^2)=0$)", whole,
      {.printed = {R"($\sum_i(|\mathbf x|^2-3x_i^2)=0$)", [](const Whole& x) { return x.cancels(3); }},
       .near_misses = {
           {R"($\sum_i(|\mathbf x|^2-2x_i^2)=0$)", [](const Whole& x) { return x.cancels(2); }}}});

  const Known flux = truth("05_03_spheroid_flux", {1.5, 1.5, 0.375});
  const Route around{flux.source, flux.value};
  const Check zero = divergence_is_zero(
      R"(\mathbf x/|\mathbf x|^3)", [](const Away& a) { return divergence(inverse_square, a.frame)(a.x); },
      samples(random, 1e60));
  claims.add("zero", 3267,
             R"($\nabla\cdot(\mathbf x/|\mathbf x|^3)=0$ (our condition: where the field is defined))",
             {.printed = {R"($\nabla\cdot(\mathbf x/|\mathbf x|^3)=0$ where it is defined)", {zero}},
              .near_misses = {
                  divergence_of_power(2, random),
                  divergence_of_power(4, random),
                  {"and at the origin too: a sphere around it has no flux",
                   {Check{"flux through a sphere", around, {"zero", 0.0}, {1e-10, "ten decimals"}, 1}}}}});

  const double all_around = 4 * std::numbers::pi;
  const auto out_of_a_ball = [&](const char* text, double said) {
    const Route over_ball{"the divergence over the ball", said};
    return Reading{
        text,
        {Check{"flux out of a ball around the origin", over_ball, around, rounding(all_around), all_around}}};
  };
  Reading corrected = out_of_a_ball(R"(zero but at the origin: a flux of $4\pi$ around it)", all_around);
  corrected.checks.push_back(zero);
  claims.add("origin", 3267, R"($\nabla\cdot(\mathbf x/|\mathbf x|^3)=0$, no point being left out)",
             {.printed = out_of_a_ball("zero everywhere: no flux out of any ball", 0),
              .corrected = corrected,
              .in_view = {R"(for $\mathbf x\ne0$)", {zero}},
              .near_misses = {out_of_a_ball(R"(a flux of $2\pi$)", all_around / 2)},
              .why = filled(
                  R"(At $\mathbf x=0$ the text divides by zero, so its lines do not hold at that )"
                  R"(point. It matters: $4\pi=@5$ flows out of every sphere around the origin, however )"
                  R"(small, so that the divergence is $4\pi\delta(\mathbf x)$, and Gauss's theorem with a )"
                  R"(divergence of zero gives 0.)",
                  {all_around}),
              .root = "the origin"});
  return claims.in_order();
}

std::vector<Root> roots() {
  return {
      {"the origin",
       filled(R"(A field that is put together from its sources, as smoke or gravity is, would have none. )"
              R"(Nothing would flow out of the sphere around a source, where $4\pi=@5$ should, whatever its )"
              R"(radius.)",
              {4 * std::numbers::pi})}};
}

}  // namespace oddity::ex05_03
