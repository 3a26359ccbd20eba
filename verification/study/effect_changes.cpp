// Which effects a study tries, and how each is left out or added.
#include "verification/study/cells_times.h"
#include "verification/study/effects.h"
#include "verification/study/scheme_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace wetfront::verification {
namespace {

using Settings = std::vector<Setting>;

class Changes {
 public:
  explicit Changes(const Scene& scene) : scene_(scene), deforms_(deforms(scene)) {}

  std::vector<EffectChange> all() {
    add("the scene as it is", true, "", {});
    add("cells half as large", true, "", cells_times(scene_, 2));
    if (scene_.water) {
      inertia();
      water();
    }
    skeleton();
    contact();
    return std::move(found_);
  }

 private:
  static std::string soil(std::size_t i) { return "soil[" + std::to_string(i) + "]."; }
  static std::string side(std::size_t i) { return "boundary[" + std::to_string(i) + "]."; }

  Settings for_soils(const std::string& key, const std::string& value) const {
    Settings settings;
    for (std::size_t i = 0; i < scene_.soils.size(); ++i) settings.push_back({soil(i) + key, value});
    return settings;
  }

  void add(const std::string& effect, bool called_for, const std::string& how, Settings settings) {
    EffectChange change{effect, called_for, how, {}};
    change.point.name = how.empty() ? effect : effect + (called_for ? " left out: " : " added: ") + how;
    change.point.settings = std::move(settings);
    found_.push_back(std::move(change));
  }

  /// Against a deforming skeleton the water's inertia is tried with two velocities alone.
  void inertia() {
    const Scheme now = *scene_.stages.back().scheme;
    const char* two = "water and skeleton with velocities of their own";
    if (now == Scheme::seepage) {
      if (!deforms_)
        add("inertia of the water", false, "semi-implicit in place of seepage",
            scheme_settings(scene_, "semi-implicit"));
      add(two, false, "implicit-drag in place of seepage", scheme_settings(scene_, "implicit-drag"));
      return;
    }
    add("inertia of the water", true, "seepage", scheme_settings(scene_, "seepage"));
    if (now == Scheme::semi_implicit)
      add(two, false, "implicit-drag", scheme_settings(scene_, "implicit-drag"));
    else if (!deforms_)
      add(two, true, "semi-implicit", scheme_settings(scene_, "semi-implicit"));
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
    else if (!std::holds_alternative<Column>(scene_.geometry.shape))  // there water has one way to go
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
    add("deformation of the skeleton", true, "a rigid skeleton", rigid());
    if (has_events(scene_))
      found_.back().by_nature = "the scene asks for failure or rest, which a rigid skeleton does not know";
    else if (!scene_.water)
      found_.back().by_nature = "the scene is dry, so that nothing else is computed";
    const bool bounded = std::ranges::any_of(scene_.soils, [](const Soil& soil) { return soil.strength.has_value(); });
    if (bounded)
      add("plasticity", true, "elastic soils", for_soils("strength", ""));
    else
      add("plasticity", false, "Mohr-Coulomb, 34 degrees, 1 kPa",
          for_soils("strength", "{ law = \"mohr-coulomb\", friction = \"34 deg\", cohesion = \"1 kPa\" }"));
    if (scene_.water) {
      Settings effective = for_soils("bishop", "effective-saturation");
      if (stores_skeleton()) effective.push_back({"reference.skeleton_storage", "effective-saturation"});
      add("suction stress by the effective saturation", false, "Bishop's chi = Se", effective);
    }
    if (scene_.stages.back().local_damping > 0)
      add("damping of the skeleton", true, "none", {{last_stage(scene_) + "local_damping", ""}});
    if (scene_.skeleton.b_bar) add("cure of volumetric locking", true, "none", {{"skeleton.locking", "none"}});
    if (!scene_.water && std::holds_alternative<Box>(scene_.geometry.shape) &&
        scene_.skeleton.shape == SkeletonSettings::Shape::linear)
      add("quadratic splines", false, "in place of linear shape functions", {{"skeleton.shape", "quadratic-spline"}});
  }

