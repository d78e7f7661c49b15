#include "tests/questions/judge.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <sstream>

#include "tests/questions/follow.hpp"

namespace questions {

namespace {

using Words = std::vector<std::string>;

// ---- programs ---------------------------------------------------------------------------------------------

std::string content(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Ended {
  int code = 0;  ///< -1: it did not end by itself within the time
  std::string out, err;
  double seconds = 0, processor_seconds = 0;
};

double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto in_seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
}

/// Ended before it had worked for half of its time.
bool is_starved(const Ended& ended) { return ended.code < 0 && ended.processor_seconds < ended.seconds / 2; }

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

Ended run(const Program& program, const Words& words, double most_seconds) {
  const std::string out = program.folder + "/out", err = program.folder + "/err";
  std::string command = "timeout -s KILL " + std::to_string(most_seconds);
  for (const std::string& word : words) command += " " + quoted(word);
  const double used = processor_seconds();
  const auto begin = std::chrono::steady_clock::now();
  const int status = std::system((command + " </dev/null >" + quoted(out) + " 2>" + quoted(err)).c_str());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return {code == 137 && took.count() >= most_seconds ? -1 : code, content(out), content(err), took.count(),
          processor_seconds() - used};
}

Ended ask(const Question& question, const Program& program, const std::string& format) {
  Words words{program.oddity, "choose"};
  words.insert(words.end(), question.words.begin(), question.words.end());
  if (!format.empty()) words.push_back(format);
  return run(program, words, 10 * question.limit + 60);  // a hang lasts forever, and a busy machine is slow
}

std::string shown(Real x) {
  std::ostringstream text;
  text.precision(3);
  text << x;
  return text.str();
}

struct CannotBeJudged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// ---- output of the printed program ------------------------------------------------------------------------

/// The code with the rates of its observables printed after them, twice: by differences along the model's own
/// rate, and by differences that are twice as wide.
std::string with_rates(std::string code) {
  // The observables come first in the line of names; an orientation for drawing follows them.
  const std::size_t names = code.find("\"t ["), all = code.find("\\n", names),
                    drawn = code.find(",qw", names);
  const std::string head = code.substr(names, std::min(all, drawn) - names);
  const std::string count = std::to_string(std::count(head.begin(), head.end(), ','));
  const std::string helper = "\nconstexpr std::size_t observed = " + count + R"(;
template <class Observables, class Look>
void print_rates(const Observables& now, const Look& look, double h) {
  const auto a = look(-4 * h), b = look(-3 * h), c = look(-2 * h), d = look(-h), e = look(h), f = look(2 * h),
             g = look(3 * h), i = look(4 * h);
  for (std::size_t k = 0; k < observed; ++k)
    std::printf(",%.17g", (4.0 / 5 * (double(e[k]) - double(d[k])) - 1.0 / 5 * (double(f[k]) - double(c[k])) +
                           4.0 / 105 * (double(g[k]) - double(b[k])) - 1.0 / 280 * (double(i[k]) - double(a[k]))) / h);
}
template <class Observables, class Look>
void print_row(double t, const Observables& now, const Look& look) {
  const double h = sizeof(oddity::asked::Number) < sizeof(double) ? 3e-3 : 1e-4;
  std::printf("%.17g", t);
  for (std::size_t k = 0; k < observed; ++k) std::printf(",%.17g", double(now[k]));
  print_rates(now, look, h / 2);
  print_rates(now, look, h);
  std::printf("\n");
}

int main() {)";
  const bool is_short =
      code.find("oddity::asked") == std::string::npos;  // written by its operations, in double
  const auto put = [&](const std::string& old, const std::string& now) {
    if (const auto at = code.find(old); at != std::string::npos) code.replace(at, old.size(), now);
  };
  put("\nint main() {", helper);
  put("print_row(t1, model.observe(x, Number(t1)));", R"({
      auto rate = x;
      model(x, rate, Number(t1));
      print_row(t1, model.observe(x, Number(t1)), [&](double h) {
        auto moved = x;
        for (std::size_t i = 0; i < x.size(); ++i) moved[i] += Number(h) * rate[i];
        return model.observe(moved, Number(t1 + h));
      });
    })");
  put("print_row(t, model.at(oddity::asked::Number(t)));",
      "print_row(t, model.at(oddity::asked::Number(t)), [&](double h) { return model.at(oddity::asked::Number(t + h)); "
      "});");
  const auto put_row = [&](const std::string& t, const std::string& seen, const std::string& row) {
    put("std::printf(\"%.17g\", " + t + ");\n    for (const double seen : " + seen +
            ") std::printf(\",%.17g\", seen);\n    std::printf(\"\\n\");",
        row);
  };
  put_row("t1", "observe(x, t1)",  // a step's rate at h = 0 is the model's own
          "print_row(t1, observe(x, t1), [&](double h) { return observe(step(x, t1, h), t1 + h); });");
  put_row("t", "at(t)", "print_row(t, at(t), [&](double h) { return at(t + h); });");
  if (is_short) put("sizeof(oddity::asked::Number) < sizeof(double) ? 3e-3 : 1e-4", "1e-4");
  return code;
}

using Rows = std::vector<Values>;

/// Output of the code.
struct Printed {
  std::vector<double> times;
  Rows rows;
};

/// Throws std::runtime_error if the code cannot be run, and CannotBeJudged if this machine is too busy for
/// that.
Printed printed(const std::string& code, const Program& program) {
  const std::string source = program.folder + "/asked.cpp", binary = program.folder + "/asked";
  std::ofstream(source) << code;
  const Ended compiled =
      run(program, {program.compiler, "-std=c++20", "-O1", "-ffp-contract=off", source, "-o", binary}, 120);
  if (is_starved(compiled)) throw CannotBeJudged("the machine is too busy to compile the code");
  if (compiled.code != 0)
    throw std::runtime_error("the code does not compile: " + compiled.err.substr(0, 300));
  const Ended ran = run(program, {binary}, 120);
  if (is_starved(ran)) throw CannotBeJudged("the machine is too busy to run the code");
  if (ran.code != 0) throw std::runtime_error("the code ends with " + std::to_string(ran.code));
  Printed all;
  std::istringstream lines(ran.out);
  std::string line;
  std::getline(lines, line);  // names
  while (std::getline(lines, line)) {
    Values row;
    std::istringstream in(line);
    std::string cell;
    std::getline(in, cell, ',');
    all.times.push_back(std::strtod(cell.c_str(), nullptr));
    while (std::getline(in, cell, ',')) row.push_back(std::strtold(cell.c_str(), nullptr));
    all.rows.push_back(std::move(row));
  }
  return all;
}

/// A fault in the drawn times; empty if they are as requested.
std::string unlike_asked(const Question& q, const std::vector<double>& times) {
  if (!q.frames_differ()) {
    const auto expected = q.times();
    if (times.size() != expected.size())
      return std::to_string(times.size()) + " for " + std::to_string(expected.size());
    for (std::size_t k = 0; k < times.size(); ++k)
      if (std::abs(times[k] - expected[k]) > 1e-9 * expected[k])
        return "frame " + std::to_string(k) + " is elsewhere";
    return {};
  }
  const double least = std::min((1 - q.jitter) / q.rate, q.longest_frame),
               most = q.drop > 0 ? q.longest_frame : std::min((1 + q.jitter) / q.rate, q.longest_frame);
  double last = 0, sum = 0;
  for (const double t : times) {
    if (t - last < least * (1 - 1e-9) || t - last > most * (1 + 1e-9))
      return "one takes " + shown(static_cast<Real>(t - last));
    sum += t - last;
    last = t;
  }
  if (times.empty() || last > q.horizon * (1 + 1e-9)) return "they end at " + shown(static_cast<Real>(last));
  if (q.longest_frame < INFINITY) return {};
  // Before any is dropped there are n of a mean length 1/rate, spread evenly; a part of these is drawn.
  const double n = q.horizon * q.rate, drawn = static_cast<double>(times.size()),
               spread = std::sqrt(n * (q.jitter * q.jitter / 3 + q.drop * (1 - q.drop)));
  return std::abs(drawn - n * (1 - q.drop)) > 6 * spread + 3 ? std::to_string(times.size()) + " are drawn"
                                                             : "";
}

// ---- the criteria, from their definitions -----------------------------------------------------------------

/// Largest distances from the reference, by unit; infinite for values that are not finite.
std::map<std::string, Real> distances(const Scene& scene, const Rows& seen, const Rows& truth) {
  std::map<std::string, Real> most;
  for (const Norm& norm : scene.norms)
    for (std::size_t k = 0; k < truth.size(); ++k) {
      Real square = 0;
      for (std::size_t i : norm.parts) square += (seen[k][i] - truth[k][i]) * (seen[k][i] - truth[k][i]);
      const Real distance = std::sqrt(square);
      most[norm.unit] = std::isfinite(distance) ? std::max(most[norm.unit], distance) : INFINITY;
    }
  return most;
}

/// Largest error of the energy, as a part of the largest kinetic energy.
Real off_energy(const Scene& scene, const Parameters& p, const Rows& seen, const Rows& truth) {
  Real most = 0, moves = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const Energy real = scene.energy(p, truth[k]), now = scene.energy(p, seen[k]);
    moves = std::max(moves, std::abs(real.kinetic));
    const Real off = std::abs(now.whole - real.whole);
    most = std::isfinite(off) ? std::max(most, off) : INFINITY;
  }
  return most / moves;
}

