# Clouds of particles and tanks of still liquid, which unit tests and benchmarks share.
include_guard(GLOBAL)
find_package(GTest REQUIRED)
add_library(test_particles STATIC
  ${PROJECT_SOURCE_DIR}/tests/unit/solver/cloud.cpp ${PROJECT_SOURCE_DIR}/tests/unit/solver/still_tank.cpp)
target_link_libraries(test_particles PRIVATE seiche::options seiche::solver GTest::gtest)
