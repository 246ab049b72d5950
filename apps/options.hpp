#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/scene.hpp"

// The one list of scene keys. Parsing, --set, --dry-run, range checks, "did you mean" and run.json all read it.
namespace seiche::apps {

/// Numbers that a key takes; the lower end may be left out.
struct Range {
  double low, high;
  bool above_low = false;  ///< low itself is refused
};

/// Words that a key takes.
using Choices = std::vector<std::string_view>;

/// A value with a written form of its own, as in "1280x720". `set` throws std::invalid_argument.
struct Written {
  std::string (*get)(const Scene&);
  void (*set)(Scene&, const std::string&);
  std::string_view form;  ///< what is expected, as in "width x height in pixels"
};

/// One key of a scene file.
struct Option {
  using Access =
      std::variant<double& (*)(Scene&), int& (*)(Scene&), bool& (*)(Scene&), std::string& (*)(Scene&), Written>;
  std::string_view section;  ///< empty: above the first [section]
  std::string_view key;
  std::string_view unit;  ///< empty: none
  Access access;
  std::variant<std::monostate, Range, Choices> rule;
  std::string_view help;  ///< one line
};

/// A value as a scene file or a command line gives it.
using Value = std::variant<bool, std::int64_t, double, std::string>;

const std::vector<Option>& options();

/// Names of the sections, in order; the first is empty.
std::vector<std::string> sections();

const Option* find_option(std::string_view section, std::string_view key);

/// As in "[motion] amplitude", or "gravity" where there is no section.
std::string title(const Option& option);

/// As in "motion.amplitude": how --set names it.
std::string dotted(const Option& option);

/// What the key takes, as in "a number from 0 to 10 [m]" or "one of KF1, KF2".
std::string expected(const Option& option);

/// Puts the value into the scene; on a wrong one the scene is left as it was and the complaint returned.
std::optional<std::string> assign(const Option& option, Scene& scene, const Value& value);

/// The scene's value of the key.
Value value_of(const Option& option, const Scene& scene);

}  // namespace seiche::apps
