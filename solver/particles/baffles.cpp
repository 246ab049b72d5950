#include "solver/particles/baffles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche::solver {

template <int D>
int Baffles<D>::entered(const Vec<D>& from, const Vec<D>& to) const {
  double first = std::numeric_limits<double>::infinity();
  int found = -1;
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const double share = faces_[k].entry(from, to, first - 1e-9);
    if (!std::isfinite(share)) continue;
    first = share;
    found = static_cast<int>(k);
  }
  return found;
}

template <int D>
bool Baffles<D>::sees(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const {
  if (behind_a < 0 && behind_b < 0) return entered(a, b) < 0 && entered(b, a) < 0;
  if (behind_a >= 0 && behind_b >= 0 && behind_a != behind_b && !face_each_other(a, behind_a, b, behind_b))
    return false;
  return behind_a == behind_b || (behind_b >= 0 && entered(a, b) == behind_b) ||
         (behind_a >= 0 && entered(b, a) == behind_a);
}

template <int D>
bool Baffles<D>::is_at_rim(const Vec<D>& r, double distance) const {
  return std::any_of(faces_.begin(), faces_.end(), [&](const auto& face) { return face.is_at_rim(r, distance); });
}

template <int D>
bool Baffles<D>::is_near(const Vec<D>& r, double distance) const {
  return std::any_of(faces_.begin(), faces_.end(), [&](const auto& face) { return face.is_near(r, distance); });
}

template <int D>
bool Baffles<D>::face_each_other(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const {
  const BaffleFace<D>&first = faces_[behind_a], &second = faces_[behind_b];
  return second.behind(first.foot(a)) < 0 && first.behind(second.foot(b)) < 0;
}

template class Baffles<2>;
template class Baffles<3>;

}  // namespace seiche::solver
