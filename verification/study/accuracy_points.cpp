// Which settings a study of accuracy tries.
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/translate/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double factors[] = {0.25, 0.5, 1.0, 2.0, 4.0};

struct Count {
  std::string path;
  int cells;
};

std::vector<Count> cell_counts(const Scene& scene) {
  const Shape& shape = scene.geometry.shape;
  if (const auto* column = std::get_if<Column>(&shape)) return {{"geometry.column.cells", column->cells}};
  if (const auto* slope = std::get_if<Slope>(&shape))
    return {{"geometry.slope.cells_along", slope->cells_along}, {"geometry.slope.cells_over", slope->cells_over}};
  if (const auto* profile = std::get_if<GroundProfile>(&shape))
    return {{"geometry.profile.cells_along", profile->cells_along},
            {"geometry.profile.cells_over", profile->cells_over}};
  if (const auto* box = std::get_if<Box>(&shape)) {
    std::vector<Count> counts;
    for (std::size_t i = 0; i < box->cells.size(); ++i)
      counts.push_back({"geometry.box.cells[" + std::to_string(i) + "]", box->cells[i]});
    return counts;
  }
  throw SceneError({scene.geometry.origin.text() +
                    ": what accuracy costs cannot be studied on a mesh of your own (its cells cannot be halved from "
                    "here). Describe the ground by a shape."});
}

