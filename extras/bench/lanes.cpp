#include "extras/bench/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "chapters/contents.hpp"
#include "extras/bench/fresh_pages.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

using lanes::Batch, lanes::Fixed, lanes::Registers, lanes::SceneInLanes, lanes::Steps;

constexpr std::size_t bodies = 512;
constexpr double apart = 1e-4;  // from body to body, in each parameter
constexpr int frames = 15, steps_a_frame = 4, spans = 3;
constexpr double part_of_start = 0.999;  // at its start a body may rest, and nothing would be computed
constexpr double frame = 1.0 / 60;
constexpr double of_fixed_steps = 0.9, of_own_steps = 0.8;

std::vector<Registers> wide_ones() {
  std::vector<Registers> all;
  for (Registers r : {Registers::baseline, Registers::avx2, Registers::avx512})
    if (lanes::can(r)) all.push_back(r);
  return all;
}

/// CPU time of this thread, independent of the machine's load.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// Time between two readings of the clock with nothing between them: a tenth of the shortest span.
double seconds_of_looking() {
  static const double least = [] {
    double found = 1;
    for (int i = 0; i < 1000; ++i) {
      const double start = processor_seconds();
      found = std::min(found, processor_seconds() - start);
    }
    return found;
  }();
  return least;
}

/// A model by one algorithm, as single numbers and in all kinds of registers in turn.
class Contestant {
 public:
  Contestant(const SceneInLanes& scene, std::size_t model, Precision precision, std::string algorithm,
             Steps steps, std::function<void(Batch&, Registers)> run)
      : number_(scene.number),
        model_(lanes::model_names(scene)[model]),
        algorithm_(std::move(algorithm)),
        precision_(precision),
        batch_(scene, model, precision,
               lanes::apart(scene, exercise(scene.number).parameters, bodies, apart)),
        steps_(steps),
        run_(std::move(run)) {}

  static const Exercise& exercise(std::string_view number) {
    return std::ranges::find(registry(), exercise_number(number), &Entry::number)->exercise;
  }

  void measure() {
    const double alone = seconds(Registers::one);
    const Batch expected = batch_;
    alone_.push_back(alone);
    for (Registers r : wide_ones()) {
      Times& times = wide_[r];
      times.seconds.push_back(seconds(r));
      times.shares.push_back(alone / times.seconds.back() / static_cast<double>(batch_.width(r)));
      times.same = 0;
      for (std::size_t i = 0; i < bodies; ++i)
        times.same += std::ranges::equal(batch_.state(i), expected.state(i));
    }
  }
  void add_to(std::vector<LanesResult>& results) const {
    for (const auto& [r, times] : wide_)
      results.push_back({number_, model_, algorithm_, precision_, r, batch_.width(r), spread_of(alone_),
                         spread_of(times.seconds), spread_of(times.shares),
                         algorithm_ == lanes::own_steps_name ? of_own_steps : of_fixed_steps, bodies,
                         times.same});
  }

 private:
  struct Times {
    std::vector<double> seconds, shares;
    std::size_t same = 0;
  };

  /// The shortest of several spans from the same start, after one that is not timed.
  double seconds(Registers registers) {
    double least = std::numeric_limits<double>::infinity();
    for (int span = 0; span <= spans; ++span) {
      batch_.begin_again(part_of_start);
      batch_.group(registers, steps_);
      const double start = processor_seconds();
      run_(batch_, registers);
      const double passed = processor_seconds() - start - seconds_of_looking();
      if (span > 0) least = std::min(least, passed);
    }
    return least / (static_cast<double>(bodies) * frames);
  }

  std::string number_, model_, algorithm_;
  Precision precision_;
  Batch batch_;
  Steps steps_;
  std::function<void(Batch&, Registers)> run_;
  std::vector<double> alone_;
  std::map<Registers, Times> wide_;
};

/// The operations alone, of one precision, in all kinds of registers in turn.
class ArithmeticAlone {
 public:
  explicit ArithmeticAlone(Precision precision) : precision_(precision) {}

  void measure() {
    for (int operation = 0; operation < lanes::arithmetic_count; ++operation) {
      const double alone = seconds(Registers::one, operation);
      for (Registers r : wide_ones())
        at_once_[r][static_cast<std::size_t>(operation)].push_back(alone / seconds(r, operation) *
                                                                   static_cast<double>(of(r).width));
    }
  }
  void add_to(std::vector<ArithmeticResult>& results) const {
    for (const auto& [registers, measured] : at_once_) {
      ArithmeticResult result{registers, precision_, of(registers).width, {}};
      for (std::size_t i = 0; i < measured.size(); ++i) result.at_once[i] = spread_of(measured[i]);
      results.push_back(result);
    }
  }

