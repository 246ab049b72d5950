#pragma once
#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// Items sorted by where they are, so that the one nearest to a point is found without asking all.
template <int D>
class BoxTree {
 public:
  BoxTree() = default;

  /// @param boxes that hold the items, one each
  explicit BoxTree(const std::vector<Bounds<D>>& boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!boxes.empty()) build(boxes, 0, static_cast<int>(boxes.size()));
  }

  /// Asks the items that may be nearer to r than the nearest so far.
  /// @param least_squared of an item's number: asks it, and returns the least squared distance of all asked
  /// @param least squared distance from which on items are of no interest
  template <class LeastSquared>
  void search(const Vec<D>& r, LeastSquared least_squared,
              double least = std::numeric_limits<double>::infinity()) const {
    if (nodes_.empty()) return;
    visit(0, r, least, least_squared);
  }

 private:
  struct Node {
    Bounds<D> box;
    int first, last;             ///< of its items in the order
    int children[2] = {-1, -1};  ///< none at a leaf
  };

  int build(const std::vector<Bounds<D>>& boxes, int first, int last) {
    Bounds<D> all = boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(first)])];
    for (int k = first; k < last; ++k) {
      const Bounds<D>& box = boxes[static_cast<std::size_t>(order_[static_cast<std::size_t>(k)])];
      all.low = all.low.cwiseMin(box.low);
      all.high = all.high.cwiseMax(box.high);
    }
    const std::size_t place = nodes_.size();
    nodes_.push_back({all, first, last});
    if (last - first > 4) {
      int axis;
      all.size().maxCoeff(&axis);
      const auto middle = [&](int item) {
        const Bounds<D>& box = boxes[static_cast<std::size_t>(item)];
        return box.low[axis] + box.high[axis];
      };
      const int half = (first + last) / 2;
      std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                       [&](int a, int b) { return middle(a) < middle(b); });
      const int low = build(boxes, first, half), high = build(boxes, half, last);
      nodes_[place].children[0] = low;
      nodes_[place].children[1] = high;
    }
    return static_cast<int>(place);
  }

  double squared_distance_to(int node, const Vec<D>& r) const {
    const Bounds<D>& box = nodes_[static_cast<std::size_t>(node)].box;
    return (r - r.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
  }

  template <class LeastSquared>
  void visit(int place, const Vec<D>& r, double& least, LeastSquared& least_squared) const {
    const Node& node = nodes_[static_cast<std::size_t>(place)];
    if (node.children[0] < 0) {
      for (int k = node.first; k < node.last; ++k) least = least_squared(order_[static_cast<std::size_t>(k)]);
      return;
    }
    double off[2] = {squared_distance_to(node.children[0], r), squared_distance_to(node.children[1], r)};
    const int nearer = off[1] < off[0];
    for (const int child : {nearer, 1 - nearer})
      if (off[child] <= least) visit(node.children[child], r, least, least_squared);
  }

  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace seiche::solver
