#include "verification/scene/scene_template.h"

namespace wetfront::verification {
namespace {

const std::string head = R"toml(   # what the scene is there to show
gravity = ["0 m/s2", "-9.81 m/s2"]       # x, y; y is up

# Every value with a unit stands in quotation marks; any unit of the right kind will do ("100 mm/h", "3e-5 m/s").
# Nothing here switches physics on or off: what the scene contains is simulated, nothing else.
# All keys, units and defaults: verification/scene/SCENE.md. `wetfront explain` shows what a scene calls for.

)toml";

const std::string body = R"toml([geometry]                               # one of column, slope, profile, box, mesh
column = { height = "1.2 m", cells = 40 }
# slope = { length = "20 m", thickness = "1.2 m", angle = "30 deg", cells_along = 80, cells_over = 10 }
# mesh = "ground.msh"                    # your own; sides and soils are its physical groups

[water]                                  # leave it out, with all that is wet below, and the scene is dry
density = "1000 kg/m3"
bulk_modulus = "2.2 GPa"
viscosity = "1e-6 kPa s"

[[soil]]
name = "sand"
porosity = 0.46
grain_density = "2690 kg/m3"
intrinsic_permeability = "3e-11 m2"      # or saturated_conductivity = "2.9e-4 m/s"
retention = { law = "van-genuchten", air_entry = "4.35 kPa", lambda = 0.61, S_min = 0.087, S_max = 1 }
# retention = { law = "van-genuchten", alpha = "2.25 1/m", n = 2.56, theta_r = 0.04, theta_s = 0.46 }   # the same
permeability = { law = "mualem" }
# young = "10 MPa"                       # these two make the skeleton elastic; without them it is rigid
# poisson = 0.3

[initial]                                # or uniform = "-10 kPa", steady = { rain = "1 mm/h" }, ...
hydrostatic = { water_table = "0 m", suction_cap = "10 kPa" }

[[rain]]                                 # per horizontal area; what the soil does not take runs off
side = "top"
intensity = "100 mm/h"
# series = [["0 s", "100 mm/h"], ["1 h", "0 mm/h"]]
# csv = "rain.csv"                       # header: time [s], intensity [mm/h]

[[boundary]]                             # a side without rain and without this is impermeable
side = "base"
water = "impermeable"                    # or free-drainage, seepage-face, pressure (with pressure = "...")

[[probe]]                                # a gauge: pressure and saturation over time
name = "base"
elevation = "0 m"

[[stage]]
name = "infiltration"
scheme = "seepage"                       # or implicit-drag: with inertia, for short windows and for failure
until = "105 % of filling"               # or "2 h"; filling = storage deficit / rain

[mpm]
points_per_cell = 4

[reference]                              # the finite-element solution to compare with
cells = 320
tolerance = 1e-6

[comparison]
times = ["25 % of filling", "50 % of filling", "75 % of filling"]

[[tolerance]]                            # a gate; as many as you like
quantity = "pressure_l2"
value = "1 %"
reason = "to be replaced: say where your number comes from"

[[tolerance]]
quantity = "water_balance"
value = 1e-8
reason = "nodal sums are conserved to the residual of the Newton iteration"
)toml";

/// As a TOML basic string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20) continue;
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

}  // namespace

std::string headed_template(const std::string& name, const std::string& requirement) {
  return "# What this scene is and where its numbers come from (paper and section).\n\ntitle = " +
         quoted(name.empty() ? "New scene" : name) + "\nrequirement = " + quoted(requirement) + head;
}

std::string scene_template(const std::string& name) {
  return headed_template(name, "The MPM follows rain into this soil as Richards' equation does.") + body;
}

}  // namespace wetfront::verification
