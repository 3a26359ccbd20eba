#pragma once

#include "meshes/mesh.h"

#include <limits>
#include <map>
#include <string>
#include <vector>

/// What a solver leaves behind: fields on a mesh over time, the water ledger, the gauges, the cost.
/// Both solvers fill the same record, so that a comparison needs to know neither of them.
///
/// Sign convention: pore pressure is compression-positive [Pa]; suction is its negative.
namespace wetfront::meshes {

/// Values at material points, for the figures only (comparisons use cells and nodes).
struct PointCloud {
  std::vector<Point> position;
  std::vector<double> pressure;
  std::vector<double> saturation;
};

struct Snapshot {
  double time = 0;  ///< s
  std::string stage;
  std::vector<double> node_pressure;    ///< Pa, one per mesh node
  std::vector<double> node_saturation;  ///< -, one per mesh node
  std::vector<double> cell_pressure;    ///< Pa
  std::vector<double> cell_saturation;  ///< -
  /// What the cell values are: averages over the cell, where a scheme carries those, or values at its centre.
  bool cells_hold_averages = false;
  PointCloud points;                     ///< empty where the solver has none
  std::vector<Point> node_displacement;  ///< m; empty where the skeleton is rigid
};

/// Water volumes integrated over the mesh: m3/m2 in one dimension, m3/m in two, m3 in three.
/// All but the two stored columns are cumulative since the start of the run and >= 0 unless said.
struct LedgerRow {
  double time = 0;         ///< s
  double rain_asked = 0;   ///< what the rain record asked for
  double infiltrated = 0;  ///< rain imposed on the soil by the boundary code
  double run_off = 0;      ///< rain refused by the boundary code
  double outflow = 0;      ///< through every other side; negative: water came in
  double stored = 0;       ///< water in the soil from the nodal (cell) unknowns the scheme conserves
  double stored_points = std::numeric_limits<double>::quiet_NaN();  ///< the same, summed over points
};

/// The water that passed one side [as LedgerRow, cumulative], one value per row of the ledger.
struct SideLedger {
  std::string side;                ///< empty: inside the soil
  std::string condition;           ///< "rain", "head", "free drainage", "flux", "water level", "source", ...
  std::vector<double> asked;       ///< rain (or inflow) that the record asked for
  std::vector<double> run_off;     ///< refused
  std::vector<double> outflow;     ///< left the soil, evaporation apart; negative: came in other than as rain
  std::vector<double> evaporated;  ///< met demand
  std::vector<double> demanded;    ///< demand
};

/// Momentum and energy of a deforming skeleton, in a dynamic stage [per metre of thickness in two dimensions]. Works
/// and impulses are sums since the stage began.
struct MotionRow {
  double time = 0;         ///< s
  double kinetic = 0;      ///< J, of the points
  double potential = 0;    ///< J, in the field of gravity
  double stress_work = 0;  ///< J, done on the material: stored elastically and dissipated
  double load_work = 0;    ///< J, of tractions and water on the skeleton
  double resistance = 0;   ///< J, of sides, contact and damping (negative: taken from the skeleton)
  double drift = 0;        ///< J, what the balance of the above and the beginning lacks
  double motion = 0;       ///< N s, sum of m |v| over the points: what drift of momentum is small against
  Point momentum{};        ///< N s, of the points
  Point impulse{};         ///< N s, of weight, tractions and water
  Point reaction{};        ///< N s, of sides, contact and damping
  Point momentum_drift{};  ///< N s, what their balance lacks: round-off
};

struct Gauge {
  std::string name;
  Point position{};
  std::vector<double> time;        ///< s, every accepted step
  std::vector<double> pressure;    ///< Pa
  std::vector<double> saturation;  ///< -
};

/// Rain over one boundary node, cumulative at the end of the run [as LedgerRow].
struct NodeRain {
  int node = 0;
  Point position{};
  double asked = 0;
  double imposed = 0;
  double run_off = 0;
};

struct KernelCost {
  std::string phase;
  std::string kernel;
  double cpu_seconds = 0;
  long calls = 0;
};

struct FieldHistory {
  std::string solver;  ///< e.g. "fem: IDA BDF, Q1 lumped" or "mpm: seepage"
  Mesh mesh;
  std::vector<Snapshot> snapshots;  ///< one per requested output time, in order
  /// The initial state first, then one row per accepted step; conditionally stable stages, whose steps are tiny, write
  /// rows at events and at even intervals between them.
  std::vector<LedgerRow> ledger;
  std::vector<SideLedger> sides;  ///< one per condition of the scene that passes water; empty where a solver has none
  std::vector<MotionRow> motion;  ///< empty where no skeleton deforms dynamically
  std::vector<Gauge> gauges;
  std::vector<NodeRain> rain_by_node;
  std::vector<KernelCost> cost;
  double cpu_seconds = 0;
  /// Counters with speaking names: "steps", "rejected steps", "Newton iterations", ...
  std::map<std::string, double> counters;
  /// Stage changes, rejected steps worth telling, warnings: one sentence each.
  std::vector<std::string> log;
};

/// Called now and then while a solver runs: physical time reached and the end time [s].
using Progress = void (*)(double time, double end, const char* what);

}  // namespace wetfront::meshes
