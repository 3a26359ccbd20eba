#pragma once

namespace wetfront::verification::exact {

/// A column under its own weight, X up from its fixed base, sides on rollers (with nu = 0: free, the same). The nominal
/// stress at X is -rho_0 g (H - X), whatever the law; strains follow from it. SI units, stress tension-positive.
struct GravityColumn {
  double height;   ///< H [m]
  double density;  ///< rho_0, of the mixture [kg/m3]
  double gravity;  ///< g [m/s2]
  double young;    ///< E [Pa]
  double poisson;  ///< nu [-]
};

/// How stress follows from stretch along the column.
enum class ColumnLaw {
  small_strain,  ///< sigma = E_oed e
  hencky,        ///< tau = J sigma = E_oed ln(stretch): Coombs et al. 2020
  rate,          ///< sigma = E_oed ln(stretch): elasticity in increments of Cauchy stress (Jaumann)
};

/// std::invalid_argument for non-positive parameters or nu outside [0, 0.5); hencky: std::domain_error where the column
/// cannot bear its weight (never in compression).
class GravityColumnSolution {
 public:
  GravityColumnSolution(const GravityColumn& problem, ColumnLaw law);
  double stretch(double x) const;          ///< dx/dX
  double position(double x) const;         ///< of what was at X [m]
  double height() const;                   ///< at rest under its weight [m]
  double settlement() const;               ///< of the top [m]
  double vertical_stress(double x) const;  ///< Cauchy [Pa]
  double stress_ratio() const;             ///< horizontal over vertical, nu/(1 - nu)
  double period() const;                   ///< of the first mode, small motion: 4 H/c [s]

 private:
  GravityColumn p_;
  ColumnLaw law_;
  double modulus_;
};

}  // namespace wetfront::verification::exact
