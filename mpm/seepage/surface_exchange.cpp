#include "mpm/seepage/surface_exchange.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/time_record.h"
#include "mpm/record/water_ledger.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

namespace {

/// A level that rises past a piece inside a cell wets it over this part of the cell: below the error of any mesh.
constexpr double wetting_height = 0.01;
/// Shorter ones are not steps but the look ahead from which the first step after a break is chosen.
constexpr double shortest_step = 1.5e-9;  // s
/// Demand fades out over this part of the least pressure (plus 1 Pa) below it.
constexpr double fading = 1e-4;

template <int dim>
double height(const StagePlan<dim>& plan, const Vector<dim>& x) {
  return dot<dim>(x, upward(plan.problem));
}

template <int dim>
double specific_weight(const Problem<dim>& problem) {
  return problem.water->density * length<dim>(problem.gravity);
}

}  // namespace

template <int dim>
typename SurfaceExchange<dim>::Site& SurfaceExchange<dim>::site_of(const Outlet<dim>& outlet) {
  for (Site& site : sites_)
    if (site.outlet.piece == outlet.piece && (outlet.piece >= 0 || site.outlet.node[0] == outlet.node[0])) {
      site.outlet.size += outlet.piece >= 0 ? 0 : outlet.size;
      site.outlet.film = std::max(site.outlet.film, outlet.film);
      return site;
    }
  sites_.push_back({});
  sites_.back().outlet = outlet;
  return sites_.back();
}

template <int dim>
void SurfaceExchange<dim>::add_outlets(StagePlan<dim>& plan, int condition) {
  const WaterBoundary& entry = plan.problem.water_boundary[static_cast<std::size_t>(condition)];
  const auto* pressure = std::get_if<PressureSide>(&entry);
  const auto* head = std::get_if<TotalHeadSide>(&entry);
  const bool held = pressure != nullptr || head != nullptr;
  const auto side = std::visit([](const auto& b) { return b.side; }, entry);
  if (!exchanges(entry) && !(held && side == free_surface)) return;
  const Origin origin = std::visit([](const auto& b) { return b.origin; }, entry);
  const char* who = held                                            ? "a prescribed pressure"
                    : std::holds_alternative<FluxSide>(entry)       ? "a flux"
                    : std::holds_alternative<WaterLevelSide>(entry) ? "a water level"
                                                                    : "rainfall";
  const auto& surface = water_->surface(plan);
  const auto found = outlets(plan, surface, side, who, origin);
  if (wants_sky(entry)) check_rain(plan, surface, found, side, has_moved_, origin);
  for (const Outlet<dim>& outlet : found) {
    const auto is_held = [&outlet](const auto& h) { return outlet.piece < 0 && h.node == outlet.node[0]; };
    if (std::any_of(water_->held.begin(), water_->held.end(), is_held)) continue;  // a held pressure wins
    Site& site = site_of(outlet);
    for (int i = 0; i < outlet.count; ++i) {
      double along = 0;
      for (int a = 0; a < dim; ++a)
        along += outlet.area[a] * (plan.fields.grid.node(outlet.node[i])[a] - outlet.centre[a]);
      site.beyond[static_cast<std::size_t>(i)] = outlet.piece >= 0 && along > 0;
    }
    if (held) site.held = condition;
    if (std::holds_alternative<WaterLevelSide>(entry)) site.level = condition;
    if (!held)
      site.catchments.push_back({condition, std::holds_alternative<FluxSide>(entry) ? outlet.size : outlet.open, 0, 0});
  }
}

template <int dim>
void SurfaceExchange<dim>::collect(StagePlan<dim>& plan) {
  sites_.clear();
  for (std::size_t c = 0; c < plan.problem.water_boundary.size(); ++c) add_outlets(plan, static_cast<int>(c));
}

