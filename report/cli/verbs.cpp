#include "report/cli/verbs.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <map>

#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "problem/template.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/proofs.hpp"
#include "reference/text.hpp"
#include "reference/to_write.hpp"
#include "report/cli/about.hpp"
#include "report/cli/asked.hpp"
#include "report/cli/enclosing.hpp"
#include "report/cli/words.hpp"
#include "report/pages/choose_view.hpp"
#include "report/pages/closing_screen.hpp"
#include "report/pages/code.hpp"
#include "report/pages/held_steps_view.hpp"
#include "report/pages/is_enough_view.hpp"
#include "report/pages/lockstep.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/pictures.hpp"
#include "report/pages/program.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/tables.hpp"
#include "report/pages/text_view.hpp"
#include "report/pages/trust.hpp"
#include "report/pages/write_report.hpp"
#include "report/site/own_page.hpp"
#include "report/site/site.hpp"
#include "report/study/cheapest_models.hpp"
#include "report/study/choose.hpp"
#include "report/study/earlier_results.hpp"
#include "report/study/held_steps.hpp"
#include "report/study/in_time.hpp"
#include "report/study/is_enough.hpp"
#include "report/study/kept_results.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/prices.hpp"
#include "report/study/progress.hpp"
#include "report/study/run.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/study/stability.hpp"
#include "report/text/readable.hpp"
#include "solvers/ode/catalog.hpp"
#include "solvers/stop.hpp"

