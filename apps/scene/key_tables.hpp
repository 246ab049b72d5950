#pragma once
#include <string>

namespace seiche::apps {

/// The keys of a scene as Markdown, a table for each section and each list: what scenes/README.md has between its
/// markers.
std::string key_tables();

}  // namespace seiche::apps