bool is_rigid(const Scene& scene) {
  return std::ranges::none_of(scene.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
}

struct SchemeChoice {
  std::string scheme, integrator;

  std::string name() const {
    return scheme == "seepage" ? scheme + (integrator.empty() ? ", bdf2" : ", " + integrator) : scheme;
  }
  bool tolerates() const { return scheme == "seepage" || scheme == "semi-implicit"; }  ///< has a tolerance in time
};

/// From the cheapest to the dearest.
std::vector<SchemeChoice> schemes(const Scene& scene) {
  std::vector<SchemeChoice> all;
  const bool rigid = is_rigid(scene);
  if (rigid || scene.stages.back().scheme == Scheme::seepage)
    all.insert(all.end(), {{"seepage", ""}, {"seepage", "backward-euler"}});
  if (rigid) all.push_back({"semi-implicit", ""});
  all.insert(all.end(), {{"implicit-drag", ""}, {"explicit", ""}});
  return all;
}

std::string last_stage(const Scene& scene) {
  return "stage[" + std::to_string(scene.stages.size() - 1) + "].";
}

/// The scheme of the last stage.
std::vector<Setting> settings_of(const Scene& scene, const SchemeChoice& choice) {
  const std::string stage = last_stage(scene);
  std::vector<Setting> settings{{stage + "time_integrator", choice.integrator}};
  if (!choice.tolerates()) settings.push_back({stage + "time_tolerance", ""});
  // Two velocities know no equilibrium: their skeleton moves, or is rigid.
  if (!choice.tolerates() && !is_rigid(scene) && scene.stages.back().motion.quasi_static)
    settings.push_back({stage + "skeleton", "dynamic"});
  settings.push_back({stage + "scheme", choice.scheme});
  return settings;
}

/// Sets the cells to so many times the scene's; false where that is no mesh of this family.
bool set_cells(const std::vector<Count>& counts, double factor, std::vector<Setting>& settings, std::string& text) {
  for (const Count& count : counts) {
    const double wanted = count.cells * factor;
    if (wanted != std::floor(wanted) || wanted < 2) return false;
    settings.push_back({count.path, fmt::format("{:.0f}", wanted)});
    text += (text.empty() ? "" : " x ") + settings.back().value;
  }
  return true;
}

class Builder {
 public:
  explicit Builder(const Scene& scene) : scene_(scene), counts_(cell_counts(scene)) {}

  std::vector<AccuracyPoint> all() {
    if (!scene_.water) {
      for (const double factor : factors) add("dynamics", "dynamics", factor, {}, "");
      variants("dynamics", {});
      return std::move(points_);
    }
    const auto choices = schemes(scene_);
    for (const SchemeChoice& choice : choices)
      for (const double factor : factors) add(choice.name(), choice.name(), factor, settings_of(scene_, choice), "");
    const SchemeChoice& base = choices.front();
    const std::vector<Setting> settings = settings_of(scene_, base);
    if (base.scheme == "seepage")
      for (const char* tolerance : {"1e-2", "1e-3", "1e-4", "1e-6"})
        add(base.name(), "time tolerance", 1, with(settings, {last_stage(scene_) + "time_tolerance", tolerance}),
            std::string(", tolerance ") + tolerance);
    variants(base.name(), settings);
    return std::move(points_);
  }

 private:
  static std::vector<Setting> with(std::vector<Setting> settings, Setting more) {
    settings.push_back(std::move(more));
    return settings;
  }

  void variants(const std::string& name, const std::vector<Setting>& settings) {
    for (const char* points : {"9", "16"})
      add(name, "points per cell", 1, with(settings, {"mpm.points_per_cell", points}),
          std::string(", points per cell ") + points);
    if (!is_rigid(scene_))
      add(name, "shape functions", 1, with(settings, {"skeleton.shape", "quadratic-spline"}), ", quadratic splines");
  }

  void add(const std::string& name, const std::string& curve, double factor, std::vector<Setting> settings,
           const std::string& suffix) {
    std::string cells;
    if (set_cells(counts_, factor, settings, cells))
      points_.push_back({{name + ", " + cells + " cells" + suffix, std::move(settings)}, curve, factor});
  }

  const Scene& scene_;
  std::vector<Count> counts_;
  std::vector<AccuracyPoint> points_;
};

/// The largest of 1, 2 or 5 times a power of ten that is not above the value.
double rounded_down(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

/// A stretch of the last stage up to the last comparison time [s].
struct Window {
  double from, to;
};

std::string seconds(double value) {
  return fmt::format("{:.10g} s", value);
}

/// Seepage up to the window, then the scheme; compared at the window's end only.
std::vector<Setting> settings_in(const Window& window, const Scene& scene, const SchemeChoice& choice) {
  std::vector<Setting> settings{{last_stage(scene) + "until", seconds(window.from)}};
  settings.push_back(
      {"stage[+]", "{ name = \"window\", scheme = \"" + choice.scheme + "\", until = \"" + seconds(window.to) + "\"" +
                       (choice.integrator.empty() ? "" : ", time_integrator = \"" + choice.integrator + "\"") + " }"});
  settings.push_back({"comparison.times", "[\"" + seconds(window.to) + "\"]"});
  for (std::size_t i = 0; i < scene.comparison.tolerances.size(); ++i)
    if (scene.comparison.tolerances[i].at) settings.push_back({"tolerance[" + std::to_string(i) + "].at", ""});
  return settings;
}

struct Cost {
  double budget, per_second;  ///< s of CPU; of the whole stage on the finest cells
};

/// The longest window, up to half of `whole`, whose own plan keeps within the budget on the finest cells: steps there
/// may be shorter than those of the stage as a whole.
Window affordable(const Scene& scene, const SchemeChoice& choice, double whole, double last, const Cost& cost) {
  double length = rounded_down(std::min(cost.budget / cost.per_second, 0.5 * whole));
  for (; length > 1e-7 * last; length = rounded_down(0.5 * length)) {
    const Window window{last - length, last};
    std::vector<Setting> settings = settings_in(window, scene, choice);
    std::string unused;
    if (!set_cells(cell_counts(scene), factors[std::size(factors) - 1], settings, unused)) break;
    if (expected_cpu(scene.path, {"", settings}) <= cost.budget) return window;
  }
  return {last, last};
}

}  // namespace

std::vector<AccuracyPoint> accuracy_points(const Scene& scene) {
  return Builder(scene).all();
}

std::vector<AccuracyPoint> window_points(const Scene& scene, double budget) {
  if (!scene.water || !is_rigid(scene) || scene.stages.back().scheme != Scheme::seepage ||
      scene.comparison.times.empty() || scene.stages.back().lasts)
    return {};
  const Timeline times = timeline(scene);
  const double begin = times.stage_end.size() > 1 ? times.stage_end[times.stage_end.size() - 2] : 0;
  const double last = times.comparison_times.back();
  const auto counts = cell_counts(scene);
  const auto choices = schemes(scene);
  std::vector<AccuracyPoint> points;
  for (std::size_t dear = 0; dear < choices.size() && last > begin; ++dear) {
    std::vector<Setting> finest = settings_of(scene, choices[dear]);
    std::string unused;
    if (!set_cells(counts, factors[std::size(factors) - 1], finest, unused)) continue;
    const double expected = expected_cpu(scene.path, {"", finest});
    if (!(expected > budget)) continue;
    const Window window =
        affordable(scene, choices[dear], last - begin, last, {budget, expected / (times.end() - begin)});
    const double length = window.to - window.from;
    if (!(length > 1e-7 * last)) continue;  // shorter than a scene can say
    const std::string name = fmt::format("from {:.7g} s for {:.3g} s", window.from, length);
    for (std::size_t k = 0; k <= dear; ++k)
      for (const double factor : factors) {
        std::vector<Setting> settings = settings_in(window, scene, choices[k]);
        std::string cells;
        if (!set_cells(counts, factor, settings, cells)) continue;
        points.push_back({{choices[k].name() + ", " + cells + " cells, " + name, std::move(settings)},
                          choices[k].name(),
                          factor,
                          name});
      }
  }
  return points;
}

}  // namespace wetfront::verification
