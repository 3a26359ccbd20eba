#include "verification/suites/on_points.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

constexpr double density = 1000, viscosity = 1e-3;  // kg/m3, Pa s

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("on_points: " + what + " (the material point method has no terms for it)");
}

/// Soils and sides of a problem, with its rho g.
class Terms {
 public:
  explicit Terms(const fem::RichardsProblem& problem) : problem_(problem), weight_(problem.unit_weight) {}

  mpm::Soil soil(const fem::Soil& in) const {
    mpm::Soil out;
    out.name = in.name;
    out.origin = "case: soil " + in.name;
    const auto [theta_r, theta_s] = std::visit([](const auto& law) { return range(law); }, in.retention);
    out.porosity = in.porosity > 0 ? in.porosity : theta_s;
    out.grain_density = 2650;
    out.intrinsic_permeability = in.saturated_conductivity * viscosity / weight_;
    out.retention = retention(in.retention, theta_r / out.porosity, theta_s / out.porosity);
    out.permeability = permeability(in.conductivity);
    out.anisotropy = in.anisotropy;
    return out;
  }

  mpm::WaterBoundary side(const fem::BoundaryCondition& in) const {
    return std::visit(
        Overloaded{[&](const fem::RainSide& s) -> mpm::WaterBoundary {
                     return mpm::RainSide{s.side, s.rain, origin(s.side), s.evaporation, s.minimum_head * weight_};
                   },
                   [&](const fem::HeadSide& s) { return head(s); },
                   [&](const fem::FreeDrainageSide& s) -> mpm::WaterBoundary {
                     return mpm::FreeDrainageSide{s.side, origin(s.side)};
                   },
                   [&](const fem::FluxSide& s) -> mpm::WaterBoundary {
                     return mpm::FluxSide{s.side, s.inflow, s.minimum_head * weight_, origin(s.side)};
                   },
                   [&](const fem::WaterLevelSide& s) -> mpm::WaterBoundary {
                     return mpm::WaterLevelSide{s.side, record(s.level, 1), s.rain, origin(s.side)};
                   },
                   [&](const fem::PeriodicSides& s) -> mpm::WaterBoundary {
                     return mpm::PeriodicSides{s.side, s.partner, origin(s.side)};
                   }},
        in);
  }

 private:
  static std::pair<double, double> range(const fem::TabulatedRetention& law) {
    return {law.content.front(), law.content.back()};
  }
  template <class Law>
  static std::pair<double, double> range(const Law& law) {
    return {law.theta_r, law.theta_s};
  }

  /// Suctions [Pa], ascending, of heads [m], ascending to 0; `values` in the same order turned round.
  std::pair<std::vector<double>, std::vector<double>> turned(const std::vector<double>& heads,
                                                             const std::vector<double>& values, double unit) const {
    std::vector<double> suction, turned;
    for (std::size_t i = heads.size(); i-- > 0;) {
      suction.push_back(-heads[i] * weight_);
      turned.push_back(values[i] / unit);
    }
    return {suction, turned};
  }

  mpm::RetentionSpec retention(const fem::Retention& in, double s_min, double s_max) const {
    return std::visit(
        Overloaded{[&](const fem::VanGenuchten& law) -> mpm::RetentionSpec {
                     return mpm::VanGenuchtenRetention{weight_ / law.alpha, 1 - 1 / law.n, s_min, s_max,
                                                       law.air_entry * weight_};
                   },
                   [&](const fem::ExponentialRetention& law) -> mpm::RetentionSpec {
                     return mpm::ExponentialRetention{weight_ / law.alpha, s_min, s_max};
                   },
                   [&](const fem::HaverkampRetention& law) -> mpm::RetentionSpec {
                     return mpm::HaverkampRetention{law.a * std::pow(weight_, law.beta), law.beta, s_min, s_max};
                   },
                   [&](const fem::HaverkampLogRetention& law) -> mpm::RetentionSpec {
                     return mpm::HaverkampLogRetention{law.a, law.beta, law.entry * weight_, s_min, s_max};
                   },
                   [&](const fem::BroadbridgeWhiteRetention& law) -> mpm::RetentionSpec {
                     return mpm::BroadbridgeWhiteRetention{law.c, law.lambda * weight_, s_min, s_max};
                   },
                   [&](const fem::TabulatedRetention& law) -> mpm::RetentionSpec {
                     auto [suction, saturation] = turned(law.head, law.content, law.content.back() / s_max);
                     return mpm::PointsRetention{std::move(suction), std::move(saturation)};
                   }},
        in);
  }

  mpm::PermeabilitySpec permeability(const fem::Conductivity& in) const {
    return std::visit(
        Overloaded{
            [](const fem::MualemConductivity&) -> mpm::PermeabilitySpec { return mpm::MualemPermeability{}; },
            [&](const fem::ExponentialConductivity& law) -> mpm::PermeabilitySpec {
              return mpm::ExponentialPermeability{weight_ / law.alpha};
            },
            [](const fem::ConstantConductivity&) -> mpm::PermeabilitySpec { return mpm::ConstantPermeability{}; },
            [&](const fem::HaverkampConductivity& law) -> mpm::PermeabilitySpec {
              return mpm::HaverkampPermeability{law.a * std::pow(weight_, law.gamma), law.gamma};
            },
            [](const fem::BroadbridgeWhiteConductivity&) -> mpm::PermeabilitySpec {
              return mpm::BroadbridgeWhitePermeability{};
            },
            [&](const fem::TabulatedConductivity& law) -> mpm::PermeabilitySpec {
              auto [suction, relative] = turned(law.head, law.relative, 1);
              return mpm::PointsPermeability{std::move(suction), std::move(relative)};
            }},
        in);
  }

