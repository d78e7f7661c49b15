// The claims of exercise 2.15, on random systems of particles: the text's sums checked by the definition. The
// lines before the last hold for any point, so they are checked at a random one, where no term is zero.

#include "chapters/particle_sums.hpp"

#include "chapters/02_basic_concepts/15_transfer_theorem/transfer_theorem.hpp"

namespace oddity::transfer_theorem {

namespace {

constexpr std::array axes{"x", "y", "z"};
/// Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
constexpr std::array<std::string_view, 6> names{"xx", "yy", "zz", "xy", "xz", "yz"};

template <class T>
struct ParticleOf {
  T m;
  std::array<T, 3> r;
};

/// Particles, and a point A in place of their center of mass. Recorded for Coq there is one particle, and a
/// sum is over any number of them.
template <class T>
struct SampleOf {
  std::vector<ParticleOf<T>> particles;
  std::array<T, 3> A{};

  /// The sum of m f(r).
  template <class F>
  T sum(const F& f) const {
    T all(0.0);
    for (const auto& [m, r] : particles) all += m * T(f(r));
    if constexpr (std::same_as<T, Shortened>)
      return Expression::letter("(total l (fun m x y z => " + all.expression().coq() + "))");
    else
      return all;
  }
  T mass() const {
    return sum([](const auto&) { return 1.0; });
  }
  T inertia(std::size_t k, const std::array<T, 3>& about) const {
    return sum([&](const auto& r) { return inertia_component<T>(k, r - about); });
  }
  std::vector<T*> letters() {
    std::vector<T*> all{&A[0], &A[1], &A[2]};
    for (auto& [m, r] : particles) all.insert(all.end(), {&m, &r[0], &r[1], &r[2]});
    return all;
  }
  TypesetIn<T> typeset() const {
    TypesetIn<T> all{{"m", mass()}};
    for (std::size_t k = 0; k < 6; ++k) all.emplace_back("I_{" + std::string(names[k]) + "}'", inertia(k, A));
    for (std::size_t k = 0; k < 3; ++k) all.emplace_back("c_" + std::string(axes[k]), A[k]);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const std::string index = "_{" + std::to_string(i + 1) + "}";
      all.emplace_back("m" + index, particles[i].m);
      for (std::size_t k = 0; k < 3; ++k) {
        all.emplace_back(axes[k] + index, particles[i].r[k]);
        all.emplace_back(axes[k] + index + "'", particles[i].r[k] - A[k]);
      }
    }
    return all;
  }
  std::string where() const { return std::to_string(particles.size()) + " particles, $A$ = " + shown(A); }
};
using Sample = SampleOf<double>;
using Sum = ProvableFormula<SampleOf>;
Sum sum_of(const std::string& text) { return over_particles<SampleOf>(text, "m x y z"); }

/// Systems with A at their center, and with A at any point.
struct Samples {
  std::vector<Sample> center, any_point;

  Samples() = default;
  explicit Samples(double seed) {
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      Sample system;
      const Vector offset = random.point(20);
      for (int n = 0; n < 6; ++n)
        system.particles.push_back({std::abs(random.magnitude(0.05, 20)), offset + random.point(5)});
      system.A = center_by_lever_rule(system.particles);
      center.push_back(system);
      system.A = system.A + random.point(10);
      any_point.push_back(system);
    }
  }
};

/// The claims, with their proofs' formulas.
struct Table {
  struct Line {
    std::string slug;
    bool at_center;
    ProvableClaim<SampleOf> claim;
  };
  Claims& claims;
  Samples samples = {};
  std::vector<Line> lines = {};

  void add(const std::string& slug, int line, const std::string& says, bool at_center,
           const ProvableClaim<SampleOf>& claim) {
    ProvableClaims<SampleOf>(claims).formula(slug, line, says, at_center ? samples.center : samples.any_point,
                                             claim);
    lines.push_back({slug, at_center, claim});
  }
};

