#pragma once

#include "mpm/two_velocity/water.h"

#include <utility>
#include <vector>

namespace wetfront::mpm {

/// The rainfall boundary of the two-velocity schemes (Martinelli 2020; benchmarks 8.3): predict with p = 0 at the
/// surface, r = [nS (v_l - v_s) - q].n, q.n = -I cos(slope); r < 0: correct the normal velocity so that the relative
/// flux is exactly q; r >= 0: keep the prediction, the surplus runs off. A record without rain is a potential seepage
/// face.
///
/// The infiltration capacity is predicted with the saturated conductivity (a dry k_rel would send the first rain
/// away). n is the direction of the nodal integral of N_i n over the rained sides, hence unique at kinks; at the ends
/// of a side the correction runs along the walls there. nS is the nodal content of Eq. 14 at the start of the step.
template <int dim>
class RainOnTwoVelocity : public Effect<dim> {
 public:
  RainOnTwoVelocity(Origin origin, std::shared_ptr<TwoVelocityWater<dim>> water)
      : Effect<dim>("rainfall", std::move(origin),
                    "Martinelli 2020; Lee 2021 supplement 1; mpm/two_velocity/README.md section 5"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  struct Node {
    std::size_t index = 0;
    Vector<dim> normal{};                               ///< unit
    Vector<dim> along{};                                ///< direction of the correction, along.normal = 1
    double area = 0;                                    ///< |integral of N_i n| [m^(dim-1)]
    double mobility = 0;                                ///< k/mu, saturated [m2/(Pa s)]
    bool closed = false;                                ///< by walls: all its rain runs off
    double flux = 0;                                    ///< w.n decided in step II [m/s]
    std::vector<std::size_t> cells;                     ///< behind, of a moving body
    std::vector<std::pair<std::size_t, double>> rains;  ///< rain, horizontal area [m^(dim-1)]
  };
  /// Water leaves a moving body only where all cells behind the node are full, or nearly so: what a full one presses
  /// out would else be taken from an empty one beside it.
  bool may_leave(const Node& node) const;
  void collect(const StagePlan<dim>& plan);
  void collect_from_body(const StagePlan<dim>& plan);
  Node& node_at(std::size_t index);
  void settle(Node& node);
  void refuse_to_miss(double time) const;
  void correct(double time, double dt);
  void close(std::size_t node, double dt);
  void restore();
  void surface_state();
  void anticipate(double time);
  void book(double time, double dt);
  void book_pieces();
  void fill_ledger(double time);
  double rate(const Node& node, double time) const;
  /// (v_l - v_s).n
  static double normal_part(const Node& node, const Velocities<dim>& v);

  std::shared_ptr<TwoVelocityWater<dim>> water_;
  std::vector<RainSide> rains_;
  std::vector<Node> nodes_, spare_;
  std::vector<int> place_of_node_;     ///< in nodes_ while these are collected from a body that moves, -1: none
  std::vector<int> rain_of_boundary_;  ///< index into rains_, -1: not rain
  Column *asked_ = nullptr, *imposed_ = nullptr, *run_off_ = nullptr, *outflow_ = nullptr;
  Column *ponded_ = nullptr, *ledger_ = nullptr, *on_pieces_ = nullptr;
  const Grid<dim>* grid_ = nullptr;
  double nearly_full_ = -1e30;  ///< Pa: a twentieth of the curve's scale, where S is within 1e-3 of S_max
};

}  // namespace wetfront::mpm
