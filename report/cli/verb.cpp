#include "report/cli/verb.hpp"

#include <unistd.h>

#include <iostream>

namespace oddity {

namespace verbs {

Screen output() { return screen_of(STDOUT_FILENO); }

void print(const Table& table, Format format) {
  std::cout << (format == Format::json ? to_json(table) : to_csv(table));
}

}  // namespace verbs

CLI::App* add_verb(CLI::App& app, const std::string& name, const std::string& says, const std::string& footer,
                   const std::function<void()>& act, bool shows_needs) {
  auto* verb = app.add_subcommand(name, says);
  verb->group("Verbs");
  verb->footer(footer);
  verb->callback([act, shows_needs] {
    if (shows_needs || !needs_are_asked()) act();
  });
  return verb;
}

void add_formats(CLI::App& verb, Formats& formats, const std::string& what) {
  auto* json = verb.add_flag("--json", formats.json, what + ", as JSON");
  verb.add_flag("--csv", formats.csv, what + ", as comma-separated values")->excludes(json);
}

void add_time_limit(CLI::App& verb, std::string& limit, const std::string& of) {
  add_value(verb, "--time-limit", limit, "TIME",
            "the longest that the answer may take" + of + ", or none: then it may take hours")
      ->capture_default_str();
}

void add_criteria(CLI::App& verb, AskedNeed& need) {
  add_value(
      verb, "--criterion", need.criterion, "WORD",
      "what must hold: path; energy (of the observed motion, near its true one); period (and the swing's size); "
      "bounded (nothing explodes); constraint (fixed lengths)")
      ->capture_default_str();
  add_value(
      verb, "--energy", need.energy, "PART",
      "also the energy of the observed motion: its error as a part of the energy that varies, 1% or 0.01");
  add_value(verb, "--period", need.period, "PART", "also the period: its relative error, 1% or 0.01");
  add_value(verb, "--constraint", need.constraint, "LENGTH",
            "also fixed lengths, and points on a surface or a wire: off by a length, 1mm");
}

void add_varied_frames(CLI::App& verb, AskedNeed& need) {
  add_value(verb, "--jitter", need.jitter, "PART",
            "random frames, longer or shorter by up to this part: 20%");
  add_value(verb, "--drop", need.drop, "PART", "part of the frames that is dropped, at random: 1%");
  add_value(verb, "--frame-seed", need.frame_seed, "N", "seed of the random frames: 2");
  add_value(verb, "--frames", need.trace, "FILE",
            "recorded lengths of frames, one per line, 16.7ms; repeated to the end");
}

void add_frames(CLI::App& verb, AskedNeed& need) {
  add_varied_frames(verb, need);
  verb.get_option("--frames")->excludes(verb.get_option("--fps"));
  add_value(verb, "--max-frame", need.longest_frame, "TIME",
            "the most that a frame moves the clock on: 100ms");
}

void add_kick(CLI::App& verb, AskedNeed& need) {
  add_value(
      verb, "--kick", need.kick, "KICK",
      "a contact or an impulse changes an observable or its rate: \"t=1s,theta'=+2\" adds 2 to a rate. A value "
      "with a sign adds, one without sets (theta=0.1), also theta=(-0.1), and * multiplies (speed=*0.5: all "
      "rates). Semicolons separate several changes. Closed forms take no kick");
}

void set_apart(CLI::App& verb, CLI::Option* option, std::initializer_list<const char*> others) {
  for (const char* other : others) option->excludes(verb.get_option(other));
}

}  // namespace oddity
