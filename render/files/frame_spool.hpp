#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>

#include "render/system/descriptor.hpp"
#include "solver/frame.hpp"

namespace seiche::render {

/// Frames kept on disk until all are there, since a run's would fill the memory. Their file has no name, so that the
/// system frees it however the program ends.
class FrameSpool {
 public:
  /// Makes `folder` and in it the file. Throws std::runtime_error where that fails.
  explicit FrameSpool(const std::filesystem::path& folder);

  /// Throws std::runtime_error, as where the disk is full; the frames before are still there then.
  void write(const Frame& frame);

  /// The next frame, bit by bit, from the first on; nothing after the last. Throws std::runtime_error.
  std::optional<Frame> read();

 private:
  void put(const void* bytes, std::size_t size, long& place) const;
  void get(void* bytes, std::size_t size);

  std::filesystem::path folder_;
  Descriptor file_;
  long end_ = 0, place_ = 0;  // of the frames written, and of those read [bytes]
};

}  // namespace seiche::render