namespace oddity::verbs {

namespace {

Reference truth_of(const fs::path& folder, bool enclosed, fs::path cache = {}) {
  const Reference truth(folder, std::move(cache));
  return enclosed ? truth.enclosed_by(enclosing()) : truth;
}

/// The last results. Runs exercises again whose code, tables or ledger have changed. If wanted, adds the
/// cheapest models, which a run of the suite neither needs nor makes.
Results last_results(const fs::path& folder, bool cheapest_models) {
  const fs::path file = results_file();
  const Reference truth(folder, motions_folder());
  const std::vector<Task> tasks(registry().begin(), registry().end());
  const MadeFrom here = made_from(folder);
  std::size_t run_again = 0, extended = 0;
  Results results = completed(
      kept_results(file, here), tasks, [](const ExerciseResult& e) { return !e.made_from.empty(); },
      [&](const Results&, std::span<const Task> lacking) {
        run_again = lacking.size();
        return noted(with_progress([&](const Progress& progress) {
                       return with_stability(run(lacking, truth, true, progress), lacking, truth, progress);
                     }),
                     here);
      });
  const std::string program = made_by(folder);
  if (run_again == tasks.size())
    results.made_by = program;
  else if (run_again > 0 && results.made_by != program)
    results.made_by = "several programs";
  if (cheapest_models)
    results = completed(
        std::move(results), tasks, [](const ExerciseResult& e) { return !e.scene || e.cheapest_models; },
        [&](Results some, std::span<const Task> lacking) {
          extended = lacking.size();
          return with_progress([&](const Progress& progress) {
            return with_cheapest_models(std::move(some), lacking, truth, progress);
          });
        });
  if (run_again > 0 || extended > 0) write_whole(file, to_json(results));
  return results;
}

/// "0.001 to 3.14", "whole, 2 to 100"; empty if any number is allowed.
std::string range_of(const Parameter& p) {
  const bool from = std::isfinite(p.least), to = std::isfinite(p.most);
  const std::string ends = from && to ? format_shortest(p.least) + " to " + format_shortest(p.most)
                           : from     ? "from " + format_shortest(p.least)
                           : to       ? "up to " + format_shortest(p.most)
                                      : "";
  return (p.whole ? "whole" : "") + std::string(p.whole && !ends.empty() ? ", " : "") + ends;
}

std::string in_list(const Entry& entry, const Screen& screen) {
  std::string text =
      screen.styled(Style::heading, to_string(entry.number) + "  " + std::string(entry.exercise.title)) +
      (entry.exercise.scene ? " (scene)" : "") + (of_the_book(entry.number) ? "" : " (own)") + "\n";
  for (const Parameter& p : entry.exercise.parameters) {
    const std::string range = range_of(p);
    text += "      " + std::string(p.name) + " = " + format_shortest(p.value) +
            (p.unit.empty() || p.unit == "1" ? "" : " " + std::string(p.unit)) + "  " +
            readable(std::string(p.says)) + (range.empty() ? "" : " (" + range + ")") + "\n";
  }
  return wrapped(text, screen, 10);
}

/// The reference, limited by the time limit of the answer.
Reference truth_in_time(const fs::path& folder) {
  return Reference(folder, motions_folder()).watched([](double) { check_stop(); });
}

/// Returns the result of `work`, with the limit for each of so many exercises, counted from the program's
/// start.
template <class Work>
auto in_time_for_each(const std::string& limit, std::size_t exercises, const Work& work) {
  return in_time(time_limit_of(limit) * static_cast<double>(exercises) - seconds_running(),
                 exercises > 1 ? "fewer exercises at once" : "", work);
}

/// In the tasks' common unit of time; empty if not given.
std::optional<double> horizon_of(const std::vector<Task>& tasks, const std::string& text) {
  if (text.empty()) return {};
  std::optional<double> horizon;
  for (const Task& task : tasks) {
    const double here = between("--horizon", text, task.entry->exercise.scene->axes.time, 1e-12, 1e12);
    if (horizon && *horizon != here)
      throw BadInput("--horizon " + text + " is another time for " + to_string(task.entry->number) +
                     ", whose unit is " + std::string(task.entry->exercise.scene->axes.time));
    horizon = here;
  }
  return horizon;
}

/// The additional need of each task; empty unless the options add one. Judges at most 4,096 times of a
/// motion.
std::vector<Need> other_needs(const AskedStability& asked, const std::vector<Task>& tasks,
                              std::optional<double> horizon) {
  constexpr double looks = 4096;
  const std::string option = accuracy_option(asked.need);
  if (option.empty()) return {};
  if (asked.words.empty()) throw BadInput(option + " is of an exercise: name one, such as 3.5");
  std::vector<Need> needs;
  for (const Task& task : tasks) {
    const double end = horizon.value_or(task.entry->exercise.scene->horizon);
    if (constexpr double shortest = looks * 1e-12; end < shortest)
      throw BadInput(option + " takes a --horizon from " + format_significant(shortest, 2) + " on");
    AskedNeed one = asked.need;
    one.as_engines = true;
    one.time_limit = "none";
    one.horizon = format_shortest(end);
    one.frames_per_second = format_shortest(looks / end);
    needs.push_back(need_of(task, one));
  }
  return needs;
}

/// "angle within 1 deg at the end of every step".
std::string in_words(const Need& need, const Task& task) {
  const Scene& scene = *task.entry->exercise.scene;
  const Quantity seen = motion(scene, task.parameters, Reference::nothing());
  Choice asked;
  asked.need = need;
  asked.quantity = seen.name;
  for (std::string_view unit : seen.units()) asked.units.emplace_back(unit);
  asked.needs = needs_of(need, seen);
  return what_holds(asked, "at the end of every step");
}

/// Horizon and need of each task, checked before anything runs.
struct StabilityTasks {
  std::vector<Task> tasks;
  std::optional<double> horizon;
  std::vector<Need> needs;
  std::vector<FramesAsked> frames;  ///< one per task; empty: all have the same length

