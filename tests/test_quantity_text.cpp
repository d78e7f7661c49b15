#include <array>
#include <numbers>
#include <random>

#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"
#include "report/study/limit_records.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"

using namespace oddity;

TEST_CASE("a number may have a unit", "[reference]") {
  CHECK(in_unit("0.5", "m") == 0.5);
  CHECK(in_unit("50cm", "m") == 0.5);
  CHECK(in_unit("+50 cm", "m") == 0.5);
  CHECK(in_unit("30deg", "rad") == std::numbers::pi / 6);
  CHECK(in_unit("30°", "rad") == std::numbers::pi / 6);
  CHECK(in_unit("250 mrad", "rad") == 0.25);
  for (const char* micro : {"5us", "5µs", "5μs", "5e3 ns"}) CHECK(in_unit(micro, "s") == 5e-6);
  CHECK(in_unit("1h", "s") == 3600);
  CHECK(in_unit("2min", "s") == 120);
  CHECK(in_unit("1yr", "s") == 31557600);
  CHECK(in_unit("365.25d", "yr") == 1);
  CHECK(in_unit("149597870700m", "AU") == 1);
  CHECK(in_unit("60Hz", "1/s") == 60);
  CHECK(in_unit("60/s", "1/s") == 60);
  CHECK(in_unit("36km/h", "m/s") == 10);
  CHECK(in_unit("981cm/s^2", "m/s^2") == 9.81);
  CHECK(in_unit("9.81m/s2", "m/s^2") == 9.81);
  CHECK(in_unit("9.81 m/s²", "m/s^2") == 9.81);
  CHECK(in_unit("60rpm", "rad/s") == 2 * std::numbers::pi);
  CHECK(in_unit("5N/cm", "N/m") == 500);
  CHECK(in_unit("2 kg/s", "N s/m") == 2);
  CHECK(in_unit("2 kg m^2", "kg m^2") == 2);
  CHECK(in_unit("500 g*m^2", "kg m^2") == 0.5);
  CHECK(in_unit("39.5 AU^3/(yr^2 solar mass)", "AU^3/(yr^2 solar mass)") == 39.5);
  CHECK(in_unit("1 kg^-1 m^3 s^-2", "m^3/(kg s^2)") == 1);
  CHECK(in_unit("3", "") == 3);
  CHECK(in_unit("3", "1") == 3);
}

TEST_CASE("a unit that does not fit is refused with those that do", "[reference]") {
  const auto refused = [](const char* text, const char* unit) {
    return complaint([&] { in_unit(text, unit); });
  };
  CHECK(refused("30kg", "rad") == "'30kg' has a unit that does not fit; units that fit: rad, mrad, deg");
  CHECK(refused("1cm", "s") ==
        "'1cm' has a unit that does not fit; units that fit: s, ms, us, ns, min, h, d, yr");
  CHECK(refused("3m", "") == "'3m' has a unit that does not fit: this one has no unit");
  CHECK(refused("x", "m") == "'x' is not a number");
  CHECK(refused("", "m") == "'' is not a number");
  for (const char* wrong :
       {"1 foot", "0,5", "1m^", "1m/", "1 m)", "1 (m", "1e", "0x10", "5US", "1m^99", "1 m!", "1\nm"})
    CHECK(refused(wrong, "m").find("is not a number, nor one with a unit; units that fit: m, cm") !=
          std::string::npos);
  CHECK(refused("1e999", "m") == "'1e999' is outside the range of numbers");
}

TEST_CASE("comparing two words for similarity does not count all their errors", "[reference]") {
  std::mt19937 random(5);
  const auto word = [&] {
    std::string letters(random() % 9, 'a');
    for (char& c : letters) c = static_cast<char>("abcA"[random() % 4]);
    return letters;
  };
  for (int i = 0; i < 20000; ++i) {
    const std::string a = word(), b = word();
    const int most = static_cast<int>(random() % 6);
    CAPTURE(a, b, most);
    REQUIRE(nearly_same(a, b, most) == (typing_errors(a, b) <= most));
  }
}

TEST_CASE("the closest name is found by the fewest typing errors", "[reference]") {
  CHECK(typing_errors("solve", "sovle") == 1);
  CHECK(typing_errors("abc", "ABC") == 0);
  CHECK(typing_errors("", "abc") == 3);
  CHECK(nearly_same("abc", "abcd", 1));
  CHECK(!nearly_same("abc", "abcd", 0));
  CHECK(!nearly_same("abc", "axyd", 2));
  const std::array<std::string, 4> verbs{"solve", "list", "chart", "choose"};
  CHECK(did_you_mean("sovle", verbs) == "; did you mean 'solve'?");
  CHECK(did_you_mean("CHART", verbs) == "; did you mean 'chart'?");
  CHECK(did_you_mean("frobnicate", verbs).empty());
  CHECK(did_you_mean("x", verbs).empty());
}
