#include "verification/suites/mechanics/energy_split.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

namespace {

bool linear_in_strain(const mpm::Soil& soil) {
  return !soil.law || std::holds_alternative<mpm::MohrCoulomb>(*soil.law) ||
         std::holds_alternative<mpm::SofteningMohrCoulomb>(*soil.law) ||
         std::holds_alternative<mpm::SuctionMohrCoulomb>(*soil.law);
}

/// sum V ((1 + nu) s:s - nu tr(s)^2)/(2 E).
template <int dim>
double stored_in(const Cloud<dim>& cloud, const mpm::Elastic& elastic) {
  double sum = 0;
  for (std::size_t p = 0; p < cloud.size(); ++p) {
    double trace = 0, square = 0;
    for (std::size_t q = 0; q < cloud.stress[p].size(); ++q) {
      const double s = cloud.stress[p][q];
      square += (q < 3 ? 1 : 2) * s * s;
      if (q < 3) trace += s;
    }
    sum += cloud.volume[p] * ((1 + elastic.poisson) * square - elastic.poisson * trace * trace);
  }
  return sum / (2 * elastic.young);
}

/// When the ledger begins: at the first output of a later stage, else before the first step.
template <int dim>
const Cloud<dim>& at_beginning(const Motion<dim>& motion, double time) {
  if (time > 0)
    for (const Cloud<dim>& cloud : motion.clouds)
      if (cloud.time >= time) return cloud;
  return motion.start;
}

}  // namespace

template <int dim>
EnergySplit energy_split(const mpm::Problem<dim>& problem, const Motion<dim>& motion) {
  const auto& rows = motion.history.motion;
  const meshes::MotionRow &first = rows.front(), &last = rows.back();
  EnergySplit out;
  for (const meshes::MotionRow& row : rows) {
    out.size = std::max({out.size, row.kinetic, std::abs(row.potential - first.potential), std::abs(row.stress_work),
                         std::abs(row.load_work)});
    out.worst_loss = std::max(out.worst_loss, -row.drift);
    out.worst_gain = std::max(out.worst_gain, row.drift);
  }
  out.released = first.potential - last.potential;
  out.loads = last.load_work;
  out.kinetic = last.kinetic - first.kinetic;
  out.stress_work = last.stress_work;
  out.resisted = -last.resistance;
  out.mapping = -last.drift;
  if (problem.soils.size() == 1 && linear_in_strain(problem.soils[0]) && !motion.clouds.empty()) {
    const mpm::Elastic& elastic = *problem.soils[0].elastic;
    out.stored = stored_in(motion.clouds.back(), elastic) - stored_in(at_beginning(motion, first.time), elastic);
  }
  return out;
}

template EnergySplit energy_split(const mpm::Problem<2>&, const Motion<2>&);
template EnergySplit energy_split(const mpm::Problem<3>&, const Motion<3>&);

}  // namespace wetfront::verification
