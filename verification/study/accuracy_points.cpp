// Which settings a study of accuracy tries.
#include "verification/study/accuracy.h"
#include "verification/study/cells_times.h"
#include "verification/study/scheme_settings.h"
#include "verification/translate/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double factors[] = {0.25, 0.5, 1.0, 2.0, 4.0};
/// Of the water's bulk modulus, for schemes whose step it limits.
constexpr const char* softenings[] = {"0.1", "0.01"};

struct SchemeChoice {
  std::string scheme, integrator;

  std::string name() const {
    return scheme == "seepage" ? scheme + (integrator.empty() ? ", bdf2" : ", " + integrator) : scheme;
  }
  bool tolerates() const { return controls_its_error(scheme); }
};

/// From the cheapest to the dearest.
std::vector<SchemeChoice> schemes(const Scene& scene) {
  std::vector<SchemeChoice> all;
  const bool rigid = !deforms(scene);
  if (rigid || scene.stages.back().scheme == Scheme::seepage)
    all.insert(all.end(), {{"seepage", ""}, {"seepage", "backward-euler"}});
  if (rigid) all.push_back({"semi-implicit", ""});
  all.insert(all.end(), {{"implicit-drag", ""}, {"explicit", ""}});
  return all;
}

std::vector<Setting> settings_of(const Scene& scene, const SchemeChoice& choice) {
  return scheme_settings(scene, choice.scheme, choice.integrator);
}

/// "40" or "60 x 8".
std::string text_of(const std::vector<Setting>& cells) {
  std::string text;
  for (const Setting& count : cells) text += (text.empty() ? "" : " x ") + count.value;
  return text;
}

std::vector<Setting> with(std::vector<Setting> settings, const std::vector<Setting>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

class Builder {
 public:
  explicit Builder(const Scene& scene) : scene_(scene) {}

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
        add(base.name(), "time tolerance", 1, with(settings, {{last_stage(scene_) + "time_tolerance", tolerance}}),
            std::string(", tolerance ") + tolerance);
    variants(base.name(), settings);
    for (const SchemeChoice& choice : choices)
      if (!choice.tolerates()) softened(choice.name(), settings_of(scene_, choice));
    return std::move(points_);
  }

 private:
  void softened(const std::string& name, const std::vector<Setting>& settings) {
    for (const char* part : softenings)
      add(name, "softened water, " + name, 1, with(settings, {{"mpm.water_softening", part}}),
          std::string(", water softened to ") + part);
  }

  void variants(const std::string& name, const std::vector<Setting>& settings) {
    for (const char* points : {"9", "16"})
      add(name, "points per cell", 1, with(settings, {{"mpm.points_per_cell", points}}),
          std::string(", points per cell ") + points);
    if (deforms(scene_))
      add(name, "shape functions", 1, with(settings, {{"skeleton.shape", "quadratic-spline"}}), ", quadratic splines");
  }

  void add(const std::string& name, const std::string& curve, double factor, const std::vector<Setting>& settings,
           const std::string& suffix) {
    const std::vector<Setting> cells = cells_times(scene_, factor);
    if (!cells.empty())
      points_.push_back({{name + ", " + text_of(cells) + " cells" + suffix, with(settings, cells)}, curve, factor});
  }

  const Scene& scene_;
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
  const std::vector<Setting> finest = cells_times(scene, factors[std::size(factors) - 1]);
  double length = rounded_down(std::min(cost.budget / cost.per_second, 0.5 * whole));
  for (; length > 1e-7 * last; length = rounded_down(0.5 * length)) {
    const Window window{last - length, last};
    if (expected_cpu(scene.path, {"", with(settings_in(window, scene, choice), finest)}) <= cost.budget) return window;
  }
  return {last, last};
}

}  // namespace

std::vector<AccuracyPoint> accuracy_points(const Scene& scene) {
  return Builder(scene).all();
}

std::vector<AccuracyPoint> window_points(const Scene& scene, double budget) {
  if (!scene.water || deforms(scene) || scene.stages.back().scheme != Scheme::seepage ||
      scene.comparison.times.empty() || scene.stages.back().lasts)
    return {};
  const Timeline times = timeline(scene);
  const double begin = times.stage_end.size() > 1 ? times.stage_end[times.stage_end.size() - 2] : 0;
  const double last = times.comparison_times.back();
  const std::vector<Setting> finest = cells_times(scene, factors[std::size(factors) - 1]);
  if (finest.empty()) return {};
  const auto choices = schemes(scene);
  std::vector<AccuracyPoint> points;
  for (std::size_t dear = 0; dear < choices.size() && last > begin; ++dear) {
    const double expected = expected_cpu(scene.path, {"", with(settings_of(scene, choices[dear]), finest)});
    if (!(expected > budget)) continue;
    const Window window =
        affordable(scene, choices[dear], last - begin, last, {budget, expected / (times.end() - begin)});
    const double length = window.to - window.from;
    if (!(length > 1e-7 * last)) continue;  // shorter than a scene can say
    const std::string name = fmt::format("from {:.7g} s for {:.3g} s", window.from, length);
    const auto add = [&](const SchemeChoice& choice, double factor, const std::string& softened) {
      std::vector<Setting> changed = cells_times(scene, factor);
      if (changed.empty()) return;
      const std::string told = choice.name() + ", " + text_of(changed) + " cells, ";
      if (!softened.empty()) changed.push_back({"mpm.water_softening", softened});
      points.push_back({{told + (softened.empty() ? "" : "water softened to " + softened + ", ") + name,
                         with(settings_in(window, scene, choice), changed)},
                        (softened.empty() ? "" : "softened water, ") + choice.name(),
                        factor,
                        name});
    };
    for (std::size_t k = 0; k <= dear; ++k) {
      for (const double factor : factors) add(choices[k], factor, "");
      if (choices[k].tolerates()) continue;  // no step to lengthen
      for (const char* part : softenings) add(choices[k], 1, part);
    }
  }
  return points;
}

}  // namespace wetfront::verification
