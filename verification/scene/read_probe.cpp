#include "verification/scene/reading.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

/// Why the place is not in the soil, or "".
std::string why_outside(const Geometry& geometry, const std::array<double, 3>& at) {
  const double x = at[0], y = at[1];
  constexpr double slack = 1e-9;  // m: a probe on the surface is inside
  const auto* column = std::get_if<Column>(&geometry.shape);
  if (column && column->height > 0) {
    const double width = column->cells > 0 ? column->height / column->cells : column->height;
    if (y < -slack || y > column->height + slack)
      return fmt::format("the column reaches from 0 m to {:g} m", column->height);
    if (x < -slack || x > width + slack) return fmt::format("the column is one cell, {:g} m, wide", width);
  }
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) {
    if (x < -slack || x > slope->length + slack)
      return fmt::format("the slope reaches from x = 0 m to {:g} m", slope->length);
    const double base = x * std::tan(slope->angle);
    if (y < base - slack || y > base + slope->thickness + slack)
      return fmt::format("at x = {:g} m the soil reaches from {:g} m to {:g} m", x, base, base + slope->thickness);
  }
  if (const auto* box = std::get_if<Box>(&geometry.shape)) {
    for (std::size_t axis = 0; axis < box->size.size(); ++axis)
      if (at[axis] < -slack || at[axis] > box->size[axis] + slack)
        return fmt::format("the box reaches from {0} = 0 m to {1:g} m", "xyz"[axis], box -> size[axis]);
  }
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape); profile && !profile->surface.x.empty()) {
    const double left = profile->surface.x.front(), right = profile->surface.x.back();
    if (x < left - slack || x > right + slack)
      return fmt::format("the profile reaches from x = {:g} m to {:g} m", left, right);
    if (y < base_at(geometry, x) - slack || y > surface_at(geometry, x) + slack)
      return fmt::format("at x = {:g} m the soil reaches from {:g} m to {:g} m", x, base_at(geometry, x),
                         surface_at(geometry, x));
  }
  return "";
}

/// `what` is "probe" or "rider".
void read_position(SectionReader& reader, Probe& point, const std::string& what, const Geometry& geometry) {
  const bool column = std::holds_alternative<Column>(geometry.shape);
  std::string key = "at";
  if (reader.has("elevation")) {
    key = "elevation";
    point.position[1] = reader.quantity("elevation");
    if (!column)
      reader.complain("elevation", {"an elevation alone does not place this " + what,
                                    "only a column has one place per elevation", "Write at = [\"0 m\", \"0.6 m\"]."});
  } else {
    const std::vector<double> at = reader.vector("at");
    for (std::size_t i = 0; i < at.size(); ++i) point.position[i] = at[i];
    check_plane(reader, "at", at, geometry);
  }
  const std::string why = why_outside(geometry, point.position);
  if (!why.empty())
    reader.complain(key, {"the " + what + " '" + point.name + "' is outside the soil", why, "Move it into the soil."});
}

/// Adds a named place in the soil to those read before it, which have other names.
void read_point(SectionReader& reader, const std::string& what, const Geometry& geometry, std::vector<Probe>& points) {
  Probe point;
  point.name = reader.text("name");
  point.origin = reader.origin();
  read_position(reader, point, what, geometry);
  for (const Probe& other : points)
    if (other.name == point.name && !point.name.empty())
      reader.complain("name",
                      {"a second " + what + " is called '" + point.name + "'",
                       "the first stands in line " + std::to_string(other.origin.line), "Give it another name."});
  points.push_back(point);
  reader.finish();
}

}  // namespace

void read_probes(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "probe", reading.complaints))
    read_point(reader, "probe", reading.scene.geometry, reading.scene.probes);
}

void read_riders(Reading& reading) {
  for (SectionReader& reader : sections_of(reading.root, "rider", reading.complaints)) {
    if (!reading.elastic())
      reader.complain_at(reader.place(), {"this rider never moves", "every soil of this scene is rigid",
                                          "Remove it, or give the soil young and poisson."});
    read_point(reader, "rider", reading.scene.geometry, reading.scene.riders);
  }
}

}  // namespace wetfront::verification
