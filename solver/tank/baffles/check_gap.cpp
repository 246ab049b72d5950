#include "solver/tank/baffles/check_gap.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

constexpr double narrowest = 2;  // [l0]

}  // namespace

template <int D>
void check_gap(const Vecs<D>& points, const Scalars& gap, double l0, double touching, bool closed,
               const std::string& what, const std::string& to_what) {
  const std::size_t count = gap.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool falls = (k == 0 && !closed) || gap[k] <= gap[(k + count - 1) % count];
    const bool rises = (k + 1 == count && !closed) || gap[k] <= gap[(k + 1) % count];
    const bool is_least = falls && rises;
    if (!is_least || gap[k] <= touching || gap[k] >= narrowest * l0 * (1 - 1e-6)) continue;
    std::string at;
    for (int a = 0; a < D; ++a) at += fmt::format("{}{:.6g}", a > 0 ? ", " : "", points[k][a]);
    throw BadParameters(
        fmt::format("the gap of {:.4g} m between {} at ({}) m and {} is {:.3g} spacings wide; a run needs 2: "
                    "take particles.spacing = {:.4g} or less, or close the gap",
                    gap[k], what, at, to_what, gap[k] / l0, gap[k] / narrowest));
  }
}

template void check_gap<2>(const Vecs<2>&, const Scalars&, double, double, bool, const std::string&,
                           const std::string&);
template void check_gap<3>(const Vecs<3>&, const Scalars&, double, double, bool, const std::string&,
                           const std::string&);

}  // namespace seiche::solver
