#pragma once
#include "solver/frame.hpp"

namespace seiche::render {

/// What a panel shows at a time.
struct PanelFrame {
  FramePtr frame;      ///< the last one up to that time
  bool ended = false;  ///< none comes any more, though the clock goes on
};

}  // namespace seiche::render
