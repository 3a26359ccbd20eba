#include "verification/translate/mpm_soil.h"

#include "verification/translate/initial_pressure.h"

#include <cmath>

namespace wetfront::verification {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

/// Laws in papers' units of head: a * (rho g unit)^power stands with suctions in Pa.
double for_suction(double a, double head_unit, double power, double unit_weight) {
  return a * std::pow(unit_weight * head_unit, power);
}

mpm::RetentionSpec retention_of(const Retention& retention, double unit_weight) {
  return std::visit(
      Overloaded{
          [](const VanGenuchten& law) -> mpm::RetentionSpec {
            return mpm::VanGenuchtenRetention{law.air_entry, law.lambda, law.s_min, law.s_max, law.cut_off};
          },
          [](const Exponential& law) -> mpm::RetentionSpec {
            return mpm::ExponentialRetention{law.suction_scale, law.s_min, law.s_max};
          },
          [&](const Haverkamp& law) -> mpm::RetentionSpec {
            return mpm::HaverkampRetention{for_suction(law.a, law.head_unit, law.beta, unit_weight), law.beta,
                                           law.s_min, law.s_max};
          },
          [&](const HaverkampLog& law) -> mpm::RetentionSpec {
            return mpm::HaverkampLogRetention{law.a, law.beta, law.head_unit * unit_weight, law.s_min, law.s_max};
          },
          [&](const BroadbridgeWhite& law) -> mpm::RetentionSpec {
            return mpm::BroadbridgeWhiteRetention{law.c, law.sorptive_length * unit_weight, law.s_min, law.s_max};
          },
          [](const TabulatedRetention& law) -> mpm::RetentionSpec {
            return mpm::PointsRetention{law.suction, law.saturation};
          }},
      retention);
}

mpm::PermeabilitySpec permeability_of(const Soil& soil, double unit_weight) {
  switch (soil.permeability) {
    case PermeabilityLaw::mualem:
      return mpm::MualemPermeability{};
    case PermeabilityLaw::printed_mualem:
      return mpm::PrintedMualemPermeability{};
    case PermeabilityLaw::mualem_of_saturation:
      return mpm::MualemOfSaturationPermeability{};
    case PermeabilityLaw::exponential:
      return mpm::ExponentialPermeability{soil.permeability_suction_scale};
    case PermeabilityLaw::constant:
      return mpm::ConstantPermeability{};
    case PermeabilityLaw::haverkamp:
      return mpm::HaverkampPermeability{
          for_suction(soil.haverkamp.a, soil.haverkamp.head_unit, soil.haverkamp.gamma, unit_weight),
          soil.haverkamp.gamma};
    case PermeabilityLaw::broadbridge_white:
      return mpm::BroadbridgeWhitePermeability{};
    case PermeabilityLaw::tabulated:
      break;
  }
  return mpm::PointsPermeability{soil.table.suction, soil.table.relative};
}

mpm::MohrCoulomb frictional(const FrictionalStrength& strength, const Origin& origin) {
  return {strength.friction, strength.cohesion, strength.dilatancy, strength.tension_cut_off, origin.text()};
}

mpm::SkeletonLaw law_of(const Soil& soil) {
  const Strength& strength = *soil.strength;
  const mpm::MohrCoulomb peak = frictional(strength.peak, strength.origin);
  switch (strength.law) {
    case Strength::Law::mohr_coulomb:
      return peak;
    case Strength::Law::softening:
      return mpm::SofteningMohrCoulomb{peak, frictional(strength.residual, strength.origin), strength.softening_range};
    case Strength::Law::suction:
      return mpm::SuctionMohrCoulomb{peak, strength.suction_cohesion, strength.cohesion_rate, strength.friction_rate};
    case Strength::Law::cam_clay:
      break;
  }
  mpm::ModifiedCamClay clay{};
  clay.critical_slope = strength.critical_slope;
  clay.compression = strength.compression;
  clay.swelling = strength.swelling;
  clay.void_ratio = soil.porosity / (1 - soil.porosity);
  clay.preconsolidation = strength.preconsolidation;
  clay.least_pressure = 1000;
  clay.origin = strength.origin.text();
  return clay;
}

/// The tensor of principal factors turned by an angle from x towards up.
std::array<double, 6> turned(const Anisotropy& a) {
  const double c = std::cos(a.angle), s = std::sin(a.angle);
  return {
      a.along * c * c + a.across * s * s, a.along * s * s + a.across * c * c, 1, (a.along - a.across) * s * c, 0, 0};
}

}  // namespace

mpm::Soil mpm_soil(const Scene& scene, const Soil& soil) {
  const double unit_weight = scene.water ? scene.water->density * gravity_magnitude(scene) : 0;
  mpm::Soil out;
  out.name = soil.name;
  out.porosity = soil.porosity;
  out.grain_density = soil.grain_density;
  out.intrinsic_permeability = soil.intrinsic_permeability;
  out.origin = soil.origin.text();
  if (soil.retention) {
    out.retention = retention_of(*soil.retention, unit_weight);
    out.permeability = permeability_of(soil, unit_weight);
  }
  if (soil.elastic) out.elastic = mpm::Elastic{soil.elastic->young, soil.elastic->poisson, soil.elastic->origin.text()};
  if (soil.strength) out.law = law_of(soil);
  out.earth_pressure_at_rest = soil.earth_pressure_at_rest;
  if (soil.anisotropy) out.anisotropy = turned(*soil.anisotropy);
  if (soil.specific_storage) out.storage = *soil.specific_storage / unit_weight / scene.mpm.water_softening;
  if (soil.bishop == Bishop::effective_saturation) out.bishop = mpm::Bishop::effective_saturation;
  return out;
}

}  // namespace wetfront::verification
