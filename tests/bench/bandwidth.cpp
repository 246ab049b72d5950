#include "tests/bench/bandwidth.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "solver/particles/chunks.hpp"
#include "solver/pressure/amg/sparse_row.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/stirred_tank.hpp"

namespace seiche::bench {
namespace {

template <class F>
double fastest(int repetitions, F run) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repetitions; ++k) {
    const double start = omp_get_wtime();
    run();
    best = std::min(best, omp_get_wtime() - start);
  }
  return best;
}

Numbers triad(int threads) {
  constexpr long size = 1L << 24;
  omp_set_num_threads(threads);
  // Not initialised, so that each page is first touched by the thread that works on it.
  const std::unique_ptr<double[]> a(new double[size]), b(new double[size]), c(new double[size]);
#pragma omp parallel for schedule(static)
  for (long i = 0; i < size; ++i) a[i] = 0, b[i] = 1, c[i] = 2;
  const double seconds = fastest(10, [&] {
#pragma omp parallel for schedule(static)
    for (long i = 0; i < size; ++i) a[i] = b[i] + 3 * c[i];
  });
  if (a[size / 2] != 7) throw std::runtime_error("the triad is wrong");
  return {{"bytes", 24.0 * size}, {"seconds", seconds}};
}

Numbers product(int threads) {
  omp_set_num_threads(threads);
  const StirredTank tank(200000);
  const solver::SparseView a = tank.pressure.matrix();
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(a.cols(), 0, 1);
  Eigen::VectorXd y(a.rows());
  // As AmgSolver multiplies.
  const int *start = a.outerIndexPtr(), *column = a.innerIndexPtr();
  const double seconds = fastest(50, [&] {
    solver::each_row(static_cast<int>(a.rows()),
                     [&](int i) { y[i] = solver::row_times(a.valuePtr(), column, start[i], start[i + 1], x.data()); });
  });
  const double rows = static_cast<double>(a.rows()), values = static_cast<double>(a.nonZeros());
  const double matrix = values * (sizeof(double) + sizeof(int)) + (rows + 1) * sizeof(int);
  return {{"bytes", matrix + 2 * rows * sizeof(double)}, {"seconds", seconds}};
}

}  // namespace

std::vector<Bandwidth> measure_bandwidth() {
  std::vector<Bandwidth> all;
  const auto add = [&](const std::string& name, int threads, const std::function<Numbers()>& measure) {
    Numbers found = in_child(measure);
    all.push_back({name, threads, found["bytes"], found["seconds"]});
  };
  for (int threads : {1, 2}) add("triad", threads, [&] { return triad(threads); });
  for (int threads : {1, 2}) add("sparse product", threads, [&] { return product(threads); });
  return all;
}

std::string bandwidth_csv(const std::vector<Bandwidth>& all) {
  std::string text = "kernel,threads,bytes,ms,GB_per_s,percent_of_triad\n";
  for (const Bandwidth& one : all) {
    const auto triad = std::find_if(all.begin(), all.end(), [&](const Bandwidth& other) {
      return other.name == "triad" && other.threads == one.threads;
    });
    text += fmt::format("{},{},{:.0f},{:.4g},{:.4g},{:.3g}\n", one.name, one.threads, one.bytes, 1e3 * one.seconds,
                        1e-9 * one.rate(), 100 * one.rate() / triad->rate());
  }
  return text;
}

}  // namespace seiche::bench
