#pragma once
#include <functional>
#include <string>
#include <vector>

#include "apps/validate/bench.hpp"
#include "apps/validate/figure.hpp"
#include "render/outputs.hpp"

namespace seiche::apps::validate {

/// One chart of the page.
struct Chart {
  std::string title, x_label, y_label;
  std::vector<render::Curve> curves;
  render::Scales scales{};
};

/// What a case finds.
struct Findings {
  std::vector<Figure> figures;
  std::vector<Chart> charts;
};

/// A comparison of runs with something known. `run` throws Interrupted; anything else that it throws is its failure.
struct Case {
  std::string name;   ///< as in "still-tank"
  std::string shows;  ///< one line
  std::function<Findings(Bench&)> run;
};

}  // namespace seiche::apps::validate
