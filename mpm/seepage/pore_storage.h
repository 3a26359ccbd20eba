#pragma once

#include "mpm/seepage/seepage_step.h"
#include "mpm/seepage/soil_content.h"

namespace wetfront::mpm {

/// W_i += P_i content(p_i) with the pores P_i of a region at the nodes, and its slope to the capacity.
template <int dim>
void store_in_pores(const NodalWater<dim>& water, const SeepageColumns& columns, int region,
                    const SoilContent& content) {
  const double *pores = (*columns.pore_volume)[region], *p = (*water.trial)[0];
  double *stored = (*water.stored)[0], *capacity = (*water.capacity)[0];
  for (std::size_t i = 0; i < columns.pressure->size(); ++i) {
    if (!(pores[i] > 0)) continue;
    const ValueAndSlope held = content.at(p[i]);
    stored[i] += pores[i] * held.value;
    capacity[i] += pores[i] * held.slope;
  }
}

}  // namespace wetfront::mpm
