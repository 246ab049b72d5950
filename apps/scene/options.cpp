#include "apps/scene/options.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace seiche::apps {
namespace {

std::optional<std::string> assign_written(const Option& option, const Written& written, Scene& scene,
                                          const Value& value) {
  const std::string* text = std::get_if<std::string>(&value);
  if (!text) return refusal(title(option), expected(option), value, "is not text");
  try {
    written.set(scene, *text);
  } catch (const std::invalid_argument&) {
    return refusal(title(option), expected(option), value, "cannot be used");
  }
  return {};
}

std::optional<std::string> assign_chosen(const Option& option, const Chosen& chosen, Scene& scene, const Value& value) {
  std::string text;
  if (auto complaint = put(value, {&text, option.rule, title(option), expected(option)})) return complaint;
  chosen.set(scene, text);
  return {};
}

std::optional<std::string> assign_several(const Option& option, const Several& several, Scene& scene,
                                          const Value& value) {
  Numbers numbers;
  if (auto complaint = put(value, {&numbers, option.rule, title(option), expected(option)})) return complaint;
  several.set(scene, numbers);
  return {};
}

// The member behind the key; nothing where it has a written form of its own.
std::optional<Target> target(const Option& option, Scene& scene) {
  return std::visit(
      [&](const auto& access) -> std::optional<Target> {
        using Access = std::decay_t<decltype(access)>;
        if constexpr (std::is_same_v<Access, Written> || std::is_same_v<Access, Chosen> ||
                      std::is_same_v<Access, Several>)
          return {};
        else
          return &access(scene);
      },
      option.access);
}

}  // namespace

std::vector<std::string> sections() {
  std::vector<std::string> result;
  for (const Option& option : options()) {
    if (result.empty() || result.back() != option.section) result.emplace_back(option.section);
  }
  return result;
}

const Option* find_option(std::string_view section, std::string_view key) {
  for (const Option& option : options()) {
    if (option.section == section && option.key == key) return &option;
  }
  return nullptr;
}

std::string title(const Option& option) {
  return option.section.empty() ? std::string(option.key) : fmt::format("[{}] {}", option.section, option.key);
}

std::string dotted(const Option& option) {
  return option.section.empty() ? std::string(option.key) : fmt::format("{}.{}", option.section, option.key);
}

std::string explained(const Option& option) {
  const auto* chosen = std::get_if<Chosen>(&option.access);
  if (!chosen) return expected(option);
  std::string text;
  const Choices& names = std::get<Choices>(option.rule);
  for (std::size_t k = 0; k < names.size(); ++k)
    text += fmt::format("{}{}: {}", k > 0 ? "; " : "", names[k], chosen->meanings[k]);
  return text;
}

std::string expected(const Option& option) {
  if (const auto* written = std::get_if<Written>(&option.access)) {
    return option.unit.empty() ? std::string(written->form) : fmt::format("{} [{}]", written->form, option.unit);
  }
  return expected(option.rule, option.unit, std::holds_alternative<int& (*)(Scene&)>(option.access));
}

std::optional<std::string> assign(const Option& option, Scene& scene, const Value& value) {
  if (const auto* written = std::get_if<Written>(&option.access)) {
    return assign_written(option, *written, scene, value);
  }
  if (const auto* chosen = std::get_if<Chosen>(&option.access)) return assign_chosen(option, *chosen, scene, value);
  if (const auto* several = std::get_if<Several>(&option.access)) return assign_several(option, *several, scene, value);
  return put(value, {*target(option, scene), option.rule, title(option), expected(option)});
}

Value value_of(const Option& option, const Scene& scene) {
  if (const auto* written = std::get_if<Written>(&option.access)) return written->get(scene);
  if (const auto* chosen = std::get_if<Chosen>(&option.access)) return chosen->get(scene);
  if (const auto* several = std::get_if<Several>(&option.access)) {
    Numbers numbers = several->get(scene);
    return value_in(&numbers);
  }
  Scene copy = scene;  // The table reaches members for writing only; one copy a key is cheap.
  return value_in(*target(option, copy));
}

}  // namespace seiche::apps
