#include "extras/mutation/kept_points.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "extras/mutation/schemata.hpp"
#include "reference/files.hpp"

namespace oddity::mutation {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::uint64_t this_program() {
  static const std::uint64_t number = number_of(read("/proc/self/exe"));
  return number;
}

}  // namespace

static void to_json(json& j, const Extent& e) { j = {e.begin, e.end}; }
static void from_json(const json& j, Extent& e) { e = {j.at(0), j.at(1)}; }

static void to_json(json& j, const Point& p) {
  j = {static_cast<int>(p.shape),
       p.function,
       p.whole,
       p.op,
       p.operators[0],
       p.operators[1],
       p.within,
       p.mutations,
       p.free};
}
static void from_json(const json& j, Point& p) {
  p = {static_cast<Shape>(j.at(0).get<int>()),
       j.at(1),
       j.at(2),
       j.at(3),
       {j.at(4), j.at(5)},
       j.at(6),
       j.at(7),
       j.at(8)};
}

static void to_json(json& j, const Mutable& m) { j = {m.file, m.text, m.points, m.left_out}; }
static void from_json(const json& j, Mutable& m) {
  j.at(0).get_to(m.file);
  j.at(1).get_to(m.text);
  j.at(2).get_to(m.points);
  j.at(3).get_to(m.left_out);
}

static void to_json(json& j, const KeptPoints::Unit& u) { j = {u.text, u.included, u.shown}; }
static void from_json(const json& j, KeptPoints::Unit& u) {
  j.at(0).get_to(u.text);
  j.at(1).get_to(u.included);
  j.at(2).get_to(u.shown);
}

KeptPoints::KeptPoints(fs::path file) : file_(std::move(file)) {
  if (!fs::exists(file_)) return;
  const json all = json::parse(read(file_));
  if (all.at("program") == this_program()) all.at("units").get_to(units_);
}

std::uint64_t KeptPoints::now(const std::string& file) {
  const auto [at, fresh] = now_.try_emplace(file, 0);
  if (fresh) at->second = number_of(read(file));
  return at->second;
}

const KeptPoints::Unit* KeptPoints::of(const std::string& unit, const std::string& text) {
  const auto at = units_.find(unit);
  if (at == units_.end() || at->second.text != number_of(text)) return nullptr;
  const bool as_it_was = std::ranges::all_of(
      at->second.included, [&](const auto& file) { return now(file.first) == file.second; });
  return as_it_was ? &at->second : nullptr;
}

void KeptPoints::add(const std::string& unit, const std::string& text,
                     const std::vector<std::string>& included, std::vector<Mutable> shown) {
  Unit& u = units_[unit] = {number_of(text), {}, std::move(shown)};
  for (const std::string& file : included) u.included[file] = now(file);
}

void KeptPoints::write() const {
  write_whole(file_, json{{"program", this_program()}, {"units", units_}}.dump());
}

}  // namespace oddity::mutation
