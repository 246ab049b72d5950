#include "render/movie_format.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace seiche::render {

const MovieRow& format_of(const std::filesystem::path& file) {
  std::string all;
  for (const MovieRow& row : ChoiceTable<MovieFormat>::rows) {
    if (row.value == MovieFormat::none) continue;
    if (file.extension() == row.suffix) return row;
    all += fmt::format("{}{}", all.empty() ? "" : ", ", row.suffix);
  }
  throw std::invalid_argument(fmt::format("{}: the name of a movie ends in one of {}", file.string(), all));
}

}  // namespace seiche::render
