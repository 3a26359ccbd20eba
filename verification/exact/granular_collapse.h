#pragma once

namespace wetfront::verification::exact {

/// Dry granular columns that collapse, H_0 high and L_0 long (radius L_0), aspect ratio a = H_0/L_0: laws fitted to
/// experiments, not closed forms. Run-out and height over L_0. benchmarks.md section 5.3.
struct Collapse {
  double run_out;  ///< (L_end - L_0)/L_0
  double height;   ///< H_end/L_0, at the wall (axis)
};

/// Plane, Lube et al. 2005 (Phys. Rev. E 72:041301): run-out 1.2 a for a <= 1.8, 1.9 a^(2/3) for a >= 2.8, and between
/// them the straight line that joins the two; height a for a <= 1.15, a^0.4 above.
Collapse lube_plane(double aspect);
/// Plane, height after Lajeunesse et al. 2005 (Phys. Fluids 17:103302): a for a < 0.7, a^(1/3) above; run-out as Lube's
/// (theirs depends on the material: 1.2 to 1.8 a, 1.9 a^(2/3)).
Collapse lajeunesse_plane(double aspect);
/// Axisymmetric, Lube et al. 2004 (J. Fluid Mech. 508:175): 1.24 a for a < 1.7, 1.6 a^(1/2) above; height 0.88 a^(1/6)
/// above a = 1.7, at most a.
Collapse lube_axisymmetric(double aspect);

}  // namespace wetfront::verification::exact
