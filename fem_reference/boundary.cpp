#include "fem_reference/boundary.h"

#include <algorithm>
#include <map>

namespace wetfront::fem_reference {

Boundary::Boundary(const RichardsProblem& problem, const Discretisation& space) : problem_(problem) {
  std::map<int, HeldDof> held;
  for (int c = 0; c < condition_count(); ++c) {
    const BoundaryCondition& condition = problem.boundary[c];
    for (const SideShare& share : space.sides[c]) {
      if (std::holds_alternative<FreeDrainageSide>(condition)) {
        if (share.horizontal_area < 0) drains_.push_back({share, c});
      } else if (const auto* head = std::get_if<HeadSide>(&condition)) {
        // A head wins over rain where two sides meet.
        held[share.dof] = {share.dof, HeldDof::Kind::head, c, head->head, 0, {}};
      } else {
        HeldDof& dof = held.try_emplace(share.dof, HeldDof{share.dof, HeldDof::Kind::rain, c, 0, 0, {}}).first->second;
        // Rain falls vertically: a face that looks down catches none.
        if (dof.kind == HeldDof::Kind::rain) dof.catchment.emplace_back(c, std::max(0.0, share.horizontal_area));
      }
    }
  }
  for (auto& [dof, entry] : held) held_.push_back(std::move(entry));
}

const meshes::RainRecord& Boundary::record(int condition) const {
  return std::get<RainSide>(problem_.boundary[condition]).rain;
}

void Boundary::set_time(double time) {
  for (HeldDof& held : held_) {
    held.rain = 0;
    for (const auto& [condition, area] : held.catchment) {
      held.rain += area * meshes::intensity_after(record(condition), time);
    }
  }
}

double Boundary::asked(const HeldDof& held, double time) const {
  double volume = 0;
  for (const auto& [condition, area] : held.catchment) {
    volume += area * meshes::depth_until(record(condition), time);
  }
  return volume;
}

const std::string& Boundary::side_name(int condition) const {
  return std::visit([](const auto& c) -> const std::string& { return c.side; }, problem_.boundary[condition]);
}

std::vector<double> Boundary::breaks() const {
  std::vector<double> times;
  for (const BoundaryCondition& condition : problem_.boundary) {
    if (const auto* rain = std::get_if<RainSide>(&condition)) {
      for (double t : rain->rain.start) {
        if (t > 0 && t < problem_.end_time) times.push_back(t);
      }
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace wetfront::fem_reference
