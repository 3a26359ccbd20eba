#pragma once

#include "mpm/seepage/seepage_step.h"
#include "mpm/seepage/soil_content.h"

#include <span>
#include <string>

namespace wetfront::mpm {

/// The water of points that move through the grid (README.md section 5). Points carry
///   "water"              W_p, what is conserved: changed by what nodes gain and lose, never by motion [m^dim]
///   "carried pressure"   p_p, changed by the increments of the nodes [Pa]
///   "pressure gradient"  of the nodal pressures around the point [Pa/m]
/// When points have moved, nodal pressures change by what the points bring, and by nothing when they have not:
///
///   p_i += Pi'_i - Pi_i - lambda_i (p_i - Pi_i),   Pi_i = sum_p N_i(x_p) P_p (p_p + grad p_p.(x_i - x_p)) / sum_p N_i
///   P_p,
///
/// What a node of several soils has gained is the points' by their own curves (find_excess). P_p the pores of the
/// point, lambda_i = min(1, 2 |du_i|/h): what the points do not know belongs to where the body was. With the same
/// lambda the p_p of unsaturated points follow their own water, p_p -> content^-1(W_p/P_p).
template <int dim>
class CarriedWater {
 public:
  CarriedWater(StagePlan<dim>& plan, const SeepageColumns& columns, Column& trial,
               const std::vector<SoilContent>& contents, const std::string& grain_mass = "mass");

  /// W_p and p_p of the nodal pressures, when a stage begins.
  void begin();
  /// Before the points move: Pi of their present places.
  void before_motion();
  /// After it, stencils filled: the nodal pressures p^n, p^{n-1}, p^{n-2} and the trial one.
  /// `answer`: what nodal pressures have gained on the way by the motion itself, undrained; p^n is still without it.
  void after_motion(std::span<const double> answer = {});
  /// Adds what the nodes gained during the accepted step to the points; updates their pressure and saturation.
  void take_increments();
  double total() const;

  /// V_p - m_p/rho_s [m^dim].
  double pores(std::size_t point, const Soil& soil) const {
    return (*volume_)[0][point] - (*mass_)[0][point] / soil.grain_density;
  }
  const Soil& soil_of(const Block& block) const { return plan_.problem.soils[static_cast<std::size_t>(block.soil)]; }
  const SoilContent& content_of(const Block& block) const { return contents_[static_cast<std::size_t>(block.soil)]; }

 private:
  void map(std::vector<double>& mapped, std::vector<double>& pores);
  void take_answer(std::span<const double> answer);
  void find_excess();
  void find_gradients();
  void follow_water();

  StagePlan<dim>& plan_;
  SeepageColumns c_;
  Column& trial_;
  const std::vector<SoilContent>& contents_;
  Column *volume_, *mass_, *position_, *shape_, *gradient_, *displacement_;
  Column *water_, *carried_, *slope_;
  std::vector<double> mapped_, mapped_pores_, new_mapped_, new_pores_, displaced_, lambda_, answer_mapped_;
  /// Per soil: what its pores at a node have taken up per volume beyond the mean of all pores there. Empty: one soil.
  std::vector<std::vector<double>> excess_;
};

}  // namespace wetfront::mpm
