#include "solver/tank/contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

using Loop = std::vector<Edge>;

double signed_area(const Loop& loop) {
  double sum = 0;
  for (const Edge& edge : loop) {
    sum += cross(edge.from, edge.to);
    if (edge.bulge != 0) sum += edge.radius() * edge.radius() * (edge.angle() - std::sin(edge.angle()));
  }
  return 0.5 * sum;
}

Bounds<2> bounds_of(const Edge& edge) {
  Bounds<2> all{edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)};
  if (edge.bulge == 0) return all;
  for (const Vec<2>& axis : {Vec<2>(1, 0), Vec<2>(0, 1), Vec<2>(-1, 0), Vec<2>(0, -1)}) {
    const Vec<2> r = edge.point(edge.nearest_share(edge.centre() + edge.radius() * axis));
    all.low = all.low.cwiseMin(r);
    all.high = all.high.cwiseMax(r);
  }
  return all;
}

Loop reversed(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  for (Edge& edge : loop) {
    std::swap(edge.from, edge.to);
    edge.bulge = -edge.bulge;
  }
  return loop;
}

std::string written(const Vec<2>& r) { return fmt::format("({:.6g}, {:.6g}) m", r[0], r[1]); }

void check_loop(const Loop& loop) {
  if (loop.size() < 2)
    throw BadParameters("the tank's wall: a loop of fewer than two edges; give three points at least");
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Edge& edge = loop[k];
    if (!edge.from.allFinite() || !edge.to.allFinite() || !std::isfinite(edge.bulge))
      throw BadParameters("the tank's wall: a point is not a finite number");
    if (edge.from == edge.to)
      throw BadParameters(
          fmt::format("the tank's wall: the point {} is there twice; leave one out", written(edge.from)));
    if (edge.to != loop[(k + 1) % loop.size()].from)
      throw BadParameters(fmt::format("the tank's wall: it isn't closed at {}", written(edge.to)));
  }
}

std::vector<Contour::Corner> polygon_of(const Loop& loop, double tolerance) {
  std::vector<Contour::Corner> corners;
  for (const Edge& edge : loop) {
    int pieces = 1;
    if (edge.bulge != 0) {
      // A chord over the angle a lies R (1 - cos(a/2)) off its arc.
      const double widest = 2 * std::acos(std::max(0.0, 1 - tolerance / edge.radius()));
      pieces = std::max(2, static_cast<int>(std::ceil(std::abs(edge.angle()) / widest)));
    }
    for (int k = 0; k < pieces; ++k) corners.push_back({edge.point(double(k) / pieces), edge.patch});
  }
  return corners;
}

/// Whether the pieces a b and c d have a point in common.
bool meet(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
  const auto side = [](const Vec<2>& p, const Vec<2>& q, const Vec<2>& r) { return cross(q - p, r - p); };
  const auto within = [](const Vec<2>& p, const Vec<2>& q, const Vec<2>& r) {
    return (r.array() >= p.cwiseMin(q).array()).all() && (r.array() <= p.cwiseMax(q).array()).all();
  };
  const double s1 = side(a, b, c), s2 = side(a, b, d), s3 = side(c, d, a), s4 = side(c, d, b);
  if (((s1 > 0 && s2 < 0) || (s1 < 0 && s2 > 0)) && ((s3 > 0 && s4 < 0) || (s3 < 0 && s4 > 0))) return true;
  return (s1 == 0 && within(a, b, c)) || (s2 == 0 && within(a, b, d)) || (s3 == 0 && within(c, d, a)) ||
         (s4 == 0 && within(c, d, b));
}

struct Piece {
  Vec<2> from, to;
  std::size_t before, after;  ///< places of its neighbours along the loop
};

std::vector<Piece> pieces_of(const std::vector<std::vector<Contour::Corner>>& polygons) {
  std::vector<Piece> pieces;
  for (const auto& corners : polygons) {
    const std::size_t first = pieces.size(), count = corners.size();
    for (std::size_t k = 0; k < count; ++k)
      pieces.push_back({corners[k].position, corners[(k + 1) % count].position, first + (k + count - 1) % count,
                        first + (k + 1) % count});
  }
  return pieces;
}

void check_crossings(const std::vector<std::vector<Contour::Corner>>& polygons) {
  const std::vector<Piece> pieces = pieces_of(polygons);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (std::size_t m = k + 1; m < pieces.size(); ++m) {
      const Piece &a = pieces[k], &b = pieces[m];
      if ((a.from.cwiseMax(a.to).array() < b.from.cwiseMin(b.to).array()).any() ||
          (b.from.cwiseMax(b.to).array() < a.from.cwiseMin(a.to).array()).any())
        continue;
      // Neighbours share a point; they fold back on each other only if they leave it in one direction.
      const bool next = a.after == m, last = a.before == m;
      bool bad = !next && !last && meet(a.from, a.to, b.from, b.to);
      if (next) bad |= cross(a.from - a.to, b.to - b.from) == 0 && (a.from - a.to).dot(b.to - b.from) > 0;
      if (last) bad |= cross(a.to - a.from, b.from - b.to) == 0 && (a.to - a.from).dot(b.from - b.to) > 0;
      if (bad)
        throw BadParameters(
            fmt::format("the tank's wall crosses or touches itself near {}", written(0.5 * (a.from + a.to))));
    }
}

