#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>

#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"

namespace seiche::apps {
namespace {

// A basic string of TOML.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    result += control ? fmt::format("\\u{:04x}", c) : std::string(1, c);
  }
  return result + '"';
}

std::string toml_value(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  return std::visit([](const auto& plain) { return fmt::format("{}", plain); }, value);
}

// One key as a line, with what it means where `commented`.
template <class Key>
std::string line(const Key& key, const Value& value, bool commented) {
  const std::string bare = fmt::format("{} = {}", key.key, toml_value(value));
  if (!commented) return bare + "\n";
  return fmt::format("{:<32} # {}{}({})\n", bare, key.help, key.help.empty() ? "" : " ", explained(key));
}

// A list's tables; an empty list is explained by a table that is commented out.
std::string list_text(const List& list, const Scene& scene, bool explained) {
  std::string result;
  for (std::size_t row = 0; row < list.size(scene); ++row) {
    result += explained ? fmt::format("\n{:<32} # {}\n", title(list), list.help) : fmt::format("\n{}\n", title(list));
    for (const Member& member : list.members)
      if (!is_of_row(member)) result += line(member, value_of(member, scene, row), explained);
  }
  if (list.size(scene) > 0 || !explained) return result;
  Scene example;
  list.reset(example, 1);
  result += fmt::format("\n# {:<30} # {}\n", title(list), list.help);
  for (const Member& member : list.members)
    if (!is_of_row(member)) result += "# " + line(member, value_of(member, example, 0), true);
  return result;
}

std::string section_text(const std::string& section, const Scene& scene, bool explained) {
  std::string result = section.empty() ? "" : fmt::format("\n[{}]\n", section);
  for (const Option& option : options()) {
    if (option.section == section) result += line(option, value_of(option, scene), explained);
  }
  for (const List& list : lists()) {
    if (list.section == section) result += list_text(list, scene, explained);
  }
  return result;
}

std::string text(const Scene& scene, bool explained) {
  std::string result;
  for (const std::string& section : sections()) result += section_text(section, scene, explained);
  return result;
}

}  // namespace

std::string scene_text(const Scene& scene) { return text(scene, false); }

std::string explained_scene_text(const Scene& scene) { return text(scene, true); }

std::string scene_hash(const Scene& scene) {
  std::string all = scene_text(scene);
  const Parameters::TimeSeries& s = scene.parameters.motion.series;
  all += fmt::format("\n{}", fmt::join(s.time, ","));
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (!s[row.value].empty()) all += row.name, all += fmt::format("\n{}", fmt::join(s[row.value], ","));
  for (const render::Reference& reference : scene.look.references)
    for (const auto* values : {&reference.series.time, &reference.series.value})
      all += fmt::format("\n{}", fmt::join(*values, ","));
  for (const auto& point : scene.parameters.tank.mesh.points) all += fmt::format("\n{}", fmt::join(point, ","));
  for (const SurfaceMesh::Patch& patch : scene.parameters.tank.mesh.patches) {
    all += "\n" + patch.name;
    for (const auto& face : patch.faces) all += fmt::format("\n{}", fmt::join(face, ","));
  }
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const unsigned char c : all) hash = (hash ^ c) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

}  // namespace seiche::apps
