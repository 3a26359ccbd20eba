#pragma once

#include "mpm/boundary/surface.h"
#include "mpm/plan/stage_plan.h"

#include <functional>
#include <set>
#include <vector>

namespace wetfront::mpm {

template <int dim>
struct TwoVelocityWater;

/// The free surface of a resting body wherever it lies, also inside cells (README.md section 5b). Each piece takes rain
/// as water of the cell behind it and pushes on that cell's nodes with its pressure p_s.
///
/// p_s is that of the cell carried to the surface by Darcy's law at the flux of the rain, 0 at most. A cell that holds
/// more water than p_s = 0 allows gives the surplus back: first rain that runs off, then water that seeps out.
template <int dim>
class CutSurface {
 public:
  explicit CutSurface(const StagePlan<dim>& plan);

  struct Piece {
    std::size_t cell = 0;
    Vector<dim> centre{}, area{};  ///< x_s [m], outwards [m^(dim-1)]
    double size = 0, open = 0;     ///< |area|, horizontal area [m^(dim-1)]
    std::array<double, cell_nodes<dim>> weight{};
    double asked = 0, taken = 0, seeped = 0;  ///< in the last step [m^dim]
  };
  const std::vector<Piece>& pieces() const { return pieces_; }
  /// Whether soil touches this face of the mesh's border.
  bool wets(const std::vector<int>& sorted_face) const { return wet_.contains(sorted_face); }
  /// Rain that reaches a cell [m^dim/s].
  double rain_on(std::size_t cell, double time) const;
  /// Takes the surface out of the cells' outflow, and gives them its push with p_s = p_c; then what every inner node
  /// sees of the faces sums to zero, so that no water is made or lost.
  void attach(TwoVelocityWater<dim>& water) const;
  /// The rest of the push, from p_s - p_c.
  void push(TwoVelocityWater<dim>& water, double time) const;
  /// Rain into the water of cells, the surplus back; `change(cell, volume)` gives water to the points of a cell.
  void rain(const TwoVelocityWater<dim>& water, double time, double dt,
            const std::function<double(std::size_t cell)>& held,
            const std::function<void(std::size_t cell, double volume)>& change);

 private:
  double intensity(double time) const;
  double excess_pressure(const TwoVelocityWater<dim>& water, const Piece& piece, double intensity) const;
  double most_water(const TwoVelocityWater<dim>& water, const Piece& piece) const;

  const StagePlan<dim>& plan_;
  std::vector<Piece> pieces_;
  std::set<std::vector<int>> wet_;
  std::vector<RainSide> rains_;
  std::vector<std::function<double(double)>> content_;  ///< e(p) of each soil
};

}  // namespace wetfront::mpm
