#pragma once
#include "render/files/read_png.hpp"

namespace seiche::test {

using render::read_png;

}  // namespace seiche::test
