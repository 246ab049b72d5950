#pragma once

namespace seiche::apps {

/// What the program exits with; `seiche --help` lists them.
enum ExitCode { done = 0, failed = 1, bad_usage = 2, over_threshold = 3, no_gl = 4, no_encoder = 5, interrupted = 130 };

}  // namespace seiche::apps
