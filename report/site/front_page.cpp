#include "report/site/front_page.hpp"

#include "report/site/page.hpp"

namespace oddity {

std::string front_page(const Results& results) {
  std::string body = "<h1>oddity</h1>\n<ul>\n";
  for (const ExerciseResult& e : results.exercises)
    body += "<li><a href=\"" + to_string(e.number) + ".html\">" + to_string(e.number) + " " +
            html::escaped(e.title) + "</a></li>\n";
  return html::whole({"oddity", body + "</ul>\n"});
}

}  // namespace oddity
