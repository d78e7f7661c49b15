// Choosing, on a made-up scene whose true motion is a = x(t) for all t, with methods of known errors.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <set>
#include <thread>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/choose_view.hpp"
#include "report/study/choose.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/ladder.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/integrate.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

constexpr Parameter parameters[] = {{"a", 1, "m", "where it stays", 0, 10}};

/// x = a (1 + error) at one frame in the middle, and a at the others, with this many evaluations.
Method method(std::string model, std::string algorithm, Resolution resolution, double a, int frames,
              std::function<double(double)> error, std::function<long(double)> evaluations) {
  return {std::move(model), std::move(algorithm), std::move(resolution), [=](double setting) {
            std::vector<double> x(static_cast<std::size_t>(frames), a);
            x[x.size() / 2] *= 1 + error(setting);
            return Answer{Value(std::move(x)), evaluations(setting)};
          }};
}

/// "coarse": off by a tenth of (a - 1). "stepping": off by its step, in float by at least 0.02. "rich":
/// exact, at a hundred evaluations.
Quantity place(const Parameters& p, const Horizon& horizon, const Reference&) {
  const double a = p["a"];
  const auto everywhere = static_cast<std::size_t>(horizon.count());
  Quantity q{"place", "m",        "", {"exact", Value(std::vector<double>(everywhere, a))},
             1e-16,   {1e-6, ""}, {}, {}};
  q.samples = horizon.count();
  const auto one = [](double) { return 1L; };
  q.add(method(
      "coarse", "closed form", no_resolution(), a, horizon.count(),
      [a](double) { return std::abs(a - 1) / 10 + 1e-4; }, one));
  q.add(method(
      "stepping", "explicit", halving("step", 1, 4), a, horizon.count(), [](double h) { return h; },
      [=](double h) { return std::lround(horizon.end / h); }));
  q.add(method(
      "rich", "everything", tolerances(), a, horizon.count(), [](double e) { return e * 1e-4 + 1e-14; },
      [](double e) { return std::lround(-100 * std::log10(e)); }));
  Method single = method(
      "stepping", "explicit in float", halving("step", 1, 4), a, horizon.count(),
      [](double h) { return std::max(h, 0.02); }, [=](double h) { return std::lround(horizon.end / h); });
  single.precision = Precision::in_float;
  q.add(std::move(single));
  q.add(
      {"absent", "raises", no_resolution(), [](double) -> Answer { throw std::runtime_error("not here"); }});
  return q;
}

const Entry entry{{3, 99},
                  "",
                  {"made up", "", parameters,
                   Scene{place, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};

/// One nanosecond per evaluation.
Time counted_cost(const Method& m, double setting) {
  return {static_cast<double>(m.run(setting).evaluations) * 1e-9, 0};
}

Need asked(double error, double horizon, double frames_per_second = 10) {
  Need need{error};
  need.horizon = horizon;
  need.frames_per_second = frames_per_second;
  return need;
}

Choice choose_for(const Need& need, double a = 1, const Price& price = counted_cost) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(entry);
  task.parameters.set("a", a);
  return choose(task, need, truth, price);
}

}  // namespace

TEST_CASE("the cheapest method that holds is chosen, and tested on other starts", "[choose]") {
  const Choice choice = choose_for(asked(0.05, 10));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "coarse");
  CHECK(choice.chosen->evaluations_per_frame == 0.01);
  CHECK(choice.margin() > 1);
  CHECK(choice.seen.size() == 3);
  CHECK(choice.unseen.size() == 3);
  CHECK(choice.seen != choice.unseen);
  CHECK_FALSE(choice.next_cheaper);
  REQUIRE(choice.next_richer);
  CHECK(choice.next_richer->model == "rich");
  std::set<std::pair<std::string, std::string>> methods;
  for (const Candidate& c : choice.candidates) CHECK(methods.emplace(c.model, c.algorithm).second);
  CHECK(methods.size() >= 2);
  for (std::size_t i = 1; i < choice.candidates.size(); ++i)  // methods without a time come last
    CHECK_FALSE(choice.candidates[i - 1].seconds_per_frame > choice.candidates[i].seconds_per_frame);
}

TEST_CASE("every stage reports progress up to 100 %", "[choose]") {
  std::mutex telling;
  std::map<std::string, std::pair<double, std::size_t>> last;
  const Progress progress = [&](const std::string& stage, double done, std::size_t all) {
    const std::lock_guard lock(telling);
    last[stage] = {done, all};
  };
  choose(Task(entry), asked(0.05, 10), Reference(std::string(ODDITY_SOURCE) + "/reference"), counted_cost,
         progress);
  for (const char* stage : {"making the true motions", "making more true motions", "trying the methods"}) {
    INFO(stage);
    REQUIRE(last.contains(stage));
    CHECK(last[stage].first == static_cast<double>(last[stage].second));
  }
}

TEST_CASE("a possible tie is refined up to twice the cost of the chosen one, and is not the next cheaper",
          "[choose]") {
  Need need = asked(0.0056, 10);  // 20 steps a frame; 16 are tried at once
  need.exclude = {"coarse"};
  const auto price = [](const Method& m, double setting) -> Time {
    return {m.model == "rich" ? 1.8e-6 : counted_cost(m, setting).seconds, 0};
  };
  const Choice dearer = choose_for(need, 1, price);
  REQUIRE(dearer.chosen);
  CHECK(dearer.chosen->model == "rich");
  REQUIRE(dearer.ties.size() == 1);
  CHECK(std::lround(1 / (10 * dearer.ties.front().setting)) == 20);
  const auto cheaper = [&](const Method& m, double setting) -> Time {
    return {m.model == "rich" ? 2.2e-6 : counted_cost(m, setting).seconds, 0};
  };
  const Choice tie = choose_for(need, 1, cheaper);
  CHECK(tie.chosen->model == "rich");  // being more accurate
  CHECK(tie.ties.size() == 1);
  REQUIRE(tie.next_cheaper);
  CHECK_FALSE(tie.next_cheaper->holds());
}

TEST_CASE("a simple method is refined to its margin where another holds at less work", "[choose]") {
  Need need = asked(0.017, 10);  // with a margin of three 20 steps a frame; 16 are tried at once
  need.exclude = {"coarse"};
  need.objective = Objective::simple;
  const Choice choice = choose_for(need);
  REQUIRE(choice.chosen);
  CHECK(choice.by_objective);
  CHECK(choice.chosen->model == "stepping");
  CHECK(std::lround(1 / (10 * choice.chosen->setting)) == 20);
}

TEST_CASE("a method that does not hold names the start with its largest error", "[choose]") {
  std::vector<Start> starts;
  for (int a : {2, 5, 3}) {
    Parameters p(entry.exercise.parameters);
    p.set("a", a);
    starts.push_back({"a = " + std::to_string(a), place(p, {1, 10}, Reference::nothing())});
  }
  const Method& coarse = starts[0].motion.methods[0];
  CHECK(evaluate(starts, coarse, 0, asked(0.01, 1)).where == "a = 5");
  const auto until_one_fails = [&](const std::vector<std::string>& first) {
    return evaluate_until_one_fails(in_order(starts, first), coarse, 0, asked(0.01, 1)).where;
  };
  CHECK(until_one_fails({}) == "a = 2");
  CHECK(until_one_fails({"a = 3", "a = 5"}) == "a = 3");
}

TEST_CASE("starts are tried in the order of those named, and then in their own", "[choose]") {
  std::vector<Start> starts;
  for (const char* says : {"asked", "easy", "hard", "harder"}) starts.push_back({says, {}});
  std::string order;
  for (const Start* start : in_order(starts, std::vector<std::string>{"harder", "gone", "hard", "harder"}))
    order += start->says + " ";
  CHECK(order == "harder hard asked easy ");
}

TEST_CASE("an exception on a start counts if the starts before it hold", "[choose]") {
  std::vector<Start> starts;
  for (const std::string says : {"holds", "fails", "throws"}) {
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = 0.01;
    q.methods = {{"model", "by hand", no_resolution(), [says](double) {
                    return Answer{Value(std::vector<double>(100, says == "fails" ? 2.0 : 1.0)), 1};
                  }}};
    starts.push_back({says, std::move(q)});
  }
  starts.back().motion.reference_error = starts.back().motion.need.allowed;  // which decides nothing
  starts.back().sharper =
      std::make_shared<Lazy<Start>>([]() -> Start { throw BadInput("not known any better"); });
  const auto tried = [&](const std::vector<std::string>& first) {
    return evaluate_until_one_fails(in_order(starts, first), starts[0].motion.methods[0], 0, asked(0.01, 10));
  };
  for (int times = 0; times < 200; ++times) CHECK(tried({"holds", "fails"}).where == "fails");
  CHECK(complaint([&] { tried({"holds", "throws"}); }) == "not known any better");
}

TEST_CASE("the first setting that holds is found, and the first that holds with a margin", "[choose]") {
  Need need = asked(0.1, 10);
  need.objective = Objective::simple;  // with a margin of three
  const Horizon horizon{need.horizon, static_cast<int>(need.frames())};
  std::vector<Start> starts{{"here", place(Parameters(parameters), horizon, Reference::nothing())}};
  starts[0].motion.need.allowed = need.error;
  const Method& stepping = starts[0].motion.methods[1];
  Ladder tries(stepping, need);
  while (!tries.is_over()) tries.go_on(1e6, starts, need);
  const Ladder::Found found = tries.found(need);
  REQUIRE(found.first);
  REQUIRE(found.with_margin);
  CHECK(found.first->error <= 1);
  CHECK(found.first->error > 1.0 / 3);
  CHECK(found.with_margin->error <= 1.0 / 3);
}

