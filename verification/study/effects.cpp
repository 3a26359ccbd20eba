#include "verification/study/effects.h"

#include "verification/compare/gates.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace wetfront::verification {
namespace {

using Settings = std::vector<Setting>;

class Changes {
 public:
  explicit Changes(const Scene& scene) : scene_(scene) {
    deforms_ = std::ranges::any_of(scene.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
  }

  std::vector<EffectChange> all() {
    add("the scene as it is", true, "", {});
    add("cells half as large", true, "", finer_cells());
    if (scene_.water) {
      inertia();
      water();
    }
    skeleton();
    return std::move(found_);
  }

 private:
  std::string stage() const { return "stage[" + std::to_string(scene_.stages.size() - 1) + "]."; }
  static std::string soil(std::size_t i) { return "soil[" + std::to_string(i) + "]."; }
  static std::string side(std::size_t i) { return "boundary[" + std::to_string(i) + "]."; }

  Settings for_soils(const std::string& key, const std::string& value) const {
    Settings settings;
    for (std::size_t i = 0; i < scene_.soils.size(); ++i) settings.push_back({soil(i) + key, value});
    return settings;
  }

  Settings finer_cells() const {
    const Shape& shape = scene_.geometry.shape;
    const auto twice = [](int cells) { return std::to_string(2 * cells); };
    if (const auto* column = std::get_if<Column>(&shape)) return {{"geometry.column.cells", twice(column->cells)}};
    if (const auto* slope = std::get_if<Slope>(&shape))
      return {{"geometry.slope.cells_along", twice(slope->cells_along)},
              {"geometry.slope.cells_over", twice(slope->cells_over)}};
    if (const auto* profile = std::get_if<GroundProfile>(&shape))
      return {{"geometry.profile.cells_along", twice(profile->cells_along)},
              {"geometry.profile.cells_over", twice(profile->cells_over)}};
    if (const auto* box = std::get_if<Box>(&shape)) {
      Settings settings;
      for (std::size_t i = 0; i < box->cells.size(); ++i)
        settings.push_back({"geometry.box.cells[" + std::to_string(i) + "]", twice(box->cells[i])});
      return settings;
    }
    throw SceneError({scene_.geometry.origin.text() +
                      ": the effects cannot be studied on a mesh of your own (what its cells leave open is not known). "
                      "Describe the ground by a shape."});
  }

  void add(const std::string& effect, bool called_for, const std::string& how, Settings settings) {
    EffectChange change{effect, called_for, how, {}};
    change.point.name = how.empty() ? effect : effect + (called_for ? " left out: " : " added: ") + how;
    change.point.settings = std::move(settings);
    found_.push_back(std::move(change));
  }

  void inertia() {
    const Scheme now = *scene_.stages.back().scheme;
    const auto scheme = [&](const char* name) {
      Settings settings{{stage() + "time_integrator", ""}};
      if (std::string(name) == "implicit-drag") settings.push_back({stage() + "time_tolerance", ""});
      settings.push_back({stage() + "scheme", name});
      return settings;
    };
    if (now == Scheme::seepage) {
      add("inertia of the water", false, "semi-implicit in place of seepage", scheme("semi-implicit"));
      add("water and skeleton with velocities of their own", false, "implicit-drag in place of seepage",
          scheme("implicit-drag"));
    } else {
      add("inertia of the water", true, "seepage", scheme("seepage"));
      if (now == Scheme::semi_implicit)
        add("water and skeleton with velocities of their own", false, "implicit-drag", scheme("implicit-drag"));
      else
        add("water and skeleton with velocities of their own", true, "semi-implicit", scheme("semi-implicit"));
    }
  }

  void water() {
    add("compressibility of the water", true, "a bulk modulus of 200 GPa", {{"water.bulk_modulus", "200 GPa"}});
    if (scene_.water->bulk_modulus < 2.1e9)
      add("softening of the water", true, "its true bulk modulus, 2.2 GPa", {{"water.bulk_modulus", "2.2 GPa"}});
    if (std::ranges::all_of(scene_.soils,
                            [](const Soil& soil) { return soil.permeability != PermeabilityLaw::constant; }))
      add("conductivity that falls with suction", true, "constant conductivity",
          for_soils("permeability", "{ law = \"constant\" }"));
    const bool van_genuchten = std::ranges::all_of(scene_.soils, [](const Soil& soil) {
      return soil.retention && std::holds_alternative<VanGenuchten>(*soil.retention);
    });
    if (van_genuchten) add("air entry", false, "full up to 2 cm of suction", for_soils("retention.cut_off", "2 cm"));
    const bool anisotropic =
        std::ranges::any_of(scene_.soils, [](const Soil& soil) { return soil.anisotropy.has_value(); });
    if (anisotropic)
      add("anisotropy", true, "the same conductivity along and across", for_soils("anisotropy", ""));
    else
      add("anisotropy", false, "twice the conductivity along the bedding",
          for_soils("anisotropy", "{ along = 2, across = 1 }"));
    if (std::ranges::any_of(scene_.soils, [](const Soil& soil) { return soil.conductivity_field.has_value(); }))
      add("conductivity that differs from place to place", true, "even", for_soils("conductivity_field", ""));
  }

  void skeleton() {
    if (!deforms_) {
      rigid_skeleton();
      return;
    }
    Settings rigid;
    for (std::size_t i = 0; i < scene_.soils.size(); ++i)
      for (const char* key : {"young", "poisson", "strength", "bishop", "earth_pressure_at_rest"})
        rigid.push_back({soil(i) + key, ""});
    for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
      if (scene_.boundaries[i].skeleton && !scene_.boundaries[i].water)
        rigid.push_back({side(i) + "water", "impermeable"});  // a side must say something
      rigid.push_back({side(i) + "skeleton", ""});
    }
    rigid.push_back({stage() + "local_damping", ""});
    add("deformation of the skeleton", true, "a rigid skeleton", rigid);
    const bool bounded = std::ranges::any_of(scene_.soils, [](const Soil& soil) { return soil.strength.has_value(); });
    if (bounded)
      add("plasticity", true, "elastic soils", for_soils("strength", ""));
    else
      add("plasticity", false, "Mohr-Coulomb, 34 degrees, 1 kPa",
          for_soils("strength", "{ law = \"mohr-coulomb\", friction = \"34 deg\", cohesion = \"1 kPa\" }"));
    if (scene_.water)
      add("suction stress by the effective saturation", false, "Bishop's chi = Se",
          for_soils("bishop", "effective-saturation"));
    if (scene_.stages.back().local_damping > 0)
      add("damping of the skeleton", true, "none", {{stage() + "local_damping", ""}});
    if (scene_.skeleton.b_bar) add("cure of volumetric locking", true, "none", {{"skeleton.locking", "none"}});
    if (scene_.skeleton.shape == SkeletonSettings::Shape::linear)
      add("quadratic splines", false, "in place of linear shape functions", {{"skeleton.shape", "quadratic-spline"}});
  }

