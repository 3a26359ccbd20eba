#pragma once

#include "mpm/grid/chunks.h"
#include "mpm/plan/team.h"
#include "mpm/two_velocity/blow_up.h"
#include "mpm/two_velocity/coupled_limit.h"
#include "mpm/two_velocity/moving_cells.h"
#include "mpm/two_velocity/water.h"

#include <algorithm>
#include <limits>
#include <span>

namespace wetfront::mpm {

/// The two-velocity liquid in a skeleton that moves: the same scheme as at rest, with sums over points made anew in
/// every step, fused into few passes (README.md section 3b). Acts on the nodes of the skeleton as one of its
/// conditions.
template <int dim>
class MovingLiquid {
 public:
  struct PointColumns {
    Column *position, *volume, *mass, *solid_velocity, *water, *velocity;
  };
  MovingLiquid(StagePlan<dim>& plan, TwoVelocityWater<dim>& water, const PointColumns& points, Vector<dim> weight);

  /// Every sum over points, pressures and conductivities, from carried columns alone; `moved` before another body.
  void sum();
  void begin_body();  ///< for the cells that hold points now, without a look whether they are others
  void add_force();
  void solve(double dt);
  /// Who decides at the surface does so once both phases have been accelerated, before contact and sides.
  void after_solve(std::function<void()> body) { after_solve_.push_back(std::move(body)); }
  /// Where contact and sides have changed the skeleton, the drag anew.
  void follow_skeleton(double dt);
  void points(double dt);
  void relative_velocity();
  void balance(double dt, bool as_printed);
  /// The longest stable step of a soil's blocks [s].
  double limit(int soil, double steps_ahead, double growth, double last_step);
  void at_other_body(std::function<void()> body) { listeners_.push_back(std::move(body)); }

