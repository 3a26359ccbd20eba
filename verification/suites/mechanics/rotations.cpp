#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/mechanics/motion_setups.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace wetfront::verification {
namespace {

constexpr double young = 1e6, density = 1000;

/// A block of one third of the box, in its middle, that turns about its centre once.
template <int dim>
mpm::Problem<dim> turning_block(int cells, double turns) {
  const double omega = 1;  // rad/s: centrifugal stress rho w^2 r^2/2, 14 Pa at the corners; E = 1 MPa
  auto problem = dry_problem<dim>(box_mesh(dim, {1, 1, dim == 3 ? 1.0 : 0.0}, {cells, cells, cells}),
                                  dry_soil(density, young, 0.3), evenly(turns * 2 * std::numbers::pi / omega, 8));
  fill_only<dim>(problem, [](const meshes::Point& at) {
    for (int a = 0; a < dim; ++a)
      if (std::abs(at[static_cast<std::size_t>(a)] - 0.5) > 1.0 / 6) return false;
    return true;
  });
  problem.initial_velocity = [omega](const std::array<double, dim>& at) {
    std::array<double, dim> v{};
    v[0] = -omega * (at[1] - 0.5);
    v[1] = omega * (at[0] - 0.5);
    return v;
  };
  return problem;
}

}  // namespace

std::vector<Case> rotation_cases() {
  return {};
}

}  // namespace wetfront::verification
