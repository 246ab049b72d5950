#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/contents.hpp"

namespace seiche::apps {

/// Of numbered pictures (000123.png at 123 frame intervals, the last not after `end`) no more than `most`, evenly
/// spaced, the first and the last among them.
std::vector<Still> even_stills(const std::vector<std::filesystem::path>& pictures, double frame_interval, double end,
                               std::size_t most = 13);

/// The report of one run by itself, with what is in its folder. Throws BadFolder, BadScene.
Report report_of(const StoredRun& run, const std::string& command = "");

/// Writes one self-contained HTML page: movie, stills, curves, a table of measures, what was run. A movie too large
/// to be embedded is linked by its path from the page's folder. The same runs give the same page, but for wall times.
/// Throws std::runtime_error where the page can't be written or a picture can't be read.
void write_report(const std::filesystem::path& file, const Report& report);

}  // namespace seiche::apps
