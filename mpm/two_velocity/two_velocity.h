#pragma once

#include "mpm/two_velocity/blow_up.h"
#include "mpm/two_velocity/moving_liquid.h"

#include <functional>
#include <string>

namespace wetfront::mpm {

/// The two-velocity pore liquid in a resting or an elastic skeleton, with implicit drag (`implicit-drag`) or explicit
/// (`explicit`, as the paper); README.md derives it.
///
/// Points carry the liquid velocity and their water W_p (what is conserved); the pressure of a cell is the inverse of
/// its water content. One cycle is steps I to IX of Lee et al. 2021 with the mass balance in flux form.
template <int dim>
class TwoVelocityLiquid : public Effect<dim> {
 public:
  /// `cycle`: of a skeleton that deforms; null where it rests.
  TwoVelocityLiquid(Origin origin, std::shared_ptr<TwoVelocityWater<dim>> water, SkeletonCycle<dim>* cycle)
      : Effect<dim>("two-velocity pore liquid", std::move(origin),
                    "Lee 2021 Eqs 1, 10 (drag sign corrected, drag explicit or implicit), 12 to 14; Eqs 4/18 in flux "
                    "form or as "
                    "printed; Eqs 5 to 8; mpm/two_velocity/README.md"),
        water_(std::move(water)),
        cycle_(cycle) {}
  void join(StagePlan<dim>& plan) override;

 private:
  void provide_columns(StagePlan<dim>& plan);
  void add_gather(StagePlan<dim>& plan);
  void add_momentum(StagePlan<dim>& plan);
  void add_mass_balance(StagePlan<dim>& plan);
  void add_rain_on_cut_surface(StagePlan<dim>& plan);
  void add_pressure(StagePlan<dim>& plan);
  void add_state(StagePlan<dim>& plan);
  void refuse_what_it_cannot_do(const StagePlan<dim>& plan) const;
  void join_resting(StagePlan<dim>& plan);
  void join_moving(StagePlan<dim>& plan);
  void add_moving_momentum(StagePlan<dim>& plan);
  void add_moving_balance(StagePlan<dim>& plan);
  void clear_left_nodes();
  void find_stiffness(StagePlan<dim>& plan);
  void add_limits(StagePlan<dim>& plan);
  template <class Drag>
  void add_pressure_limit(StagePlan<dim>& plan);
  void add_resting_limit(StagePlan<dim>& plan);
  void add_coupled_limit(StagePlan<dim>& plan);
  void add_ledger(StagePlan<dim>& plan);
  void add_output(StagePlan<dim>& plan);
  void take_over(StagePlan<dim>& plan);
  std::array<double, cell_nodes<dim>> centre_weights(const StagePlan<dim>& plan, const Block& block) const;
  /// A cell that is not full, when the stage begins.
  struct Taker {
    Block block;
    double slope, capacity;  ///< of its content and its water by pressure [1/Pa, m^dim/Pa]
  };
  template <class Law>
  void fit_full_cell(const StagePlan<dim>& plan, const Block& block, double content, const Law& law,
                     std::vector<Taker>& takers);
  void give_back(const StagePlan<dim>& plan, double change, const std::vector<Taker>& takers);
  void start_as_darcy(StagePlan<dim>& plan);
  void tell_hand_over(meshes::FieldHistory& history);
  void sum_cells(StagePlan<dim>& plan);
  Vector<dim> liquid_weight(const StagePlan<dim>& plan) const;

  std::shared_ptr<TwoVelocityWater<dim>> water_;
  SkeletonCycle<dim>* cycle_;                  ///< null where the skeleton rests
  std::unique_ptr<MovingLiquid<dim>> moving_;  ///< likewise
  Column* point_water_ = nullptr;              ///< W_p
  Column* point_velocity_ = nullptr;           ///< v_l
  Column* steps_ = nullptr;                    ///< the last dt
  bool outside_holds_ = true;                  ///< nodes that no cell with points has may hold something
  std::function<void()> content_, from_points_, forces_;
  std::unique_ptr<BlowUp<dim>> blow_up_;
  bool carried_before_ = false;  ///< the points have had their water in the stage before (coupled seepage)
  std::string hand_over_;        ///< a sentence for the log
  double hand_over_change_ = 0;  ///< m^dim
};

}  // namespace wetfront::mpm