 private:
  const lanes::Repeated& of(Registers registers) const {
    return lanes::repeated_operations(registers)[precision_ == Precision::in_float];
  }
  double seconds(Registers registers, int operation) {
    constexpr long times = 20000;
    const double start = processor_seconds();
    left_ = of(registers).run(static_cast<lanes::Arithmetic>(operation), times);
    return processor_seconds() - start;
  }

  Precision precision_;
  std::map<Registers, std::array<std::vector<double>, lanes::arithmetic_count>> at_once_;
  volatile double left_ = 0;
};

void by_fixed_steps(Batch& batch, Registers registers, Fixed algorithm) {
  batch.steps(registers, algorithm, 0, frame / steps_a_frame, frames * steps_a_frame);
}
void by_own_steps(Batch& batch, Registers registers, Precision precision) {
  batch.own_steps(registers, 0, frames * frame, precision == Precision::in_double ? 1e-9 : 1e-5, frame);
}

std::vector<Contestant> contestants(const std::vector<std::string>& numbers) {
  std::vector<Contestant> all;
  for (const SceneInLanes& scene : lanes::scenes_in_lanes()) {
    if (!numbers.empty() && std::ranges::find(numbers, scene.number) == numbers.end()) continue;
    for (std::size_t model = 0; model < scene.models; ++model) {
      if (scene.beginnings[model].unknowns == 0) continue;
      for (Precision precision : {Precision::in_double, Precision::in_float}) {
        for (Fixed algorithm : {Fixed::runge_kutta_4, Fixed::velocity_verlet, Fixed::symplectic_euler})
          if (scene.compiled[0][model].fixed[static_cast<int>(algorithm)])
            all.emplace_back(scene, model, precision, std::string(lanes::name_of(algorithm)), Steps::fixed,
                             [=](Batch& batch, Registers r) { by_fixed_steps(batch, r, algorithm); });
        all.emplace_back(scene, model, precision, std::string(lanes::own_steps_name), Steps::own,
                         [=](Batch& batch, Registers r) { by_own_steps(batch, r, precision); });
      }
    }
  }
  return all;
}

std::string_view verdict_of(const LanesResult& r) {
  if (r.broken()) return "BROKEN";
  if (r.holds()) return "holds";
  if (!r.is_asked()) return "not asked";
  return r.holds_of_arithmetic() ? "arithmetic" : "undecided";
}

std::string in_nanoseconds(double seconds) { return format_significant(seconds * 1e9, 3); }

/// "7.1 ns, 0.95 +- 0.01".
std::string cell(const LanesResult& r) {
  return in_nanoseconds(r.in_lanes.median) + " ns, " + format_significant(r.share.median, 2) + " +- " +
         format_significant(r.share.half_width, 1);
}

/// How many results with fixed steps and with their own steps hold, on one kind of register.
std::string summary(const LanesBench& bench, Registers registers) {
  std::string text;
  for (bool own : {false, true}) {
    std::size_t all = 0, hold = 0, of_arithmetic = 0;
    std::vector<double> shares;
    for (const LanesResult& r : bench.results) {
      if (r.registers != registers || (r.algorithm == lanes::own_steps_name) != own) continue;
      ++all, hold += r.holds(), of_arithmetic += r.holds_of_arithmetic();
      shares.push_back(r.share.median);
    }
    if (all == 0) continue;
    text += (own ? "; own steps: a share of at least "
                 : std::string(lanes::name_of(registers)) + ", fixed steps: a share of at least ") +
            format_significant(own ? of_own_steps : of_fixed_steps, 1) + " in " + std::to_string(hold) +
            " of " + std::to_string(all) +
            (of_arithmetic > hold
                 ? ", and relative to the ceiling of its arithmetic in " + std::to_string(of_arithmetic)
                 : "") +
            " (median " + format_significant(spread_of(shares).median, 2) + ", least " +
            format_significant(std::ranges::min(shares), 2) + ")";
  }
  return text + "\n";
}

/// "AVX-512: adds 4.0, multiplies 4.0, divides 4.0, roots 4.2 doubles at once, of 8"
std::string text_of(const ArithmeticResult& a) {
  constexpr std::string_view names[] = {"adds", "multiplies", "divides", "roots"};
  std::string text(lanes::name_of(a.registers));
  for (int i = 0; i < lanes::arithmetic_count; ++i)
    text += std::string(i ? ", " : ": ") + std::string(names[i]) + " " +
            format_significant(a.at_once[i].median, 2);
  return text + " at once, of " + std::to_string(a.width) +
         (a.precision == Precision::in_double ? " doubles\n" : " floats\n");
}

}  // namespace

