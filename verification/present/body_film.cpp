#include "verification/present/body_film.h"

#include "reports/film.h"
#include "verification/compare/magnitude.h"
#include "verification/present/contours.h"

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

}  // namespace

std::vector<reports::Film> body_films(const Scene& scene, const meshes::FieldHistory& history,
                                      const mpm::BodyRecord& body) {
  if (history.mesh.dim != 2 || body.pictures.size() < 2) return {};
  const bool wet = scene.water.has_value() && has_water(body.pictures);
  reports::Film heading;
  heading.id = "body";
  heading.title = "The body in motion";
  heading.caption = "Material points; lines: the background mesh's outline.";
  heading.channels = {{"displacement", "m"}};
  if (wet) heading.channels.insert(heading.channels.end(), {{"pore pressure", "kPa"}, {"degree of saturation", "1"}});
  heading.ground = {outline(history.mesh)};
  std::vector<reports::FilmMoment> moments;
  for (const mpm::Picture& picture : body.pictures) {
    if (!moments.empty() && picture.snapshot.time == moments.back().time) {  // an event's, beside one of the series
      if (!picture.of.empty()) moments.back().label = picture.of;
      continue;
    }
    moments.push_back(moment_of(picture, body.pictures.front(), wet));
  }
  return {reports::make_film(std::move(heading), std::move(moments))};
}

}  // namespace wetfront::verification
