#pragma once
#include <string>
#include <vector>

#include "solver/parameters.hpp"

namespace seiche::apps {

/// Whether the text is a table of OpenFOAM's tabulated6DoFMotion: it begins with a bracket, or with a count and one.
bool is_openfoam_table(const std::string& text);

/// Reads one: its x, y, z are the axes of motion.axes; it turns by R = R_x R_y R_z. Throws BadScene.
Parameters::TimeSeries openfoam_motion(const std::string& text, const std::string& file,
                                       const Parameters::Motion& motion);

/// Whether the text's first line that isn't a comment is one of numbers, so that no titles say what they are.
bool has_no_titles(const std::string& text);

/// Reads rows of numbers with commas, semicolons or spaces between. Throws BadScene.
/// @param columns what each is, as in "t", "roll"; empty: those of a DualSPHysics path
Parameters::TimeSeries untitled_motion(const std::string& text, const std::string& file,
                                       const Parameters::Motion& motion, const std::vector<std::string>& columns);

}  // namespace seiche::apps
