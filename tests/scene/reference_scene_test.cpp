/// What the reader makes of what only the reference can solve: laws in terms of heads, layers, records in time, starts.
#include "verification/scene/read.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace wetfront::verification {
namespace {

constexpr double unit_weight = 9810;  // Pa/m

/// A small scene in a folder of its own, with files beside it.
class Small {
 public:
  Small() { std::filesystem::create_directories(folder_); }
  ~Small() { std::filesystem::remove_all(folder_); }

  std::string geometry = "column = { height = \"2 m\", cells = 20 }", initial = "uniform = \"-1 m\"", more;
  std::string soil =
      "retention = { law = \"van-genuchten\", alpha = \"0.02 1/cm\", n = 2.5, theta_r = 0.05, theta_s = 0.4 }";

  Small& file(const std::string& name, const std::string& contents) {
    std::ofstream(folder_ / name) << contents;
    return *this;
  }
  Scene read() {
    std::ofstream(folder_ / "scene.toml") << "title = \"small\"\n[geometry]\n"
                                          << geometry << "\n[water]\n[[soil]]\nname = \"sand\"\n"
                                          << "saturated_conductivity = \"1 cm/h\"\n"
                                          << soil << "\n[initial]\n"
                                          << initial << "\n"
                                          << more << "\n[[stage]]\nname = \"all\"\nuntil = \"1 d\"\n[reference]\n";
    return read_scene(folder_ / "scene.toml");
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("wetfront_small_" + std::to_string(getpid()));
};

TEST(ReferenceScene, HeadsBecomePressuresAndWaterContentsSaturations) {
  const Scene scene = Small().read();
  const Soil& soil = scene.soils.at(0);
  EXPECT_DOUBLE_EQ(soil.porosity, 0.4);
  const auto& law = std::get<VanGenuchten>(*soil.retention);
  EXPECT_DOUBLE_EQ(law.air_entry, unit_weight / 2);
  EXPECT_DOUBLE_EQ(law.lambda, 1 - 1 / 2.5);
  EXPECT_DOUBLE_EQ(law.s_min, 0.05 / 0.4);
  EXPECT_EQ(law.s_max, 1);
  EXPECT_DOUBLE_EQ(std::get<UniformStart>(scene.initial->pressure).pressure, -unit_weight);
  EXPECT_FALSE(scene.stages.at(0).scheme);
  EXPECT_EQ(scene.reference->cells, 320);
}

TEST(ReferenceScene, LessThanThePoresMayFill) {
  Small small;
  small.soil =
      "porosity = 0.5\nretention = { law = \"van-genuchten\", air_entry = \"50 cm\", n = 2, cut_off = \"2 cm\", "
      "theta_r = 0.05, theta_s = 0.4 }";
  const auto law = std::get<VanGenuchten>(*small.read().soils.at(0).retention);
  EXPECT_DOUBLE_EQ(law.s_max, 0.8);
  EXPECT_DOUBLE_EQ(law.air_entry, unit_weight / 2);
  EXPECT_DOUBLE_EQ(law.cut_off, unit_weight / 50);
}

TEST(ReferenceScene, LawsOfTheLiterature) {
  Small small;
  small.soil =
      "retention = { law = \"haverkamp\", a = 1.611e6, beta = 3.96, theta_r = 0.075, theta_s = 0.287 }\n"
      "permeability = { law = \"haverkamp\", a = 1.175e6, gamma = 4.74, head_unit = \"1 cm\" }";
  Soil soil = small.read().soils.at(0);
  EXPECT_DOUBLE_EQ(std::get<Haverkamp>(*soil.retention).head_unit, 0.01);
  EXPECT_EQ(soil.permeability, PermeabilityLaw::haverkamp);
  EXPECT_DOUBLE_EQ(soil.haverkamp.a, 1.175e6);
  small.soil =
      "retention = { law = \"broadbridge-white\", c = 1.17, sorptive_length = \"10 cm\", theta_r = 0, theta_s = 0.3 }";
  soil = small.read().soils.at(0);
  EXPECT_DOUBLE_EQ(std::get<BroadbridgeWhite>(*soil.retention).sorptive_length, 0.1);
  EXPECT_EQ(soil.permeability, PermeabilityLaw::broadbridge_white);
  small.soil =
      "retention = { law = \"vauclin\", a = 4e4, beta = 2.9, theta_s = 0.3 }\npermeability = { law = \"constant\" }";
  EXPECT_EQ(std::get<Haverkamp>(*small.read().soils.at(0).retention).s_min, 0);
}

TEST(ReferenceScene, CurvesByPointsInlineOrFromAFile) {
  Small small;
  small.soil =
      "retention = { law = \"tabulated\", theta = \"curve.csv\" }\n"
      "permeability = { law = \"tabulated\", k_rel = [[\"0 cm\", 1], [\"50 cm\", 0.1]] }";
  small.file("curve.csv", "# measured\nsuction [cm], theta [-]\n0, 0.4\n100, 0.1\n");
  const Soil soil = small.read().soils.at(0);
  const auto& table = std::get<TabulatedRetention>(*soil.retention);
  EXPECT_EQ(table.suction, (std::vector<double>{0, unit_weight}));
  EXPECT_EQ(table.saturation, (std::vector<double>{1, 0.25}));
  EXPECT_DOUBLE_EQ(soil.table.suction.at(1), unit_weight / 2);
}

TEST(ReferenceScene, RecordsInTime) {
  Small small;
  small.geometry = "box = { size = [\"4 m\", \"2 m\"], cells = [8, 4] }";
  small.file("level.csv", "time [d], level [m]\n0, 1\n2, 1.5\n");
  small.more = R"(
[[boundary]]
side = "left"
water = "water-level"
level = "level.csv"
[[boundary]]
side = "right"
water = "pressure"
pressure = [["0 h", "1 m"], ["1 h", "-2 kPa"]]
[[boundary]]
side = "base"
water = "flux"
inflow = "-36 mm/h"
[[evaporation]]
side = "top"
demand = [["0 d", "0 mm/d"], ["1 d", "86.4 mm/d"]]
)";
  const Scene scene = small.read();
  EXPECT_EQ(scene.boundaries.at(0).record.time, (std::vector<double>{0, 172800}));
  EXPECT_EQ(scene.boundaries[0].record.value, (std::vector<double>{1, 1.5}));
  EXPECT_EQ(scene.boundaries[1].record.value, (std::vector<double>{unit_weight, -2000}));
  EXPECT_DOUBLE_EQ(scene.boundaries[2].inflow.intensity.at(0), -1e-5);
  EXPECT_DOUBLE_EQ(scene.boundaries[2].least_pressure, -150 * unit_weight);
  EXPECT_DOUBLE_EQ(scene.evaporations.at(0).demand.intensity.at(1), 1e-6);
  EXPECT_EQ(scene.reference->cells, 4);
}

TEST(ReferenceScene, StartsByElevationPlaceAndRecord) {
  Small small;
  small.initial = "csv = \"start.csv\"";
  small.file("start.csv", "elevation [m], pressure [kPa]\n0, 0\n2, -8\n");
  const auto profile = std::get<ProfileStart>(small.read().initial->pressure);
  EXPECT_DOUBLE_EQ(interpolate(profile.elevation, profile.pressure, 0.5), -2000);
  small.geometry = "box = { size = [\"4 m\", \"2 m\"], cells = [8, 4] }";
  small.file("start.csv", "x [m], y [m], pressure [kPa]\n0, 0, 0\n4, 0, 4\n0, 2, -8\n4, 2, -4\n");
  const auto field = std::get<FieldStart>(small.read().initial->pressure);
  EXPECT_DOUBLE_EQ(field.pressure.at({1, 1, 0}), -3000);
  small.initial =
      "spin_up = { series = [[\"0 d\", \"1 mm/h\"]], duration = \"10 d\", water_table = \"0 m\", suction_cap = \"1 m\" "
      "}";
  const auto spin_up = std::get<SpinUpStart>(small.read().initial->pressure);
  EXPECT_EQ(spin_up.duration, 864000);
  EXPECT_EQ(spin_up.from.suction_cap, unit_weight);
}

TEST(PlaceTable, BilinearOnAGridNearestElsewhere) {
  PlaceTable table{{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, {0, 2, 10, 12}};
  EXPECT_TRUE(forms_grid(table.place));
  EXPECT_EQ(table.at({0.9, 0.1, 0}), 0);
  table.bilinear = true;
  EXPECT_DOUBLE_EQ(table.at({0.5, 0.5, 0}), 5.5);
  EXPECT_DOUBLE_EQ(table.at({-3, 9, 0}), 10);
  table.place.pop_back();
  EXPECT_FALSE(forms_grid(table.place));
}

TEST(Layers, BottomsFollowThicknessElevationAndLine) {
  Geometry geometry;
  geometry.shape = Slope{10, 2, std::atan(0.5), 10, 4};
  geometry.layers = {
      {"a", Layer::Thickness{0.5}, {}}, {"b", Polyline{{0, 10}, {0.5, 5.5}}, {}}, {"c", Layer::ToBase{}, {}}};
  const std::vector<double> bottoms = layer_bottoms(geometry, 4), expected = {3.5, 2.5, 2};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(bottoms.at(i), expected[i], 1e-12);
  geometry.layers[1].bottom = Layer::Elevation{1};
  EXPECT_DOUBLE_EQ(layer_bottoms(geometry, 4)[1], 1);
}

}  // namespace
}  // namespace wetfront::verification
