// One value of a scene set anew: the text changes there and nowhere else, and a path that leads nowhere is refused.
#include "verification/scene/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wetfront::verification {
namespace {

using testing::HasSubstr;

const std::string text = R"(title = "Zürich"  # ü counts as one column
gravity = ["0 m/s2", "-9.81 m/s2"]
[geometry]
column = { height = "1 m", cells = 40 }
[[soil]]
name = "sand"
porosity = 0.4  # kept
retention = { law = "van-genuchten", air_entry = "4.35 kPa", lambda = 0.61 }
[[soil]]
name = "clay 1.2"
porosity = 0.5
[[rain]]
side = "top"
intensity = "7.5e-5 m/s"   # steady
[[stage]]
scheme = "seepage"
until = "25 % of filling"
)";

std::string with(const std::string& setting) {
  return with_value(text, "scene.toml", read_setting(setting));
}
std::string replaced(std::string by, const std::string& what) {
  std::string out = text;
  out.replace(out.find(what), what.size(), by);
  return out;
}
std::string refusal(const std::string& setting) {
  try {
    with(setting);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(SetValue, ABareNumberKeepsTheUnit) {
  EXPECT_EQ(with("rain.intensity=2e-5"), replaced("\"2e-5 m/s\"", "\"7.5e-5 m/s\""));
  EXPECT_EQ(with("rain.intensity=10 mm/h"), replaced("\"10 mm/h\"", "\"7.5e-5 m/s\""));
  EXPECT_EQ(with("stage.until=50"), replaced("\"50 % of filling\"", "\"25 % of filling\""));
  EXPECT_EQ(with("gravity[1]=-1.62"), replaced("\"-1.62 m/s2\"", "\"-9.81 m/s2\""));
}

TEST(SetValue, NumbersChoicesAndTextStandAsTheScenesGrammarWantsThem) {
  EXPECT_EQ(with("soil[0].porosity=0.3"), replaced("porosity = 0.3", "porosity = 0.4"));
  EXPECT_EQ(with("soil.sand.porosity=30 %"), replaced("porosity = \"30 %\"", "porosity = 0.4"));
  EXPECT_EQ(with("soil[clay 1.2].porosity=0.3"), replaced("porosity = 0.3", "porosity = 0.5"));
  EXPECT_EQ(with("stage.0.scheme=semi-implicit"), replaced("\"semi-implicit\"", "\"seepage\""));
  EXPECT_EQ(with("geometry.column.cells=20"), replaced("cells = 20", "cells = 40"));
  EXPECT_EQ(with("soil.sand.retention.lambda=0.5"), replaced("lambda = 0.5", "lambda = 0.61"));
  EXPECT_EQ(with("title=7"), replaced("title = \"7\"", "title = \"Zürich\""));
}

TEST(SetValue, WhatTheSceneDoesNotSayIsAdded) {
  EXPECT_THAT(with("mpm.points_per_cell=9"), HasSubstr("\n\n[mpm]\npoints_per_cell = 9\n"));
  EXPECT_THAT(with("stage.time_tolerance=1e-3"), HasSubstr("[[stage]]\ntime_tolerance = 1e-3\nscheme"));
  EXPECT_THAT(with("soil.sand.anisotropy={ along = 2, across = 1 }"),
              HasSubstr("[[soil]]\nanisotropy = { along = 2, across = 1 }\nname = \"sand\""));
  EXPECT_THAT(with("soil.sand.retention.S_min=0.1"), HasSubstr("retention = { S_min = 0.1, law = \"van-genuchten\""));
}

TEST(SetValue, OneMoreOfWhatThereMayBeSeveralOf) {
  EXPECT_EQ(with("boundary[+]={ side = \"left\", water = \"impermeable\" }"),
            text + "\n[[boundary]]\n side = \"left\"\n water = \"impermeable\" \n");
  EXPECT_THAT(refusal("water[+]={ density = 1 }"), HasSubstr("nothing can be added like this"));
}

TEST(SetValue, NothingLeavesAKeyOut) {
  EXPECT_EQ(with("stage.scheme="), replaced("", "scheme = \"seepage\"\n"));
  EXPECT_EQ(with("soil.sand.retention.lambda="), replaced("", ", lambda = 0.61"));
  EXPECT_EQ(with("soil.sand.retention.law="), replaced("{  air", "{ law = \"van-genuchten\", air"));
}

TEST(SetValue, NothingLeavesASectionOut) {
  const std::string geometry = "[geometry]\ncolumn = { height = \"1 m\", cells = 40 }\n";
  EXPECT_EQ(with("geometry="), replaced("", geometry));
  EXPECT_EQ(with("skeleton="), text);
  EXPECT_EQ(with("soil[clay 1.2]="), replaced("", "[[soil]]\nname = \"clay 1.2\"\nporosity = 0.5\n"));
  EXPECT_EQ(with("stage[0]="), replaced("", "[[stage]]\nscheme = \"seepage\"\nuntil = \"25 % of filling\"\n"));
  const std::string below = text + "[[soil]]\nname = \"silt\"\n[soil.retention]\nlaw = \"van-genuchten\"\n# of what\n";
  EXPECT_EQ(with_value(below, "scene.toml", read_setting("soil.silt=")), text + "# of what\n");
  EXPECT_THAT(refusal("soil[sand]=0.4"), HasSubstr("this is a section"));
  EXPECT_THAT(refusal("soil="), HasSubstr("it is not said which [[soil]] is meant"));
}

TEST(SetValue, APathThatLeadsNowhereIsRefusedWithWhatThereIs) {
  EXPECT_EQ(refusal("rain.intensty=1"),
            "--set rain.intensty: there is no 'intensty' in [rain] (known are side, intensity, series or csv). Did you "
            "mean 'intensity'?");
  EXPECT_EQ(refusal("soil.porosity=1"),
            "--set soil.porosity: it is not said which [[soil]] is meant (the scene has 2). Write soil[sand] or "
            "soil[clay 1.2] and then the key.");
  EXPECT_THAT(refusal("soil[2].porosity=1"), HasSubstr("it is not said which [[soil]] is meant"));
  EXPECT_THAT(refusal("gravity[2]=1"), HasSubstr("there is no entry 2"));
  EXPECT_THAT(refusal("rain[0=1"), HasSubstr("no path"));
  EXPECT_THAT(refusal("rain"), HasSubstr("sets nothing"));
  EXPECT_THAT(refusal("rain.side.name=1"), HasSubstr("nothing lies below \"top\""));
  EXPECT_THAT(refusal("rains.intensity=1"), HasSubstr("Did you mean 'rain'?"));
}

TEST(SetValue, TheReaderComplainsOfTheValueAtItsPlace) {
  const std::filesystem::path scene =
      std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/seed_column/scene_7.5e-5.toml";
  EXPECT_DOUBLE_EQ(read_scene(scene, {{"rain.intensity", "2e-5"}}).rains.at(0).record.intensity.at(0), 2e-5);
  try {
    read_scene(scene, {{"soil.sand.porosity", "1.5"}});
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene_7.5e-5.toml:26:12: porosity = 1.5"));
  }
}

}  // namespace
}  // namespace wetfront::verification