/// The mean time between the upward passages of the first observable through this height, in frames; NaN for
/// fewer than two.
Real period(const Rows& seen, Real height) {
  std::vector<Real> passages;
  for (std::size_t k = 1; k < seen.size(); ++k) {
    const Real before = seen[k - 1][0] - height, now = seen[k][0] - height;
    if (before < 0 && now >= 0) passages.push_back(static_cast<Real>(k) - now / (now - before));
  }
  return passages.size() < 2 ? NAN
                             : (passages.back() - passages.front()) / static_cast<Real>(passages.size() - 1);
}

Real off_period(const Rows& seen, const Rows& truth) {
  Real mean = 0;
  for (const Values& row : truth) mean += row[0] / static_cast<Real>(truth.size());
  return std::abs(period(seen, mean) / period(truth, mean) - 1);
}

// ---- the verdict ------------------------------------------------------------------------------------------

/// A measured, a requested and a stated error, in one unit.
struct Compared {
  std::string criterion, unit;
  Real measured, asked, said, uncertain;

  std::string text() const {
    return shown(measured) + " " + unit + ", said " + shown(said) + ", asked " + shown(asked);
  }
};

/// Empty if everything is true, as far as it can be seen: a stated error may come from a later frame.
/// `truth`: possible error of the program's own reference, below which it never states an error.
std::string untrue(const Compared& c, const Question& question, double seen_until, Real truth) {
  if (!(c.measured - c.uncertain <= c.asked * 1.0001L)) return c.criterion + " not held: " + c.text();
  // the stated error is the worst of the starts that were tried
  if (!(c.measured - c.uncertain <= 1.1L * c.said)) return c.criterion + " error understated: " + c.text();
  if (question.asked_alone && seen_until == 1 && c.said > 1.1L * truth * c.asked &&
      c.measured + c.uncertain < 0.9L * c.said && c.said > 1e-3L * c.asked)
    return c.criterion + " error overstated: " + c.text();
  return {};
}