  mpm::WaterBoundary head(const fem::HeadSide& in) const {
    if (in.varying) refuse("a head given by a function on side '" + in.side + "'");
    if (in.total) {
      const fem::TimeRecord constant{{0}, {in.head}};
      return mpm::TotalHeadSide{in.side, record(in.record.value.empty() ? constant : in.record, 1), origin(in.side)};
    }
    mpm::PressureSide out{in.side, in.head * weight_, origin(in.side)};
    out.record = record(in.record, weight_);
    out.initial = in.initial;
    return out;
  }

  static mpm::TimeRecord record(const fem::TimeRecord& in, double unit) {
    mpm::TimeRecord out{in.time, in.value};
    for (double& value : out.value) value *= unit;
    return out;
  }
  static std::string origin(const std::string& side) { return "case: side " + side; }

  const fem::RichardsProblem& problem_;
  double weight_;  ///< rho g [Pa/m]
};

/// K_l that gives the soils' storage above p = 0, n S_max / K_l, where they agree on one; infinite where none has any.
double bulk_modulus(const fem::RichardsProblem& problem, std::vector<mpm::Soil>& soils) {
  double modulus = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < soils.size(); ++i) {
    const double storage = problem.soils[i].specific_storage / problem.unit_weight;
    if (i == 0 && storage > 0) modulus = soils[i].porosity / storage;
    if (std::abs(storage - soils[i].porosity / modulus) > 1e-12 * storage) soils[i].storage = storage;
  }
  return modulus;
}

}  // namespace

meshes::Mesh strip_of(const meshes::Mesh& line) {
  meshes::Mesh mesh;
  const double low = line.nodes.front()[0], high = line.nodes.back()[0], width = (high - low) / line.cell_count();
  for (const auto& node : line.nodes)
    for (const double x : {0.0, width}) mesh.nodes.push_back({x, node[0], 0});
  meshes::Side left{"left", {}}, right{"right", {}};
  for (std::size_t c = 0; c < line.cell_count(); ++c) {
    const int a = 2 * line.cell(c)[0], b = 2 * line.cell(c)[1];
    mesh.cells.insert(mesh.cells.end(), {a, a + 1, b + 1, b});
    left.faces.insert(left.faces.end(), {b, a});
    right.faces.insert(right.faces.end(), {a + 1, b + 1});
  }
  mesh.region = line.region;
  mesh.region_names = line.region_names;
  for (const auto& end : line.sides) mesh.sides.push_back({end.name, {2 * end.faces[0], 2 * end.faces[0] + 1}});
  mesh.sides.push_back(left);
  mesh.sides.push_back(right);
  return mesh;
}

std::vector<double> on_line(const std::vector<double>& strip_nodes) {
  std::vector<double> values;
  for (std::size_t i = 0; i < strip_nodes.size(); i += 2) values.push_back(strip_nodes[i]);
  return values;
}

meshes::FieldHistory on_line(const meshes::FieldHistory& strip, const meshes::Mesh& line) {
  meshes::FieldHistory out = strip;
  out.mesh = line;
  for (auto& snapshot : out.snapshots) {
    snapshot.node_pressure = on_line(snapshot.node_pressure);
    snapshot.node_saturation = on_line(snapshot.node_saturation);
    snapshot.cell_pressure.clear();
    snapshot.cell_saturation.clear();
    snapshot.points = {};
  }
  return out;
}

mpm::Problem<2> on_points(const fem::RichardsProblem& in) {
  if (in.mesh.dim > 2) refuse("three dimensions");
  if (in.source) refuse("a source inside the soil");
  const bool line = in.mesh.dim == 1;
  mpm::Problem<2> out;
  out.mesh = line ? strip_of(in.mesh) : in.mesh;
  out.mesh.dim = 2;
  const double g = in.unit_weight / density;
  out.gravity = line ? std::array{0.0, g * in.gravity_direction[0]}
                     : std::array{g * in.gravity_direction[0], g * in.gravity_direction[1]};
  out.gravity_origin = "case: gravity";
  const Terms terms(in);
  for (const auto& soil : in.soils) out.soils.push_back(terms.soil(soil));
  out.water = mpm::Water{density, bulk_modulus(in, out.soils), viscosity, "case: water"};
  for (const double head : in.initial_head)
    for (int copies = line ? 2 : 1; copies > 0; --copies) out.initial_pressure.push_back(head * in.unit_weight);
  out.conductivity_factor = in.conductivity_factor;
  for (const auto& side : in.boundary) out.water_boundary.push_back(terms.side(side));
  const double middle = line ? 0.5 * out.mesh.nodes[1][0] : 0;
  for (const auto& gauge : in.gauges)
    out.probes.push_back(
        {gauge.name, line ? meshes::Point{middle, gauge.position[0], 0} : gauge.position, "case: gauge " + gauge.name});
  mpm::Stage stage;
  stage.name = "seepage";
  stage.liquid = mpm::LiquidScheme::seepage;
  stage.end_time = in.end_time;
  stage.origin = "case: stage";
  out.stages = {stage};
  out.output_times = in.output_times;
  return out;
}

}  // namespace wetfront::verification