  double end(std::size_t i) const { return horizon.value_or(tasks[i].entry->exercise.scene->horizon); }
};
StabilityTasks stability_tasks(const AskedStability& asked) {
  StabilityTasks all{scenes_of(asked.words), {}, {}, {}};
  all.horizon = horizon_of(all.tasks, asked.horizon);
  all.needs = other_needs(asked, all.tasks, all.horizon);
  for (const Task& task : all.tasks) {
    const std::string time(task.entry->exercise.scene->axes.time);
    if (const FramesAsked frames = frames_of(asked.need, time); !says(frames, time).empty())
      all.frames.push_back(frames);
  }
  return all;
}

struct FoundStability {
  Results results;
  std::vector<HeldSteps> held;  ///< for each exercise in turn; empty: not requested
};
FoundStability stability_of(const fs::path& folder, const AskedStability& asked) {
  const StabilityTasks all = stability_tasks(asked);
  Results blank;
  for (const Task& task : all.tasks) {
    ExerciseResult& e = blank.exercises.emplace_back();
    e.number = task.entry->number;
    e.title = task.entry->exercise.title;
  }
  const Reference truth = truth_in_time(folder);
  FoundStability found;
  in_time_for_each(asked.need.time_limit, all.tasks.size(), [&] {
    for (std::size_t i = 0; i < all.needs.size(); ++i) {
      found.held.push_back(with_progress(
          [&](const Progress& progress) { return held_steps(all.tasks[i], all.needs[i], truth, progress); }));
      found.held.back().asked = in_words(all.needs[i], all.tasks[i]);
    }
    if (!all.frames.empty()) found.held.resize(all.tasks.size());
    for (std::size_t i = 0; i < all.frames.size(); ++i)
      with_progress([&](const Progress& progress) {
        find_stable_at_frames(found.held[i], all.tasks[i], all.frames[i], all.end(i), progress);
        return 0;
      });
    found.results = with_progress([&](const Progress& progress) {
      return with_stability(blank, all.tasks, truth, progress, all.horizon);
    });
  });
  for (const ExerciseResult& e : found.results.exercises)
    if (!e.failure.empty()) throw BadInput("exercise " + to_string(e.number) + " raised: " + e.failure);
  return found;
}

/// The book must not depend on installed libraries.
void require_common_algorithms() {
  if (ode::not_in_catalog().empty())
    throw BadInput("the book has no algorithms of SUNDIALS: build it with -DODDITY_SUNDIALS=OFF");
}

/// Refuses to choose without a reference.
void require_truth(const Task& task, const Reference& truth) {
  const Quantity seen = motion(*task.entry->exercise.scene, task.parameters, truth);
  if (seen.reference.by.starts_with(to_write_mark))
    throw BadInput("exercise " + to_string(task.entry->number) +
                   " has no truth to judge by: " + seen.reference.by);
}

Results trials_of(const fs::path& folder, const std::vector<Task>& tasks, const std::string& time_limit) {
  return in_time_for_each(time_limit, tasks.size(), [&] {
    return with_progress(
        [&](const Progress& progress) { return run(tasks, truth_in_time(folder), true, progress); });
  });
}

fs::path report_of(const Results& results, const fs::path& folder, Edition edition, const fs::path& out) {
  return with_progress([&](const Progress& progress) {
    return write_report(results, edition, out, progress, read_trust(folder));
  });
}

std::vector<EngineContest> kept_contests() {
  return fs::exists(engines_file()) ? read_engines(engines_file()) : std::vector<EngineContest>();
}

fs::path site_of(const Results& results, const fs::path& folder, const fs::path& out) {
  return with_progress([&](const Progress& progress) {
    return write_site(results, Reference(folder, motions_folder()), out, progress, kept_contests(),
                      read_trust(folder));
  });
}

void require_room_for_report(const fs::path& out, bool overwrite) {
  take_to_write(out, overwrite);
  make_folder(out);
}

void require_room_for_site(const fs::path& out, bool overwrite) {
  take_to_write(out, overwrite);
  require_writable_folder(out);
}

}  // namespace

void list(const std::vector<std::string>& exercises, Format format, const OtherEngines& engines) {
  const std::vector<Task> tasks = tasks_about(exercises);
  if (format != Format::text) return print(parameters_table(tasks), format);
  for (const Task& task : tasks) std::cout << in_list(*task.entry, output());
  for (const std::string& name : engines.scenes())
    if (std::ranges::any_of(exercises, [&](const std::string& text) { return is_about(name, text); }))
      std::cout << name << " (a scene of engines alone: " << program_as_typed() << " engines "
                << for_shell(name) << ")\n";
}

void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool enclosed, Format format) {
  const Task task = task_of(exercise, overrides);
  const Reference truth = truth_of(folder, enclosed);
  const Results results = with_progress(
      [&](const Progress& progress) { return run(std::span(&task, 1), truth, true, progress); });
  if (format == Format::csv) return print(trials_table(results), format);
  std::cout << (format == Format::json ? to_json(results) : text_view(results.exercises.front(), output()));
}

