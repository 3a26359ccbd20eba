#pragma once

#include "mpm/problem.h"

#include <cstddef>
#include <string>
#include <vector>

/// The plan of a stage, as plain data: what `explain` prints and what tests hold to account.
namespace wetfront::mpm {

struct ColumnInfo {
  std::string name, symbol, unit;
  int components = 1;
  bool carried = true;              ///< false: lives within one step only
  std::size_t bytes_per_point = 0;  ///< in each slot
  std::string provided_by;          ///< effect
};

struct EffectInfo {
  std::string name;
  Origin called_for_by;   ///< scene entry
  std::string equations;  ///< paper and equation
};

struct KernelInfo {
  std::string phase, name, effect;
};

struct StepLimit {
  std::string name, formula;
  double seconds = 0;  ///< at the initial state; infinity: no limit
};

struct PlanInfo {
  std::string stage, scheme;
  std::vector<EffectInfo> effects;
  std::vector<ColumnInfo> columns;
  std::vector<KernelInfo> kernels;  ///< in the order they run
  std::vector<StepLimit> step_limits;
  std::size_t points = 0, nodes = 0, cells = 0;
  std::size_t slots = 0;            ///< places for points: more than there are points where these may move
  std::size_t bytes_per_point = 0;  ///< in each slot; with slots that are empty: point_bytes / points
  std::size_t point_bytes = 0;      ///< all that is allocated for points: its columns, bytes_per_point * slots
  double estimated_steps = 0, estimated_cpu_seconds = 0;
};

/// The plan of every stage, without running it. Throws CannotPlan.
template <int dim>
std::vector<PlanInfo> plan(const Problem<dim>& problem);

}  // namespace wetfront::mpm