/// What holds in the step from `begin` to `end`: rain of its beginning (steps end where it changes), levels and
/// pressures of its end.
template <int dim>
void SurfaceExchange<dim>::set_time(const StagePlan<dim>& plan, double begin, double end) {
  const auto& conditions = plan.problem.water_boundary;
  starting_ = end - begin < shortest_step;
  std::vector<Weather> weather;
  std::vector<double> value, middle;  // level or total head [m], pressure [Pa]
  for (const auto& condition : conditions) {
    weather.push_back(weather_of(condition, begin));
    value.push_back(0);
    middle.push_back(0);
    if (const auto* level = std::get_if<WaterLevelSide>(&condition)) {
      value.back() = value_until(level->level, end);
      middle.back() = value_until(level->level, 0.5 * (begin + end));
    }
    if (const auto* head = std::get_if<TotalHeadSide>(&condition)) value.back() = value_until(head->head, end);
    if (const auto* pressure = std::get_if<PressureSide>(&condition))
      value.back() = pressure->record.time.empty() ? pressure->pressure : value_until(pressure->record, end);
  }
  const double weight = specific_weight(plan.problem);
  std::erase_if(water_->held, [&](const auto& held) {
    return std::holds_alternative<WaterLevelSide>(conditions[static_cast<std::size_t>(held.condition)]);
  });
  for (Site& site : sites_) {
    const double z = height<dim>(plan, site.outlet.centre);
    site.wetted = site.outside = site.offered = site.demanded = 0;
    site.least_pressure = -std::numeric_limits<double>::infinity();
    if (site.held >= 0) {
      const auto c = static_cast<std::size_t>(site.held);
      site.wetted = 1;
      site.outside = std::holds_alternative<TotalHeadSide>(conditions[c]) ? weight * (value[c] - z) : value[c];
      if (const auto* p = std::get_if<PressureSide>(&conditions[c]); p != nullptr && p->initial)
        site.outside = site.outlet.at(plan.problem.initial_pressure.data());
      continue;
    }
    if (site.level >= 0) {
      const double above = value[static_cast<std::size_t>(site.level)] - z;
      const double over = wetting_height * plan.fields.grid.smallest_altitude(site.outlet.cell);
      site.wetted = std::clamp(above / over, 0.0, 1.0);
      site.outside = std::max(weight * above, 0.0);
      if (site.outlet.piece < 0) {
        // A node of the grid is held while it is under water. Steps end where the level passes it: the middle tells.
        site.wetted = middle[static_cast<std::size_t>(site.level)] >= z ? 1 : 0;
        if (site.wetted > 0) water_->held.push_back({site.outlet.node[0], weight * above, site.level});
      }
    }
    for (Catchment& catchment : site.catchments) {
      const Weather& w = weather[static_cast<std::size_t>(catchment.condition)];
      catchment.offered = (1 - site.wetted) * catchment.area * w.offered;
      catchment.demanded = (1 - site.wetted) * catchment.area * w.demanded;
      site.offered += catchment.offered;
      site.demanded += catchment.demanded;
      if (w.demanded > 0) site.least_pressure = std::max(site.least_pressure, w.least_pressure);
    }
  }
}

template <int dim>
typename SurfaceExchange<dim>::Flow SurfaceExchange<dim>::flow(const Site& site, double p) const {
  Flow flow;
  // The look ahead asks what the soil would take or give at its own conductance, not what the film could pass.
  const double film = site.outlet.film * site.outlet.size * (starting_ ? 1 / film_conductance : 1);
  if (site.wetted > 0) {
    const double held = site.wetted * film;
    flow.through_water = flow.inflow = held * (site.outside - p);
    flow.slope = -held;
  }
  if (site.wetted >= 1) return flow;
  double evaporation_slope = 0;
  if (site.demanded > 0) {
    const double over = fading * std::abs(site.least_pressure) + 1;
    const double met = 1 + (p - site.least_pressure) / over;
    flow.evaporated = site.demanded * std::clamp(met, 0.0, 1.0);
    if (met > 0 && met < 1) evaporation_slope = site.demanded / over;
  }
  const double net = site.offered - flow.evaporated;
  const double capacity = -(1 - site.wetted) * film * p;
  if (capacity <= net) {
    const double released = net - capacity;
    flow.run_off = std::min(released, site.offered);
    flow.seeping = released - flow.run_off;
    flow.inflow += capacity;
    flow.slope -= (1 - site.wetted) * film;
  } else {
    flow.inflow += net;
    flow.slope -= evaporation_slope;
  }
  return flow;
}

