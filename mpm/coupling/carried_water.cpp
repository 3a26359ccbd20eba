#include "mpm/coupling/carried_water.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// What is not carried by points is forgotten over half a cell of motion.
constexpr double forgetting = 2;
/// Points this close to full (in S) tell their pressure badly: between here and full their own water counts less and
/// less, linearly. 0.01 of S is 0.9 kPa of suction in the seed paper's sand, 2 Pa of it per 1e-5 of S there.
constexpr double nearly_full = 0.01;

}  // namespace

template <int dim>
CarriedWater<dim>::CarriedWater(StagePlan<dim>& plan, const SeepageColumns& columns, Column& trial,
                                const std::vector<SoilContent>& contents, const std::string& grain_mass)
    : plan_(plan), c_(columns), trial_(trial), contents_(contents) {
  volume_ = &plan.require_on_points("volume");
  mass_ = &plan.require_on_points(grain_mass);
  position_ = &plan.require_on_points("position");
  shape_ = &plan.require_on_points("shape value");
  gradient_ = &plan.require_on_points("shape gradient");
  displacement_ = &plan.require_on_nodes("displacement");
  water_ = &plan.provide_on_points({"water", "W", dim == 2 ? "m2" : "m3"});
  carried_ = &plan.provide_on_points({"carried pressure", "p", "Pa"});
  slope_ = &plan.provide_on_points({"pressure gradient", "grad p", "Pa/m", dim});
}

template <int dim>
void CarriedWater<dim>::begin() {
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double p = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) p += (*shape_)[i][q] * (*c_.pressure)[0][block.nodes[i]];
      (*carried_)[0][q] = p;
      (*water_)[0][q] = pores(q, soil_of(block)) * content_of(block).at(p).value;
    }
}

template <int dim>
void CarriedWater<dim>::find_gradients() {
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      for (int a = 0; a < dim; ++a) {
        double slope = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i)
          slope += (*gradient_)[i * dim + a][q] * (*c_.pressure)[0][block.nodes[i]];
        (*slope_)[a][q] = slope;
      }
}

template <int dim>
void CarriedWater<dim>::map(std::vector<double>& mapped, std::vector<double>& pores_at) {
  mapped.assign(c_.pressure->size(), 0.0);
  pores_at.assign(c_.pressure->size(), 0.0);
  for (const Block& block : plan_.fields.points.blocks()) {
    const Soil& soil = soil_of(block);
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const double held = pores(q, soil);
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const auto node = static_cast<std::size_t>(block.nodes[i]);
        const Vector<dim>& x = plan_.fields.grid.node(block.nodes[i]);
        double p = (*carried_)[0][q];
        for (int a = 0; a < dim; ++a) p += (*slope_)[a][q] * (x[a] - (*position_)[a][q]);
        mapped[node] += (*shape_)[i][q] * held * p;
        pores_at[node] += (*shape_)[i][q] * held;
      }
    }
  }
  for (std::size_t i = 0; i < mapped.size(); ++i)
    if (pores_at[i] > 0) mapped[i] /= pores_at[i];
}

template <int dim>
void CarriedWater<dim>::before_motion() {
  find_gradients();
  map(mapped_, mapped_pores_);
  displaced_.assign(displacement_->values().begin(), displacement_->values().end());
}

/// Unsaturated points: their water says what their pressure is.
template <int dim>
void CarriedWater<dim>::follow_water() {
  for (const Block& block : plan_.fields.points.blocks()) {
    const Soil& soil = soil_of(block);
    const TabulatedCurve& curve = content_of(block).curve();
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double share = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i)
        share += (*shape_)[i][q] * lambda_[static_cast<std::size_t>(block.nodes[i])];
      const double held = (*water_)[0][q] / pores(q, soil), lacks = curve.s_max() - held;
      share *= std::clamp(lacks / nearly_full, 0.0, 1.0);
      if (!(share > 0)) continue;
      const double effective = (held - curve.s_min()) / (curve.s_max() - curve.s_min());
      if (!(effective > 1e-6)) continue;  // beyond what the curve can tell
      (*carried_)[0][q] += share * (-curve.suction_at(effective) - (*carried_)[0][q]);
    }
  }
}

