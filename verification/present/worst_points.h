#pragma once

#include "reports/record.h"
#include "verification/compare/histories.h"
#include "verification/compare/measure.h"

#include <vector>

/// Where a gate on a field failed: the places that make most of the error.
namespace wetfront::verification {

struct WorstPoints {
  std::vector<reports::Table> tables;     ///< the ten worst of every field and time that failed
  std::vector<reports::FieldFile> files;  ///< of the same, at most a thousand: `fields/worst_points_0000.vtu`, ...
};

/// Of every finding on pressure or saturation that FAILs: the centres of the candidate's cells, where norms are taken,
/// by their share of the squared error. Nothing where all fields hold.
WorstPoints worst_points(const std::vector<reports::Finding>& findings, const std::vector<Measurement>& measurements,
                         const Histories& histories);

}  // namespace wetfront::verification
