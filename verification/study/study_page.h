#pragma once

#include "reports/record.h"
#include "verification/scene/scene.h"
#include "verification/study/point_result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::verification {

/// What every page of a study begins with: the scene, its provenance, the gravest verdict of its points.
reports::Record start_study(const std::string& kind, const Scene& scene, const std::vector<PointResult>& results);

/// PASS, FAIL, INCONCLUSIVE, "refused", "gave up".
std::string verdict_of(const PointResult& result);

/// "point/report.html", or its run.log where it has no report.
std::string link_to(const std::filesystem::path& out, std::size_t index, const StudyPoint& point);

/// One page over a parametric study: verdict, cost, outcomes and the worst gate of each point; outcomes over the values
/// of the first variation that is a number.
reports::Record vary_page(const Scene& scene, const std::vector<Variation>& variations,
                          const std::vector<PointResult>& results, const std::filesystem::path& out);

}  // namespace wetfront::verification
