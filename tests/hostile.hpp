#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// The strings of a JSON text by their places, and functions that replace them.
namespace hostile {

using Json = nlohmann::ordered_json;
using Places = std::vector<Json::json_pointer>;

inline void collect(const Json& json, const Json::json_pointer& place, Places& places) {
  if (json.is_string()) places.push_back(place);
  if (json.is_object())
    for (const auto& [key, value] : json.items()) collect(value, place / key, places);
  if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i) collect(json[i], place / i, places);
}

inline Places strings_of(const Json& json) {
  Places places;
  collect(json, Json::json_pointer(), places);
  return places;
}

/// Groups places by key, except names of quantities, as two of one name are refused.
inline std::map<std::string, Places> by_key(const Places& places) {
  std::map<std::string, Places> all;
  for (const auto& place : places)
    if (place.to_string() != "/exercises/0/quantities/0/name") all[place.back()].push_back(place);
  return all;
}

inline Json spoilt(Json json, const Places& places, const std::string& text) {
  for (const auto& place : places) json[place] = text;
  return json;
}

}  // namespace hostile
