#include "fem_reference/transfer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::fem_reference {
namespace {

using CellOf = std::map<Box, int>;

CellOf cells_of(const Discretisation& space) {
  CellOf cells;
  for (int cell = 0; cell < space.cell_count; ++cell) cells.emplace_hint(cells.end(), space.box[cell], cell);
  return cells;
}

/// The box of which `box` is a part.
Box parent(Box box, int levels) {
  --box.level;
  for (int& low : box.low) low = low >> (levels - box.level) << (levels - box.level);
  return box;
}

/// The cell that is, or contains, a box; -1 when the box is divided.
int covering(const CellOf& cells, Box box, int levels) {
  for (;; box = parent(box, levels)) {
    if (const auto found = cells.find(box); found != cells.end()) return found->second;
    if (box.level == 0) return -1;
  }
}

double corner_value(const Discretisation& space, int cell, int corner, std::span<const double> head) {
  const int n = space.dofs_per_cell;
  const double* shape = space.corner_shape_of(cell) + static_cast<std::size_t>(corner) * n;
  double value = 0;
  for (int a = 0; a < n; ++a) value += shape[a] * head[space.dofs_of(cell)[a]];
  return value;
}

/// The value at a place of the lattice within a cell.
double value_within(const Discretisation& space, int cell, const std::array<int, 3>& place,
                    std::span<const double> head) {
  const Box& box = space.box[cell];
  const double size = 1 << (space.levels - box.level);
  double sum = 0;
  for (int v = 0; v < space.corners(); ++v) {
    double weight = 1;
    for (int axis = 0; axis < space.dim; ++axis) {
      const double unit = (place[axis] - box.low[axis]) / size;
      weight *= (v >> axis & 1) != 0 ? unit : 1 - unit;
    }
    if (weight != 0) sum += weight * corner_value(space, cell, v, head);
  }
  return sum;
}

std::array<int, 3> corner_place(const Discretisation& space, const Box& box, int corner) {
  std::array<int, 3> place = box.low;
  for (int axis = 0; axis < space.dim; ++axis) place[axis] += (corner >> axis & 1) << (space.levels - box.level);
  return place;
}

/// The part of a divided box at one of its corners.
int part_at(const CellOf& cells, const Discretisation& space, Box box, int corner) {
  const std::array<int, 3> end = corner_place(space, box, corner);
  for (;;) {
    ++box.level;
    for (int axis = 0; axis < space.dim; ++axis) {
      box.low[axis] = end[axis] - ((corner >> axis & 1) << (space.levels - box.level));
    }
    if (const auto found = cells.find(box); found != cells.end()) return found->second;
  }
}

/// Whether a corner is a degree of freedom of its own; it then has the corner's place among the cell's.
bool is_dof(const Discretisation& space, int cell, int corner) {
  return space.corner_shape_of(cell)[static_cast<std::size_t>(corner) * space.dofs_per_cell + corner] == 1;
}

std::vector<double> interpolate(const Discretisation& from, const CellOf& cells, std::span<const double> head,
                                const Discretisation& to) {
  std::vector<double> result(to.dof_count);
  for (const bool unchanged : {false, true}) {  // last, so that what did not change keeps its last digit
    for (int cell = 0; cell < to.cell_count; ++cell) {
      const Box& box = to.box[cell];
      const int old = covering(cells, box, to.levels);
      if ((old >= 0 && from.box[old] == box) != unchanged) continue;
      for (int v = 0; v < to.corners(); ++v) {
        if (!is_dof(to, cell, v)) continue;
        double& value = result[to.dofs_of(cell)[v]];
        if (unchanged) {
          value = corner_value(from, old, v, head);
        } else if (old >= 0) {
          value = value_within(from, old, corner_place(to, box, v), head);
        } else {
          value = corner_value(from, part_at(cells, from, box, v), v, head);
        }
      }
    }
  }
  return result;
}

/// Calls visit(dof, volume) for the shares of the lumped mass that a cell brings.
template <class Visit>
void visit_volumes(const Discretisation& space, int cell, Visit visit) {
  const int n = space.dofs_per_cell;
  const double* shape = space.corner_shape_of(cell);
  for (int v = 0; v < space.corners(); ++v, shape += n) {
    const double volume = space.corner_volume[static_cast<std::size_t>(cell) * space.corners() + v];
    for (int a = 0; a < n; ++a) {
      if (shape[a] != 0) visit(space.dofs_of(cell)[a], shape[a] * volume);
    }
  }
}

double water_of(const FlowOperator& flow, int cell, std::span<const double> head) {
  const SoilLaw& law = flow.laws()[flow.space().cell_soil[cell]];
  double water = 0;
  visit_volumes(flow.space(), cell, [&](int dof, double volume) { water += volume * law.storage(head[dof]).value; });
  return water;
}

/// The patch to which a cell belongs: itself where it is the same cell in both meshes but for its constraints, else the
/// larger of what covers it. False where nothing changed.
bool patch_of(const Discretisation& own, int cell, const Discretisation& other, const CellOf& others, Box& patch) {
  const int cover = covering(others, own.box[cell], own.levels);
  patch = cover < 0 ? own.box[cell] : other.box[cover];
  if (cover < 0 || patch != own.box[cell]) return true;
  const auto n = static_cast<std::size_t>(own.dofs_per_cell) * own.corners();
  return !std::equal(own.corner_shape_of(cell), own.corner_shape_of(cell) + n, other.corner_shape_of(cover));
}

struct Patch {
  double defect = 0;       ///< water before less water after interpolation
  std::vector<int> cells;  ///< of the new mesh
};

/// Water to be given to each dof.
std::vector<double> corrections(const FlowOperator& to, std::span<const double> head, const std::vector<char>& fixed,
                                const std::map<Box, Patch>& patches) {
  std::vector<double> given(head.size(), 0.0);
  for (const auto& [box, patch] : patches) {
    std::vector<std::pair<int, double>> share;
    double sum = 0;
    for (const int cell : patch.cells) {
      const SoilLaw& law = to.laws()[to.space().cell_soil[cell]];
      visit_volumes(to.space(), cell, [&](int dof, double volume) {
        if (fixed[dof]) return;
        share.emplace_back(dof, volume * law.storage(head[dof]).slope);
        sum += share.back().second;
      });
    }
    for (const auto& [dof, weight] : share) {
      if (sum > 0) given[dof] += patch.defect * (weight / sum);
    }
  }
  return given;
}

/// The soils around a degree of freedom and their volumes.
using Shares = std::span<const StorageShare>;

ValueAndSlope water_in(const FlowOperator& flow, Shares shares, double head) {
  ValueAndSlope sum{0, 0};
  for (const StorageShare& share : shares) {
    const ValueAndSlope w = flow.laws()[share.soil].storage(head);
    sum.value += share.volume * w.value;
    sum.slope += share.volume * w.slope;
  }
  return sum;
}

/// The head at which a degree of freedom holds `target` [m^dim], not above the larger of `start` and saturation;
/// `start` where it can not hold so little.
double head_for(const FlowOperator& flow, Shares shares, double target, double start) {
  double high = std::max(start, 0.0), low = start - 1;
  if (water_in(flow, shares, high).value <= target) return high;
  for (double step = 1; water_in(flow, shares, low).value > target; step *= 2, low -= step) {
    if (step > 1e6) return start;
  }
  double head = start;
  for (int iteration = 0; iteration < 100 && high - low > 1e-15 * std::abs(low); ++iteration) {
    const ValueAndSlope w = water_in(flow, shares, head);
    (w.value > target ? high : low) = head;
    const double next = w.slope > 0 ? head - (w.value - target) / w.slope : low;
    if (next == head) break;
    head = next > low && next < high ? next : 0.5 * (low + high);
  }
  return head;
}

/// Changes heads so that each dof holds `given` [m^dim] more.
void give(const FlowOperator& flow, const std::vector<double>& given, std::vector<double>& head) {
  const std::vector<StorageShare>& storage = flow.space().storage;  // sorted by dof
  for (std::size_t first = 0, last = 0; first < storage.size(); first = last) {
    const int dof = storage[first].dof;
    while (last < storage.size() && storage[last].dof == dof) ++last;
    if (given[dof] == 0) continue;
    const Shares shares(&storage[first], last - first);
    head[dof] = head_for(flow, shares, water_in(flow, shares, head[dof]).value + given[dof], head[dof]);
  }
}

}  // namespace

Transferred transfer(const FlowOperator& from, std::span<const double> head, const FlowOperator& to,
                     const std::vector<char>& fixed) {
  const Discretisation &before = from.space(), &after = to.space();
  const CellOf old_cells = cells_of(before), new_cells = cells_of(after);
  Transferred result;
  result.head = interpolate(before, old_cells, head, after);
  std::map<Box, Patch> patches;
  Box box{};
  for (int cell = 0; cell < before.cell_count; ++cell) {
    if (patch_of(before, cell, after, new_cells, box)) patches[box].defect += water_of(from, cell, head);
  }
  for (int cell = 0; cell < after.cell_count; ++cell) {
    if (!patch_of(after, cell, before, old_cells, box)) continue;
    Patch& patch = patches[box];
    patch.defect -= water_of(to, cell, result.head);
    patch.cells.push_back(cell);
  }
  for (const auto& [key, patch] : patches) result.moved += std::abs(patch.defect);
  give(to, corrections(to, result.head, fixed, patches), result.head);
  result.lost = from.stored(from.water_at(head)) - to.stored(to.water_at(result.head));
  return result;
}

}  // namespace wetfront::fem_reference
