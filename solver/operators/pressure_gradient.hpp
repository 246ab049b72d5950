#pragma once
#include <variant>

#include "solver/operators/gradient.hpp"
#include "solver/operators/interactions.hpp"

namespace seiche::solver {

/// The pressure's gradient at fluid particles, by the model that the scene names.
class PressureGradient {
 public:
  explicit PressureGradient(GradientModel model) {
    switch (model) {
      case GradientModel::corrected:
        model_ = CorrectedGradient{};
        break;
      case GradientModel::minimum:
        model_ = MinimumGradient{};
        break;
      case GradientModel::plain:
        model_ = PlainGradient{};
        break;
    }
  }

  /// @param wall_slope, out as those of pressure_gradient()
  template <int D>
  void operator()(const Range<D>& range, const Vecs<D>* wall_slope, const State<D>& s, Vecs<D>& out) const {
    resize_kept(out, s.size());
    std::visit([&](auto model) { pressure_gradient(model, *range.pairs, range.ref.n0, wall_slope, s, out); }, model_);
  }

 private:
  std::variant<CorrectedGradient, MinimumGradient, PlainGradient> model_;
};

}  // namespace seiche::solver
