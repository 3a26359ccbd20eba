#include "verification/scene/csv_table.h"
#include "verification/scene/reading.h"

#include <cmath>

namespace wetfront::verification {
namespace {

void read_conductivity(SectionReader& reader, Soil& soil, const Scene& scene) {
  const bool both = reader.has("intrinsic_permeability") && reader.has("saturated_conductivity");
  if (both)
    reader.complain("saturated_conductivity", {"saturated_conductivity is given beside intrinsic_permeability",
                                               "they say the same thing in two ways", "Keep one of the two."});
  soil.intrinsic_permeability = reader.quantity("intrinsic_permeability");
  if (reader.has("saturated_conductivity")) {
    const double conductivity = reader.quantity("saturated_conductivity");
    const double gravity = std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    if (gravity == 0)
      reader.complain("saturated_conductivity",
                      {"a conductivity needs gravity", "k = Ks mu / (rho g), and g is zero here",
                       "Give intrinsic_permeability instead."});
    else if (!both && scene.water)
      soil.intrinsic_permeability = conductivity * scene.water->viscosity / (scene.water->density * gravity);
  } else if (!reader.has("intrinsic_permeability")) {
    reader.missing("intrinsic_permeability",
                   "with [water] the soil must say how easily water flows; saturated_conductivity does as well");
  }
}

void read_directions(SectionReader& reader, Soil& soil, const Reading& reading) {
  auto table = reader.table("anisotropy");
  if (!table) return;
  Anisotropy anisotropy{table->quantity("along"), table->quantity("across"), 0, table->quantity("angle"),
                        reader.origin_of("anisotropy")};
  anisotropy.sideways = table->has("sideways") ? table->quantity("sideways") : anisotropy.along;
  if (table->has("sideways") && reading.scene.geometry.dim() == 2)
    table->unused("sideways", "this ground lies in the plane x, y", "Remove it.");
  soil.anisotropy = anisotropy;
  table->finish();
}

void read_field(SectionReader& reader, Soil& soil, const Reading& reading) {
  auto table = reader.table("conductivity_field");
  if (!table) return;
  const std::string file = table->text("csv");
  const bool bilinear = table->choice("between") == "bilinear";
  if (!file.empty()) {
    PlaceTable field =
        read_places(reading.folder() / file, {"factor", "1"}, reading.scene.geometry.dim(), *table, "csv");
    for (const double factor : field.value)
      if (factor <= 0) {
        table->complain("csv", {"a factor in " + file + " is not positive", "it multiplies the conductivity",
                                "Write a small positive number for tight ground."});
        break;
      }
    if (bilinear && !field.bilinear && !field.value.empty())
      table->complain("between", {"the places in " + file + " form no grid", "bilinear needs one in x and y",
                                  "Write between = \"nearest\", or complete the grid."});
    field.bilinear = bilinear;
    soil.conductivity_field = field;
  }
  table->finish();
}

Soil read_one(SectionReader& reader, const Reading& reading) {
  Soil soil;
  soil.name = reader.text("name");
  soil.porosity = reader.quantity("porosity");
  soil.grain_density = reader.quantity("grain_density");
  soil.intrinsic_permeability = std::nan("");
  read_laws(reader, soil, reading);
  if (reading.wet()) {
    read_conductivity(reader, soil, reading.scene);
    read_directions(reader, soil, reading);
    read_field(reader, soil, reading);
    if (reader.has("specific_storage")) soil.specific_storage = reader.quantity("specific_storage");
  }
  read_soil_skeleton(reader, soil);
  soil.origin = reader.origin();
  return soil;
}

}  // namespace

void read_soils(Reading& reading) {
  Scene& scene = reading.scene;
  if (auto water = section_of(reading.root, "water", reading.complaints)) {
    scene.water = Water{water->quantity("density"), water->quantity("bulk_modulus"), water->quantity("viscosity"),
                        water->origin()};
    water->finish();
  }
  for (SectionReader& reader : reading.sections("soil")) {
    const Soil soil = read_one(reader, reading);
    for (const Soil& other : scene.soils)
      if (!soil.name.empty() && other.name == soil.name)
        reader.complain("name",
                        {"a second soil is called '" + soil.name + "'",
                         "the first stands in line " + std::to_string(other.origin.line), "Give it another name."});
    scene.soils.push_back(soil);
    reader.finish();
  }
  check_soil_names(reading);
}

}  // namespace wetfront::verification
