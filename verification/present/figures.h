#pragma once

#include "reports/record.h"
#include "verification/compare/histories.h"
#include "verification/compare/measure.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// The figures of a comparison: profiles (columns), time series at probes, wetting front, flux audit, step sizes.
std::vector<reports::Figure> figures(const Scene& scene, const Timeline& timeline, const Histories& histories,
                                     const std::vector<Measurement>& measurements);

/// The figures of a run that has no reference (a dry scene) or whose reference gave up.
std::vector<reports::Figure> figures_of_one(const Scene& scene, const meshes::FieldHistory& history,
                                            const std::string& who);

}  // namespace wetfront::verification
