#include "chapters/05_fluids_and_gases/shared/proof.hpp"

#include <cctype>
#include <stdexcept>

#include "formula/print.hpp"
#include "reference/text.hpp"

namespace oddity::fields {

// ---- samples ----------------------------------------------------------------------------------------------

void Sample::put(std::string name, double value, double size) {
  names.push_back(std::move(name));
  values.push_back(value);
  sizes.push_back(size);
}
void Sample::put(std::string name, double value) { put(std::move(name), value, std::abs(value)); }
void Sample::put(const std::string& name, const Point& v) {
  for (std::size_t i = 0; i < 3; ++i) put(name + digit(i), v[i], size_of(Value(v)));
}

std::vector<Sample> sampled(Random random, const std::function<void(Sample&, const Drawn&)>& fill) {
  std::vector<Sample> all;
  for (int n = 0; n < 64; ++n) {
    const auto size = [&] { return random.magnitude(1e-6, 1e6); };
    const auto rate = [&] { return random.magnitude(0.01, 10); };
    Drawn drawn{{random, size(), rate()}, {random, size(), rate()}, {random, size(), rate()}, {}, {}, {}};
    drawn.x = random.point();
    drawn.frame = random_frame(random);
    drawn.m = {random.point(), random.point(), random.point()};
    all.push_back({"draw " + std::to_string(n) + " at (" + format_shortest(drawn.x[0]) + ", " +
                   format_shortest(drawn.x[1]) + ", " + format_shortest(drawn.x[2]) + ")"});
    fill(all.back(), drawn);
  }
  return all;
}

// ---- lines ------------------------------------------------------------------------------------------------

namespace {

/// All products of a term of `one` with a term of `other`.
Terms expanded(const Terms& one, const Terms& other) {
  Terms all;
  for (const Term& a : one)
    for (const Term& b : other) {
      Term ab{a.sign * b.sign, a.factors};
      ab.factors.insert(ab.factors.end(), b.factors.begin(), b.factors.end());
      all.push_back(std::move(ab));
    }
  return all;
}

Terms terms_of(const formula::Tree& x) {
  const bool is_product = x.kind() == formula::Kind::product && x->marks.find('/') == std::string::npos;
  if (x.kind() == formula::Kind::letter) return {{1, {static_cast<std::size_t>(x->entries[0].rates[0])}}};
  if (x.kind() != formula::Kind::sum && !is_product)
    throw std::logic_error("'" + formula::plain(x) + "' is no sum of products");
  Terms all;
  if (is_product) all = {{}};
  for (std::size_t i = 0; i < x->children.size(); ++i)
    if (is_product)
      all = expanded(all, terms_of(x.child(i)));
    else
      for (Term& term : terms_of(x.child(i)))
        all.push_back({x->marks[i] == '-' ? -term.sign : term.sign, std::move(term.factors)});
  return all;
}

double value_of(const Terms& terms, const Sample& s) {
  double sum = 0;
  for (const Term& t : terms) {
    double product = t.sign;
    for (std::size_t k : t.factors) product *= s.values[k];
    sum += product;
  }
  return sum;
}
/// Size of the terms that are added up.
double size_of(const Terms& terms, const Sample& s) {
  double sum = 0;
  for (const Term& t : terms) {
    double product = 1;
    for (std::size_t k : t.factors) product *= s.sizes[k];
    sum += product;
  }
  return sum;
}

}  // namespace

Terms read_terms(std::string_view line, const Sample& symbols) {
  if (!symbols.reader || symbols.reader->letters() != symbols.names.size())
    symbols.reader = std::make_shared<const formula::PlainReader>(symbols.names);
  return terms_of((*symbols.reader)(line));
}

// ---- claims -----------------------------------------------------------------------------------------------

std::vector<Row> each_component(const std::string& left, const std::string& right) {
  std::vector<Row> all;
  for (char i : {'0', '1', '2'}) {
    all.push_back({left, right});
    std::ranges::replace(all.back().left, '#', i);
    std::ranges::replace(all.back().right, '#', i);
  }
  return all;
}

std::string typeset(std::string_view line, const Names& names) {
  const auto symbol = [&](const std::string& read) {
    const std::size_t comma = std::min(read.find(','), read.size());
    std::string base = read.substr(0, comma), indices = read.substr(comma);
    while (!names.contains(base) && !base.empty() && std::isdigit(base.back())) {
      indices.insert(0, 1, base.back());
      base.pop_back();
    }
    const auto found = names.find(base);
    return (found != names.end() ? found->second
            : base == "phi"      ? "\\varphi"
                                 : base) +
           (indices.empty() ? "" : "_{" + indices + "}");
  };
  std::string tex;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && (std::isalnum(line[end]) || line[end] == '_' || line[end] == ',')) ++end;
    const bool follows = !tex.empty() && line[i - 1] == ' ' && (std::isalnum(line[i]) || line[i] == '(') &&
                         tex.back() != '+' && tex.back() != '-';
    if (follows) tex += "\\,";
    if (end > i)
      tex += symbol(std::string(line.substr(i, end - i)));
    else if (line[i] != ' ')
      tex += line[i];
    i = std::max(end, i + 1);
  }
  return tex;
}

