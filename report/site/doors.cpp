#include "report/site/doors.hpp"

#include <array>
#include <set>

#include "chapters/contents.hpp"
#include "report/site/lesson.hpp"
#include "report/site/moving_picture.hpp"
#include "report/site/page.hpp"
#include "report/study/findings.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

/// The result for a whole solution.
struct TileClass {
  std::string_view kind, words;
};
constexpr TileClass tile_wrong{"wrong", "wrong"}, tile_incomplete{"incomplete", "incomplete"},
    tile_misprint{"misprint", "misprints only"}, tile_unsettled{"unsettled", "unsettled"},
    tile_right{"right", "nothing wrong"};
constexpr std::array tile_classes{tile_right, tile_misprint, tile_incomplete, tile_wrong, tile_unsettled};

/// The worst of its claims decides. Losses in our copy are no fault of the book.
TileClass tile_of(const ExerciseResult& e) {
  const Counts counts = counts_of(e);
  if (counts.contains(Verdict::wrong)) return tile_wrong;
  if (counts.contains(Verdict::incomplete)) return tile_incomplete;
  if (counts.contains(Verdict::unsettled) || !e.failure.empty()) return tile_unsettled;
  return counts.contains(Verdict::misprint) ? tile_misprint : tile_right;
}

std::string tile(const ExerciseResult& e) {
  const TileClass tile = tile_of(e);
  const std::string number = to_string(e.number);
  return element(
      "a",
      " class=\"tile " + std::string(tile.kind) + "\" href=\"" + number + ".html\" title=\"" +
          in_xml(e.title + ": " + std::string(tile.words)) + "\"",
      number + "<span class=\"unseen\"> " + in_xml(e.title + ", " + std::string(tile.words)) + "</span>");
}

std::string chapter_tiles(const Results& results, const Chapter& chapter) {
  std::string tiles;
  for (const ExerciseResult& e : results.exercises)
    if (e.number.chapter == chapter.number) tiles += tile(e);
  return tiles.empty() ? ""
                       : element("li", "",
                                 element("span", " class=\"chapter\"", in_xml(chapter.title)) +
                                     element("span", " class=\"standings\"", tiles)) +
                             "\n";
}

std::string tiles_legend(const Results& results) {
  std::string items;
  for (const TileClass& tile : tile_classes) {
    const auto count = std::ranges::count_if(
        results.exercises, [&](const ExerciseResult& e) { return tile_of(e).kind == tile.kind; });
    if (count > 0)
      items += element("li", " class=\"" + std::string(tile.kind) + "\"",
                       "<b>" + std::to_string(count) + "</b> " + std::string(tile.words));
  }
  return element("ul", " class=\"standings\"", items) + "\n";
}

/// The field needs scripts, which also make it visible.
std::string exercises_door(const Results& results) {
  std::string chapters_of_the_book;
  for (const Chapter& chapter : chapters()) chapters_of_the_book += chapter_tiles(results, chapter);
  return "<section class=\"door exercises\">\n<h2>Is my exercise right?</h2>\n<div class=\"ask\"></div>\n" +
         element("ul", " class=\"grid\"", chapters_of_the_book) + "\n" + tiles_legend(results) +
         "</section>\n";
}

std::string door(const std::string& to, const std::string& asks, const std::string& text) {
  return element("section", " class=\"door\"",
                 element("h2", "", html::link(to, asks)) + element("p", "", text)) +
         "\n";
}

std::string euler_door() {
  return door("lesson.html", "Why does Euler fail?",
              "A lesson in " + std::to_string(lesson_steps().size() + 1) +
                  " steps on a mass and a spring: drag it, change the step, and see where the energy goes.");
}

std::string use_door() {
  return door(
      "recipes.html", "What do I use?",
      "For each scene the model, the algorithm and the step that are enough for a game, and the cost of "
      "every other method. " +
          html::link("own.html", "Or type your own equations") + ".");
}

std::string picture_door(const Results& results) {
  const ExerciseResult* e = exercise_in_motion(results);
  if (!e) return "";
  return "<section class=\"door moving\">\n" + moving_picture(*e) + "<div>" +
         element("h2", "", html::link(to_string(e->number) + ".html", in_xml(e->title))) +
         element("p", "", "The motion in the manual, and the true one.") +
         "<p class=\"stop\"><button type=\"button\" hidden>Stop the pictures</button></p></div></section>\n";
}

}  // namespace

const ExerciseResult* exercise_in_motion(const Results& results) {
  for (const Finding& finding : errata_worst_first(results))
    if (!moving_picture(*finding.exercise).empty()) return finding.exercise;
  return nullptr;
}

std::string doors(const Results& results) {
  return "<div class=\"doors\">\n" + exercises_door(results) + picture_door(results) + euler_door() +
         use_door() + "</div>\n";
}

}  // namespace oddity
