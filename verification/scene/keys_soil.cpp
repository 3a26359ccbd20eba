#include "verification/scene/keys.h"

/// The table: soils.
namespace wetfront::verification {

// Ranges are wide on purpose: they catch slips of a unit or an exponent, not unusual soils.
// clang-format off
std::vector<Key> soil_keys() {
  constexpr auto required = Presence::required;
  constexpr auto optional = Presence::optional;
  const std::vector<std::string> van_genuchten = {"van-genuchten"}, exponential = {"exponential"}, tabulated = {"tabulated"};
  const std::vector<std::string> with_a = {"haverkamp", "vauclin", "haverkamp-log"}, with_theta = {"van-genuchten", "exponential", "haverkamp", "haverkamp-log", "vauclin", "broadbridge-white"};
  const std::vector<std::string> with_rest = {"van-genuchten", "exponential", "haverkamp", "haverkamp-log", "broadbridge-white"};
  const std::string pa = "Pa or m";
  return {
    {"soil", "name", Takes::text, "", required, "", "name; with a mesh file that of its region", "sand"},
    {"soil", "porosity", Takes::quantity, "1", optional, "", "volume of pores over volume; theta_s of the retention when absent", "0.46", {"0", "1", true, true}},
    {"soil", "grain_density", Takes::quantity, "kg/m3", optional, "2650 kg/m3", "density of the grains; that of quartz when absent", "2690 kg/m3", {"500 kg/m3", "20000 kg/m3"}},
    {"soil", "intrinsic_permeability", Takes::quantity, "m2", optional, "", "permeability of the saturated soil",
     "3e-11 m2", {"1e-22 m2", "1e-5 m2"}},
    {"soil", "saturated_conductivity", Takes::quantity, "m/s", optional, "", "the same as k rho g / mu", "2.9e-4 m/s", {"1e-16 m/s", "10 m/s"}},
    {"soil", "retention", Takes::table, "", optional, "", "water retention curve; needed with water",
     R"({ law = "van-genuchten", air_entry = "4.35 kPa", lambda = 0.61, S_min = 0.087, S_max = 1 })"},
    {"soil", "permeability", Takes::table, "", optional, "", "relative permeability; mualem when absent, after broadbridge-white theirs", R"({ law = "mualem" })"},
    {"soil", "anisotropy", Takes::table, "", optional, "", "conductivity that differs between directions", R"({ along = 10, across = 1, angle = "20 deg" })"},
    {"soil", "conductivity_field", Takes::table, "", optional, "", "conductivity that differs from place to place", R"({ csv = "field.csv", between = "bilinear" })"},
    {"soil", "specific_storage", Takes::quantity, "1/m", optional, "", "storage of the saturated soil; n rho g / K of the water when absent", "1e-4 1/m", {"0 1/m", "1 1/m"}},
    {"soil", "young", Takes::quantity, "Pa", optional, "", "Young's modulus of an elastic skeleton; rigid when absent", "10 MPa", {"1 Pa", "1000 GPa"}},
    {"soil", "bishop", Takes::choice, "", optional, "saturation", "Bishop's parameter chi of the effective stress sigma + chi p", "saturation", {}, {"saturation", "effective-saturation"}},
    {"soil", "poisson", Takes::quantity, "1", optional, "", "Poisson's ratio; needed with young", "0.3", {"0", "0.5", false, true}},
    {"soil", "strength", Takes::table, "", optional, "", "what bounds the stress of the skeleton; it stays elastic when absent", R"({ law = "mohr-coulomb", friction = "34 deg" })"},
    {"soil", "earth_pressure_at_rest", Takes::quantity, "1", optional, "", "K_0, effective horizontal over vertical stress at the start; poisson / (1 - poisson) when absent", "0.44", {"0", "10"}},

    {"soil.retention", "law", Takes::choice, "", required, "", "van Genuchten 1980 (Lee 2021, Eq. 5); Gardner 1958; Haverkamp 1977, sand, and Yolo clay (log); Vauclin 1979; Broadbridge and White 1988; or points",
     "van-genuchten", {}, {"van-genuchten", "exponential", "haverkamp", "haverkamp-log", "vauclin", "broadbridge-white", "tabulated"}},
    {"soil.retention", "air_entry", Takes::quantity, pa, optional, "", "p0 of Lee 2021, Eq. 5, which is rho g / alpha; with lambda", "4.35 kPa", {"0 Pa", "1 GPa", true}, {}, "law", van_genuchten},
    {"soil.retention", "lambda", Takes::quantity, "1", optional, "", "lambda = 1 - 1/n", "0.61", {"0", "1", true, true}, {}, "law", van_genuchten},
    {"soil.retention", "alpha", Takes::quantity, "1/m", optional, "", "alpha of van Genuchten (with n) or of Gardner, in terms of the suction head", "2.25 1/m", {"0 1/m", "1e6 1/m", true}, {}, "law", {"van-genuchten", "exponential"}},
    {"soil.retention", "n", Takes::quantity, "1", optional, "", "n, above 1", "2.56", {"1", "100", true}, {}, "law", van_genuchten},
    {"soil.retention", "cut_off", Takes::quantity, pa, optional, "0 Pa", "full up to this suction, the curve scaled to meet it there and Mualem's integral cut (Vogel 2001, Ippisch 2006)", "2 cm", {"0 Pa", "1 GPa"}, {}, "law", van_genuchten},
    {"soil.retention", "suction_scale", Takes::quantity, pa, optional, "", "p_c of S = S_min + (S_max - S_min) exp(-s/p_c), which is rho g / alpha", "0.98 kPa", {"0 Pa", "1 GPa", true}, {}, "law", exponential},
    {"soil.retention", "a", Takes::quantity, "1", required, "", "a of Se = a / (a + (h / head_unit)^beta), or with haverkamp-log a / (a + ln(h / head_unit)^beta)", "1.611e6", {"0", "1e30", true}, {}, "law", with_a},
    {"soil.retention", "beta", Takes::quantity, "1", required, "", "its exponent", "3.96", {"0", "100", true}, {}, "law", with_a},
    {"soil.retention", "head_unit", Takes::quantity, "m", optional, "1 cm", "the unit of suction head that a is printed for", "1 cm", {"1e-6 m", "1 km"}, {}, "law", with_a},
    {"soil.retention", "c", Takes::quantity, "1", required, "", "C of Broadbridge and White, above 1", "1.17", {"1", "1e6", true}, {}, "law", {"broadbridge-white"}},
    {"soil.retention", "sorptive_length", Takes::quantity, "m", required, "", "their lambda_s", "10 cm", {"0 m", "1 km", true}, {}, "law", {"broadbridge-white"}},
    {"soil.retention", "S", Takes::pairs, "", optional, "", "points: suction from 0, degree of saturation; a monotone smooth curve runs through them", R"([["0 kPa", 1], ["2 kPa", 0.9], ["100 kPa", 0.2]])", {}, {}, "law", tabulated,
     {{"suction", pa}, {"S", "1"}}},
    {"soil.retention", "theta", Takes::pairs, "", optional, "", "the same with volumetric water contents", R"([["0 cm", 0.43], ["20 cm", 0.39], ["10 m", 0.08]])", {}, {}, "law", tabulated,
     {{"suction", pa}, {"theta", "1"}}},
    {"soil.retention", "S_min", Takes::quantity, "1", optional, "", "residual degree of saturation; vauclin has none", "0.087", {"0", "1", false, true}, {}, "law", with_rest},
    {"soil.retention", "S_max", Takes::quantity, "1", optional, "", "largest degree of saturation; 1 when absent", "1", {"0", "1", true}, {}, "law", with_theta},
    {"soil.retention", "theta_r", Takes::quantity, "1", optional, "", "residual water content, S_min times the porosity", "0.04", {"0", "1", false, true}, {}, "law", with_rest},
    {"soil.retention", "theta_s", Takes::quantity, "1", optional, "", "largest water content, S_max times the porosity", "0.46", {"0", "1", true, true}, {}, "law", with_theta},

    {"soil.permeability", "law", Takes::choice, "", required, "",
     "mualem; printed-mualem is Lee 2021, Eq. 7 as printed and mualem-of-saturation takes S for Se: both are known defects, kept to show what they cost; the others as the retention curves of those names",
     "mualem", {}, {"mualem", "printed-mualem", "mualem-of-saturation", "exponential", "constant", "haverkamp", "vauclin", "broadbridge-white", "tabulated"}},
    {"soil.permeability", "suction_scale", Takes::quantity, pa, optional, "", "k_rel = exp(-s/scale); that of an exponential retention when absent", "0.98 kPa",
     {"0 Pa", "1 GPa", true}, {}, "law", exponential},
    {"soil.permeability", "alpha", Takes::quantity, "1/m", optional, "", "the same as k_rel = exp(-alpha h)", "10 1/m", {"0 1/m", "1e6 1/m", true}, {}, "law", exponential},
    {"soil.permeability", "a", Takes::quantity, "1", required, "", "a of k_rel = a / (a + (h / head_unit)^gamma)", "1.175e6", {"0", "1e30", true}, {}, "law", {"haverkamp", "vauclin"}},
    {"soil.permeability", "gamma", Takes::quantity, "1", required, "", "its exponent", "4.74", {"0", "100", true}, {}, "law", {"haverkamp", "vauclin"}},
    {"soil.permeability", "head_unit", Takes::quantity, "m", optional, "1 cm", "the unit of suction head that a is printed for", "1 cm", {"1e-6 m", "1 km"}, {}, "law", {"haverkamp", "vauclin"}},
    {"soil.permeability", "k_rel", Takes::pairs, "", required, "", "points: suction from 0, relative permeability from 1; a monotone smooth curve runs through their logarithms", R"([["0 cm", 1], ["20 cm", 0.3], ["10 m", 1e-6]])", {}, {}, "law", tabulated,
     {{"suction", pa}, {"k_rel", "1"}}},

    {"soil.anisotropy", "along", Takes::quantity, "1", required, "", "factor on the conductivity along the bedding", "10", {"1e-6", "1e6"}},
    {"soil.anisotropy", "across", Takes::quantity, "1", required, "", "factor across the bedding", "1", {"1e-6", "1e6"}},
    {"soil.anisotropy", "sideways", Takes::quantity, "1", optional, "", "factor in the third direction of a box in space; as along when absent", "10", {"1e-6", "1e6"}},
    {"soil.anisotropy", "angle", Takes::quantity, "rad", optional, "0 deg", "of the bedding over the horizontal, rising to the right", "20 deg", {"-90 deg", "90 deg"}},
    {"soil.conductivity_field", "csv", Takes::path, "", required, "", "file with the header `x [m], y [m], factor [-]`: factors on the conductivity at places (in space also z, after y)", "field.csv"},
    {"soil.conductivity_field", "between", Takes::choice, "", optional, "nearest", "the nearest place counts, or bilinear between places that form a grid in x and y; beyond the places the nearest", "bilinear", {}, {"nearest", "bilinear"}},
  };
}
// clang-format on

}  // namespace wetfront::verification
