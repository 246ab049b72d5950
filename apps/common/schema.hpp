#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace seiche::apps {

/// Key of a JSON file's schema version: a whole number that grows whenever the program can't read older files.
constexpr const char* schema_key = "schema";

/// Throws std::invalid_argument, fit for the user after the file's name, where the file has another version or none.
/// @param remedy what to do then, as in "run it again"
void check_schema(const nlohmann::json& json, int expected, const std::string& remedy);

}  // namespace seiche::apps
