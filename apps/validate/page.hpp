#pragma once
#include <vector>

#include "apps/validate/case.hpp"
#include "render/image.hpp"

namespace seiche::apps::validate {

/// All charts on one page, two beside each other. Throws render::NoGl.
render::Image draw_page(const std::vector<Chart>& charts);

}  // namespace seiche::apps::validate
