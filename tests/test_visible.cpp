#include <sstream>

#include "report/text/visible.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"

using namespace oddity;
using namespace program;

TEST_CASE("control characters are escaped, and letters and colours are not", "[visible]") {
  CHECK(visible("a\x1b]52;c;AAAA\x07z") == "a\\x1b]52;c;AAAA\\x07z");
  CHECK(visible("one\r\ttwo\n") == "one\\x0d\ttwo\n");
  CHECK(visible("\x1b[31mred\x1b[0m\x7f\b") == "\\x1b[31mred\\x1b[0m\\x7f\\x08");
  CHECK(visible("µ° 5×10⁻¹ 𝜋") == "µ° 5×10⁻¹ 𝜋");
  CHECK(visible("\xc2\x9b"
                "31m \xff \xc3 \xc0\xaf \xe2\x82") == "\\xc2\\x9b31m \\xff \\xc3 \\xc0\\xaf \\xe2\\x82");
  CHECK(visible(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(visible("a\u202eb\u2066c\u200fd") == "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6c\\xe2\\x80\\x8fd");
  CHECK(visible("a\u061cb\u2013c\u2060d") == "a\\xd8\\x9cb\u2013c\u2060d");
  std::ostringstream stream;
  {
    const VisibleOutput output(stream, true);
    stream << '\x1b' << "[0;31mred\x1b[0m \x1b]0;title\x07 \x1b[2J\x1b[8m " << '\xc2' << '\xb5' << "\n\r";
    CHECK(stream.good());
  }
  CHECK(stream.str() == "\x1b[0;31mred\x1b[0m \\x1b]0;title\\x07 \\x1b[2J\\x1b[8m \xc2\xb5\n\\x0d");
  stream << "\r";
  CHECK(stream.str().ends_with("\r"));
  stream.str("");
  {
    const VisibleOutput output(stream, false, "\r");
    stream << "\r\x1b[31mred";
  }
  CHECK(stream.str() == "\r\\x1b[31mred");
}

TEST_CASE("no argument and no file sends control characters to the terminal", "[visible]") {
  const std::string bell = "\x1b]52;c;AAAA\x07", shown = "\\x1b]52;c;AAAA\\x07";
  for (const std::string& asked :
       {"solve '3.5" + bell + "'", "choose 3.5 'a=" + bell + "' --error 1deg", "verify '[" + bell + "]'",
        "sweep status '" + bell + "'", "'" + bell + "'", "list --reference '" + bell + "'",
        "chart 3.5 --out '/proc/" + bell + "'", "verify --from '" + bell + "' '[3.5]'"}) {
    const Ran ran = run(asked);
    INFO(asked << "\n" << ran.output);
    CHECK(ran.status == 2);
    CHECK_FALSE(says(ran, "\x1b]"));
    CHECK_FALSE(says(ran, "\x07"));
  }
  CHECK(says(run("sweep status '" + bell + "'"), shown));
}
