#include "verification/ledger/observed_soil.h"

#include "fem_reference/soil/soil_law.h"
#include "verification/ledger/delivered_rain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::verification {
namespace {

/// Linear between sampled places, constant beyond; `empty` where there are none.
double between(const std::vector<double>& x, const std::vector<double>& y, double at, double empty) {
  if (x.empty()) return empty;
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const std::size_t i = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + values.size() / 2);
  return values[values.size() / 2];
}

struct Samples {
  std::vector<double> x, y;
};

/// Medians over groups of neighbours in x, at most `groups` of them, each of `least` samples or more.
Samples grouped(const Samples& samples, std::size_t groups, std::size_t least) {
  std::vector<std::size_t> order(samples.x.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return samples.x[a] < samples.x[b]; });
  const std::size_t size = std::max(least, (order.size() + groups - 1) / groups);
  Samples out;
  for (std::size_t from = 0; from + least <= order.size(); from += size) {
    Samples group;
    for (std::size_t i = from; i < std::min(from + size, order.size()); ++i)
      group.x.push_back(samples.x[order[i]]), group.y.push_back(samples.y[order[i]]);
    const double x = median(group.x);
    if (!out.x.empty() && !(x > out.x.back())) continue;
    out.x.push_back(x);
    out.y.push_back(median(group.y));
  }
  return out;
}

/// Head at which the law holds this saturation [m], by bisection; 0 where it is full.
double head_of(const fem_reference::SoilLaw& law, double saturation) {
  double wet = 0, dry = -1e4;
  if (saturation >= law.saturation(wet)) return wet;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (wet + dry);
    (law.saturation(middle) < saturation ? dry : wet) = middle;
  }
  return 0.5 * (wet + dry);
}

void observe_content(const meshes::FieldHistory& history, const fem_reference::SoilLaw& law, double unit_weight,
                     ObservedSoil& out) {
  Samples samples;
  double squares = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots)
    for (std::size_t i = 0; i < snapshot.node_pressure.size(); ++i) {
      const double pressure = snapshot.node_pressure[i];
      if (!(pressure < 0)) continue;
      samples.x.push_back(-pressure);
      samples.y.push_back(snapshot.node_saturation[i] - law.saturation(pressure / unit_weight));
      squares += samples.y.back() * samples.y.back();
    }
  if (samples.x.empty()) return;
  out.content_rms = std::sqrt(squares / samples.x.size());
  Samples curve = grouped(samples, 60, 3);
  out.suction = curve.x;
  out.content = curve.y;
}

/// Water above a height per area, cell by cell; and the cells in the order of their elevations.
class Column {
 public:
  explicit Column(const meshes::Mesh& mesh) : mesh_(mesh), up_(meshes::up_axis(mesh.dim)), cells_(mesh.cell_count()) {
    std::iota(cells_.begin(), cells_.end(), 0u);
    std::ranges::sort(cells_, [&](std::size_t a, std::size_t b) { return elevation(a) < elevation(b); });
  }
  const std::vector<std::size_t>& upwards() const { return cells_; }
  double elevation(std::size_t cell) const { return mesh_.cell_centre(cell)[up_]; }
  double height(std::size_t cell) const {
    double low = 1e300, high = -1e300;
    for (const int node : mesh_.cell(cell)) {
      low = std::min(low, mesh_.nodes[node][up_]);
      high = std::max(high, mesh_.nodes[node][up_]);
    }
    return high - low;
  }

 private:
  const meshes::Mesh& mesh_;
  int up_;
  std::vector<std::size_t> cells_;
};

constexpr double even_enough = 0.05;                       ///< of S over one sample: K varies little within it
constexpr double least_gradient = 0.2, most_gradient = 4;  ///< of total head: elsewhere its error is K's

