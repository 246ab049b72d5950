#include "render/files/provenance.hpp"

#include <fmt/format.h>

namespace seiche::render {

Notes provenance(const RunInfo& run) {
  return {{"Software", fmt::format("Seiche {}", run.version)},
          {"Title", run.name},
          {"Scene hash", run.scene_hash},
          {"Parameters", run.parameters}};
}

Notes provenance(const RunInfo& run, const Frame& frame) {
  Notes notes = provenance(run);
  notes.emplace_back("Time", fmt::format("{:.9g} s", frame.time));
  notes.emplace_back("Step", fmt::format("{}", frame.step));
  return notes;
}

}  // namespace seiche::render
