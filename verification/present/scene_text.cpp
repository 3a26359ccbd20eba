#include "verification/present/scene_text.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

std::string limits(double s_min, double s_max) {
  return fmt::format(", S {:g} to {:g}", s_min, s_max);
}

/// A record of values in SI over `unit`, in words.
std::string record_text(const std::vector<double>& values, double unit, const std::string& name) {
  if (values.empty()) return "";
  if (values.size() == 1) return fmt::format(" {:.4g} {}", values[0] / unit, name);
  return fmt::format(" from a record of {} values, {:.4g} to {:.4g} {}", values.size(), values.front() / unit,
                     values.back() / unit, name);
}

}  // namespace

std::string geometry_text(const Geometry& geometry) {
  return std::visit(
      Overloaded{[](const Column& column) {
                   return fmt::format("column, {:g} m high, {} cells of {:g} m", column.height, column.cells,
                                      column.height / column.cells);
                 },
                 [](const Slope& slope) {
                   return fmt::format("slope, {:g} m long, {:g} m thick (vertical), {:g} degrees, {} x {} cells",
                                      slope.length, slope.thickness, slope.angle * 180 / M_PI, slope.cells_along,
                                      slope.cells_over);
                 },
                 [](const MeshFile& file) { return "mesh " + file.path.string(); },
                 [](const Box& box) {
                   std::string text = box.dim() == 3 ? "box" : "rectangle";
                   for (int i = 0; i < box.dim(); ++i)
                     text += fmt::format("{} {:g} m", i == 0 ? "," : " x", box.size[i]);
                   for (int i = 0; i < box.dim(); ++i) text += fmt::format("{} {}", i == 0 ? "," : " x", box.cells[i]);
                   return text + " cells";
                 },
                 [](const GroundProfile& profile) {
                   return fmt::format("profile from x = {:g} m to {:g} m, {} x {} cells", profile.surface.x.front(),
                                      profile.surface.x.back(), profile.cells_along, profile.cells_over);
                 }},
      geometry.shape);
}

std::string layer_text(const Layer& layer) {
  return '\'' + layer.soil + '\'' +
         std::visit(
             Overloaded{[](const Layer::ToBase&) { return std::string(", down to the base"); },
                        [](const Layer::Thickness& t) { return fmt::format(", {:g} m thick", t.value); },
                        [](const Layer::Elevation& e) { return fmt::format(", down to elevation {:g} m", e.value); },
                        [](const Polyline& line) {
                          return fmt::format(", down to a line from {:g} m to {:g} m", line.y.front(), line.y.back());
                        }},
             layer.bottom);
}

std::string extent_text(const Extent& extent) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    if (std::isfinite(extent.from[axis]))
      text += fmt::format("{}{} {:.6g} to {:.6g} m", text.empty() ? "" : ", ", "xyz"[axis], extent.from[axis],
                          extent.to[axis]);
  return text;
}

std::string start_text(const InitialState& initial) {
  const auto hydrostatic = [](const HydrostaticStart& start) {
    std::string text = !start.line.x.empty()
                           ? fmt::format("hydrostatic over a water table along a line from {:g} m to {:g} m",
                                         start.line.y.front(), start.line.y.back())
                           : fmt::format("hydrostatic over a water table at {:g} m{}", start.water_table,
                                         start.over_base ? " above the base" : "");
    if (std::isfinite(start.suction_cap)) text += fmt::format(", suction capped at {:g} kPa", start.suction_cap / 1e3);
    return text;
  };
  return std::visit(
      Overloaded{[&](const HydrostaticStart& start) { return hydrostatic(start); },
                 [](const UniformStart& start) { return fmt::format("uniform {:g} kPa", start.pressure / 1e3); },
                 [](const ProfileStart& start) {
                   return fmt::format("profile, {:g} kPa at {:g} m to {:g} kPa at {:g} m", start.pressure.front() / 1e3,
                                      start.elevation.front(), start.pressure.back() / 1e3, start.elevation.back());
                 },
                 [](const SoilStart& start) {
                   std::string text;
                   for (const auto& [soil, pressure] : start.pressure)
                     text += fmt::format("{}'{}' {:g} kPa", text.empty() ? "" : ", ", soil, pressure / 1e3);
                   return text;
                 },
                 [](const SteadyStart& start) {
                   return fmt::format("steady under antecedent rain of {:.4g} mm/h", start.rain * 3.6e6);
                 },
                 [&](const SpinUpStart& start) {
                   return fmt::format("spun up over {:g} s of a record of {} intensities, from {}", start.duration,
                                      start.rain.start.size(), hydrostatic(start.from));
                 },
                 [](const FieldStart& start) {
                   return start.file.empty() ? fmt::format("{} points", start.pressure.value.size())
                                             : "the field " + start.file.string();
                 }},
      initial.pressure);
}

