#include "verification/suites/problem_setup.h"

#include "fem_reference/richards_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

reports::Table empty_setup() {
  return {"What is solved",
          "Set-up",
          "The first problem of this case; the others change what the findings name.",
          {"quantity", "value", "unit"},
          {}};
}

void add(reports::Table& table, const std::string& quantity, const std::string& value, const std::string& unit = "") {
  table.rows.push_back({quantity, value, unit});
}

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

void add_mesh(reports::Table& table, const meshes::Mesh& mesh) {
  std::array<double, 3> low{}, high{};
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = i == 0 ? mesh.nodes[i][a] : std::min(low[a], mesh.nodes[i][a]);
      high[a] = i == 0 ? mesh.nodes[i][a] : std::max(high[a], mesh.nodes[i][a]);
    }
  std::string size;
  for (int a = 0; a < mesh.dim; ++a)
    size += (a == 0 ? "" : " x ") + number(high[static_cast<std::size_t>(a)] - low[static_cast<std::size_t>(a)]);
  add(table, fmt::format("mesh, {} cells in {} dimension{}", mesh.cell_count(), mesh.dim, mesh.dim > 1 ? "s" : ""),
      size, "m");
}

struct RetentionName {
  std::string operator()(const fem_reference::VanGenuchten& law) const {
    return fmt::format("van Genuchten, alpha {:.6g} 1/m, n {:.6g}", law.alpha, law.n);
  }
  std::string operator()(const fem_reference::ExponentialRetention& law) const {
    return fmt::format("exponential (Gardner), alpha {:.6g} 1/m", law.alpha);
  }
  std::string operator()(const fem_reference::HaverkampRetention& law) const {
    return fmt::format("Haverkamp, a {:.6g} m^beta, beta {:.6g}", law.a, law.beta);
  }
  std::string operator()(const fem_reference::HaverkampLogRetention& law) const {
    return fmt::format("Haverkamp (logarithm), a {:.6g}, beta {:.6g}", law.a, law.beta);
  }
  std::string operator()(const fem_reference::BroadbridgeWhiteRetention& law) const {
    return fmt::format("Broadbridge-White, C {:.6g}, lambda {:.6g} m", law.c, law.lambda);
  }
  std::string operator()(const fem_reference::TabulatedRetention& law) const {
    return fmt::format("table of {} points", law.head.size());
  }
};

double wet(const fem_reference::TabulatedRetention& law) {
  return law.content.empty() ? 0 : law.content.back();
}
double dry(const fem_reference::TabulatedRetention& law) {
  return law.content.empty() ? 0 : law.content.front();
}
double wet(const auto& law) {
  return law.theta_s;
}
double dry(const auto& law) {
  return law.theta_r;
}

std::string side_text(const fem_reference::BoundaryCondition& condition) {
  struct Text {
    std::string operator()(const fem_reference::RainSide& side) const {
      return side.side + (side.rain.intensity.empty() ? ": seepage face or evaporation" : ": rain");
    }
    std::string operator()(const fem_reference::HeadSide& side) const {
      const bool fixed = !side.varying && !side.initial && side.record.time.empty();
      return side.side + ": " + (side.total ? "total head" : "pressure head") +
             (fixed          ? fmt::format(" {:.6g} m", side.head)
              : side.initial ? " of the start"
                             : " in time");
    }
    std::string operator()(const fem_reference::FreeDrainageSide& side) const { return side.side + ": free drainage"; }
    std::string operator()(const fem_reference::FluxSide& side) const { return side.side + ": flux"; }
    std::string operator()(const fem_reference::WaterLevelSide& side) const { return side.side + ": water level"; }
    std::string operator()(const fem_reference::PeriodicSides& side) const {
      return side.side + " and " + side.partner + ": periodic";
    }
  };
  return std::visit(Text{}, condition);
}

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