  void rigid_skeleton() {
    if (!scene_.water || !std::holds_alternative<Column>(scene_.geometry.shape)) return;
    Settings soft = for_soils("young", "10 MPa");
    for (const Setting& setting : for_soils("poisson", "0.3")) soft.push_back(setting);
    std::set<std::string> told;
    for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
      told.insert(scene_.boundaries[i].side);
      if (scene_.boundaries[i].side == "base") soft.push_back({side(i) + "skeleton", "fixed"});
    }
    for (const char* flank : {"left", "right"})
      if (!told.contains(flank))
        soft.push_back({"boundary[+]", std::string("{ side = \"") + flank + "\", skeleton = \"roller\" }"});
    for (const char* key : {"time_integrator", "time_tolerance"}) soft.push_back({stage() + key, ""});
    Settings plastic = soft;
    soft.push_back({stage() + "scheme", "implicit-drag"});
    add("deformation of the skeleton", false, "E = 10 MPa, nu = 0.3, implicit-drag", soft);
    for (const Setting& setting :
         for_soils("strength", "{ law = \"mohr-coulomb\", friction = \"34 deg\", cohesion = \"1 kPa\" }"))
      plastic.push_back(setting);
    plastic.push_back({stage() + "scheme", "implicit-drag"});
    add("plasticity", false, "the same with Mohr-Coulomb, 34 degrees, 1 kPa", plastic);
  }

  const Scene& scene_;
  bool deforms_;
  std::vector<EffectChange> found_;
};

/// The narrowest gate on what the outcome is about, in its unit; without one 1 % of it.
double tolerance_on(const Scene& scene, const Outcome& outcome) {
  const double gate = gate_on(scene, outcome.name.substr(0, outcome.name.find_first_of("@:")), outcome.value);
  if (gate > 0) return gate;
  // Pressures near zero: half of what counts as arrival (compare/events.h).
  const double least = outcome.unit == "Pa" ? 100 : 0;
  return std::max(0.01 * std::abs(outcome.value), least);
}

}  // namespace

std::vector<EffectChange> effect_changes(const Scene& scene) {
  return Changes(scene).all();
}

std::vector<Influence> influences(const Scene& scene, const PointResult& base, const PointResult& finer,
                                  const PointResult& changed) {
  std::vector<Influence> all;
  for (const Outcome& outcome : base.candidate) {
    Influence one;
    one.outcome = outcome.description;
    const double other = value_of(changed.candidate, outcome.name), mesh = value_of(finer.candidate, outcome.name);
    if (std::isnan(outcome.value) && std::isnan(other)) continue;
    one.tolerance = tolerance_on(scene, outcome);
    one.change = other - outcome.value;
    one.uncertainty = std::abs(mesh - outcome.value);
    if (std::isnan(outcome.value) || std::isnan(other)) {
      one.need = Need::needed;  // an event that happens only with it, or only without it
    } else if (std::isnan(one.uncertainty)) {
      one.need = Need::undecided;
    } else {
      const double size = std::abs(one.change);
      one.need = size - one.uncertainty > one.tolerance    ? Need::needed
                 : size + one.uncertainty <= one.tolerance ? Need::not_needed
                 // A change of nothing needs no doubt: the mesh is the same in both runs.
                 : size <= 1e-3 * one.tolerance ? Need::not_needed
                                                : Need::undecided;
    }
    all.push_back(one);
  }
  return all;
}

Need overall_need(const std::vector<Influence>& influences) {
  if (influences.empty()) return Need::unknown;
  Need worst = Need::not_needed;
  for (const Influence& one : influences) {
    if (one.need == Need::needed) return Need::needed;
    if (one.need != Need::not_needed) worst = Need::undecided;
  }
  return worst;
}

}  // namespace wetfront::verification
