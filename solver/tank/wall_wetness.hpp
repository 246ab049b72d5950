#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/operators/reference.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// How wet the walls are: 1 beside liquid, 0 where a wall is dry, in between at the contact line. A dry wall bounds no
/// liquid, so it mustn't count as a neighbour: else liquid creeps up a wall, and a particle at the contact line isn't
/// seen to be at the free surface.
///
/// Of the liquid that a wall particle would have around it on a full lattice it has the share
///   s_i = sum_fluid w / (n0 - sum_solid w).
/// On the lattice s is `level` beside the topmost layer of still liquid, where all the wall counts as it does far from
/// the surface, and `above` one spacing higher, where none does; wetness goes from 0 to 1 between them. That is beside
/// an upright wall, where liquid below the level fills a right angle. Under a wall that leans over it liquid fills a
/// wider angle a: up to a lean of 45 degrees both are a/(pi/2) times as great. From there on they go back linearly, to
/// those of an upright wall at a roof, since liquid that comes up to a roof from below has no level there. A dummy is
/// as wet as the wall particle before it.
template <int D>
class WallWetness {
 public:
  template <class K>
  WallWetness(const K& w, double l0) {
    // Liquid fills x > 0 up to the height of the wall particle (0), or of one a spacing below it.
    double flooded = 0;
    const int m = static_cast<int>(std::ceil(w.support / l0));
    for (int k = D == 3 ? -m : 0; k <= (D == 3 ? m : 0); ++k)
      for (int j = -m; j <= m; ++j)
        for (int i = 1; i <= m; ++i) {
          const double r = l0 * std::sqrt(double(i) * i + double(j) * j + double(k) * k);
          if (!(r < w.support)) continue;
          flooded += w(r);
          if (j <= 0) level_ += w(r);
          if (j < 0) above_ += w(r);
        }
    level_ /= flooded;
    above_ /= flooded;
  }

  double level() const { return level_; }
  double above() const { return above_; }

  /// Finds the wall particle before each dummy. Call when the list was made anew.
  void relist(const Neighbours<D>& list, const State<D>& s) {
    before_.assign(s.size(), -1);
    distance_.assign(s.size(), std::numeric_limits<double>::infinity());
    for (int i = 0; i < static_cast<int>(s.size()); ++i) {
      if (s.kind[i] != Kind::wall) continue;
      for (int j : list[i]) {
        const double r2 = (s.position[j] - s.position[i]).squaredNorm();
        if (s.kind[j] == Kind::dummy && s.behind[j] == s.behind[i] && r2 < distance_[j])
          distance_[j] = r2, before_[j] = i;
      }
    }
  }

  /// Sets the wetness of wall and dummy particles.
  /// @param up against gravity, in the tank's axes; 0 where there is none
  void operator()(const Pairs<D>& pairs, double n0, const Vec<D>& up, State<D>& s) const {
    const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) {
      if (s.kind[i] != Kind::wall) continue;
      double fluid = 0, solid = 0;
      pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
        (s.kind[j] == Kind::fluid ? fluid : solid) += s.volume[j] * weight * rij.squaredNorm();
      });
      const double share = fluid / (n0 - solid), wider = times_wider(s.normal[i].dot(up));
      s.wet[i] = s.volume[i] * std::clamp((share - wider * above_) / (wider * (level_ - above_)), 0.0, 1.0);
    }
    for (int i = 0; i < size; ++i)
      if (s.kind[i] == Kind::dummy)
        s.wet[i] = before_[i] < 0 ? 0 : s.volume[i] / s.volume[before_[i]] * s.wet[before_[i]];
  }

 private:
  /// @param rise of the wall's normal out of the tank: 0 of an upright wall, 1 of a roof
  static double times_wider(double rise) {
    if (!(rise > 0)) return 1;
    const double lean = std::asin(std::min(rise, 1.0)) / (0.5 * std::numbers::pi);
    return 1 + std::min(lean, 1 - lean);
  }

  double level_ = 0, above_ = 0;
  std::vector<int> before_;
  Scalars distance_;
};

}  // namespace seiche::solver
