#include "solver/modes/section_modes.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/errors.hpp"
#include "solver/modes/ears.hpp"
#include "solver/modes/element_size.hpp"
#include "solver/modes/no_crossing.hpp"
#include "solver/modes/refine.hpp"

namespace seiche::solver::modes {
namespace {

TriangleMesh mesh_of(const Outline& outline, int along, double longest) {
  check_no_crossing(outline);
  const Walk walk = joined(outline);
  std::vector<Vec<2>> points;
  std::vector<bool> surface;
  for (const Corner& corner : walk.corners) {
    points.push_back(corner.at);
    surface.push_back(corner.surface);
  }
  TriangleMesh mesh(std::move(points), ears(walk, outline), surface);
  refine(mesh, ElementSize(outline, along, longest));
  mesh.place(outline.origin, outline.unit);
  return mesh;
}

Chamber modes_of(const Elements& elements, double gravity, int count, bool has_rest) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> inverse(elements.inner);
  const Eigen::MatrixXd response = inverse.solve(Eigen::MatrixXd(elements.coupling));
  const Eigen::MatrixXd condensed = elements.outer - elements.coupling.transpose() * response;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(condensed, elements.mass);
  Chamber chamber{elements.across, {}};
  const int first = has_rest ? 1 : 0;
  for (int k = first; k < std::min<int>(first + count, static_cast<int>(eigen.eigenvalues().size())); ++k) {
    Eigen::VectorXd shape = eigen.eigenvectors().col(k);
    shape /= shape.cwiseAbs().maxCoeff();
    chamber.modes.push_back({std::sqrt(gravity * std::max(eigen.eigenvalues()[k], 0.0)), {shape.begin(), shape.end()}});
  }
  return chamber;
}

}  // namespace

std::vector<Chamber> section_modes(const Polygons& section, double level, double gravity, int count,
                                   const Across& across, int along) {
  if (!(gravity > 0) || !std::isfinite(gravity))
    throw BadParameters(
        fmt::format("first frequencies: the gravity is {:.6g} m/s^2; it must be greater than 0", gravity));
  for (const auto& polygon : section)
    for (const Vec<2>& r : polygon)
      if (across.revolved && r[0] < 0)
        throw BadParameters(fmt::format(
            "first frequencies: the profile has the radius {:.6g} m at height {:.6g} m; none may be negative", r[0],
            r[1]));
  const double infinity = std::numeric_limits<double>::infinity();
  const double longest = across.wave_number > 0 ? 0.6 / across.wave_number : infinity;
  std::vector<Chamber> chambers;
  for (const Outline& outline : liquid_below(level, section)) {
    const TriangleMesh mesh = mesh_of(outline, along > 0 ? along : 6 * count + 14, longest);
    const Elements elements = assemble(mesh, across);
    chambers.push_back(modes_of(elements, gravity, count, !(across.revolved ? across.m > 0 : across.wave_number > 0)));
  }
  return chambers;
}

}  // namespace seiche::solver::modes
