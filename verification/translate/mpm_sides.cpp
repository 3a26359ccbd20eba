#include "verification/translate/mpm_sides.h"

#include "verification/scene/weather.h"
#include "verification/translate/scene_mesh.h"

namespace wetfront::verification {
namespace {

const meshes::RainRecord dry{{0}, {0}};

class Sides {
 public:
  explicit Sides(const Scene& scene) : scene_(scene), surface_inside_cells_(!surface_inside_cells(scene).empty()) {}

  std::vector<mpm::WaterBoundary> all() {
    for (const Rain& rain : scene_.rains)
      if (!under_water(scene_, rain.side)) add_weather(rain.side, rain.origin, &rain);
    for (const Evaporation& evaporation : scene_.evaporations)
      if (!rain_on(scene_, evaporation.side)) add_weather(evaporation.side, evaporation.origin, nullptr);
    for (const Boundary& boundary : scene_.boundaries)
      if (boundary.water) add(boundary);
    return std::move(sides_);
  }

 private:
  /// Name of a side in the mesh of the points.
  std::string name(const std::string& side) const {
    return surface_inside_cells_ && side == "top" ? mpm::free_surface : side;
  }

  void add_weather(const std::string& side, const Origin& origin, const Rain* rain) {
    mpm::RainSide out{name(side), rain ? rain->record : dry, origin.text()};
    if (const Evaporation* evaporation = evaporation_from(scene_, side)) {
      out.evaporation = evaporation->demand;
      out.least_pressure = evaporation->least_pressure;
    }
    sides_.push_back(out);
  }

  void add_pressure(const Boundary& boundary) {
    mpm::PressureSide side{name(boundary.side), boundary.pressure, boundary.origin.text()};
    if (boundary.record.value.size() > 1) side.record = {boundary.record.time, boundary.record.value};
    sides_.push_back(side);
  }

  void add(const Boundary& boundary) {
    const std::string side = name(boundary.side), origin = boundary.origin.text();
    const mpm::TimeRecord record{boundary.record.time, boundary.record.value};
    switch (*boundary.water) {
      case WaterCondition::impermeable:
        return;
      case WaterCondition::free_drainage:
        sides_.push_back(mpm::FreeDrainageSide{side, origin});
        return;
      case WaterCondition::pressure:
        return add_pressure(boundary);
      case WaterCondition::seepage_face:
        sides_.push_back(mpm::RainSide{side, dry, origin});
        return;
      case WaterCondition::total_head:
        sides_.push_back(mpm::TotalHeadSide{side, record, origin});
        return;
      case WaterCondition::flux:
        sides_.push_back(mpm::FluxSide{side, boundary.inflow, boundary.least_pressure, origin});
        return;
      case WaterCondition::water_level: {
        const Rain* rain = rain_on(scene_, boundary.side);
        sides_.push_back(mpm::WaterLevelSide{side, record, rain ? rain->record : meshes::RainRecord{}, origin});
        return;
      }
      case WaterCondition::as_at_start: {
        mpm::PressureSide held{side, 0, origin};
        held.initial = true;
        sides_.push_back(held);
        return;
      }
      case WaterCondition::periodic:
        sides_.push_back(mpm::PeriodicSides{side, name(boundary.partner), origin});
    }
  }

  const Scene& scene_;
  bool surface_inside_cells_;
  std::vector<mpm::WaterBoundary> sides_;
};

}  // namespace

std::vector<mpm::WaterBoundary> mpm_sides(const Scene& scene) {
  return Sides(scene).all();
}

}  // namespace wetfront::verification
