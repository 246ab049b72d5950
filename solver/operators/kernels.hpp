#pragma once
#include <array>
#include <cmath>
#include <string_view>
#include <variant>

// The five kernel functions of Table 1 (Pan, Zhang, Lu 2008). A kernel is a value: w(r), its support, name and source.
namespace seiche::solver {

/// w = r_e/r - 1. Singular at r = 0.
struct KF1 {
  static constexpr std::string_view name = "KF1";
  static constexpr std::string_view formula = "r_e/r - 1";
  static constexpr std::string_view source = "Ataie-Ashtiani & Farhadi 2006";
  double support;
  double operator()(double r) const { return r < support ? support / r - 1 : 0; }
};

/// w = exp(-(r/(alpha r_e))^2), cut at r_e, where it jumps by exp(-1/alpha^2): 0.895 with the paper's alpha = 3.
struct KF2 {
  static constexpr std::string_view name = "KF2";
  static constexpr std::string_view formula = "exp(-(r/(alpha r_e))^2)";
  static constexpr std::string_view source = "Ataie-Ashtiani & Farhadi 2006";
  double support;
  double alpha = 3.0;
  double operator()(double r) const {
    const double q = r / (alpha * support);
    return r <= support ? std::exp(-q * q) : 0;
  }
};

/// w = 1 - 6q^2 + 8q^3 - 3q^4 = (1 - q)^3 (1 + 3q), q = r/r_e.
struct KF3 {
  static constexpr std::string_view name = "KF3";
  static constexpr std::string_view formula = "1 - 6 q^2 + 8 q^3 - 3 q^4";
  static constexpr std::string_view source = "Ataie-Ashtiani & Farhadi 2006";
  double support;
  double operator()(double r) const {
    const double q = r / support, s = 1 - q;
    return r <= support ? s * s * s * (1 + 3 * q) : 0;
  }
};

/// Cubic spline: 2/3 - 4q^2 + 4q^3 up to q = 1/2, then 4/3 - 4q + 4q^2 - 4/3 q^3 = 4/3 (1 - q)^3.
struct KF4 {
  static constexpr std::string_view name = "KF4";
  static constexpr std::string_view formula = "2/3 - 4 q^2 + 4 q^3 (q <= 1/2); 4/3 (1 - q)^3 (q > 1/2)";
  static constexpr std::string_view source = "Ataie-Ashtiani & Farhadi 2006";
  double support;
  double operator()(double r) const {
    const double q = r / support, s = 1 - q;
    if (r > support) return 0;
    return q <= 0.5 ? 2. / 3 - 4 * q * q * s : 4. / 3 * s * s * s;
  }
};

/// w = 2 - (2q)^2 up to q = 1/2, then (2q - 2)^2. (The paper prints the second branch's lower end as r, not r/r_e.)
struct KF5 {
  static constexpr std::string_view name = "KF5";
  static constexpr std::string_view formula = "2 - (2 q)^2 (q <= 1/2); (2 q - 2)^2 (q > 1/2)";
  static constexpr std::string_view source = "Koshizuka & Oka 1996";
  double support;
  double operator()(double r) const {
    const double q = r / support, s = 2 * q - 2;
    if (r > support) return 0;
    return q <= 0.5 ? 2 - 4 * q * q : s * s;
  }
};

using Kernel = std::variant<KF1, KF2, KF3, KF4, KF5>;

/// Table 1 with supports r_e. A sixth kernel is one more entry here and in `Kernel`.
inline std::array<Kernel, std::variant_size_v<Kernel>> kernel_table(double support, double kf2_alpha = 3.0) {
  return {KF1{support}, KF2{support, kf2_alpha}, KF3{support}, KF4{support}, KF5{support}};
}

/// The kernel of the name that is wanted. Throws BadParameters.
Kernel find_kernel(std::string_view wanted, double support, double kf2_alpha);

inline std::string_view name(const Kernel& kernel) {
  return std::visit([](const auto& w) { return w.name; }, kernel);
}

}  // namespace seiche::solver
