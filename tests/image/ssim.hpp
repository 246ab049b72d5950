#pragma once
#include "render/image.hpp"

namespace seiche::test {

/// Structural similarity of two pictures of one size: 1 where they are equal, near 0 where they have nothing in common.
/// Z. Wang et al., IEEE Trans. Image Processing 13(4), 2004, doi:10.1109/TIP.2003.819861, equation (13), over windows
/// of 8 x 8 pixels in steps of 4, the least of red, green, blue and alpha.
struct Similarity {
  double mean = 1;   ///< of all windows
  double least = 1;  ///< of the worst tile of 32 x 32 pixels: sees a missing word in a large picture
};
Similarity similarity(const render::Image& a, const render::Image& b);

}  // namespace seiche::test
