#include "report/site/data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace oddity {

using Json = nlohmann::ordered_json;

std::string exercise_data(const ExerciseResult& e, const Reference&) {
  const Json json{{"number", to_string(e.number)}, {"title", e.title}};
  return "oddity.exercise(" + json.dump() + ");\n";
}

}  // namespace oddity
