#pragma once

#include "mpm/boundary/outlets.h"
#include "mpm/seepage/exchange_weather.h"
#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Water through the film between soil and sky, inside the Newton step (README section 5): rain, ponding, seepage
/// faces, evaporation, flux per area, water levels, and pressures given where the surface lies inside cells.
///
///   offered O, demanded D, p = sum N_i(x_s) p_i, A the whole area, beta the conductance of the film:
///   e = D clamp(1 + (p - p_least)/eps, 0, 1)                 evaporation
///   q = min(O - e, -beta A p)                                what enters; what is refused runs off up to O,
///                                                            the rest seeps out
///   under water (a part w of a piece inside a cell):  q = w beta A (p_w - p) + (1 - w) (as above, O without what is
///   under water); nodes of the grid that are under water are held at p_w.
template <int dim>
class SurfaceExchange : public Effect<dim> {
 public:
  SurfaceExchange(const std::string& name, Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>(name, std::move(origin),
                    "Martinelli 2020, capacity inside Newton's method; mpm/README.md section 5"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  /// A condition at an outlet and the area it acts on: horizontal for rain, whole for a flux.
  struct Catchment {
    int condition;
    double area;                       ///< m^(dim-1)
    double offered = 0, demanded = 0;  ///< by it during the present step [m^dim/s]
  };
  /// An outlet, what meets there, and what holds there during the present step.
  struct Site {
    Outlet<dim> outlet;
    std::vector<Catchment> catchments;
    int level = -1, held = -1;  ///< conditions
    std::array<int, cell_nodes<dim> * cell_nodes<dim>> slots{};
    /// Nodes beyond the surface: the sliver of pores there follows a held pressure at once, so that the first step
    /// after a break is not chosen by it.
    std::array<bool, cell_nodes<dim>> beyond{};
    double offered = 0, demanded = 0, least_pressure = 0;  ///< m^dim/s, Pa
    double outside = 0;                                    ///< p in the water in front, or given [Pa]
    double wetted = 0;                                     ///< part that is under water, or where p is given [-]
  };
  struct Flow {
    double inflow = 0, slope = 0;  ///< into the soil [m^dim/s], d/dp
    double run_off = 0, seeping = 0, evaporated = 0, through_water = 0;
  };
  void collect(StagePlan<dim>& plan);
  void add_outlets(StagePlan<dim>& plan, int condition);
  void add_passings(StagePlan<dim>& plan);
  Site& site_of(const Outlet<dim>& outlet);
  void set_time(const StagePlan<dim>& plan, double begin, double end);
  Flow flow(const Site& site, double pressure) const;
  void stop_at_kinks(const std::vector<double>& start, double* trial) const;
  void add_flows();
  void book(const Site& site, const Flow& flow);
  void add_ledger(StagePlan<dim>& plan);

  std::shared_ptr<NodalWater<dim>> water_;
  std::vector<Site> sites_;
  /// A first step is being chosen: by what the soil takes, K_s/h, and not by how fast a film reaches a held pressure.
  bool starting_ = false;
  bool has_moved_ = false;                                             ///< the body, since the scene placed it
  Column *asked_ = nullptr, *imposed_ = nullptr, *run_off_ = nullptr;  ///< rates
};

}  // namespace wetfront::mpm
