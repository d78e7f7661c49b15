#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "reference/bad_input.hpp"
#include "report/charts/chart.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/errata.hpp"
#include "report/site/evidence_pages.hpp"
#include "report/site/formulas.hpp"
#include "report/site/further_pages.hpp"
#include "report/site/lesson.hpp"
#include "report/site/page.hpp"
#include "report/site/script.hpp"
#include "report/site/single.hpp"
#include "report/site/site.hpp"
#include "report/study/embedded.hpp"
#include "report/study/settings.hpp"
#include "report/verify/catch.hpp"
#include "tests/hostile.hpp"
#include "tests/near.hpp"
#include "tests/packed.hpp"
#include "tests/properties.hpp"
#include "tests/sample_results.hpp"

using namespace oddity;
namespace fs = std::filesystem;
using hostile::Json;

namespace {

/// An opening tag of a page.
struct Tag {
  std::string name;
  std::map<std::string, std::string> attributes;
};

/// Children that elements of formulas need.
const std::map<std::string, int> children_needed{{"msub", 2},       {"msup", 2},  {"msubsup", 3},
                                                 {"mfrac", 2},      {"mover", 2}, {"munder", 2},
                                                 {"munderover", 3}, {"mroot", 2}};

/// A page's tags in order, and their faults: each opened tag must be closed, in order, with the children that
/// it needs, and attributes must be written name="value".
struct Parsed {
  std::vector<Tag> tags;
  std::vector<std::string> wrong;
};

Parsed parsed(const std::string& page) {
  static const std::set<std::string> empty{"meta", "link", "br", "input"};
  static const std::regex attribute(R"x(\s+([A-Za-z][-A-Za-z0-9]*)(="([^"<]*)")?)x");
  Parsed made;
  std::vector<std::string> open;
  std::vector<int> children{0};
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return made.wrong.push_back("an open end"), made;
    std::string inside = page.substr(at + 1, end - at - 1);
    at = end;
    if (inside.starts_with("!doctype")) continue;
    if (inside.starts_with('/')) {
      if (open.empty() || open.back() != inside.substr(1))
        made.wrong.push_back("</" + inside.substr(1) + "> too much");
      if (open.empty()) continue;
      if (const auto needed = children_needed.find(open.back());
          needed != children_needed.end() && needed->second != children.back())
        made.wrong.push_back("<" + open.back() + "> has " + std::to_string(children.back()) + " children");
      open.pop_back();
      children.pop_back();
      continue;
    }
    const bool closed = inside.ends_with('/');
    if (closed) inside.pop_back();
    Tag tag{inside.substr(0, inside.find_first_of(" \n")), {}};
    std::string rest = inside.substr(tag.name.size());
    for (std::smatch found; std::regex_search(rest, found, attribute, std::regex_constants::match_continuous);
         rest = found.suffix())
      tag.attributes[found[1]] = found[3];
    if (rest.find_first_not_of(' ') != std::string::npos)
      made.wrong.push_back("<" + tag.name + " " + rest + ">");
    ++children.back();
    if (!closed && !empty.contains(tag.name)) {
      open.push_back(tag.name);
      children.push_back(0);
    }
    if (tag.name == "style") at = page.find("</style", at);
    made.tags.push_back(std::move(tag));
  }
  for (const std::string& name : open) made.wrong.push_back("<" + name + "> is not closed");
  return made;
}

/// Contents that no page of ours may have: inline scripts, handlers, anything from elsewhere.
std::vector<std::string> foreign(const Parsed& page) {
  static const std::set<std::string> known{
      "html",    "head",    "meta",    "title",    "link",    "body",     "a",          "header",
      "nav",     "main",    "footer",  "section",  "article", "h1",       "h2",         "h3",
      "h4",      "p",       "ul",      "li",       "dl",      "dt",       "dd",         "div",
      "span",    "b",       "em",      "strong",   "small",   "code",     "cite",       "var",
      "table",   "caption", "thead",   "tbody",    "tr",      "th",       "td",         "figure",
      "button",  "details", "summary", "script",   "style",   "noscript", "svg",        "g",
      "circle",  "path",    "text",    "tspan",    "animate", "polygon",  "polyline",   "figcaption",
      "math",    "mi",      "mo",      "mn",       "mtext",   "mrow",     "msub",       "msup",
      "msubsup", "mfrac",   "msqrt",   "mroot",    "mover",   "munder",   "munderover", "mtable",
      "mtr",     "mtd",     "mspace",  "menclose", "mpadded", "merror",   "mstyle",     "mphantom",
      "i",       "rect",    "ol",      "pre"};
  std::vector<std::string> all;
  for (const Tag& tag : page.tags) {
    if (!known.contains(tag.name)) all.push_back("<" + tag.name + ">");
    for (const auto& [name, value] : tag.attributes) {
      if (name.starts_with("on")) all.push_back(tag.name + " " + name);
      const bool leads = name == "href" || name == "src" || name == "action" || name == "data";
      if (leads && (value.find(':') != std::string::npos || value.starts_with("//")) && value != "data:,")
        all.push_back(tag.name + " " + name + "=" + value);
    }
    if (tag.name == "script" && !tag.attributes.contains("src")) all.push_back("a script in the page");
  }
  return all;
}

std::vector<std::string> ids(const Parsed& page) {
  std::vector<std::string> all;
  for (const Tag& tag : page.tags)
    if (const auto id = tag.attributes.find("id"); id != tag.attributes.end()) all.push_back(id->second);
  return all;
}

/// A page without the code listings.
std::string without_listings(std::string page) {
  for (auto at = page.find("<pre"); at != std::string::npos; at = page.find("<pre", at))
    page.erase(at, page.find("</pre>", at) - at);
  return page;
}

/// The id in an address; an & starts the state of a player.
std::string id_of(const std::string& address) {
  const std::string after = address.substr(address.find('#') + 1);
  return after.substr(0, after.find('&'));
}

/// Links of a site's pages with a missing target.
std::vector<std::string> dead_links(const std::map<std::string, Parsed>& pages,
                                    const std::set<std::string>& files) {
  std::vector<std::string> dead;
  for (const auto& [name, page] : pages)
    for (const Tag& tag : page.tags)
      for (const char* attribute : {"href", "src"}) {
        const auto found = tag.attributes.find(attribute);
        if (found == tag.attributes.end() || found->second == "data:,") continue;
        const std::string& to = found->second;
        const std::string file = to.starts_with('#') ? name : to.substr(0, to.find('#'));
        const bool anchored = to.find('#') != std::string::npos;
        const auto target = pages.find(file);
        const bool there = files.contains(file) || target != pages.end();
        const bool known =
            !anchored || (target != pages.end() && std::ranges::count(ids(target->second), id_of(to)) == 1);
        if (!there || !known) dead.push_back(name + ": " + to);
      }
  return dead;
}

/// Headings begin with one h1, and none is more than one level deeper than the previous one.
bool headings_in_order(const Parsed& page) {
  int last = 0, first = 0;
  for (const Tag& tag : page.tags) {
    if (tag.name.size() != 2 || tag.name[0] != 'h' || tag.name[1] < '1' || tag.name[1] > '6') continue;
    const int level = tag.name[1] - '0';
    first += level == 1;
    if (level > last + 1) return false;
    last = level;
  }
  return first == 1;
}

std::map<std::string, Parsed> parsed(const std::map<std::string, std::string>& pages) {
  std::map<std::string, Parsed> all;
  for (const auto& [name, text] : pages) all.emplace(name, parsed(text));
  return all;
}

void check_pages(const std::map<std::string, std::string>& pages, std::set<std::string> files) {
  files.insert({"assets/models.js", "assets/own.js", "data/scenes.js", "data/problems.js"});
  for (const EmbeddedFile& asset : embedded_assets()) files.insert("assets/" + std::string(asset.path));
  const auto all = parsed(pages);
  for (const auto& [name, page] : all) {
    INFO(name);
    CHECK(page.wrong == std::vector<std::string>());
    CHECK(foreign(page) == std::vector<std::string>());
    CHECK(headings_in_order(page));
    auto names = ids(page);
    std::ranges::sort(names);
    CHECK(std::ranges::adjacent_find(names) == names.end());
    CHECK(std::ranges::none_of(pages.at(name), [](unsigned char c) { return c < 0x20 && c != '\n'; }));
  }
  CHECK(dead_links(all, files) == std::vector<std::string>());
}

const std::set<std::string> files_of_sample{"errata.json",    "errata.schema.json",    "data/3.5.js",
                                            "data/search.js", "data/bouncing_ball.js", "assets/drawing.css"};

/// Violations of a schema in a JSON text, for: required, type, enum, pattern, minimum, minLength, properties,
/// items.
void against(const Json& schema, const Json& value, const std::string& at, std::vector<std::string>& wrong) {
  const auto is = [&](const std::string& type) {
    return type == "object"    ? value.is_object()
           : type == "array"   ? value.is_array()
           : type == "string"  ? value.is_string()
           : type == "integer" ? value.is_number_integer()
           : type == "number"  ? value.is_number()
                               : value.is_null();
  };
  if (schema.contains("type")) {
    const Json& type = schema["type"];
    const bool fits = type.is_string() ? is(type) : std::ranges::any_of(type, [&](const Json& one) {
      return is(one.get<std::string>());
    });
    if (!fits) return wrong.push_back(at + " is no " + type.dump());
  }
  if (schema.contains("enum") && std::ranges::find(schema["enum"], value) == schema["enum"].end())
    wrong.push_back(at + " is " + value.dump());
  if (schema.contains("pattern") &&
      !std::regex_search(value.get<std::string>(), std::regex(schema["pattern"].get<std::string>())))
    wrong.push_back(at + " is " + value.dump());
  if (schema.contains("minLength") &&
      value.get<std::string>().size() < schema["minLength"].get<std::size_t>())
    wrong.push_back(at + " is empty");
  if (schema.contains("minimum") && value.get<double>() < schema["minimum"].get<double>())
    wrong.push_back(at + " is too small");
  if (value.is_object()) {
    for (const Json& name : schema.value("required", Json::array()))
      if (!value.contains(name.get<std::string>())) wrong.push_back(at + " lacks " + name.dump());
    for (const auto& [name, part] : value.items())
      if (schema["properties"].contains(name))
        against(schema["properties"][name], part, at + "/" + name, wrong);
      else
        wrong.push_back(at + " has " + name);
  }
  if (value.is_array() && schema.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i)
      against(schema["items"], value[i], at + "/" + std::to_string(i), wrong);
}

std::vector<std::string> against_schema(const Json& value) {
  std::vector<std::string> wrong;
  against(Json::parse(errata_schema()), value, "", wrong);
  return wrong;
}

/// The sample, with a misprint and an erratum that has a root.
Results sample_with_findings() {
  Results results = sample();
  ExerciseResult& e = results.exercises[0];
  e.roots = {{"a root", "It shows by 2 m."}};
  Claim wrong{.id = "3.5-w", .line = 4, .says = "z is $\\frac12$"};
  wrong.printed = {"$\\frac12$", {{"z", {"a", 0.5}, {"b", 2}, exact(), 1, "a place"}}};
  wrong.corrected = {"$2$", {one_against_one(0)}};
  wrong.why = "It is *two*.";
  wrong.kind = Fault::formula;
  wrong.root = "a root";
  Claim misprint = wrong;
  misprint.id = "3.5-m";
  std::swap(misprint.meant, misprint.corrected);
  misprint.kind = Fault::formula;
  misprint.root = "";
  e.claims[1].claim.id = "3.5-y";
  e.claims.push_back({wrong, verdict(wrong)});
  e.claims.push_back({misprint, verdict(misprint)});
  return results;
}

}  // namespace