Real stated_error(const Json& chosen, const Json& need, const std::string& unit) {
  // an error may be printed in the requested unit
  static const std::map<std::string, std::pair<std::string, Real>, std::less<>> shown_units{
      {"cm", {"m", 0.01L}},
      {"mm", {"m", 0.001L}},
      {"km", {"m", 1000}},
      {"deg", {"rad", std::numbers::pi_v<Real> / 180}}};
  for (const Json& symbol : need["unit"].items) {
    const auto found = shown_units.find(symbol.words);
    const std::string base = found == shown_units.end() ? symbol.words : found->second.first;
    if (base != unit) continue;
    const Json& error = chosen["error"];
    const Json& number = error.kind == Json::object ? error[symbol.words] : error;
    return static_cast<Real>(number.value) * (found == shown_units.end() ? 1 : found->second.second);
  }
  return NAN;
}

/// The program's motion compared with the reference, as far as that is known: to a tenth of the requested
/// error.
class Beside {
 public:
  Beside(const Question& q, Printed seen, bool in_float, bool with_rates)
      : q_(q), seen_(std::move(seen.rows)), times_(std::move(seen.times)), in_float_(in_float) {
    if (with_rates)
      for (Values& row : seen_) {
        const auto places = static_cast<std::ptrdiff_t>(row.size() / 3);
        Values& other = coarse_.emplace_back(row.begin(), row.begin() + places);
        other.insert(other.end(), row.begin() + 2 * places, row.end());
        row.resize(static_cast<std::size_t>(2 * places));
      }
    Truth truth = truth_of(q.scene->motion(q.parameters), times_, 20, with_rates);
    for (const Values& row : truth.frames)
      for (Real x : row) largest_ = std::max(largest_, std::abs(x));
    Real least = 1e-6L * largest_;
    if (q.criterion == "path")
      for (const Norm& norm : q.scene->norms) least = std::min(least, asked(norm.unit));
    std::size_t known = 0;
    while (known < truth.frames.size() && truth.uncertain[known] <= least / 10) ++known;
    if (known > 0) uncertain_ = truth.uncertain[known - 1];
    truth.frames.resize(known);
    truth_ = std::move(truth.frames);
  }