std::string law_text(const std::optional<mpm::SkeletonLaw>& law) {
  if (!law) return "linear elastic";
  struct Text {
    std::string operator()(const mpm::MohrCoulomb& law) const {
      return fmt::format("Mohr-Coulomb, phi {:.4g} deg, c {:.4g} Pa, psi {:.4g} deg", degrees(law.friction),
                         law.cohesion, degrees(law.dilatancy));
    }
    std::string operator()(const mpm::SofteningMohrCoulomb&) const { return "Mohr-Coulomb, softening"; }
    std::string operator()(const mpm::SuctionMohrCoulomb&) const { return "Mohr-Coulomb with suction"; }
    std::string operator()(const mpm::ModifiedCamClay& law) const {
      return fmt::format("modified Cam-Clay, M {:.4g}, lambda {:.4g}, kappa {:.4g}", law.critical_slope,
                         law.compression, law.swelling);
    }
    std::string operator()(const mpm::NeoHookean&) const { return "neo-Hookean"; }
    std::string operator()(const mpm::Hencky&) const { return "Hencky"; }
  };
  return std::visit(Text{}, *law);
}

template <int dim>
std::string equation(const mpm::Problem<dim>& problem) {
  const bool moves = std::ranges::any_of(problem.soils, [](const mpm::Soil& soil) { return soil.elastic.has_value(); });
  const std::string water = "d(n S)/dt = div(k k_r/mu (grad p - rho g)), p compression-positive";
  const std::string motion = "rho dv/dt = div(sigma' - S p 1) + rho g";
  if (!problem.water) return "rho dv/dt = div sigma + rho g, updated Lagrangian";
  return moves ? motion + "; " + water : water;
}

}  // namespace

reports::Table problem_setup(const fem_reference::RichardsProblem& problem) {
  reports::Table table = empty_setup();
  const double gravity =
      std::hypot(problem.gravity_direction[0], problem.gravity_direction[1], problem.gravity_direction[2]);
  add(table, "equation (Richards, mixed form)",
      std::string("d theta(psi)/dt = div(K(psi) grad(psi") + (gravity > 0 ? " + z))" : ")), no gravity") +
          (problem.source ? " + source" : ""));
  add_mesh(table, problem.mesh);
  for (const fem_reference::Soil& soil : problem.soils) {
    const std::string name = problem.soils.size() > 1 ? soil.name + ": " : "";
    add(table, name + "retention", std::visit(RetentionName{}, soil.retention));
    add(table, name + "water content, dry to wet",
        std::visit([](const auto& law) { return number(dry(law)) + " to " + number(wet(law)); }, soil.retention), "-");
    add(table, name + "saturated conductivity", number(soil.saturated_conductivity), "m/s");
  }
  for (const auto& condition : problem.boundary) add(table, "side", side_text(condition));
  add(table, "end", number(problem.end_time), "s");
  add(table, "relative tolerance in time", number(problem.tolerance), "-");
  return table;
}

template <int dim>
reports::Table problem_setup(const mpm::Problem<dim>& problem) {
  reports::Table table = empty_setup();
  add(table, "equation", equation(problem));
  add_mesh(table, problem.mesh);
  add(table, "points per cell", number(problem.points_per_cell), "-");
  double gravity = 0;
  for (const double g : problem.gravity) gravity = std::hypot(gravity, g);
  add(table, "gravity", number(gravity), "m/s2");
  for (const mpm::Soil& soil : problem.soils) {
    const std::string name = problem.soils.size() > 1 ? soil.name + ": " : "";
    add(table, name + "porosity", number(soil.porosity), "-");
    add(table, name + "density of grains", number(soil.grain_density), "kg/m3");
    if (problem.water) add(table, name + "intrinsic permeability", number(soil.intrinsic_permeability), "m2");
    if (!soil.elastic) continue;
    add(table, name + "Young's modulus", number(soil.elastic->young), "Pa");
    add(table, name + "Poisson's ratio", number(soil.elastic->poisson), "-");
    add(table, name + "law", law_text(soil.law));
  }
  if (problem.water) {
    add(table, "bulk modulus of water", number(problem.water->bulk_modulus), "Pa");
    add(table, "viscosity of water", number(problem.water->viscosity), "Pa s");
  }
  if (!problem.stages.empty()) add(table, "end", number(problem.stages.back().end_time), "s");
  return table;
}

template reports::Table problem_setup(const mpm::Problem<2>&);
template reports::Table problem_setup(const mpm::Problem<3>&);

}  // namespace wetfront::verification