namespace {

constexpr double far_off = 300;  // in tolerances, up to the motion's size

/// Errors that grow with the step to the power `order`, up to the motion's size; unstable beyond `limit`.
struct Converging {
  std::string algorithm;
  double order, error_at_a_frame;
  double limit = 1;
  double beyond = far_off;
  std::vector<Start> starts = {};
  Need need = asked(1, 10);

  Ladder tries() {
    const Horizon horizon{need.horizon, static_cast<int>(need.frames())};
    Quantity q = place(Parameters(parameters), horizon, Reference::nothing());
    q.need.allowed = need.error;
    const double frame = 1 / need.frames_per_second;
    q.methods = {method(
        "model", algorithm, halving("step", 1, 4), 1, horizon.count(),
        [*this, frame](double h) {
          return h / frame > limit ? beyond
                                   : std::min(far_off, error_at_a_frame * std::pow(h / frame, order));
        },
        [=](double h) { return std::lround(horizon.end / h); })};
    starts = {{"here", std::move(q)}};
    return {starts.front().motion.methods.front(), need};
  }

  /// Steps per frame.
  std::vector<long> tried() {
    Ladder all = tries();
    while (!all.is_over()) all.go_on(1e6, starts, need);
    std::vector<long> steps;
    for (const Candidate& c : all.candidates)
      steps.push_back(std::lround(1 / (c.setting * need.frames_per_second)));
    return steps;
  }
};

}  // namespace

TEST_CASE("settings that cannot hold by the algorithm's order are skipped", "[choose]") {
  using Steps = std::vector<long>;
  // Errors 300 times too large: with a fifth power and a safety factor of four, the step must shrink 2.4
  // times at least.
  CHECK(Converging{"Runge-Kutta 4", 4, 1e5}.tried() == Steps{1, 3, 8, 12, 16, 20});
  // Steps skipped because of instability are tried when a finer one holds.
  CHECK(Converging{"Runge-Kutta 4", 4, 0.5, 0.3}.tried() == Steps{1, 3, 4});
  CHECK(Converging{"Runge-Kutta 4", 4, 0.5, 0.5}.tried() == Steps{1, 2});
  // The finest is tried before the answer is that nothing holds.
  CHECK(Converging{"explicit Euler", 0, 1e5}.tried() == Steps{1, 10, 96, 512});
  // Between the skipped steps and one that holds with a margin, the coarsest that does is found.
  Converging with_margin{"Runge-Kutta 4", 4, 200, 0.3};
  with_margin.need.objective = Objective::simple;
  CHECK(with_margin.tried() == Steps{1, 3, 4, 5});
  // An error that is not finite has no size.
  CHECK(Converging{"Runge-Kutta 4", 4, 0.5, 0.3, std::numeric_limits<double>::infinity()}.tried() ==
        Steps{1, 2, 3, 4});
  // With an unknown order, or thoroughly, all are tried.
  CHECK(Converging{"by hand", 4, 1e3}.tried() == Steps{1, 2, 3, 4, 5, 6});
  Converging thorough{"Runge-Kutta 4", 4, 1e3};
  thorough.need.thorough = true;
  CHECK(thorough.tried() == Steps{1, 2, 3, 4, 5, 6});
}

TEST_CASE("in chaos an error as large as the motion shows how much finer a step has to be", "[choose]") {
  // Errors and disturbances grow by this factor each frame, up to the size of the motion.
  Need need = asked(0.1, 10);
  const auto tried = [&](double by, double at_first, bool is_chaotic) {
    const auto grown = [by](double from, int frame) { return std::min(3.0, from * std::pow(by, frame)); };
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = need.error;
    Parting parting{{}, is_chaotic};
    for (int k = 0; k < 100; ++k) parting.until.push_back(grown(1e-9, k));
    q.methods = {{"model", "explicit Euler", halving("step", 1, 4), [=](double h) {
                    std::vector<double> x;
                    for (int k = 0; k < 100; ++k) x.push_back(1 + grown(at_first * 10 * h, k));
                    return Answer{Value(std::move(x)), std::lround(10 / h)};
                  }}};
    std::vector<Start> starts{{"here", std::move(q)}};
    starts[0].parting = std::make_shared<Lazy<Parting>>([=] { return parting; });
    Ladder tries(starts[0].motion.methods[0], need);
    while (!tries.is_over()) tries.go_on(1e6, starts, need);
    std::vector<long> steps;
    for (const Candidate& c : tries.candidates) steps.push_back(std::lround(1 / (10 * c.setting)));
    return steps;
  };
  using Steps = std::vector<long>;
  // 0.001 grows to 125 times the tolerance, of which a 16th is less than the 30 seen.
  CHECK(tried(1.1, 0.001, true) == tried(1.1, 0.001, false));
  // 0.09 grows to 11,270 times: with a second power and a safety factor of four, the step must shrink 13
  // times at least.
  CHECK(tried(1.1, 0.09, false) == Steps{1, 3, 10, 32, 96, 384, 512});
  CHECK(tried(1.1, 0.09, true) == Steps{1, 16, 64, 192, 512});
  // To 62 million times: not even 512 steps a frame can hold.
  CHECK(tried(1.2, 0.09, false).back() == 512);
  CHECK(tried(1.2, 0.09, true) == Steps{1});
}

TEST_CASE("a method that holds with the margin at no setting does not do so on more starts", "[choose]") {
  Need need = asked(0.1, 10);
  need.objective = Objective::simple;  // with a margin of three
  const auto tried = [&](double finest_error) {
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = need.error;
    q.methods = {{"model", "by hand", halving("step", 1, 2), [=](double h) {
                    const double error = h > 0.06 ? 0.2 : finest_error;
                    return Answer{Value(std::vector<double>(100, 1 + error)), 1};
                  }}};
    const std::vector<Start> starts{{"here", std::move(q)}};
    Ladder tries(starts[0].motion.methods[0], need);
    CHECK(tries.may_hold_with_margin());
    while (!tries.is_over()) tries.go_on(1e6, starts, need);
    CHECK(tries.may_hold_with_margin());
    tries.again(need);
    CHECK_FALSE(tries.is_over());
    return tries.may_hold_with_margin();
  };
  CHECK(tried(0.01));
  CHECK_FALSE(tried(0.09));
}

TEST_CASE("a method that ignores its tolerance is not tried again", "[choose]") {
  Need need = asked(0.1, 10);
  need.objective = Objective::simple;  // with a margin of three
  Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
  q.need.allowed = need.error;
  const auto with_error = [&](const std::string& model, double error) {
    return method(
        model, "deaf", tolerances(), 1, 100, [=](double) { return error; }, [](double) { return 9L; });
  };
  q.methods = {with_error("near", 0.05), with_error("far", 0.2)};
  const std::vector<Start> starts{{"here", q}};
  const auto settings_tried = [&](const Method& m) {
    Ladder tries(m, need);
    while (!tries.is_over()) tries.go_on(1e6, starts, need);
    return tries.candidates.size();
  };
  CHECK(settings_tried(starts[0].motion.methods[0]) == 2);
  CHECK(settings_tried(starts[0].motion.methods[1]) == 3);  // a failing method is tried at the finest, too
}

TEST_CASE("a start on which a method fails is tried first at the next setting", "[choose]") {
  std::vector<std::string> seen;
  std::vector<Start> starts;
  for (const char* says : {"easy", "hard"}) {
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = 0.01;
    const double hard = says == std::string("hard") ? 100 : 1;
    q.methods = {{"model", "by hand", halving("step", 1, 4), [&seen, says, hard](double h) {
                    seen.push_back(says);
                    return Answer{Value(std::vector<double>(100, 1 + 0.09 * hard * h)), 1};
                  }}};
    starts.push_back({says, std::move(q)});
  }
  Ladder tries(starts[0].motion.methods[0], asked(0.01, 10));
  while (!tries.is_over() && tries.candidates.size() < 3)
    tries.go_on(tries.expected_evaluations(), starts, asked(0.01, 10));
  CHECK(seen.size() >= 3);
  CHECK(std::vector(seen.begin(), seen.begin() + 3) == std::vector<std::string>{"easy", "hard", "hard"});
}

TEST_CASE("the start that is hardest for others is tried first, unless another one failed the method",
          "[choose]") {
  std::vector<std::string> seen;
  std::mutex seeing;
  std::vector<Start> starts;
  for (const std::string says : {"asked", "hard", "harder"}) {
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = 0.01;
    // With one step a frame all starts fail; with two only the last one.
    q.methods = {{"model", "by hand", halving("step", 1, 3), [&, says](double h) {
                    const std::lock_guard lock(seeing);
                    seen.push_back(says);
                    const bool fails = h > 0.06 || (h > 0.04 && says == "harder");
                    return Answer{Value(std::vector<double>(100, fails ? 1 + 20 * h : 1.0)), 1};
                  }}};
    starts.push_back({says, std::move(q)});
  }
  Ladder tries(starts[0].motion.methods[0], asked(0.01, 10));
  while (!tries.is_over()) tries.go_on(1e6, starts, asked(0.01, 10), {"hard"});
  REQUIRE(seen.size() == 7);  // after the first of a setting, the others in parallel
  for (const auto at : {2, 5}) std::sort(seen.begin() + at, seen.begin() + at + 2);
  CHECK(seen == std::vector<std::string>{"hard", "hard", "asked", "harder", "harder", "asked", "hard"});
}

