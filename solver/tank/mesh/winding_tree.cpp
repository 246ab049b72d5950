#include "solver/tank/mesh/winding_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace seiche::solver {
namespace {

using std::numbers::pi;

/// A piece is far from its distance in radii on.
constexpr double far = 2.5;
constexpr int leaf_size = 8;

}  // namespace

double solid_angle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot(cross(b, c)), below);
}

WindingTree::WindingTree(const Triangles& mesh) : mesh_(&mesh), order_(mesh.count()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) build(0, mesh.count());
}

int WindingTree::build(int first, int last) {
  Node node{Vec<3>::Zero(), Vec<3>::Zero(), 0, first, last};
  double area = 0;
  Bounds<3> box = mesh_->box(order_[first]);
  for (int k = first; k < last; ++k) {
    const int t = order_[k];
    const Vec<3> along = mesh_->area(t);
    const double size = along.norm();
    node.centre += size * mesh_->centre(t);
    node.area += along;
    area += size;
    const Bounds<3> one = mesh_->box(t);
    box.low = box.low.cwiseMin(one.low);
    box.high = box.high.cwiseMax(one.high);
  }
  node.centre = area > 0 ? Vec<3>(node.centre / area) : Vec<3>(0.5 * (box.low + box.high));
  for (int k = first; k < last; ++k)
    for (int corner = 0; corner < 3; ++corner)
      node.radius = std::max(node.radius, (mesh_->corner(order_[k], corner) - node.centre).norm());
  const int place = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  if (last - first > leaf_size) {
    int axis;
    box.size().maxCoeff(&axis);
    const int half = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                     [&](int a, int b) { return mesh_->centre(a)[axis] < mesh_->centre(b)[axis]; });
    const int low = build(first, half), high = build(half, last);
    nodes_[place].children[0] = low;
    nodes_[place].children[1] = high;
  }
  return place;
}

double WindingTree::number(const Vec<3>& r) const {
  double angle = 0;
  int open[64], count = 0;  // nodes: one a level at most waits, and levels halve
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    const Vec<3> off = node.centre - r;
    const double squared = off.squaredNorm();
    if (squared > far * far * node.radius * node.radius) {
      angle += node.area.dot(off) / (squared * std::sqrt(squared));
    } else if (node.children[0] >= 0) {
      open[count++] = node.children[0];
      open[count++] = node.children[1];
    } else {
      for (int k = node.first; k < node.last; ++k) {
        const int t = order_[k];
        angle += solid_angle(mesh_->corner(t, 0) - r, mesh_->corner(t, 1) - r, mesh_->corner(t, 2) - r);
      }
    }
  }
  return angle / (4 * pi);
}

}  // namespace seiche::solver
