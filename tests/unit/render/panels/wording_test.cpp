#include "render/panels/wording.hpp"

#include <gtest/gtest.h>

#include "render/panels/compared_curves.hpp"
#include "tests/unit/render/synthetic_comparison.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

// What panels of runs with these labels say in a picture so wide.
Wording wording(int width, const std::string& reference, const std::vector<std::string>& labels) {
  auto variants = test::variants({}, labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) variants[i].label = labels[i];
  Look look;
  look.references = {test::reference()};
  look.references[0].label = reference;
  const auto curves = compared_curves(variants, look);
  const Needs needs{.width = width, .height = width * 9 / 16, .view_width = 0.66, .view_height = 0.46};
  return worded_layout(needs, variants, measured(curves)).second;
}

}  // namespace

TEST(Wording, InBriefIsOfLabelsTheValuesAlone) {
  EXPECT_EQ(brief("viscosity 0.001 m\u00b2/s, amplitude 20 mm"), "0.001 m\u00b2/s, 20 mm");
  EXPECT_EQ(brief("KF3, 10 mm, start impulsive"), "KF3, 10 mm, impulsive");
  EXPECT_EQ(brief("kf2 alpha 0.5, depth -1 m"), "0.5, -1 m");
  EXPECT_EQ(brief("KF5, 40 leaked"), "KF5, 40 leaked");
  EXPECT_EQ(brief(""), "");
}

TEST(Wording, IsAsFullAsThereIsRoomFor) {
  const std::vector<std::string> kernels{"KF1, 5 mm", "KF2, 5 mm", "KF3, 5 mm", "KF4, 5 mm", "KF5, 5 mm"};
  const Wording full = wording(1280, "VOF", kernels);
  EXPECT_FALSE(full.brief_labels || full.brief_notes);
  const Wording notes = wording(1280, "nonlinear potential theory", kernels);
  EXPECT_TRUE(!notes.brief_labels && notes.brief_notes);
  const std::string longest = "viscosity 0.001 m\u00b2/s, frequency 0.";
  const Wording both = wording(640, "VOF", {longest + "1 Hz", longest + "2 Hz", longest + "3 Hz"});
  EXPECT_TRUE(both.brief_labels && both.brief_notes);
}

TEST(Wording, OfADeviationTellsFromWhatUnlessInBrief) {
  const auto variants = test::variants({}, 2);
  Look look;
  look.references = {test::reference()};
  auto curves = compared_curves(variants, look);
  const SensorCurve* curve = measured(curves);
  ASSERT_EQ(curve, &curves[0]);
  EXPECT_EQ(note_of(curve, 0, 1, {}), "") << "no readings yet";
  for (SensorCurve& each : curves) record(each, test::readings(0, 1));
  const std::string full = note_of(curve, 0, 1, {});
  EXPECT_TRUE(full.ends_with(" mm RMS off nonlinear potential theory")) << full;
  EXPECT_EQ(note_of(curve, 0, 1, {.brief_labels = false, .brief_notes = true}), full.substr(0, full.find(" off")));
  EXPECT_EQ(note_of(nullptr, 0, 1, {}), "");
}