TEST_CASE("a better known reference is requested where the present one does not decide", "[choose]") {
  const auto start_of = [](double truth, double known_to) {
    Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
    q.need.allowed = 1;
    q.reference = {"made", Value(std::vector<double>(100, truth))};
    q.reference_error = known_to;
    q.methods = {{"model", "by hand", no_resolution(), [](double) {
                    return Answer{Value(std::vector<double>(100, 0.0)), 1};
                  }}};
    return Start{"here", std::move(q)};
  };
  int made = 0;
  const auto judged = [&](double truth, double known_to, Objective objective = Objective::cheapest) {
    made = 0;
    std::vector<Start> starts{start_of(truth, known_to)};
    starts[0].sharper = std::make_shared<Lazy<Start>>([&] {
      ++made;
      return start_of(0.25, 1e-9);
    });
    Need need = asked(1, 10);
    need.objective = objective;
    const Method& m = starts[0].motion.methods[0];
    evaluate(starts, m, 0, need);
    return evaluate(starts, m, 0, need);
  };
  CHECK(judged(3, 1.9).error == 3);  // fails for any true value
  CHECK(made == 0);
  CHECK(judged(0.8, 0.1).holds());
  CHECK(made == 0);
  CHECK(judged(0.95, 0.1).error == 0.25);  // may hold or fail
  CHECK(made == 1);
  CHECK(judged(3, 2.1).error == 0.25);
  CHECK(made == 1);
  judged(0.4, 0.1, Objective::simple);  // holds with a margin of three, or only without
  CHECK(made == 1);
  judged(0.4, 0.01, Objective::simple);
  CHECK(made == 0);
  judged(0.95, 0.1, Objective::simple);  // decides without the margin
  CHECK(made == 1);
  judged(1.0 / 3, 1e-3, Objective::simple);  // a thousandth does not decide about a margin
  CHECK(made == 0);
}

TEST_CASE(
    "a method that fails on the known part fails on the whole, and one that holds there is judged by a better reference",
    "[choose]") {
  int made = 0;
  Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
  q.samples = 50;
  q.reference.value = Value(std::vector<double>(50, 1.0));
  q.need.allowed = 0.1;
  const auto off_by = [](double off) {
    return Method{"off", "by " + format_shortest(off), no_resolution(), [off](double) {
                    return Answer{Value(std::vector<double>(50, 1 + off)), 100};
                  }};
  };
  q.methods = {off_by(0.2), off_by(0.05)};
  std::vector<Start> starts{{"here", q}};
  starts[0].is_whole = false;
  starts[0].sharper = std::make_shared<Lazy<Start>>([&] {
    ++made;
    Start whole{"here", q};
    whole.motion.samples = 100;
    whole.motion.reference.value = Value(std::vector<double>(100, 1.0));
    whole.motion.methods[1].run = [](double) { return Answer{Value(std::vector<double>(100, 1.5)), 300}; };
    return whole;
  });
  const Need need = asked(0.1, 10);
  const Candidate fails = evaluate(starts, q.methods[0], 0, need);
  CHECK(near_ulps(fails.error, 2, 64));
  CHECK(fails.evaluations_per_frame == 2);
  CHECK(made == 0);
  const Candidate holds_at_first = evaluate(starts, q.methods[1], 0, need);
  CHECK(near_ulps(holds_at_first.error, 5, 64));
  CHECK(holds_at_first.evaluations_per_frame == 3);
  CHECK(made == 1);
}

TEST_CASE("a start that was tried is not tried again, unless it ran out of evaluations", "[choose]") {
  int runs = 0;
  Ending ending = Ending::reached;
  Quantity q = place(Parameters(parameters), {10, 100}, Reference::nothing());
  q.methods = {{"model", "by hand", halving("step", 1, 4), [&](double) {
                  ++runs;
                  Answer answer{Value(std::vector<double>(100, 1.0)), 7};
                  answer.ending = ending;
                  return answer;
                }}};
  std::vector<Start> starts{{"here", q}};
  const auto runs_of_two = [&](double setting) {
    runs = 0;
    const Candidate first = evaluate(starts, q.methods[0], setting, asked(1e-6, 10));
    const Candidate second = evaluate(starts, q.methods[0], setting, asked(1e-6, 10));
    CHECK(first.outcome == second.outcome);
    CHECK(first.evaluations_per_frame == second.evaluations_per_frame);
    return runs;
  };
  CHECK(runs_of_two(1) == 2);
  starts[0].attempts = std::make_shared<Attempts>();
  CHECK(runs_of_two(1) == 1);
  CHECK(runs_of_two(1) == 0);
  CHECK(runs_of_two(0.5) == 1);
  ending = Ending::stalled;
  CHECK(runs_of_two(0.25) == 2);
}

TEST_CASE("one step a frame is one, and two are several", "[choose]") {
  Candidate candidate{"model", "algorithm", "step", 0.1};
  CHECK(shown_setting(candidate, asked(1, 1, 10)) == "1 step per frame");
  candidate.setting = 0.05;
  CHECK(shown_setting(candidate, asked(1, 1, 10)) == "2 steps per frame");
}

TEST_CASE("the cost of restarting a method counts once per restart", "[choose]") {
  // One evaluation a frame after 30 at the beginning; the other method takes two from the first frame on.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const auto frames = static_cast<std::size_t>(horizon.count());
    Quantity q{"place", "m",        "", {"exact", Value(std::vector<double>(frames, p["a"]))},
               1e-16,   {1e-6, ""}, {}, {}};
    q.samples = horizon.count();
    const auto exact = [](double) { return 1e-9; };
    for (long each : {1, 2})
      q.add(method(each == 1 ? "with a history" : "without", "exact", no_resolution(), p["a"],
                   horizon.count(), exact,
                   [=](double) { return each * horizon.count() + (each == 1 ? 30 : 0); }));
    return q;
  };
  const Entry contacts{{3, 98},
                       "",
                       {"contacts", "", parameters,
                        Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};
  const Task task(contacts);
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Need need = asked(0.01, 100);
  const auto chosen = [&] {
    const Choice choice = choose(task, need, truth, counted_cost);
    std::set<std::string> models;  // each listed once per algorithm
    for (const Candidate& c : choice.candidates) CHECK(models.insert(c.model).second);
    return *choice.chosen;
  };
  CHECK(chosen().model == "with a history");
  CHECK(near_ulps(chosen().seconds_per_frame, 1.03e-9, 64));
  need.restart_every = 10;
  CHECK(chosen().model == "with a history");
  CHECK(near_ulps(chosen().seconds_per_frame, 1.03e-9 * (1 + 29.97 / 1.03 / 100), 64));
  const Choice noisy = choose(task, need, truth, [](const Method& m, double setting) -> Time {
    return {counted_cost(m, setting).seconds, 1e-7};
  });
  REQUIRE(noisy.chosen);
  CHECK(near_ulps(noisy.chosen->spread, 1e-10 * (1 + 29.97 / 1.03 / 100), 64));
  need.restart_every = 2;
  CHECK(chosen().model == "without");
  CHECK(near_ulps(chosen().seconds_per_frame, 2e-9, 64));
}

TEST_CASE("a period is measured between passages of the mean, wherever the motion is", "[choose]") {
  // One period a second about 5; the method's is longer by a hundredth.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const auto turning = [&](double period) {
      std::vector<double> x;
      for (double t : horizon.times()) x.push_back(5 + p["a"] * std::cos(2 * std::numbers::pi * t / period));
      x.erase(x.begin());  // the start, at which nothing is judged
      return x;
    };
    Quantity q{"place", "m", "", {"exact", Value(turning(1))}, 1e-16, {1e-6, ""}, {}, {}};
    q.samples = horizon.count();
    q.add({"slow", "exact", no_resolution(), [slow = turning(1.01)](double) {
             return Answer{Value(slow), 1};
           }});
    q.add({"quick", "exact", no_resolution(), [quick = turning(0.8)](double) {
             return Answer{Value(quick), 1};
           }});
    return q;
  };
  const Entry turning{{3, 97},
                      "",
                      {"turning", "", parameters,
                       Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Need need = asked(0.02, 10);
  need.criterion = Criterion::period;
  const Choice choice = choose(Task(turning), need, truth, counted_cost);
  REQUIRE(choice.chosen);
  CHECK(near_part(choice.chosen->error, 0.5, 0.03));
  const auto quick = std::ranges::find(choice.candidates, "quick", &Candidate::model);
  REQUIRE(quick != choice.candidates.end());
  CHECK(near_part(quick->error, 10, 0.03));  // over more passages
}

TEST_CASE("a coarse model that fails next to the requested start is not chosen", "[choose]") {
  const Choice choice = choose_for(asked(0.005, 1));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "rich");
  REQUIRE(choice.next_cheaper);
  CHECK(choice.next_cheaper->model == "stepping");
  CHECK(choice.next_cheaper->outcome == Outcome::inaccurate);
}

