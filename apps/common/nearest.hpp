#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seiche::apps {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn one word into the other
/// (optimal string alignment).
int edit_distance(std::string_view a, std::string_view b);

/// The candidate that the user most likely meant, upper and lower case taken as equal; nothing if none is
/// close, or several equally so.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace seiche::apps
