#include "fem_reference/stage/boundary.h"

#include "fem_reference/soil/tensor.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// The record of a condition that is linear in time, or null.
const TimeRecord* moving_record(const BoundaryCondition& condition) {
  if (const auto* head = std::get_if<HeadSide>(&condition)) return head->record.time.empty() ? nullptr : &head->record;
  if (const auto* level = std::get_if<WaterLevelSide>(&condition)) return &level->level;
  return nullptr;
}

const HeadSide* varying_head(const BoundaryCondition& condition) {
  const auto* head = std::get_if<HeadSide>(&condition);
  return head != nullptr && head->varying ? head : nullptr;
}

double intensity(const meshes::RainRecord& record, double time) {
  return record.start.empty() ? 0 : meshes::intensity_after(record, time);
}

struct Exchange {
  double offered = 0, demanded = 0;  // m/s, >= 0
};

Exchange exchange(const BoundaryCondition& condition, double time) {
  if (const auto* rain = std::get_if<RainSide>(&condition)) {
    return {intensity(rain->rain, time), intensity(rain->evaporation, time)};
  }
  if (const auto* level = std::get_if<WaterLevelSide>(&condition)) return {intensity(level->rain, time), 0};
  if (const auto* flux = std::get_if<FluxSide>(&condition)) {
    const double inflow = intensity(flux->inflow, time);
    return {std::max(0.0, inflow), std::max(0.0, -inflow)};
  }
  return {};
}

double minimum_head(const BoundaryCondition& condition) {
  if (const auto* rain = std::get_if<RainSide>(&condition)) return rain->minimum_head;
  if (const auto* flux = std::get_if<FluxSide>(&condition)) return flux->minimum_head;
  return -std::numeric_limits<double>::infinity();
}

}  // namespace

Boundary::Boundary(const RichardsProblem& problem, const Discretisation& space)
    : problem_(problem), space_(space), index_(space.dof_count, -1), piece_(problem.boundary.size()) {
  for (int c = 0; c < condition_count(); ++c) {
    const BoundaryCondition& condition = problem.boundary[c];
    for (const SideShare& share : space.sides[c]) {
      if (std::holds_alternative<FreeDrainageSide>(condition)) add_drain(share, c);
      if (std::holds_alternative<HeadSide>(condition)) add_head(share, c, space);
      if (std::holds_alternative<WaterLevelSide>(condition)) add_level(share, c, space);
      // Rain falls vertically: a face that looks down catches none.
      const double caught = std::max(0.0, share.horizontal_area);
      if (std::holds_alternative<RainSide>(condition) || std::holds_alternative<WaterLevelSide>(condition)) {
        add_catchment(share, c, caught);
      }
      if (std::holds_alternative<FluxSide>(condition)) add_catchment(share, c, share.area);
    }
  }
  std::sort(held_.begin(), held_.end(), [](const HeldDof& a, const HeldDof& b) { return a.dof < b.dof; });
  for (std::size_t h = 0; h < held_.size(); ++h) {
    const bool fixed = held_[h].kind == HeldDof::Kind::head;
    const BoundaryCondition& owner = problem.boundary[held_[h].condition];
    if (moving_record(owner) != nullptr || varying_head(owner) != nullptr) moving_.push_back(static_cast<int>(h));
    if (fixed && std::holds_alternative<HeadSide>(owner)) held_[h].catchment.clear();
  }
  find_breaks(space);
  any_moving_ = space.ranks.any(!moving_.empty());
}

void Boundary::add_drain(const SideShare& share, int condition) {
  const meshes::Point pull = times(problem_.soils[share.soil].anisotropy, problem_.gravity_direction);
  double area = 0;
  for (int axis = 0; axis < 3; ++axis) area += share.normal_area[axis] * pull[axis];
  if (area > 0) drains_.push_back({share.dof, share.soil, area, condition});
}

HeldDof& Boundary::entry(int dof, int condition) {
  if (index_[dof] < 0) {
    index_[dof] = static_cast<int>(held_.size());
    HeldDof fresh{};
    fresh.dof = dof;
    fresh.kind = HeldDof::Kind::rain;
    fresh.condition = condition;
    held_.push_back(fresh);
  }
  return held_[index_[dof]];
}

void Boundary::add_head(const SideShare& share, int condition, const Discretisation& space) {
  const auto& side = std::get<HeadSide>(problem_.boundary[condition]);
  HeldDof& held = entry(share.dof, condition);
  held.kind = HeldDof::Kind::head;
  held.condition = condition;
  held.offset = side.total ? space.position[share.dof][meshes::up_axis(space.dim)] : 0;
  held.head = side.initial ? space.initial_head[share.dof] : side.head - held.offset;
}

void Boundary::add_level(const SideShare& share, int condition, const Discretisation& space) {
  HeldDof& held = entry(share.dof, condition);
  if (std::holds_alternative<HeadSide>(problem_.boundary[held.condition])) return;
  held.condition = condition;
  held.offset = space.position[share.dof][meshes::up_axis(space.dim)];
}

void Boundary::add_catchment(const SideShare& share, int condition, double area) {
  HeldDof& held = entry(share.dof, condition);
  for (HeldDof::Catchment& catchment : held.catchment) {
    if (catchment.condition == condition) {  // a dof between two soils has a share of each
      catchment.area += area;
      return;
    }
  }
  held.catchment.push_back({condition, area, 0, 0});
}