/// Where the film begins to refuse water its stiff branch meets one of next to no stiffness: from there Newton's method
/// flies far into the film, and no step length that the line search tries brings it back. It stops at the kink.
template <int dim>
void SurfaceExchange<dim>::stop_at_kinks(const std::vector<double>& start, double* trial) const {
  for (const Site& site : sites_) {
    if (site.outlet.piece >= 0 || site.wetted > 0) continue;
    const auto node = static_cast<std::size_t>(site.outlet.node[0]);
    // Just on the film's side of the kink, so that its slope is there in the next iteration.
    const double kink = -site.offered / (site.outlet.film * site.outlet.size) * (1 - 1e-12);
    if (start[node] < kink && trial[node] > kink) trial[node] = kink;
  }
}

template <int dim>
void SurfaceExchange<dim>::add_flows() {
  const double* trial = (*water_->trial)[0];
  const auto matrix = water_->matrix->values();
  for (const Site& site : sites_) {
    const Outlet<dim>& outlet = site.outlet;
    if (outlet.piece < 0 && site.wetted > 0) continue;  // held: the reaction of its balance is booked by the step
    const Flow f = flow(site, outlet.at(trial));
    const auto n = static_cast<std::size_t>(outlet.count);
    for (std::size_t i = 0; i < n; ++i) {
      if (starting_ && site.wetted > 0 && site.beyond[i]) continue;
      (*water_->inflow)[0][outlet.node[i]] += outlet.weight[i] * f.inflow;
      for (std::size_t j = 0; j < n; ++j)
        matrix[static_cast<std::size_t>(site.slots[i * n + j])] += outlet.weight[i] * outlet.weight[j] * f.slope;
    }
    book(site, f);
  }
}

template <int dim>
void SurfaceExchange<dim>::book(const Site& site, const Flow& f) {
  const Outlet<dim>& outlet = site.outlet;
  for (std::size_t i = 0; i < static_cast<std::size_t>(outlet.count); ++i) {
    const auto node = static_cast<std::size_t>(outlet.node[i]);
    (*asked_)[0][node] += outlet.weight[i] * site.offered;
    (*imposed_)[0][node] += outlet.weight[i] * (site.offered - f.run_off);
    (*run_off_)[0][node] += outlet.weight[i] * f.run_off;
    (*water_->outflow)[0][node] += outlet.weight[i] * (f.seeping + f.evaporated - f.through_water);
  }
  const int owner = site.held >= 0 ? site.held : site.level >= 0 ? site.level : site.catchments.front().condition;
  water_->add_to_side(owner, side_outflow, f.seeping - f.through_water);
  // What several conditions bring to one place is refused, and met, in proportion.
  for (const auto& [condition, area, offered, demanded] : site.catchments) {
    water_->add_to_side(condition, side_asked, offered);
    water_->add_to_side(condition, side_demanded, demanded);
    if (offered > 0) water_->add_to_side(condition, side_run_off, f.run_off * offered / site.offered);
    if (demanded > 0) water_->add_to_side(condition, side_evaporated, f.evaporated * demanded / site.demanded);
  }
}

template <int dim>
void SurfaceExchange<dim>::add_ledger(StagePlan<dim>& plan) {
  Column& ledger = plan.require_on_run("water ledger");
  const Column &asked = plan.require_on_nodes("rain asked"), &imposed = plan.require_on_nodes("rain imposed"),
               &run_off = plan.require_on_nodes("rain run-off");
  plan.add(Phase::carry, "rain ledger", [&ledger, &asked, &imposed, &run_off] {
    ledger[ledger_rain_asked][0] = asked.sum();
    ledger[ledger_infiltrated][0] = imposed.sum();
    ledger[ledger_run_off][0] = run_off.sum();
  });
  plan.at_finish([this, &plan, &asked, &imposed, &run_off](meshes::FieldHistory& history) {
    std::vector<int> nodes;
    for (const Site& site : sites_)
      if (!site.catchments.empty())
        nodes.insert(nodes.end(), site.outlet.node.begin(), site.outlet.node.begin() + site.outlet.count);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    history.rain_by_node.clear();
    for (int node : nodes) {
      const auto i = static_cast<std::size_t>(node);
      history.rain_by_node.push_back({node, plan.problem.mesh.nodes[i], asked[0][i], imposed[0][i], run_off[0][i]});
    }
  });
}

