#include "solver/tank/mesh/closest.hpp"

namespace seiche::solver {

Foot foot_on(const Triangles& mesh, int triangle, const Vec<3>& r) {
  const Vec<3>&a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1), &c = mesh.corner(triangle, 2);
  const auto result = [&](Foot::On on, int k, const Vec<3>& at) {
    return Foot{triangle, on, k, at, (r - at).squaredNorm()};
  };
  using On = Foot::On;
  const Vec<3> ab = b - a, ac = c - a, ar = r - a;
  const double d1 = ab.dot(ar), d2 = ac.dot(ar);
  if (d1 <= 0 && d2 <= 0) return result(On::corner, 0, a);
  const Vec<3> br = r - b;
  const double d3 = ab.dot(br), d4 = ac.dot(br);
  if (d3 >= 0 && d4 <= d3) return result(On::corner, 1, b);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return result(On::side, 0, a + d1 / (d1 - d3) * ab);
  const Vec<3> cr = r - c;
  const double d5 = ab.dot(cr), d6 = ac.dot(cr);
  if (d6 >= 0 && d5 <= d6) return result(On::corner, 2, c);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return result(On::side, 2, a + d2 / (d2 - d6) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return result(On::side, 1, b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b));
  return result(On::face, 0, a + (vb * ab + vc * ac) / (va + vb + vc));
}

Closest::Closest(const Triangles& mesh) : mesh_(&mesh) {
  std::vector<Bounds<3>> boxes;
  for (int t = 0; t < mesh.count(); ++t) boxes.push_back(mesh.box(t));
  tree_ = BoxTree<3>(boxes);
}

Foot Closest::foot(const Vec<3>& r, double within) const {
  Foot best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  tree_.search(
      r,
      [&](int t) {
        const Foot one = foot_on(*mesh_, t, r);
        if (one.squared_distance < best.squared_distance) best = one;
        return best.squared_distance;
      },
      within * within);
  return best;
}

}  // namespace seiche::solver