  const Body<dim>& body() const { return body_; }
  const LiquidBlock<dim>& block(const Block& block) const { return blocks_[place(block)]; }
  /// Of the soils in an occupied cell [Pa].
  double lowest_pressure(std::size_t cell) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t at = cell; at < blocks_.size(); at += geometry_.size())
      if (plan_.fields.points.count_of_cell()[at] > 0) lowest = std::min(lowest, blocks_[at].pressure);
    return lowest;
  }
  double stored() const { return stored_; }  ///< sum of pores e(p) [m^dim]
  double held() const { return held_; }      ///< sum of W_p [m^dim]

 private:
  /// Blocks are kept by soil, then by cell.
  std::size_t place(std::size_t cell, int soil) const { return static_cast<std::size_t>(soil) * cells_ + cell; }
  std::size_t place(const Block& block) const { return place(block.cell, block.soil); }
  std::size_t cell_of(std::size_t place) const { return place % cells_; }
  const LiquidLaws& laws_of(std::size_t place) const { return laws_[place / cells_]; }
  template <class Body>
  void near_surface(const Body& body) const;
  /// What a run of cells finds while the others look at theirs; added up in their order.
  struct Found {
    static constexpr std::size_t none = ~std::size_t{0};
    double stored = 0, held = 0;  ///< m^dim
    std::size_t burst = none;     ///< the first place whose content no pressure explains
    double worst = 0;             ///< 1/dt
  };
  using Shares = std::array<double, cell_nodes<dim>>;
  template <class Body>
  void over_cells(const Body& body);
  template <class Body>
  void over_nodes(const Body& body);
  template <class Body>
  void over_node_runs(const Body& body);
  void find_border();
  double least_drag() const;
  void find_cells_at_nodes();
  void find_extents(std::size_t node);
  void sum_cells(std::span<const Block> blocks, Found& found);
  [[gnu::always_inline]] inline void sum_points(const Block& block, LinearShape<dim>& shape, const LiquidLaws& laws,
                                                Shares& share);
  [[gnu::always_inline]] inline void find_pressure(const Block& block, const LiquidLaws& laws, Found& found);
  [[gnu::always_inline]] inline void give_pressure(const Block& block, const Shares& share);
  [[gnu::always_inline]] inline void points_of(const Block& block, LinearShape<dim>& shape, double share);
  [[gnu::always_inline]] inline void limit_of(const Block& block, const LiquidLaws& laws, double modulus, double ahead,
                                              Found& found) const;
  void find_resistance();
  bool explains(double pressure) const;
  void push_of_crooked_cell(const Block& block, LiquidBlock<dim>& sums) const;
  bool near_kink(const LiquidBlock<dim>& sums, double change, const LiquidLaws& laws) const;
  double fill_of(std::size_t cell) const;
  [[gnu::always_inline]] inline void find_push(const Block& block, const LinearShape<dim>& shape, const Shares& share,
                                               LiquidBlock<dim>& sums) const;
  double pressure_at(const LiquidLaws& laws, double content, const Vector<dim>& centre, std::size_t cell) const;
  double take_pressure(std::size_t place, double pressure, double content, const LiquidLaws& laws);
  void group_slivers();
  void share_pressures();
  void drain(std::span<const Block> blocks, double per_volume, double content) const;
  double outflow(const Block& block, const std::array<double*, dim>& flux) const;
  void finish_nodes();
  void add_flow_volume();
  void find_parts();
  void open_faces();
  NodalVectors<dim> faces_of(std::size_t cell, bool whole) const;

  StagePlan<dim>& plan_;
  TwoVelocityWater<dim>& w_;
  PointColumns points_;
  Vector<dim> weight_;
  Body<dim> body_;
  std::size_t cells_;
  std::vector<CellGeometry<dim>> geometry_;
  std::vector<NodalVectors<dim>> whole_faces_;  ///< integrals of grad N_i over the cells
  std::vector<NodalVectors<dim>> faces_;        ///< integrals of grad N_i over the cells, by how far faces are open
  std::vector<std::size_t> cells_at_, around_;  ///< per node, into around_; the cells there, ascending
  std::vector<std::size_t> narrowed_;           ///< cells whose faces are open in part
  std::vector<LiquidLaws> laws_;
  std::vector<LiquidBlock<dim>> blocks_;
  Team team_;  ///< of its own: those who wait sleep while the skeleton's work
  Chunks<dim> chunks_;
  std::vector<Found> found_;    ///< per soil and chunk
  long version_ = -1;           ///< of the points' cells when the chunks were found
  std::vector<Shares> shares_;  ///< sum_p V_p N_i of cells near the surface, by place
  std::vector<LiquidGroup> groups_;
  std::size_t group_count_ = 0;
  std::vector<Block> members_;  ///< of the group at hand
  std::vector<LiquidNode<dim>> nodes_;
  std::vector<Vector<dim>> gifts_;             ///< what the points' v_l - v_s take of a node [m/s]
  std::array<std::vector<double>, dim> back_;  ///< (W (v_l - v_s))_i mapped back
  std::vector<Vector<dim>> solid_at_;          ///< v_s at the start of the step
  std::vector<Vector<dim>> decided_;           ///< v_s' of liquid and skeleton alone
  std::vector<std::size_t> held_nodes_;        ///< nodes of the body that walls or fixities hold
  std::vector<double> drag_;                   ///< r of the nodes, as the step limit counts it [1/s]
  std::vector<double> falls_;                  ///< rain at the nodes per volume [1/s]
  std::vector<double> full_;                   ///< integral of N_i over the inner cells of the body [m^dim]
  std::vector<double> all_;                    ///< the same over all its cells [m^dim]
  struct Hanging {
    int node = 0;
    Vector<dim> force{};
  };
  std::vector<Hanging> hanging_;  ///< rho g.x_i times the open area of outer nodes [N]
  struct Rained {
    int node = 0;
    std::size_t cell = 0;
    Vector<dim> area{};
    double height = 0;
  };
  std::vector<Rained> rained_;
  std::vector<std::function<void()>> listeners_, after_solve_;
  double stored_ = 0, held_ = 0;
};

}  // namespace wetfront::mpm
