#pragma once

#include "mpm/plan/stage_plan.h"
#include "mpm/skeleton/gather_quads.h"
#include "mpm/skeleton/move_cell.h"
#include "mpm/skeleton/points_cell.h"

#include <memory>
#include <span>

namespace wetfront::mpm {

/// The kernels of one soil over the cells of a chunk: shape functions and law are chosen once, when it is made.
template <int dim>
class SoilMotion {
 public:
  using Blocks = std::span<const Block>;
  virtual ~SoilMotion() = default;
  virtual void gather(Blocks blocks, GatherParts parts) const = 0;
  /// f_i += sum m_p b_p N_i with accelerations of the points [m/s2] (a column of dim components).
  virtual void push(Blocks blocks, const Column& acceleration) const = 0;
  virtual void points(Blocks blocks, TransferParts parts) const = 0;
  virtual void move(Blocks blocks, MoveParts parts, MoveFindings& found) const = 0;
  /// What `move` finds, at the present state and without moving.
  virtual void rates(Blocks blocks, MoveFindings& found) const = 0;
  /// Memory of points that have not been strained.
  virtual void begin(Blocks blocks) const = 0;
};

/// What a soil's kernels work with; all of it outlives them.
template <int dim>
struct SoilMotionSetting {
  const SkeletonColumns& columns;
  const std::vector<double>& altitude;  ///< per cell [m]
  /// Provides the columns of a law's memory, or finds them where another soil has provided them.
  std::function<std::vector<MemoryColumn>(const std::vector<ColumnSpec>&)> memory;
};

/// Throws CannotPlan when the soil has no elastic constants.
template <int dim, class Shape>
std::unique_ptr<SoilMotion<dim>> make_soil_motion(const Soil& soil, const Shape& shape,
                                                  const SoilMotionSetting<dim>& setting);

/// The kernels that know no law.
template <int dim, class Shape>
class ShapeMotion : public SoilMotion<dim> {
 public:
  using typename SoilMotion<dim>::Blocks;
  ShapeMotion(Shape shape, const SkeletonColumns& columns) : shape_(shape), columns_(columns) {}

  void gather(Blocks blocks, GatherParts parts) const override {
    const auto over = [blocks](auto cell) {
      for (const Block& block : blocks) cell(block);
    };
    if constexpr (std::is_same_v<Shape, LinearShape<2>>)
      if (columns_.affine == nullptr) return GatherQuads(shape_, columns_, parts)(blocks);
    if (columns_.affine != nullptr)
      over(GatherCell<dim, Shape, true>(shape_, columns_, parts));
    else
      over(GatherCell<dim, Shape, false>(shape_, columns_, parts));
  }
  void push(Blocks blocks, const Column& acceleration) const override {
    Shape shape = shape_;
    typename Shape::Stencil at;
    for (const Block& block : blocks) {
      shape.enter(block);
      for (std::size_t p = block.first; p < block.first + block.count; p += lane_count) {
        std::array<Lanes, dim> x;
        for (int a = 0; a < dim; ++a) x[a] = load((*columns_.position)[a] + p);
        shape.values(x, at);
        const Lanes m = load((*columns_.mass)[0] + p);
        for (int a = 0; a < dim; ++a)
          for (int i = 0; i < Shape::nodes; ++i)
            (*columns_.node_force)[a][shape.node(i)] += sum(m * at.value[i] * load(acceleration[a] + p));
      }
    }
  }
  void points(Blocks blocks, TransferParts parts) const override {
    const auto over = [blocks](auto cell) {
      constexpr std::size_t ahead = 4;
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (b + ahead < blocks.size()) cell.fetch(blocks[b + ahead].first);
        cell(blocks[b]);
      }
    };
    if (columns_.affine != nullptr)
      over(PointsCell<dim, Shape, Take::affine>(shape_, columns_, parts));
    else if (columns_.node_new_velocity != nullptr)
      over(PointsCell<dim, Shape, Take::blend>(shape_, columns_, parts));
    else
      over(PointsCell<dim, Shape, Take::increments>(shape_, columns_, parts));
  }

 protected:
  Shape shape_;
  const SkeletonColumns& columns_;
};

/// With the law.
template <int dim, class Shape, class Law>
class LawMotion final : public ShapeMotion<dim, Shape> {
 public:
  using typename SoilMotion<dim>::Blocks;
  LawMotion(Shape shape, const SoilMotionSetting<dim>& setting, const Law& law)
      : ShapeMotion<dim, Shape>(shape, setting.columns),
        altitude_(setting.altitude),
        law_(law),
        memory_(setting.memory(Law::memory_specs(dim))) {}

  void move(Blocks blocks, MoveParts parts, MoveFindings& found) const override {
    MoveCells<dim, Shape, Law>(this->shape_, this->columns_, memory_, law_, parts)(blocks, altitude_, found);
  }
  void rates(Blocks blocks, MoveFindings& found) const override {
    const SkeletonColumns& c = this->columns_;
    each_point(blocks, [&](std::size_t p, const Block& block) {
      LawPoint<Law, dim> point;
      for (int q = 0; q < stress_components<dim>; ++q) point.stress[q] = (*c.stress)[q][p];
      for (std::size_t q = 0; q < point.memory.size(); ++q) point.memory[q] = *memory_[q].at(p);
      if constexpr (Law::needs_suction) point.suction = (*c.suction)[0][p];
      const double rate = 1 / (altitude_[block.cell] * altitude_[block.cell]);
      double square = 0;
      for (int a = 0; a < dim; ++a) square += (*c.velocity)[a][p] * (*c.velocity)[a][p];
      const double wave = law_.constrained_modulus(point) * (*c.volume)[0][p] / (*c.mass)[0][p];
      found.wave = max(found.wave, Lanes(wave * rate));
      found.motion = max(found.motion, Lanes(square * rate));
    });
  }
  void begin(Blocks blocks) const override {
    each_point(blocks, [&](std::size_t p, const Block&) {
      LawPoint<Law, dim> point;
      for (int q = 0; q < stress_components<dim>; ++q) point.stress[q] = (*this->columns_.stress)[q][p];
      law_.begin(point);
      for (std::size_t q = 0; q < point.memory.size(); ++q) *memory_[q].at(p) = point.memory[q];
    });
  }

 private:
  template <class Body>
  void each_point(Blocks blocks, Body body) const {
    for (const Block& block : blocks)
      for (std::size_t p = block.first; p < block.first + block.count; ++p) body(p, block);
  }

  const std::vector<double>& altitude_;
  Law law_;
  std::vector<MemoryColumn> memory_;
};

}  // namespace wetfront::mpm