  /// The part of the motion for which the reference is known.
  double until() const { return static_cast<double>(truth_.size()) / static_cast<double>(times_.size()); }

  /// Errors by every requested criterion. Throws CannotBeJudged.
  std::vector<Compared> all(const Json& chosen, const Json& need) const {
    if (truth_.empty()) throw CannotBeJudged("the judge's own truth is not known");
    std::vector<Compared> all;
    if (q_.criterion == "path") {
      for (const auto& [unit, distance] : distances(*q_.scene, seen_, truth_))
        all.push_back({"path", unit, distance, asked(unit), stated_error(chosen, need, unit),
                       2 * uncertain_ + rounding()});
    } else {
      const Real allowed = q_.criterion == "bounded"
                               ? 1
                               : static_cast<Real>(q_.error_in(q_.criterion == "constraint" ? "m" : ""));
      const Real said =
          static_cast<Real>(chosen["also"] ? chosen["error"].value
                                           : chosen["error_in_needs"].value * static_cast<double>(allowed));
      all.push_back(by(q_.criterion, allowed, said));
    }
    for (const auto& [criterion, allowed] : q_.also)
      all.push_back(
          by(criterion, static_cast<Real>(allowed), static_cast<Real>(chosen["also"][criterion].value)));
    return all;
  }

 private:
  Real asked(const std::string& unit) const {
    return q_.digits ? std::pow(Real(10), -static_cast<Real>(*q_.digits)) * largest_
                     : static_cast<Real>(q_.error_in(unit));
  }
  /// Rounding error of a number of this size in the program. Only the code observes a motion in float by
  /// float: a few roundings, of terms that may be larger than their sum.
  Real rounding(Real size) const { return (in_float_ ? 0x1p-21L : 0x1p-50L) * size; }
  Real rounding() const { return rounding(largest_); }
  /// Largest observed size; observations may go farther than the reference.
  Real largest_seen() const {
    Real most = 0;
    for (const Values& row : seen_)
      for (Real x : row) most = std::isfinite(x) ? std::max(most, std::abs(x)) : INFINITY;
    return most;
  }

