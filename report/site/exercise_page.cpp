#include "report/site/exercise_page.hpp"

#include "report/site/page.hpp"

namespace oddity {

std::string exercise_page(const ExerciseResult& e) {
  const std::string number = to_string(e.number);
  return html::whole(
      {number + " " + e.title,
       "<h1>" + number + " " + html::escaped(e.title) + "</h1>\n<p>" + html::prose(e.asks) + "</p>\n",
       {"data/" + number + ".js"}});
}

}  // namespace oddity