namespace {

/// The limit is for the whole answer: subtracts the time since the program began.
Need in_what_is_left(Need need) {
  need.time_limit -= seconds_running();
  return need;
}

OtherEngines::Answer engines_in_time(const OtherEngines::Answers& engines, const Choice& choice,
                                     const Reference& truth, const Need& need) {
  try {
    return in_time(in_what_is_left(need).time_limit, "", [&] { return engines(choice, truth); });
  } catch (const OutOfTime&) {
    return {"  the engine came to no end within the time limit\n", "[]"};
  }
}

/// Chooses, and keeps the methods' costs for the next run, separately for each part of a long horizon.
Choice choice_in_time(const Task& task, const Need& asked, const Reference& truth, bool anew,
                      const ManyBodies& bodies) {
  std::map<double, KeptPrices> kept;  // by horizon
  Choice choice = with_progress([&](const Progress& progress) {
    const PriceOver price_over = [&](const Need& need) -> Price {
      const auto [prices, made] =
          kept.try_emplace(need.horizon, prices_folder(), price_key(task, need), anew,
                           need.bodies > 1 ? bodies.price(task, need) : Price(measured_price));
      return std::ref(prices->second);
    };
    return choose_in_time(task, in_what_is_left(asked), truth, price_over, progress);
  });
  for (auto& [horizon, prices] : kept) prices.keep();
  choice.prices_are = kept.at(choice.need.horizon).source();
  if (asked.bodies > 1 && choice.chosen) choice.registers = bodies.registers(choice);
  return choice;
}

/// Judges the user's method, and shows the recommended one if it is found in time.
int judge_own(const fs::path& folder, const Task& task, const AskedNeed& asked, const Need& need,
              Format format, const ManyBodies& bodies) {
  const MethodAsked method = method_of(task, asked, need);
  const Reference truth(folder, motions_folder());
  if (!of_the_book(task.entry->number)) require_truth(task, truth);
  const IsEnough found = with_progress([&](const Progress& progress) {
    return is_enough(task, in_what_is_left(need), method, truth, measured_price, progress);
  });
  if (format != Format::text) {
    print(is_enough_table(found), format);
    return found.holds() ? 0 : 1;
  }
  const std::optional<Choice> choice = [&]() -> std::optional<Choice> {
    try {
      return choice_in_time(task, need, truth, asked.measure, bodies);
    } catch (const OutOfTime&) {
      return {};
    }
  }();
  std::cout << is_enough_text(found, output())
            << wrapped(choice ? "\n" + asked_text(*choice) + ":\n" + part_text(*choice) +
                                    (choice->chosen ? answer_text(*choice, output())
                                                    : "nothing here meets that.\n")
                              : "\nno better method was found within the time limit\n",
                       output(), 4);
  return found.holds() ? 0 : 1;
}

}  // namespace

