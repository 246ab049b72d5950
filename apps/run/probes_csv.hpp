#pragma once
#include <filesystem>
#include <memory>

#include "solver/sink.hpp"

namespace seiche::apps {

/// All sensor readings of a run in one file: a column of time and one for each sensor, with units in the header; on
/// the disk after every frame.
std::unique_ptr<Sink> probes_csv(const std::filesystem::path& file);

}  // namespace seiche::apps
