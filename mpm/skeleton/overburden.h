#pragma once

#include "mpm/boundary/faces.h"
#include "mpm/plan/stage_plan.h"

#include <functional>

namespace wetfront::mpm {

/// What lies above a place, along the line against gravity through it: all soil that the line crosses (cells by their
/// faces, cut cells up to Problem::surface), with its water in a stage that has one, and tractions
/// where the line leaves it. Water that stands on the soil presses on the skeleton only where the scene gives it as a
/// traction, here as in the run.
template <int dim>
class Overburden {
 public:
  explicit Overburden(const StagePlan<dim>& plan);

  /// Vertical total stress of what lies above x, compression-positive [Pa].
  double above(const Vector<dim>& x) const;
  /// chi p at a place of a cell [Pa]; 0 in a stage without liquid.
  double pore_stress(std::size_t cell, const Vector<dim>& x) const;
  const Vector<dim>& up() const { return up_; }

 private:
  struct Face {
    Vector<dim> normal{}, centre{};  ///< outward, of length 1; m
  };
  struct Range {
    double from = 0, until = 0;  ///< along the line [m]
    int last_face = -1;          ///< through which it leaves
  };
  struct Water {
    double pressure, saturation, bishop;  ///< Pa, compression-positive; -; chi [-]
  };
  void sort_cells();
  std::array<long, 2> bucket_of(const Vector<dim>& x) const;
  Range crossing(std::size_t cell, const Vector<dim>& x) const;
  /// Calls `body(from, until)` for what of the range lies below the problem's surface.
  void below_surface(const Vector<dim>& x, const Range& range, const std::function<void(double, double)>& body) const;
  double weight(std::size_t cell, const Vector<dim>& x, double from, double until) const;
  double load_on_top(std::size_t cell, int face) const;
  Water water_at(std::size_t cell, const Vector<dim>& x) const;

  const StagePlan<dim>& plan_;
  Faces<dim> faces_;
  Vector<dim> up_{};
  double gravity_ = 0;                   ///< m/s2
  std::array<Vector<dim>, 2> across_{};  ///< axes of the buckets, across gravity
  std::array<double, 2> low_{}, width_{};
  std::array<long, 2> buckets_{1, 1};
  std::vector<std::vector<std::size_t>> cells_of_bucket_;
  std::vector<std::array<Face, cell_faces<dim>>> cell_faces_;
  std::vector<std::function<Water(double)>> water_of_soil_;  ///< of the pressure; empty without liquid
};

}  // namespace wetfront::mpm