double ArithmeticResult::ceiling() const {
  double most = 0;
  for (const Spread& numbers : at_once) most = std::max(most, numbers.median + numbers.half_width);
  return std::min(1.0, most / static_cast<double>(width));
}

bool LanesBench::broken() const { return std::ranges::any_of(results, &LanesResult::broken); }

LanesBench bench_lanes(const std::vector<std::string>& numbers, int rounds, const Progress& progress) {
  auto all = contestants(numbers);
  std::array arithmetic{ArithmeticAlone(Precision::in_double), ArithmeticAlone(Precision::in_float)};
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress("models in lanes", round, static_cast<std::size_t>(rounds));
    move_code_to_fresh_pages();
    for (ArithmeticAlone& one : arithmetic) one.measure();
    for (Contestant& one : all) one.measure();
  }
  LanesBench bench{lanes::widest(), {}};
  for (const Contestant& one : all) one.add_to(bench.results);
  for (const ArithmeticAlone& one : arithmetic) one.add_to(bench.arithmetic);
  for (LanesResult& r : bench.results)
    for (const ArithmeticResult& a : bench.arithmetic)
      if (a.registers == r.registers && a.precision == r.precision) r.ceiling = a.ceiling();
  return bench;
}

std::string lanes_view(const LanesBench& bench, const Screen& screen) {
  std::set<Registers> kinds;
  for (const LanesResult& r : bench.results) kinds.insert(r.registers);
  std::vector<std::vector<std::string>> rows{{"", "model", "algorithm", "in", "alone"}};
  for (Registers kind : kinds) rows[0].push_back(std::string(lanes::name_of(kind)));
  rows[0].push_back("same bits");
  std::size_t same = 0, all = 0;
  for (std::size_t i = 0; i < bench.results.size();) {
    const LanesResult& first = bench.results[i];
    rows.push_back({first.number, first.model, first.algorithm, std::string(name_of(first.precision)),
                    in_nanoseconds(first.alone.median) + " ns"});
    std::size_t least = first.bodies;
    for (Registers kind : kinds) {
      const LanesResult& r = bench.results[i];
      if (r.registers != kind) throw std::logic_error("the results of lanes have not all kinds of registers");
      rows.back().push_back(screen.styled(r.holds() ? Style::good : Style::doubtful, cell(r)));
      least = std::min(least, r.same);
      same += r.same, all += r.bodies, ++i;
    }
    rows.back().push_back(std::to_string(least) + " of " + std::to_string(first.bodies));
  }
  std::string text =
      wrapped(
          "Time per body and frame alone and in lanes, and the speed-up as a share of the register width:\n",
          screen) +
      aligned(std::move(rows), screen,
              {.shorten = {"model", "algorithm"}, .leave_out = {"SSE2", "alone"}, .first_above = true}) +
      wrapped("\nA frame is 1/60 s, of " + std::to_string(steps_a_frame) +
                  " fixed steps; own steps hold their error at 1e-9, in float at 1e-5. " +
                  std::to_string(bodies) + " bodies with different parameters, " + std::to_string(frames) +
                  " frames at once: the least of " + std::to_string(spans) +
                  " times, after one that is not timed.\nTaken on this machine: " +
                  std::string(lanes::name_of(bench.taken)) + ".\n",
              screen);
  if (!bench.arithmetic.empty())
    text += wrapped(
        "Throughput of its arithmetic, measured in this run by independent operations: doubles at once in the "
        "time of one alone. An instruction on a wider register may take longer: a model that keeps the "
        "arithmetic busy alone then stays below the register's width.\n",
        screen);
  for (const ArithmeticResult& a : bench.arithmetic) text += "  " + text_of(a);
  for (Registers kind : kinds) text += wrapped(summary(bench, kind), screen);
  return text + std::to_string(same) + " of " + std::to_string(all) +
         " bodies have the bits that they have alone.\n";
}

Table lanes_table(const LanesBench& bench) {
  Table table{{"scene", "model", "algorithm", "precision", "registers", "width", "taken", "seconds_alone",
               "half_width_alone", "seconds", "half_width", "share", "half_width_of_share", "at_least",
               "ceiling", "verdict", "bodies", "same_bits"},
              {}};
  for (const LanesResult& r : bench.results)
    table.rows.push_back({r.number, r.model, r.algorithm, std::string(name_of(r.precision)),
                          std::string(lanes::name_of(r.registers)), static_cast<long>(r.width),
                          std::string(r.registers == bench.taken ? "yes" : "no"), r.alone.median,
                          r.alone.half_width, r.in_lanes.median, r.in_lanes.half_width, r.share.median,
                          r.share.half_width, r.at_least, r.ceiling, std::string(verdict_of(r)),
                          static_cast<long>(r.bodies), static_cast<long>(r.same)});
  return table;
}

}  // namespace oddity