int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const AskedNeed& asked, Format format, bool all_rows, const std::string& engine,
           const std::string& command, const std::string& language, const Extras& extras) {
  const Language written = language_of(language);
  const Task task = task_of(exercise, overrides);
  const Need need = asked.lockstep ? in_lockstep(need_of(task, asked), task) : need_of(task, asked);
  require_language(written, task, need);
  if (!asked.method.empty()) return judge_own(folder, task, asked, need, format, extras.bodies);
  if (need.frame_times && !engine.empty())
    throw BadInput(
        "--engine is for frames of one length: leave out --jitter, --drop, --frames and --max-frame");
  if (!engine.empty()) extras.engines.require_scene(*task.entry);
  if (needs_are_all(need.bodies > 1 ? extras.bodies.needs : Needs())) return 0;
  const auto engines = engine.empty() ? OtherEngines::Answers() : extras.engines.named(engine, task);
  const Reference truth = truth_of(folder, asked.enclosed, motions_folder());
  if (!of_the_book(task.entry->number)) require_truth(task, truth);
  Choice choice = choice_in_time(task, need, truth, asked.measure, extras.bodies);
  if (asked.lockstep) choice.lockstep = lockstep_of(task, choice, in_what_is_left(need).time_limit);
  const auto beside = engines ? engines_in_time(engines, choice, truth, need) : OtherEngines::Answer();
  if (format == Format::text && !asked.says.empty())
    std::cout << exercise << " states no need, so the need is " << asked.says << "\n";
  if (format == Format::csv || (format == Format::code && choice.chosen)) std::cerr << part_text(choice);
  if (format == Format::code && !choice.chosen)
    std::cerr << choice_text(choice, all_rows, screen_of(STDERR_FILENO));
  else
    std::cout << (format == Format::json   ? choice_json(choice, beside.json)
                  : format == Format::csv  ? choice_csv(choice)
                  : format == Format::code ? code_of(task, choice, command, written)
                                           : choice_text(choice, all_rows, output()));
  if (asked.enclosed && format == Format::text) std::cout << truth_text(choice, output());
  if (asked.explain && format == Format::text) std::cout << "\n" << explanation_text(choice);
  if (format == Format::text) std::cout << beside.text;
  return choice.chosen && !choice.asked_horizon ? 0 : 1;
}

void report(const fs::path& folder, const std::string& chapter, Edition edition, const fs::path& out,
            bool overwrite) {
  const int number = chapter.empty() ? 0 : chapter_of(chapter);
  if (edition == Edition::book) require_common_algorithms();
  require_room_for_report(out, overwrite);
  require_writable(results_file());
  Results results = last_results(folder, number == 0);
  if (number != 0)
    std::erase_if(results.exercises, [&](const ExerciseResult& e) { return e.number.chapter != number; });
  std::cout << "the report is in " << report_of(results, folder, edition, out).string() << "\n";
}

void trust(const fs::path& folder, Format format) {
  require_writable(results_file());
  const Trust on_record = read_trust(folder);
  const Results results = last_results(folder, false);
  if (format != Format::text) return print(trust_table(results, on_record), format);
  std::cout << trust_text(results, on_record, output());
}

namespace {

void list_missing_parts() {
  const SiteParts parts = parts_at_hand();
  for (const std::string& one : lacks(parts)) std::cerr << "oddity: this copy lacks " << one << "\n";
  if (!lacks(parts).empty()) std::cerr << "oddity: a whole one is made by: " << command_for(parts) << "\n";
}

}  // namespace

void site(const fs::path& folder, const fs::path& out, bool overwrite) {
  require_room_for_site(out, overwrite);
  if (needs_are_all(needs_of_site())) return;
  require_writable(results_file());
  const Results results = last_results(folder, true);
  std::cout << "the report that runs is in " << site_of(results, folder, out).string() << "\n";
  list_missing_parts();
}

