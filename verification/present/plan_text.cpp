#include "verification/present/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

void add_effects(std::string& text, const mpm::PlanInfo& plan) {
  text += "  effects                                called for by\n";
  for (const auto& effect : plan.effects) {
    text += fmt::format("    {:<36} {}\n", effect.name, effect.called_for_by);
    if (!effect.equations.empty()) text += fmt::format("    {:<36}   {}\n", "", effect.equations);
  }
}

void add_columns(std::string& text, const mpm::PlanInfo& plan) {
  const double total = static_cast<double>(plan.point_bytes), points = std::max(1.0, static_cast<double>(plan.points));
  text += fmt::format("  columns: {} points in {} slots of {} bytes: {:.6g} MB, {:.1f} bytes per point\n", plan.points,
                      plan.slots, plan.bytes_per_point, 1e-6 * total, total / points);
  for (const auto& column : plan.columns)
    text += fmt::format("    {:<26} {:<8} {:<9} {:>3} B  {:<8} by {}\n", column.name, column.symbol, column.unit,
                        column.bytes_per_point, column.carried ? "carried" : "one step", column.provided_by);
}

void add_kernels(std::string& text, const mpm::PlanInfo& plan) {
  text += "  kernels, in order\n";
  std::string phase;
  for (const auto& kernel : plan.kernels) {
    text +=
        fmt::format("    {:<30} {:<36} by {}\n", kernel.phase == phase ? "" : kernel.phase, kernel.name, kernel.effect);
    phase = kernel.phase;
  }
}

void add_limits(std::string& text, const mpm::PlanInfo& plan) {
  const auto binding = std::min_element(plan.step_limits.begin(), plan.step_limits.end(),
                                        [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  text += "  time-step limits at the start of the stage\n";
  if (plan.step_limits.empty()) text += "    none: implicit, accuracy sets the step\n";
  for (auto limit = plan.step_limits.begin(); limit != plan.step_limits.end(); ++limit) {
    const std::string size = std::isfinite(limit->seconds) ? fmt::format("{:.3g} s", limit->seconds) : "none";
    text += fmt::format("    {:<30} {:<12} {}{}\n", limit->name, size, limit->formula,
                        limit == binding && std::isfinite(limit->seconds) ? "   <- binding" : "");
  }
}

}  // namespace

std::string plan_text(const std::vector<mpm::PlanInfo>& plans) {
  std::string text;
  for (const auto& plan : plans) {
    text += fmt::format("stage '{}': {}\n", plan.stage, plan.scheme);
    text += fmt::format("  {} material points, {} cells, {} nodes\n", plan.points, plan.cells, plan.nodes);
    add_effects(text, plan);
    add_columns(text, plan);
    add_kernels(text, plan);
    add_limits(text, plan);
    text += fmt::format("  estimated cost: about {:.2g} steps, {:.2g} CPU-s\n\n", plan.estimated_steps,
                        plan.estimated_cpu_seconds);
  }
  return text;
}

}  // namespace wetfront::verification
