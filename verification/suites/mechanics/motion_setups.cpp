#include "verification/suites/mechanics/motion_setups.h"

#include "verification/suites/mechanics/motion_book.h"

#include <fmt/format.h>

#include <map>

namespace wetfront::verification {

mpm::Soil dry_soil(double density, double young, double poisson) {
  mpm::Soil soil;
  soil.name = "soil";
  soil.porosity = 0.5;
  soil.grain_density = 2 * density;
  soil.intrinsic_permeability = 1e-12;  // of no use without water
  soil.elastic = mpm::Elastic{young, poisson, "suite"};
  soil.origin = "suite";
  return soil;
}

mpm::Soil frictional_soil(double density, const mpm::Elastic& elastic, const mpm::MohrCoulomb& strength) {
  mpm::Soil soil = dry_soil(density, elastic.young, elastic.poisson);
  soil.law = strength;
  return soil;
}

template <int dim>
mpm::Problem<dim> dry_problem(meshes::Mesh mesh, mpm::Soil soil, const std::vector<double>& times) {
  mpm::Problem<dim> problem;
  problem.mesh = std::move(mesh);
  problem.soils = {std::move(soil)};
  problem.gravity_origin = "suite";
  problem.points_per_cell = 1 << dim;
  mpm::Stage stage;
  stage.name = "motion";
  stage.end_time = times.back();
  stage.origin = "suite";
  problem.stages = {stage};
  problem.output_times = times;
  return problem;
}

template <int dim>
void add_rollers(mpm::Problem<dim>& problem, const std::vector<std::string>& sides) {
  const std::map<std::string, int> axis = {{"left", 0}, {"right", 0},      {"front", 1},
                                           {"back", 1}, {"base", dim - 1}, {"top", dim - 1}};
  for (const std::string& side : sides) {
    mpm::Fixity fixity{side, {}, "suite"};
    fixity.fixed[static_cast<std::size_t>(axis.at(side))] = true;
    problem.fixities.push_back(fixity);
  }
}

template <int dim>
void fill_only(mpm::Problem<dim>& problem, const std::function<bool(const meshes::Point&)>& inside) {
  problem.empty_cells.resize(problem.mesh.cell_count());
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c)
    problem.empty_cells[c] = inside(problem.mesh.cell_centre(c)) ? 0 : 1;
}

std::vector<double> evenly(double end, int count) {
  std::vector<double> times;
  for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
  return times;
}

std::string scheme_text(const mpm::SkeletonScheme& scheme) {
  std::string text = scheme.shape == mpm::ShapeFunctions::linear ? "linear" : "quadratic splines";
  if (scheme.shape == mpm::ShapeFunctions::linear && scheme.locking == mpm::LockingRemedy::b_bar) text += ", B-bar";
  if (scheme.transfer == mpm::Transfer::apic) text += ", APIC";
  if (scheme.transfer == mpm::Transfer::flip && scheme.pic > 0) text += fmt::format(", {:g} PIC", scheme.pic);
  if (scheme.integration == mpm::StressIntegration::points) text += ", integrated at points";
  if (scheme.update == mpm::StressUpdate::usf) text += ", USF";
  if (scheme.update == mpm::StressUpdate::usl) text += ", USL";
  return text;
}

const Gate weighty_energy{0.02, "1",
                          "gravity's work is taken where points are, that of forces at nodes, and contact stops points "
                          "a step after nodes: up to .014 measured"};

Gate smooth_energy(const mpm::SkeletonScheme& scheme, int cells, double cells_lost) {
  if (scheme.update != mpm::StressUpdate::musl)
    return {0.2, "1",
            "works are taken with v_i + dt a_i less what light nodes are spared, so a border that crosses cells loses "
            "(axis-aligned, 8, 16, 32 cells: USF .14, .04, .09, USL .06, .02, .01; vortex, 16 cells: .17, .11)"};
  if (scheme.transfer == mpm::Transfer::flip && !(scheme.pic > 0))
    return {1e-9, "1", "FLIP gives points what forces do at nodes: round-off"};
  return {
      cells_lost / cells, "1",
      "PIC and APIC smooth what nodes do not see: in proportion to h or less (splines, APIC, 16, 32, 64 cells: .073, "
      ".037, .020; vortex .53, .16, .03)"};
}

Gate smooth_energy_made(const Gate& lost) {
  if (lost.tolerance <= MotionBook::round_off_energy.tolerance) return lost;
  return {
      0.1 * lost.tolerance, "1",
      "a tenth of what may be lost; it falls faster than that (splines, APIC, linear, 8, 16, 32 cells: .011, .0038, "
      ".0008; vortex, 32, 64: .011, .003)"};
}

template mpm::Problem<2> dry_problem(meshes::Mesh, mpm::Soil, const std::vector<double>&);
template mpm::Problem<3> dry_problem(meshes::Mesh, mpm::Soil, const std::vector<double>&);
template void add_rollers(mpm::Problem<2>&, const std::vector<std::string>&);
template void add_rollers(mpm::Problem<3>&, const std::vector<std::string>&);
template void fill_only(mpm::Problem<2>&, const std::function<bool(const meshes::Point&)>&);
template void fill_only(mpm::Problem<3>&, const std::function<bool(const meshes::Point&)>&);

}  // namespace wetfront::verification
