#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "solver/frame.hpp"
#include "solver/quantity.hpp"

namespace seiche::test {

template <class Value>
void expect_same_bits(const std::vector<Value>& a, const std::vector<Value>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  EXPECT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0) << what;
}

/// Of all but the readings, which files don't hold; floats bit by bit.
inline void expect_same_frame(const Frame& a, const Frame& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.pose.displacement, b.pose.displacement);
  EXPECT_EQ(a.pose.velocity, b.pose.velocity);
  EXPECT_EQ(a.pose.acceleration, b.pose.acceleration);
  EXPECT_EQ(a.pose.orientation.coeffs(), b.pose.orientation.coeffs());
  EXPECT_EQ(a.pose.omega, b.pose.omega);
  EXPECT_EQ(a.pose.alpha, b.pose.alpha);
  EXPECT_EQ(a.pose.pivot, b.pose.pivot);
  expect_same_bits(a.position, b.position, "position");
  expect_same_bits(a.velocity, b.velocity, "velocity");
  expect_same_bits(a.pressure, b.pressure, "pressure");
  expect_same_bits(a.number_density, b.number_density, "number_density");
  expect_same_bits(a.kind, b.kind, "kind");
  expect_same_bits(a.free_surface, b.free_surface, "free_surface");
  expect_same_bits(a.id, b.id, "id");
  ASSERT_EQ(a.derived.size(), b.derived.size());
  for (std::size_t k = 0; k < a.derived.size(); ++k) {
    EXPECT_EQ(a.derived[k].quantity, b.derived[k].quantity);
    expect_same_bits(a.derived[k].values, b.derived[k].values, "derived");
  }
}

}  // namespace seiche::test
