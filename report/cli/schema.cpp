#include "report/cli/schema.hpp"

#include <nlohmann/json.hpp>

#include "problem/keys.hpp"

namespace oddity {

namespace {

using Json = nlohmann::ordered_json;

Json type_of(std::string_view is) {
  const Json text = {{"type", {"string", "number"}}};
  if (const auto either = is.find(" or "); either != is.npos && !is.starts_with("map "))
    return {{"anyOf", {type_of(is.substr(0, either)), type_of(is.substr(either + 4))}}};
  if (is.starts_with("map ")) return {{"type", "object"}, {"additionalProperties", type_of(is.substr(4))}};
  if (is.starts_with("list ")) return {{"type", "array"}, {"items", type_of(is.substr(5))}};
  if (is == "text") return text;
  if (is == "texts") return {{"anyOf", {text, {{"type", "array"}, {"items", text}}}}};
  if (is == "components") return {{"anyOf", {text, {{"type", "array"}, {"items", type_of("texts")}}}}};
  if (is == "flag") return {{"type", "boolean"}};
  if (is == "number") return {{"type", "number"}};
  if (is == "rows") {
    const Json row = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
    return {{"anyOf", {{{"type", "string"}}, {{"type", "array"}, {"items", row}}}}};
  }
  return {{"$ref", "#/$defs/" + std::string(is)}};
}

Json table_of(const problem::KeysOf& table) {
  Json properties = Json::object(), needed = Json::array();
  for (const problem::Key& key : table.keys) {
    Json one = type_of(key.is);
    one["description"] = key.says;
    properties[std::string(key.name)] = one;
    if (key.needed) needed.push_back(key.name);
  }
  Json all = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!needed.empty()) all["required"] = needed;
  return all;
}

}  // namespace

std::string schema_of_problems() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "A problem of oddity, in TOML"}};
  const auto all = problem::all_keys();
  schema.update(table_of(all.front()));
  for (const problem::KeysOf& table : all.subspan(1))
    schema["$defs"][std::string(table.name)] = table_of(table);
  return schema.dump(2) + "\n";
}

}  // namespace oddity