namespace {

/// The answer of `choose` for a file; empty if it takes too long.
std::string chosen_of_file(const fs::path& folder, const Task& task) {
  if (!task.entry->exercise.scene) return "";
  AskedNeed asked;
  ask_as_file(asked, *task.entry);
  try {
    const Choice choice =
        choice_in_time(task, need_of(task, asked), truth_of(folder, false, motions_folder()), false, {});
    return asked_text(choice) + ": " + (choice.chosen ? answer_text(choice) : "nothing here meets that.");
  } catch (const OutOfTime&) {
    return "";
  }
}

/// The task of a file that the page can read.
Task task_of_page(const std::string& file) {
  const Task task = task_of(file, {});
  if (file.ends_with(".ode"))
    throw BadInput("the page reads no .ode files: 'choose', 'chart' and 'solve' take " + file);
  return task;
}

/// `file` becomes a page that needs no other. Throws BadInput where `choose` refuses it.
std::string page_of_file(const fs::path& folder, const std::string& file) {
  const Task task = task_of_page(file);
  return own_in_one_file({std::string(task.entry->exercise.title), problem::source_of(*task.entry).text,
                          chosen_of_file(folder, task)});
}

void write_page(const fs::path& out, const std::string& page) {
  write_whole(out, page);
  std::cout << "the page is " << out.string() << "\n";
  list_missing_parts();
}

}  // namespace

void site_of_file(const fs::path& folder, const std::string& file, const fs::path& out, bool overwrite) {
  if (!problem::is_file(file))
    throw BadInput("site takes a problem's file, such as suspension.toml; for an exercise, --single " +
                   to_string(task_of(file, {}).entry->number) + " writes the page");
  task_of_page(file);
  if (needs_are_all(needs_of_site())) return;
  const std::string page = page_of_file(folder, file);
  require_room_for_site(out, overwrite);
  write_page(out / "index.html", page);
}

void single(const fs::path& folder, const std::string& exercise, const fs::path& out, bool overwrite) {
  const Task task = problem::is_file(exercise) ? task_of_page(exercise) : task_of(exercise, {});
  if (fs::exists(fs::symlink_status(out)) && !overwrite)
    throw BadInput(out.string() + " is there: name a new file by --out, or write over it by --overwrite");
  if (needs_are_all(needs_of_site())) return;
  if (problem::is_file(exercise)) return write_page(out, page_of_file(folder, exercise));
  require_writable(out);
  require_writable(results_file());
  const Results results = last_results(folder, true);
  const auto one = std::ranges::find(results.exercises, task.entry->number, &ExerciseResult::number);
  write_page(out, single_page(results, *one, Reference(folder, motions_folder()), kept_contests(),
                              read_proofs(folder / "approved")));
}

Needs needs_of_site() { return {packages_of_models(), {}, {"models_module"}}; }

void require_room_for_all(const fs::path& report_out, const fs::path& site_out) {
  require_room_for_report(report_out, false);
  require_room_for_site(site_out, false);
  require_writable(results_file());
}

void publish(const fs::path& folder, const fs::path& report_out, const fs::path& site_out, bool as_on_record,
             const std::function<double()>& seconds) {
  const Results results = last_results(folder, true);
  const fs::path report = report_of(results, folder, Edition::whole, report_out),
                 site = site_of(results, folder, site_out);
  const SiteParts parts = parts_at_hand();
  std::cout << closing_screen(
      results, {as_on_record, seconds(), site, report, program_as_typed(), lacks(parts), command_for(parts)},
      output());
}

void chart(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed& asked,
           Curves curves, const fs::path& out, bool overwrite, const OtherEngines& engines) {
  const std::vector<Task> tasks = tasks_at_frames(exercises, asked);
  take_to_write(out, overwrite);
  make_folder(out);
  const Results results = trials_of(folder, tasks, asked.time_limit);
  const auto pages =
      with_progress([&](const Progress& progress) { return write_charts(results, curves, out, progress); });
  for (const fs::path& page : pages) std::cout << page.string() << "\n";
  if (asked.frames_are_given) return;  // engines ran at frames of one length
  for (const fs::path& picture : engines.draw(tasks, Reference(folder, motions_folder()), out))
    std::cout << picture.string() << "\n";
}

void chart_table(const fs::path& folder, const std::vector<std::string>& exercises, const AskedNeed& asked,
                 Format format) {
  print(trials_table(trials_of(folder, tasks_at_frames(exercises, asked), asked.time_limit)), format);
}