namespace {

std::string written(const std::vector<Row>& rows, const Names& names) {
  std::string text;
  for (const Row& row : rows)
    text += (text.empty() ? "$" : ", $") + typeset(row.left, names) + "=" + typeset(row.right, names) + "$";
  return text;
}

}  // namespace

namespace {

/// Whether the typeset right side of a single row agrees with its computed value.
bool is_as_typeset(const std::string& text, const Terms& right, const std::vector<Sample>& samples,
                   const Names& names) {
  constexpr std::size_t enough = 3;
  std::vector<std::pair<TypesetLetters, Value>> computed;
  for (const Sample& s : samples) {
    if (computed.size() == enough) break;
    TypesetLetters letters;
    for (std::size_t i = 0; i < s.names.size(); ++i)
      letters.emplace_back(typeset(s.names[i], names), s.values[i]);
    computed.emplace_back(std::move(letters), value_of(right, s));
  }
  return oddity::is_as_typeset(compare_typeset("$" + text + "$", computed));
}

}  // namespace

Reading Proof::reading(const std::vector<Row>& rows, const std::string& by) const {
  std::vector<std::pair<Terms, Terms>> sums;
  std::string quantity;
  for (const Row& row : rows) {
    sums.emplace_back(read_terms(row.left, samples[0]), read_terms(row.right, samples[0]));
    quantity += (quantity.empty() ? "$" : ", $") + typeset(row.left, names) + "$";
  }
  const bool zero =
      std::ranges::all_of(rows, [&](const Row& row) { return row.right == "zero"; });  // zero is on the right
  WorstSample worst(quantity, zero ? by : "the line as it is written", zero ? "zero" : by);
  for (const Sample& s : samples) {
    std::vector<double> left, right;
    double size = 0;
    for (const auto& [l, r] : sums) {
      left.push_back(value_of(l, s));
      right.push_back(value_of(r, s));
      size = std::max(size, size_of(r, s));
    }
    worst.add(zero ? left : right, zero ? right : left, size, s.where);
  }
  const bool read =
      rows.size() == 1 && is_as_typeset(typeset(rows[0].right, names), sums[0].second, samples, names);
  return {written(rows, names), {worst.check()}, read};
}

namespace {

/// All lines that differ from this one by a single sign.
std::vector<std::string> signs_flipped(const std::string& line) {
  std::vector<std::string> all;
  if (line[0] != '-') all.push_back("- " + line);
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '+' || line[i] == '-') (all.emplace_back(line))[i] = line[i] == '+' ? '-' : '+';
  return all;
}
/// All lines that differ from this one by a single index.
std::vector<std::string> indices_changed(const std::string& line) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < line.size(); ++i)
    for (char other : {'0', '1', '2'})
      if (std::isdigit(line[i]) && line[i] != other) (all.emplace_back(line))[i] = other;
  return all;
}

/// The single change to one row that is hardest to detect.
Reading hardest_to_see(const std::string& kind, const Proof& proof, const std::vector<Row>& rows,
                       const std::string& by, std::vector<std::string> (*changes)(const std::string&)) {
  Reading hardest;
  double least = 0;
  int count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::string& changed : changes(rows[i].right)) {
      std::vector<Row> changed_rows = rows;
      changed_rows[i].right = changed;
      const Reading reading = proof.reading(changed_rows, by);
      const double tolerances = reading.checks[0].difference() / reading.checks[0].tolerance.allowed;
      if (count++ > 0 && !is_worse(least, tolerances)) continue;
      least = tolerances;
      hardest = reading;
    }
  hardest.as_typeset = false;
  hardest.text = kind + ", the hardest to see of " + std::to_string(count) + ": " + hardest.text;
  return hardest;
}

}  // namespace

std::vector<Reading> Proof::single_changes(const std::vector<Row>& rows, const std::string& by) const {
  return {hardest_to_see("a sign flipped", *this, rows, by, signs_flipped),
          hardest_to_see("an index changed", *this, rows, by, indices_changed)};
}

void Proof::line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
                 const std::string& by) {
  lines.push_back({.slug = slug, .rows = rows});
  if (rows.size() == 1 && says.find('=') == std::string::npos) says += ": " + written(rows, names);
  claims.add(slug, at, std::move(says),
             {.printed = reading(rows, by), .near_misses = single_changes(rows, by)});
}

void Proof::line(const std::string& slug, int at, std::string says, const std::vector<Row>& rows,
                 const std::string& by, const std::vector<std::vector<Row>>& near_misses) {
  lines.push_back({.slug = slug, .rows = rows});
  Claim claim{.printed = reading(rows, by)};
  for (const auto& near : near_misses) claim.near_misses.push_back(reading(near, by));
  claims.add(slug, at, std::move(says), std::move(claim));
}

}  // namespace oddity::fields
