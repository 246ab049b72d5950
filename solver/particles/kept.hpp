#pragma once
#include <vector>

namespace seiche::solver {

/// Resizes a buffer that is kept from step to step. Where it must grow it takes an eighth more than it needs, not the
/// double of std::vector, so that memory stays small, and growth rare.
template <class T>
void resize_kept(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) values.reserve(size + size / 8);
  values.resize(size);
}

}  // namespace seiche::solver
