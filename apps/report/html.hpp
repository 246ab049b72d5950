#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace seiche::apps::report {

/// Text as HTML, in an element or in an attribute between double quotes.
std::string escaped(std::string_view text);

/// As in "data:image/png;base64,iVBO...".
std::string data_url(std::string_view type, std::string_view bytes);

/// A relative path as a URL.
std::string url_of(const std::filesystem::path& path);

}  // namespace seiche::apps::report
