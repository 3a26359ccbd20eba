#include "mpm/skeleton/deforming_skeleton.h"

#include <algorithm>
#include <cmath>

/// One cycle of the deforming skeleton (README.md: phase -> equation).
namespace wetfront::mpm {

namespace {

/// of/mass at the nodes of the runs, 0 where there is no mass. (Four at a time: a compiler does not divide where the
/// program says that it shall not.)
void per_mass(const std::vector<NodeRun>& runs, const double* of, const double* mass, double* out) {
  for (const NodeRun& run : runs)
    in_lanes(
        run.first, run.last, [=]<class Number>(std::size_t i) __attribute__((always_inline)) {
          const Number m = load<Number>(mass + i);
          store(select(m > 0.0, load<Number>(of + i) / m, Number(0.0)), out + i);
        });
}

}  // namespace

/// Cells chunk by chunk, colour by colour: chunks of one colour share no node.
template <int dim>
template <class Body>
void DeformingSkeleton<dim>::over_chunks(const Body& body) {
  for (const auto& colour : chunks_->colours())
    team_->run(colour.size(), [&](std::size_t k) {
      for (std::size_t soil = 0; soil < soils_.size(); ++soil)
        body(*soils_[soil], chunks_->blocks(plan_->fields.points, colour[k], static_cast<int>(soil)), colour[k], soil);
    });
}

/// Who is where, when that has changed. Nodes that are left behind keep no motion.
template <int dim>
void DeformingSkeleton<dim>::refresh() {
  const auto& points = plan_->fields.points;
  if (version_ == points.version()) return;
  for (Column* column : {c_.node_mass, c_.node_force, c_.node_velocity, c_.node_acceleration, c_.node_new_velocity})
    for (int c = 0; column != nullptr && c < column->spec().components; ++c)
      for (const NodeRun& run : active_->runs()) std::fill((*column)[c] + run.first, (*column)[c] + run.last, 0.0);
  active_->clear();
  std::array<int, SplineGrid<dim>::nodes> nodes{};
  for (const Block& block : points.blocks())
    if (splines_) {
      splines_->nodes_of(block.cell, nodes.data());
      for (int node : nodes) active_->mark(node);
    } else {
      for (int i = 0; i < cell_nodes<dim>; ++i) active_->mark(block.nodes[i]);
    }
  active_->finish();
  chunks_->update(points, static_cast<int>(soils_.size()));
  if (covered_) covered_->update(points);
  version_ = points.version();
}

/// I and the internal forces of II; with the stress first (USF) also IV and V.
template <int dim>
void DeformingSkeleton<dim>::gather() {
  refresh();
  for (Column* column : {c_.node_mass, c_.node_force, c_.node_velocity})
    for (int c = 0; c < column->spec().components; ++c)
      for (const NodeRun& run : active_->runs()) std::fill((*column)[c] + run.first, (*column)[c] + run.last, 0.0);
  const bool first = plan_->problem.skeleton.update == StressUpdate::usf;
  gather_cells(true, !first);
  if (first) {
    divide_momentum();
    hold_fixed(*c_.node_velocity);
    for (const auto& condition : cycle_->conditions) condition->limit_velocity();
    move(true, false);
    gather_cells(false, true);
  }
}

template <int dim>
void DeformingSkeleton<dim>::gather_cells(bool motion, bool force) {
  const GatherParts parts{motion, force, plan_->problem.skeleton.locking == LockingRemedy::b_bar,
                          covered_ ? covered_->volumes() : nullptr};
  over_chunks([&parts](const SoilMotion<dim>& soil, std::span<const Block> blocks, std::size_t, std::size_t) {
    soil.gather(blocks, parts);
  });
}

/// Accelerations that the problem gives to the points, at the beginning of the step.
template <int dim>
void DeformingSkeleton<dim>::push() {
  for (const Block& block : plan_->fields.points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      Vector<dim> began;
      for (int a = 0; a < dim; ++a) began[a] = (*c_.initial_position)[a][p];
      const Vector<dim> given = plan_->problem.body_acceleration(began, plan_->clock.time);
      for (int a = 0; a < dim; ++a) (*body_)[a][p] = given[a];
    }
  over_chunks([this](const SoilMotion<dim>& soil, std::span<const Block> blocks, std::size_t, std::size_t) {
    soil.push(blocks, *body_);
  });
}

/// "velocity" from momentum to velocity.
template <int dim>
void DeformingSkeleton<dim>::divide_momentum() {
  const double* mass = (*c_.node_mass)[0];
  for (int a = 0; a < dim; ++a) per_mass(active_->runs(), (*c_.node_velocity)[a], mass, (*c_.node_velocity)[a]);
}

template <int dim>
void DeformingSkeleton<dim>::add_weight() {
  const double* mass = (*c_.node_mass)[0];
  for (int a = 0; a < dim; ++a) {
    const double g = (*gravity_)[a][0];
    double* force = (*c_.node_force)[a];
    if (g == 0) continue;
    for (const NodeRun& run : active_->runs())
      for (std::size_t i = run.first; i < run.last; ++i) force[i] += mass[i] * g;
  }
}

/// II: a_i = f_i/m_i with weight, conditions, damping.
template <int dim>
void DeformingSkeleton<dim>::accelerate() {
  if (plan_->problem.skeleton.update != StressUpdate::usf) divide_momentum();
  if (gravity_ != nullptr) add_weight();
  for (const auto& condition : cycle_->conditions) condition->add_force();
  if (body_ != nullptr) push();  // a load, to who tells loads from stress
  for (const auto& condition : cycle_->conditions) condition->see_force();
  if (plan_->problem.skeleton.update == StressUpdate::usl || plan_->problem.skeleton.update == StressUpdate::usf ||
      plan_->problem.skeleton.transfer == Transfer::apic)
    find_light();
  const double* mass = (*c_.node_mass)[0];
  const double damping = cycle_->damping;
  for (int a = 0; a < dim; ++a) {
    double *force = (*c_.node_force)[a], *acceleration = (*c_.node_acceleration)[a];
    const double* v = (*c_.node_velocity)[a];
    if (damping > 0)
      for (const NodeRun& run : active_->runs())
        for (std::size_t i = run.first; i < run.last; ++i)
          if (v[i] != 0) force[i] -= damping * std::copysign(std::abs(force[i]), v[i]);
    per_mass(active_->runs(), force, mass, acceleration);
  }
  stop_fixed();
  for (const auto& condition : cycle_->conditions) condition->limit_acceleration();
}

template <int dim>
void DeformingSkeleton<dim>::find_light() {
  constexpr double share = 0.1;
  double heaviest = 0;
  for (const NodeRun& run : active_->runs())
    for (std::size_t i = run.first; i < run.last; ++i) heaviest = std::max(heaviest, (*c_.node_mass)[0][i]);
  light_ = share * heaviest;
}

/// III: points take the motion of the nodes; MUSL: and give it back.
template <int dim>
void DeformingSkeleton<dim>::points() {
  const SkeletonScheme& scheme = plan_->problem.skeleton;
  const bool back = scheme.update == StressUpdate::musl;
  if (c_.node_new_velocity != nullptr)
    for (int a = 0; a < dim; ++a)
      for (const NodeRun& run : active_->runs())
        for (std::size_t i = run.first; i < run.last; ++i)
          (*c_.node_new_velocity)[a][i] =
              (*c_.node_velocity)[a][i] +
              (scheme.transfer == Transfer::apic ? strained(i) : 1.0) * cycle_->dt * (*c_.node_acceleration)[a][i];
  if (back)
    for (int a = 0; a < dim; ++a)
      for (const NodeRun& run : active_->runs())
        std::fill((*c_.node_velocity)[a] + run.first, (*c_.node_velocity)[a] + run.last, 0.0);
  const TransferParts parts{cycle_->dt, scheme.pic, back, light_};
  over_chunks([&parts](const SoilMotion<dim>& soil, std::span<const Block> blocks, std::size_t, std::size_t) {
    soil.points(blocks, parts);
  });
}

/// The velocities that strain and move the points: mapped back (MUSL, Eq. 14) or the nodes' own.
template <int dim>
void DeformingSkeleton<dim>::velocity() {
  const double dt = cycle_->dt;
  if (plan_->problem.skeleton.update == StressUpdate::musl) {
    divide_momentum();
    for (const auto& condition : cycle_->conditions) condition->see_velocity();
    hold_fixed(*c_.node_velocity);
  } else {
    for (int a = 0; a < dim; ++a)
      for (const NodeRun& run : active_->runs())
        for (std::size_t i = run.first; i < run.last; ++i)
          (*c_.node_velocity)[a][i] += strained(i) * dt * (*c_.node_acceleration)[a][i];
    hold_fixed(*c_.node_velocity);
  }
  for (const auto& condition : cycle_->conditions) condition->limit_velocity();
  for (int a = 0; a < dim; ++a) {
    double* u = (*c_.node_displacement)[a];
    const double* v = (*c_.node_velocity)[a];
    for (const NodeRun& run : active_->runs())
      for (std::size_t i = run.first; i < run.last; ++i) u[i] += dt * v[i];
  }
}

/// IV, V and VIII.
template <int dim>
void DeformingSkeleton<dim>::move(bool strain, bool move) {
  const MoveParts parts{cycle_->dt, strain, move, plan_->problem.skeleton.locking == LockingRemedy::b_bar};
  over_chunks([&](const SoilMotion<dim>& soil, std::span<const Block> blocks, std::size_t chunk, std::size_t number) {
    MoveFindings& found = found_[number * chunks_->size() + chunk];
    if (strain) found.wave = Lanes(0.0);
    found.motion = Lanes(0.0);
    found.leaving = &migration_->leaving(chunk);
    soil.move(blocks, parts, found);
  });
  if (move) keep_rates();
}

template <int dim>
void DeformingSkeleton<dim>::find_rates() {
  refresh();
  over_chunks([&](const SoilMotion<dim>& soil, std::span<const Block> blocks, std::size_t chunk, std::size_t number) {
    MoveFindings& found = found_[number * chunks_->size() + chunk];
    found.wave = found.motion = Lanes(0.0);
    soil.rates(blocks, found);
  });
  keep_rates();
}

template <int dim>
void DeformingSkeleton<dim>::keep_rates() {
  for (std::size_t soil = 0; soil < soils_.size(); ++soil) {
    Lanes wave(0.0), motion(0.0);
    for (std::size_t chunk = 0; chunk < chunks_->size(); ++chunk) {
      const MoveFindings& found = found_[soil * chunks_->size() + chunk];
      wave = max(wave, found.wave);
      motion = max(motion, found.motion);
    }
    (*rates_)[2 * static_cast<int>(soil)][0] = std::experimental::hmax(wave);
    (*rates_)[2 * static_cast<int>(soil) + 1][0] = std::experimental::hmax(motion);
  }
}

template <int dim>
void DeformingSkeleton<dim>::hold_fixed(Column& vector) const {
  for (int a = 0; a < dim; ++a)
    for (int node : fixed_[static_cast<std::size_t>(a)]) vector[a][node] = 0;
}

/// What is held comes to rest within the step, v_i + dt a_i = 0: the side takes the momentum that points bring to its
/// nodes. With a_i = 0 a point beside a held side would keep its velocity for ever, and FLIP would press it onto it.
template <int dim>
void DeformingSkeleton<dim>::stop_fixed() const {
  for (int a = 0; a < dim; ++a) {
    const double* v = (*c_.node_velocity)[a];
    double* acceleration = (*c_.node_acceleration)[a];
    for (int node : fixed_[static_cast<std::size_t>(a)]) acceleration[node] = -v[node] / cycle_->dt;
  }
}

#define WETFRONT_INSTANTIATE(d)                         \
  template void DeformingSkeleton<d>::gather();         \
  template void DeformingSkeleton<d>::accelerate();     \
  template void DeformingSkeleton<d>::points();         \
  template void DeformingSkeleton<d>::velocity();       \
  template void DeformingSkeleton<d>::move(bool, bool); \
  template void DeformingSkeleton<d>::find_rates();
WETFRONT_INSTANTIATE(2)
WETFRONT_INSTANTIATE(3)
#undef WETFRONT_INSTANTIATE

}  // namespace wetfront::mpm