/// Steps end where a level passes a node: what is held there jumps.
template <int dim>
void SurfaceExchange<dim>::add_passings(StagePlan<dim>& plan) {
  std::vector<double> known = plan.breaks();
  known.insert(known.end(), plan.problem.output_times.begin(), plan.problem.output_times.end());
  // Nodes of one height are passed at times that differ by round-off: as short as that no step can be.
  const double close = 1e-9 * plan.problem.stages.back().end_time;
  std::sort(known.begin(), known.end());
  std::vector<double> passings;
  for (std::size_t c = 0; c < plan.problem.water_boundary.size(); ++c) {
    const auto* level = std::get_if<WaterLevelSide>(&plan.problem.water_boundary[c]);
    if (level == nullptr) continue;
    std::vector<double> heights;
    for (const Site& site : sites_)
      if (site.level == static_cast<int>(c) && site.outlet.piece < 0)
        heights.push_back(height<dim>(plan, site.outlet.centre));
    std::sort(heights.begin(), heights.end());
    const auto& [time, value] = level->level;
    for (std::size_t i = 0; i + 1 < time.size(); ++i) {
      const auto [low, high] = std::minmax(value[i], value[i + 1]);
      for (auto z = std::upper_bound(heights.begin(), heights.end(), low); z != heights.end() && *z < high; ++z)
        passings.push_back(time[i] + (time[i + 1] - time[i]) * (*z - value[i]) / (value[i + 1] - value[i]));
    }
  }
  std::sort(passings.begin(), passings.end());
  double last = -1;
  for (double t : passings) {
    const auto next = std::lower_bound(known.begin(), known.end(), t - close);
    if ((next != known.end() && *next <= t + close) || t - last <= close) continue;
    plan.add_break(t);
    last = t;
  }
}

template <int dim>
void SurfaceExchange<dim>::join(StagePlan<dim>& plan) {
  water_->keep_side_ledger(plan);
  asked_ = &water_->cumulate(plan, "rain asked", "Q_rain");
  imposed_ = &water_->cumulate(plan, "rain imposed", "Q_in");
  run_off_ = &water_->cumulate(plan, "rain run-off", "Q_run");
  plan.require_on_nodes("pressure");
  const bool rigid =
      std::ranges::none_of(plan.problem.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
  has_moved_ = !rigid && plan.fields.points.columns.find_allocated("water") != nullptr;
  collect(plan);
  has_moved_ = !rigid;
  add_passings(plan);
  const bool follows = std::ranges::any_of(plan.problem.water_boundary, [](const auto& boundary) {
    return std::visit([](const auto& b) { return b.side == free_surface; }, boundary);
  });
  const auto find_sites = [this, &plan, follows, rigid] {
    // A side of the mesh stays the surface of a body that settles, so long as there is soil behind it.
    if ((follows || rigid) && water_->surface(plan).update()) collect(plan);
    for (const Site& site : sites_)
      if (!plan.fields.points.occupied(site.outlet.cell))
        throw StepFailed("the soil has left the side on which " + this->name() +
                         " acts. Let it act on the free surface, which moves with the soil");
    for (Site& site : sites_)
      for (int i = 0; i < site.outlet.count; ++i)
        for (int j = 0; j < site.outlet.count; ++j)
          site.slots[static_cast<std::size_t>(i * site.outlet.count + j)] = water_->matrix->slot(
              site.outlet.node[static_cast<std::size_t>(i)], site.outlet.node[static_cast<std::size_t>(j)]);
  };
  plan.at_ready(find_sites);
  water_->moved.push_back([find_sites] {
    try {
      find_sites();
    } catch (const CannotPlan& refused) {
      throw StepFailed(refused.what());
    }
  });
  water_->before_solve.push_back([this, &plan](double begin, double end) { set_time(plan, begin, end); });
  water_->limits.push_back([this](const auto& start, double* trial) { stop_at_kinks(start, trial); });
  water_->terms.push_back(&plan.add_iterated(Phase::pressure, this->name(), [this] { add_flows(); }));
  add_ledger(plan);
}

template class SurfaceExchange<2>;
template class SurfaceExchange<3>;

}  // namespace wetfront::mpm
