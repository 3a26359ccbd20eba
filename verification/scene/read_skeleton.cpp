#include "verification/scene/reading.h"
#include "verification/scene/section_tables.h"

#include <cmath>
#include <map>

namespace wetfront::verification {
namespace {

FrictionalStrength read_friction(SectionReader& table, const std::string& prefix) {
  return {table.quantity(prefix + "friction"),
          table.quantity(prefix + "cohesion"),
          table.quantity(prefix + "dilatancy"),
          {}};
}

void check_dilatancy(SectionReader& table, const std::string& prefix, const FrictionalStrength& strength) {
  if (strength.dilatancy > strength.friction)
    table.complain(prefix + "dilatancy", {table.shown(prefix + "dilatancy") + " is above the friction angle",
                                          "such a soil would make work out of nothing",
                                          "Write at most the friction angle, which is associated flow."});
}

void read_clay(SectionReader& table, Strength& strength) {
  strength.critical_slope = table.quantity("critical_slope");
  strength.compression = table.quantity("compression");
  strength.swelling = table.quantity("swelling");
  strength.preconsolidation = table.quantity("preconsolidation");
  if (strength.swelling >= strength.compression)
    table.complain("swelling", {table.shown("swelling") + " is not below compression",
                                "a clay swells less than it was compressed", "Make swelling smaller."});
}

std::optional<Strength> read_strength(SectionReader& reader) {
  static const std::map<std::string, Strength::Law> laws = {{"mohr-coulomb", Strength::Law::mohr_coulomb},
                                                            {"softening-mohr-coulomb", Strength::Law::softening},
                                                            {"suction-mohr-coulomb", Strength::Law::suction},
                                                            {"modified-cam-clay", Strength::Law::cam_clay}};
  auto table = reader.table("strength");
  if (!table) return {};
  Strength strength;
  strength.origin = reader.origin_of("strength");
  const auto found = laws.find(table->choice("law"));
  if (found != laws.end()) {
    strength.law = found->second;
    if (strength.law == Strength::Law::cam_clay) {
      read_clay(*table, strength);
    } else {
      strength.peak = read_friction(*table, "");
      check_dilatancy(*table, "", strength.peak);
      if (table->has("tension_cut_off")) strength.peak.tension_cut_off = table->quantity("tension_cut_off");
    }
    if (strength.law == Strength::Law::softening) {
      strength.residual = read_friction(*table, "residual_");
      check_dilatancy(*table, "residual_", strength.residual);
      strength.softening_range = table->quantity("softening_range");
    }
    if (strength.law == Strength::Law::suction) {
      strength.suction_cohesion = table->quantity("suction_cohesion");
      strength.cohesion_rate = table->quantity("cohesion_rate");
      strength.friction_rate = table->quantity("friction_rate");
    }
  }
  table->finish();
  return strength;
}

}  // namespace

void read_soil_skeleton(SectionReader& reader, Soil& soil) {
  const double young = reader.quantity("young"), poisson = reader.quantity("poisson");
  if (reader.choice("bishop") == "effective-saturation") soil.bishop = Bishop::effective_saturation;
  soil.strength = read_strength(reader);
  if (reader.has("earth_pressure_at_rest")) soil.earth_pressure_at_rest = reader.quantity("earth_pressure_at_rest");
  if (!reader.has("young")) {
    reader.unused("bishop", "a rigid skeleton has no effective stress to speak of", "Remove it, or add young.");
    reader.unused("strength", "a rigid skeleton does not fail", "Remove it, or add young and poisson.");
    reader.unused("earth_pressure_at_rest", "a rigid skeleton has no stress to speak of", "Remove it, or add young.");
    reader.unused("poisson", "without young the skeleton is rigid", "Remove it, or add young = \"10 MPa\".");
    return;
  }
  if (!reader.has("poisson")) reader.missing("poisson", "young makes the skeleton elastic, which takes both");
  soil.elastic = Elastic{young, poisson, reader.origin_of("young")};
}

void read_skeleton(Reading& reading) {
  auto section = reading.section("skeleton");
  if (!section) return;
  SkeletonSettings& skeleton = reading.scene.skeleton;
  skeleton.origin = section->origin();
  skeleton.k0_stress = section->choice("initial_stress") == "k0";
  if (section->choice("shape") == "quadratic-spline") skeleton.shape = SkeletonSettings::Shape::quadratic_spline;
  const std::string update = section->choice("stress_update");
  if (update == "usf") skeleton.update = SkeletonSettings::Update::usf;
  if (update == "usl") skeleton.update = SkeletonSettings::Update::usl;
  skeleton.apic = section->choice("transfer") == "apic";
  skeleton.pic = section->quantity("pic");
  const std::string integration = section->choice("integration");
  if (integration == "mixed") skeleton.integration = SkeletonSettings::Integration::mixed;
  if (integration == "points") skeleton.integration = SkeletonSettings::Integration::points;
  skeleton.b_bar = section->choice("locking") == "b-bar";
  if (!reading.elastic())
    section->complain_at(section->place(), {"[skeleton] is not used", "every soil of this scene is rigid",
                                            "Remove it, or give the soil young and poisson."});
  section->finish();
}

namespace {

using Kind = SkeletonCondition::Kind;

struct Named {
  Kind kind;
  std::array<bool, 3> axes;
};
const std::map<std::string, Named>& conditions() {
  static const std::map<std::string, Named> known = {{"free", {Kind::free, {}}},
                                                     {"fixed", {Kind::fixed, {true, true, true}}},
                                                     {"fixed-x", {Kind::fixed, {true, false, false}}},
                                                     {"fixed-y", {Kind::fixed, {false, true, false}}},
                                                     {"roller", {Kind::fixed, {}}},
                                                     {"moving", {Kind::moving, {true, true, true}}},
                                                     {"moving-x", {Kind::moving, {true, false, false}}},
                                                     {"moving-y", {Kind::moving, {false, true, false}}},
                                                     {"contact", {Kind::contact, {}}},
                                                     {"absorbing", {Kind::absorbing, {}}},
                                                     {"periodic", {Kind::periodic, {}}}};
  return known;
}

std::array<bool, 3> roller_axes(SectionReader& reader, const std::string& side, const Scene& scene) {
  if (side == "left" || side == "right") return {true, false, false};
  if (std::holds_alternative<Column>(scene.geometry.shape)) return {false, true, false};
  reader.complain("skeleton",
                  {"a roller on '" + side + "' is not along an axis", "the side is inclined or its direction not known",
                   "Write \"fixed\", \"fixed-x\" or \"fixed-y\", or \"contact\" without friction."});
  return {};
}

}  // namespace

void read_skeleton_condition(SectionReader& reader, Boundary& boundary, const Reading& reading) {
  if (reader.has("skeleton")) {
    const std::string name = reader.choice("skeleton");
    SkeletonCondition condition;
    if (const auto found = conditions().find(name); found != conditions().end())
      condition = {found->second.kind, found->second.axes, {}, 0};
    if (name == "roller") condition.axes = roller_axes(reader, boundary.side, reading.scene);
    if (condition.kind == Kind::moving) {
      const std::vector<double> velocity = reader.vector("velocity");
      check_plane(reader, "velocity", velocity, reading.scene.geometry);
      for (std::size_t a = 0; a < velocity.size() && a < 3; ++a) condition.velocity[a] = velocity[a];
    }
    if (condition.kind == Kind::contact) condition.friction = std::tan(reader.quantity("base_friction"));
    if (condition.kind == Kind::periodic && boundary.partner.empty())
      boundary.partner = read_side(reader, reading, "partner");
    boundary.skeleton = condition;
  }
  if (reader.has("load")) {
    Rows rows = read_record(reader, "load", reading.folder());
    check_ascending(rows, 0, false, "the times of load");
    if (rows.size() > 0) boundary.load = Record{rows.column[0], rows.column[1]};
  }
  if (reader.has("traction")) {
    Rows rows = read_vectors(reader, "traction", reading.folder());
    check_ascending(rows, 0, false, "the times of traction");
    if (rows.size() > 0)
      boundary.traction = {Record{rows.column[0], rows.column[1]}, Record{rows.column[0], rows.column[2]}};
  }
  if (reading.elastic()) return;
  for (const char* key : {"skeleton", "load", "traction"})
    reader.unused(key, "every soil of this scene is rigid", "Remove it, or give the soil young and poisson.");
  boundary.skeleton.reset();
  boundary.load.reset();
  boundary.traction.reset();
}

}  // namespace wetfront::verification
