#include "verification/scene/reading.h"

#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

Retention read_retention(SectionReader& law) {
  const std::string name = law.choice("law");
  const double s_min = law.quantity("S_min"), s_max = law.quantity("S_max");
  if (s_min >= s_max)
    law.complain("S_min", {law.shown("S_min") + " is not below S_max", "the soil could hold no water that moves",
                           "Make S_min smaller than S_max."});
  Retention retention = VanGenuchten{std::nan(""), std::nan(""), s_min, s_max};
  if (name == "exponential") retention = Exponential{law.quantity("suction_scale"), s_min, s_max};
  if (name == "van-genuchten")
    retention = VanGenuchten{law.quantity("air_entry"), law.quantity("lambda"), s_min, s_max};
  return retention;
}

void read_permeability_law(SectionReader& law, Soil& soil) {
  const std::string name = law.choice("law");
  const bool van_genuchten = soil.retention && std::holds_alternative<VanGenuchten>(*soil.retention);
  if (name == "printed-mualem") soil.permeability = PermeabilityLaw::printed_mualem;
  if (name == "mualem-of-saturation") soil.permeability = PermeabilityLaw::mualem_of_saturation;
  if (name == "constant") soil.permeability = PermeabilityLaw::constant;
  if (name == "exponential") {
    soil.permeability = PermeabilityLaw::exponential;
    const bool own = law.has("suction_scale");
    const auto* retention = soil.retention ? std::get_if<Exponential>(&*soil.retention) : nullptr;
    if (own)
      soil.permeability_suction_scale = law.quantity("suction_scale");
    else if (retention)
      soil.permeability_suction_scale = retention->suction_scale;
    else
      law.missing("suction_scale", "only an exponential retention would provide one");
  } else if (name.find("mualem") != std::string::npos && soil.retention && !van_genuchten) {
    law.complain("law", {law.shown("law") + " does not fit the retention curve",
                         "Mualem's integral is known here for van-genuchten",
                         "Write law = \"exponential\", or change the retention."});
  }
}

void read_laws(SectionReader& reader, Soil& soil, bool wet) {
  if (!wet) {
    for (const char* name : {"intrinsic_permeability", "saturated_conductivity", "retention", "permeability"})
      reader.unused(name, "there is no [water] in this scene", "Remove it, or add [water].");
    return;
  }
  if (auto retention = reader.table("retention")) {
    soil.retention = read_retention(*retention);
    retention->finish();
  } else if (!reader.has("retention")) {
    reader.missing("retention", "with [water] the soil must say how much it holds at a suction");
  }
  if (auto law = reader.table("permeability")) {
    read_permeability_law(*law, soil);
    law->finish();
  } else if (!reader.has("permeability") && soil.retention && std::holds_alternative<Exponential>(*soil.retention)) {
    reader.complain("permeability",
                    {"[[soil]] has no 'permeability'", "the default, mualem, needs a van-genuchten retention",
                     "Add permeability = { law = \"exponential\" } or { law = \"constant\" }."});
  }
}

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

void read_skeleton(SectionReader& reader, Soil& soil) {
  const double young = reader.quantity("young"), poisson = reader.quantity("poisson");
  if (reader.has("young") && !reader.has("poisson"))
    reader.missing("poisson", "young makes the skeleton elastic, which takes both");
  if (!reader.has("young") && reader.has("poisson"))
    reader.unused("poisson", "without young the skeleton is rigid", "Remove it, or add young = \"10 MPa\".");
  if (reader.has("young")) soil.elastic = Elastic{young, poisson, reader.origin_of("young")};
}

}  // namespace

void read_geometry(Reading& reading) {
  auto section = section_of(reading.root, "geometry", reading.complaints);
  if (!section) return;
  Geometry& geometry = reading.scene.geometry;
  geometry.origin = section->origin();
  if (const std::string file = section->text("mesh"); !file.empty()) {
    const std::filesystem::path mesh = reading.scene.path.parent_path() / file;
    std::error_code error;
    if (!std::filesystem::is_regular_file(mesh, error))
      section->complain("mesh", {section->shown("mesh") + " cannot be read", "there is no file " + mesh.string(),
                                 "The path is relative to the scene's folder."});
    geometry.shape = MeshFile{mesh};
  }
  if (auto column = section->table("column")) {
    geometry.shape = Column{column->quantity("height"), column->count("cells")};
    column->finish();
  }
  if (auto slope = section->table("slope")) {
    geometry.shape = Slope{slope->quantity("length"), slope->quantity("thickness"), slope->quantity("angle"),
                           slope->count("cells_along"), slope->count("cells_over")};
    slope->finish();
  }
  section->finish();
}

void read_soils(Reading& reading) {
  Scene& scene = reading.scene;
  if (auto water = section_of(reading.root, "water", reading.complaints)) {
    scene.water = Water{water->quantity("density"), water->quantity("bulk_modulus"), water->quantity("viscosity"),
                        water->origin()};
    water->finish();
  }
  for (SectionReader& reader : sections_of(reading.root, "soil", reading.complaints)) {
    Soil soil;
    soil.name = reader.text("name");
    soil.porosity = reader.quantity("porosity");
    soil.grain_density = reader.quantity("grain_density");
    soil.intrinsic_permeability = std::nan("");
    read_laws(reader, soil, reading.wet());
    if (reading.wet()) read_conductivity(reader, soil, scene);
    read_skeleton(reader, soil);
    soil.origin = reader.origin();
    for (const Soil& other : scene.soils)
      if (!soil.name.empty() && other.name == soil.name)
        reader.complain("name",
                        {"a second soil is called '" + soil.name + "'",
                         "the first stands in line " + std::to_string(other.origin.line), "Give it another name."});
    const bool built_in = !std::holds_alternative<MeshFile>(scene.geometry.shape);
    if (built_in && scene.soils.size() == 1)
      reader.complain("name", {"a second soil has no place", "a column and a slope are made of one soil",
                               "Remove it, or give a mesh with regions."});
    scene.soils.push_back(soil);
    reader.finish();
  }
}

void read_initial(Reading& reading) {
  auto section = section_of(reading.root, "initial", reading.complaints);
  if (!section) {
    if (reading.wet())
      reading.complaints.add({1, 1},
                             {"the scene has no [initial]", "with [water] the pore pressure at the start must be known",
                              "Add [initial] with hydrostatic = { water_table = \"0 m\" } or uniform = \"-10 kPa\"."});
    return;
  }
  if (!reading.wet()) {
    for (const char* name : {"hydrostatic", "uniform"})
      section->unused(name, "there is no [water] in this scene", "Remove [initial], or add [water].");
    return;
  }
  InitialState state;
  state.origin = section->origin();
  if (auto hydrostatic = section->table("hydrostatic")) {
    const double cap = hydrostatic->quantity("suction_cap");
    state.pressure = HydrostaticStart{hydrostatic->quantity("water_table"),
                                      hydrostatic->has("suction_cap") ? cap : std::numeric_limits<double>::infinity()};
    hydrostatic->finish();
  }
  if (section->has("uniform")) state.pressure = UniformStart{section->quantity("uniform")};
  const auto& g = reading.scene.gravity;
  const bool weightless = section->has("hydrostatic") && g[0] == 0 && g[1] == 0 && g[2] == 0;
  if (weightless)
    section->complain("hydrostatic", {"a hydrostatic start needs gravity", "gravity is zero in this scene",
                                      "Write uniform = \"0 kPa\" instead."});
  if (!weightless) reading.scene.initial = state;
  section->finish();
}

}  // namespace wetfront::verification
