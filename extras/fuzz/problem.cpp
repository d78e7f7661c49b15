// A problem's file, TOML or XPPAUT's: read, its models built, their rates computed once.
#include "extras/fuzz/fuzz.hpp"

#include "problem/claims.hpp"
#include "problem/model.hpp"
#include "problem/ode_file.hpp"
#include "problem/staging.hpp"

using namespace oddity::problem;

namespace {

void run(const File& file) {
  std::vector<double> values;
  for (const ParameterText& p : file.parameters) values.push_back(p.value);
  for (const ModelText& text : file.models) {
    const Model model(file, text);
    const Numbers numbers = model.with(values);
    std::vector<double> x(numbers.start.begin(), numbers.start.end()), rates(x.size());
    if (!model.is_closed()) numbers.rates.run(x.data(), 0.5, rates.data());
    fuzz::require(numbers.start.size() == numbers.unknowns);
    std::vector<double> seen(numbers.observed.outputs().size());
    numbers.observed.run(x.data(), 0.5, seen.data());
  }
  if (!file.staged) return;
  const auto staging = Staged(file).with(values);
  staging.observe(std::vector<oddity::engines::State>(staging.world.bodies.size()), 0.5);
}

}  // namespace

void fuzz::read(std::string_view input) {
  if (input.empty()) return;
  const std::string text(input.substr(1));
  if (input.front() % 2 != 0) {
    run(*oddity::problem::read("input.toml", text));
  } else {
    run(*read_ode("input.ode", text));
  }
}
