#include "verification/scene/place_table.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace wetfront::verification {
namespace {

using Place = std::array<double, 3>;

double nearest_value(const PlaceTable& table, const Place& point) {
  double least = std::numeric_limits<double>::infinity(), value = 0;
  for (std::size_t i = 0; i < table.place.size(); ++i) {
    double distance = 0;
    for (int axis = 0; axis < 3; ++axis)
      distance += (table.place[i][axis] - point[axis]) * (table.place[i][axis] - point[axis]);
    if (distance < least) least = distance, value = table.value[i];
  }
  return value;
}

double bilinear_value(const PlaceTable& table, const Place& point) {
  std::map<double, std::map<double, double>> rows;  // y -> x -> value
  for (std::size_t i = 0; i < table.place.size(); ++i) rows[table.place[i][1]][table.place[i][0]] = table.value[i];
  std::vector<double> y, along;
  for (const auto& [height, row] : rows) {
    std::vector<double> x, value;
    for (const auto& [position, at] : row) x.push_back(position), value.push_back(at);
    y.push_back(height);
    along.push_back(interpolate(x, value, point[0]));
  }
  return interpolate(y, along, point[1]);
}

}  // namespace

double PlaceTable::at(const Place& point) const {
  return bilinear ? bilinear_value(*this, point) : nearest_value(*this, point);
}

bool forms_grid(const std::vector<Place>& places) {
  std::set<double> x, y;
  std::set<std::pair<double, double>> pairs;
  for (const Place& place : places) {
    x.insert(place[0]);
    y.insert(place[1]);
    pairs.emplace(place[0], place[1]);
    if (place[2] != 0) return false;
  }
  return !places.empty() && pairs.size() == places.size() && pairs.size() == x.size() * y.size();
}

double interpolate(const std::vector<double>& positions, const std::vector<double>& values, double at) {
  const auto above = std::upper_bound(positions.begin(), positions.end(), at) - positions.begin();
  if (above == 0) return values.front();
  if (above == static_cast<std::ptrdiff_t>(positions.size())) return values.back();
  const double low = positions[above - 1], high = positions[above];
  return values[above - 1] + (values[above] - values[above - 1]) * (at - low) / (high - low);
}

}  // namespace wetfront::verification