/// Points take what the nodes around them have gained; answer_mapped_: what of it they bring back to the nodes.
template <int dim>
void CarriedWater<dim>::take_answer(std::span<const double> answer) {
  std::vector<double> pores_at(c_.pressure->size(), 0.0);
  answer_mapped_.assign(c_.pressure->size(), 0.0);
  for (const Block& block : plan_.fields.points.blocks()) {
    const Soil& soil = soil_of(block);
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double gained = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i)
        gained += (*shape_)[i][q] * answer[static_cast<std::size_t>(block.nodes[i])];
      (*carried_)[0][q] += gained;
      const double held = pores(q, soil);
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        answer_mapped_[static_cast<std::size_t>(block.nodes[i])] += (*shape_)[i][q] * held * gained;
        pores_at[static_cast<std::size_t>(block.nodes[i])] += (*shape_)[i][q] * held;
      }
    }
  }
  for (std::size_t i = 0; i < pores_at.size(); ++i)
    if (pores_at[i] > 0) answer_mapped_[i] = answer[i] - answer_mapped_[i] / pores_at[i];
}

template <int dim>
void CarriedWater<dim>::after_motion(std::span<const double> answer) {
  const std::size_t nodes = c_.pressure->size();
  double shortest = plan_.fields.grid.smallest_altitude(0);
  lambda_.assign(nodes, 0.0);
  for (std::size_t i = 0; i < nodes; ++i) {
    double square = 0;
    for (int a = 0; a < dim; ++a) {
      const double d = (*displacement_)[a][i] - displaced_[static_cast<std::size_t>(a) * nodes + i];
      square += d * d;
    }
    lambda_[i] = std::min(1.0, forgetting * std::sqrt(square) / shortest);
  }
  if (!answer.empty()) take_answer(answer);
  follow_water();
  map(new_mapped_, new_pores_);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!(new_pores_[i] > 0)) continue;
    if (!(mapped_pores_[i] > 0)) {
      for (Column* column : {c_.pressure, c_.pressure_before, c_.pressure_earlier, &trial_})
        (*column)[0][i] = new_mapped_[i];
      continue;
    }
    // What the step under way adds to p^n is not the points' yet: it moves with the nodes until they take it.
    double change = new_mapped_[i] - mapped_[i] - lambda_[i] * ((*c_.pressure)[0][i] - mapped_[i]);
    if (!answer.empty()) change += answer_mapped_[i];
    for (Column* column : {c_.pressure, c_.pressure_before, c_.pressure_earlier, &trial_}) (*column)[0][i] += change;
  }
}

/// Where soils meet a node's gain dW = sum_r P_r d(content_r) + what is left (pores that changed) is no even share of
/// its pores: those of soil r take d(content_r) each, and all alike of what is left.
template <int dim>
void CarriedWater<dim>::find_excess() {
  const std::size_t soils = contents_.size(), nodes = c_.pressure->size();
  if (soils < 2) return;
  excess_.assign(soils, std::vector<double>(nodes));
  for (std::size_t i = 0; i < nodes; ++i) {
    double taken = 0, room = 0;
    int meet = 0;
    for (std::size_t r = 0; r < soils; ++r) {
      const double pores = (*c_.pore_volume)[static_cast<int>(r)][i];
      if (!(pores > 0)) continue;
      const double change =
          contents_[r].at((*c_.pressure)[0][i]).value - contents_[r].at((*c_.pressure_before)[0][i]).value;
      excess_[r][i] = change;
      taken += pores * change;
      room += pores;
      ++meet;
    }
    for (std::size_t r = 0; r < soils; ++r) excess_[r][i] = meet > 1 ? excess_[r][i] - taken / room : 0.0;
  }
}

template <int dim>
void CarriedWater<dim>::take_increments() {
  const double *now = (*c_.pressure)[0], *before = (*c_.pressure_before)[0];
  const double *stored = (*c_.stored)[0], *stored_before = (*c_.stored_before)[0];
  map(new_mapped_, new_pores_);
  find_excess();
  for (const Block& block : plan_.fields.points.blocks()) {
    const Soil& soil = soil_of(block);
    const std::vector<double>* excess = excess_.empty() ? nullptr : &excess_[static_cast<std::size_t>(block.soil)];
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double gained = 0, risen = 0, p = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const auto node = static_cast<std::size_t>(block.nodes[i]);
        const double n = (*shape_)[i][q];
        if (new_pores_[node] > 0) gained += n * (stored[node] - stored_before[node]) / new_pores_[node];
        if (excess != nullptr) gained += n * (*excess)[node];
        risen += n * (now[node] - before[node]);
        p += n * now[node];
      }
      (*water_)[0][q] += pores(q, soil) * gained;
      (*carried_)[0][q] += risen;
      (*c_.point_pressure)[0][q] = p;
      (*c_.point_saturation)[0][q] = content_of(block).saturation(p);
    }
  }
}

template <int dim>
double CarriedWater<dim>::total() const {
  double sum = 0;
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) sum += (*water_)[0][q];
  return sum;
}

template class CarriedWater<2>;
template class CarriedWater<3>;

}  // namespace wetfront::mpm
