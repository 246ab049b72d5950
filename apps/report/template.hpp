#pragma once
#include <map>
#include <string>
#include <string_view>

namespace seiche::apps::report {

/// The text with each {{name}} replaced by what the name stands for; what is put in isn't searched again.
/// Throws std::logic_error for a name that stands for nothing.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace seiche::apps::report
