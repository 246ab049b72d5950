#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/scene/scene.hpp"
#include "apps/scene/values.hpp"

// The one list of scene keys. Parsing, --set, --dry-run, range checks, "did you mean" and run.json all read it.
namespace seiche::apps {

/// A value with a written form of its own, as in "1280x720". `set` throws std::invalid_argument.
struct Written {
  std::string (*get)(const Scene&);
  void (*set)(Scene&, const std::string&);
  std::string_view form;  ///< what is expected, as in "width x height in pixels"
};

/// An enum, by the names of its values. `set` takes one of the option's Choices.
struct Chosen {
  std::string (*get)(const Scene&);
  void (*set)(Scene&, std::string_view);
  std::vector<std::string_view> meanings;  ///< of its Choices, in their order
};

/// Numbers of an OneOr rule. `set` takes what it lets through.
struct Several {
  Numbers (*get)(const Scene&);
  void (*set)(Scene&, const Numbers&);
};

/// One key of a scene file.
struct Option {
  using Access = std::variant<double& (*)(Scene&), int& (*)(Scene&), bool& (*)(Scene&), std::string& (*)(Scene&),
                              Points& (*)(Scene&), Chosen, Written, Several>;
  std::string_view section;  ///< empty: above the first [section]
  std::string_view key;
  std::string_view unit;  ///< empty: none
  Access access;
  Rule rule;
  std::string_view help;  ///< one line
};

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

/// The same for documents: a choice that comes with meanings as "a: what a is; b: what b is".
std::string explained(const Option& option);

/// Puts the value into the scene; on a wrong one the scene is left as it was and the complaint returned.
std::optional<std::string> assign(const Option& option, Scene& scene, const Value& value);

/// The scene's value of the key.
Value value_of(const Option& option, const Scene& scene);

}  // namespace seiche::apps
