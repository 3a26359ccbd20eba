#include "verification/compare/slope_factors.h"

#include "meshes/evaluate.h"
#include "verification/exact/infinite_slope.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/lay_soils.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr int slices = 200;           ///< of the depth: the least factor lies within half a per cent of the thickness
constexpr double atmosphere = 100e3;  ///< Pa, of strength by suction

struct Place {
  double x = 0, angle = 0;
};

/// The middle of the steepest straight part of the surface.
std::optional<Place> steepest(const Geometry& geometry) {
  if (!std::holds_alternative<Slope>(geometry.shape) && !std::holds_alternative<GroundProfile>(geometry.shape))
    return {};
  const std::vector<double> x = stations(geometry);
  Place found;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double rise = surface_at(geometry, x[k]) - surface_at(geometry, x[k - 1]);
    const double angle = std::atan(std::abs(rise) / (x[k] - x[k - 1]));
    // Parts between stations of the base may be one straight line: the longest of equal ones would be as good.
    if (angle > found.angle + 1e-9) found = {0.5 * (x[k] + x[k - 1]), angle};
  }
  return found.angle > 0 ? std::optional(found) : std::nullopt;
}

bool frictional(const Soil& soil) {
  return soil.strength && soil.strength->law != Strength::Law::cam_clay;
}

/// chi of Bishop's stress.
double bishop(const Soil& soil, double saturation) {
  if (soil.bishop == Bishop::saturation || !soil.retention) return saturation;
  const auto [least, most] = std::visit(
      [](const auto& law) -> std::pair<double, double> {
        if constexpr (requires { law.s_min; })
          return {law.s_min, law.s_max};
        else
          return {law.saturation.back(), law.saturation.front()};
      },
      *soil.retention);
  return std::clamp((saturation - least) / (most - least), 0.0, 1.0);
}

exact::PlaneStrength strength_of(const Soil& soil, double suction) {
  const Strength& law = *soil.strength;
  exact::PlaneStrength strength{law.peak.friction, law.peak.dilatancy, law.peak.cohesion};
  if (law.law != Strength::Law::suction) return strength;
  strength.friction += law.friction_rate * suction / atmosphere;
  strength.cohesion += law.suction_cohesion * (1 - std::exp(-law.cohesion_rate * suction / atmosphere));
  return strength;
}

void lower(double value, double depth, double& least, double& at) {
  if (value < least) least = value, at = depth;
}

}  // namespace

std::optional<SlopeFactors> slope_factors(const Scene& scene, const meshes::Mesh& mesh,
                                          const meshes::Snapshot& snapshot) {
  const auto place = steepest(scene.geometry);
  if (!place || !scene.geometry.zones.empty() || !std::ranges::all_of(scene.soils, frictional)) return {};
  const double top = surface_at(scene.geometry, place->x), thickness = top - base_at(scene.geometry, place->x);
  const double g = gravity_magnitude(scene), sine = std::sin(place->angle), cosine = std::cos(place->angle);
  const double step = thickness / slices;
  const meshes::Evaluator at(mesh);
  const bool wet = scene.water && !snapshot.node_pressure.empty();
  const auto value = [&](const std::vector<double>& nodal, double depth) {
    return wet ? at(nodal, {place->x, top - depth, 0}) : 0.0;
  };
  constexpr double none = std::numeric_limits<double>::infinity();
  SlopeFactors found{place->x, place->angle, none, none, none};
  double above = 0, unused = 0;  // weight per horizontal area
  for (int k = 0; k < slices; ++k) {
    const double middle = (k + 0.5) * step, depth = (k + 1) * step;
    const auto soil =
        std::ranges::find(scene.soils, soil_at(scene, {place->x, top - middle, 0}, mesh.dim), &Soil::name);
    if (soil == scene.soils.end()) return {};
    const double water = wet ? soil->porosity * value(snapshot.node_saturation, middle) * scene.water->density : 0;
    above += ((1 - soil->porosity) * soil->grain_density + water) * g * step;
    // The lower end of a slice a hair inside of it: the last lies on the border of the mesh.
    const double here = depth - 1e-6 * step;
    const double pore = bishop(*soil, value(snapshot.node_saturation, here)) * value(snapshot.node_pressure, here);
    const exact::PlaneLoad load{above * cosine * cosine, above * cosine * sine, pore};
    const exact::PlaneStrength strength = strength_of(*soil, std::max(0.0, -pore));
    lower(exact::limit_safety(load, strength), depth, found.limit, found.limit_depth);
    lower(exact::davis_safety(load, strength), depth, found.davis, found.davis_depth);
    lower(exact::reduced_safety(load, strength), depth, found.reduced, unused);
  }
  return found;
}

}  // namespace wetfront::verification
