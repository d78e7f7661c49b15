// An engine as a separate program. `--about` prints its description; otherwise it reads one request
// (world_json.hpp) and writes one reply. An abort or an endless loop of the engine ends only this process.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "extras/engines/adapters/simulation.hpp"
#include "extras/engines/world_json.hpp"
#include "solvers/turns.hpp"

namespace oddity::engines {

namespace {

using nlohmann::json;

/// Forces that the engine does not compute: the world's springs, and the forces of its moving axes.
class Pushes {
 public:
  explicit Pushes(const World& world) : world_(world) {
    for (const Spring& s : world.springs)
      ends_.push_back({Point(world, s.a, s.at), Point(world, s.b, s.end)});
    shaken_ = world.shaking != Vector{};
    turning_ = world.turning != Vector{};
  }

  void before_step(Simulation& simulation, double t) const {
    if (shaken_) simulation.set_gravity(world_.gravity + std::sin(world_.frequency * t) * world_.shaking);
    if (!simulation.has_springs())
      for (std::size_t i = 0; i < ends_.size(); ++i) pull(simulation, world_.springs[i], ends_[i]);
    if (turning_)
      for (std::size_t i = 0; i < world_.bodies.size(); ++i) turn(simulation, static_cast<int>(i));
  }

 private:
  using Ends = std::array<Point, 2>;

  static Vector now(const Simulation& simulation, const Point& point) {
    return point.body == ground ? point.in_body : point.at(simulation.state(point.body));
  }
  static void pull(Simulation& simulation, const Spring& spring, const Ends& ends) {
    const Vector a = now(simulation, ends[0]), b = now(simulation, ends[1]), along = b - a;
    const double length = std::hypot(along[0], along[1], along[2]);
    const Vector force = spring.stiffness * (1 - spring.rest / length) * along;
    if (spring.a != ground) simulation.push(spring.a, force, a);
    if (spring.b != ground) simulation.push(spring.b, -1.0 * force, b);
  }
  void turn(Simulation& simulation, int body) const {
    const State s = simulation.state(body);
    const Vector& w = world_.turning;
    const Vector acceleration = -2.0 * cross(w, s.velocity) - cross(w, cross(w, s.position));
    simulation.push(body, body_of(world_, body).mass * acceleration, s.position);
  }

  const World& world_;
  std::vector<Ends> ends_;
  bool shaken_ = false, turning_ = false;
};

bool is_finite(const State& s) {
  const auto all = [](const auto& numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
  };
  return all(s.position) && all(s.orientation) && all(s.velocity) && all(s.spin);
}

/// One run of a request, with its states at the frames.
class Run {
 public:
  explicit Run(const Request& request)
      : request_(request),
        step_(1 / (request.frames_per_second * request.steps_per_frame)),
        simulation_(engine().make(request.world, request.variant, step_)),
        pushes_(request.world) {
    see();
  }

  /// Continues as long as the states are finite.
  void to_frame(int frame) {
    for (; frame_ < frame && finite_; ++frame_) {
      const auto start = std::chrono::steady_clock::now();
      for (int i = 0; i < request_.steps_per_frame; ++i) {
        pushes_.before_step(*simulation_, (frame_ * request_.steps_per_frame + i) * step_);
        simulation_->step(step_);
      }
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      see();
    }
  }
  bool save() { return simulation_->save(); }
  void back_to(int frame) {
    simulation_->restore();
    frame_ = frame;
    frames.resize(std::min(frames.size(), static_cast<std::size_t>(frame) + 1));
    finite_ = frames.size() == static_cast<std::size_t>(frame) + 1;
  }

  double seconds = 0;
  std::vector<std::vector<State>> frames;

 private:
  void see() {
    std::vector<State> bodies;
    for (std::size_t i = 0; i < request_.world.bodies.size(); ++i)
      bodies.push_back(simulation_->state(static_cast<int>(i)));
    finite_ = std::ranges::all_of(bodies, is_finite);
    if (finite_) frames.push_back(std::move(bodies));
  }

  const Request& request_;
  double step_;
  std::unique_ptr<Simulation> simulation_;
  Pushes pushes_;
  int frame_ = 0;
  bool finite_ = true;
};

bool same_bits(const std::vector<std::vector<State>>& a, const std::vector<std::vector<State>>& b) {
  static_assert(std::is_trivially_copyable_v<State>);
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(a[i].data(), b[i].data(), a[i].size() * sizeof(State)) != 0) return false;
  return true;
}

std::string restored(const Request& request) {
  Run run(request);
  const int half = request.frames / 2;
  run.to_frame(half);
  if (!run.save()) return "not offered";
  run.to_frame(request.frames);
  const auto first = run.frames;
  run.back_to(half);
  run.to_frame(request.frames);
  return same_bits(first, run.frames) ? "same bits" : "other bits";
}

Reply reply(const Request& request) {
  Reply reply;
  try {
    if (!request.world.ropes.empty() && !engine().ropes)
      throw NotExpressible("no rope that turns its pulleys");
    for (int i = 0; i < request.runs; ++i) {
      Run run(request);
      run.to_frame(request.frames);
      reply.seconds.push_back(run.seconds);
      reply.same_bits = reply.same_bits && (i == 0 || same_bits(reply.frames, run.frames));
      if (i == 0) reply.frames = std::move(run.frames);
    }
    if (request.restored) reply.restored = restored(request);
  } catch (const NotExpressible& lacking) {
    reply.cannot = lacking.what();
  }
  return reply;
}

json about() {
  const auto settings = std::filesystem::read_symlink("/proc/self/exe").replace_filename("variants.json");
  std::ifstream file(settings);
  if (!file)
    throw std::runtime_error("cannot read " + settings.string() + ", which has the engine's settings");
  const Engine e = engine();
  return {{"name", e.name},
          {"version", e.version},
          {"precision", e.precision},
          {"plane", e.plane},
          {"variants", json::parse(file).at(ADAPTER)}};
}

}  // namespace

}  // namespace oddity::engines

int main(int count, char** words) {
  using namespace oddity::engines;
  std::FILE* const out = fdopen(dup(STDOUT_FILENO), "w");
  if (!std::freopen("/dev/null", "w", stdout)) return 1;  // engines may print anything there
  const bool asked_about = count == 2 && std::strcmp(words[1], "--about") == 0;
  const json answer = asked_about ? about() : json(reply(json::parse(std::cin).get<Request>()));
  std::fputs((answer.dump() + "\n").c_str(), out);
  return std::fclose(out);
}
