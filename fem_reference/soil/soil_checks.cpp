#include "fem_reference/soil/soil_checks.h"

#include "fem_reference/require.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// Heads ascend and end at 0; values do not fall and lie in (or at the ends of) [low, high].
void check_table(const std::vector<double>& head, const std::vector<double>& value, double low, double high,
                 const std::string& where) {
  require(head.size() == value.size() && head.size() >= 2, where, ": ", head.size(), " heads for ", value.size(),
          " values (one each, at least two)");
  for (std::size_t i = 0; i < head.size(); ++i) {
    require(std::isfinite(head[i]) && (i == 0 || head[i] > head[i - 1]), where, ".head[", i, "]: ", head[i],
            " (heads must ascend)");
    require(value[i] >= low && value[i] <= high && (i == 0 || value[i] >= value[i - 1]), where, "[", i, "]: ", value[i],
            " (values must not fall and lie within ", low, " to ", high, ")");
  }
  require(head.back() == 0, where, ".head: the last is ", head.back(), " (must be 0, saturation)");
}

void check_parameters(const VanGenuchten& law, const std::string& where) {
  require(positive(law.alpha), where, ".alpha: ", law.alpha, " (must be positive, in 1/m)");
  require(law.n > 1 && std::isfinite(law.n), where, ".n: ", law.n, " (van Genuchten's m = 1 - 1/n needs n > 1)");
  require(std::isfinite(law.air_entry) && law.air_entry >= 0, where, ".air_entry: ", law.air_entry,
          " (a suction is not negative, in m)");
}
void check_parameters(const ExponentialRetention& law, const std::string& where) {
  require(positive(law.alpha), where, ".alpha: ", law.alpha, " (must be positive, in 1/m)");
}
void check_parameters(const HaverkampRetention& law, const std::string& where) {
  require(positive(law.a), where, ".a: ", law.a, " (must be positive, in m^beta)");
  require(positive(law.beta), where, ".beta: ", law.beta, " (must be positive)");
}
void check_parameters(const HaverkampLogRetention& law, const std::string& where) {
  require(positive(law.a), where, ".a: ", law.a, " (must be positive)");
  require(positive(law.beta), where, ".beta: ", law.beta, " (must be positive)");
  require(positive(law.entry), where, ".entry: ", law.entry, " (must be positive, in m)");
}
void check_parameters(const BroadbridgeWhiteRetention& law, const std::string& where) {
  require(law.c > 1 && std::isfinite(law.c), where, ".c: ", law.c, " (must exceed 1)");
  require(positive(law.lambda), where, ".lambda: ", law.lambda, " (must be positive, in m)");
}

void check_contents(const Soil& soil, double theta_r, double theta_s, const std::string& where) {
  require(std::isfinite(theta_r) && theta_r >= 0, where, ".retention.theta_r: ", theta_r,
          " (a water content is not negative)");
  require(theta_s > theta_r && theta_s <= 1, where, ".retention.theta_s: ", theta_s,
          " (must exceed theta_r = ", theta_r, " and not 1)");
  require(soil.porosity == 0 || (soil.porosity >= theta_s && soil.porosity <= 1), where, ".porosity: ", soil.porosity,
          " (must be at least theta_s = ", theta_s, " and at most 1)");
}

void check_retention(const Soil& soil, const std::string& where) {
  if (const auto* table = std::get_if<TabulatedRetention>(&soil.retention)) {
    check_table(table->head, table->content, 0, 1, where + ".retention.content");
    check_contents(soil, table->content.front(), table->content.back(), where);
    return;
  }
  std::visit(
      [&](const auto& law) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(law)>, TabulatedRetention>) {
          check_contents(soil, law.theta_r, law.theta_s, where);
          check_parameters(law, where + ".retention");
        }
      },
      soil.retention);
}

void check_conductivity(const Soil& soil, const std::string& where) {
  require(positive(soil.saturated_conductivity), where, ".saturated_conductivity: ", soil.saturated_conductivity,
          " (must be positive, in m/s)");
  require(!std::holds_alternative<MualemConductivity>(soil.conductivity) ||
              std::holds_alternative<VanGenuchten>(soil.retention),
          where, ".conductivity: Mualem's closed form needs van Genuchten's retention curve");
  require(!std::holds_alternative<BroadbridgeWhiteConductivity>(soil.conductivity) ||
              std::holds_alternative<BroadbridgeWhiteRetention>(soil.retention),
          where, ".conductivity: Broadbridge and White's K(Se) needs their retention curve");
  if (const auto* law = std::get_if<ExponentialConductivity>(&soil.conductivity)) {
    require(positive(law->alpha), where, ".conductivity.alpha: ", law->alpha, " (must be positive, in 1/m)");
  }
  if (const auto* law = std::get_if<HaverkampConductivity>(&soil.conductivity)) {
    require(positive(law->a), where, ".conductivity.a: ", law->a, " (must be positive, in m^gamma)");
    require(positive(law->gamma), where, ".conductivity.gamma: ", law->gamma, " (must be positive)");
  }
  if (const auto* table = std::get_if<TabulatedConductivity>(&soil.conductivity)) {
    constexpr double least = 1e-300;  // its logarithm is interpolated
    check_table(table->head, table->relative, least, 1, where + ".conductivity.relative");
    require(table->relative.back() == 1, where, ".conductivity.relative: the last is ", table->relative.back(),
            " (must be 1, saturation)");
  }
}

}  // namespace

void check_soils(const RichardsProblem& problem) {
  require(problem.soils.size() == problem.mesh.region_names.size(), "soils: ", problem.soils.size(),
          " given (the mesh has ", problem.mesh.region_names.size(), " regions, one soil each)");
  for (std::size_t s = 0; s < problem.soils.size(); ++s) {
    const Soil& soil = problem.soils[s];
    const std::string where = entry("soils", s) + (soil.name.empty() ? "" : " '" + soil.name + "'");
    check_retention(soil, where);
    check_conductivity(soil, where);
    require(std::isfinite(soil.specific_storage) && soil.specific_storage >= 0, where,
            ".specific_storage: ", soil.specific_storage, " (must not be negative)");
    require(std::isfinite(soil.oedometer_modulus) && soil.oedometer_modulus >= 0, where,
            ".oedometer_modulus: ", soil.oedometer_modulus, " (must not be negative, in Pa; 0 is a rigid skeleton)");
    const auto& [xx, yy, zz, xy, yz, zx] = soil.anisotropy;
    const double determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
    require(xx > 0 && xx * yy > xy * xy && determinant > 0 && std::isfinite(determinant), where,
            ".anisotropy: not positive definite");
  }
}

}  // namespace wetfront::fem_reference