TEST_CASE("steps divide the frame, and the first that holds is taken", "[choose]") {
  const Choice choice = choose_for(asked(0.06, 0.1), 5);
  const auto stepping = std::ranges::find(choice.candidates, "stepping", &Candidate::model);
  REQUIRE(stepping != choice.candidates.end());
  CHECK(stepping->holds());
  CHECK(std::round(1 / (stepping->setting * 10)) == 10);
}

TEST_CASE("a simple method is one of fixed step or closed form that holds with a margin of three",
          "[choose]") {
  Need need = asked(0.1, 0.3);
  need.objective = Objective::simple;
  const Choice margin = choose_for(need, 5);
  REQUIRE(margin.chosen);
  CHECK(margin.by_objective);
  CHECK(margin.chosen->model == "stepping");
  CHECK(margin.chosen->error <= 1 / 3.0);
  need.error = 1e-7;
  const Choice rich = choose_for(need, 5);
  REQUIRE(rich.chosen);
  CHECK_FALSE(rich.by_objective);
  CHECK(rich.chosen->model == "rich");
}

TEST_CASE(
    "among methods with equal cost within a quarter the most accurate is chosen, and the tie is reported",
    "[choose]") {
  const auto price = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.2e-6 : 1, 0};
  };
  const Choice tie = choose_for(asked(0.05, 10), 1, price);
  REQUIRE(tie.chosen);
  CHECK(tie.chosen->model == "rich");
  REQUIRE_FALSE(tie.ties.empty());
  CHECK(tie.ties.front().model == "coarse");
  const auto dearer = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.3e-6 : 1, 0};
  };
  CHECK(choose_for(asked(0.05, 10), 1, dearer).chosen->model == "coarse");
  const auto noisy = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.3e-6 : 1, 0.2e-6};
  };
  CHECK(choose_for(asked(0.05, 10), 1, noisy).chosen->model == "rich");
}

TEST_CASE("a run that came to an end has a cost to compare", "[choose]") {
  for (const Outcome outcome : {Outcome::ok, Outcome::inaccurate, Outcome::drifted, Outcome::diverged}) {
    Candidate t;
    t.outcome = outcome;
    CHECK(came_to_an_end(t));
  }
  for (const Outcome outcome :
       {Outcome::non_finite, Outcome::stalled, Outcome::raised, Outcome::chattering, Outcome::grazing}) {
    Candidate t;
    t.outcome = outcome;
    CHECK_FALSE(came_to_an_end(t));
  }
}

TEST_CASE("a motion is known well if its error is a millionth of the smallest need", "[choose]") {
  Quantity q = place(Parameters(parameters), {1, 10}, Reference::nothing());
  q.needs = {3, 0.01};
  q.reference_error = 0.9e-8;
  CHECK(is_known_well(q));
  q.reference_error = 1.1e-8;
  CHECK_FALSE(is_known_well(q));
}

TEST_CASE("--only and --exclude select by words of models and algorithms", "[choose]") {
  Need need = asked(0.05, 10);
  need.exclude = {"coarse"};
  CHECK(choose_for(need).chosen->model == "rich");
  need.only = {"explicit"};
  need.error = 1e-5;
  CHECK_FALSE(choose_for(need, 5).chosen);
  need.only = {"nobody"};
  CHECK(complaint([&] {
          choose_for(need);
        }).find("no method is left; this scene has coarse by closed form") != std::string::npos);
}

TEST_CASE("a need relative to the motion is the same at any size", "[choose]") {
  for (double a : {1.0, 8.0}) {
    Need need = asked(2e-8, 10);
    need.relative = true;
    const Choice choice = choose_for(need, a);
    REQUIRE(choice.chosen);
    CHECK(choice.chosen->model == "rich");
    CHECK(choice.chosen->setting == 1e-4);
  }
}

TEST_CASE("a need that nothing meets is reported, with the nearest miss", "[choose]") {
  Need need = asked(1e-9, 10);
  need.budget = 1e-9;
  const Choice poor = choose_for(need);
  CHECK_FALSE(poor.chosen);
  REQUIRE(poor.nearest_miss);
  CHECK(poor.nearest_miss->holds());
  CHECK(poor.nearest_miss->seconds_per_frame > 1e-9);
  CHECK(choice_text(poor, false).find("times the budget") != std::string::npos);

  const Choice impossible = choose_for(asked(1e-15, 10));
  CHECK_FALSE(impossible.chosen);
  REQUIRE(impossible.nearest_miss);
  CHECK(impossible.nearest_miss->model == "rich");
  CHECK(choice_text(impossible, false).find("Nothing here meets that") != std::string::npos);
}

TEST_CASE("the nearest miss is the method that misses least on its worst start", "[choose]") {
  // At a = 5 the method whose error grows with the distance from there is nearer, on the neighbouring starts
  // the other.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const double a = p["a"];
    Quantity q = place(p, horizon, Reference::nothing());
    q.methods.clear();
    q.methods_in_float.clear();
    const auto one = [](double) { return 1L; };
    q.add(method(
        "there", "alone", no_resolution(), a, horizon.count(),
        [a](double) { return 0.01 + 10 * std::abs(a - 5); }, one));
    q.add(method(
        "everywhere", "alike", no_resolution(), a, horizon.count(), [](double) { return 0.02; }, one));
    return q;
  };
  const Entry nearest{{3, 95},
                      "",
                      {"nearest", "", parameters,
                       Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};
  Task task(nearest);
  task.parameters.set("a", 5);
  const Choice choice =
      choose(task, asked(1e-3, 3), Reference(std::string(ODDITY_SOURCE) + "/reference"), counted_cost);
  REQUIRE(choice.nearest_miss);
  CHECK(choice.nearest_miss->model == "everywhere");
}

namespace {

/// A motion that stays at a.
Quantity staying(double a, const Horizon& horizon) {
  Quantity q{"place", "m",
             "",      {"exact", Value(std::vector<double>(static_cast<std::size_t>(horizon.count()), a))},
             1e-16,   {1e-6, ""},
             {},      {}};
  q.samples = horizon.count();
  return q;
}

/// The choice for such a scene at a = 5.
Choice choose_at_5(Quantity (*motion)(const Parameters&, const Horizon&, const Reference&),
                   const Need& need) {
  const Entry staying_there{
      {3, 97},
      "",
      {"staying", "", parameters, Scene{motion, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}},
       nullptr}};
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(staying_there);
  task.parameters.set("a", 5);
  return choose(task, need, truth, counted_cost);
}

/// Adds a method with this model, algorithm, error and number of evaluations, for any start and setting.
void add(Quantity& q, const std::string& model, const std::string& algorithm, double error,
         long evaluations) {
  const int frames = q.samples;
  const double a = q.reference.value[0];
  q.add(method(
      model, algorithm, no_resolution(), a, frames, [=](double) { return error; },
      [=](double) { return evaluations * frames; }));
}

}  // namespace

TEST_CASE("among equally fast and accurate methods the simpler is chosen, in the catalog's order",
          "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    for (const char* algorithm : {"Runge-Kutta 4", "explicit Euler", "closed form"})
      add(q, "right", algorithm, 1e-9, 10);
    return q;
  };
  Need need = asked(1e-3, 3);
  CHECK(choose_at_5(scene, need).chosen->algorithm == "closed form");
  need.exclude = {"closed form"};
  CHECK(choose_at_5(scene, need).chosen->algorithm == "explicit Euler");
}

TEST_CASE("when a pick fails its test, the test's starts are added and others are made", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "up to 5", "explicit Euler", std::max(0.0, p["a"] - 5), 1);  // the first starts are among these
    add(q, "everywhere", "Runge-Kutta 4", 1e-5, 10);
    return q;
  };
  const Choice choice = choose_at_5(scene, asked(1e-3, 3));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "everywhere");
  CHECK(choice.explanation.rounds == 2);
  CHECK(choice.seen.size() == 6);
  CHECK(choice.unseen.size() == 3);
  std::set<std::string> starts(choice.seen.begin(), choice.seen.end());
  starts.insert(choice.unseen.begin(), choice.unseen.end());
  CHECK(starts.size() == 9);
}

TEST_CASE("the objective's method is searched within the budget where something else is cheaper",
          "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "dear", "closed form", 1e-5, 1);
    q.add(method(
        "tolerant", "by hand", tolerances(), p["a"], q.samples, [](double) { return 1e-3; },
        [=](double) { return 2L * horizon.count(); }));
    q.add(method(
        "stepping", "explicit", halving("step", 1, 4), p["a"], q.samples, [](double h) { return h; },
        [=](double h) { return std::lround(horizon.end / h); }));
    return q;
  };
  const Entry three{{3, 94},
                    "",
                    {"three", "", parameters,
                     Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};
  Task task(three);
  task.parameters.set("a", 4);
  Need need =
      asked(0.0748, 10);  // with a margin of three 20 steps a frame at all starts; 16 are tried at once
  need.objective = Objective::simple;
  need.budget = 1e-6;
  const auto price = [](const Method& m, double setting) -> Time {
    return {m.model == "dear" ? 1 : m.model == "tolerant" ? 1e-6 : counted_cost(m, setting).seconds, 0};
  };
  const Choice choice = choose(task, need, Reference(std::string(ODDITY_SOURCE) + "/reference"), price);
  REQUIRE(choice.chosen);
  CHECK(choice.by_objective);
  CHECK(choice.chosen->model == "stepping");
}

