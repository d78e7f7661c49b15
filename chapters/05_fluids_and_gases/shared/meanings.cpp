#include "chapters/05_fluids_and_gases/shared/meanings.hpp"

/// Fields in Coq. Derivatives are Coquelicot's along the axes; Coq proves the rules for derivatives of sums
/// and products.
namespace oddity::fields {

namespace {

using Coordinates = std::array<std::string, 3>;

const Coordinates at_point{"x0", "x1", "x2"};

const std::string definitions = R"(
Definition field := R -> R -> R -> R.
Definition d0 (f : field) x0 x1 x2 := Derive (fun t => f t x1 x2) x0.
Definition d1 (f : field) x0 x1 x2 := Derive (fun t => f x0 t x2) x1.
Definition d2 (f : field) x0 x1 x2 := Derive (fun t => f x0 x1 t) x2.
Definition differentiable (f : field) := forall x0 x1 x2 : R,
  ex_derive (fun t : R => f t x1 x2) x0 /\ ex_derive (fun t : R => f x0 t x2) x1 /\
  ex_derive (fun t : R => f x0 x1 t) x2.
Ltac exists_derivative := cbv beta;
  lazymatch goal with
  | H : differentiable ?f |- ex_derive (fun t : R => ?f t ?y ?z) ?x => exact (proj1 (H x y z))
  | H : differentiable ?f |- ex_derive (fun t : R => ?f ?x t ?z) ?y => exact (proj1 (proj2 (H x y z)))
  | H : differentiable ?f |- ex_derive (fun t : R => ?f ?x ?y t) ?z => exact (proj2 (proj2 (H x y z)))
  | |- ex_derive (fun _ : R => ?c) _ => apply ex_derive_const
  | |- ex_derive (fun t : R => t) _ => apply ex_derive_id
  | |- ex_derive (fun t : R => @?f t * @?g t) ?x => apply (ex_derive_mult f g x); exists_derivative
  | |- ex_derive (fun t : R => @?f t + @?g t) ?x => apply (ex_derive_plus f g x); exists_derivative
  | |- ex_derive (fun t : R => @?f t - @?g t) ?x => apply (ex_derive_minus f g x); exists_derivative
  end.
Ltac differentiate := unfold d0, d1, d2; cbv beta;
  repeat (match goal with
  | |- context [Derive (fun _ : R => ?c) ?x] => rewrite (Derive_const c x)
  | |- context [Derive (fun t : R => t) ?x] => change (Derive (fun t : R => t) x) with (Derive id x); rewrite (Derive_id x)
  | |- context [Derive (fun t : R => @?f t * @?g t) ?x] => rewrite (Derive_mult f g x) by exists_derivative
  | |- context [Derive (fun t : R => @?f t + @?g t) ?x] => rewrite (Derive_plus f g x) by exists_derivative
  | |- context [Derive (fun t : R => @?f t - @?g t) ?x] => rewrite (Derive_minus f g x) by exists_derivative
  end; cbv beta).
)";

CoqField combined(const CoqField& f, const CoqField& g,
                  Expression (*how)(const Expression&, const Expression&)) {
  return {[=](const Coordinates& x) { return how(f.at(x), g.at(x)); }};
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
  return all;
}

}  // namespace

CoqField operator+(const CoqField& f, const CoqField& g) {
  return combined(f, g, [](const Expression& a, const Expression& b) { return a + b; });
}
CoqField operator-(const CoqField& f, const CoqField& g) {
  return combined(f, g, [](const Expression& a, const Expression& b) { return a - b; });
}
CoqField operator*(const CoqField& f, const CoqField& g) {
  return combined(f, g, [](const Expression& a, const Expression& b) { return a * b; });
}
CoqField partial(const CoqField& f, std::size_t by) {
  return {[=](const Coordinates& x) {
    return Expression::letter("(d" + digit(by) + " (fun y0 y1 y2 => " + f.at({"y0", "y1", "y2"}).coq() +
                              ") " + x[0] + " " + x[1] + " " + x[2] + ")");
  }};
}

