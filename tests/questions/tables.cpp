// Compares the judge's own motions with the reference tables, which were made independently.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/questions/follow.hpp"
#include "tests/questions/judge.hpp"
#include "tests/questions/scenes.hpp"

namespace questions {

namespace {

constexpr Real never = 1e30L;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
  return all;
}

std::string table_of(const std::string& scene) {
  static const std::map<std::string, std::string> tables{
      {"2.7", "02_07_orientation"}, {"3.3", "03_03_orbit"},       {"3.5", "03_05_swing"},
      {"3.7", "03_07_slide"},       {"3.9", "03_09_ball"},        {"3.11", "03_11_hill"},
      {"3.13", "03_13_chute"},      {"3.15", "03_15_slide"},      {"3.17", "03_17_bob"},
      {"3.19", "03_19_pulleys"},    {"3.21", "03_21_disk"},       {"3.23", "03_23_swing"},
      {"3.25", "03_25_chain"},      {"3.27", "03_27_two_bodies"}, {"3.29", "03_29_fall"},
      {"3.31", "03_31_slide"},      {"3.33", "03_33_axis"},       {"3.35", "03_35_axis"}};
  return tables.at(scene);
}

/// Renames a table's inputs to the scene's parameters; false if the scene has no such start.
bool rename_inputs(const std::string& scene, Parameters& p) {
  if (scene == "2.7") p["pace"] = 1;
  if (scene == "3.31")
    for (const char* speed : {"u", "v", "w"}) p[std::string(speed) + "0"] = p.at(speed);
  if (scene == "3.11") {
    if (p.at("p1") != 0 || p.at("p2") != 0) return false;
    p["factor"] = std::sqrt((std::pow(p.at("v1") / p.at("a1"), 2) + std::pow(p.at("v2") / p.at("a2"), 2)) /
                            (p.at("g") / 2));
  }
  return true;
}

}  // namespace

/// Prints a row for each scene. Returns how many differ.
int compare_with_tables(const std::string& folder) {
  int differ = 0;
  for (const Scene& scene : scenes()) {
    std::ifstream file(folder + "/" + table_of(scene.number) + ".csv");
    std::string line;
    while (std::getline(file, line) && line.starts_with("#")) {
    }
    const auto names = cells(line);
    const auto time = static_cast<std::size_t>(std::ranges::find(names, "t") - names.begin());
    std::map<std::string, std::map<double, Values>> starts;  // by inputs and time
    while (std::getline(file, line)) {
      const auto row = cells(line);
      std::string inputs;
      for (std::size_t i = 0; i < time; ++i) inputs += row[i] + ",";
      starts[inputs][std::strtod(row[time].c_str(), nullptr)].push_back(
          std::strtold(row[time + 2].c_str(), nullptr));
    }
    std::size_t rows = 0;
    Real most = 0, uncertain = 0;
    for (const auto& [inputs, values] : starts) {
      Parameters p;
      const auto row = cells(inputs);
      for (std::size_t i = 0; i < time; ++i) p[names[i]] = std::strtod(row[i].c_str(), nullptr);
      if (!rename_inputs(scene.number, p)) continue;
      std::vector<double> times;
      for (const auto& [t, value] : values) times.push_back(t);
      const Truth truth = truth_of(scene.motion(p), times);
      if (truth.frames.size() < times.size()) most = never;
      std::size_t frame = 0;
      for (const auto& [t, value] : values) {
        if (frame == truth.frames.size()) break;
        for (std::size_t i = 0; i < value.size(); ++i, ++rows) {
          const Real off =
              std::abs(truth.frames[frame].at(i) - value[i]) / std::max<Real>(1, std::abs(value[i]));
          most = off < never ? std::max(most, off) : never;
        }
        uncertain = std::max(uncertain, truth.uncertain[frame++]);
      }
    }
    const bool same = rows > 0 && most <= 10 * uncertain + 1e-16L;
    differ += !same;
    std::printf("%-5s %4zu values, at most %.1Le apart, uncertain by %.1Le%s\n", scene.number.c_str(), rows,
                most, uncertain, same ? "" : "  DIFFERENT");
    std::fflush(stdout);
  }
  return differ;
}

}  // namespace questions
