#include "apps/scene/lists.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <type_traits>

namespace seiche::apps {
namespace {

/// The member of one table, where it isn't an enum.
Target target(const Member& member, Scene& scene, std::size_t row) {
  return std::visit(
      [&](const auto& access) -> Target {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(access)>, ChosenInRow>)
          throw std::logic_error("an enum has no plain member");
        else
          return &access(scene, row);
      },
      member.access);
}

}  // namespace

const List* find_list(std::string_view section, std::string_view key) {
  for (const List& list : lists()) {
    if (list.section == section && list.key == key) return &list;
  }
  return nullptr;
}

const Member* find_member(const List& list, std::string_view key) {
  for (const Member& member : list.members) {
    if (member.key == key) return &member;
  }
  return nullptr;
}

std::string title(const List& list) { return fmt::format("[[{}]]", dotted(list)); }

std::string dotted(const List& list) { return fmt::format("{}.{}", list.section, list.key); }

std::string title(const List& list, const Member& member) { return fmt::format("{} {}", title(list), member.key); }

std::string form(const List& list) {
  std::string keys;
  for (const Member& member : list.members) keys += fmt::format("{}{} = ...", keys.empty() ? "" : ", ", member.key);
  return "[{" + keys + "}]";
}

std::string expected(const Member& member) { return expected(member.rule, member.unit, false); }

std::optional<std::string> assign(const List& list, const Member& member, Scene& scene, std::size_t row,
                                  const Value& value) {
  const auto* chosen = std::get_if<ChosenInRow>(&member.access);
  std::string text;
  auto complaint =
      put(value, {chosen ? &text : target(member, scene, row), member.rule, title(list, member), expected(member)});
  if (!complaint && chosen) chosen->set(scene, row, text);
  return complaint;
}

Value value_of(const Member& member, const Scene& scene, std::size_t row) {
  if (const auto* chosen = std::get_if<ChosenInRow>(&member.access)) return chosen->get(scene, row);
  Scene copy = scene;  // The table reaches members for writing only; one copy a key is cheap.
  return value_in(target(member, copy, row));
}

}  // namespace seiche::apps