  /// Uncertainty of the energy. Rates are eighth-order differences of rounded places: relative to the
  /// fastest, and twice, as energy is quadratic.
  Real uncertain_energy() const {
    const Real apart = in_float_ ? 3e-3L : 1e-4L;
    Real fastest = 0;
    for (const Values& row : truth_)
      for (std::size_t i = row.size() / 2; i < row.size(); ++i) fastest = std::max(fastest, std::abs(row[i]));
    const Real of_width = std::abs(off_energy(*q_.scene, q_.parameters, coarse_, truth_) -
                                   off_energy(*q_.scene, q_.parameters, seen_, truth_));
    return (in_float_ ? 1e-3L : 1e-8L) + 4 * rounding() / apart / fastest + of_width;
  }

  /// Largest error of the constraint, at the drawn times multiplied by `scale`. A scale near 1 shows the
  /// effect of roundings of an angle w t.
  Real off_constraint(Real scale) const {
    Real most = 0;
    for (std::size_t k = 0; k < seen_.size(); ++k) {
      const Real off = q_.scene->off(q_.parameters, seen_[k], scale * static_cast<Real>(times_[k]));
      most = std::isfinite(off) ? std::max(most, off) : INFINITY;
    }
    return most;
  }

  Compared by(const std::string& criterion, Real allowed, Real said) const {
    if (criterion == "energy") {
      if (!q_.scene->energy) throw CannotBeJudged("the energy does not follow from the observables");
      if (allowed < uncertain_energy()) throw CannotBeJudged("an energy is not measured so exactly");
      return {criterion,
              "times the largest kinetic energy",
              off_energy(*q_.scene, q_.parameters, seen_, truth_),
              allowed,
              said,
              uncertain_energy()};
    }
    if (criterion == "period") {
      if (until() < 1) throw CannotBeJudged("chaos: a period is of the whole motion");
      return {criterion, "of it", off_period(seen_, truth_), allowed, said, 1e-9L};
    }
    if (criterion == "constraint") {
      if (!q_.scene->off) throw CannotBeJudged("nothing seen is held");
      const Real most = off_constraint(1), later = off_constraint(1 + rounding(1));
      return {criterion, "m", most, allowed, said, rounding(largest_seen()) + std::abs(later - most)};
    }
    if (until() < 1) throw CannotBeJudged("the truth's size is not known to the end");
    return {
        criterion, "in units of ten times the truth's size", largest_seen() / (10 * largest_), allowed, said,
        0};
  }

  const Question& q_;
  Rows seen_, coarse_, truth_;  ///< coarse: with the other rates
  std::vector<double> times_;
  bool in_float_;
  Real largest_ = 0, uncertain_ = 0;
};

Verdict wrong(const std::string& says, const Ended& ended, double known_until = 1) {
  return {Verdict::wrong, says, ended.seconds, known_until};
}

std::string first_line(const std::string& text) {
  return text.substr(0, std::min(text.find('\n'), std::size_t{200}));
}

bool names(const std::vector<std::string>& words, const Json& method) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return method["model"].words.find(word) != std::string::npos ||
           method["algorithm"].words.find(word) != std::string::npos;
  });
}

/// Contradictions in the answer apart from its error.
std::string contradiction(const Question& q, const Json& answer) {
  const Json &chosen = answer["chosen"], &need = answer["need"];
  if (need["horizon"].value != q.horizon || need["frames_per_second"].value != q.rate ||
      need["criterion"].words != q.criterion)
    return "echo: another question was answered";
  if (q.frames_differ() == need["frame_lengths"].words.empty()) return "echo: frames of other lengths";
  const bool in_float = chosen["precision"].words == "float";
  if (in_float ? !q.float_allowed : !q.double_allowed) return "precision: one that was not allowed";
  if (!q.only.empty() && !names(q.only, chosen)) return "only: a method that was not asked for";
  if (names(q.exclude, chosen)) return "exclude: a method that was excluded";
  if (q.one_step &&
      (chosen["algorithm"].words.starts_with("Adams-") || chosen["algorithm"].words.starts_with("CVODE")))
    return "one-step: a method with a history";
  if (chosen["holds"].value != 1) return "holds: the chosen method does not hold";
  const bool linear = q.scene->number == "3.9" || q.scene->number == "3.19" || q.scene->number == "3.29";
  if (linear && answer["predictable"]) return "chaos: a linear motion is called chaotic";
  if (const double budget = need["budget"].value;
      need["budget"] && chosen["seconds_per_frame"].value > budget)
    return "budget: it takes more";
  return {};
}