/// The components about the origin by their definition.
Sum definition(const std::vector<std::size_t>& which) {
  return {
      R"($\sum m_i\,\mathbf r_i\times(\mathbf w\times\mathbf r_i)$, the angular momentum of a turn $\mathbf w$)",
      [=]<class T>(const SampleOf<T>& s) {
        std::vector<T> all;
        for (const std::size_t k : which) all.push_back(s.inertia(k, {}));
        return all;
      }};
}

/// Claims lines that state their formula.
auto lines(Table& table, const std::string& quantity, const Sum& truth) {
  return [&table, quantity, truth](const std::string& slug, int line, const std::string& text,
                                   bool at_center = false, const std::string& ours = "") {
    table.add(slug, line, text + ours, at_center,
              {.quantity = quantity, .truth = truth, .printed = sum_of(text)});
  };
}

void moments_of_inertia(Table& table) {
  const auto ixx = lines(table, "$I_{xx}$", definition({0}));
  ixx("ixx", 747, R"($I_{xx}=\sum m_i(y_i^2+z_i^2)$)");
  ixx("ixx_shifted", 751, R"($I_{xx}=\sum m_i\bigl((y_i'+c_y)^2+(z_i'+c_z)^2\bigr)$)");
  ixx("ixx_split", 753, R"($I_{xx}=\sum m_i(y_i'^2+z_i'^2)+\sum m_i(2y_i'c_y+c_y^2+2z_i'c_z+c_z^2)$)");
  ixx("ixx_collected", 759, R"($I_{xx}=I_{xx}'+2c_y\sum m_iy_i'+2c_z\sum m_iz_i'+(c_y^2+c_z^2)\sum m_i$)",
      false, R"( (we write $I_{xx}'$ for the first sum, $\sum m_i(y_i'^2+z_i'^2)$).)");
  ixx("ixx_transfer", 769, "$I_{xx}=I_{xx}'+m(c_y^2+c_z^2)$", true);
}

void products_of_inertia(Table& table) {
  const Sum truth = definition({3});
  const auto ixy = lines(table, "$I_{xy}$", truth);
  ixy("ixy", 779, R"($I_{xy}=\sum m_ix_iy_i$)");
  ixy("ixy_shifted", 781, R"($I_{xy}=\sum m_i(x_i'+c_x)(y_i'+c_y)$)");
  const std::string massless = R"($I_{xy}=\sum x_i'y_i')", with_mass = R"($I_{xy}=\sum m_ix_i'y_i')";
  constexpr double mass = 2, place = 1;
  const auto of_pair = [](const std::string& text) {
    const Sample pair{{{mass, {place, place, 0}}, {mass, {-place, -place, 0}}}};
    return TypesetFormula(text + "$")(pair.typeset())[0];
  };
  const auto without_mass = [&](const std::string& slug, int line, const std::string& rest) {
    table.add(
        slug, line, massless + rest, false,
        {.quantity = "$I_{xy}$",
         .truth = truth,
         .printed = sum_of(massless + rest),
         .meant = sum_of(with_mass + rest),
         .kind = Fault::formula,
         .why = filled(
             "The mass $m_i$ is left out of the first sum, $\\sum m_i\\,x'_iy'_i$, of lines 783 and "
             "787; lines 779 and 781, before them, include it. As printed the sum has another "
             "unit: for two masses of @1 kg at $\\pm(@1,@1)$ m it is @1, where $I_{xy}$ is @1 kg m$^2$.",
             {mass, place, place, of_pair(massless), of_pair(with_mass)})});
  };
  without_mass("ixy_split", 783, R"(+\sum m_i(c_xy_i'+c_yx_i'+c_xc_y)$)");
  without_mass("ixy_collected", 787, R"(+c_x\sum m_iy_i'+c_y\sum m_ix_i'+c_xc_y\sum m_i$)");
  ixy("ixy_transfer", 795, "$I_{xy}=I_{xy}'+mc_xc_y$", true);
}