TEST_CASE("a budget has to hold in the costliest part of the horizon", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    const auto add_counted = [&](const std::string& model, long (*count)(long frames)) {
      q.add(method(
          model, "explicit Euler", no_resolution(), p["a"], q.samples, [](double) { return 1e-5; },
          [=, frames = horizon.count()](double) { return count(frames); }));
    };
    add_counted("steady", [](long frames) { return 3 * frames; });
    add_counted("with a start", [](long frames) { return 2 * frames + 40; });
    add_counted("uneven", [](long frames) { return frames + 6 * std::clamp(frames - 200, 0L, 20L); });
    return q;
  };
  const auto costs = [&](double budget) {
    Need need = asked(1e-3, 40);
    need.budget = budget;
    std::map<std::string, double> all;
    for (const Candidate& t : choose_at_5(scene, need).candidates) all[t.model] = 1e9 * t.seconds_per_frame;
    return all;
  };
  for (auto& [model, cost] : costs(std::numeric_limits<double>::infinity()))
    CHECK(near(cost, model == "steady" ? 3 : model == "uneven" ? 1.3 : 2.1, 1e-9));
  for (auto& [model, cost] : costs(1e-8))
    CHECK(near(cost, model == "steady" ? 3 : model == "uneven" ? 7 : 4, 1e-9));
  CHECK(near(costs(1.2e-9).at("uneven"), 1.3, 1e-9));  // beyond it on average already
}

TEST_CASE("errors within 10 % count as equal", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "right", "Runge-Kutta 4", 1e-5, 10);
    add(q, "right", "explicit Euler", 1.08e-5, 10);
    add(q, "right", "Heun", 1.15e-5, 10);
    return q;
  };
  CHECK(choose_at_5(scene, asked(1e-3, 3)).chosen->algorithm == "explicit Euler");
}

TEST_CASE("methods with a history are left out when one step at a time is requested", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    for (const char* algorithm : {"Adams-Bashforth 4", "GSL msadams", "GSL msbdf", "explicit Euler"})
      add(q, "right", algorithm, 1e-9, algorithm[0] == 'e' ? 100 : 10);
    return q;
  };
  Need need = asked(1e-3, 3);
  CHECK(choose_at_5(scene, need).candidates.size() == 4);
  need.one_step = true;
  CHECK(choose_at_5(scene, need).candidates.size() == 1);
  need.one_step = false;
  need.objective = Objective::simple;
  CHECK(choose_at_5(scene, need).chosen->algorithm == "explicit Euler");
}

TEST_CASE("the next richer model holds at a higher cost, and is another model", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "with a history", "Adams-Bashforth 4", 1e-9, 50);
    add(q, "thrifty", "explicit Euler", 1e-10, 100);
    add(q, "failing", "Runge-Kutta 4", 1, 110);
    add(q, "tied", "Runge-Kutta 4", 1e-6, 120);
    add(q, "failing dearly", "Runge-Kutta 4", 1, 200);
    add(q, "thrifty", "Runge-Kutta 4", 1e-9, 300);
    add(q, "rich", "Runge-Kutta 4", 1e-9, 400);
    add(q, "richer", "Runge-Kutta 4", 1e-9, 500);
    return q;
  };
  Need need = asked(1e-3, 3);
  need.objective = Objective::simple;
  const Choice choice = choose_at_5(scene, need);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "thrifty");
  CHECK(choice.chosen->algorithm == "explicit Euler");
  REQUIRE(choice.next_richer);
  CHECK(choice.next_richer->model == "rich");
  REQUIRE(choice.ties.size() == 1);
  CHECK(choice.ties[0].model == "tied");
  CHECK(choice.candidates.size() == 8);
  for (const Candidate& t : choice.candidates) {
    INFO(t.model);
    CHECK(near_ulps(t.seconds_per_frame, t.evaluations_per_frame * 1e-9, 64));
  }
}

TEST_CASE("the answer reports the cost of a rollback", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "one", "explicit Euler", 1e-10, 300);
    return q;
  };
  Need need = asked(1e-3, 3);
  Choice choice = choose_at_5(scene, need);
  REQUIRE(choice.chosen);
  choice.chosen->state_size = 4;
  const double frame = choice.chosen->seconds_per_frame;
  CHECK(
      answer_text(choice).ends_with("  rollback: 32 bytes of state to save; from there 8 frames again take " +
                                    shown_time(8 * frame) + ".\n"));
  choice.restart = 2 * choice.chosen->evaluations_per_frame;  // a history that is restarted
  CHECK(answer_text(choice).ends_with(" take " + shown_time(10 * frame) + ".\n"));
  need.bodies = 10;
  choice.need = need;
  CHECK(answer_text(choice).find("rollback: 320 bytes") != std::string::npos);
  choice.chosen->precision = Precision::in_float;
  CHECK(answer_text(choice).find("rollback: 160 bytes") != std::string::npos);
  choice.chosen->state_size = 0;
  CHECK(answer_text(choice).ends_with(
      "  rollback: there is no state to save, and any frame is computed at once.\n"));
}

TEST_CASE("an engine's steps are tried at 60, 120 and 240 Hz, or at the next higher rates that fill a frame",
          "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    add(q, "moving", "symplectic Euler", 1e-9, 10);
    return q;
  };
  const auto rates = [&](double frames_per_second) {
    std::vector<long> all;
    for (const Candidate& t : choose_at_5(scene, asked(1e-3, 1, frames_per_second)).engine)
      all.push_back(std::lround(1 / t.setting));
    return all;
  };
  CHECK(rates(60) == std::vector<long>{60, 120, 240});
  CHECK(rates(100) == std::vector<long>{100, 200, 300});
  CHECK(rates(120) == std::vector<long>{120, 240});
}

TEST_CASE("where a neighbouring start decides, the answer names the method for the requested start",
          "[choose]") {
  // Exact at a = 5, and off by the distance from there.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const double a = p["a"];
    Quantity q = staying(a, horizon);
    q.add(method(
        "there", "alone", no_resolution(), a, horizon.count(), [a](double) { return std::abs(a - 5) + 1e-9; },
        [](double) { return 30L; }));
    return q;
  };
  Need need = asked(1e-3, 3);
  const Choice choice = choose_at_5(scene, need);
  CHECK_FALSE(choice.chosen);
  REQUIRE(choice.on_asked);
  CHECK(choice.on_asked->holds());
  CHECK(near_ulps(choice.on_asked->seconds_per_frame, 1e-9, 64));
  REQUIRE(choice.next_to_asked);
  CHECK(choice.next_to_asked->outcome == Outcome::inaccurate);
  const std::string text = choice_text(choice, false);
  CHECK(text.find("on the start asked for there by alone") != std::string::npos);
  CHECK(text.find("this one is inaccurate at " + choice.next_to_asked->where) != std::string::npos);
  CHECK(choice.explanation.starts == 3);  // no others are made where nothing holds on these
  need.budget = 1e-10;
  CHECK_FALSE(choose_at_5(scene, need).on_asked);
}

TEST_CASE("a method that fails on the requested start is not reported to hold there", "[choose]") {
  // The smaller a is, the larger the error; one method has the same error everywhere.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const double a = p["a"];
    Quantity q = staying(a, horizon);
    for (const double least : {0.0, 1.0})
      q.add(method(
          least > 0 ? "nowhere" : "there", "alone", no_resolution(), a, horizon.count(),
          [=](double) { return std::max(least, 5 - a) + 1e-9; },
          [=](double) { return least > 0 ? 10L : 30L; }));
    return q;
  };
  const Choice choice = choose_at_5(scene, asked(1e-3, 3));
  CHECK_FALSE(choice.chosen);
  REQUIRE(choice.on_asked);
  CHECK(choice.on_asked->model == "there");
  CHECK(choice.on_asked->holds());
}

