// Exercise 2.13: the six inertia components of the lamina x^2 <= y <= 1, z = 0, of density 1.
//   J w = int r x (w x r) dm;  Ixx = ex . J ex, ..., Ixy = -ex . J ey, ...   the definition
//   int x^p y^q over the lamina = 4 / ((p+1)(p+2q+3)) for p even, 0 for p odd   by rows of constant y.
// The text integrates columns (dy dx). The independent routes integrate rows (dx dy), which use no formula of
// the text: exactly in rational numbers, or numerically from the definition. For the integrands the lamina is
// also cut off at x = left and moved to the height z, so that no component vanishes.

#include "chapters/02_basic_concepts/13_lamina_inertia/lamina_inertia.hpp"
#include "reference/reference.hpp"

namespace oddity {

namespace ex02_13 {

using namespace lamina_inertia;

constexpr Parameter parameters[] = {
    {"left", -1, "", "left end of the lamina; the whole parabola begins at -1", -1, 0.9},
    {"z", 0, "", "height of the lamina's plane", -10, 10},
    {"rho", 1, "", "mass of a unit area", 1e-3, 1e3},
    {"seed", 13, "", "seed of the random samples", 0, 1e9, whole_number},
};

/// Green's theorem: the integral of f is that of Q dy around the boundary, with dQ/dx = f. The top has dy =
/// 0, the parabola dy = 2 x dx.
Integral edge(const Rule& rule, const Lamina& l, std::size_t k) {
  const double corner = l.left * l.left;
  const Integral below = rule([&](double x) { return 2 * x * l.primitive(x, x * x)[k]; }, l.left, 1);
  if (!(corner < 1)) return below;
  return below + rule([&](double y) { return -l.primitive(l.left, y)[k]; }, corner, 1);
}

Quantity inertia(std::string name, std::string says, const Lamina& l, double seed, const Reference& truth) {
  Quantity q = quantity(std::move(name), "", std::move(says), truth("02_13_lamina", {l.left, l.z, l.rho}),
                        {1e-10 * l.rho, "ten decimals for a unit density"});
  const auto component = [l](std::size_t k) { return [l, k](double x, double y) { return l.at(x, y)[k]; }; };
  const Resolution panels = doubling("panels", 2, 7);
  const auto add = [&](const std::string& model, const auto& integrate, const std::string& algorithm,
                       Rule (*rule)(double), const std::string& too_slow = "") {
    const Resolution resolution = algorithm == "Simpson"          ? panels
                                  : algorithm == "Gauss-Legendre" ? doubling("points", 1, 5)
                                                                  : tolerances();
    const auto run = [=](double setting) {
      return all_of(6, [&](std::size_t k) { return integrate(rule(setting), k); });
    };
    q.add(
        {model, algorithm, resolution, run, too_slow.empty() ? Outcome::ok : Outcome::inaccurate, too_slow});
  };
  const auto by_columns = [=](const Rule& rule, std::size_t k) {
    return columns(rule, component(k), l.left);
  };
  const auto by_rows = [=](const Rule& rule, std::size_t k) {
    return rows(rule, component(k), l.left, false);
  };
  const auto by_root = [=](const Rule& rule, std::size_t k) {
    return rows(rule, component(k), l.left, true);
  };
  const auto by_edge = [=](const Rule& rule, std::size_t k) { return edge(rule, l, k); };
  const std::string low_order =
      filled("the error shrinks as $h^4$: too slow for ten decimals at @3 panels", {panels.settings.back()});
  const std::string no_slope = R"(the width of a row, $2\sqrt y$, has no derivative at the vertex)";
  add("columns", by_columns, "QAGS", qags_rule);
  add("columns", by_columns, "CQUAD", cquad_rule);
  add("columns", by_columns, "Gauss-Legendre", gauss_rule);
  add("columns", by_columns, "Simpson", simpson_rule, low_order);
  add("rows", by_rows, "QAGS", qags_rule);
  add("rows", by_rows, "CQUAD", cquad_rule);
  add("rows", by_rows, "Gauss-Legendre", gauss_rule, no_slope);
  add("rows", by_rows, "Simpson", simpson_rule, no_slope);
  add("rows by sqrt(y)", by_root, "Gauss-Legendre", gauss_rule);
  add("edge alone", by_edge, "QAGS", qags_rule);
  add("edge alone", by_edge, "Gauss-Legendre", gauss_rule);
  add("edge alone", by_edge, "Simpson", simpson_rule, low_order);
  add_box_methods<2>(q, {256, 1024, 4096, 16384, 65536}, seed, [l](const std::array<double, 2>& u) {
    const double width = 1 - l.left, x = l.left + width * u[0];
    Six f{};
    if (x * x <= u[1]) f = l.at(x, u[1]);
    for (double& each : f) each *= width;
    return f;
  });
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  Quantity whole = inertia("inertia", "$I_{xx}$, $I_{yy}$, $I_{zz}$, $I_{xy}$, $I_{xz}$, $I_{yz}$",
                           {p["left"], p["z"], p["rho"]}, p["seed"], truth);
  constexpr Lamina lifted{-0.625, 1.5, 1};
  Quantity cut = inertia(
      "cut_inertia", filled("inertia of the lamina cut off at $x=@3$, at $z=@2$", {lifted.left, lifted.z}),
      lifted, p["seed"], truth);
  cut.add(
      Breakdown{"@2 Gauss points, exact for the columns, keep @1 digits by rows: the width of a row, "
                R"($2\sqrt y$, has no derivative at the vertex. Over $u=\sqrt y$ the integrand is a )"
                "polynomial again, and @2 points are exact.",
                "rows, Gauss-Legendre",
                16,
                Outcome::inaccurate,
                "rows by sqrt(y), Gauss-Legendre",
                4,
                {setting_of(Side::broken), digits_of(Side::broken), setting_of(Side::cured)}});
  return {claims(p["seed"]), {whole, cut}};
}

}  // namespace ex02_13

Exercise exercise_2_13() {
  using namespace ex02_13;
  return {"Inertia of a parabolic lamina",
          "Find $I_{xx}, I_{yy}, I_{zz}, I_{xy}, I_{xz}, I_{yz}$ of the flat region $x^2\\le y\\le 1$, "
          "$z=0$, with unit density.",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
