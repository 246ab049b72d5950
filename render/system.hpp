#pragma once
// Face: what apps may use of render/system.
#include "render/system/bounded_queue.hpp"
#include "render/system/process.hpp"
