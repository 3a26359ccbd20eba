#pragma once

#include "fem_reference/richards_problem.h"

#include "meshes/field_history.h"

#include <optional>
#include <string>
#include <vector>

/// The soil that a solution behaves as if it had, read off its fields: no law of either solver is looked at.
namespace wetfront::verification {

/// How a solution's soil departs from the one it should have. Both are functions of the degree of saturation or of the
/// suction on a grid of sampled values, linear between and constant beyond.
struct ObservedSoil {
  std::vector<double> suction, content;          ///< [Pa, -]: observed S minus that of the law at the same suction
  std::vector<double> saturation, conductivity;  ///< [-, -]: observed K over that of the law at the same S
  double content_rms = 0;                        ///< of the departures of S
  std::size_t flux_samples = 0;                  ///< places and times at which K could be observed
};

/// From the fields of a column with many snapshots: S against p at the nodes; K from the water that passed each height
/// between two snapshots (its ledger and what is stored above) over the gradient of head there.
ObservedSoil observe(const meshes::FieldHistory& history, const fem_reference::Soil& law, double unit_weight,
                     double area);

/// K over that of the law, divided by what the same observation makes of `truth`, a solution that has the law: what is
/// left of it is no error of observing. Empty where the two have no saturations in common.
void relate_to(ObservedSoil& soil, const ObservedSoil& truth);

/// The law in tables, with departures (none: the law itself, so that what the tables change can be told apart).
fem_reference::Soil tabulated(const fem_reference::Soil& law, double unit_weight, double driest_head,
                              const ObservedSoil* content, const ObservedSoil* conductivity);

}  // namespace wetfront::verification
