#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"

#include <optional>
#include <vector>

namespace wetfront::verification {

/// Rain on the surface over x, cumulative, per horizontal metre of ground [mm].
struct SurfaceRain {
  std::vector<double> x;  ///< m, ascending
  std::vector<double> fallen, taken, run_off;
};

/// From what nodes got: those that stand above each other, nearer than a third of a cell in x, are one place, which
/// catches rain halfway to its neighbours. Empty where less than two places were rained on.
SurfaceRain rain_over_surface(const std::vector<meshes::NodeRain>& nodes, const meshes::Mesh& mesh);

/// Rain fallen, taken and run off over the surface of the MPM until the end of its run, of the reference dashed. After
/// a failure [s; infinity: none] the reference is left out: its rain by node is that of another time. Empty in other
/// dimensions and on columns.
std::optional<reports::Figure> surface_rain_figure(const meshes::FieldHistory& candidate, double failure,
                                                   const meshes::FieldHistory* reference);

}  // namespace wetfront::verification
