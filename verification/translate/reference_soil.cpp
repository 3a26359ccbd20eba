#include "verification/translate/reference_soil.h"

#include "verification/translate/initial_pressure.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

/// Heads [m] ascending to 0 from suctions [Pa] ascending from 0.
std::vector<double> heads_of(const std::vector<double>& suction, double unit_weight) {
  std::vector<double> head;
  for (auto s = suction.rbegin(); s != suction.rend(); ++s) head.push_back(*s == 0 ? 0.0 : -*s / unit_weight);
  return head;
}

fem::Retention retention(const Soil& soil, double unit_weight) {
  const double n = soil.porosity;
  return std::visit(
      Overloaded{[&](const VanGenuchten& law) -> fem::Retention {
                   return fem::VanGenuchten{n * law.s_min, n * law.s_max, unit_weight / law.air_entry,
                                            1 / (1 - law.lambda), law.cut_off / unit_weight};
                 },
                 [&](const Exponential& law) -> fem::Retention {
                   return fem::ExponentialRetention{n * law.s_min, n * law.s_max, unit_weight / law.suction_scale};
                 },
                 // a printed for another unit of length: a * unit^beta
                 [&](const Haverkamp& law) -> fem::Retention {
                   return fem::HaverkampRetention{n * law.s_min, n * law.s_max,
                                                  law.a * std::pow(law.head_unit, law.beta), law.beta};
                 },
                 [&](const HaverkampLog& law) -> fem::Retention {
                   return fem::HaverkampLogRetention{n * law.s_min, n * law.s_max, law.a, law.beta, law.head_unit};
                 },
                 [&](const BroadbridgeWhite& law) -> fem::Retention {
                   return fem::BroadbridgeWhiteRetention{n * law.s_min, n * law.s_max, law.c, law.sorptive_length};
                 },
                 [&](const TabulatedRetention& law) -> fem::Retention {
                   fem::TabulatedRetention table{heads_of(law.suction, unit_weight), law.saturation};
                   std::reverse(table.content.begin(), table.content.end());
                   for (double& content : table.content) content *= n;
                   return table;
                 }},
      *soil.retention);
}

/// The reference always computes what is right: research variants of the candidate (printed formulas, S in place
/// of the effective saturation) are compared with the corrected law.
fem::Conductivity conductivity(const Soil& soil, double unit_weight) {
  switch (soil.permeability) {
    case PermeabilityLaw::constant:
      return fem::ConstantConductivity{};
    case PermeabilityLaw::exponential:
      return fem::ExponentialConductivity{unit_weight / soil.permeability_suction_scale};
    case PermeabilityLaw::haverkamp:
      return fem::HaverkampConductivity{soil.haverkamp.a * std::pow(soil.haverkamp.head_unit, soil.haverkamp.gamma),
                                        soil.haverkamp.gamma};
    case PermeabilityLaw::broadbridge_white:
      return fem::BroadbridgeWhiteConductivity{};
    case PermeabilityLaw::tabulated: {
      fem::TabulatedConductivity table{heads_of(soil.table.suction, unit_weight), soil.table.relative};
      std::reverse(table.relative.begin(), table.relative.end());
      return table;
    }
    case PermeabilityLaw::mualem:
    case PermeabilityLaw::printed_mualem:
    case PermeabilityLaw::mualem_of_saturation:
      break;
  }
  return fem::MualemConductivity{};
}

/// E_oed = E (1 - nu) / ((1 + nu) (1 - 2 nu)).
double oedometer_modulus(const Elastic& elastic) {
  const double nu = elastic.poisson;
  return elastic.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
}

}  // namespace

fem::Soil reference_soil(const Scene& scene, const Soil& soil, int dim) {
  const double unit_weight = scene.water->density * gravity_magnitude(scene);
  fem::Soil out;
  out.name = soil.name;
  out.porosity = soil.porosity;
  out.retention = retention(soil, unit_weight);
  out.conductivity = conductivity(soil, unit_weight);
  out.saturated_conductivity = soil.intrinsic_permeability * unit_weight / scene.water->viscosity;
  out.specific_storage = soil.specific_storage.value_or(soil.porosity * unit_weight / scene.water->bulk_modulus);
  if (soil.anisotropy) {
    const Anisotropy& a = *soil.anisotropy;
    if (dim == 1)  // only the elevation is left: T_yy of the turned tensor
      out.anisotropy[0] = a.along * std::pow(std::sin(a.angle), 2) + a.across * std::pow(std::cos(a.angle), 2);
    else
      out.anisotropy = fem::principal_tensor(
          dim, dim == 2 ? std::array{a.along, a.across, 1.0} : std::array{a.along, a.sideways, a.across}, a.angle);
  }
  using Storage = ReferenceSettings::SkeletonStorage;
  const Storage storage = scene.reference ? scene.reference->skeleton : Storage::none;
  if (storage != Storage::none && soil.elastic) {
    out.oedometer_modulus = oedometer_modulus(*soil.elastic);
    out.bishop =
        storage == Storage::saturation ? fem::Soil::Bishop::saturation : fem::Soil::Bishop::effective_saturation;
  }
  return out;
}

}  // namespace wetfront::verification
