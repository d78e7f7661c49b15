// Exercise 7.5: u + v + w = 0 makes u x v = v x w = w x u, the triangle's normal, as long as twice its area.
// The lines of the proof are checked in whole numbers, exactly, each for vectors as general as it allows; the
// area comes from the lengths of the sides alone, 16 area^2 = 2(a^2 b^2 + b^2 c^2 + c^2 a^2) - a^4 - b^4 -
// c^4 (Heron), in which no cross product occurs. Kahan, Miscalculating area and angles of a needle-like
// triangle.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "chapters/07_linear_algebra/05_triangle_normal/triangles.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace ex07_05 {

using namespace triangle_normals;

/// Whole numbers of 128 bits.
__extension__ typedef __int128 Whole;

constexpr Parameter parameters[] = {
    {"d", 1e8, "", "distance of the flat triangle from the origin", 0, 1e10},
    {"h", 1e-3, "", "height of the flat triangle over a base of about one", 1e-8, 1},
    {"s", 1e-10, "", "short side of the needle, the others about one", 1e-15, 1},
    {"seed", 1, "", "seed of the random vectors", 0, 1e9, whole_number},
};

// ---- the claims -------------------------------------------------------------------------------------------

struct Sample {
  Vector u, v, w;
};

/// Whole numbers of all sizes up to a million, every tenth v nearly parallel to u; w closes the triangle or
/// is random.
std::vector<Sample> samples(Random random, bool closed) {
  std::vector<Sample> all;
  const auto vector = [&] {
    const double size = std::round(std::abs(random.magnitude(1, 1e6)));
    Vector x;
    for (double& component : x) component = std::round(random.between(-size, size));
    return x;
  };
  for (int i = 0; i < 300; ++i) {
    Sample s{vector(), vector(), vector()};
    if (i % 10 == 9) s.v = Vector{1 - s.u[0], -s.u[1], 2 - s.u[2]};
    if (closed) s.w = -(s.u + s.v);
    all.push_back(s);
  }
  return all;
}

std::string shown(const Vector& x) {
  return "(" + shortest(x[0]) + ", " + shortest(x[1]) + ", " + shortest(x[2]) + ")";
}

using Expression = std::function<Vector(const Sample&)>;

/// Two vectors over all samples, exactly.
Reading equal(std::string text, const std::vector<Sample>& all, const std::string& left,
              const Expression& one, const std::string& right, const Expression& other) {
  Worst worst(left + " and " + right, left, right);
  for (const Sample& s : all)
    worst.see(one(s), other(s), exact(), 1 + dot(s.u, s.u) + dot(s.v, s.v) + dot(s.w, s.w),
              shown(s.u) + ", " + shown(s.v));
  return {std::move(text), {worst.check()}};
}

Claim claim(std::string id, int line, std::string says, Reading printed, Reading near_miss) {
  Claim c{std::move(id), line, std::move(says)};
  c.printed = std::move(printed);
  c.near_misses = {std::move(near_miss)};
  return c;
}

Vector zero(const Sample&) { return {0, 0, 0}; }
Vector sum(const Sample& s) { return s.u + s.v + s.w; }
Vector expanded(const Sample& s) { return cross(s.u, s.u) + cross(s.u, s.v) + cross(s.u, s.w); }
Vector normal(const Sample& s) { return cross(s.u, s.v); }

/// The three vectors of a sample as the vertices of a triangle, and the walk around it.
Claim closed_walk(const std::vector<Sample>& vertices) {
  const auto sum = [](const Sample& s) { return ((s.v - s.u) + (s.w - s.v)) + (s.u - s.w); };
  const auto walked = [](const Sample& s) {
    return Vector{length(s.v - s.u) + length(s.w - s.v) + length(s.u - s.w), 0, 0};
  };
  Claim c = claim("7.5-closed_walk", 3853,
                  "once around a triangle the net distance traveled, that is the displacement, is zero",
                  equal("(Q - P) + (R - Q) + (P - R) = 0", vertices, "sum of the edges", sum, "0", zero),
                  equal(
                      "the last edge backwards", vertices, "(Q - P) + (R - Q) + (R - P)",
                      [](auto& s) { return ((s.v - s.u) + (s.w - s.v)) + (s.w - s.u); }, "0", zero));
  c.near_misses.push_back(
      equal("the distance that is walked", vertices, "length of the three edges", walked, "0", zero));
  return c;
}

/// Whether u and v are independent, by their Gram determinant in whole numbers.
bool independent(const Sample& s) {
  const auto u = cast<Whole>(s.u), v = cast<Whole>(s.v);
  return dot(u, u) * dot(v, v) != dot(u, v) * dot(u, v);
}