TEST_CASE("a method with many evaluations is timed over its first frames", "[choose]") {
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    Quantity q = staying(p["a"], horizon);
    for (const long each : {100L, 100'000L})
      q.add(method(
          std::to_string(each), "alone", no_resolution(), p["a"], horizon.count(),
          [](double) { return 1e-9; }, [=](double) { return each * horizon.count(); }));
    return q;
  };
  const Entry staying_there{
      {3, 96},
      "",
      {"staying", "", parameters, Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}},
       nullptr}};
  std::vector<long> timed;
  const Choice choice =
      choose(Task(staying_there), asked(1e-3, 3), Reference(std::string(ODDITY_SOURCE) + "/reference"),
             [&](const Method& m, double setting) {
               timed.push_back(m.run(setting).evaluations);
               return counted_cost(m, setting);
             });
  CHECK(timed == std::vector<long>{3000, 100'000});  // all 30 frames, and one
  REQUIRE(choice.candidates.size() == 2);
  CHECK(near_ulps(choice.candidates[0].seconds_per_frame, 100e-9, 64));
  CHECK(near_ulps(choice.candidates[1].seconds_per_frame, 100'000e-9, 64));
}

namespace {

/// At 10 frames a second, in metres: a true path, and the same from a start that is off by `off(t)`.
struct Neighbours {
  Quantity motion{"place", "m", "", {"exact", Value(std::vector<double>())}, 1e-16, {1e-2, ""}, {}, {}};
  std::vector<double> truth, beside;

  template <class Off>
  Neighbours(double horizon, const Off& off) {
    for (int k = 1; k <= std::lround(10 * horizon); ++k) {
      truth.push_back(std::sin(k / 10.0));
      beside.push_back(truth.back() + off(k / 10.0));
    }
    motion.samples = static_cast<int>(truth.size());
    motion.reference.value = Value(truth);
    motion.norms = {{"m", {0}}};
    motion.needs = {1e-2};
  }

  Parting parting() const { return parting_of(motion, Value(beside), 1e-9); }
  std::optional<double> predictable_until() const {
    const Parting parting = this->parting();
    if (!parting.is_chaotic) return {};
    const auto lost = parting.lost_at();
    return lost ? static_cast<double>(*lost + 1) / 10 : std::numeric_limits<double>::infinity();
  }
};

double chaotic(double t) { return std::min(1.0, 1e-9 * std::exp(3 * t)); }

}  // namespace

TEST_CASE("in chaos a saturated error is extrapolated", "[choose]") {
  const Parting parting = Neighbours(10, chaotic).parting();
  REQUIRE(parting.is_chaotic);
  CHECK(near_ulps(parting.until.back(), 100, 64));  // as large as the motion, in tolerances
  // Half the tolerance up to 3 s, and as large as the motion from then on.
  std::vector<double> until(100, 50);
  std::fill_n(until.begin(), 30, 0.5);
  CHECK(near_part(parting.in_the_end(until), 0.5 * 100 / (1e-7 * std::exp(9)) / 16, 1e-11));
  CHECK(parting.in_the_end(std::vector<double>(100, 0.5)) == 0.5);  // never lost
  CHECK(parting.in_the_end(std::vector<double>(100, 50)) == 50);    // never there
  CHECK(parting.in_the_end({0.5, 50}) == 50);                       // with another number of frames
  CHECK(Neighbours(10, [](double t) { return 1e-9 * t; }).parting().in_the_end(until) == 50);
}

TEST_CASE("a chaotic motion is distinguished from a regular one, over any horizon", "[choose]") {
  for (double horizon : {7.0, 10.0, 20.0, 100.0}) {
    const auto until = Neighbours(horizon, chaotic).predictable_until();
    INFO("over " << horizon);
    REQUIRE(until);
    CHECK(near_ulps(*until, 5.4, 64));
  }
  const auto soon = Neighbours(5, chaotic).predictable_until();
  REQUIRE(soon);
  CHECK(std::isinf(*soon));
  for (double horizon : {5.0, 100.0}) {
    CHECK_FALSE(Neighbours(horizon, [](double t) { return 1e-9 * t; }).predictable_until());
    CHECK_FALSE(Neighbours(horizon, [](double t) { return 1e-9 * t * t; }).predictable_until());
    CHECK_FALSE(Neighbours(horizon, [](double t) { return t < 3 ? 1e-16 : 1e-9 * t; }).predictable_until());
  }
}

TEST_CASE("a choice reports until when a chaotic path is predictable, and nothing for a regular one",
          "[choose]") {
  for (double rate : {3.0, 0.0}) {
    INFO("grows by e to the " << rate << " a second");
    static double growth;
    growth = rate;
    const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
      const double off = p["a"] - 5;
      std::vector<double> path;
      for (int k = 1; k <= horizon.count(); ++k)
        path.push_back(std::sin(k / 10.0) + std::clamp(off * std::exp(growth * k / 10), -1.0, 1.0));
      Quantity q = staying(0, horizon);
      q.reference.value = Value(path);
      q.add({"parting", "Fehlberg 7(8)", tolerances(), [path](double) { return Answer{Value(path), 100}; }});
      return q;
    };
    const Choice choice = choose_at_5(scene, asked(1e-2, 10));
    CHECK(choice.predictable.has_value() == (rate > 0));
    if (choice.predictable)
      CHECK(near_ulps(*choice.predictable, 4.9, 64));  // 5e-9 m grow to 1e-2 m in 4.84 s
  }
}

TEST_CASE("each unit loses the path by its own error", "[choose]") {
  const Neighbours one(10, chaotic), other(10, [](double t) { return 1e-9 * t; });
  Neighbours both = one;
  std::vector<double> truth, beside;
  for (std::size_t k = 0; k < one.truth.size(); ++k) {
    truth.insert(truth.end(), {one.truth[k], other.truth[k]});
    beside.insert(beside.end(), {one.beside[k], other.beside[k]});
  }
  both.motion.reference.value = Value(truth);
  both.motion.norms = {{"m", {0}}, {"rad", {1}}};
  both.motion.needs = {1e-2, 1e-7};  // the angle's is smaller, and kept
  both.beside = beside;
  REQUIRE(both.predictable_until());
  CHECK(near_ulps(*both.predictable_until(), 5.4, 64));
  both.motion.needs = {1e-2, 1e-9};
  CHECK(*both.predictable_until() < 2);
  both.beside.pop_back();
  CHECK_FALSE(both.predictable_until());
}

TEST_CASE("without a requested path chaos is not reported, and without a size no exactness", "[choose]") {
  Need need = asked(1, 10);
  need.criterion = Criterion::bounded;
  const Choice choice = choose_for(need);
  REQUIRE(choice.chosen);
  CHECK_FALSE(choice.predictable);
  CHECK(answer_text(choice).find("exact") == std::string::npos);
  CHECK(answer_text(choice).find("on starts that it was not chosen on it is bounded, too") !=
        std::string::npos);
  CHECK(choice_json(choice).find("\"margin\": null") != std::string::npos);
}

TEST_CASE("the judged time is reported where the frames do not fill the horizon", "[choose]") {
  CHECK(
      asked_text(choose_for(asked(0.05, 0.1, 26))).find("over 3 frames, 0.115 s, at 26 frames per second") !=
      std::string::npos);
  CHECK(asked_text(choose_for(asked(0.05, 10))).find("over 10 s at 10 frames per second") !=
        std::string::npos);
}

TEST_CASE("the next cheaper one tried may hold without the margin", "[choose]") {
  Need need = asked(0.1, 0.3);
  need.objective = Objective::simple;
  need.only = {"stepping"};
  const Choice choice = choose_for(need, 5);
  REQUIRE(choice.chosen);
  REQUIRE(choice.next_cheaper);
  CHECK(choice.next_cheaper->holds());
  CHECK(choice.next_cheaper->error > 1 / 3.0);
  CHECK(answer_text(choice).find("the next cheaper one that was tried: stepping by explicit") !=
        std::string::npos);
  CHECK(answer_text(choice).find("instead of 3") != std::string::npos);
}

TEST_CASE("a method that fails with a non-finite result on one start is not the next cheaper", "[choose]") {
  // The cheaper one is inaccurate everywhere, and not finite below a = 5.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const double a = p["a"];
    Quantity q = staying(a, horizon);
    q.add(method(
        "breaking", "here and there", no_resolution(), a, horizon.count(),
        [a](double) { return a < 5 ? std::numeric_limits<double>::quiet_NaN() : 0.5; },
        [](double) { return 10L; }));
    q.add(method(
        "right", "everywhere", no_resolution(), a, horizon.count(), [](double) { return 1e-9; },
        [](double) { return 100L; }));
    return q;
  };
  const Choice choice = choose_at_5(scene, asked(1e-3, 3));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "right");
  CHECK_FALSE(choice.next_cheaper);
}

TEST_CASE("an error is shown in the requested unit", "[choose]") {
  Need need = asked(0.05, 10);
  need.shown = {{"m", {"cm", 0.01}}};
  const Choice choice = choose_for(need);
  CHECK(choice_text(choice, false).find("place within 5 cm at every frame") != std::string::npos);
  CHECK(choice_json(choice).find("\"error\": 5.0") != std::string::npos);
  CHECK(choice_csv(choice).find("error [cm]") != std::string::npos);
}

TEST_CASE("a precision can be requested, and a method chosen in double is tried in float", "[choose]") {
  Need need = asked(0.05, 10, 100);
  need.only = {"stepping"};
  const auto precisions = [](const Choice& choice) {
    std::set<Precision> all;
    for (const Candidate& t : choice.candidates) all.insert(t.precision);
    return all;
  };
  const Choice in_double = choose_for(need);
  REQUIRE(in_double.chosen);
  CHECK(precisions(in_double) == std::set{Precision::in_double});
  REQUIRE(in_double.in_float);
  CHECK(in_double.in_float->algorithm == "explicit in float");
  CHECK(in_double.in_float->setting == in_double.chosen->setting);
  CHECK(in_double.in_float->holds());
  CHECK(answer_text(in_double).find("in float: error 0.02 m, holds") != std::string::npos);
  CHECK(choice_csv(in_double).find("stepping,explicit,double,") != std::string::npos);

  need.in_float = true;
  CHECK(precisions(choose_for(need)).size() == 2);
  need.in_double = false;
  const Choice in_float = choose_for(need);
  REQUIRE(in_float.chosen);
  CHECK(in_float.chosen->algorithm == "explicit in float");
  CHECK(precisions(in_float) == std::set{Precision::in_float});
  CHECK_FALSE(in_float.in_float);
  CHECK(answer_text(in_float).find("in float:") == std::string::npos);
  CHECK(choice_json(in_float).find("\"precision\": \"float\"") != std::string::npos);

  need.in_double = true, need.in_float = false, need.error = 0.015;
  CHECK(answer_text(choose_for(need)).find("in float: inaccurate, error 0.02 m at a = 1: fails") !=
        std::string::npos);
  need.only = {"rich"};
  CHECK(answer_text(choose_for(need)).find("in double only") != std::string::npos);
}

