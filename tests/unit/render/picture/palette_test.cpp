#include "render/picture/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Colours of curves, as seen by people with and without colour blindness.
using namespace seiche::render;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i] += m[i][j] * v[j];
  return out;
}

// On linear RGB: G.M. Machado, M.M. Oliveira, L.A.F. Fernandes, IEEE Trans. Vis. Comput. Graph. 15(6), 2009,
// severity 1.
const Matrix eyes[] = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

// CIE L*a*b*, D65.
Triple seen(Rgb colour, const Matrix& eye) {
  Triple linear;
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = colour[i] / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  linear = times(eye, linear);
  for (double& c : linear) c = std::clamp(c, 0.0, 1.0);
  const Matrix to_xyz{{{0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505},
                       {0.2126, 0.7152, 0.0722},
                       {0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089}}};
  Triple f = times(to_xyz, linear);
  for (double& t : f) t = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double distance(const Triple& a, const Triple& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

}  // namespace

TEST(Palette, ReferencesOfSeveralRunsAreNoRunsColour) {
  for (const Background background : {Background::white, Background::black}) {
    const Palette colours = palette_of_several(background);
    for (const Rgb& reference : colours.references) {
      EXPECT_TRUE(reference[0] == reference[1] && reference[1] == reference[2]) << "grey";
      EXPECT_GT(std::abs(seen(reference, eyes[0])[0] - seen(colours.background, eyes[0])[0]), 40);
      for (const Rgb& run : colours.runs) EXPECT_GT(distance(seen(reference, eyes[0]), seen(run, eyes[0])), 12);
    }
  }
}

TEST(Palette, RunsDifferForEveryEyeAndFromThePaper) {
  for (const Background background : {Background::white, Background::black, Background::transparent}) {
    const Palette colours = palette(background);
    for (const Matrix& eye : eyes)
      for (std::size_t i = 0; i < colours.runs.size(); ++i) {
        EXPECT_GT(std::abs(seen(colours.runs[i], eye)[0] - seen(colours.background, eye)[0]), 25)
            << seiche::name(background) << " " << i;
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GT(distance(seen(colours.runs[i], eye), seen(colours.runs[j], eye)), 12)
              << seiche::name(background) << " " << i << " and " << j;
      }
  }
}
