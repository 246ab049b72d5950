#pragma once
#include <filesystem>

#include "solver/frame.hpp"

namespace seiche::render {

/// The frame that write_vtu wrote, bit by bit, but for its readings. `index` becomes Frame::index, which the file
/// doesn't hold. Throws std::runtime_error where the file is missing, cut short or not one of ours. May be called on
/// any thread.
Frame read_vtu(const std::filesystem::path& file, long index);

}  // namespace seiche::render
