#include "solver/modes/elements.hpp"

#include <array>
#include <cmath>

#include "solver/modes/nodes.hpp"
#include "solver/tank/edge.hpp"

namespace seiche::solver::modes {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;
using Barycentric = std::array<double, 3>;

struct Point {
  Barycentric at;
  double weight;
};

/// Exact up to degree 6 (Dunavant 1985).
std::vector<Point> triangle_rule() {
  std::vector<Point> points;
  const auto add = [&](double weight, const Barycentric& b) {
    for (const auto& k : {std::array<std::size_t, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
      points.push_back({{b[k[0]], b[k[1]], b[k[2]]}, weight});
      if (points.size() % 3 == 0 && b[1] == b[2]) return;
    }
  };
  add(0.116786275726379, {0.501426509658179, 0.249286745170910, 0.249286745170910});
  add(0.050844906370207, {0.873821971016996, 0.063089014491502, 0.063089014491502});
  add(0.082851075618374, {0.053145049844817, 0.310352451033784, 0.636502499121399});
  return points;
}

/// Of the corners, then of the middles of the edges opposite to them.
Six shape(const Barycentric& b) {
  Six n;
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](int i) { return b[static_cast<std::size_t>(i % 3)]; };
    n[k] = at(k) * (2 * at(k) - 1);
    n[3 + k] = 4 * at(k + 1) * at(k + 2);
  }
  return n;
}

/// @param slopes gradients of the barycentric coordinates
Eigen::Matrix<double, 6, 2> gradients(const Barycentric& b, const Eigen::Matrix<double, 3, 2>& slopes) {
  Eigen::Matrix<double, 6, 2> all;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    all.row(k) = (4 * b[static_cast<std::size_t>(k)] - 1) * slopes.row(k);
    all.row(3 + k) =
        4 * (b[static_cast<std::size_t>(i)] * slopes.row(j) + b[static_cast<std::size_t>(j)] * slopes.row(i));
  }
  return all;
}

Eigen::Matrix<double, 6, 6> stiffness(const std::array<Vec<2>, 3>& corners, const Across& across) {
  static const std::vector<Point> rule = triangle_rule();
  const double twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
  Eigen::Matrix<double, 3, 2> slopes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec<2> opposite = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    slopes.row(static_cast<int>(k)) << -opposite[1] / twice, opposite[0] / twice;
  }
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  for (const Point& point : rule) {
    const double r = point.at[0] * corners[0][0] + point.at[1] * corners[1][0] + point.at[2] * corners[2][0];
    const double weight = 0.5 * twice * point.weight * (across.revolved ? r : 1);
    const double wave_number = across.revolved ? across.m / r : across.wave_number;
    const auto slope = gradients(point.at, slopes);
    const Six n = shape(point.at);
    sum += weight * (slope * slope.transpose() + wave_number * wave_number * n * n.transpose());
  }
  return sum;
}

/// Of an edge of the surface: its ends and its middle.
Eigen::Matrix3d surface_mass(double from, double to, bool revolved) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int k = -1; k <= 1; ++k) {  // Gauss, exact up to degree 5
    const double s = k * std::sqrt(0.6), x = 0.5 * (from + to) + 0.5 * s * (to - from);
    const double weight = 0.5 * std::abs(to - from) * (k == 0 ? 8.0 / 9 : 5.0 / 9) * (revolved ? x : 1);
    const Eigen::Vector3d n(0.5 * s * (s - 1), 0.5 * s * (s + 1), 1 - s * s);
    sum += weight * n * n.transpose();
  }
  return sum;
}

}  // namespace

Elements assemble(const TriangleMesh& mesh, const Across& across) {
  const Nodes nodes(mesh, across.revolved && across.m > 0);
  const int count_outer = static_cast<int>(nodes.on_surface().size());
  Elements all;
  all.outer = all.mass = Eigen::MatrixXd::Zero(count_outer, count_outer);
  all.across = nodes.on_surface();
  std::vector<Eigen::Triplet<double>> inner, coupling;
  for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t) {
    const std::array<Vec<2>, 3> corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const auto k = stiffness(corners, across);
    const std::array<Nodes::Place, 6>& places = nodes.of(t);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) {
        const Nodes::Place a = places[i], b = places[j];
        if (a.row < 0 || b.row < 0) continue;
        const double value = k(static_cast<int>(i), static_cast<int>(j));
        if (a.on_surface && b.on_surface)
          all.outer(a.row, b.row) += value;
        else if (!a.on_surface && !b.on_surface)
          inner.emplace_back(a.row, b.row, value);
        else if (b.on_surface)
          coupling.emplace_back(a.row, b.row, value);
      }
    for (std::size_t e = 0; e < 3; ++e) {
      if (mesh.triangles()[static_cast<std::size_t>(t)].across[e] != TriangleMesh::surface) continue;
      const std::array<std::size_t, 3> line{(e + 1) % 3, (e + 2) % 3, 3 + e};
      const Eigen::Matrix3d m = surface_mass(corners[line[0]][0], corners[line[1]][0], across.revolved);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          if (places[line[i]].row >= 0 && places[line[j]].row >= 0)
            all.mass(places[line[i]].row, places[line[j]].row) += m(static_cast<int>(i), static_cast<int>(j));
    }
  }
  all.inner.resize(nodes.below(), nodes.below());
  all.inner.setFromTriplets(inner.begin(), inner.end());
  all.coupling.resize(nodes.below(), count_outer);
  all.coupling.setFromTriplets(coupling.begin(), coupling.end());
  return all;
}

}  // namespace seiche::solver::modes
