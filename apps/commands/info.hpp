#pragma once
#include <string>

namespace seiche::apps {

/// What `seiche info` says: versions, the GL renderer, ffmpeg and its encoders. What is missing is named with the
/// Debian package that has it.
std::string info_text();

}  // namespace seiche::apps
