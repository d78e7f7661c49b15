// The claims of exercise 2.15, on random systems of particles: the text's sums against the definition. The
// lines up to the last are algebra about any point: there they are checked about a random one, where no term
// is zero.

#include "chapters/claims.hpp"
#include "chapters/provable_claims.hpp"

#include "chapters/02_basic_concepts/15_transfer_theorem/transfer_theorem.hpp"

namespace oddity::transfer_theorem {

namespace {

/// Particles, and a point A in the place of their center of mass.
struct Sample {
  System system;
  Vector A;

  /// As seen from A.
  System relative() const {
    System moved = system;
    for (Particle& p : moved) p.r = p.r - A;
    return moved;
  }
  std::vector<double*> letters() {
    std::vector<double*> all{&A[0], &A[1], &A[2]};
    for (Particle& p : system) all.insert(all.end(), {&p.m, &p.r[0], &p.r[1], &p.r[2]});
    return all;
  }
  TypesetLetters typeset() const;
  std::string where() const { return std::to_string(system.size()) + " particles, $A$ = " + shown(A); }
};
using Sum = Formula<Sample>;

/// Systems with A in their center, and with A anywhere.
struct Samples {
  std::vector<Sample> center, any_point;

  explicit Samples(double seed) {
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      System system;
      const Vector offset = random.point(20);
      for (int n = 2 + random.below(10); n > 0; --n)
        system.push_back({std::abs(random.magnitude(0.05, 20)), offset + random.point(5)});
      center.push_back({system, center_by_lever_rule(system)});
      any_point.push_back({system, center.back().A + random.point(10)});
    }
  }
};

/// A value of the system as it is seen from A.
using S = const System&;
using V = const Vector&;
using Of = std::function<Value(S relative, V A)>;
Sum seen(const std::string& text, const Of& of) {
  return {text, [=](const Sample& s) { return of(s.relative(), s.A); }};
}

template <class F>
double sum(S system, const F& f) {
  double all = 0;
  for (const Particle& p : system) all += p.m * f(p.r[0], p.r[1], p.r[2]);
  return all;
}
const auto xy_of = [](const auto& x, const auto& y, const auto&) { return x * y; };
const auto yz_squared = [](const auto&, const auto& y, const auto& z) { return y * y + z * z; };

/// Any number of particles (m, x, y, z), as they are seen from a point, recorded.
struct Recording {
  std::array<Shortened, 3> from{};
};
template <class F>
Shortened sum(const Recording& system, const F& f) {
  std::array<Shortened, 3> r{Shortened::letter("x"), Shortened::letter("y"), Shortened::letter("z")};
  for (std::size_t i = 0; i < 3; ++i) r[i] -= system.from[i];
  const Shortened one = Shortened::letter("m") * Shortened(f(r[0], r[1], r[2]));
  return Expression::letter("(total l (fun m x y z => " + one.expression().coq() + "))");
}
Shortened mass_of(const Recording& system) {
  return sum(system, [](const auto&, const auto&, const auto&) { return 1.0; });
}
std::array<Shortened, 3> first_moments(const Recording& system) {
  return {sum(system, [](const auto& x, const auto&, const auto&) { return x; }),
          sum(system, [](const auto&, const auto& y, const auto&) { return y; }),
          sum(system, [](const auto&, const auto&, const auto& z) { return z; })};
}
Shortened by_definition(std::size_t k, const Recording& system) {
  return sum(system, [k](const auto&... r) { return inertia_component(k, std::array{r...}); });
}

TypesetLetters Sample::typeset() const {
  const System from_A = relative();
  const Six inertia = inertia_about(from_A, {});
  TypesetLetters all{{"m", mass_of(system)}, {"c_x", A[0]},           {"c_y", A[1]},
                     {"c_z", A[2]},          {"I_{xx}'", inertia[0]}, {"I_{xy}'", inertia[3]}};
  const std::array axes{"x", "y", "z"};
  for (std::size_t i = 0; i < system.size(); ++i) {
    const std::string index = "_{" + std::to_string(i + 1) + "}";
    all.emplace_back("m" + index, system[i].m);
    for (std::size_t k = 0; k < 3; ++k) {
      all.emplace_back(axes[k] + index, system[i].r[k]);
      all.emplace_back(axes[k] + index + "'", from_A[i].r[k]);
    }
  }
  return all;
}

Vector first_moments(S system) {
  Vector all{};
  for (const Particle& p : system) all = all + p.m * p.r;
  return all;
}

/// Components about the origin.
Sum definition(const std::vector<std::size_t>& which) {
  return {
      R"($\sum m_i\,\mathbf r_i\times(\mathbf w\times\mathbf r_i)$, the angular momentum of a turn $\mathbf w$)",
      [=](const Sample& s) {
        std::vector<double> all(which.size());
        for (std::size_t k = 0; k < which.size(); ++k)
          for (const Particle& p : s.system) all[k] += p.m * inertia_by_definition(which[k], p.r);
        return all;
      }};
}
Sum zero(std::size_t n) {
  return {"zero", [=](const Sample&) { return Value(std::vector<double>(n)); }};
}

/// A sum over the positions themselves.
template <class F>
Sum direct(const std::string& text, const F& f) {
  return {text, [=](const Sample& s) { return sum(s.system, f); }};
}

/// Lines of one quantity, each of which says its formula; where that begins with =, the quantity before it.
auto lines(Claims& claims, const std::string& quantity, const Sum& truth) {
  return [&claims, quantity, truth](std::string_view slug, int line, const std::vector<Sample>& samples,
                                    const Sum& printed, const Sum& near) {
    std::string says = printed.text;
    if (says.starts_with("$=")) says = quantity.substr(0, quantity.size() - 1) + says.substr(1);
    claims.formula(slug, line, says, samples,
                   {.quantity = quantity, .truth = truth, .printed = printed, .near_misses = {near}});
  };
}

// Ixx by the text, with a factor that is 1, or 2, as printed.
const auto shifted_xx = [](double sign) {
  return [=](const auto& s, const auto& A) {
    return sum(s, [&](const auto& x, const auto& y, const auto& z) {
      return yz_squared(x, y + sign * A[1], z + sign * A[2]);
    });
  };
};
const auto split_xx = [](double two) {
  return [=](const auto& s, const auto& A) {
    return sum(s, yz_squared) + sum(s, [&](const auto&, const auto& y, const auto& z) {
             return two * y * A[1] + A[1] * A[1] + two * z * A[2] + A[2] * A[2];
           });
  };
};
const auto collected_xx = [](double sign) {
  return [=](const auto& s, const auto& A) {
    return sum(s, yz_squared) + sign * 2 * A[1] * first_moments(s)[1] + 2 * A[2] * first_moments(s)[2] +
           (A[1] * A[1] + A[2] * A[2]) * mass_of(s);
  };
};
const auto transfer_xx = [](double sign) {
  return [=](const auto& s, const auto& A) {
    return sum(s, yz_squared) + sign * mass_of(s) * (A[1] * A[1] + A[2] * A[2]);
  };
};

void moments_of_inertia(Claims& claims, const Samples& samples) {
  const auto ixx = lines(claims, "$I_{xx}$", definition({0}));
  ixx("ixx", 747, samples.any_point, direct(R"($I_{xx}=\sum m_i(y_i^2+z_i^2)$)", yz_squared),
      direct(R"($\sum m_ix_iy_i$)", xy_of));
  ixx("ixx_shifted", 751, samples.any_point,
      seen(R"($=\sum m_i\bigl((y_i'+c_y)^2+(z_i'+c_z)^2\bigr)$)", shifted_xx(1)),
      seen(R"($\sum m_i\bigl((y_i'-c_y)^2+(z_i'-c_z)^2\bigr)$)", shifted_xx(-1)));
  ixx("ixx_split", 753, samples.any_point,
      seen(R"($=\sum m_i(y_i'^2+z_i'^2)+\sum m_i(2y_i'c_y+c_y^2+2z_i'c_z+c_z^2)$)", split_xx(2)),
      seen("without the factors 2", split_xx(1)));
  ixx("ixx_collected", 759, samples.any_point,
      seen(R"($=I_{xx}'+2c_y\sum m_iy_i'+2c_z\sum m_iz_i'+(c_y^2+c_z^2)\sum m_i$)", collected_xx(1)),
      seen(R"(with $-2c_y\sum m_iy_i'$)", collected_xx(-1)));
  ixx("ixx_transfer", 769, samples.center, seen("$=I_{xx}'+m(c_y^2+c_z^2)$", transfer_xx(1)),
      seen("$I_{xx}'-m(c_y^2+c_z^2)$", transfer_xx(-1)));
}

// Ixy by the text.
const auto shifted_xy = [](double sign) {
  return [=](const auto& s, const auto& A) {
    return sum(s, [&](const auto& x, const auto& y, const auto&) { return (x + sign * A[0]) * (y + A[1]); });
  };
};
double first_sum(S s, bool massless) {
  double all = 0;
  for (const Particle& p : s) all += (massless ? 1 : p.m) * p.r[0] * p.r[1];
  return all;
}
Shortened first_sum(const Recording& s, bool) { return sum(s, xy_of); }
const auto split_xy = [](bool massless, double sign = 1) {
  return [=](const auto& s, const auto& A) {
    return first_sum(s, massless) + sum(s, [&](const auto& x, const auto& y, const auto&) {
             return A[0] * y + sign * A[1] * x + A[0] * A[1];
           });
  };
};
const auto collected_xy = [](bool massless, double sign = 1) {
  return [=](const auto& s, const auto& A) {
    const auto moment = first_moments(s);
    return first_sum(s, massless) + A[0] * moment[1] + sign * A[1] * moment[0] + A[0] * A[1] * mass_of(s);
  };
};
const auto transfer_xy = [](double sign) {
  return [=](const auto& s, const auto& A) { return sum(s, xy_of) + sign * mass_of(s) * A[0] * A[1]; };
};

void products_of_inertia(Claims& claims, const Samples& samples) {
  const Sum truth = definition({3});
  const auto ixy = lines(claims, "$I_{xy}$", truth);
  ixy("ixy", 779, samples.any_point, direct(R"($I_{xy}=\sum m_ix_iy_i$)", xy_of),
      direct(R"($I_{xy}=-\sum m_ix_iy_i$)", [](double x, double y, double) { return -x * y; }));
  ixy("ixy_shifted", 781, samples.any_point, seen(R"($=\sum m_i(x_i'+c_x)(y_i'+c_y)$)", shifted_xy(1)),
      seen(R"($\sum m_i(x_i'-c_x)(y_i'+c_y)$)", shifted_xy(-1)));
  const System pair{{2, {1, 1, 0}}, {2, {-1, -1, 0}}};
  const auto without_mass = [&](std::string_view slug, int number, const std::string& rest,
                                const std::string& near, const auto& of) {
    claims.formula(
        slug, number, R"($I_{xy}=\sum x_i'y_i')" + rest, samples.any_point,
        {.quantity = "$I_{xy}$",
         .truth = truth,
         .printed = seen(R"($=\sum x_i'y_i')" + rest, of(true, 1)),
         .meant = seen(R"($\sum m_ix_i'y_i')" + rest, of(false, 1)),
         .near_misses = {seen("with $m_i$, and " + near, of(false, -1))},
         .kind = Fault::formula,
         .why =
             filled("The mass $m_i$ is left out of the first sum, $\\sum m_i\\,x'_iy'_i$, of lines 783 and "
                    "787; lines 779 and 781, before them, have it. As it stands the sum has another "
                    "unit: for two masses of 2 kg at $\\pm(1,1)$ m it is @1, where $I_{xy}$ is @1 kg m$^2$.",
                    {first_sum(pair, true), first_sum(pair, false)})});
  };
  without_mass("ixy_split", 783, R"(+\sum m_i(c_xy_i'+c_yx_i'+c_xc_y)$)", "$-c_yx_i'$", split_xy);
  without_mass("ixy_collected", 787, R"(+c_x\sum m_iy_i'+c_y\sum m_ix_i'+c_xc_y\sum m_i$)",
               R"($-c_y\sum m_ix_i'$)", collected_xy);
  ixy("ixy_transfer", 795, samples.center, seen("$=I_{xy}'+mc_xc_y$", transfer_xy(1)),
      seen("$I_{xy}'-mc_xc_y$", transfer_xy(-1)));
}

template <class T>
std::vector<T> middle_terms(const std::array<T, 3>& moment, const std::array<T, 3>& A) {
  return {2 * A[1] * moment[1], 2 * A[2] * moment[2], A[0] * moment[1], A[1] * moment[0]};
}

/// Component k about the origin, as the text leaves it to its reader.
template <class T>
T transferred_component(std::size_t k, const T& central, const T& mass, const std::array<T, 3>& A,
                        double sign) {
  switch (k) {
    case 1:
      return central + mass * (A[0] * A[0] + A[2] * A[2]);
    case 2:
      return central + mass * (A[0] * A[0] + A[1] * A[1]);
    case 4:
      return central + sign * mass * A[0] * A[2];
    default:
      return central + sign * mass * A[1] * A[2];
  }
}
constexpr std::size_t other_components[] = {1, 2, 4, 5};

void statements(Claims& claims, const Samples& samples) {
  const auto vanish = [&](std::string_view slug, int number, const std::string& says,
                          const std::string& quantity, std::size_t count, const Of& of) {
    const auto about = [&](const std::string& text, const std::vector<Sample>& all) {
      return Reading{text, {compare(quantity, seen(text, of), zero(count), all)}};
    };
    claims.add(slug, number, says,
               {.printed = about(says, samples.center),
                .near_misses = {about("about another point", samples.any_point)}});
  };
  vanish(
      "first_moments", 771,
      R"(The first moments about the center of mass are zero: $\sum m_iy_i'=\sum m_i(y_i-c_y)=0$, and so for $x$ and $z$.)",
      "first moments", 3, [](S s, V) { return first_moments(s); });
  const auto terms = [](std::size_t first) {
    return [=](S s, V A) {
      const std::vector<double> all = middle_terms(first_moments(s), A);
      return Value{all[first], all[first + 1]};
    };
  };
  vanish("middle_terms", 771,
         R"(The middle two terms of $I_{xx}$, $2c_y\sum m_iy_i'$ and $2c_z\sum m_iz_i'$, are zero.)",
         "middle terms of $I_{xx}$", 2, terms(0));
  vanish("middle_terms_again", 797,
         R"(The middle two terms of $I_{xy}$, $c_x\sum m_iy_i'$ and $c_y\sum m_ix_i'$, are zero.)",
         "middle terms of $I_{xy}$", 2, terms(2));

  const auto transfer = [](double sign) {
    return [=](S s, V A) {
      const Six central = inertia_about(s, {});
      std::vector<double> all;
      for (const std::size_t k : other_components)
        all.push_back(transferred_component<double>(k, central[k], mass_of(s), A, sign));
      return all;
    };
  };
  lines(claims, "$I_{yy}$, $I_{zz}$, $I_{xz}$, $I_{yz}$", definition({1, 2, 4, 5}))(
      "others", 799, samples.center,
      seen(
          "The other components are handled in the same manner (our formulas): $I_{yy}=I_{yy}'+m(c_x^2+c_z^2)$, "
          "$I_{zz}=I_{zz}'+m(c_x^2+c_y^2)$, $I_{xz}=I_{xz}'+mc_xc_z$, $I_{yz}=I_{yz}'+mc_yc_z$.",
          transfer(1)),
      seen("the products with $-mc_xc_z$", transfer(-1)));
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const Samples samples(seed);
  Claims claims("2.15");
  for (auto* section : {statements, moments_of_inertia, products_of_inertia}) section(claims, samples);
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

constexpr const char* totals_in_coq = R"(
From Coq Require Import List.
Local Open Scope R_scope.

(* over particles of the mass m at (x, y, z), however many *)
Definition total (l : list (R * R * R * R)) (f : R -> R -> R -> R -> R) : R :=
  fold_right (fun p s => match p with (m, x, y, z) => f m x y z end + s) 0 l.

Ltac by_particles l :=
  unfold total; induction l as [|[[[m x] y] z] l h]; cbn [fold_right]; [ring |];
  first [rewrite <- h; ring | rewrite h; ring].
)";

/// The first moments about the center: H, H0 and H1 say where it is.
constexpr const char* first_moments_vanish = R"(
  assert (f0 : total l (fun m x y z => m * (x - c0)) = 0)
    by (transitivity (total l (fun m x y z => m * x) - c0 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite H; ring]);
  assert (f1 : total l (fun m x y z => m * (y - c1)) = 0)
    by (transitivity (total l (fun m x y z => m * y) - c1 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite H0; ring]);
  assert (f2 : total l (fun m x y z => m * (z - c2)) = 0)
    by (transitivity (total l (fun m x y z => m * z) - c2 * total l (fun m x y z => m));
        [clear -l; by_particles l | rewrite H1; ring]);
  )";