bool is_inside(const std::vector<Contour::Corner>& corners, const Vec<2>& r) {
  bool inside = false;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k].position, &b = corners[(k + 1) % corners.size()].position;
    if ((a[1] > r[1]) != (b[1] > r[1]) && r[0] < a[0] + (r[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

}  // namespace

Contour::Contour(std::vector<std::vector<Edge>> loops) : loops_(std::move(loops)) {
  if (loops_.empty()) throw BadParameters("the tank's wall: no loop of points; give three points at least");
  std::for_each(loops_.begin(), loops_.end(), check_loop);
  const double tolerance = 1e-4 * bounds().size().maxCoeff();
  const auto corners = polygons(tolerance);
  check_crossings(corners);
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    int around = 0;
    for (std::size_t m = 0; m < loops_.size(); ++m) around += m != k && is_inside(corners[m], loops_[k][0].from);
    if ((signed_area(loops_[k]) > 0) != (around % 2 == 0)) loops_[k] = reversed(std::move(loops_[k]));
  }
  std::vector<Bounds<2>> boxes;
  for (std::size_t k = 0; k < loops_.size(); ++k)
    for (std::size_t m = 0; m < loops_[k].size(); ++m) {
      const Edge& edge = loops_[k][m];
      Held held{k, m, edge.from, edge.to - edge.from, Vec<2>::Zero(), Vec<2>::Zero(), 0, 0};
      if (edge.bulge != 0) {
        held.centre = edge.centre();
        held.radius = edge.radius();
        held.middle = (edge.point(0.5) - held.centre) / held.radius;
        held.cosine = std::cos(0.5 * edge.angle());
      }
      held_.push_back(held);
      boxes.push_back(bounds_of(edge));
    }
  tree_ = BoxTree<2>(boxes);
}

double Contour::Held::squared_distance(const Vec<2>& r) const {
  const Vec<2> off = r - from;
  if (radius == 0) {
    const double share = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (off - share * way).squaredNorm();
  }
  const Vec<2> arm = r - centre;
  const double distance = arm.norm();
  if (arm.dot(middle) >= distance * cosine) return (distance - radius) * (distance - radius);
  return std::min(off.squaredNorm(), (off - way).squaredNorm());
}

Nearest<2> Contour::nearest(const Vec<2>& r) const {
  int nearest = std::numeric_limits<int>::max();
  double least = std::numeric_limits<double>::infinity();
  tree_.search(r, [&](int item) {
    const double squared = held_[static_cast<std::size_t>(item)].squared_distance(r);
    // Of edges as near, the first, whatever the order that the tree has them in.
    if (squared < least || (squared == least && item < nearest)) least = squared, nearest = item;
    return least;
  });
  const Held& found = held_[static_cast<std::size_t>(nearest)];
  const Loop* loop = &loops_[found.loop];
  const Edge* edge = &(*loop)[found.edge];
  const double share = edge->nearest_share(r);
  Nearest<2> result{0, edge->point(share), edge->normal(share), edge->patch};
  const Vec<2> off = r - result.foot;
  result.distance = off.norm();
  if (share > 0 && share < 1) {
    if (off.dot(result.normal) < 0) result.distance = -result.distance;
    return result;
  }
  const std::size_t count = loop->size();
  const Edge& other = (*loop)[share > 0 ? (found.edge + 1) % count : (found.edge + count - 1) % count];
  const Vec<2> beside = other.normal(share > 0 ? 0 : 1);
  if (off.dot(result.normal + beside) < 0) {
    result.distance = -result.distance;
    result.normal = -off.normalized();
  } else if (off.dot(beside) > off.dot(result.normal)) {
    result.normal = beside;
    result.patch = other.patch;
  }
  return result;
}

Bounds<2> Contour::bounds() const {
  Bounds<2> all = bounds_of(loops_[0][0]);
  for (const Loop& loop : loops_)
    for (const Edge& edge : loop) {
      const Bounds<2> one = bounds_of(edge);
      all.low = all.low.cwiseMin(one.low);
      all.high = all.high.cwiseMax(one.high);
    }
  return all;
}

double Contour::area() const {
  double sum = 0;
  for (const Loop& loop : loops_) sum += signed_area(loop);
  return sum;
}

double Contour::length() const {
  double sum = 0;
  for (const Loop& loop : loops_)
    for (const Edge& edge : loop) sum += edge.length();
  return sum;
}

std::vector<std::vector<Contour::Corner>> Contour::polygons(double tolerance) const {
  std::vector<std::vector<Corner>> all;
  for (const Loop& loop : loops_) all.push_back(polygon_of(loop, tolerance));
  return all;
}

Contour polygon(const std::vector<Vec<2>>& corners) {
  if (corners.size() < 3)
    throw BadParameters(fmt::format("the tank's wall: {} points; give three at least", corners.size()));
  Loop loop;
  for (std::size_t k = 0; k < corners.size(); ++k)
    loop.push_back({corners[k], corners[(k + 1) % corners.size()], 0, static_cast<int>(k)});
  return Contour({loop});
}

}  // namespace seiche::solver
