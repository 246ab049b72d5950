#include "solver/tank/baffles/cut_polygons.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

/// The part where a value given at each corner is at most 0, between corners taken to be linear.
Polygon3 below(const Polygon3& polygon, const Scalars& value) {
  Polygon3 kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = (k + 1) % polygon.size();
    if (value[k] <= 0) kept.push_back(polygon[k]);
    if (value[k] * value[next] < 0)
      kept.push_back(polygon[k] + value[k] / (value[k] - value[next]) * (polygon[next] - polygon[k]));
  }
  return kept.size() < 3 ? Polygon3() : kept;
}

template <class Of>
Scalars values(const Polygon3& polygon, Of of) {
  Scalars all;
  for (const Vec<3>& r : polygon) all.push_back(of(r));
  return all;
}

Vec<3> middle_of(const Polygon3& polygon) {
  Vec<3> sum = Vec<3>::Zero();
  for (const Vec<3>& r : polygon) sum += r;
  return sum / static_cast<double>(polygon.size());
}

struct Cut {
  const std::function<double(const Vec<3>&)>& distance;
  double slack, finest;
  Polygons3 kept;

  /// Returns whether all of it is kept, as one piece.
  bool add(const Polygon3& polygon, int halvings = 0) {
    const Vec<3> middle = middle_of(polygon);
    const auto farther = [&](const Vec<3>& a, const Vec<3>& b) {
      return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    };
    const Vec<3> way = *std::max_element(polygon.begin(), polygon.end(), farther) - middle;
    const double off = distance(middle), extent = way.norm();
    if (off > extent) return false;
    if (off <= -extent) {
      kept.push_back(polygon);
      return true;
    }
    if (extent <= finest || halvings > 60) {
      const Scalars at = values(polygon, distance);
      const bool whole = *std::max_element(at.begin(), at.end()) <= slack;
      if (Polygon3 part = whole ? polygon : cut_off(polygon, at); !part.empty()) kept.push_back(std::move(part));
      return whole;
    }
    const std::size_t begin = kept.size();
    const Face<3> half{way / extent, way.dot(middle) / extent};
    const Polygon3 near = before(polygon, half), far = behind(polygon, half);
    const bool near_whole = near.empty() || add(near, halvings + 1), far_whole = far.empty() || add(far, halvings + 1);
    if (!near_whole || !far_whole) return false;
    kept.resize(begin);
    kept.push_back(polygon);
    return true;
  }

  /// What lies within; its sides end where the distance is the slack, which may bend along them, as in a corner.
  Polygon3 cut_off(const Polygon3& polygon, const Scalars& at) const {
    Polygon3 part;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t next = (k + 1) % polygon.size();
      const bool is_in = at[k] <= slack;
      if (is_in) part.push_back(polygon[k]);
      if (is_in == (at[next] <= slack)) continue;
      Vec<3> in = polygon[is_in ? k : next], out = polygon[is_in ? next : k];
      for (int halving = 0; halving < 40; ++halving) {
        const Vec<3> middle = 0.5 * (in + out);
        (distance(middle) <= slack ? in : out) = middle;
      }
      if ((in - polygon[k]).squaredNorm() > 0) part.push_back(in);
    }
    return part.size() < 3 ? Polygon3() : part;
  }
};

}  // namespace

Polygon3 behind(const Polygon3& polygon, const Face<3>& plane) {
  return below(polygon, values(polygon, [&](const Vec<3>& r) { return -plane.behind(r); }));
}

Polygon3 before(const Polygon3& polygon, const Face<3>& plane) {
  return below(polygon, values(polygon, [&](const Vec<3>& r) { return plane.behind(r); }));
}

Polygons3 inside(const Polygon3& polygon, const std::function<double(const Vec<3>&)>& distance, double slack,
                 double finest) {
  Cut whole{distance, slack, finest, {}}, cut{distance, 1e-9 * finest, finest, {}};
  if (whole.add(polygon)) return {polygon};
  cut.add(polygon);
  return std::move(cut.kept);
}

Polygons3 outside(const Polygon3& polygon, const std::vector<Face<3>>& solid) {
  Polygons3 kept;
  Polygon3 rest = polygon;
  for (const Face<3>& plane : solid) {
    if (Polygon3 part = behind(rest, plane); !part.empty()) kept.push_back(std::move(part));
    rest = before(rest, plane);
    if (rest.empty()) return kept;
  }
  return kept;
}

void join_sides(Polygons3& polygons) {
  double size = 0;
  std::vector<Vecs<3>> sorted(3);
  for (const Polygon3& polygon : polygons) {
    for (Vecs<3>& by_axis : sorted) by_axis.insert(by_axis.end(), polygon.begin(), polygon.end());
    for (const Vec<3>& r : polygon) size = std::max(size, (r - polygons[0][0]).norm());
  }
  for (int axis = 0; axis < 3; ++axis)
    std::sort(sorted[static_cast<std::size_t>(axis)].begin(), sorted[static_cast<std::size_t>(axis)].end(),
              [axis](const Vec<3>& a, const Vec<3>& b) { return a[axis] < b[axis]; });
  const double same = 1e-9 * size;
  for (Polygon3& polygon : polygons) {
    Polygon3 joined;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec<3>&from = polygon[k], way = polygon[(k + 1) % polygon.size()] - from;
      joined.push_back(from);
      const double length = way.norm();
      int axis = 0;
      way.cwiseAbs().maxCoeff(&axis);
      const double low = std::min(from[axis], from[axis] + way[axis]), high = low + std::abs(way[axis]);
      const Vecs<3>& near = sorted[static_cast<std::size_t>(axis)];
      std::vector<std::pair<double, Vec<3>>> between;
      for (auto at = std::lower_bound(near.begin(), near.end(), low,
                                      [axis](const Vec<3>&r, double value) { return r[axis] < value; });
           at != near.end() && (*at)[axis] <= high; ++at) {
        const double along = way.dot(*at - from) / length;
        if (along < same || along > length - same || (*at - from - along / length * way).norm() > same) continue;
        between.emplace_back(along, *at);
      }
      std::sort(between.begin(), between.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& [along, r] : between)
        if ((r - joined.back()).norm() > same) joined.push_back(r);
    }
    polygon = std::move(joined);
  }
}

}  // namespace seiche::solver