TEST_CASE("a method that fails at a higher cost than the chosen one's is not refined", "[choose]") {
  Need need = asked(5e-4, 10);
  const auto steps_of = [](const Choice& choice) {
    const auto stepping = std::ranges::find(choice.candidates, "stepping", &Candidate::model);
    return stepping == choice.candidates.end() ? 0 : std::lround(1 / (stepping->setting * 10));
  };
  const Choice left = choose_for(need);
  CHECK(left.chosen->model == "rich");
  CHECK(left.explanation.left == 1);
  CHECK(steps_of(left) == 16);
  const auto stepping = std::ranges::find(left.candidates, "stepping", &Candidate::model);
  CHECK_FALSE(left.was_followed(*stepping));
  CHECK(left.was_followed(*left.chosen));
  CHECK(choice_text(left, true).find("; not followed\n") != std::string::npos);
  CHECK(
      choice_text(left, true).find("not all are followed to finer settings, as they cost too much already") !=
      std::string::npos);
  CHECK(choice_json(left).find("\"followed\": false") != std::string::npos);
  need.exclude = {"coarse", "rich"};
  const Choice followed = choose_for(need);
  REQUIRE(followed.chosen);
  CHECK(followed.explanation.left == 0);
  CHECK(choice_text(followed, true).find("not followed") == std::string::npos);
  CHECK(steps_of(followed) == 256);
}

TEST_CASE("a method that fails at a lower cost than the chosen one's is refined", "[choose]") {
  const auto price = [](const Method& m, double setting) -> Time {
    return {m.model == "stepping" ? 1e-9 / setting : 1, 0};
  };
  const Choice choice = choose_for(asked(5e-4, 10), 1, price);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "stepping");
}

TEST_CASE("a setting with far more work than expected is given up until that much is allowed", "[choose]") {
  const Need need = asked(0.05, 10);  // 100 frames
  const Horizon horizon{need.horizon, static_cast<int>(need.frames())};
  Quantity q = place(Parameters(parameters), horizon, Reference::nothing());
  constexpr long work = 100'000;
  q.add(method(
      "spinning", "on and on", tolerances(), 1, horizon.count(), [](double) { return 0; },
      [](double) { return work; }));
  const auto right = q.methods.back().run;
  q.methods.back().run = [right](double setting) {
    Answer answer = right(setting);
    if (ode::most_evaluations < work)
      answer.evaluations = ode::most_evaluations, answer.ending = Ending::stalled;
    return answer;
  };
  const std::vector<Start> starts{{"here", q}};
  Ladder tries(q.methods.back(), need);
  const auto go_on = [&](double most, double most_of_all = std::numeric_limits<double>::infinity()) {
    tries.go_on(most, starts, need, {}, most_of_all);
    REQUIRE(tries.candidates.size() == 1);
    return tries.candidates.back().outcome;
  };
  CHECK(go_on(16) == Outcome::stalled);  // 25,600 evaluations at most
  CHECK(tries.is_given_up());
  CHECK_FALSE(tries.is_over());
  CHECK(tries.expected_evaluations() == 256);
  CHECK(go_on(64) == Outcome::stalled);
  CHECK(tries.expected_evaluations() == 256);
  CHECK(go_on(1e6, 300) == Outcome::stalled);  // ends, although it is allowed to go on
  CHECK(tries.expected_evaluations() == 300);
  CHECK(tries.is_given_up());
  tries = Ladder(q.methods.back(), need);
  CHECK(go_on(64) == Outcome::ok);  // 102,400 evaluations
  tries = Ladder(q.methods.back(), need);
  CHECK(go_on(16) == Outcome::stalled);
  CHECK(go_on(256) == Outcome::ok);
  CHECK(tries.is_over());
  CHECK_FALSE(tries.is_given_up());
}

TEST_CASE("a setting that was not timed is expected to cost the same per evaluation as the nearest timed one",
          "[choose]") {
  const Need need = asked(0.05, 10);
  const Quantity q =
      place(Parameters(parameters), {need.horizon, static_cast<int>(need.frames())}, Reference::nothing());
  Ladder tries(q.methods[1], need);
  for (const double evaluations : {1, 2, 10, 64}) {
    Candidate t{"stepping", "explicit", "step", 1 / evaluations};
    t.evaluations_per_frame = evaluations;
    tries.candidates.push_back(t);
  }
  CHECK(std::isnan(tries.expected_seconds(tries.candidates[0])));
  tries.candidates[0].seconds_per_frame = 5;
  CHECK(tries.expected_seconds(tries.candidates[0]) == 5);
  CHECK(near_ulps(tries.expected_seconds(tries.candidates[3]), 5 * 64, 64));
  tries.candidates[3].seconds_per_frame = 192;
  CHECK(near_ulps(tries.expected_seconds(tries.candidates[1]), 10, 64));
  CHECK(near_ulps(tries.expected_seconds(tries.candidates[2]), 3 * 10, 64));
}

TEST_CASE("the cost of the next setting is estimated from the work and time of the last", "[choose]") {
  const Need need = asked(1e-3, 10);
  const std::vector<Start> starts{
      {"here",
       place(Parameters(parameters), {need.horizon, static_cast<int>(need.frames())}, Reference::nothing())}};
  Ladder stepping(starts[0].motion.methods[1], need);
  stepping.go_on(2, starts, need);
  REQUIRE(stepping.candidates.size() == 2);
  stepping.candidates.back().seconds_per_frame = 5;
  CHECK(near_ulps(stepping.expected_evaluations(), 3, 64));
  CHECK(near_ulps(stepping.expected_seconds(), 5 * 1.5, 64));

  // 2 evaluations a frame at 0.01, and 4 at 0.0001.
  Ladder tolerant(starts[0].motion.methods[2], asked(1e-9, 10));
  std::vector<Start> asked_more = starts;
  asked_more[0].motion.need.allowed = 1e-9;
  tolerant.go_on(2, asked_more, asked(1e-9, 10));
  REQUIRE(tolerant.candidates.size() == 2);
  CHECK(near_ulps(tolerant.candidates.back().setting, 1e-4, 64));
  CHECK(near_ulps(tolerant.expected_evaluations(), 4 * std::sqrt(2), 64));  // at 0.00001
}

TEST_CASE("a long motion is computed in double, and in long double where that does not suffice", "[choose]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Need need = asked(0.01, 400, 60);
  const auto truth_of = [&](const Task& task) {
    return InitialConditions(task, need, truth).asked_and_nearby(0, [] {}).front().motion.reference.by;
  };
  const Task top(*std::ranges::find(registry(), Number{3, 33}, &Entry::number));
  Task chain(*std::ranges::find(registry(), Number{3, 25}, &Entry::number));
  chain.parameters.set("theta1", 2.5);
  CHECK(truth_of(top).find("in double: ") != std::string::npos);
  need.error = 1e-7;  // double's roundings are larger than a thousandth of it
  CHECK(truth_of(top).find("in long double: ") != std::string::npos);
  need.error = 0.01;
  CHECK(truth_of(chain).find("in double: ") == std::string::npos);
  need.horizon = 10;
  CHECK(truth_of(top).find("in long double: ") != std::string::npos);
}

TEST_CASE("where long double loses a motion no method is refined far", "[choose]") {
  Task task(*std::ranges::find(registry(), Number{3, 25}, &Entry::number));
  task.parameters.set("theta1", 2.5);
  Need need = game_need();
  need.horizon = 16;
  const Choice choice =
      choose(task, need, Reference(std::string(ODDITY_SOURCE) + "/reference"), counted_cost);
  CHECK_FALSE(choice.chosen);
  REQUIRE(choice.explanation.truth_until);
  CHECK(*choice.explanation.truth_until > 10);
  CHECK(*choice.explanation.truth_until < 16);
  CHECK(choice.explanation.left > 0);
  for (const Candidate& t : choice.candidates) {
    INFO(t.model << " by " << t.algorithm << " at " << t.setting);
    CHECK_FALSE(t.holds());
    CHECK(t.evaluations_per_frame < 400);
  }
  const std::string text = choice_text(choice, true);
  CHECK(text.find("there even long double loses it") != std::string::npos);
  CHECK(text.find("not all are followed to finer settings, as none can hold") != std::string::npos);
  CHECK(explanation_text(choice).find("not followed to finer settings, as none can hold") !=
        std::string::npos);

  task.parameters.set("theta1", 3);
  need.horizon = 10.35;  // the routes disagree too much, but repeats know it
  CHECK_FALSE(choose(task, need, Reference(std::string(ODDITY_SOURCE) + "/reference"), counted_cost)
                  .explanation.truth_until);
}

TEST_CASE("an answer reports until when the true motion is known", "[choose]") {
  Choice choice = choose_for(asked(0.05, 10));
  CHECK(choice_text(choice, true).find("known up to") == std::string::npos);
  choice.explanation.truth_until = 5;
  CHECK(choice_text(choice, true)
            .find("the true motion is known up to 5 s: errors of methods that fail earlier") !=
        std::string::npos);
  CHECK(explanation_text(choice).find("as they cost too much already") != std::string::npos);
  choice.predictable = 2;
  CHECK(choice_text(choice, true).find("the true motion is known up to 5 s: there even long double") !=
        std::string::npos);
  CHECK(explanation_text(choice).find("as none can hold") != std::string::npos);
}

