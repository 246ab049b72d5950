#pragma once
#include <string>
#include <vector>

#include "solver/frame.hpp"

namespace seiche::render {

/// A degree of freedom as a picture shows it.
struct MotionMark {
  std::string name;
  bool rotation = false;  ///< an arc about the axis, right-handed; else an arrow along it
  Double3 axis{1, 0, 0};  ///< of length 1, in the tank's frame
};

struct MotionMarks {
  Double3 origin{};  ///< where they begin [m]
  std::vector<MotionMark> marks;
};

}  // namespace seiche::render
