#pragma once
#include <string>

#include "solver/parameters.hpp"

namespace seiche::apps {

/// Reads a record of the tank's motion, in one of these forms by what the file holds. All need four samples at least,
/// times that ascend, and no gaps. Angles that jump by whole turns are made continuous.
///
/// - CSV with a title above each column, in any order: the time, `t [s]`, also `time`, in s or ms (`t` alone is in s);
///   and any of surge, heave, sway [m, cm, mm], roll, pitch, yaw [deg, rad], or their accelerations [m/s^2, cm/s^2,
///   mm/s^2, g; deg/s^2, rad/s^2], which become displacements by `integrated_twice`.
/// - CSV without titles: `columns` names its columns. Without that, seven are a DualSPHysics path: time, x, y, z [m],
///   angles about x, y, z [degrees]; four are its first four.
/// - A table of OpenFOAM's tabulated6DoFMotion: (time ((x y z) (angles about x y z))), in m and degrees.
///
/// x, y, z are the axes of motion.axes, along which places of a path count from the first one.
///
/// @param motion its axes and order of rotations
/// @param columns names of those that are wanted, with commas between; empty: all. Others are then ignored.
/// Throws BadScene with file:line, what is wrong and what was expected.
Parameters::TimeSeries read_motion_file(const std::string& file, const Parameters::Motion& motion,
                                        const std::string& columns);

/// The same from a file's text; `file` is its name in messages.
Parameters::TimeSeries parse_motion(const std::string& text, const std::string& file, const Parameters::Motion& motion,
                                    const std::string& columns);

}  // namespace seiche::apps