/// Evidence of the judge's own motion against a reason; empty without any.
std::string unfounded(const Question& q, const std::string& reason) {
  const bool no_period = reason.find("no two periods") != std::string::npos,
             not_held = reason.find("constraint to be off") != std::string::npos;
  if (not_held && q.scene->off) return "something is held";
  if (!no_period) return {};
  const auto times = q.times();
  const Truth truth = truth_of(q.scene->motion(q.parameters), times);
  return truth.frames.size() == times.size() && off_period(truth.frames, truth.frames) == 0
             ? "the motion has periods"
             : "";
}

/// Whether the answer in another format has the same choice: in its chosen row, or after "Take".
bool same_choice(const Question& q, const std::string& text, const Json& chosen) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (q.beside == "--csv" ? line.ends_with(",1") : line.starts_with("Take "))
      return line.find(q.beside == "--csv" ? chosen["algorithm"].words
                                           : chosen["model"].words.substr(0, 30)) != std::string::npos;
  return false;
}

void set_option(Question& q, const std::string& option, const std::string& value) {
  const auto given = std::ranges::find(q.words, option);
  if (given == q.words.end())
    q.words.insert(q.words.end(), {option, value});
  else
    *std::next(given) = value;
}

/// The question over the part of its horizon that was judged before its time was over, with time enough to be
/// answered whole.
Question over_part(Question q, double horizon) {
  if (horizon == q.horizon) return q;
  std::array<char, 40> text;
  const std::string shortest(text.data(), std::to_chars(text.data(), text.data() + text.size(), horizon).ptr);
  set_option(q, "--horizon", shortest);
  q.horizon = horizon;
  q.limit = 60;
  set_option(q, "--time-limit", "60s");
  return q;
}

Verdict judge_chosen(const Question& asked, const Program& program, const Ended& ended, const Json& answer) {
  if (const std::string off = contradiction(asked, answer); !off.empty()) return wrong(off, ended);
  const Question q = over_part(asked, answer["need"]["judged_over"].value);
  const Json& chosen = answer["chosen"];
  const bool is_whole =
      q.horizon == asked.horizon;  // a part is another question, for which times are measured again
  if (q.beside != "-" && is_whole) {
    const Ended other = ask(q, program, q.beside);
    if (other.code == 0 && !same_choice(q, other.out, chosen))
      return wrong("two answers: --json chooses " + chosen["model"].words + " by " +
                       chosen["algorithm"].words + ", unlike " + (q.beside.empty() ? "the text" : q.beside),
                   ended);
  }
  const Ended coded = ask(q, program, "--code");
  if (coded.code != 0) {
    if (coded.code < 0) return wrong("hang: --code", ended);
    if (coded.err.empty())
      return wrong("reason: --code ends with " + std::to_string(coded.code) + " without a message", ended);
    return {Verdict::not_run, first_line(coded.err), ended.seconds};
  }
  if (coded.out.find(chosen["model"].words + ", " + chosen["algorithm"].words) == std::string::npos &&
      coded.out.substr(0, 2000).find(chosen["algorithm"].words) == std::string::npos) {
    if (!is_whole)
      return {Verdict::not_run, "over its part alone, another method is cheapest", ended.seconds};
    return wrong("two answers: --json chooses " + chosen["model"].words + " by " + chosen["algorithm"].words +
                     ", unlike --code",
                 ended);
  }

  const bool with_energy = q.scene->energy && (q.criterion == "energy" || q.also.contains("energy"));
  Printed seen;
  try {
    seen = printed(with_energy ? with_rates(coded.out) : coded.out, program);
  } catch (const CannotBeJudged& why) {
    return {Verdict::not_run, why.what(), ended.seconds};
  } catch (const std::runtime_error& error) {
    return wrong(std::string("code: ") + error.what(), ended);
  }
  if (const std::string off = unlike_asked(q, seen.times); !off.empty())
    return wrong("frames: " + off, ended);
  const Beside beside(q, std::move(seen), chosen["precision"].words == "float", with_energy);
  try {
    std::string says = chosen["model"].words + " by " + chosen["algorithm"].words;
    const auto truth = static_cast<Real>(answer["explanation"]["truths"]["error_in_needs"].value);
    for (const Compared& c : beside.all(chosen, answer["need"])) {
      if (const std::string off = untrue(c, q, beside.until(), truth); !off.empty())
        return wrong(off, ended, beside.until());
      says += "; " + c.text();
    }
    return {Verdict::right, says, ended.seconds, beside.until()};
  } catch (const CannotBeJudged& why) {
    return {Verdict::not_run, why.what(), ended.seconds, beside.until()};
  }
}

}  // namespace