TEST_CASE("the site's pages are complete, and all their links lead somewhere", "[site]") {
  check_pages(site_pages(sample_with_findings()), files_of_sample);
}

TEST_CASE("a copy of the site lists its missing parts, and does not claim to have them", "[site]") {
  const Results results = sample_with_findings();
  const auto whole = site_pages(results, {}, {true}), bare = site_pages(results, {}, {false});
  check_pages(bare, files_of_sample);
  for (const auto& [name, page] : bare) {
    INFO(name);
    for (const char* part :
         {"lacks the compiled models",
          "apt-get install clang lld libc++-dev-wasm32 libclang-rt-dev-wasm32 &amp;&amp; ./oddity site"})
      CHECK(page.find(part) != std::string::npos);
    CHECK(whole.at(name).find("class=\"lacks\"") == std::string::npos);
  }
  for (const char* claim : {"run by the very C++ that was tested", "computed in this page"}) {
    INFO(claim);
    const auto claims = [&](const auto& pages) {
      return std::ranges::count_if(
          pages, [&](const auto& page) { return page.second.find(claim) != std::string::npos; });
    };
    CHECK(claims(whole) == 1);
    CHECK(claims(bare) == 0);
  }
}

TEST_CASE("every page runs only its own files, and has no inline code", "[site]") {
  static const std::regex within("<script(?![^>]* src=)|<style|\\sstyle=|\\son[a-z]+=");
  for (const auto& [name, page] : site_pages(sample_with_findings())) {
    INFO(name);
    CHECK(page.find(
              "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self' "
              "'wasm-unsafe-eval'; style-src 'self'; ") != std::string::npos);
    CHECK_FALSE(std::regex_search(page, within));
  }
}