void stability(const fs::path& folder, const AskedStability& asked, const fs::path& out, bool overwrite) {
  stability_tasks(asked);
  take_to_write(out, overwrite);
  make_folder(out);
  const auto [results, held] = stability_of(folder, asked);
  for (std::size_t i = 0; i < results.exercises.size(); ++i) {
    const ExerciseResult& e = results.exercises[i];
    std::cout << stability_text(e, held.empty() ? HeldSteps() : held[i], output()) << "\n";
    draw_map(e, out);
  }
  std::cout << "the maps are in " << (out / "charts").string() << "\n";
}

void stability_table(const fs::path& folder, const AskedStability& asked, Format format) {
  const auto [results, held] = stability_of(folder, asked);
  print(limits_table(results, held), format);
}

void stability_rows(const fs::path& folder, const AskedStability& asked) {
  if (const auto overrides = with_overrides(asked.words).overrides; !overrides.empty())
    throw BadInput("--rows are of the exercises as they are: leave '" + overrides.front() + "' out");
  const Results results = stability_of(folder, asked).results;
  std::cout << limit_rows(results) << "\n" << map_rows(results);
}

int judge(const std::string& file, Format format) {
  const Entry& entry = problem::entry_of_file(file);
  const Verdicts& stated = problem::stated_by(entry);
  if (stated.empty()) throw BadInput(file + " has no claims: add [[claim]] with says, printed and truth");
  ExerciseResult judged;
  judged.number = entry.number;
  judged.title = entry.exercise.title;
  for (Claim& claim :
       entry.exercise.study(Parameters(entry.exercise.parameters), Reference::nothing()).claims) {
    const Verdict found = verdict(claim);
    judged.claims.push_back({std::move(claim), found});
  }
  const auto is_so = [&](const JudgedClaim& one) { return name_of(one.verdict) == stated.at(one.claim.id); };
  const bool all = std::ranges::all_of(judged.claims, is_so);
  if (format != Format::text) {
    Results results;
    results.exercises = {std::move(judged)};
    print(claims_table(results, stated), format);
    return all ? 0 : 1;
  }
  std::string text = text_view(judged, output());
  for (const JudgedClaim& one : judged.claims)
    if (!is_so(one))
      text += "\n" + wrapped("The file expects this to be " + stated.at(one.claim.id) + ", but it is " +
                                 std::string(name_of(one.verdict)) + ":\n" +
                                 with_short_numbers(claims_evidence(one)) +
                                 (one.claim.why.empty() ? "" : "  " + one.claim.why + "\n"),
                             output(), 4);
  std::cout << text;
  return all ? 0 : 1;
}

void create_problem(const fs::path& file, const std::string& from_exercise) {
  if (fs::exists(file)) throw BadInput(file.string() + " is there already, and is not overwritten");
  write_whole(file, std::string(from_exercise.empty() ? problem::begun : scene_as_file(from_exercise)));
  std::cout << file.string() << "\n"
            << program_as_typed() << " choose " << for_shell(file.string())
            << "  # runs as it is: change it, and ask again\n";
}

void create(NewExercise asked) {
  if (!asked.in.empty()) asked.in = fs::absolute(asked.in).lexically_normal();
  const std::vector<NewFile> files = new_files(asked);
  for (const NewFile& file : files) write_whole(file.path, file.text);
  for (const NewFile& file : files)
    std::cout << (asked.in.empty() ? file.path.lexically_relative(source_folder()) : file.path).string()
              << "\n";
  const std::string oddity =
      (asked.in.empty() ? "" : "ODDITY_OWN=" + for_shell(asked.in.string()) + " ") + "./oddity ";
  std::cout << oddity << "solve " << asked.number << "  # builds it and runs it\n"
            << oddity << "verify '[" << asked.number << "]'  # lists the gaps, and their places\n"
            << oddity << "verify --approve '[" << asked.number
            << "]'  # without gaps: approves its results\n";
  if (own_tree().empty())
    std::cout << "# An installed program builds nothing: run these in a clone of oddity's sources.\n";
}

}  // namespace oddity::verbs
