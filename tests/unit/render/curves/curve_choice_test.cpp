#include "render/curves/curve_choice.hpp"

#include <gtest/gtest.h>

using namespace seiche;
using namespace seiche::render;

namespace {

const std::vector<Column> sensors{{"p_left_bottom", "Pa", "pressure, left bottom", ColumnKind::pressure},
                                  {"eta_left", "m", "elevation, left", ColumnKind::elevation},
                                  {"eta_right", "m", "elevation, right", ColumnKind::elevation},
                                  {"surge", "m", "surge", ColumnKind::translation}};

std::vector<std::size_t> chosen(const std::string& curves, const std::vector<Reference>& references = {}) {
  Look look;
  look.curves = parse_curves(curves);
  look.references = references;
  return chosen_columns(look, sensors);
}

Reference beside(const std::string& sensor) {
  Reference reference;
  reference.of = sensor;
  return reference;
}

}  // namespace

TEST(CurveChoice, NamesStandInTheirOrder) {
  EXPECT_EQ(chosen("eta_right, p_left_bottom"), (std::vector<std::size_t>{2, 0}));
  EXPECT_EQ(chosen("surge"), (std::vector<std::size_t>{3}));
  EXPECT_TRUE(chosen("none").empty());
  EXPECT_THROW(chosen("eta"), std::invalid_argument);
}

TEST(CurveChoice, AutoTakesElevationPressureAndMotion) {
  EXPECT_EQ(chosen("auto"), (std::vector<std::size_t>{1, 0, 3}));
  EXPECT_EQ(chosen_columns(Look{}, {{"roof", "Pa", "pressure, roof", ColumnKind::pressure}}),
            (std::vector<std::size_t>{0}));
  EXPECT_TRUE(chosen_columns(Look{}, {}).empty());
}

TEST(CurveChoice, AutoPrefersWhatHasAReference) {
  EXPECT_EQ(chosen("auto", {beside("eta_right")}), (std::vector<std::size_t>{2, 0, 3}));
  EXPECT_EQ(chosen("auto", {beside("surge"), beside("surge"), beside("p_left_bottom")}),
            (std::vector<std::size_t>{3, 0, 1}));
}

TEST(CurveChoice, AListThatNoPictureCouldShowIsRefused) {
  for (const char* bad : {"", "a,", ",a", "a,,b", "a, b, c, d"}) EXPECT_THROW(parse_curves(bad), std::invalid_argument);
  EXPECT_EQ(parse_curves("auto"), std::nullopt);
  EXPECT_EQ(parse_curves(" a ,b"), (std::vector<std::string>{"a", "b"}));
  for (const char* text : {"auto", "none", "a", "a, b"}) EXPECT_EQ(text_of(parse_curves(text)), text);
}

TEST(CurveChoice, TitlesHaveUnitsAsWrittenByHand) {
  EXPECT_EQ(curve_title(sensors[0]), "pressure, left bottom [Pa]");
  EXPECT_EQ(curve_title({"volume", "m^3", "volume"}), "volume [m\u00b3]");
}