const char* name_of(Verdict::Kind kind) {
  return std::array{"right", "right as far as it can be run", "refused", "nothing holds", "out of time",
                    "FALSE"}[kind];
}

std::string output_of(const Program& program, const Words& words) {
  Words all{program.oddity};
  all.insert(all.end(), words.begin(), words.end());
  const Ended ended = run(program, all, 120);
  if (ended.code != 0) throw std::runtime_error(program.oddity + " fails: " + ended.err);
  return ended.out;
}

Verdict judge(const Question& q, const Program& program) {
  const Ended ended = ask(q, program, "--json");
  if (ended.code < 0) return wrong("hang: no end after " + shown(ended.seconds) + " s", ended);
  if (ended.code > 2)
    return wrong("crash: exit code " + std::to_string(ended.code) + " " + first_line(ended.err), ended);
  // Allows the limit, a tenth more, and time to begin and end. Counts CPU time too, as the machine may be
  // busy.
  if (std::min(ended.seconds, ended.processor_seconds) > 1.1 * q.limit + 0.6)
    return wrong("limit: " + shown(ended.seconds) + " s for " + shown(q.limit), ended);
  if (ended.code == 2) {
    if (ended.err.empty()) return wrong("reason: exit code 2 and no word", ended);
    const bool is_time = ended.err.find("time limit") != std::string::npos ||
                         ended.err.find("--time-limit") != std::string::npos;
    if (const std::string why = unfounded(q, ended.err); !why.empty())
      return wrong("reason: " + first_line(ended.err) + "; but " + why, ended);
    return {is_time ? Verdict::out_of_time : Verdict::refused, first_line(ended.err), ended.seconds};
  }
  Json answer;
  try {
    answer = JsonReader(ended.out).whole();
  } catch (const std::runtime_error&) {
    return wrong("format: --json prints no JSON", ended);
  }
  const bool is_whole = answer["need"]["judged_over"].value == q.horizon;
  if ((ended.code == 0) != (is_whole && answer["chosen"]))
    return wrong("exit code: not as the answer is", ended);
  if (!answer["chosen"]) {
    if (answer["candidates"].items.empty())
      return wrong("reason: nothing holds, and nothing was tried", ended);
    const Json& budget = answer["need"]["budget"];
    for (const Json& t : answer["candidates"].items)
      if (t["holds"].value == 1 &&
          (!budget || (t["seconds_per_frame"] && t["seconds_per_frame"].value <= budget.value)))
        return wrong(
            "reason: nothing holds, but " + t["model"].words + " by " + t["algorithm"].words + " does",
            ended);
    return {Verdict::nothing_holds, std::to_string(answer["candidates"].items.size()) + " methods tried",
            ended.seconds};
  }
  return judge_chosen(q, program, ended, answer);
}

}  // namespace questions