TEST_CASE("the page of engines has each engine's error with its coarsest steps, and the sufficient steps",
          "[site]") {
  EngineContest contest{"3.5", "Pendulum", {"m"}, {0.01}, 10, 60, {}};
  EngineSeries moves, stands;
  moves.engine = "Some", stands.engine = "Other";
  moves.trials.resize(2);
  moves.trials[0].steps_per_frame = 2, moves.trials[0].outcome = Outcome::inaccurate;
  moves.trials[1].steps_per_frame = 4;
  moves.trials[0].in_needs = 3.5, moves.trials[1].in_needs = 0.5;
  stands.cannot = "it has no joints";
  contest.series = {moves, stands};
  const std::string page = engines_html(sample(), std::span(&contest, 1));
  for (const char* part : {"Needed: 0.01 m.", "3.5</td><td class=\"n\">120</td><td class=\"n\">240 Hz",
                           "cannot: it has no joints", "<a href=\"3.5.html#recipe\">"}) {
    INFO(page);
    CHECK(page.find(part) != std::string::npos);
  }
  CHECK(engines_html(sample(), {}).find("No engine has run for this copy") != std::string::npos);
}

TEST_CASE("a page as one file contains all its code, and leads nowhere else", "[site]") {
  std::set<std::string> taken;
  const std::string page =
      in_one_file(site_pages(sample_with_findings()).at("3.5.html"), [&](const std::string& file) {
        taken.insert(file);
        return "/* " + file + " */\n";
      });
  static const std::regex elsewhere("<link rel=\"stylesheet|<script[^>]* src=|<a [^>]*href=\"(?!#|http)");
  CHECK_FALSE(std::regex_search(page, elsewhere));
  static const std::regex nonces(
      "script-src 'nonce-([0-9a-f]{16})' 'wasm-unsafe-eval'; style-src 'nonce-([0-9a-f]{16})'");
  std::smatch nonce;
  REQUIRE(std::regex_search(page, nonce, nonces));
  CHECK(nonce.str(1) == nonce.str(2));
  for (const char* file :
       {"assets/page.js", "assets/engine.js", "assets/models.js", "assets/drawing.css", "data/3.5.js"}) {
    INFO(file);
    CHECK(taken.contains(file));
    const std::string element = std::string(file).ends_with(".css") ? "style" : "script";
    CHECK(page.find("<" + element + " nonce=\"" + nonce.str(1) + "\">\n/* " + file + " */\n</" + element +
                    ">") != std::string::npos);
  }
  CHECK_FALSE(taken.contains("assets/search.js"));
  CHECK_THROWS_AS(in_one_file(page, {}), std::logic_error);  // it is one file already
}

