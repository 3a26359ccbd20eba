/// What the reader makes of good scenes: values in SI, defaults, origins, laws, rain records.
#include "verification/scene/read.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace wetfront::verification {
namespace {

const std::filesystem::path cases = std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases";

/// Reads a text with `from` replaced by `to` in the seed column's first scene.
class Rewritten {
 public:
  Rewritten() {
    std::ifstream file(cases / "seed_column/scene_3e-5.toml");
    text_.assign(std::istreambuf_iterator<char>(file), {});
    std::filesystem::create_directories(folder_);
  }
  ~Rewritten() { std::filesystem::remove_all(folder_); }

  Rewritten& replace(const std::string& from, const std::string& to) {
    const auto at = text_.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text_.replace(at, from.size(), to);
    return *this;
  }
  /// Drops everything from `from` on: gates, when their quantities no longer exist.
  Rewritten& cut(const std::string& from) {
    text_.resize(text_.find(from));
    return *this;
  }
  Rewritten& file(const std::string& name, const std::string& contents) {
    std::ofstream(folder_ / name) << contents;
    return *this;
  }
  Scene read() {
    std::ofstream(folder_ / "scene.toml") << text_;
    return read_scene(folder_ / "scene.toml");
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("wetfront_read_" + std::to_string(getpid()));
  std::string text_;
};

TEST(ReadScene, SeedColumnInSi) {
  const Scene scene = read_scene(cases / "seed_column/scene_3e-5.toml");
  EXPECT_EQ(std::get<Column>(scene.geometry.shape).cells, 40);
  EXPECT_DOUBLE_EQ(std::get<Column>(scene.geometry.shape).height, 1.2);
  EXPECT_DOUBLE_EQ(scene.water->bulk_modulus, 2e8);
  EXPECT_DOUBLE_EQ(scene.water->viscosity, 1e-3);
  const auto& law = std::get<VanGenuchten>(*scene.soils.at(0).retention);
  EXPECT_DOUBLE_EQ(law.air_entry, 4350);
  EXPECT_DOUBLE_EQ(law.s_min, 0.087);
  EXPECT_FALSE(scene.soils[0].elastic);
  EXPECT_DOUBLE_EQ(std::get<HydrostaticStart>(scene.initial->pressure).suction_cap, 1e4);
  EXPECT_EQ(scene.rains.at(0).record.intensity, std::vector<double>{3e-5});
  EXPECT_EQ(scene.boundaries.at(0).water, WaterCondition::impermeable);
  EXPECT_EQ(scene.probes.at(1).position, (std::array<double, 3>{0, 0.6, 0}));
  EXPECT_EQ(scene.stages.at(0).scheme, Scheme::seepage);
  EXPECT_TRUE(scene.stages[0].until.of_filling);
  EXPECT_DOUBLE_EQ(scene.stages[0].until.value, 1.05);
  EXPECT_EQ(scene.comparison.times.size(), 3u);
  EXPECT_DOUBLE_EQ(scene.comparison.tolerances.at(0).value, 0.002);
  EXPECT_DOUBLE_EQ(scene.comparison.tolerances[0].at->value, 0.25);
}

TEST(ReadScene, OriginsPointIntoTheFile) {
  const Scene scene = read_scene(cases / "seed_column/scene_3e-5.toml");
  std::ifstream file(scene.path);
  std::string line;
  for (int i = 0; i < scene.rains.at(0).origin.line; ++i) std::getline(file, line);
  EXPECT_EQ(line, "[[rain]]");
  EXPECT_EQ(scene.rains[0].origin.text(),
            scene.path.string() + ":" + std::to_string(scene.rains[0].origin.line) + ":1");
}

TEST(ReadScene, DefaultsAreThoseOfSceneH) {
  const Scene scene = Rewritten().replace("bulk_modulus = \"0.2 GPa\"", "").replace("points_per_cell = 4", "").read();
  EXPECT_DOUBLE_EQ(scene.water->bulk_modulus, Water{}.bulk_modulus);
  EXPECT_EQ(scene.mpm.points_per_cell, MpmSettings{}.points_per_cell);
  const Stage stage = scene.stages.at(0), fresh;
  EXPECT_DOUBLE_EQ(stage.time_tolerance, fresh.time_tolerance);
  EXPECT_DOUBLE_EQ(stage.step_safety, fresh.step_safety);
  EXPECT_DOUBLE_EQ(stage.largest_step, fresh.largest_step);
  EXPECT_DOUBLE_EQ(stage.local_damping, fresh.local_damping);
  EXPECT_EQ(stage.backward_euler, fresh.backward_euler);
  EXPECT_EQ(scene.reference->cells, ReferenceSettings{}.cells);
  EXPECT_DOUBLE_EQ(scene.reference->tolerance, ReferenceSettings{}.tolerance);
}

/// ks = k rho g / mu: 3e-11 m2 * 1000 * 9.81 / 1e-3 Pa s = 2.943e-4 m/s.
TEST(ReadScene, ConductivityBecomesPermeability) {
  const Scene scene =
      Rewritten().replace("intrinsic_permeability = \"3e-11 m2\"", "saturated_conductivity = \"2.943e-4 m/s\"").read();
  EXPECT_NEAR(scene.soils.at(0).intrinsic_permeability, 3e-11, 1e-24);
}

TEST(ReadScene, RainSeriesAndCsvAreTheSameRecord) {
  const std::string hours = "times = [\"1 h\"]\n";
  const auto with = [&](const std::string& rain) {
    return Rewritten()
        .replace("intensity = \"3e-5 m/s\"", rain)
        .replace("\"105 % of filling\"", "\"2 h\"")
        .cut("times = ")
        .replace("[comparison]\n", "[comparison]\n" + hours)
        .file("rain.csv", "# gauge 7\ntime [h], intensity [mm/h]\n0, 100\n\n1, 0\n")
        .read()
        .rains.at(0)
        .record;
  };
  const meshes::RainRecord series = with(R"(series = [["0 s", "100 mm/h"], ["1 h", "0 mm/h"]])"),
                           csv = with("csv = \"rain.csv\"");
  EXPECT_EQ(series.start, (std::vector<double>{0, 3600}));
  EXPECT_EQ(csv.start, series.start);
  EXPECT_EQ(csv.intensity, series.intensity);
  EXPECT_DOUBLE_EQ(series.intensity[0], 0.1 / 3600);
}

TEST(ReadScene, ExponentialConductivityTakesTheScaleOfTheRetention) {
  const Scene scene = Rewritten()
                          .replace("law = \"van-genuchten\", air_entry = \"4.35 kPa\", lambda = 0.61",
                                   "law = \"exponential\", suction_scale = \"981 Pa\"")
                          .replace("law = \"mualem\"", "law = \"exponential\"")
                          .read();
  EXPECT_EQ(scene.soils.at(0).permeability, PermeabilityLaw::exponential);
  EXPECT_DOUBLE_EQ(scene.soils[0].permeability_suction_scale, 981);
}

TEST(ReadScene, DryAndDeformingScenes) {
  const Scene dry = read_scene(cases / "dry_column/scene.toml");
  EXPECT_FALSE(dry.water || dry.initial || dry.reference || dry.soils.at(0).retention || dry.stages.at(0).scheme);
  EXPECT_EQ(dry.boundaries.at(1).skeleton->axes, (std::array<bool, 3>{true, false, false}));
  const Scene deforming = read_scene(cases / "deforming_column/scene.toml");
  EXPECT_DOUBLE_EQ(deforming.soils.at(0).elastic->young, 1e7);
  EXPECT_EQ(deforming.stages.at(0).scheme, Scheme::implicit_drag);
}

const std::string slope =
    R"(slope = { length = "20 m", thickness = "1.2 m", angle = "30 deg", cells_along = 80, cells_over = 10 })";

TEST(ReadScene, Slope) {
  const std::string column = R"(column = { height = "1.2 m", cells = 40 })";
  const auto scene_with = [&](const std::string& probe) {
    return Rewritten()
        .replace(column, slope)
        .replace("elevation = \"0 m\"", probe)
        .replace("elevation = \"0.6 m\"", R"(at = ["10 m", "6 m"])")
        .replace("elevation = \"1.2 m\"", R"(at = ["20 m", "12 m"])")
        .replace("\"105 % of filling\"", "\"2 h\"")
        .cut("[reference]")
        .read();
  };
  const Scene scene = scene_with(R"(at = ["0 m", "0 m"])");
  EXPECT_NEAR(std::get<Slope>(scene.geometry.shape).angle, std::acos(-1.0) / 6, 1e-15);
  EXPECT_EQ(scene.probes.at(1).position, (std::array<double, 3>{10, 6, 0}));
  EXPECT_THROW(scene_with(R"(at = ["10 m", "5 m"])"), SceneError);  // the base is at 5.77 m there
  EXPECT_THROW(scene_with("elevation = \"0 m\""), SceneError);
}

TEST(ReadScene, MeshFileIsFoundBesideTheScene) {
  const Scene scene = Rewritten()
                          .replace(R"(column = { height = "1.2 m", cells = 40 })", "mesh = \"ground.msh\"")
                          .file("ground.msh", "$MeshFormat\n")
                          .replace("side = \"base\"", "side = \"bedrock\"")
                          .cut("[[probe]]")
                          .replace("water = \"impermeable\"\n", R"(water = "impermeable"
[[stage]]
name = "rain"
scheme = "seepage"
until = "2 h"
)")
                          .read();
  EXPECT_EQ(std::get<MeshFile>(scene.geometry.shape).path, scene.path.parent_path() / "ground.msh");
  EXPECT_EQ(scene.boundaries.at(0).side, "bedrock");
}

TEST(ReadScene, PrintedEquationsAreNamedVariants) {
  EXPECT_TRUE(read_scene(cases / "printed_equations/printed_mass_balance.toml").stages.at(1).printed_mass_balance);
  EXPECT_EQ(read_scene(cases / "printed_equations/printed_mualem.toml").soils.at(0).permeability,
            PermeabilityLaw::printed_mualem);
}

}  // namespace
}  // namespace wetfront::verification
