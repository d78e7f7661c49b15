// The linter of prose: which passages it reads, and the faults it finds in them.

#include "report/verify/catch.hpp"
#include "tests/prose/prose.hpp"

using namespace oddity;

namespace {

std::vector<std::string> texts_in(const char* file, const char* text) {
  std::vector<std::string> texts;
  for (const auto& passage : prose::passages_in(file, text)) texts.push_back(passage.text);
  return texts;
}

std::vector<std::string> kinds_in(const std::string& text) {
  static const auto rules = prose::rules_of(
      "relative: what -> name the thing\ngenitive: ^ of -> verb or noun first\n"
      "own: of its|their own -> its own\n");
  std::vector<std::string> kinds;
  for (const auto& fault : prose::faults_in({text, 1}, rules)) kinds.push_back(fault.kind);
  return kinds;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("the linter reads comments and long texts, not code", "[prose]") {
  CHECK(texts_in("a.cpp",
                 "/// One comment\n/// in two lines.\nint what = 1'000;  // behind code\n\n// another\n") ==
        Texts{"One comment in two lines.", "behind code", "another"});
  CHECK(texts_in("a.cpp", R"(f("short text", "the first half of it, "
 "and the second", 'x', "a \" quote that does not end it"); // after)") ==
        Texts{"the first half of it, and the second", "after", "a \\\" quote that does not end it"});
  CHECK(texts_in("a.cpp", "R\"x(a raw text with \" in it)x\" /* one */ /* two\n * three */") ==
        Texts{"one", "two three", "a raw text with \" in it"});
  CHECK(texts_in("a.md", "# Head\nOne\nparagraph.\n\n```\ncode\n```\n- item\n- item\n") ==
        Texts{"# Head", "One paragraph.", "- item", "- item"});
  CHECK(texts_in("a.sh", "#!/bin/sh\n# A comment\n# goes on\nrun  # behind code\n") ==
        Texts{"A comment goes on", "behind code"});
  CHECK(texts_in("a.cpp", R"(f("Lemma a : (f x = g x) -> (x = 0).");)").empty());
  CHECK(texts_in("a.bin", "# nothing").empty());
}

TEST_CASE("the linter finds words in a row, within a sentence, and long sentences", "[prose]") {
  CHECK(kinds_in("Of the next setting.") == Texts{"genitive"});
  CHECK(kinds_in("Cost. Of the next setting.").empty());
  CHECK(kinds_in("It prints what it has.") == Texts{"relative"});
  CHECK(kinds_in("Whatever it prints, `what` and $what$ are code. What is this?").empty());
  CHECK(kinds_in("A folder of its own, of Their own.") == Texts{"own", "own"});
  CHECK(kinds_in("A folder of its. Own").empty());
  std::string long_sentence;
  for (std::size_t i = 0; i < prose::longest_sentence; ++i) long_sentence += "word ";
  CHECK(kinds_in(long_sentence + ".").empty());
  CHECK(kinds_in(long_sentence + "more.") == Texts{"long"});
  CHECK(kinds_in(long_sentence + "\\nmore.").empty());
}

TEST_CASE("the linter skips links' addresses and ends of sentences", "[prose]") {
  CHECK(kinds_in("[rules](what-is-read.md) are short").empty());
  CHECK(kinds_in(" of the next setting, behind a number").empty());
}

TEST_CASE("places that stay have their file, kind and first words", "[prose]") {
  const auto accepted = prose::accepted_in("# a comment\na/b.cpp: say: says: x -> a column\n");
  REQUIRE(accepted.size() == 1);
  CHECK(accepted[0].file == "a/b.cpp");
  CHECK(accepted[0].kind == "say");
  CHECK(accepted[0].words == "says: x");
  CHECK(prose::accepted_in("a.md: long:  -> the rows of its tables\n")[0].words.empty());
  CHECK_THROWS_AS(prose::accepted_in("a/b.cpp: say: says"), std::invalid_argument);
}

TEST_CASE("the linter refuses a line that is no rule", "[prose]") {
  CHECK_THROWS_AS(prose::rules_of("relative what"), std::invalid_argument);
}