TEST_CASE("the site of the last run is complete, typeset and small", "[site]") {
  const fs::path file = results_file();
  if (!fs::exists(file)) {
    WARN("there is no last run: " << file.string());
    return;
  }
  Results results;
  try {
    results = read_results(file);
  } catch (const BadInput& error) {  // results of this version must be readable
    if (std::string(error.what()).find("another") == std::string::npos) throw;
    WARN(error.what());
    return;
  }
  if (std::ranges::any_of(results.exercises,
                          [](const ExerciseResult& e) { return e.scene && !e.cheapest_models; })) {
    WARN("the last run was the suite's, which makes no cheapest models as the site does: " << file.string());
    return;
  }
  const auto pages = site_pages(results);
  std::set<std::string> files{"errata.json", "errata.schema.json", "data/search.js", "data/bouncing_ball.js",
                              "assets/drawing.css"};
  for (const ExerciseResult& e : results.exercises) files.insert("data/" + to_string(e.number) + ".js");
  check_pages(pages, files);
  std::size_t size = 0;
  static const std::regex code("<code>[^<]{0,400}</code>");
  for (const auto& [name, page] : pages) {
    INFO(name);
    size += page.size();
    CHECK(parsed(page).wrong == std::vector<std::string>());
    CHECK(page.find("class=\"tex\"") == std::string::npos);
    const std::string told = std::regex_replace(without_listings(page), code, "");
    CHECK(told.find('\\') == std::string::npos);
    CHECK(told.find("..</p>") == std::string::npos);
    if (const auto at = page.find("<pre class=\"code\""); at != std::string::npos)
      CHECK(page.substr(at, page.find("</pre>", at) - at).find("\nint main() {\n") != std::string::npos);
  }
  for (const ExerciseResult& e : results.exercises) {
    if (!e.cheapest_models) continue;
    const auto& faulted = properties::entry_of(to_string(e.number)).exercise.scene->faulted;
    for (const CheapestModel& one : e.cheapest_models->least)
      if (one.least) CHECK(std::ranges::find(faulted, one.least->model) == faulted.end());
  }
  CHECK(size < 3'000'000);  // half of the whole site's 6 MB: modules, fonts and scripts take 2.3 MB
  CHECK(against_schema(Json::parse(errata_json(results))) == std::vector<std::string>());
  CHECK(argument("index", search_index(results)).dump().find("\ufffd") ==
        std::string::npos);  // no letter is cut in two
}

