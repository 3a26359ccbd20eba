#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// Least and largest saturation: S_min and S_max, or theta_r and theta_s over the porosity.
struct Limits {
  double s_min, s_max;
};

/// One of two ways to say a thing; "" when neither is given, complained of when both are.
std::string one_way(SectionReader& law, const std::string& a, const std::string& b) {
  if (law.has(a) && law.has(b))
    law.complain(b, {b + " is given beside " + a, "they say the same thing in two ways", "Keep one of the two."});
  return law.has(a) ? a : law.has(b) ? b : "";
}

/// The porosity is theta_s where the soil does not say it.
void take_porosity(SectionReader& reader, Soil& soil, double theta_s) {
  if (std::isnan(soil.porosity) && !reader.has("porosity")) soil.porosity = theta_s;
}

Limits read_limits(SectionReader& reader, SectionReader& law, const std::string& name, Soil& soil) {
  const std::string most = one_way(law, "S_max", "theta_s"), least = one_way(law, "S_min", "theta_r");
  const double theta_s = law.quantity("theta_s"), theta_r = law.quantity("theta_r");
  if (most == "theta_s") {
    take_porosity(reader, soil, theta_s);
    if (theta_s > soil.porosity)
      law.complain("theta_s", {law.shown("theta_s") + " is above the porosity",
                               fmt::format("the pores hold no more than {:g}", soil.porosity),
                               "Check both; a porosity may be left out, it is theta_s then."});
  }
  Limits limits{0, 1};
  if (most == "S_max") limits.s_max = law.quantity("S_max");
  if (most == "theta_s") limits.s_max = theta_s / soil.porosity;
  if (least == "S_min") limits.s_min = law.quantity("S_min");
  if (least == "theta_r") limits.s_min = theta_r / soil.porosity;
  if (least.empty() && name != "vauclin" && !name.empty())
    law.missing("S_min", "residual degree of saturation; theta_r does as well");
  if (limits.s_min >= limits.s_max)
    law.complain(least, {law.shown(least) + (most == "theta_s" ? " is not below theta_s" : " is not below S_max"),
                         "the soil could hold no water that moves", "Make " + least + " smaller."});
  return limits;
}

/// rho g / alpha, alpha in terms of heads [Pa].
double pressure_of(SectionReader& law, double alpha) {
  if (!(law.unit_weight() > 0))
    law.complain("alpha", {"alpha needs gravity", "it counts per head of water, and water weighs nothing here",
                           "Give air_entry or suction_scale as a pressure."});
  return law.unit_weight() / alpha;
}

VanGenuchten read_van_genuchten(SectionReader& law, Limits limits) {
  const std::string scale = one_way(law, "air_entry", "alpha"), shape = one_way(law, "lambda", "n");
  VanGenuchten out{std::nan(""), std::nan(""), limits.s_min, limits.s_max, law.quantity("cut_off")};
  if (scale == "air_entry") out.air_entry = law.quantity("air_entry");
  if (scale == "alpha") out.air_entry = pressure_of(law, law.quantity("alpha"));
  if (shape == "lambda") out.lambda = law.quantity("lambda");
  if (shape == "n") out.lambda = 1 - 1 / law.quantity("n");
  if (scale.empty()) law.missing("air_entry", "p0 of Lee 2021, Eq. 5, or alpha as in alpha = \"2.25 1/m\"");
  if (shape.empty()) law.missing("lambda", "lambda = 1 - 1/n, or n as in n = 2.56");
  return out;
}

double read_scale(SectionReader& law) {
  const std::string scale = one_way(law, "suction_scale", "alpha");
  if (scale == "alpha") return pressure_of(law, law.quantity("alpha"));
  return law.quantity("suction_scale");
}

/// Suctions ascend from 0, values do not rise and lie within (low, high].
void check_points(Rows& rows, const std::string& what, double low, double high) {
  if (rows.size() == 0) return;
  check_ascending(rows, 0, true, "the suctions");
  if (rows.column[0][0] != 0)
    rows.complain(0, {"the points do not start at suction 0", "there the soil is full", "Add that point."});
  if (rows.size() == 1) rows.complain(0, {"there is a single point", "a curve needs two", "Add points."});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double value = rows.column[1][i];
    if (!(value >= low && value <= high))
      rows.complain(i, {fmt::format("{} = {:g} is out of range", what, value),
                        fmt::format("it lies between {:g} and {:g}", low, high), "Check the unit."});
    if (i > 0 && value > rows.column[1][i - 1])
      rows.complain(i, {fmt::format("{} rises with suction", what),
                        fmt::format("{:g} follows {:g}", value, rows.column[1][i - 1]), "A drier soil has less."});
  }
}

Retention read_points(SectionReader& reader, SectionReader& law, Soil& soil, const Reading& reading) {
  const std::string given = one_way(law, "S", "theta");
  if (given.empty()) {
    law.missing("S", "tabulated needs points; theta does as well");
    return TabulatedRetention{};
  }
  Rows rows = read_pairs(law, given, reading.folder());
  if (given == "theta" && rows.size() > 0) take_porosity(reader, soil, rows.column[1][0]);
  check_points(rows, given, 0, given == "S" ? 1 : soil.porosity);
  if (rows.size() == 0) return TabulatedRetention{};
  TabulatedRetention table{rows.column[0], rows.column[1]};
  if (given == "theta")
    for (double& value : table.saturation) value /= soil.porosity;
  return table;
}

