#pragma once

namespace seiche::apps::report {

/// report.css and report.js, which every page holds.
extern const char* const style;
extern const char* const script;

}  // namespace seiche::apps::report
