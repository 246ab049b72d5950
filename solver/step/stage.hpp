#pragma once
#include <omp.h>

namespace seiche::solver {

/// Adds the time that it lives to a stage's total.
class Stage {
 public:
  explicit Stage(double& total) : total_(total), start_(omp_get_wtime()) {}
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() { total_ += omp_get_wtime() - start_; }

 private:
  double& total_;
  double start_;
};

}  // namespace seiche::solver