/// Three vectors with the sum zero, every tenth three of them on a line: those without a normal.
Claim triangle(const std::vector<Sample>& closed) {
  const auto normals = [&](std::string text, const auto& chosen) {
    long without = 0, samples = 0;
    for (std::size_t i = 0; i < closed.size(); ++i) {
      Sample s = closed[i];
      if (i % 10 == 0) s.v = (i % 20 == 0 ? 2.0 : 0.0) * s.u, s.w = -(s.u + s.v);
      if (!chosen(s)) continue;
      ++samples, without += normal(s) == Vector{};
    }
    return Reading{std::move(text), {never("triples without a normal vector", without, samples)}};
  };
  Claim c{"7.5-triangle", 3853, "vectors with the sum zero are edges of a triangle, u x v its normal vector"};
  c.printed = normals("u + v + w = 0", [](const Sample&) { return true; });
  c.corrected = normals("u + v + w = 0, u and v not parallel", independent);
  c.near_misses = {normals("u + v + w = 0, none of them zero", [](const Sample& s) {
    return s.u != Vector{} && s.v != Vector{} && s.w != Vector{};
  })};
  c.why =
      "Three vectors on one line, $u=(1,0,0)$, $v=(2,0,0)$, $w=(-3,0,0)$, have the sum zero as well: all "
      "three "
      "products are 0. The triangle is flat, lies in many planes, and its unit normal is $0/0$. That the "
      "products are equal, and their length twice the area, holds there too.";
  return c;
}

std::vector<Claim> lines(const std::vector<Sample>& open, const std::vector<Sample>& closed) {
  Claim inserted{"7.5-inserted", 3841, "u x 0 is u x (u + v + w)"};
  inserted.printed = equal(
      "0 = u x (u + x v + w): with a cross and no plus", closed, "u x (u x v + w)",
      [](auto& s) { return cross(s.u, cross(s.u, s.v) + s.w); }, "0", zero);
  inserted.meant = equal(
      "0 = u x (u + v + w)", closed, "u x (u + v + w)", [](auto& s) { return cross(s.u, sum(s)); }, "0",
      zero);
  inserted.near_misses = {equal(
      "0 = u x (u + v - w)", closed, "u x (u + v - w)", [](auto& s) { return cross(s.u, s.u + s.v - s.w); },
      "0", zero)};
  inserted.why =
      "A stray cross stands before $v$ inside the bracket; the next line expands $u\\times(u+v+w)$. Read "
      "as it stands, with $u=(1,0,0)$, $v=(0,1,0)$ and $w=(-1,-1,0)$, it is $(0,-1,-1)$ and not 0.";

  Claim reduced{"7.5-reduced", 3845, "u x u + u x v + u x w is 0 + u x v - w x u"};
  reduced.printed = equal("0 + u x v - w x v", open, "u x u + u x v + u x w", expanded, "0 + u x v - w x v",
                          [](auto& s) { return cross(s.u, s.v) - cross(s.w, s.v); });
  reduced.meant = equal("0 + u x v - w x u", open, "u x u + u x v + u x w", expanded, "0 + u x v - w x u",
                        [](auto& s) { return cross(s.u, s.v) - cross(s.w, s.u); });
  reduced.near_misses = {equal("0 + u x v + w x u", open, "u x u + u x v + u x w", expanded,
                               "0 + u x v + w x u",
                               [](auto& s) { return cross(s.u, s.v) + cross(s.w, s.u); })};
  reduced.why =
      "$u\\times w=-w\\times u$, not $-w\\times v$: with $u+v+w=0$ the printed line is $2\\,u\\times v$, and "
      "not zero. The next line has $w\\times u$.";

  return {
      claim("7.5-zero", 3839, "u x 0 is 0",
            equal(
                "u x 0 = 0", open, "u x 0", [](auto& s) { return cross(s.u, zero(s)); }, "0", zero),
            equal(
                "u x 0 = u", open, "u x 0", [](auto& s) { return cross(s.u, zero(s)); }, "u",
                [](auto& s) { return s.u; })),
      inserted,
      claim("7.5-expanded", 3843, "u x (u + v + w) is u x u + u x v + u x w",
            equal(
                "u x u + u x v + u x w", open, "u x (u + v + w)", [](auto& s) { return cross(s.u, sum(s)); },
                "u x u + u x v + u x w", expanded),
            equal(
                "u x u + u x v + w x u", open, "u x (u + v + w)", [](auto& s) { return cross(s.u, sum(s)); },
                "u x u + u x v + w x u", [](auto& s) { return cross(s.u, s.v) + cross(s.w, s.u); })),
      reduced,
      claim(
          "7.5-first_pair", 3847, "u x v = w x u",
          equal("u x v = w x u", closed, "u x v", normal, "w x u", [](auto& s) { return cross(s.w, s.u); }),
          equal("u x v = u x w", closed, "u x v", normal, "u x w", [](auto& s) { return cross(s.u, s.w); })),
      claim(
          "7.5-second_pair", 3851, "u x v = v x w",
          equal("u x v = v x w", closed, "u x v", normal, "v x w", [](auto& s) { return cross(s.v, s.w); }),
          equal("u x v = w x v", closed, "u x v", normal, "w x v", [](auto& s) { return cross(s.w, s.v); })),
      closed_walk(open)};
}