void Boundary::find_breaks(const Discretisation& space) {
  const auto add = [&](double t) {
    if (t > 0 && t < problem_.end_time) breaks_.push_back(t);
  };
  for (int c = 0; c < condition_count(); ++c) {
    const BoundaryCondition& condition = problem_.boundary[c];
    if (const auto* rain = std::get_if<RainSide>(&condition)) {
      for (double t : rain->rain.start) add(t);
      for (double t : rain->evaporation.start) add(t);
      for (double e : rain->evaporation.intensity) has_demand_ = has_demand_ || e > 0;
    }
    if (const auto* flux = std::get_if<FluxSide>(&condition)) {
      for (double t : flux->inflow.start) add(t);
      for (double q : flux->inflow.intensity) has_demand_ = has_demand_ || q < 0;
    }
    if (const TimeRecord* record = moving_record(condition)) {
      for (double t : record->time) add(t);
    }
    const auto* level = std::get_if<WaterLevelSide>(&condition);
    if (level == nullptr) continue;
    for (double t : level->rain.start) add(t);
    const auto& [time, value] = level->level;
    for (const HeldDof& held : held_) {
      if (held.condition != c) continue;
      for (std::size_t i = 0; i + 1 < time.size(); ++i) {
        const double from = value[i] - held.offset, to = value[i + 1] - held.offset;
        if (from * to < 0) add(time[i] + (time[i + 1] - time[i]) * from / (from - to));
      }
    }
  }
  breaks_ = space.ranks.gather(breaks_);  // a level passes other nodes on other ranks
  std::sort(breaks_.begin(), breaks_.end());
  // A level may pass two nodes of one height at times that differ by rounding, or a node at an output time: steps as
  // short as that no integrator makes.
  const double close = 1e-12 * problem_.end_time;
  for (double& time : breaks_) {
    const auto& outputs = problem_.output_times;
    const auto output = std::lower_bound(outputs.begin(), outputs.end(), time - close);
    if (output != outputs.end() && *output <= time + close) time = *output;
  }
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end(), [&](double a, double b) { return b - a <= close; }),
                breaks_.end());
}

double Boundary::middle_after(double time) const {
  const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), time);
  return 0.5 * (time + (next == breaks_.end() ? problem_.end_time : *next));
}

void Boundary::set_time(double time) {
  // Between two breaks every record is linear and every node is under water or not: the middle tells.
  const double middle = middle_after(time);
  for (int c = 0; c < condition_count(); ++c) {
    const TimeRecord* record = moving_record(problem_.boundary[c]);
    if (record == nullptr) continue;
    const auto& [t, v] = *record;
    const std::size_t i = std::upper_bound(t.begin(), t.end(), middle) - t.begin();
    if (i == 0 || i == t.size()) {
      piece_[c] = {time, i == 0 ? v.front() : v.back(), 0};
    } else {
      piece_[c] = {t[i - 1], v[i - 1], (v[i] - v[i - 1]) / (t[i] - t[i - 1])};
    }
  }
  for (HeldDof& held : held_) {
    held.asked = asked(held, time);
    held.demanded = demanded(held, time);
    held.since = time;
    held.rain = held.demand = 0;
    held.lowest = -std::numeric_limits<double>::infinity();
    if (std::holds_alternative<WaterLevelSide>(problem_.boundary[held.condition])) {
      const Piece& level = piece_[held.condition];
      const bool under_water = level.value + level.slope * (middle - level.time) >= held.offset;
      held.kind = under_water ? HeldDof::Kind::head : HeldDof::Kind::rain;
      held.head = held.head_rate = 0;
    }
    for (HeldDof::Catchment& catchment : held.catchment) {
      const BoundaryCondition& condition = problem_.boundary[catchment.condition];
      const Exchange now = held.kind == HeldDof::Kind::head ? Exchange{} : exchange(condition, time);
      catchment.rain = catchment.area * now.offered;
      catchment.demand = catchment.area * now.demanded;
      held.rain += catchment.rain;
      held.demand += catchment.demand;
      if (now.demanded > 0) held.lowest = std::max(held.lowest, minimum_head(condition));
    }
  }
  set_stage_time(time);
}

void Boundary::set_stage_time(double time) {
  for (int h : moving_) {
    HeldDof& held = held_[h];
    if (held.kind != HeldDof::Kind::head) continue;
    if (varying_head(problem_.boundary[held.condition]) != nullptr) {
      follow_function(held, time);
      continue;
    }
    const Piece& piece = piece_[held.condition];
    held.head = piece.value + piece.slope * (time - piece.time) - held.offset;
    held.head_rate = piece.slope;
  }
}

// The rate only starts the integrator, so a difference will do: one-sided at t = 0, before which nothing is defined.
void Boundary::follow_function(HeldDof& held, double time) const {
  const auto& head = varying_head(problem_.boundary[held.condition])->varying;
  const meshes::Point& place = space_.position[held.dof];
  const double step = 1e-5 * problem_.end_time;
  held.head = head(place, time);
  held.head_rate = time < step
                       ? (4 * head(place, time + step) - 3 * held.head - head(place, time + 2 * step)) / (2 * step)
                       : (head(place, time + step) - head(place, time - step)) / (2 * step);
}

const std::string& Boundary::side_name(int condition) const {
  return std::visit([](const auto& c) -> const std::string& { return c.side; }, problem_.boundary[condition]);
}

}  // namespace wetfront::fem_reference
