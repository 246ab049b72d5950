#pragma once
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

// Files are written under another name in the same folder and renamed when they are whole, so that no reader, and
// nobody after a killed run, ever meets half a file. All functions throw std::runtime_error.
namespace seiche::render {

/// The name to write `file` under. Makes its folder.
std::filesystem::path partial_name(const std::filesystem::path& file);

/// Gives what was written under partial_name(file) its name.
void publish(const std::filesystem::path& file);

void write_file(const std::filesystem::path& file, std::string_view bytes);

/// All that a file holds.
std::string read_file(const std::filesystem::path& file);

/// All that an open file holds, wherever it is being written at.
std::string contents(std::FILE* file);

}  // namespace seiche::render
