#pragma once
#include <string>

#include "apps/common/output_folder.hpp"
#include "apps/run/run_json.hpp"
#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// What a run says last: how it ended, its wall time and steps, leaks, where the time went, and where everything is
/// that was written.
std::string summary_text(const Scene& scene, const OutputFolder& folder, const RunRecord& record);

/// Prints it, a failure to standard error, and nothing but a failure when quiet.
void print_summary(const Scene& scene, const OutputFolder& folder, const RunRecord& record, bool quiet);

}  // namespace seiche::apps
