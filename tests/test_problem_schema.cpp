// The schema of problems' files: all examples conform to it, and the reader refuses everything that it
// refuses.

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#define TOML_ENABLE_FORMATTERS 1
#include <toml++/toml.h>

#include "problem/keys.hpp"
#include "problem/scene.hpp"
#include "problem/template.hpp"
#include "report/cli/new_exercise.hpp"
#include "report/cli/schema.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using Json = nlohmann::json;

namespace {

Json json_of(const std::string& text) {
  std::ostringstream out;
  out << toml::json_formatter(toml::parse(std::string_view(text)));
  return Json::parse(out.str());
}

/// Whether the value conforms to the schema, for the keywords that ours uses.
bool is_of(const Json& value, const Json& schema, const Json& whole) {
  if (schema.contains("$ref")) {
    const std::string name = schema["$ref"].get<std::string>().substr(8);
    return is_of(value, whole["$defs"].at(name), whole);
  }
  if (schema.contains("anyOf"))
    return std::ranges::any_of(schema["anyOf"], [&](const Json& one) { return is_of(value, one, whole); });
  const Json types = schema.at("type").is_array() ? schema["type"] : Json::array({schema["type"]});
  const auto is = [&](const Json& type) {
    return type == "string"    ? value.is_string()
           : type == "number"  ? value.is_number()
           : type == "boolean" ? value.is_boolean()
           : type == "array"   ? value.is_array()
                               : value.is_object();
  };
  if (std::ranges::none_of(types, is)) return false;
  if (value.is_array())
    return value.size() >= schema.value("minItems", 0U) && value.size() <= schema.value("maxItems", 1000U) &&
           std::ranges::all_of(value, [&](const Json& one) { return is_of(one, schema["items"], whole); });
  if (!value.is_object()) return true;
  for (const Json& key : schema.value("required", Json::array()))
    if (!value.contains(key.get<std::string>())) return false;
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [key, its] : value.items()) {
    if (properties.contains(key)) {
      if (!is_of(its, properties[key], whole)) return false;
    } else if (const Json& other = schema["additionalProperties"]; other.is_boolean()) {
      if (!other.get<bool>()) return false;
    } else if (!is_of(its, other, whole)) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("Every problem's file in the tree conforms to the schema", "[problem][schema]") {
  const Json schema = Json::parse(schema_of_problems());
  std::vector<std::string> texts{std::string(problem::begun)};
  for (const EmbeddedFile& file : embedded_scenes()) texts.emplace_back(file.text);
  const auto folder = std::filesystem::path(ODDITY_SOURCE) / "chapters" / "examples" / "problems";
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".toml") texts.push_back(text_of(file.path()));
  CHECK(texts.size() > 25);
  for (const std::string& text : texts) {
    INFO(text.substr(0, 200));
    CHECK(is_of(json_of(text), schema, schema));
  }
}

TEST_CASE("The reader refuses files that do not conform to the schema", "[problem][schema]") {
  const Json schema = Json::parse(schema_of_problems());
  const std::string motion =
      "title = \"x\"\n[parameters]\nm = \"1 kg\"\n[model.a]\nequations = [\"m y'' = -1 N\"]\nstart = { y = \"1 m\", \"y'\" = 0 }\n[observe]\ny = \"m\"\n";
  CHECK(is_of(json_of(motion), schema, schema));
  const std::string turning =
      "title = \"x\"\n[parameters]\nw = \"1 1/s\"\n[given]\nW = [[0, \"-w\"], [\"w\", 0]]\n[model.a]\n"
      "equations = [\"R' = R W\"]\nstart = { R = [[1, 0], [0, 1]] }\n[observe]\nR = \"1\"\n[need]\nerror = \"0.01\"\n";
  CHECK(is_of(json_of(turning), schema, schema));
  CHECK(complaint([&] { problem::entry_of_text("t.toml", turning); }) == "nothing");
  for (const std::string wrong :
       {"[needs]\nerror = 1\n", "[need]\nerrors = 1\n", "[sweep]\nvalues = [1]\n",
        "[model.b]\nequation = \"y\"\n", "[[claim]]\nsays = \"a\"\n",
        "[[claim]]\nsays = \"a\"\nprinted = \"1 < 2\"\nproof = \"b\"\n",
        "[tables.f]\nx = \"m\"\ny = \"m\"\nrows = [[1, 2, 3]]\n", "[tables.f]\nx = \"m\"\nrows = [[1, 2]]\n",
        "[need]\nfps = [[1]]\n", "[given]\nW = [[[1, 0], 0], [0, 1]]\n",
        "[model.b]\nevents = [{ then = { y = 1 } }]\n"}) {
    INFO(wrong);
    CHECK_FALSE(is_of(json_of(motion + wrong), schema, schema));
    CHECK(complaint([&] { problem::entry_of_text("t.toml", motion + wrong); }).find("t.toml:") == 0);
  }
  // Every key of every table has a type from the schema.
  for (const auto& table : problem::all_keys())
    for (const problem::Key& key : table.keys) CHECK_FALSE(key.says.empty());
}

TEST_CASE("new --schema prints the schema", "[problem][schema][commands]") {
  const auto printed = program::printed("new --schema");
  CHECK(printed.status == 0);
  CHECK(printed.output == schema_of_problems());
  CHECK(program::run("new --schema mine.toml").status == 2);
  const auto nothing = program::run("new");
  CHECK(nothing.status == 2);
  CHECK(program::says(nothing, "new needs a number"));
}
