#include "render/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace seiche::render {

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  auto partial = file;
  partial += ".part";
  errno = 0;
  std::ofstream out(partial, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error(fmt::format("can't write {}: {}", file.string(), std::strerror(errno)));
  std::filesystem::rename(partial, file, error);
  if (error) throw std::runtime_error(fmt::format("can't write {}: {}", file.string(), error.message()));
}

}  // namespace seiche::render