TEST_CASE("a parser of pages notices faults", "[site]") {
  CHECK(parsed("<p>a<b>c</b></p>").wrong.empty());
  CHECK(parsed("<p>a<b>c</p></b>").wrong.size() == 2);
  CHECK(parsed("<p>").wrong.size() == 1);
  CHECK(parsed("<msup><mi>m</mi><mn>2</mn></msup>").wrong.empty());
  CHECK(parsed("<msup><mn>2</mn></msup>").wrong.size() == 1);
  CHECK(parsed("<p a=b></p>").wrong.size() == 1);
  CHECK(foreign(parsed("<script>1</script>")).size() == 1);
  CHECK(foreign(parsed("<a href=\"javascript:1\">x</a>")).size() == 1);
  CHECK(foreign(parsed("<p onclick=\"x\">a</p>")).size() == 1);
  CHECK_FALSE(headings_in_order(parsed("<h1>a</h1><h3>b</h3>")));
  CHECK(dead_links({{"a.html", parsed("<a href=\"#x\">a</a><a href=\"b.html\">b</a>")}}, {}).size() == 2);
}

TEST_CASE("the lesson's methods change the energy as its text claims", "[site]") {
  const double w = 2;
  const auto factors = [](const std::string& algorithm, double step) {
    const auto motion = lesson_motion(algorithm, step, 8);
    std::vector<double> all;
    for (std::size_t k = 1; k < motion.size(); ++k)
      all.push_back(lesson_energy(motion[k]) / lesson_energy(motion[k - 1]));
    return all;
  };
  for (const double h : {0.0625, 0.25, 0.75}) {
    const double y2 = h * h * w * w;
    for (const double factor : factors("explicit Euler", h)) CHECK(near(factor, 1 + y2, 1e-13));
    for (const double factor : factors("Runge-Kutta 4", h))
      CHECK(near(factor, 1 - y2 * y2 * y2 / 72 + y2 * y2 * y2 * y2 / 576, 1e-13));
    for (const std::string algorithm : {"symplectic Euler", "velocity Verlet"}) {
      const auto motion = lesson_motion(algorithm, h, 200);
      double most = 0, wobble = 0;
      for (const PlaceAndVelocity& s : motion) {
        most = std::max(
            most, std::abs(shadow_energy(algorithm, h, s) / shadow_energy(algorithm, h, motion.front()) - 1));
        wobble = std::max(wobble, std::abs(lesson_energy(s) / lesson_energy(motion.front()) - 1));
      }
      INFO(algorithm << " at " << h);
      CHECK(most < 1e-12);
      CHECK(wobble > 1e-4);  // the energy itself is not kept
    }
  }
  const auto ends = [](const std::string& algorithm, double h) {
    return lesson_energy(lesson_motion(algorithm, h, 20).back()) /
           lesson_energy(lesson_motion(algorithm, h, 0).back());
  };
  CHECK(ends("Runge-Kutta 4", 1.41) < 1);  // h w just below and above the root of 8
  CHECK(ends("Runge-Kutta 4", 1.42) > 1);
  CHECK(ends("symplectic Euler", 0.99) < 300);  // h w just below and above 2
  CHECK(ends("symplectic Euler", 1.01) > 1e3);
  for (const LessonStep& told : lesson_steps()) {
    INFO(told.name);
    CHECK(lesson_motion(told.algorithm, told.step, 4).size() == 5);
  }
}

