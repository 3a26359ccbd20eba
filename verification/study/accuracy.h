#pragma once

#include "reports/record.h"
#include "verification/compare/reference_error.h"
#include "verification/scene/scene.h"
#include "verification/study/point_result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What accuracy costs: the same scene by several schemes, cell sizes, tolerances and numbers of points.
namespace wetfront::verification {

/// A point of the study and where it belongs on the figures.
struct AccuracyPoint {
  StudyPoint point;
  std::string curve;     ///< "seepage, bdf2"; points of one curve differ in their cells alone
  double cells = 1;      ///< cells per direction over the scene's
  std::string window{};  ///< "from 163 s to 165 s"; empty: the whole scene
};

/// Schemes (of the last stage) x cells from a quarter to four times the scene's; on the scene's cells also tolerances
/// of the time integration and points per cell; shape functions where the skeleton moves. Names and settings only:
/// nothing is meshed. Throws SceneError for a mesh of the user's own.
std::vector<AccuracyPoint> accuracy_points(const Scene& scene);

/// Of every scheme that is too dear for the whole scene on its finest cells: a window of time up to the last comparison
/// time in which it is not, and in that window the scheme and all cheaper ones on the same cells, after seepage up to
/// the window. None where the last stage is not seepage on a rigid skeleton. Plans the finest cells of each scheme.
std::vector<AccuracyPoint> window_points(const Scene& scene, double budget);

/// Largest error of a quantity over the comparison times and probes, in the quantity's unit; NaN where it was not
/// measured.
double error_of(const PointResult& result, const std::string& quantity);
/// The same with what the reference itself does not know.
double bounded_error_of(const PointResult& result, const std::string& quantity);
/// error_of each, in order.
std::vector<double> errors_of(const std::vector<PointResult>& results, const std::string& quantity);

/// The cheapest finished point whose error, with the reference's own, is within `target`; nothing where there is none.
std::optional<std::size_t> cheapest(const std::vector<PointResult>& results, const std::string& quantity,
                                    double target);

/// How errors, from coarse to fine cells, approach zero: monotone where every refinement lowers them, oscillatory where
/// some raise them, divergent where the last is no smaller than the first; none of fewer than two.
Convergence convergence_of(const std::vector<double>& errors);

/// Points that no other beats in both error and CPU seconds, by ascending cost.
std::vector<std::size_t> pareto(const std::vector<PointResult>& results, const std::vector<double>& errors);
std::vector<std::size_t> pareto(const std::vector<PointResult>& results, const std::string& quantity);

/// The finished run on the finest cells in which this outcome happened; nothing where there are not two runs with it.
std::optional<std::size_t> finest_with(const std::vector<AccuracyPoint>& points,
                                       const std::vector<PointResult>& results, const std::string& outcome);
/// How far each run's outcome is off from that of run `yardstick`, over its value; NaN for the yardstick itself and
/// where it did not happen.
std::vector<double> changes_from(const std::vector<PointResult>& results, std::size_t yardstick,
                                 const std::string& outcome);

/// Error of the reference on coarser meshes against the finest, over their CPU seconds.
struct ReferenceCost {
  int cells;
  double cpu_seconds, error;
};
/// Empty where the scene has no reference.
std::vector<ReferenceCost> reference_costs(const Scene& scene, const ReferenceStore& store);

reports::Record accuracy_page(const Scene& scene, const std::vector<AccuracyPoint>& points,
                              const std::vector<PointResult>& results, const std::vector<ReferenceCost>& reference,
                              const std::filesystem::path& out);

}  // namespace wetfront::verification
