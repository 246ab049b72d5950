#include "apps/common/schema.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace seiche::apps {

void check_schema(const nlohmann::json& json, int expected, const std::string& remedy) {
  const auto found = json.find(schema_key);
  if (found == json.end())
    throw std::invalid_argument(
        fmt::format("it has no schema version, as those of Seiche 0.1; expected version {}; {}", expected, remedy));
  if (*found != expected)
    throw std::invalid_argument(
        fmt::format("its schema version is {}; expected {}; {}", found->dump(), expected, remedy));
}

}  // namespace seiche::apps
