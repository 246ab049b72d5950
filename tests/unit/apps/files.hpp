#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/unit/render/scratch.hpp"

namespace seiche::test {

inline std::string read_file(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace seiche::test