Retention read_retention(SectionReader& reader, SectionReader& law, Soil& soil, const Reading& reading) {
  const std::string name = law.choice("law");
  if (name == "tabulated") return read_points(reader, law, soil, reading);
  const Limits limits = read_limits(reader, law, name, soil);
  if (name == "exponential") {
    if (!law.has("suction_scale") && !law.has("alpha"))
      law.missing("suction_scale", "p_c of S = S_min + (S_max - S_min) exp(-s/p_c), or alpha as in alpha = \"10 1/m\"");
    return Exponential{read_scale(law), limits.s_min, limits.s_max};
  }
  if (name == "van-genuchten") return read_van_genuchten(law, limits);
  if (name == "haverkamp" || name == "vauclin")
    return Haverkamp{law.quantity("a"), law.quantity("beta"), law.quantity("head_unit"), limits.s_min, limits.s_max};
  if (name == "haverkamp-log")
    return HaverkampLog{law.quantity("a"), law.quantity("beta"), law.quantity("head_unit"), limits.s_min, limits.s_max};
  if (name == "broadbridge-white")
    return BroadbridgeWhite{law.quantity("c"), law.quantity("sorptive_length"), limits.s_min, limits.s_max};
  return VanGenuchten{std::nan(""), std::nan(""), limits.s_min, limits.s_max};
}

void read_exponential(SectionReader& law, Soil& soil) {
  const auto* retention = soil.retention ? std::get_if<Exponential>(&*soil.retention) : nullptr;
  if (law.has("suction_scale") || law.has("alpha"))
    soil.permeability_suction_scale = read_scale(law);
  else if (retention)
    soil.permeability_suction_scale = retention->suction_scale;
  else
    law.missing("suction_scale", "only an exponential retention would provide one");
}

void read_permeability_law(SectionReader& law, Soil& soil, const Reading& reading) {
  const std::string name = law.choice("law");
  const auto fits = [&]<class Law>(Law*) { return !soil.retention || std::holds_alternative<Law>(*soil.retention); };
  if (name == "printed-mualem") soil.permeability = PermeabilityLaw::printed_mualem;
  if (name == "mualem-of-saturation") soil.permeability = PermeabilityLaw::mualem_of_saturation;
  if (name == "constant") soil.permeability = PermeabilityLaw::constant;
  if (name == "exponential") {
    soil.permeability = PermeabilityLaw::exponential;
    read_exponential(law, soil);
  }
  if (name == "haverkamp" || name == "vauclin") {
    soil.permeability = PermeabilityLaw::haverkamp;
    soil.haverkamp = {law.quantity("a"), law.quantity("gamma"), law.quantity("head_unit")};
  }
  if (name == "tabulated") {
    soil.permeability = PermeabilityLaw::tabulated;
    Rows rows = read_pairs(law, "k_rel", reading.folder());
    check_points(rows, "k_rel", 1e-30, 1);
    if (rows.size() > 0 && rows.column[1][0] != 1)
      rows.complain(0, {"k_rel does not start at 1", "at suction 0 the conductivity is the saturated one",
                        "Divide the conductivities by the saturated one."});
    if (rows.size() > 0) soil.table = {rows.column[0], rows.column[1]};
  }
  if (name == "broadbridge-white") {
    soil.permeability = PermeabilityLaw::broadbridge_white;
    if (!fits(static_cast<BroadbridgeWhite*>(nullptr)))
      law.complain("law", {law.shown("law") + " does not fit the retention curve", "it is a function of theirs",
                           "Write law = \"broadbridge-white\" there too."});
  }
  if (name.find("mualem") != std::string::npos && !fits(static_cast<VanGenuchten*>(nullptr)))
    law.complain("law", {law.shown("law") + " does not fit the retention curve",
                         "Mualem's integral is known here for van-genuchten",
                         "Write law = \"exponential\", or change the retention."});
}

}  // namespace

void read_laws(SectionReader& reader, Soil& soil, const Reading& reading) {
  if (!reading.wet()) {
    for (const char* name : {"intrinsic_permeability", "saturated_conductivity", "retention", "permeability",
                             "anisotropy", "conductivity_field", "specific_storage"})
      reader.unused(name, "there is no [water] in this scene", "Remove it, or add [water].");
    if (!reader.has("porosity")) reader.missing("porosity", "volume of pores over volume");
    return;
  }
  if (auto retention = reader.table("retention")) {
    soil.retention = read_retention(reader, *retention, soil, reading);
    retention->finish();
  } else if (!reader.has("retention")) {
    reader.missing("retention", "with [water] the soil must say how much it holds at a suction");
  }
  if (std::isnan(soil.porosity) && !reader.has("porosity")) reader.missing("porosity", "volume of pores over volume");
  const bool van_genuchten = !soil.retention || std::holds_alternative<VanGenuchten>(*soil.retention);
  if (auto law = reader.table("permeability")) {
    read_permeability_law(*law, soil, reading);
    law->finish();
  } else if (!reader.has("permeability") && soil.retention &&
             std::holds_alternative<BroadbridgeWhite>(*soil.retention)) {
    soil.permeability = PermeabilityLaw::broadbridge_white;
  } else if (!reader.has("permeability") && !van_genuchten) {
    reader.complain("permeability",
                    {"[[soil]] has no 'permeability'", "the default, mualem, needs a van-genuchten retention",
                     "Add permeability = { law = \"exponential\" } or { law = \"constant\" }."});
  }
}

}  // namespace wetfront::verification