/// What a component about the origin has besides its transfer, in first moments about the center.
constexpr const char* rest_of_transfer[] = {"2 * c1 * t1 + 2 * c2 * t2", "2 * c0 * t0 + 2 * c2 * t2",
                                            "2 * c0 * t0 + 2 * c1 * t1", "c1 * t0 + c0 * t1",
                                            "c2 * t0 + c0 * t2",         "c2 * t1 + c1 * t2"};
std::string by_transfer(std::size_t k) {
  return std::string(first_moments_vanish) +
         "match goal with |- ?right = ?left =>\n"
         "    pose (t0 := total l (fun m x y z => m * (x - c0))); pose (t1 := total l (fun m x y z => m * (y - c1)));\n"
         "    pose (t2 := total l (fun m x y z => m * (z - c2)));\n"
         "    assert (all : left = right + (" +
         rest_of_transfer[k] +
         ")) by (unfold t0, t1, t2; clear -l; by_particles l);\n"
         "    rewrite all; unfold t0, t1, t2; rewrite ?f0, ?f1, ?f2; ring end";
}

}  // namespace

Provables proofs() {
  const auto letter = [](const char* name) { return Shortened::letter(name); };
  const Recording origin, from_A{{letter("c0"), letter("c1"), letter("c2")}};
  const auto& A = from_A.from;
  const std::string letters = "(l : list (R * R * R * R)) (c0 c1 c2 : R)";
  std::vector<Proposition> center;
  for (std::size_t i = 0; i < 3; ++i)
    center.push_back(first_moments(origin)[i].expression() == (A[i] * mass_of(origin)).expression());
  Provables proved;
  const auto prove = [&](const std::string& slug, const std::string& reading, const std::string& says,
                         const std::vector<Proposition>& given, const std::vector<Proposition>& follows,
                         const std::string& tactic) {
    proved.push_back({"2.15-" + slug, says, {{reading, letters, given, follows, tactic}}, 0, totals_in_coq});
  };
  const auto line = [&](const std::string& slug, std::size_t k, const Shortened& text,
                        const std::string& reading = "printed") {
    prove(slug, reading, "it is the component of any number of particles, about any point", {},
          {text.expression() == by_definition(k, origin).expression()}, "by_particles l");
  };
  line("ixx", 0, sum(origin, yz_squared));
  line("ixx_shifted", 0, shifted_xx(1)(from_A, A));
  line("ixx_split", 0, split_xx(2)(from_A, A));
  line("ixx_collected", 0, collected_xx(1)(from_A, A));
  line("ixy", 3, sum(origin, xy_of));
  line("ixy_shifted", 3, shifted_xy(1)(from_A, A));
  line("ixy_split", 3, split_xy(false)(from_A, A), "meant");
  line("ixy_collected", 3, collected_xy(false)(from_A, A), "meant");

  const std::string at_center = "it holds of any number of particles about their center of mass";
  const auto transferred = [&](const std::string& slug, std::size_t k, const Shortened& text) {
    prove(slug, "printed", at_center, center, {text.expression() == by_definition(k, origin).expression()},
          by_transfer(k));
  };
  transferred("ixx_transfer", 0, transfer_xx(1)(from_A, A));
  transferred("ixy_transfer", 3, transfer_xy(1)(from_A, A));
  const auto vanish = [&](const std::string& slug, const std::vector<Shortened>& all) {
    std::vector<Proposition> zeros;
    for (const Shortened& x : all) zeros.push_back(x.expression() == 0);
    prove(slug, "printed", at_center, center, zeros,
          std::string(first_moments_vanish) + "rewrite ?f0, ?f1, ?f2; ring");
  };
  std::vector<Lemma> others;
  for (const std::size_t k : other_components)
    others.push_back(
        {"component_" + std::to_string(k),
         letters,
         center,
         {transferred_component(k, by_definition(k, from_A), mass_of(origin), A, 1).expression() ==
          by_definition(k, origin).expression()},
         by_transfer(k)});
  proved.push_back({"2.15-others", at_center, others, 0, totals_in_coq});
  const auto moment = first_moments(from_A);
  vanish("first_moments", {moment[0], moment[1], moment[2]});
  const std::vector<Shortened> terms = middle_terms(moment, A);
  vanish("middle_terms", {terms[0], terms[1]});
  vanish("middle_terms_again", {terms[2], terms[3]});
  return proved;
}

}  // namespace oddity::transfer_theorem

namespace oddity {

Provables proofs_2_15() { return transfer_theorem::proofs(); }

}  // namespace oddity
