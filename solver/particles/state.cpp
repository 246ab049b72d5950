#include "solver/particles/state.hpp"

#include "solver/particles/kept.hpp"

namespace seiche::solver {
namespace {

template <class T>
void pick(std::vector<T>& values, const std::vector<int>& order, std::vector<T>& buffer) {
  const int size = static_cast<int>(order.size());
  resize_kept(buffer, size);
#pragma omp parallel for schedule(static)
  for (int k = 0; k < size; ++k) buffer[k] = values[order[k]];
  values.swap(buffer);
}

}  // namespace

template <int D>
void State<D>::add(const Vec<D>& r, Kind k, const Vec<D>& n, double v) {
  position.push_back(r);
  velocity.push_back(Vec<D>::Zero());
  normal.push_back(n);
  edge.push_back(-1);
  pressure.push_back(0);
  kind.push_back(k);
  density.push_back(0);
  surface.push_back(0);
  near_surface.push_back(0);
  volume.push_back(v);
  wet.push_back(v);
  behind.push_back(-1);
  id.push_back(static_cast<std::uint32_t>(id.size()));
}

template <int D>
void State<D>::reorder(const std::vector<int>& order) {
  pick(position, order, vectors_);
  pick(velocity, order, vectors_);
  pick(normal, order, vectors_);
  pick(edge, order, edges_);
  pick(pressure, order, scalars_);
  pick(kind, order, kinds_);
  pick(density, order, scalars_);
  pick(surface, order, bytes_);
  pick(near_surface, order, bytes_);
  pick(id, order, ids_);
  pick(volume, order, scalars_);
  pick(wet, order, scalars_);
  pick(behind, order, edges_);
}

template struct State<2>;
template struct State<3>;

}  // namespace seiche::solver