  /// Sides on which the body may slide and from which it may lift: without friction, and stuck.
  void contact() {
    Settings smooth, stuck;
    for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
      const auto& skeleton = scene_.boundaries[i].skeleton;
      if (!skeleton || skeleton->kind != SkeletonCondition::Kind::contact) continue;
      smooth.push_back({side(i) + "base_friction", "0 deg"});
      stuck.push_back({side(i) + "skeleton", "fixed"});
      stuck.push_back({side(i) + "base_friction", ""});
    }
    if (smooth.empty()) return;
    add("friction of the contact", true, "a smooth base, 0 degrees", smooth);
    add("slip on the contact", true, "stuck to the base", stuck);
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
    Settings plastic = soft;
    add("deformation of the skeleton", false, "E = 10 MPa, nu = 0.3", soft);
    for (const Setting& setting :
         for_soils("strength", "{ law = \"mohr-coulomb\", friction = \"34 deg\", cohesion = \"1 kPa\" }"))
      plastic.push_back(setting);
    add("plasticity", false, "the same with Mohr-Coulomb, 34 degrees, 1 kPa", plastic);
  }

  bool stores_skeleton() const {
    return scene_.reference && scene_.reference->skeleton != ReferenceSettings::SkeletonStorage::none;
  }

  /// What makes a scene's skeleton rigid: all that speaks of its deformation goes.
  Settings rigid() const {
    Settings settings;
    for (std::size_t i = 0; i < scene_.soils.size(); ++i)
      for (const char* key : {"young", "poisson", "strength", "bishop", "earth_pressure_at_rest"})
        settings.push_back({soil(i) + key, ""});
    for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
      if (!scene_.boundaries[i].water)
        settings.push_back({side(i) + "water", "impermeable"});  // a side must say something
      for (const char* key : {"velocity", "base_friction", "load", "traction", "skeleton"})
        settings.push_back({side(i) + key, ""});
    }
    for (std::size_t i = 0; i < scene_.stages.size(); ++i)
      for (const char* key : {"skeleton", "coupling_tolerance", "unbalanced_ratio", "relaxation_damping",
                              "local_damping", "picture_every"})
        settings.push_back({"stage[" + std::to_string(i) + "]." + key, ""});
    for (std::size_t i = scene_.riders.size(); i-- > 0;) settings.push_back({"rider[" + std::to_string(i) + "]", ""});
    settings.push_back({"skeleton", ""});
    if (stores_skeleton()) settings.push_back({"reference.skeleton_storage", ""});
    return settings;
  }

  const Scene& scene_;
  bool deforms_;
  std::vector<EffectChange> found_;
};

}  // namespace

std::vector<EffectChange> effect_changes(const Scene& scene) {
  return Changes(scene).all();
}

std::vector<InseparableEffect> inseparable_effects(const Scene& scene) {
  const bool deforming = deforms(scene);
  const std::string nothing =
      "a rigid skeleton has none; it comes with the deformation of the skeleton, which is tried";
  std::vector<InseparableEffect> all{
      {"porosity change", deforming,
       deforming ? "the volume of a point is what its pores follow, and mass would not be kept without it" : nothing},
      {"finite rotation", deforming,
       deforming ? "every stress law turns the stress with the step, and without that a body that turns would strain"
                 : nothing}};
  const auto contact = [](const Boundary& boundary) {
    return boundary.skeleton && boundary.skeleton->kind == SkeletonCondition::Kind::contact;
  };
  if (std::ranges::none_of(scene.boundaries, contact))
    all.push_back({"contact friction", false, "no side of the scene is in contact (skeleton = \"contact\")"});
  return all;
}

std::vector<EffectChange> affordable(const Scene& scene, std::vector<EffectChange> changes, double budget) {
  const auto costs = [&](const EffectChange& change) { return expected_cpu(scene.path, change.point); };
  const std::size_t count = changes.size();
  std::map<double, std::size_t> base_of;
  for (std::size_t i = 2; i < count; ++i) {
    if (costs(changes[i]) <= budget) continue;
    for (const double factor : {0.5, 0.25}) {
      const Settings coarse = cells_times(scene, factor);
      if (coarse.empty()) continue;
      EffectChange tried = changes[i];
      tried.cells = factor;
      tried.point.settings.insert(tried.point.settings.end(), coarse.begin(), coarse.end());
      if (costs(tried) > budget) continue;
      tried.point.name += fmt::format(", cells {:g} times as large", 1 / factor);
      if (!base_of.contains(factor)) {
        base_of[factor] = changes.size();
        changes.push_back({fmt::format("cells {:g} times as large", 1 / factor), true, "", {}});
        changes.back().point = {changes.back().effect, coarse};
        changes.back().cells = factor;
      }
      tried.base = base_of[factor];
      changes[i] = std::move(tried);
      break;
    }
  }
  return changes;
}

}  // namespace wetfront::verification