void about_center(Table& table) {
  const auto vanish = [&](const std::string& slug, int line, const std::string& says,
                          const std::string& text) {
    table.add(slug, line, says, true,
              {.truth = {"zero", [](const auto&) { return 0.0; }},
               .printed = sum_of(text),
               .changes_that_hold = "each sum is zero, and so is a multiple of it"});
  };
  vanish(
      "first_moments", 771,
      R"(The first moments about the center of mass are zero: $\sum m_iy_i'=\sum m_i(y_i-c_y)=0$ (our check: for $x$ and $z$ as well).)",
      R"($\sum m_i(x_i-c_x,\ y_i-c_y,\ z_i-c_z)=0$)");
  vanish("middle_terms", 771,
         R"(The middle two terms of $I_{xx}$, $2c_y\sum m_iy_i'$ and $2c_z\sum m_iz_i'$, are zero.)",
         R"($(2c_y\sum m_iy_i',\ 2c_z\sum m_iz_i')=0$)");
  vanish("middle_terms_again", 797,
         R"(The middle two terms of $I_{xy}$, $c_x\sum m_iy_i'$ and $c_y\sum m_ix_i'$, are zero.)",
         R"($(c_x\sum m_iy_i',\ c_y\sum m_ix_i')=0$)");
  table.add(
      "others", 799,
      "The other components are handled in the same manner (our formulas): $I_{yy}=I_{yy}'+m(c_x^2+c_z^2)$, "
      "$I_{zz}=I_{zz}'+m(c_x^2+c_y^2)$, $I_{xz}=I_{xz}'+mc_xc_z$, $I_{yz}=I_{yz}'+mc_yc_z$.",
      true,
      {.quantity = "$I_{yy}$, $I_{zz}$, $I_{xz}$, $I_{yz}$",
       .truth = definition({1, 2, 4, 5}),
       .printed = sum_of(R"($(I_{yy}'+m(c_x^2+c_z^2),\ I_{zz}'+m(c_x^2+c_y^2),\ I_{xz}'+mc_xc_z,\ )"
                         R"(I_{yz}'+mc_yc_z)$)")});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("2.15");
  Table table{claims, Samples(seed)};
  for (auto* section : {about_center, moments_of_inertia, products_of_inertia}) section(table);
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

Provables proofs() {
  const auto letter = Shortened::letter;
  SampleOf<Shortened> any{{{letter("m"), {letter("x"), letter("y"), letter("z")}}}};
  any.A = {letter("c0"), letter("c1"), letter("c2")};
  std::vector<Proposition> center;
  for (std::size_t i = 0; i < 3; ++i)
    center.push_back(any.sum([i](const auto& r) { return r[i]; }).expression() ==
                     (any.A[i] * any.mass()).expression());
  Claims claims("2.15");
  Table table{claims};
  for (auto* section : {about_center, moments_of_inertia, products_of_inertia}) section(table);
  Provables proved;
  for (const auto& [slug, at_center, claim] : table.lines) {
    const bool meant = !claim.meant.text.empty();
    Expressions stated = (meant ? claim.meant : claim.printed).recorded(any),
                truth = claim.truth.recorded(any);
    in_a_row(stated, truth);
    Lemma lemma{meant ? "meant" : "printed",
                "(l : list (R * R * R * R)) (c0 c1 c2 : R)",
                {},
                equal(stated, truth),
                "by_particles l"};
    if (at_center) lemma.given = center, lemma.tactic = "by_center l c0 c1 c2 H H0 H1";
    proved.push_back({"2.15-" + slug,
                      at_center ? "it holds of any number of particles about their center of mass"
                                : "it is the component of any number of particles, about any point",
                      {lemma},
                      0,
                      coq_source({"totals"})});
  }
  return proved;
}

}  // namespace oddity::transfer_theorem
