#include "verification/present/body_film.h"

#include "reports/film.h"
#include "verification/compare/magnitude.h"
#include "verification/present/contours.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double kPa = 1000;

/// Since the run began; where that was not kept, since the first picture.
std::vector<double> displacements(const mpm::Picture& picture, const mpm::Picture& first) {
  const auto &places = picture.snapshot.points.position, &from = first.snapshot.points.position;
  std::vector<double> moved;
  for (std::size_t p = 0; p < places.size(); ++p)
    moved.push_back(magnitude(picture.displacement.size() == places.size()
                                  ? picture.displacement[p]
                                  : meshes::Point{places[p][0] - from.at(p)[0], places[p][1] - from[p][1]}));
  return moved;
}

std::vector<double> in_unit(std::vector<double> values, double unit) {
  for (double& value : values) value /= unit;
  return values;
}

reports::FilmMoment moment_of(const mpm::Picture& picture, const mpm::Picture& first, bool wet) {
  reports::FilmMoment moment{picture.snapshot.time, picture.of, {}, {}, {displacements(picture, first)}};
  const meshes::PointCloud& points = picture.snapshot.points;
  for (const meshes::Point& place : points.position) {
    moment.x.push_back(place[0]);
    moment.y.push_back(place[1]);
  }
  if (!wet) return moment;
  moment.values.push_back(in_unit(points.pressure, kPa));
  moment.values.push_back(points.saturation);
  return moment;
}

/// Whether every picture has the same points, and each of them pressure and saturation.
bool has_water(const std::vector<mpm::Picture>& pictures) {
  for (const mpm::Picture& picture : pictures) {
    const meshes::PointCloud& points = picture.snapshot.points;
    if (points.pressure.size() != points.position.size() || points.saturation.size() != points.position.size())
      return false;
  }
  return true;
}

/// Where the points began; nothing where that was not kept.
std::vector<meshes::Point> beginnings(const mpm::Picture& picture) {
  std::vector<meshes::Point> places = picture.snapshot.points.position;
  if (picture.displacement.size() != places.size()) return {};
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t axis = 0; axis < 2; ++axis) places[p][axis] -= picture.displacement[p][axis];
  return places;
}

/// The body under the rain, before the first of its pictures: the fields that are compared hold its points. They must
/// have the order that they have in the picture, which they lose only once they change their cells: none may have left
/// its place by a fifth of a cell.
std::vector<mpm::Picture> under_rain(const meshes::FieldHistory& history, const mpm::Picture& first) {
  const std::vector<meshes::Point> began = beginnings(first);
  if (began.empty()) return {};
  const double near = 0.2 * std::sqrt(history.mesh.cell_measure(0));
  std::vector<mpm::Picture> pictures;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    const auto& places = snapshot.points.position;
    if (!(snapshot.time < first.snapshot.time) || places.size() != began.size()) continue;
    mpm::Picture picture{snapshot, "", {}};
    for (std::size_t p = 0; p < places.size(); ++p)
      picture.displacement.push_back({places[p][0] - began[p][0], places[p][1] - began[p][1], 0});
    if (std::ranges::all_of(picture.displacement, [&](const meshes::Point& moved) { return magnitude(moved) < near; }))
      pictures.push_back(std::move(picture));
  }
  return pictures;
}

}  // namespace

std::vector<reports::Film> body_films(const Scene& scene, const meshes::FieldHistory& history,
                                      const mpm::BodyRecord& body) {
  if (history.mesh.dim != 2 || body.pictures.size() < 2) return {};
  std::vector<mpm::Picture> pictures = under_rain(history, body.pictures.front());
  pictures.insert(pictures.end(), body.pictures.begin(), body.pictures.end());
  const bool wet = scene.water.has_value() && has_water(pictures);
  reports::Film heading;
  heading.id = "body";
  heading.title = "The body in motion";
  heading.caption = "Material points; lines: the background mesh's outline.";
  heading.channels = {{"displacement", "m"}};
  if (wet) heading.channels.insert(heading.channels.end(), {{"pore pressure", "kPa"}, {"degree of saturation", "1"}});
  heading.ground = {outline(history.mesh)};
  std::vector<reports::FilmMoment> moments;
  for (const mpm::Picture& picture : pictures) {
    if (!moments.empty() && picture.snapshot.time == moments.back().time) {  // an event's, beside one of the series
      if (!picture.of.empty()) moments.back().label = picture.of;
      continue;
    }
    moments.push_back(moment_of(picture, pictures.front(), wet));
  }
  return {reports::make_film(std::move(heading), std::move(moments))};
}

}  // namespace wetfront::verification