std::string retention_text(const Retention& retention) {
  return std::visit(
      Overloaded{
          [](const VanGenuchten& law) {
            std::string text = fmt::format("van Genuchten, p0 {:g} kPa, lambda {:g}", law.air_entry / 1e3, law.lambda);
            if (law.cut_off > 0) text += fmt::format(", full up to {:g} kPa", law.cut_off / 1e3);
            return text + limits(law.s_min, law.s_max);
          },
          [](const Exponential& law) {
            return fmt::format("exponential, scale {:g} kPa", law.suction_scale / 1e3) + limits(law.s_min, law.s_max);
          },
          [](const Haverkamp& law) {
            return fmt::format("Haverkamp, a {:g} and beta {:g} for heads in units of {:g} m", law.a, law.beta,
                               law.head_unit) +
                   limits(law.s_min, law.s_max);
          },
          [](const HaverkampLog& law) {
            return fmt::format("Haverkamp (logarithm), a {:g} and beta {:g} for heads in units of {:g} m", law.a,
                               law.beta, law.head_unit) +
                   limits(law.s_min, law.s_max);
          },
          [](const BroadbridgeWhite& law) {
            return fmt::format("Broadbridge and White, C {:g}, sorptive length {:g} m", law.c, law.sorptive_length) +
                   limits(law.s_min, law.s_max);
          },
          [](const TabulatedRetention& law) {
            return fmt::format("{} points up to {:g} kPa", law.suction.size(), law.suction.back() / 1e3);
          }},
      retention);
}

std::string permeability_text(const Soil& soil) {
  switch (soil.permeability) {
    case PermeabilityLaw::mualem:
      return "Mualem";
    case PermeabilityLaw::printed_mualem:
      return "Mualem as printed in Lee 2021, Eq. 7 (a known defect; the reference uses Mualem)";
    case PermeabilityLaw::mualem_of_saturation:
      return "Mualem of S in place of Se (a known defect; the reference uses Mualem)";
    case PermeabilityLaw::exponential:
      return fmt::format("exponential, scale {:g} kPa", soil.permeability_suction_scale / 1e3);
    case PermeabilityLaw::constant:
      return "constant";
    case PermeabilityLaw::haverkamp:
      return fmt::format("Haverkamp, a {:g} and gamma {:g} for heads in units of {:g} m", soil.haverkamp.a,
                         soil.haverkamp.gamma, soil.haverkamp.head_unit);
    case PermeabilityLaw::broadbridge_white:
      return "Broadbridge and White";
    case PermeabilityLaw::tabulated:
      return fmt::format("{} points up to {:g} kPa", soil.table.suction.size(), soil.table.suction.back() / 1e3);
  }
  return "";
}

std::string evaporation_text(const Evaporation& evaporation) {
  return "from '" + evaporation.side + "'," + record_text(evaporation.demand.intensity, 1e-3 / 86400, "mm/d") +
         fmt::format(", no drier than {:g} kPa", evaporation.least_pressure / 1e3);
}

std::string boundary_text(const Boundary& boundary) {
  switch (*boundary.water) {
    case WaterCondition::impermeable:
      return "impermeable";
    case WaterCondition::free_drainage:
      return "free drainage";
    case WaterCondition::pressure:
      return "pressure" + (boundary.record.value.empty() ? record_text({boundary.pressure}, 1e3, "kPa")
                                                         : record_text(boundary.record.value, 1e3, "kPa"));
    case WaterCondition::seepage_face:
      return "seepage face";
    case WaterCondition::total_head:
      return "total head" + record_text(boundary.record.value, 1, "m");
    case WaterCondition::flux:
      return "inflow per area" + record_text(boundary.inflow.intensity, 1e-3 / 3600, "mm/h");
    case WaterCondition::water_level:
      return "water level" + record_text(boundary.record.value, 1, "m") + ", seepage face or rain above";
    case WaterCondition::as_at_start:
      return "pressure as at the start";
    case WaterCondition::periodic:
      return "periodic with '" + boundary.partner + "'";
  }
  return "";
}