/// K over that of the law between two snapshots, at every face where the soil is even enough.
void sample_interval(const meshes::FieldHistory& history, std::size_t second, const Column& column,
                     const fem_reference::SoilLaw& law, double unit_weight, double inflow, Samples& samples) {
  const meshes::Snapshot &a = history.snapshots[second - 1], &b = history.snapshots[second];
  const double duration = b.time - a.time, rain = inflow / duration;
  if (!(rain > 0)) return;
  double above = 0;  // gain of water above the face
  const auto& cells = column.upwards();
  for (std::size_t i = cells.size(); i-- > 1;) {
    const std::size_t up = cells[i], down = cells[i - 1];
    above += law.porosity() * (b.cell_saturation[up] - a.cell_saturation[up]) * column.height(up);
    const double flux = (inflow - above) / duration;
    const auto [low, high] = std::ranges::minmax(
        {a.cell_saturation[up], b.cell_saturation[up], a.cell_saturation[down], b.cell_saturation[down]});
    const double rise = column.elevation(up) - column.elevation(down);
    const double gradient =
        1 + 0.5 * (a.cell_pressure[up] - a.cell_pressure[down] + b.cell_pressure[up] - b.cell_pressure[down]) /
                (unit_weight * rise);
    if (high - low > even_enough || gradient < least_gradient || gradient > most_gradient || flux < 0.1 * rain)
      continue;
    const double saturation =
        0.25 * (a.cell_saturation[up] + b.cell_saturation[up] + a.cell_saturation[down] + b.cell_saturation[down]);
    samples.x.push_back(saturation);
    samples.y.push_back(flux / gradient / law.conductivity(head_of(law, saturation)).value);
  }
}

}  // namespace

ObservedSoil observe(const meshes::FieldHistory& history, const fem_reference::Soil& soil, double unit_weight,
                     double area) {
  const fem_reference::SoilLaw law(soil, unit_weight);
  ObservedSoil out;
  observe_content(history, law, unit_weight, out);
  const std::vector<double> sum = delivered(history.ledger);
  const auto depth = [&](double time) {
    std::size_t row = 0;
    while (row + 1 < history.ledger.size() && history.ledger[row + 1].time <= time * (1 + 1e-12)) ++row;
    if (row + 1 >= history.ledger.size()) return sum.back() / area;
    const auto &a = history.ledger[row], &b = history.ledger[row + 1];
    const double part = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
    return (sum[row] + part * (sum[row + 1] - sum[row])) / area;
  };
  const Column column(history.mesh);
  Samples samples;
  for (std::size_t t = 1; t < history.snapshots.size(); ++t)
    sample_interval(history, t, column, law, unit_weight,
                    depth(history.snapshots[t].time) - depth(history.snapshots[t - 1].time), samples);
  out.flux_samples = samples.x.size();
  const Samples curve = grouped(samples, 8, 5);
  out.saturation = curve.x;
  out.conductivity = curve.y;
  return out;
}

void relate_to(ObservedSoil& soil, const ObservedSoil& truth) {
  if (truth.conductivity.empty()) {
    soil.saturation.clear(), soil.conductivity.clear();
    return;
  }
  for (std::size_t i = 0; i < soil.saturation.size(); ++i)
    soil.conductivity[i] /= between(truth.saturation, truth.conductivity, soil.saturation[i], 1);
}

fem_reference::Soil tabulated(const fem_reference::Soil& soil, double unit_weight, double driest_head,
                              const ObservedSoil* content, const ObservedSoil* conductivity) {
  const fem_reference::SoilLaw law(soil, unit_weight);
  constexpr int rows = 300;
  fem_reference::TabulatedRetention retention;
  fem_reference::TabulatedConductivity relative;
  const double full = law.saturation(0);
  const double deepest = 3 * std::abs(driest_head) + 1, nearest = 1e-4;
  double last_content = 0, last_relative = 0;
  const double at_full = conductivity ? between(conductivity->saturation, conductivity->conductivity, full, 1) : 1;
  for (int i = 0; i <= rows; ++i) {
    const double head = i == rows ? 0 : -deepest * std::pow(nearest / deepest, static_cast<double>(i) / (rows - 1));
    const double departure =
        content && i < rows ? between(content->suction, content->content, -head * unit_weight, 0) : 0;
    const double saturation = std::clamp(law.saturation(head) + departure, 1e-6, full);
    double k = law.conductivity(head_of(law, saturation)).value / soil.saturated_conductivity;
    if (conductivity) k *= between(conductivity->saturation, conductivity->conductivity, saturation, 1) / at_full;
    last_content = i == rows ? law.porosity() * full : std::max(last_content, law.porosity() * saturation);
    last_relative = i == rows ? 1 : std::clamp(k, std::max(last_relative, 1e-12), 1.0);
    retention.head.push_back(head);
    retention.content.push_back(std::min(last_content, law.porosity() * full));
    relative.head.push_back(head);
    relative.relative.push_back(last_relative);
  }
  fem_reference::Soil out = soil;
  out.retention = retention;
  out.conductivity = relative;
  out.saturated_conductivity *= at_full;
  out.porosity = law.porosity();
  return out;
}

}  // namespace wetfront::verification
