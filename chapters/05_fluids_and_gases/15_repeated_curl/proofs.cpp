// The index expressions of the claims, recorded component by component, for any fields and any frame r.
#include "chapters/05_fluids_and_gases/15_repeated_curl/lines.hpp"
#include "chapters/05_fluids_and_gases/15_repeated_curl/repeated_curl.hpp"
#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"
#include "chapters/provable.hpp"

namespace oddity::ex05_15 {

namespace {

using namespace fields;
using Letters = Triple<Shortened>;

template <class F>
auto each(const F& f) {
  return std::array{f(0), f(1), f(2)};
}
/// "f 0%nat", "f 1%nat", "f 2%nat".
Triple<std::string> components(const std::string& name) {
  return each([&](int i) { return name + " " + std::to_string(i) + "%nat"; });
}
/// x0, x1, x2.
Letters point(const std::string& name) {
  return each([&](int i) { return Shortened::letter(name + std::to_string(i)); });
}
FrameOf<Shortened> frame() { return {numbers("r 0%nat"), numbers("r 1%nat"), numbers("r 2%nat")}; }

// ---- fields by their names in Coq -------------------------------------------------------------------------

Shortened at(const Letters& x, const std::string& field) {
  std::string text = "(" + field;
  for (const Shortened& coordinate : x) {
    const std::string& written = coordinate.expression().coq();
    text += written.find(' ') == std::string::npos ? " " + written : " (" + written + ")";
  }
  return Shortened::letter(text + ")");
}
Letters at(const Letters& x, const Triple<std::string>& fields) {
  return each([&](std::size_t i) { return at(x, fields[i]); });
}
/// The values at the point y, as functions of y.
Triple<std::string> of_y(const Letters& values) {
  return each([&](std::size_t i) { return "fun y0 y1 y2 => " + values[i].expression().coq(); });
}
/// The derivatives of an order at x, with the indices m, j1 ... jn; j1 is applied first.
std::vector<Shortened> derivatives_at(const Letters& x, const Triple<std::string>& fields, int order) {
  std::vector<std::string> all{fields.begin(), fields.end()};
  for (int n = 0; n < order; ++n) {
    std::vector<std::string> slopes;
    for (const std::string& field : all)
      for (int j = 0; j < 3; ++j) slopes.push_back("d " + std::to_string(j) + " (" + field + ")");
    all = std::move(slopes);
  }
  std::vector<Shortened> values;
  for (const std::string& field : all) values.push_back(at(x, field));
  return values;
}

// ---- the symbols of the lines at x ------------------------------------------------------------------------

Tensors<Shortened> derivatives_of_f(const Letters& x) {
  Tensors<Shortened> tensors;
  put_permutation_tensor(tensors);
  for (int n = 0; n <= most_curls; ++n) tensors[{"f", n + 1}] = derivatives_at(x, components("f"), n);
  return tensors;
}
Tensors<Shortened> tensors_at(const Letters& x) {
  Tensors<Shortened> tensors = derivatives_of_f(x);
  const auto put = [&](const std::string& name, const Letters& v) {
    tensors[{name, 1}] = {v.begin(), v.end()};
  };
  const Letters y = point("y"), f = at(x, components("f")), g = at(x, components("g"));
  const auto curls = [&](const IndexExpression& curl) { return of_y(curl.value(derivatives_of_f(y))); };
  put("g", g);
  for (const char* name : {"a", "b", "c"}) put(name, numbers(name));
  put("u", turned(frame(), g));
  put("v", turned(frame(), f));
  tensors[{"once", 2}] = derivatives_at(x, curls({"e(k l m) f(m, l)", "k"}), 1);
  tensors[{"twice", 2}] = derivatives_at(x, curls({"e(k3 j2 k2) e(k2 j1 k1) f(k1, j1 j2)", "k3"}), 1);
  const auto v = turned_field([](const Letters& z) { return at(z, components("f")); }, frame());
  tensors[{"v", 3}] = derivatives_at(turned(frame(), x), of_y(v(y)), 2);
  return tensors;
}

/// The number of differentiations of f, and the left side.
std::pair<int, Letters> left_at(const Letters& x, const std::string& name) {
  const auto nested = [&](int n) { return at(x, components("curls " + std::to_string(n) + " r f")); };
  const auto along = [&](const std::string& before, const std::string& field, const std::string& after) {
    return at(x, each([&](std::size_t i) { return before + "(" + components(field)[i] + ")" + after; }));
  };
  const Letters product = cross(at(x, components("g")), at(x, components("f")));
  if (name == "g x f") return {0, product};
  if (name == "g x f, turned") return {0, turned(frame(), product)};
  if (name == "curl2, turned") return {2, turned(frame(), nested(2))};
  if (name == "f along a, b, c") return {3, along("along c (along b (along a ", "f", "))")};
  if (name == "curl1 along a") return {2, along("along a ", "curls 1 r f", "")};
  const int n = name.back() - '0';
  return {n, nested(n)};
}

// ---- proofs -----------------------------------------------------------------------------------------------

constexpr const char* by_expansion = "expanded_curls H H0; ring";
constexpr const char* derivative_of_curl =
    "pose proof (fun i => smooth_less 1 (f i) (H0 i)) as less;\n"
    "  rewrite (curls_are r 1 f H less), along_field by (apply (axis_curls_smooth 1 1 f H0));\n"
    "  cbn [axis_curls axis_curl]; unfold dot_field, dot, sum;\n"
    "  rewrite !d_plus_times by (apply (has_slope 0), d_smooth, H0); unfold plus_times; ring";
std::string tactic_of(const std::string& slug) {
  if (slug == "cross_product") return "ring";
  if (slug == "cross_product_vector") return "turned_products H";
  if (slug == "twice_nested") return "nested_curls 1%nat H H0";
  if (slug == "thrice_nested") return "nested_curls 2%nat H H0";
  if (slug == "constant") return derivative_of_curl;
  if (slug == "twice_comma") return "expanded_curls H H0; in_one_order H0; ring";
  if (slug == "twice_vector") return "turned_curls r f x0 x1 x2 H H0";
  if (slug == "appended") return "rewrite along_thrice by apply H0; unfold dot_field, dot, sum; ring";
  return by_expansion;
}

Lemma lemma_of(const std::string& slug, const Said& said, const std::string& name) {
  const Letters x = point("x");
  const auto [order, left] = left_at(x, said.left);
  const Letters right = IndexExpression(said.right, said.free).value(tensors_at(x));
  Lemma lemma{.name = name,
              .letters = "(r : nat -> nat -> R) (f g : vector) (a b c : nat -> R) (x0 x1 x2 : R)",
              .given = {{"frame r"}, {"smooth_vector " + std::to_string(order) + " f"}},
              .tactic = tactic_of(slug)};
  for (std::size_t i = 0; i < 3; ++i) lemma.follows.push_back(left[i].expression() == right[i].expression());
  return lemma;
}

/// The general formula for every n, in Coq's words.
Lemma every_n() {
  return {.name = "every_n",
          .letters = "(r : nat -> nat -> R) (f : vector) (n i : nat) (x0 x1 x2 : R)",
          .given = {{"(i < 3)%nat"}, {"frame r"}, {"smooth_vector n f"}},
          .follows = {{"curls n r f i x0 x1 x2 = tensors f n i 1 nil x0 x1 x2"}},
          .tactic = "rewrite curls_expanded, tensors_expanded by assumption; ring"};
}

}  // namespace

Provables proofs() {
  Provables all;
  for (const auto& [slug, said] : lines(Random(1)).printed) {
    const bool of_any_order = slug == "general" || slug == "product";
    Provable proof{.claim = "5.15-" + slug,
                   .says = of_any_order
                               ? "it is the curl along any frame, applied up to four times as it is "
                                 "recorded, and n times, of all fields with that many derivatives"
                               : "it holds for all fields with continuous derivatives, along any frame",
                   .preamble = coq_source({"curl_tactics"})};
    for (std::size_t n = 0; n < said.size(); ++n)
      proof.lemmas.push_back(
          lemma_of(slug, said[n], said.size() == 1 ? "printed" : "printed_" + std::to_string(n + 1)));
    if (of_any_order) proof.lemmas.push_back(every_n());
    all.push_back(std::move(proof));
  }
  return all;
}

}  // namespace oddity::ex05_15
