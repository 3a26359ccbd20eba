#pragma once

#include "mpm/laws/stress_law.h"
#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

namespace wetfront::mpm {

/// One number that a law remembers.
struct MemoryColumn {
  Column* column;
  int component;
  double* at(std::size_t slot) const { return (*column)[component] + slot; }
};

struct MoveParts {
  double dt;
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
template <int dim, class Shape, class Law>
class MoveCell {
 public:
  static constexpr int nodes = Shape::nodes;

  MoveCell(const Shape& shape, const SkeletonColumns& columns, const std::vector<MemoryColumn>& memory, const Law& law,
           MoveParts parts)
      : shape_(shape), point_(columns), node_(columns), memory_(memory), law_(law), parts_(parts) {}

  /// `size` is the cell's smallest altitude [m].
  void operator()(const Block& block, double size, MoveFindings& found) {
    shape_.enter(block);
    std::array<std::array<double, nodes>, dim> step;
    each<dim>([&](auto a) __attribute__((always_inline)) {
      each<nodes>([&](auto i)
                      __attribute__((always_inline)) { step[a][i] = parts_.dt * node_.velocity[a][shape_.node(i)]; });
    });
    const double dilation = parts_.strain && parts_.b_bar ? mean_dilation(step) : 0;
    const Lanes rate(1 / (size * size));
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      const LaneMask live = live_lanes(block.count - k);
      std::array<Lanes, dim> x;
      each<dim>([&](auto a) __attribute__((always_inline)) { x[a] = load(point_.position[a] + p); });
      typename Shape::Stencil at;
      shape_.all(x, at);
      if (parts_.strain) {
        const Lanes wave = strain(p, live, at, step, dilation) * rate;
        found.wave = max(found.wave, select(live, wave, Lanes(0.0)));
      }
      if (parts_.move) {
        Lanes square(0.0);
        each<dim>([&](auto a) __attribute__((always_inline)) {
          Lanes way = at.value[0] * step[a][0];
          each<nodes - 1>([&](auto i) __attribute__((always_inline)) { way += at.value[i + 1] * step[a][i + 1]; });
          x[a] = select(live, x[a] + way, x[a]);
          store(x[a], point_.position[a] + p);
          const Lanes v = load(point_.velocity[a] + p);
          square += v * v;
        });
        found.motion = max(found.motion, square * rate);
        const LaneMask out = live && shape_.outside(x);
        if (any(out))
          for (std::size_t lane = 0; lane < lane_count; ++lane)
            if (out[lane]) found.leaving->push_back({block.cell, block.cell, k + lane, block.soil});
      }
    }
  }

 private:
  double mean_dilation(const std::array<std::array<double, nodes>, dim>& step) const {
    std::array<Vector<dim>, nodes> mean;
    shape_.mean_gradients(mean);
    double dilation = 0;
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a) dilation += mean[i][a] * step[a][i];
    return dilation;
  }

  /// Returns c^2 = E_oed V/m.
  [[gnu::always_inline]] Lanes strain(std::size_t p, const LaneMask& live, const typename Shape::Stencil& at,
                                      const std::array<std::array<double, nodes>, dim>& step, double dilation) {
    StepGradient<dim, Lanes> gradient;
    each<dim>([&](auto a) __attribute__((always_inline)) {
      std::array<Lanes, dim> along;
      each<dim>([&](auto b) __attribute__((always_inline)) {
        along[b] = at.slope[0][b] * step[a][0];
        each<nodes - 1>([&](auto i)
                            __attribute__((always_inline)) { along[b] += at.slope[i + 1][b] * step[a][i + 1]; });
      });
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
    // Dead lanes are not strained: a law may look at all lanes together, and where dead slots lie is not state.
    each<dim>([&](auto a) __attribute__((always_inline)) {
      for (int d = 0; d < dim; ++d) gradient.plane[a][d] = select(live, gradient.plane[a][d], Lanes(0.0));
    });
    if constexpr (dim == 2) gradient.zz = select(live, gradient.zz, Lanes(0.0));
    LawPoint<Law, dim, Lanes> point;
    each<stress_components<dim>>([&](auto q)
                                     __attribute__((always_inline)) { point.stress[q] = load(point_.stress[q] + p); });
    for (std::size_t q = 0; q < point.memory.size(); ++q) point.memory[q] = load(memory_[q].at(p));
    if constexpr (Law::needs_suction) point.suction = load(point_.suction + p);
    law_.advance(point, gradient);
    each<stress_components<dim>>([&](auto q) __attribute__((always_inline)) {
      store_live(point.stress[q], point_.stress[q] + p, live);
    });
    for (std::size_t q = 0; q < point.memory.size(); ++q) store_live(point.memory[q], memory_[q].at(p), live);
    const Lanes volume = load(point_.volume + p) * (1.0 + trace);
    store_live(volume, point_.volume + p, live);
    return modulus(point) * volume / load(point_.mass + p);
  }
  [[gnu::always_inline]] Lanes modulus(const LawPoint<Law, dim, Lanes>& point) const {
    if constexpr (requires { Law::modulus_varies; }) {
      return Lanes([&](auto lane) {
        LawPoint<Law, dim> one;
        for (std::size_t q = 0; q < point.stress.size(); ++q) one.stress[q] = point.stress[q][lane];
        for (std::size_t q = 0; q < point.memory.size(); ++q) one.memory[q] = point.memory[q][lane];
        return law_.constrained_modulus(one);
      });
    } else {
      return Lanes(law_.constrained_modulus(point));
    }
  }

  Shape shape_;
  PointPlaces<dim> point_;
  NodePlaces<dim> node_;
  const std::vector<MemoryColumn>& memory_;
  const Law law_;
  MoveParts parts_;
};

}  // namespace wetfront::mpm
