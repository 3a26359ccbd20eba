#include "verification/scene/geometry.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

}  // namespace

double Polyline::at(double position) const {
  if (x.empty()) return std::nan("");
  if (position <= x.front()) return y.front();
  for (std::size_t i = 1; i < x.size(); ++i)
    if (position <= x[i]) return y[i - 1] + (y[i] - y[i - 1]) * (position - x[i - 1]) / (x[i] - x[i - 1]);
  return y.back();
}

bool Extent::contains(const std::array<double, 3>& point) const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(point[axis] >= from[axis] && point[axis] <= to[axis])) return false;
  return true;
}

int Geometry::dim() const {
  if (std::holds_alternative<MeshFile>(shape)) return 0;
  const auto* box = std::get_if<Box>(&shape);
  return box && box->dim() == 3 ? 3 : 2;
}

double surface_at(const Geometry& geometry, double x) {
  return std::visit(Overloaded{[](const Column& column) { return column.height; },
                               [&](const Slope& slope) { return x * std::tan(slope.angle) + slope.thickness; },
                               [](const MeshFile&) { return std::nan(""); },
                               [](const Box& box) { return box.size.empty() ? std::nan("") : box.size.back(); },
                               [&](const GroundProfile& profile) { return profile.surface.at(x); }},
                    geometry.shape);
}

double base_at(const Geometry& geometry, double x) {
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) return x * std::tan(slope->angle);
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) return profile->bedrock.at(x);
  return 0;
}

std::vector<double> layer_bottoms(const Geometry& geometry, double x) {
  std::vector<double> bottoms;
  double above = surface_at(geometry, x);
  for (const Layer& layer : geometry.layers) {
    above = std::visit(Overloaded{[&](const Layer::ToBase&) { return base_at(geometry, x); },
                                  [&](const Layer::Thickness& thickness) { return above - thickness.value; },
                                  [](const Layer::Elevation& elevation) { return elevation.value; },
                                  [&](const Polyline& line) { return line.at(x); }},
                       layer.bottom);
    bottoms.push_back(above);
  }
  return bottoms;
}

std::vector<double> stations(const Geometry& geometry) {
  std::vector<double> places = {0, 0};
  if (const auto* column = std::get_if<Column>(&geometry.shape))  // a strip of square cells
    places[1] = column->cells > 0 && column->height > 0 ? column->height / column->cells : 1;
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) places[1] = slope->length;
  if (const auto* box = std::get_if<Box>(&geometry.shape)) places[1] = box->size.empty() ? 0 : box->size.front();
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) {
    places = profile->surface.x;
    places.insert(places.end(), profile->bedrock.x.begin(), profile->bedrock.x.end());
  }
  if (places.empty()) return places;
  std::sort(places.begin(), places.end());
  const double left = places.front(), right = places.back();
  for (const Layer& layer : geometry.layers)
    if (const auto* line = std::get_if<Polyline>(&layer.bottom))
      for (const double x : line->x)
        if (x > left && x < right) places.push_back(x);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::string> side_names(const Geometry& geometry) {
  if (std::holds_alternative<MeshFile>(geometry.shape)) return {};
  std::vector<std::string> names = {"top", "base", "left", "right"};
  if (geometry.dim() == 3) names.insert(names.end(), {"front", "back"});
  for (const SidePart& part : geometry.parts) names.push_back(part.name);
  return names;
}

}  // namespace wetfront::verification
