#pragma once
#include <filesystem>
#include <string>

namespace seiche::apps {

/// Table 1 as text: each kernel's name, formula and source, and its values over r/r_e.
std::string kernels_text();

/// Figure 1 as a PNG: the kernels over r/r_e. Throws render::NoGl, std::runtime_error.
void draw_kernels(const std::filesystem::path& file);

}  // namespace seiche::apps
