#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/scene/scene.hpp"
#include "apps/scene/values.hpp"

// Lists of tables in a scene, as [[sensors.gauge]]: one table of what their tables hold, as options.hpp is of the keys.
namespace seiche::apps {

/// An enum of a list's table, by the names of its values. `set` takes one of the member's Choices.
struct ChosenInRow {
  std::string (*get)(const Scene&, std::size_t row);
  void (*set)(Scene&, std::size_t row, std::string_view);
};

/// One key of a list's tables. A table without it keeps the default, unless it is required.
struct Member {
  using Access =
      std::variant<double& (*)(Scene&, std::size_t row), std::string& (*)(Scene&, std::size_t row),
                   Points& (*)(Scene&, std::size_t row), Triple& (*)(Scene&, std::size_t row),
                   Triples& (*)(Scene&, std::size_t row), Quadruples& (*)(Scene&, std::size_t row), ChosenInRow>;
  std::string_view key;
  std::string_view unit;  ///< empty: none
  Access access;
  Rule rule;
  std::string_view help;  ///< one line
  bool required = false;
};

struct List {
  std::string_view section;  ///< one that has options, too
  std::string_view key;
  std::string_view help;  ///< what a table stands for, and what none means
  std::size_t (*size)(const Scene&);
  void (*reset)(Scene&, std::size_t size);  ///< to so many tables of defaults
  std::vector<Member> members;
};

const std::vector<List>& lists();

const List* find_list(std::string_view section, std::string_view key);

const Member* find_member(const List& list, std::string_view key);

/// As in "[[sensors.gauge]]".
std::string title(const List& list);

/// As in "sensors.gauge": how --set names it.
std::string dotted(const List& list);

/// As in "[[sensors.gauge]] name".
std::string title(const List& list, const Member& member);

/// How --set writes it, as in "[{name = ..., x = ...}]".
std::string form(const List& list);

/// What the member takes.
std::string expected(const Member& member);

/// The same: what a member takes needs no more words in documents.
inline std::string explained(const Member& member) { return expected(member); }

/// Puts the value into one table; on a wrong one the scene is left as it was and the complaint returned.
std::optional<std::string> assign(const List& list, const Member& member, Scene& scene, std::size_t row,
                                  const Value& value);

/// Its value.
Value value_of(const Member& member, const Scene& scene, std::size_t row);

}  // namespace seiche::apps
