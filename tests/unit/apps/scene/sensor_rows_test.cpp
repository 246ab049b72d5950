#include "apps/scene/sensor_rows.hpp"

#include <gtest/gtest.h>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "tests/facts.hpp"
#include "tests/unit/apps/errors_of.hpp"

namespace seiche::apps {
namespace {

TEST(SensorRows, StandForSensorsEvenlyApart) {
  const std::string text =
      "[[sensors.pressure]]\nname = \"wall\"\nfrom = [0, 0.02]\nto = [0, 0.1]\ncount = 5\nside = 0.01\n"
      "[[sensors.pressure]]\nname = \"roof\"\nx = 0.1\ny = 0.4\n";
  const Scene scene = parse_scene(text, "x.toml", {});
  const auto& sensors = scene.parameters.sensors.pressure;
  ASSERT_EQ(sensors.size(), 6U);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(sensors[k].name, "wall_" + std::to_string(k + 1));
    EXPECT_EQ(sensors[k].x, 0);
    EXPECT_NEAR(sensors[k].y, 0.02 + 0.02 * static_cast<double>(k), 1e-15);
    EXPECT_EQ(sensors[k].side, 0.01);
  }
  EXPECT_EQ(sensors[5].name, "roof");
  EXPECT_EQ(scene_hash(parse_scene(scene_text(scene), "x.toml", {})), scene_hash(scene))
      << "the scene's text has the sensors themselves";
}

TEST(SensorRows, OfGaugesComeFromTheCommandLineToo) {
  const Scene scene = parse_scene(
      "", "x.toml", {parse_set("sensors.gauge=[{name = \"g\", from = [0.1, 0], to = [0.5, 0], count = 3}]")});
  ASSERT_EQ(scene.parameters.sensors.gauge.size(), 3U);
  EXPECT_NEAR(scene.parameters.sensors.gauge[1].x, 0.3, 1e-15);
}

TEST(SensorRows, ThatWontDoAreToldWithTheirPlace) {
  const std::string row = "[[sensors.gauge]]\nname = \"g\"\nfrom = [0.1, 0]\n";
  EXPECT_TRUE(test::tells(errors_of(row), {"x.toml:1:1", "[[sensors.gauge]]", "from, to and count"}));
  EXPECT_TRUE(test::tells(errors_of(row + "to = [0.2, 0]\ncount = 1\n"), {"x.toml:5:9", "count", "2", "1000"}));
  EXPECT_TRUE(test::tells(errors_of(row + "to = [0.2]\ncount = 3\n"), {"x.toml:4:6", "to", "2 or 3 numbers"}));
  EXPECT_TRUE(test::tells(errors_of(row + "to = [0.2, 0]\ncount = 3\nx = 0.1\n"), {"x.toml:6:5", "x", "from"}));
  EXPECT_TRUE(test::tells(errors_of(row + "to = [0.2, 0]\ncount = 3\n[[sensors.gauge]]\nname = \"g_2\"\n"),
                          {"x.toml:7:8", "'g_2'"}));
}

}  // namespace
}  // namespace seiche::apps
