// Scenes that make no sense: every scheme has to say so before it starts.
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"

#include <cmath>
#include <functional>

namespace wetfront::verification {
namespace {

HardCase broken(const std::string& name, const std::string& title, const std::function<void(mpm::Problem<2>&)>& spoil) {
  HardCase row;
  row.name = name;
  row.title = title;
  row.requirement = "Refused with a message that says what is wrong.";
  row.source = "the scene alone";
  row.problem = [spoil] {
    HardColumn column;
    column.cells = 5;
    column.rain = {{0}, {1e-5}};
    column.outputs = {1};
    mpm::Problem<2> problem = strip_problem(column);
    spoil(problem);
    return problem;
  };
  row.ends = {1};
  row.judge = [](const auto&, const auto&) { return std::vector<Reading>{}; };
  row.invalid = true;
  return row;
}

}  // namespace

std::vector<HardCase> invalid_rows() {
  return {broken("invalid_rain_side", "Rain on a side that is not there",
                 [](auto& problem) { std::get<mpm::RainSide>(problem.water_boundary[0]).side = "roof"; }),
          broken("invalid_rain_below", "Rain from below",
                 [](auto& problem) { std::get<mpm::RainSide>(problem.water_boundary[0]).side = "base"; }),
          broken("invalid_start", "A start that is not a number",
                 [](auto& problem) { problem.initial_pressure[3] = std::nan(""); }),
          broken("invalid_rain", "Rain that is not a number",
                 [](auto& problem) { std::get<mpm::RainSide>(problem.water_boundary[0]).rain.intensity[0] = NAN; }),
          broken("invalid_negative_rain", "Negative rain",
                 [](auto& problem) { std::get<mpm::RainSide>(problem.water_boundary[0]).rain.intensity[0] = -1e-5; }),
          broken("invalid_porosity", "Porosity 1.2", [](auto& problem) { problem.soils[0].porosity = 1.2; }),
          broken("invalid_permeability", "Permeability 0",
                 [](auto& problem) { problem.soils[0].intrinsic_permeability = 0; }),
          broken("invalid_saturations", "S_min above S_max",
                 [](auto& problem) { std::get<mpm::VanGenuchtenRetention>(*problem.soils[0].retention).s_min = 1.1; }),
          broken("invalid_lambda", "van Genuchten's lambda 1.2",
                 [](auto& problem) { std::get<mpm::VanGenuchtenRetention>(*problem.soils[0].retention).lambda = 1.2; }),
          broken("invalid_cell", "A cell turned inside out", [](auto& problem) {
            for (std::size_t i : {4, 5}) problem.mesh.nodes[i][1] = -0.1;
          })};
}

}  // namespace wetfront::verification
