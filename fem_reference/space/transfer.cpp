#include "fem_reference/space/transfer.h"

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

/// Puts water that a patch lacks back by one shift of its heads, which shares it by volume times capacity to first
/// order.
class Filler {
 public:
  Filler(const FlowOperator& flow, const std::vector<char>& fixed, std::vector<double>& head)
      : flow_(flow), fixed_(fixed), head_(head) {}

  void fill(const Patch& patch) {
    dofs_.clear();
    for (const int cell : patch.cells) {
      visit_volumes(flow_.space(), cell, [&](int dof, double) {
        if (!fixed_[dof]) dofs_.push_back(dof);
      });
    }
    std::sort(dofs_.begin(), dofs_.end());
    dofs_.erase(std::unique(dofs_.begin(), dofs_.end()), dofs_.end());
    start_ = 0;
    start_ = gained(0).value;
    const double shift = find_shift(patch.defect);
    for (const int dof : dofs_) head_[dof] = shifted(dof, shift);
  }

 private:
  // Unsaturated soil fills up to saturation, not to a pressure: the boundary could not have imposed that.
  double shifted(int dof, double shift) const {
    return head_[dof] > 0 ? head_[dof] + shift : std::min(0.0, head_[dof] + shift);
  }

  /// Water that the patch's dofs hold when shifted, beyond what they hold now [m^dim], and its derivative.
  ValueAndSlope gained(double shift) const {
    ValueAndSlope sum{-start_, 0};
    for (const int dof : dofs_) {
      const double head = shifted(dof, shift);
      const ValueAndSlope w = flow_.storage_at(dof, head);
      sum.value += flow_.volume()[dof] * w.value;
      if (head != 0) sum.slope += flow_.volume()[dof] * w.slope;
    }
    return sum;
  }

  /// By Newton within a bracket; as far as possible where the patch has no room for so much, or not so much to give.
  double find_shift(double defect) const {
    double near = 0, far = defect > 0 ? 1e-3 : -1e-3;
    while (std::abs(gained(far).value) < std::abs(defect)) {
      near = far;
      far *= 4;
      if (std::abs(far) > 1e3) return near;
    }
    double low = std::min(near, far), high = std::max(near, far), shift = near;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const ValueAndSlope found = gained(shift);
      (found.value > defect ? high : low) = shift;
      const double next = found.slope > 0 ? shift - (found.value - defect) / found.slope : low;
      const double inside = next > low && next < high ? next : 0.5 * (low + high);
      if (inside == shift || next == shift) break;
      shift = inside;
    }
    return shift;
  }

  const FlowOperator& flow_;
  const std::vector<char>& fixed_;
  std::vector<double>& head_;
  std::vector<int> dofs_;  ///< of the patch
  double start_ = 0;       ///< water they hold
};

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
  Filler filler(to, fixed, result.head);
  for (const auto& [key, patch] : patches) {
    if (patch.defect != 0) filler.fill(patch);
  }
  result.lost = from.stored(from.water_at(head)) - to.stored(to.water_at(result.head));
  return result;
}

}  // namespace wetfront::fem_reference
