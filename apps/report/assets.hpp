#pragma once

namespace seiche::apps::report {

/// report.html, the page's template, and report.css and report.js, which it holds.
extern const char* const skeleton;
extern const char* const style;
extern const char* const script;

}  // namespace seiche::apps::report
