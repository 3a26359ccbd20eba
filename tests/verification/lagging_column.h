#pragma once

#include "meshes/field_history.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// A candidate with a known defect: a column by finite volumes whose conductivity is that of the beginning of each
/// step. Its own code throughout; with small steps it is right.
namespace wetfront::verification {

struct LaggingColumn {
  double height, rain, end;         ///< m, m/s, s
  double porosity, conductivity;    ///< -, m/s
  double air_entry, lambda, s_min;  ///< Pa, -, -
  double suction_cap, unit_weight;  ///< Pa, Pa/m
  int cells;
  double step;                ///< s
  std::vector<double> times;  ///< s, at which fields are kept

  double effective(double p) const {
    return p >= 0 ? 1 : std::pow(1 + std::pow(-p / air_entry, 1 / (1 - lambda)), -lambda);
  }
  double saturation(double p) const { return s_min + (1 - s_min) * effective(p); }
  double hydraulic(double p) const {
    const double se = effective(p);
    return conductivity * std::sqrt(se) * std::pow(1 - std::pow(1 - std::pow(se, 1 / lambda), lambda), 2);
  }

  meshes::FieldHistory run() const {
    const double h = height / cells;
    std::vector<double> p(cells);
    for (int i = 0; i < cells; ++i) p[i] = std::max(-suction_cap, -unit_weight * h * (i + 0.5));
    meshes::FieldHistory out = empty();
    double time = 0, fallen = 0;
    out.ledger.push_back({0, 0, 0, 0, 0, stored(p)});
    std::size_t next = 0;
    keep(out, p, time, next);
    while (time < end * (1 - 1e-12)) {
      double dt = std::min(step, end - time);
      if (next < times.size()) dt = std::min(dt, times[next] - time);
      advance(p, dt);
      time += dt;
      fallen += rain * dt;
      out.ledger.push_back({time, fallen, fallen, 0, 0, stored(p)});
      keep(out, p, time, next);
    }
    return out;
  }

 private:
  meshes::FieldHistory empty() const {
    meshes::FieldHistory out;
    out.solver = "finite volumes, lagged conductivity";
    out.mesh.dim = 1;
    for (int i = 0; i <= cells; ++i) out.mesh.nodes.push_back({height * i / cells, 0, 0});
    for (int i = 0; i < cells; ++i) {
      out.mesh.cells.insert(out.mesh.cells.end(), {i, i + 1});
      out.mesh.region.push_back(0);
    }
    out.mesh.region_names = {"sand"};
    out.mesh.sides = {{"base", {0}}, {"top", {cells}}};
    return out;
  }
  double stored(const std::vector<double>& p) const {
    double sum = 0;
    for (const double value : p) sum += porosity * saturation(value) * height / cells;
    return sum;
  }
  void keep(meshes::FieldHistory& out, const std::vector<double>& p, double time, std::size_t& next) const {
    if (next >= times.size() || time < times[next] * (1 - 1e-12)) return;
    ++next;
    meshes::Snapshot kept;
    kept.time = time;
    for (int i = 0; i <= cells; ++i) {
      const double below = i == 0 ? 1.5 * p[0] - 0.5 * p[1] : p[i - 1];
      const double above = i == cells ? 1.5 * p[cells - 1] - 0.5 * p[cells - 2] : p[i];
      kept.node_pressure.push_back(i == 0 ? below : i == cells ? above : 0.5 * (below + above));
      kept.node_saturation.push_back(saturation(kept.node_pressure.back()));
    }
    kept.cell_pressure = p;
    for (const double value : p) kept.cell_saturation.push_back(saturation(value));
    out.snapshots.push_back(kept);
  }
  /// n S(p) = n S(p_n) + dt (inflow - outflow) / h with K of p_n between cells, by Newton's method with bisected steps.
  void advance(std::vector<double>& p, double dt) const {
    const double h = height / cells;
    std::vector<double> k(cells + 1, 0), old = p;
    for (int i = 1; i < cells; ++i) k[i] = 0.5 * (hydraulic(p[i - 1]) + hydraulic(p[i]));
    for (int iteration = 0; iteration < 200; ++iteration) {
      std::vector<double> lower(cells, 0), diagonal(cells), upper(cells, 0), rest(cells);
      double worst = 0;
      for (int i = 0; i < cells; ++i) {
        const double capacity = porosity * (saturation(p[i] + 0.5) - saturation(p[i] - 0.5)) + 1e-12;
        diagonal[i] = capacity * h / dt;
        rest[i] = -porosity * (saturation(p[i]) - saturation(old[i])) * h / dt;
        if (i > 0) {
          rest[i] -= k[i] * ((p[i] - p[i - 1]) / (unit_weight * h) + 1);
          diagonal[i] += k[i] / (unit_weight * h), lower[i] = -k[i] / (unit_weight * h);
        }
        if (i + 1 < cells) {
          rest[i] += k[i + 1] * ((p[i + 1] - p[i]) / (unit_weight * h) + 1);
          diagonal[i] += k[i + 1] / (unit_weight * h), upper[i] = -k[i + 1] / (unit_weight * h);
        } else {
          rest[i] += rain;
        }
        worst = std::max(worst, std::abs(rest[i]));
      }
      if (worst < 1e-9 * rain) return;
      for (int i = 1; i < cells; ++i) {  // Thomas
        const double w = lower[i] / diagonal[i - 1];
        diagonal[i] -= w * upper[i - 1], rest[i] -= w * rest[i - 1];
      }
      for (int i = cells - 1; i >= 0; --i) {
        rest[i] = (rest[i] - (i + 1 < cells ? upper[i] * rest[i + 1] : 0)) / diagonal[i];
      }
      for (int i = 0; i < cells; ++i) p[i] += std::clamp(rest[i], -2000.0, 2000.0);
    }
  }
};

}  // namespace wetfront::verification
