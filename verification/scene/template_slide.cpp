#include "verification/scene/scene_template.h"

namespace wetfront::verification {
namespace {

const std::string body =
    R"toml([geometry]                               # a survey: lines of points, from left to right; sides: top, base, left, right
profile = { surface = [["0 m", "1 m"], ["3 m", "1 m"], ["9 m", "4.2 m"], ["12 m", "4.2 m"]], bedrock = [["0 m", "0 m"], ["3 m", "0 m"], ["9 m", "3.2 m"], ["12 m", "3.2 m"]], cells_along = 48, cells_over = 5, room = "1 m" }
# room: height of the empty cells above the surface that the sand may slide into

[water]
density = "1000 kg/m3"
bulk_modulus = "0.2 GPa"                 # softer than water's 2.2 GPa: longer steps in the slide, same pressures
viscosity = "1e-6 kPa s"

[[soil]]                                 # several, with a [[layer]] each: verification/cases/layered_slope
name = "sand"
porosity = 0.46
grain_density = "2690 kg/m3"
intrinsic_permeability = "3e-11 m2"      # or saturated_conductivity = "2.9e-4 m/s"
retention = { law = "van-genuchten", air_entry = "4.35 kPa", lambda = 0.61, S_min = 0.087, S_max = 1 }
permeability = { law = "mualem" }
young = "10 MPa"
poisson = 0.3
strength = { law = "mohr-coulomb", friction = "32 deg", cohesion = "0 kPa", dilatancy = "0 deg", tension_cut_off = "0 Pa" }
# dilatancy below zero: loose sand that shrinks when sheared slides much farther

[initial]                                # it decides when the slope fails: measure it, or run with two
uniform = "-5 kPa"                       # or hydrostatic = { water_table = "0 m", suction_cap = "10 kPa" }

[[rain]]                                 # per horizontal area; what the soil does not take runs off
side = "top"
intensity = "200 mm/h"
# series = [["0 s", "100 mm/h"], ["1 h", "0 mm/h"]]

[[boundary]]
side = "base"
water = "impermeable"
skeleton = "fixed"                       # or roller, or contact with a friction angle

[[boundary]]
side = "left"
water = "impermeable"                    # or seepage-face: water may leave at the toe
skeleton = "roller"

[[boundary]]
side = "right"
water = "impermeable"
skeleton = "roller"

[[probe]]                                # a gauge: pressure and saturation over time
name = "foot"
at = ["4 m", "0.75 m"]

[[rider]]                                # a point that rides on the surface: displacement and velocity
name = "marker"
at = ["7 m", "3 m"]

[skeleton]
initial_stress = "k0"
pic = 0.0005                             # damps what rings; the energy it takes is in the balance

[[stage]]
name = "infiltration"
scheme = "seepage"
skeleton = "quasi-static"
until = "6000 s"
ends_with = "failure"
time_tolerance = "1e-3"
coupling_tolerance = "1e-3"
picture_every = "300 s"

[[stage]]
name = "slide"
scheme = "seepage"
skeleton = "dynamic"
lasts = "60 s"
ends_with = "rest"
rest_energy = 5e-3
picture_every = "0.5 s"

[mpm]
points_per_cell = 4

[reference]                              # the finite-element solution to compare with, until failure
cells = 10                               # over the depth; 20 halves its own doubt and takes five times as long
skeleton_storage = "saturation"

[comparison]
times = ["500 s", "1000 s"]              # those after failure are left out
second_mesh = "coarser"                  # the slide on cells twice as large: what is numerical in it

[[tolerance]]                            # a gate; as many as you like
quantity = "pressure_l2"
value = "10 %"
reason = "to be replaced: here 5 % is what the reference itself does not know of the wetting front"

[[tolerance]]
quantity = "water_balance"
value = 1e-6
reason = "fluxes alone change the points' water: round-off and Newton's tolerance"

[[tolerance]]
quantity = "missed_events"
value = "1 %"
reason = "it fails, and what slides comes to rest"
)toml";

}  // namespace

std::string slide_template(const std::string& name) {
  return headed_template(name, "Rain soaks this slope until it fails; the slide is followed until it rests.") + body;
}

}  // namespace wetfront::verification