/// Two whole numbers over all samples, exactly: compared in two halves of 52 bits.
Reading same(std::string text, const std::vector<Sample>& all, const std::string& left,
             const std::string& right, const auto& one, const auto& other) {
  const auto halves = [](Whole x) {
    constexpr Whole base = Whole{1} << 52;
    return Value{static_cast<double>(x / base), static_cast<double>(x % base)};
  };
  Worst worst(left + " and " + right + ", in halves of 52 bits", left, right);
  for (const Sample& s : all) {
    const auto u = cast<Whole>(s.u), v = cast<Whole>(s.v), w = cast<Whole>(s.w);
    worst.see(halves(one(u, v, w)), halves(other(u, v, w)), exact(), 0x1p53, shown(s.u) + ", " + shown(s.v));
  }
  return {std::move(text), {worst.check()}};
}

std::vector<Claim> geometry(const std::vector<Sample>& open, const std::vector<Sample>& closed) {
  const auto none = [](auto&...) { return Whole{0}; };
  const auto volume = [](auto& u, auto& v, auto& w) { return triple(u, v, w); };
  const auto out_of_perpendicular = [](auto& u, auto& v, auto& w) {
    const auto n = cross(u, v);
    return dot(n, u) * dot(n, u) + dot(n, v) * dot(n, v) + dot(n, w) * dot(n, w);
  };
  const auto length = [](auto& u, auto& v, auto&) { return dot(cross(u, v), cross(u, v)); };
  const auto others = [](auto& u, auto& v, auto& w) {
    return dot(cross(w, v), cross(v, w)) + dot(cross(u, w), cross(w, u)) + 3 * dot(cross(u, v), cross(u, v));
  };
  const auto sixteen_areas = [](auto& u, auto& v, auto& w) {
    const Whole a = dot(u, u), b = dot(v, v), c = dot(w, w);
    return 2 * (a * b + b * c + c * a) - a * a - b * b - c * c;
  };
  const std::string heron = "16 area^2 by Heron";
  std::vector<Claim> all{
      claim("7.5-plane", 3853, "the three vectors lie in a plane",
            same("u . v x w = 0", closed, "u . v x w", "0", volume, none),
            same("for any u, v, w", open, "u . v x w", "0", volume, none)),
      claim("7.5-any_two_edges", 3853,
            "any two of the edges give a normal vector, of the same length (in the order of the walk)",
            {"perpendicular to all edges, the same length by every two",
             {same("", closed, "sum of (u x v . edge)^2", "0", out_of_perpendicular, none).checks[0],
              same("", closed, "|u x v|^2 from w x v, u x w, u x v", "|u x v|^2", others, length).checks[0]}},
            same("for any u, v, w", open, "sum of (u x v . edge)^2", "0", out_of_perpendicular, none)),
      claim("7.5-twice_area", 3853, "the normal is twice as long as the area",
            same(
                "4 |u x v|^2 = 16 area^2", closed, "4 |u x v|^2", heron,
                [=](auto&... x) { return 4 * length(x...); }, sixteen_areas),
            same(
                "16 |u x v|^2 = 16 area^2", closed, "16 |u x v|^2", heron,
                [=](auto&... x) { return 16 * length(x...); }, sixteen_areas))};
  all[1].near_misses.push_back(equal("in either order the same vector", closed, "u x v", normal, "v x u",
                                     [](auto& s) { return cross(s.v, s.u); }));
  all.push_back(triangle(closed));
  return all;
}

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  const auto open = samples(random, false), closed = samples(random, true);
  std::vector<Claim> claims = lines(open, closed);
  for (Claim& c : geometry(open, closed)) claims.push_back(std::move(c));

  Quantity far = normal_of("flat_far_away", "normal of a flat triangle far from the origin",
                           flat(p["d"], p["h"]), truth);
  far.add(
      Breakdown{"P x Q + Q x R + R x P cancels terms of size d^2 down to h. The differences of the vertices "
                "are exact, and their product is as good as the vertices.",
                "vertices, P x Q + Q x R + R x P", 53, Outcome::diverged, "edges, u x v", 53});
  Quantity thin = normal_of("needle", "normal of a triangle with one short side", needle(p["s"]), truth);
  thin.add(
      Breakdown{"The three products are equal, but not equally good: that of the two long sides cancels "
                "terms of size one down to s. Take the short side.",
                "edges, w x u", 53, Outcome::inaccurate, "edges, v x w", 53});
  return {claims, {far, thin, twice_area(flat(1, 1e-6), truth)}};
}

}  // namespace ex07_05

Exercise exercise_7_5() {
  using namespace ex07_05;
  return {"Three equal cross products",
          "Show that $u+v+w=0$ implies $u\\times v=v\\times w=w\\times u$, and say what this means for a "
          "triangle with these edges.",
          parameters,
          {},
          study};
}

}  // namespace oddity
