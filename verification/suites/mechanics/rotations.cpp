#include "mpm/laws/linear_elastic.h"
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

struct Turned {
  double stress;  ///< largest of any point, over rho w^2 (side/2)^2
  double spin;    ///< angular momentum about the centre of the box that is lost, relative
};

template <int dim>
Turned turn(int cells, double turns, mpm::Transfer transfer, MotionBook& book) {
  auto problem = turning_block<dim>(cells, turns);
  problem.skeleton.transfer = transfer;
  book.energy = {0.01, "1", "APIC loses spin that cells do not see: .0008 of a turn in the plane, .006 in space"};
  book.energy_made = {0.005, "1", "as above: .0008 in the plane, .002 in space"};
  const auto motion = book.move<dim>(scheme_text(problem.skeleton), problem);
  const double side = 1.0 / 3, inertia = side * side / 6;  // of a square about its centre, per mass
  const double centrifugal = density * side * side / 4;    // sigma in the middle of a square plate is of that order
  Turned out{0, 0};
  for (const auto& cloud : motion.clouds) {
    for (const auto& stress : cloud.stress)
      for (const double component : stress) out.stress = std::max(out.stress, std::abs(component) / centrifugal);
    const double spin = cloud.mean([&](std::size_t p) {
      return (cloud.position[p][0] - 0.5) * cloud.velocity[p][1] - (cloud.position[p][1] - 0.5) * cloud.velocity[p][0];
    });
    out.spin = std::max(out.spin, std::abs(1 - spin / inertia));
  }
  return out;
}

template <int dim>
void turn(int cells, double turns, MotionBook& book) {
  const Turned affine = turn<dim>(cells, turns, mpm::Transfer::apic, book);
  book.page.judge(
      "stress", "largest stress over rho w^2 (side/2)^2, APIC", affine.stress,
      {5, "1",
       "centrifugal stress itself is up to 1, twice that after the sudden start; points that cross cells add "
       "as much. Against E = 1 MPa: 1e-4"});
  book.page.judge("spin", "change of the angular momentum, APIC", affine.spin,
                  {0.02, "1", "APIC carries the spin of points and nodes; points turn in chords"});
  const Turned flip = turn<dim>(cells, turns, mpm::Transfer::flip, book);
  book.page.show("stress_flip",
                 "largest stress over rho w^2 (side/2)^2, FLIP: a node at the border takes the velocity of "
                 "the mass about it, which lies inwards of it",
                 flip.stress, "1");
  book.page.show("spin_flip", "change of the angular momentum, FLIP", flip.spin, "1");
}

/// The rotation of stress alone, by steps as large as those of a run: a turn leaves the stress what it was.
void turn_stress(CaseBook& book) {
  const mpm::LinearElastic law({1e6, 0.3, "suite"});
  for (const int steps : {8, 100, 10000}) {
    mpm::LawPoint<mpm::LinearElastic, 3> point;
    const mpm::SymmetricTensor<3> start{-100, -50, 20, 30, -10, 40};
    point.stress = start;
    // Hughes and Winget turn by 2 atan(w/2): the w of a step that makes the full turn in so many
    const double w = 2 * std::tan(std::numbers::pi / steps);
    const std::array<double, 3> axis{1 / std::sqrt(3.0), -1 / std::sqrt(3.0), 1 / std::sqrt(3.0)};
    mpm::StepGradient<3> step;
    step.plane = {{{0, -w * axis[2], w * axis[1]}, {w * axis[2], 0, -w * axis[0]}, {-w * axis[1], w * axis[0], 0}}};
    for (int i = 0; i < steps; ++i) law.advance(point, step);
    double change = 0;
    for (int k = 0; k < 6; ++k) change = std::max(change, std::abs(point.stress[k] - start[k]) / 100);
    book.judge("turn", fmt::format("change of the stress over a turn in {} steps, relative", steps), change,
               {1e-12, "1", "exact rotation: round-off of each step (the issue's 1e-12 per turn)"});
  }
}

}  // namespace

std::vector<Case> rotation_cases() {
  const std::string requirement = "A body that turns takes no stress from it.";
  const std::string source = "Hughes & Winget 1980; Lee et al. 2021 Eqs 16 and 17, corrected.";
  return {{"rotation_stress", "M1 Stress under rotation", requirement, source, Effort::quick, turn_stress},
          motion_case({"rotation_2d", "M1 A block turns once", requirement, source, Effort::quick, {}},
                      [](MotionBook& book) { turn<2>(24, 1, book); }),
          motion_case({"rotation_3d", "M1 A cube turns by a quarter", requirement, source, Effort::everyday, {}},
                      [](MotionBook& book) { turn<3>(12, 0.25, book); })};
}

}  // namespace wetfront::verification
