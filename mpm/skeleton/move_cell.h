#pragma once

#include "mpm/laws/stress_law.h"
#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

#include <algorithm>
#include <span>

namespace wetfront::mpm {

/// One number that a law remembers.
struct MemoryColumn {
  Column* column;
  int component;
  double* at(std::size_t slot) const { return (*column)[component] + slot; }
};

struct MoveParts {
  double dt;    ///< s
  bool strain;  ///< stress and volume
  bool move;    ///< position
  bool b_bar;
};

/// What a chunk of cells finds while its points are strained and moved.
struct MoveFindings {
  Lanes wave{0.0};    ///< largest (c/h)^2 [1/s2], c^2 = E_oed V/m
  Lanes motion{0.0};  ///< largest (|v|/h)^2 of points [1/s2]
  std::vector<Mover>* leaving = nullptr;
};

/// IV, V, VIII: grad v dt (Eqs 15, 17; B-bar: its trace is that of the cell's mean), effective stress by the law
/// (Eq. 16, corrected), V <- V (1 + tr), x <- x + dt sum N_i v_i (Eq. 19). Points outside their cell are noted.
///
/// The law takes points by the batch, one after the other whatever their cells: its lanes are full although cells hold
/// one, three or six points, and its long chain of operations overlaps with that of the next points.
template <int dim, class Shape, class Law>
class MoveCells {
 public:
  static constexpr int nodes = Shape::nodes;

  MoveCells(const Shape& shape, const SkeletonColumns& columns, const std::vector<MemoryColumn>& memory, const Law& law,
            MoveParts parts)
      : shape_(shape), point_(columns), node_(columns), memory_(memory), law_(law), parts_(parts) {}

  /// `size` holds the smallest altitude of each cell [m].
  void operator()(std::span<const Block> blocks, const std::vector<double>& size, MoveFindings& found) {
    constexpr std::size_t ahead = 4;
    Shape shape = shape_;  // known to nobody else: what it holds of a cell stays in registers
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (b + ahead < blocks.size()) fetch(blocks[b + ahead].first);
      shape.enter(blocks[b]);
      pass(blocks[b], shape, 1 / (size[blocks[b].cell] * size[blocks[b].cell]), found);
    }
    finish(found);
  }

 private:
  using Place = std::array<Lanes, dim>;
  using Steps = std::array<typename Shape::Field, dim>;
  using Point = LawPoint<Law, dim, Lanes>;
  static constexpr std::size_t room = 64;  ///< points in a batch
  static constexpr int strains = dim * dim + (dim == 2 ? 1 : 0);
  static constexpr std::size_t memories = std::tuple_size_v<decltype(Point::memory)>;

  /// Up to four points of a cell, and their place in the batch.
  struct Piece {
    std::size_t slot;
    std::uint32_t at, live;
    double rate;  ///< 1/h^2 of the cell [1/m2]
  };
  template <int count>
  using Packed = std::array<std::array<double, room>, count>;
  /// Points one after the other: a piece is stored with all its lanes, and the next one begins where its live ones end.
  struct Batch {
    alignas(32) Packed<strains> gradient;
    alignas(32) Packed<stress_components<dim>> stress;
    alignas(32) Packed<memories> memory;
    alignas(32) std::array<double, room> suction, modulus;
    std::array<Piece, room> pieces;
    std::size_t points = 0, count = 0;
  };

  void fetch(std::size_t slot) const {
    point_.fetch_motion(slot);
    point_.fetch_stress(slot);
  }

