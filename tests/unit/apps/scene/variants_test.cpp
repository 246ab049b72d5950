#include "apps/scene/variants.hpp"

#include <gtest/gtest.h>

#include "apps/scene/scene_file.hpp"

namespace seiche::apps {
namespace {

Scene scene_of(const std::vector<std::string>& settings) {
  std::vector<Override> overrides;
  for (const std::string& each : settings) overrides.push_back(parse_set(each));
  return parse_scene("", "x.toml", overrides);
}

const Option* key(const char* section, const char* name) { return find_option(section, name); }

std::string label_of(const Scene& scene, const std::vector<const Option*>& keys) {
  return labels_of({&scene}, keys).at(0);
}

TEST(Names, OfVariantsAreLabelsAndFolders) {
  const Scene scene = scene_of({"method.kernel=KF3", "particles.spacing=0.005"});
  const auto kernel = key("method", "kernel"), spacing = key("particles", "spacing");
  EXPECT_EQ(label_of(scene, {kernel}), "KF3");
  EXPECT_EQ(folder_of(scene, {kernel}), "KF3");
  EXPECT_EQ(label_of(scene, {kernel, spacing}), "KF3, 5 mm");
  EXPECT_EQ(folder_of(scene, {kernel, spacing}), "KF3_spacing-0.005");
  EXPECT_EQ(folder_of(scene, {key("tank", "closed")}), "closed-true");
}

TEST(Names, InLabelsHaveUnits) {
  const Scene surge = scene_of({"motion.amplitude=0.005", "motion.type=surge", "fluid.depth=0.1"});
  EXPECT_EQ(label_of(surge, {key("motion", "amplitude")}), "amplitude 5 mm");
  EXPECT_EQ(label_of(scene_of({"motion.amplitude=4", "motion.type=roll"}), {key("motion", "amplitude")}),
            "amplitude 4 degrees");
  EXPECT_EQ(label_of(surge, {key("fluid", "depth")}), "depth 0.1 m");
  EXPECT_EQ(label_of(surge, {key("time", "end")}), "end 10 s");
  EXPECT_EQ(label_of(surge, {key("method", "radius_gradient")}), "radius gradient 2.6 l0");
}

TEST(Names, InLabelsLeaveOutWhatIsTheSameInAll) {
  const Scene a = scene_of({"method.kernel=KF1", "particles.spacing=0.02"});
  const Scene b = scene_of({"method.kernel=KF3", "particles.spacing=0.02"});
  const std::vector<const Option*> keys{key("particles", "spacing"), key("method", "kernel")};
  EXPECT_EQ(labels_of({&a, &b}, keys), (std::vector<std::string>{"KF1", "KF3"}));
  EXPECT_EQ(labels_of({&a}, keys), (std::vector<std::string>{"20 mm, KF1"})) << "nothing else to say";
}

TEST(Names, OfFoldersHaveSafeCharactersOnly) {
  Scene scene;
  scene.parameters.motion.file = "../a b/c:d.csv";
  EXPECT_EQ(folder_of(scene, {key("motion", "file")}), "file-..-a-b-c-d.csv");
}

TEST(Differences, AreKeysOfTheSimulationAlone) {
  const Scene a = scene_of({"method.kernel=KF3", "look.colour_map=turbo"}), b = scene_of({"method.kernel=KF4"});
  EXPECT_EQ(differences({&a, &b}), (std::vector<const Option*>{key("method", "kernel")}));
  EXPECT_TRUE(differences({&a, &a}).empty());
}

}  // namespace
}  // namespace seiche::apps