TEST_CASE("a finding is shown with its root, the printed and the right formula", "[site]") {
  const Results results = sample_with_findings();
  const std::string page = findings_section(results.exercises[0]);
  for (const char* part :
       {"A root", "It shows by 2 m.", "id=\"3.5-w\"", "id=\"3.5-m\"", "printed", "meant", "<em>two</em>"})
    CHECK(page.find(part) != std::string::npos);
  CHECK(claims_section(results.exercises[0]).find("id=\"9.9-x\"") != std::string::npos);
}

TEST_CASE("the printed and the right value are shown at one sample", "[site]") {
  Results results = sample_with_findings();
  Claim& claim = results.exercises[0].claims.back().claim;
  claim.printed.checks = {{"z", {"a", 3}, {"b", 2}, {0.5, ""}, 1, "worst of 200: x=1"}};
  claim.meant.checks = {{"z", {"a", 17}, {"b", 17}, {0.5, ""}, 1, "worst of 200: x=9"}};
  const std::string page = findings_section(results.exercises[0]);
  CHECK(page.find(
            "<b>3</b> against <b>2</b>, b: off by 1, allowed 0.5, the most, in all 200 samples, at x=1.") !=
        std::string::npos);
  CHECK(page.find("Meant: <b>2</b> there: equal, in all 200 samples.") != std::string::npos);
  CHECK(page.find("17") == std::string::npos);
}

TEST_CASE("formulas are MathML", "[site]") {
  CHECK(html::text("so $\\frac{a}{b}<c$ and `x` $\\mathbf v$") ==
        "so <math><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>&lt;</mo><mi>c</mi></math> and <code>x</code> "
        "<math><mi>\U0001D42F</mi></math>");
  CHECK(html::text("$a=-b$, $2\\cos x$") ==
        "<math><mi>a</mi><mo>=</mo><mo form=\"prefix\">−</mo><mi>b</mi></math>, "
        "<math><mn>2</mn><mi>\u2009cos\u2009</mi><mi>x</mi></math>");
}

TEST_CASE("text that is no formula stays as TeX", "[site]") {
  CHECK(html::text("$\\nonsense{x}$") == "<code class=\"tex\">\\nonsense{x}</code>");
  CHECK(html::text("$a\x03<script>$") == "<code class=\"tex\">a &lt;script&gt;</code>");
  CHECK(html::text("a\x02"
                   "b\x03"
                   "c") == "a b c");
  CHECK(html::text("5 $ and `x") == "5 $ and `x");
  CHECK(html::text("*a* & $$") == "*a* &amp; $$");
  CHECK(html::prose("*a `b*` c*") == "<em>a `b</em>` c*");
}

