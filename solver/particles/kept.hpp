#pragma once
#include <vector>

namespace seiche::solver {

/// Makes room in a buffer that is kept from step to step. Where it must grow it takes an eighth more than it needs, not
/// the double of std::vector, so that memory stays small, and growth rare.
template <class T>
void reserve_kept(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) values.reserve(size + size / 8);
}

/// Resizes such a buffer.
template <class T>
void resize_kept(std::vector<T>& values, std::size_t size) {
  reserve_kept(values, size);
  values.resize(size);
}

/// Fills such a buffer anew.
template <class T>
void assign_kept(std::vector<T>& values, std::size_t size, const T& value) {
  reserve_kept(values, size);
  values.assign(size, value);
}

}  // namespace seiche::solver
