#include "apps/scene_text.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "apps/options.hpp"

namespace seiche::apps {
namespace {

// Text needs no escapes: every word of the table and every written form is plain.
std::string toml_value(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("\"{}\"", *text);
  return std::visit([](const auto& plain) { return fmt::format("{}", plain); }, value);
}

std::string text(const Scene& scene, bool explained) {
  std::string result;
  std::string_view section;
  for (const Option& option : options()) {
    if (option.section != section) result += fmt::format("\n[{}]\n", section = option.section);
    const std::string line = fmt::format("{} = {}", option.key, toml_value(value_of(option, scene)));
    result += explained ? fmt::format("{:<32} # {} ({})\n", line, option.help, expected(option)) : line + "\n";
  }
  return result;
}

}  // namespace

std::string scene_text(const Scene& scene) { return text(scene, false); }

std::string explained_scene_text(const Scene& scene) { return text(scene, true); }

std::string scene_hash(const Scene& scene) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const unsigned char c : scene_text(scene)) hash = (hash ^ c) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace seiche::apps
