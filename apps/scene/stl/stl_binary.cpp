#include "apps/scene/stl/stl_binary.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "apps/common/errors.hpp"

namespace seiche::apps {
namespace {

constexpr std::size_t head = 80;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return value;
}

}  // namespace

std::uint32_t stl_count(std::string_view bytes) { return bytes.size() < head + 4 ? 0 : word(bytes, head); }

void read_binary_stl(std::string_view bytes, const std::string& file, StlBuilder& builder) {
  const auto refuse = [&](std::size_t byte, const std::string& what) {
    throw BadScene(fmt::format("{}: byte {}: {}", file, byte, what));
  };
  if (bytes.size() < head + 4)
    refuse(bytes.size(), "the file ends in the head of a binary STL file, which is 84 bytes long; export it again");
  const std::uint64_t count = stl_count(bytes), size = stl_size(count);
  if (count == 0) refuse(head, "the file says that it has no triangles; export it with the tank's surface");
  if (bytes.size() < size)
    refuse(bytes.size(), fmt::format("the file ends in triangle {} of {}, {} bytes before its end; it is damaged or no "
                                     "STL file: export or copy it again",
                                     (bytes.size() - head - 4) / 50 + 1, count, size - bytes.size()));
  if (bytes.size() > size)
    refuse(size, fmt::format("{} bytes more than the {} triangles take that the file says it has; it is damaged or no "
                             "STL file: export or copy it again",
                             bytes.size() - size, count));
  builder.begin_solid({});
  for (std::uint64_t k = 0; k < count; ++k) {
    std::array<std::array<double, 3>, 3> corners;
    std::size_t at = stl_size(k) + 12;
    for (auto& corner : corners)
      for (double& coordinate : corner) {
        coordinate = std::bit_cast<float>(word(bytes, at));
        if (!std::isfinite(coordinate))
          refuse(at,
                 fmt::format("a corner of triangle {} of {} has the coordinate {}; expected finite numbers: mend or "
                             "export it again",
                             k + 1, count, coordinate));
        at += 4;
      }
    builder.add(corners);
  }
}

}  // namespace seiche::apps