  [[gnu::always_inline]] void pass(const Block& block, const Shape& shape, double rate, MoveFindings& found) {
    Steps step;
    const double dilation = prepare(shape, step);
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      const LaneMask live = live_lanes(block.count - k);
      Place x;
      each<dim>([&](auto a) __attribute__((always_inline)) { x[a] = load(point_.position[a] + p); });
      typename Shape::Stencil at;
      shape.map(x, at);
      if (parts_.strain) {
        if (batch_.points + lane_count > room) finish(found);
        strain(p, shape, live, at, step, dilation);
        const std::size_t count = std::min<std::size_t>(lane_count, block.count - k);
        batch_.pieces[batch_.count++] = {p, static_cast<std::uint32_t>(batch_.points),
                                         static_cast<std::uint32_t>(count), rate};
        batch_.points += count;
      }
      if (parts_.move) {
        Lanes square(0.0);
        each<dim>([&](auto a) __attribute__((always_inline)) {
          x[a] = select(live, x[a] + shape.value(step[a], at), x[a]);
          store(x[a], point_.position[a] + p);
          const Lanes v = load(point_.velocity[a] + p);
          square += v * v;
        });
        found.motion = max(found.motion, square * rate);
        const LaneMask out = live && shape.outside(x);
        if (any(out))
          for (std::size_t lane = 0; lane < lane_count; ++lane)
            if (out[lane]) found.leaving->push_back({block.cell, block.cell, k + lane, block.soil});
      }
    }
  }

  /// dt v_i of the cell's nodes; returns the trace of their mean gradient where that stands for the points' own.
  [[gnu::always_inline]] double prepare(const Shape& shape, Steps& step) const {
    each<dim>([&](auto a) __attribute__((always_inline)) {
      step[a] = shape.field([&](int i) __attribute__((always_inline)) {
        return parts_.dt * node_.velocity[a][shape.node(i)];
      });
    });
    return parts_.strain && parts_.b_bar ? shape.mean_divergence(step) : 0;
  }

  /// Gradient and stress of a piece to the batch, and its volume.
  [[gnu::always_inline]] void strain(std::size_t p, const Shape& shape, const LaneMask& live,
                                     const typename Shape::Stencil& at, const Steps& step, double dilation) {
    StepGradient<dim, Lanes> gradient;
    each<dim>([&](auto a) __attribute__((always_inline)) {
      const Place along = shape.slopes(step[a], at);
      each<dim>([&](auto d) __attribute__((always_inline)) {
        gradient.plane[a][d] = along[0] * at.inverse[0][d];
        each<dim - 1>([&](auto b) __attribute__((always_inline)) {
          gradient.plane[a][d] += along[b + 1] * at.inverse[b + 1][d];
        });
      });
    });
    Lanes trace = gradient.plane[0][0];
    each<dim - 1>([&](auto a) __attribute__((always_inline)) { trace += gradient.plane[a + 1][a + 1]; });
    if (parts_.b_bar) {
      const Lanes more = (dilation - trace) * (1.0 / 3);
      each<dim>([&](auto a) __attribute__((always_inline)) { gradient.plane[a][a] += more; });
      gradient.zz = more;
      trace = Lanes(dilation);
    }
    store_live(load(point_.volume + p) * (1.0 + trace), point_.volume + p, live);
    const std::size_t to = batch_.points;
    each<dim>([&](auto a) __attribute__((always_inline)) {
      each<dim>([&](auto b)
                    __attribute__((always_inline)) { store(gradient.plane[a][b], &batch_.gradient[a * dim + b][to]); });
    });
    if constexpr (dim == 2) store(gradient.zz, &batch_.gradient[4][to]);
    each<stress_components<dim>>([&](auto q) __attribute__((always_inline)) {
      store(load(point_.stress[q] + p), &batch_.stress[q][to]);
    });
    for (std::size_t q = 0; q < memories; ++q) store(load(memory_[q].at(p)), &batch_.memory[q][to]);
    if constexpr (Law::needs_suction) store(load(point_.suction + p), &batch_.suction[to]);
  }

  /// The law for the batch, and what it says back to the points.
  [[gnu::noinline]] void finish(MoveFindings& found) {
    clear_tail();
    for (std::size_t k = 0; k < batch_.points; k += lane_count) advance(k);
    for (std::size_t n = 0; n < batch_.count; ++n) {
      const Piece& piece = batch_.pieces[n];
      const std::size_t p = piece.slot;
      const LaneMask live = live_lanes(piece.live);
      each<stress_components<dim>>([&](auto q) __attribute__((always_inline)) {
        store_live(load(&batch_.stress[q][piece.at]), point_.stress[q] + p, live);
      });
      for (std::size_t q = 0; q < memories; ++q) store_live(load(&batch_.memory[q][piece.at]), memory_[q].at(p), live);
      Lanes modulus;
      if constexpr (varies)
        modulus = load(&batch_.modulus[piece.at]);
      else
        modulus = Lanes(law_.constrained_modulus(Point{}));
      const Lanes wave = modulus * load(point_.volume + p) / load(point_.mass + p) * piece.rate;
      found.wave = max(found.wave, select(live, wave, Lanes(0.0)));
    }
    batch_.points = batch_.count = 0;
  }
  /// Lanes beyond the last point hold nothing: a law may look at all lanes together.
  void clear_tail() {
    const auto clear = [this](auto& columns) {
      for (auto& column : columns)
        for (std::size_t k = batch_.points; k % lane_count != 0; ++k) column[k] = 0;
    };
    clear(batch_.gradient), clear(batch_.stress), clear(batch_.memory);
    for (std::size_t k = batch_.points; k % lane_count != 0; ++k) batch_.suction[k] = 0;
  }
  [[gnu::always_inline]] void advance(std::size_t k) {
    StepGradient<dim, Lanes> gradient;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) gradient.plane[a][b] = load(&batch_.gradient[a * dim + b][k]);
    if constexpr (dim == 2) gradient.zz = load(&batch_.gradient[4][k]);
    Point point;
    for (int q = 0; q < stress_components<dim>; ++q) point.stress[q] = load(&batch_.stress[q][k]);
    for (std::size_t q = 0; q < memories; ++q) point.memory[q] = load(&batch_.memory[q][k]);
    if constexpr (Law::needs_suction) point.suction = load(&batch_.suction[k]);
    law_.advance(point, gradient);
    for (int q = 0; q < stress_components<dim>; ++q) store(point.stress[q], &batch_.stress[q][k]);
    for (std::size_t q = 0; q < memories; ++q) store(point.memory[q], &batch_.memory[q][k]);
    if constexpr (varies) store(modulus(point), &batch_.modulus[k]);
  }
  static constexpr bool varies = requires { Law::modulus_varies; };
  Lanes modulus(const Point& point) const {
    return Lanes([&](auto lane) {
      LawPoint<Law, dim> one;
      for (std::size_t q = 0; q < point.stress.size(); ++q) one.stress[q] = point.stress[q][lane];
      for (std::size_t q = 0; q < point.memory.size(); ++q) one.memory[q] = point.memory[q][lane];
      return law_.constrained_modulus(one);
    });
  }

  Shape shape_;
  PointPlaces<dim> point_;
  NodePlaces<dim> node_;
  const std::vector<MemoryColumn>& memory_;
  const Law law_;
  MoveParts parts_;
  Batch batch_;
};

}  // namespace wetfront::mpm