CoqField divergence(const CoqVector& f) { return partial(f[0], 0) + partial(f[1], 1) + partial(f[2], 2); }
CoqVector curl(const CoqVector& f) {
  return {partial(f[2], 1) - partial(f[1], 2), partial(f[0], 2) - partial(f[2], 0),
          partial(f[1], 0) - partial(f[0], 1)};
}
CoqVector gradient(const CoqField& f) { return {partial(f, 0), partial(f, 1), partial(f, 2)}; }
CoqField dot(const CoqVector& f, const CoqVector& g) { return f[0] * g[0] + f[1] * g[1] + f[2] * g[2]; }
CoqVector cross(const CoqVector& f, const CoqVector& g) {
  return {f[1] * g[2] - f[2] * g[1], f[2] * g[0] - f[0] * g[2], f[0] * g[1] - f[1] * g[0]};
}
CoqVector times(const CoqField& phi, const CoqVector& f) { return {phi * f[0], phi * f[1], phi * f[2]}; }
CoqVector advected(const CoqVector& f, const CoqVector& g) {
  return {dot(f, gradient(g[0])), dot(f, gradient(g[1])), dot(f, gradient(g[2]))};
}

// ---- symbols ----------------------------------------------------------------------------------------------

CoqField Meanings::any_scalar(const std::string& name) {
  fields_.push_back(name);
  return {[=](const Coordinates& x) {
    return Expression::letter("(" + name + " " + x[0] + " " + x[1] + " " + x[2] + ")");
  }};
}
CoqVector Meanings::any_vector(const std::string& name) {
  return {any_scalar(name + "0"), any_scalar(name + "1"), any_scalar(name + "2")};
}
CoqVector Meanings::any_numbers(const std::string& name) {
  CoqVector v;
  for (std::size_t i = 0; i < 3; ++i) {
    numbers_.push_back(name + digit(i));
    v[i].at = [number = Expression::letter(numbers_.back())](const Coordinates&) { return number; };
  }
  return v;
}
CoqVector Meanings::position() {
  CoqVector v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i].at = [i](const Coordinates& x) { return Expression::letter(x[i]); };
  return v;
}

void Meanings::put(const std::string& name, const CoqField& f) { meanings_[name] = f.at(at_point); }
void Meanings::put(const std::string& name, const CoqVector& f) {
  for (std::size_t i = 0; i < 3; ++i) put(name + digit(i), f[i]);
}
void Meanings::put_scalar(const std::string& name, const CoqField& f) {
  put(name, f);
  for (std::size_t j = 0; j < 3; ++j) put(name + "," + digit(j), partial(f, j));
}
void Meanings::put_vector(const std::string& name, const CoqVector& f) {
  for (std::size_t i = 0; i < 3; ++i) put_scalar(name + digit(i), f[i]);
}

// ---- lines ------------------------------------------------------------------------------------------------

bool Meanings::known(const Terms& terms, const Sample& symbols) const {
  for (const Term& t : terms)
    for (const std::size_t k : t.factors)
      if (!meanings_.contains(symbols.names[k])) return false;
  return true;
}

Expression Meanings::expression(const Terms& terms, const Sample& symbols) const {
  Expression sum;
  for (std::size_t n = 0; n < terms.size(); ++n) {
    Expression product = meanings_.at(symbols.names[terms[n].factors[0]]);
    for (std::size_t k = 1; k < terms[n].factors.size(); ++k)
      product = product * meanings_.at(symbols.names[terms[n].factors[k]]);
    if (n == 0)
      sum = terms[n].sign < 0 ? -product : product;
    else
      sum = terms[n].sign < 0 ? sum - product : sum + product;
  }
  return sum;
}

Provables Meanings::proofs(const std::string& exercise, const Proof& proof) const {
  Stated differentiable{
      .letters = "(" + listed(fields_) + " : field) (" + listed(numbers_) + " x0 x1 x2 : R)",
      .given = {},
      .tactic = "differentiate; ring",
      .says = "it holds for all differentiable fields at every point",
      .preamble = definitions};
  for (const std::string& f : fields_) differentiable.given.push_back({"differentiable " + f});
  return proofs(exercise, proof, differentiable);
}

Provables Meanings::proofs(const std::string& exercise, const Proof& proof, const Stated& stated) const {
  const Sample& symbols = proof.samples[0];
  Provables all;
  for (const Line& line : proof.lines) {
    Lemma lemma{
        .name = line.reading, .letters = stated.letters, .given = stated.given, .tactic = stated.tactic};
    bool provable = true, by_definition = true;
    for (const Row& row : line.rows) {
      const Terms left = read_terms(row.left, symbols), right = read_terms(row.right, symbols);
      provable = provable && known(left, symbols) && known(right, symbols);
      if (!provable) break;
      const Expression a = expression(left, symbols), b = expression(right, symbols);
      lemma.follows.push_back(a == b);
      by_definition = by_definition && a.coq() == b.coq();
    }
    if (provable && !by_definition)
      all.push_back({exercise + "-" + line.slug, stated.says, {lemma}, 0, stated.preamble});
  }
  return all;
}

}  // namespace oddity::fields
