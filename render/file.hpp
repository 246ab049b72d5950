#pragma once
#include <filesystem>
#include <string_view>

namespace seiche::render {

/// Writes to a temporary name in the same folder and renames, so that no reader ever meets half a file. Makes the folder.
/// Throws std::runtime_error.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace seiche::render
