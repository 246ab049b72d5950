#include "render/files/file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace seiche::render {
namespace {

std::runtime_error cannot_write(const std::filesystem::path& file, const std::string& why) {
  return std::runtime_error(fmt::format("can't write {}: {}", file.string(), why));
}

// Ends as the file does: some writers go by the ending.
std::filesystem::path partial(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".part-{}", file.filename().string());
}

}  // namespace

std::filesystem::path partial_name(const std::filesystem::path& file) {
  std::error_code error;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) throw cannot_write(file, error.message());
  return partial(file);
}

void publish(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::rename(partial(file), file, error);
  if (error) throw cannot_write(file, error.message());
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  errno = 0;
  std::ofstream out(partial_name(file), std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw cannot_write(file, std::strerror(errno));
  publish(file);
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  // Opening a folder succeeds, reading it throws.
  if (!in || std::filesystem::is_directory(file))
    throw std::runtime_error(fmt::format("{} can't be read: {}", file.string(),
                                         std::filesystem::exists(file) ? "it can't be read" : "it isn't there"));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string contents(std::FILE* file) {
  std::string text;
  char part[4096];
  off_t place = 0;
  for (ssize_t count; (count = pread(fileno(file), part, sizeof part, place)) > 0; place += count)
    text.append(part, static_cast<std::size_t>(count));
  return text;
}

}  // namespace seiche::render