namespace {

std::string degrees(double angle) {
  return fmt::format("{:g} deg", angle * 180 / M_PI);
}

std::string friction_text(const FrictionalStrength& strength) {
  std::string text = fmt::format("friction {}, cohesion {:g} kPa, dilatancy {}", degrees(strength.friction),
                                 strength.cohesion / 1e3, degrees(strength.dilatancy));
  if (strength.tension_cut_off) text += fmt::format(", tension up to {:g} kPa", *strength.tension_cut_off / 1e3);
  return text;
}

}  // namespace

std::string strength_text(const Strength& strength) {
  switch (strength.law) {
    case Strength::Law::mohr_coulomb:
      return "Mohr-Coulomb, " + friction_text(strength.peak);
    case Strength::Law::softening:
      return fmt::format("Mohr-Coulomb, {}; after {:g} of plastic shear strain {}", friction_text(strength.peak),
                         strength.softening_range, friction_text(strength.residual));
    case Strength::Law::suction:
      return fmt::format("Mohr-Coulomb, {}; suction adds up to {:g} kPa of cohesion (B {:g}) and {} per atmosphere",
                         friction_text(strength.peak), strength.suction_cohesion / 1e3, strength.cohesion_rate,
                         degrees(strength.friction_rate));
    case Strength::Law::cam_clay:
      break;
  }
  return fmt::format("modified Cam-Clay, M {:g}, lambda {:g}, kappa {:g}, preconsolidation {:g} kPa",
                     strength.critical_slope, strength.compression, strength.swelling, strength.preconsolidation / 1e3);
}

std::string skeleton_side_text(const Boundary& boundary) {
  using Kind = SkeletonCondition::Kind;
  std::string text;
  if (boundary.skeleton) {
    const SkeletonCondition& side = *boundary.skeleton;
    const std::string axes = side.axes[0] && side.axes[1] ? "" : side.axes[0] ? " along x" : " along y";
    switch (side.kind) {
      case Kind::free:
        text = "free";
        break;
      case Kind::fixed:
        text = "fixed" + axes;
        break;
      case Kind::moving:
        text = fmt::format("moved{} with {:g}, {:g} m/s", axes, side.velocity[0], side.velocity[1]);
        break;
      case Kind::contact:
        text = fmt::format("contact, friction {:.4g}", side.friction);
        break;
      case Kind::absorbing:
        text = "absorbing";
        break;
      case Kind::periodic:
        text = "periodic with '" + boundary.partner + "'";
    }
  }
  if (boundary.load)
    text += (text.empty() ? "" : "; ") + std::string("load") + record_text(boundary.load->value, 1000, "kPa");
  if (boundary.traction)
    text += (text.empty() ? "" : "; ") + std::string("traction along x") +
            record_text((*boundary.traction)[0].value, 1000, "kPa") + ", along y" +
            record_text((*boundary.traction)[1].value, 1000, "kPa");
  return text;
}

std::string skeleton_text(const SkeletonSettings& settings) {
  const bool splines = settings.shape == SkeletonSettings::Shape::quadratic_spline;
  std::string text = splines ? "quadratic splines" : "linear shape functions";
  text += settings.update == SkeletonSettings::Update::usf   ? ", stress first"
          : settings.update == SkeletonSettings::Update::usl ? ", stress last"
                                                             : ", MUSL";
  text += settings.apic ? ", APIC" : settings.pic > 0 ? fmt::format(", FLIP with {:g} of PIC", settings.pic) : ", FLIP";
  text += settings.b_bar ? ", B-bar" : ", no cure of locking";
  if (settings.integration == SkeletonSettings::Integration::mixed) text += ", mixed integration";
  if (settings.integration == SkeletonSettings::Integration::points) text += ", stress integrated at the points";
  return text + (settings.k0_stress ? "; starts from K_0 stress" : "; starts without stress");
}

}  // namespace wetfront::verification