TEST_CASE("an answer explains which methods were tried and where its time went", "[choose]") {
  const Choice choice = choose_for(asked(0.05, 10));
  const Explanation& e = choice.explanation;
  CHECK(e.starts == 6);
  CHECK(e.methods == 4);
  CHECK(e.rounds == 1);
  CHECK(e.settings >= e.methods);
  CHECK(e.timed >= 1);
  CHECK(e.evaluations > 0);
  CHECK(e.truth_by == "exact");
  CHECK(e.truth_error == 1e-16 / 0.05);
  const std::string text = explanation_text(choice);
  CHECK(text.find("true motions: ") != std::string::npos);
  CHECK(text.find("4 methods at ") != std::string::npos);
  CHECK(choice_json(choice).find("\"explanation\"") != std::string::npos);
}

TEST_CASE("the parts of an answer's time add up to no more than all of it", "[choose]") {
  const auto slow_price = [](const Method& m, double setting) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return counted_cost(m, setting);
  };
  const auto start = std::chrono::steady_clock::now();
  const Explanation e = choose_for(asked(0.05, 10), 1, slow_price).explanation;
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start;
  CHECK(e.timing >= 0.02 * e.timed);
  CHECK(e.rest >= 0);
  const double parts = e.truths + e.search + e.timing + e.tests + e.rest;
  CHECK(parts <= all.count());
}

TEST_CASE("an answer that takes too long is no answer", "[choose]") {
  Need need = asked(0.05, 10);
  need.time_limit = 1e-9;
  CHECK_THROWS_AS(choose_for(need), OutOfTime);
}

TEST_CASE("an impossible need is refused", "[choose]") {
  CHECK(complaint([] { choose_for(asked(0, 10)); }).find("the error must be positive") != std::string::npos);
  CHECK(complaint([] { choose_for(asked(0.1, 1e-3)); }).find("shorter than a frame") != std::string::npos);
  CHECK(complaint([] { choose_for(asked(1e-30, 10)); }).find("known to") != std::string::npos);
  Need period = asked(0.1, 10);
  period.criterion = Criterion::period;
  CHECK(complaint([&] { choose_for(period); }).find("no two periods") != std::string::npos);
  const Entry still{{7, 99}, "", {"still", "", parameters, {}, nullptr}};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  CHECK(complaint([&] { choose(Task(still), Need{0.1}, truth); }).find("has no motion") != std::string::npos);
}

namespace {

/// Chooses over parts of the horizon, each price from `price_over`.
Choice choose_in_parts(const Need& need, const PriceOver& price_over, double a = 1) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(entry);
  task.parameters.set("a", a);
  return choose_in_time(task, need, truth, price_over);
}

}  // namespace

TEST_CASE("a long horizon has the same answer with and without parts", "[choose]") {
  for (const double error : {1e-3, 0.02, 1.0}) {
    const Need need = asked(error, 2400);
    const Choice whole = choose_for(need),
                 parts = choose_in_parts(need, [](const Need&) { return counted_cost; });
    INFO(error);
    CHECK_FALSE(parts.asked_horizon);
    REQUIRE(whole.chosen);
    REQUIRE(parts.chosen);
    CHECK(parts.chosen->algorithm == whole.chosen->algorithm);
    CHECK(parts.chosen->setting == whole.chosen->setting);
    CHECK(parts.chosen->error == whole.chosen->error);
  }
}

TEST_CASE(
    "methods that cost four times the choice over a part are not tried over the whole, except thoroughly",
    "[choose]") {
  Need need = asked(0.02, 2400);
  const auto price_over = [](const Need&) { return counted_cost; };
  const Choice whole = choose_for(need), parts = choose_in_parts(need, price_over);
  CHECK(parts.candidates.size() < whole.candidates.size());
  CHECK(parts.explanation.methods == whole.explanation.methods);
  CHECK(parts.explanation.left > whole.explanation.left);
  for (const Candidate& t : whole.candidates)
    if (!parts.was_followed(t) && whole.was_followed(t))
      CHECK(t.seconds_per_frame > 2 * parts.chosen->seconds_per_frame);
  need.thorough = true;
  CHECK(choose_in_parts(need, price_over).candidates.size() == choose_for(need).candidates.size());
}

TEST_CASE("a method that cost too much over a part is tried again where the choice costs as much",
          "[choose]") {
  // "sinking": exact to its setting over the part; over the whole only its finest setting of eight steps is.
  const auto sinking = [](const Parameters& p, const Horizon& horizon, const Reference& truth) {
    Quantity q = place(p, horizon, truth);
    const bool is_whole = horizon.end > 1000;
    q.add(method(
        "sinking", "explicit", halving("step", 0.1, 4), p["a"], horizon.count(),
        [=](double h) { return is_whole && h > 0.013 ? 1 : 1e-9; },
        [=](double h) { return std::lround(horizon.end / h); }));
    q.add(method(
        "steady", "explicit", halving("step", 0.1, 1), p["a"], horizon.count(), [](double) { return 1e-9; },
        [=](double h) { return std::lround(6 * horizon.end / h); }));
    return q;
  };
  Entry sinks = entry;
  sinks.exercise.scene->motion = sinking;
  Need need = asked(1e-3, 2400);
  need.only = {"sinking", "steady"};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Choice choice = choose_in_time(Task(sinks), need, truth, [](const Need&) { return counted_cost; });
  REQUIRE(choice.chosen);
  CHECK(choice.need.horizon == 2400);
  CHECK(choice.chosen->model == "steady");  // 6 evaluations a frame, where "sinking" takes 8
  CHECK(choice.explanation.left == 0);
}

TEST_CASE("over the whole of a long horizon no setting is tried that could not tie", "[choose]") {
  static std::mutex telling;
  static std::map<std::string, double> most;  // evaluations of a trial over the whole
  most.clear();
  const auto counted = [](const Parameters& p, const Horizon& horizon, const Reference& truth) {
    Quantity q = place(p, horizon, truth);
    q.add(method(
        "slow to converge", "explicit", halving("step", 0.1, 10), p["a"], horizon.count(),
        [=](double h) { return horizon.end > 1000 ? h : 1e-9; },
        [=](double h) { return std::lround(horizon.end / h); }));
    q.add(method(
        "flat", "closed form", no_resolution(), p["a"], horizon.count(), [](double) { return 1e-9; },
        [=](double) { return horizon.count() / 2; }));
    for (Method& m : q.methods) {
      const auto run = m.run;
      m.run = [run, horizon, name = m.model](double setting) {
        Answer answer = run(setting);
        const std::lock_guard lock(telling);
        if (horizon.end > 1000) most[name] = std::max(most[name], static_cast<double>(answer.evaluations));
        return answer;
      };
    }
    return q;
  };
  Entry slow = entry;
  slow.exercise.scene->motion = counted;
  Need need = asked(3e-3, 2400);
  need.only = {"flat", "slow"};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Choice choice = choose_in_time(Task(slow), need, truth, [](const Need&) { return counted_cost; });
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "flat");  // half an evaluation a frame
  CHECK(choice.explanation.left == 1);
  CHECK(most.at("slow to converge") == 24'000);  // one a frame
}

TEST_CASE("if the time ends before a long horizon does, the answer covers a part, and reports it",
          "[choose]") {
  const Need need = asked(0.02, 2400);
  std::vector<double> horizons;
  const Choice choice = choose_in_parts(need, [&](const Need& over) -> Price {
    horizons.push_back(over.horizon);
    if (over.horizon == need.horizon) throw OutOfTime("over");
    return counted_cost;
  });
  CHECK(horizons == std::vector<double>{300, 2400});
  REQUIRE(choice.chosen);
  CHECK(choice.need.horizon == 300);
  CHECK(choice.asked_horizon == 2400);
  CHECK_FALSE(choice.is_decided_by_part);
  CHECK(choice_text(choice, false).find("judged over the first 300 s of 2400 s") != std::string::npos);
  CHECK(choice_json(choice).find("\"judged_over\": 300.0") != std::string::npos);
  CHECK(choice_json(choice).find("\"horizon\": 2400.0") != std::string::npos);
  CHECK_THROWS_AS(choose_in_parts(need, [](const Need&) -> Price { throw OutOfTime("over"); }), OutOfTime);
}

TEST_CASE("if nothing holds over a part, nothing holds over the whole", "[choose]") {
  Need need = asked(1e-3, 2400);
  need.only = {"coarse"};
  std::vector<double> horizons;
  const auto price_over = [&](const Need& over) -> Price {
    horizons.push_back(over.horizon);
    return counted_cost;
  };
  const Choice choice = choose_in_parts(need, price_over, 1.5);
  CHECK_FALSE(choice.chosen);
  CHECK(choice.is_decided_by_part);
  CHECK(horizons == std::vector<double>{300});
  CHECK(choice_text(choice, false).find("nothing does over all of it") != std::string::npos);
  need.relative = true;  // to the size over the whole, which a part does not know
  CHECK_FALSE(choose_in_parts(need, price_over, 1.5).is_decided_by_part);
}