TEST_CASE("two formulas are shown with their differences marked, and prose is not", "[site]") {
  const auto [printed, right] = html::texts_that_differ("$a-2b$", "$a+2c$");
  CHECK(printed ==
        "<math><mi>a</mi><mrow class=\"differs\"><mo>−</mo></mrow><mn>2</mn>"
        "<mrow class=\"differs\"><mi>b</mi></mrow></math>");
  CHECK(right ==
        "<math><mi>a</mi><mrow class=\"differs\"><mo>+</mo></mrow><mn>2</mn>"
        "<mrow class=\"differs\"><mi>c</mi></mrow></math>");
  CHECK(html::texts_that_differ("half of $a$", "$a$").first == html::text("half of $a$"));
  CHECK(html::texts_that_differ("$a$", "$a$").first == html::text("$a$"));
  CHECK(html::texts_that_differ("$\\nonsense$", "$a$").second == html::text("$a$"));
}

TEST_CASE("the contents of a script do not end it", "[site]") {
  const nlohmann::ordered_json text = {"</script><!--", "\u2028\u2029", std::string(100'000, '<')};
  const std::string script = packed_call("say", text);
  CHECK(argument("say", script) == nlohmann::json(text));
  CHECK(script.size() < 1000);
  CHECK(script == packed_call("say", text));
}

TEST_CASE("the errata conform to their schema and are complete", "[site]") {
  const Results results = sample_with_findings();
  Json list = Json::parse(errata_json(results));
  CHECK(against_schema(list) == std::vector<std::string>());
  std::set<std::string> there, expected;
  for (const Json& entry : list["errata"]) there.insert(entry["id"].get<std::string>());
  for (const JudgedClaim& c : results.exercises[0].claims)
    if (is_erratum(c.verdict) || c.verdict == Verdict::misprint) expected.insert(c.claim.id);
  CHECK(expected == std::set<std::string>{"3.5-m", "3.5-w", "3.5-y"});
  CHECK(there == expected);
  const Json& w =
      *std::ranges::find(list["errata"], "3.5-w", [](const Json& e) { return e["id"].get<std::string>(); });
  CHECK(w["consequence"] == "It shows by 2 m.");
  CHECK(w["right"] == "$2$");
  CHECK(w["margin"] == Json({{"differs_by", 1.5}, {"allowed", 0.0}}));
  CHECK(w["command"] == "oddity verify '[3.5]'");
  const std::string sheet = errata_page(results);
  for (const char* part : {"3.5.html#3.5-w", "3.5.html#3.5-m", "class=\"misprint\""})
    CHECK(sheet.find(part) != std::string::npos);

  list["errata"][0]["kind"] = "other";
  list["errata"][0].erase("why");
  list["errata"][0]["id"] = "x";
  list["errata"][0]["line"] = "5";
  list["errata"][0]["more"] = 1;
  CHECK(against_schema(list).size() == 5);
}

TEST_CASE("no string of a results file breaks out of the site's pages", "[site]") {
  Results charted = sample_with_findings();
  QuantityResult& quantity = charted.exercises[0].quantities[0];
  auto& trials = quantity.methods[0].trials;
  for (double error : {0.1, 0.01, 0.001}) {
    trials.push_back(trials.front());
    trials.back().error = trials.back().final_error = error;
    trials.back().value = Value{1, 2 + error};
  }
  REQUIRE(has_chart(quantity));
  const Json whole = Json::parse(to_json(charted));
  auto by_key = hostile::by_key(hostile::strings_of(whole));
  by_key.erase("id");  // two equal ones are refused
  const auto check = [](const Json& json) {
    const Results results = results_from_json(json.dump(), "here");
    check_pages(site_pages(results), files_of_sample);
    const std::string script = search_index(results);
    CHECK(argument("index", script).is_array());
    CHECK(Json::parse(errata_json(results)).contains("errata"));
  };
  for (const std::string text :
       {"</script><script>alert(1)</script><!-- \"' onload=x ` * \u2028\x01\x02\x03]]>", "`</code><script>`",
        "$</math><script>alert(1)$", "*<b onclick=x>*", "\" onclick=\"x", "\\", "$", ""}) {
    int taken = 0;
    Json all = whole;
    for (const auto& [key, same] : by_key) {
      try {
        results_from_json(hostile::spoilt(whole, same, text).dump(), "here");
      } catch (const BadInput&) {
        continue;
      }
      ++taken;
      all = hostile::spoilt(all, same, text);
    }
    INFO(text);
    CHECK(taken > 15);
    check(all);
  }
}
