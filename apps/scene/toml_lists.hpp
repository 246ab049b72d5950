#pragma once
#include <toml++/toml.h>

#include <functional>
#include <optional>
#include <string>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// Where messages say that something stands, and its order among them.
struct Place {
  std::string origin;
  Position position;
};
using Placing = std::function<Place(const toml::source_region&)>;

/// What a key can be given; nothing for a date, a table, or an array of anything but numbers or pairs of numbers.
std::optional<Value> value_of_node(const toml::node& node);

/// The same from text, as in "[0.1, 0.2]".
std::optional<Value> value_of_text(const std::string& text);

/// Adds the tables of a list to `out`; whatever the list doesn't know are complaints, each with the nearest right name.
void read_list(const List& list, const toml::node& node, const Placing& place, Settings& out);

/// The same from text, as in "[{name = "mid", x = 0.3}]"; all that is wrong with it is said to stand at `origin`.
void read_list_text(const List& list, const std::string& text, const std::string& origin, Settings& out);

}  // namespace seiche::apps
