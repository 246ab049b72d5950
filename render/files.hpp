#pragma once
#include "render/files/file.hpp"
#include "render/files/read_png.hpp"
#include "render/files/read_vtu.hpp"
#include "render/files/small_png.hpp"

// Files, written so that none is ever seen half done, and read back.
