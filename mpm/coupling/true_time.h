#pragma once

#include "mpm/coupling/skeleton_of_flow.h"
#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// Soil and its water moving as one body in true time (README.md section 8): in a step of the plan the skeleton takes
/// as many explicit cycles as its stability asks for, undrained; then water seeps for the whole step, implicitly,
/// through the pores where they are by then.
///
/// Points carry "grain mass" beside "mass", which is that of grains and water here.
template <int dim>
class TrueTimeMotion : public SkeletonOfFlow<dim> {
 public:
  explicit TrueTimeMotion(std::shared_ptr<SkeletonCycle<dim>> cycle) : cycle_(std::move(cycle)) {}

  void join(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
            const std::vector<SoilContent>& contents, std::function<void(bool)> refresh) override;
  void add_storage(int region, const SoilContent& content) const override;
  void ready() override;
  void begin_stage() override;
  void begin_step() override;
  void end_step() override;
  const CarriedWater<dim>& carried() const override { return *carried_; }
  bool in_true_time() const override { return true; }

 private:
  /// Of a cell, while its points move through it.
  struct Cell {
    std::array<double, cell_nodes<dim>> share{};       ///< integral of N_i over the soil in it / its volume
    std::array<Vector<dim>, cell_nodes<dim>> slope{};  ///< mean of grad N_i over the cell [1/m]
  };
  class PoreForce;
  void refresh_geometry();
  void add_pore_force();
  void move_undrained();
  void answer();
  double answered(std::size_t node) const;
  void press_points();
  void weigh_points();
  double longest_cycle() const;

  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  StagePlan<dim>* plan_ = nullptr;
  NodalWater<dim>* water_ = nullptr;
  SeepageColumns c_{};
  const std::vector<SoilContent>* contents_ = nullptr;
  std::function<void(bool)> refresh_;
  std::unique_ptr<CarriedWater<dim>> carried_;
  Column *mass_ = nullptr, *grains_ = nullptr, *volume_ = nullptr, *force_ = nullptr, *water_of_points_ = nullptr,
         *pore_stress_ = nullptr, *suction_ = nullptr, *value_ = nullptr, *gradient_ = nullptr;
  std::vector<Cell> cells_;
  std::vector<std::size_t> occupied_;
  std::vector<double> block_volume_;                ///< of the blocks, before they move [m^dim]
  std::vector<std::vector<double>> pores_, grown_;  ///< nodes, per region [m^dim]
  std::vector<double> start_, push_;
  bool fresh_ = true;  ///< no stage before has carried water
  long cycles_ = 0;
};

}  // namespace wetfront::mpm
