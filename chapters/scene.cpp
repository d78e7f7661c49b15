#include "chapters/scene.hpp"

namespace oddity {

Ladder& Ladder::add(std::string model, std::string_view algorithm, bool has_tolerance,
                    std::function<Answer(double setting)> run, Outcome expected, std::string why,
                    std::function<double()> stable_step) {
  quantity_.add(Method{std::move(model), std::string(algorithm), has_tolerance ? tolerances_ : steps_,
                       std::move(run), expected, std::move(why), std::move(stable_step)});
  return *this;
}

}  // namespace oddity
