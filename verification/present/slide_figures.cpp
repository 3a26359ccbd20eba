#include "verification/present/slide_figures.h"

#include "verification/compare/magnitude.h"
#include "verification/compare/window.h"
#include "verification/present/body_figures.h"
#include "verification/present/figure_frame.h"
#include "verification/present/known.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

/// 1, 2 or 5 times a power of ten, at least the value.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (value <= factor * power * (1 + 1e-12)) return factor * power;
  return 10 * power;
}

Series ground_line(const Scene& scene, bool top) {
  Series line;
  line.label = top ? "surface at the start" : "base";
  line.colour = 6;
  if (top) line.style = Series::Style::dashed;
  for (const double x : stations(scene.geometry)) {
    line.x.push_back(x);
    line.y.push_back(top ? surface_at(scene.geometry, x) : base_at(scene.geometry, x));
  }
  return line;
}

/// Points in classes of displacement: quarters of a round number above the largest.
Figure still(const Scene& scene, const mpm::Picture& picture) {
  Figure figure =
      figure_frame({"body_at_" + picture.of,
                    "The slope at " + picture.of + fmt::format(", t = {:.6g} s", picture.snapshot.time), "The slide"},
                   {"x", "m"}, {"elevation", "m"});
  const auto& places = picture.snapshot.points.position;
  double farthest = 1e-300;
  for (const meshes::Point& d : picture.displacement) farthest = std::max(farthest, magnitude(d));
  const double whole = rounded_up(farthest);
  constexpr std::array<double, 5> bounds = {0.02, 0.1, 0.25, 0.5, 1};
  constexpr std::array<int, 5> colours = {6, 5, 2, 4, 1};
  double below = -1;
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    Series series;
    series.style = Series::Style::points;
    series.colour = colours[k];
    const double unit = whole < 0.05 ? 1e-3 : 1;
    series.label = fmt::format("moved {:.3g} to {:.3g} {}", std::max(0.0, below) / unit, bounds[k] * whole / unit,
                               unit < 1 ? "mm" : "m");
    for (std::size_t p = 0; p < picture.displacement.size(); ++p) {
      const double moved = magnitude(picture.displacement[p]);
      if (moved <= below || moved > bounds[k] * whole) continue;
      series.x.push_back(places[p][0]);
      series.y.push_back(places[p][1]);
    }
    below = bounds[k] * whole;
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  }
  figure.series.push_back(ground_line(scene, true));
  figure.series.push_back(ground_line(scene, false));
  figure.note = fmt::format("largest displacement {:.3g} m", farthest);
  return figure;
}

/// The body at failure, twice on its way and at the end: outlines that can be told from each other.
std::vector<const meshes::Snapshot*> few_of_the_slide(const mpm::BodyRecord& body) {
  const auto failed = std::ranges::find(body.pictures, "failure", &mpm::Picture::of);
  const auto first = failed == body.pictures.end() ? body.pictures.begin() : failed;
  const auto largest = [](const mpm::Picture& picture) {
    double farthest = 0;
    for (const meshes::Point& d : picture.displacement) farthest = std::max(farthest, magnitude(d));
    return farthest;
  };
  std::vector<const meshes::Snapshot*> times = {&first->snapshot};
  const double begun = largest(*first), way = largest(body.pictures.back()) - begun;
  for (const double share : {1.0 / 3, 2.0 / 3}) {
    const auto there = std::find_if(first, body.pictures.end() - 1, [&](const mpm::Picture& picture) {
      return largest(picture) >= begun + share * way;
    });
    if (there->snapshot.time > times.back()->time && there + 1 != body.pictures.end())
      times.push_back(&there->snapshot);
  }
  if (body.pictures.back().snapshot.time > times.back()->time) times.push_back(&body.pictures.back().snapshot);
  return times;
}

std::vector<Figure> of_markers(const Scene& scene, const mpm::BodyRecord& body) {
  const double failure = failure_time(body);
  const double begin = std::isfinite(failure) ? failure : 0;
  const std::string axis = std::isfinite(failure) ? "time since failure" : "time";
  Figure far = figure_frame({"marker_displacement", "Displacement of the markers", "The slide"}, {axis, "s"},
                            {"displacement", "m"});
  Figure fast =
      figure_frame({"marker_velocity", "Velocity of the markers", "The slide"}, {axis, "s"}, {"velocity", "m/s"});
  for (const mpm::Rider& rider : body.riders) {
    Series d, v;
    d.label = v.label = rider.name;
    const std::size_t stride = 1 + rider.time.size() / 2000;
    for (std::size_t k = 0; k < rider.time.size(); k += stride) {
      if (rider.time[k] < begin) continue;
      d.x.push_back(rider.time[k] - begin);
      v.x.push_back(rider.time[k] - begin);
      d.y.push_back(magnitude({rider.place[k][0] - rider.start[0], rider.place[k][1] - rider.start[1], 0}));
      v.y.push_back(magnitude(rider.velocity[k]));
    }
    if (d.x.size() < 2) continue;
    far.series.push_back(std::move(d));
    fast.series.push_back(std::move(v));
  }
  if (far.series.empty()) return {};
  draw_known_displacement(far, scene);
  return {far, fast};
}

std::string number(const Outcome* outcome) {
  if (outcome == nullptr || std::isnan(outcome->value)) return "-";
  const std::string meaning = in_words(*outcome);
  return fmt::format("{:.5g}{}{}", outcome->value, outcome->unit == "-" ? "" : " " + outcome->unit,
                     meaning.empty() ? "" : ", " + meaning);
}

const std::string apart = "the two meshes differ by";

std::string doubt(const std::optional<OnSecondMesh>& second) {
  return second ? "What two meshes differ by is the numerical doubt; shares are of the value here." : "";
}

}  // namespace

std::vector<Figure> slide_figures(const Scene& scene, const meshes::FieldHistory& history,
                                  const mpm::BodyRecord& body) {
  std::vector<Figure> all;
  if (history.mesh.dim != 2 || std::holds_alternative<MeshFile>(scene.geometry.shape)) return all;
  for (const mpm::Picture& picture : body.pictures)
    if (!picture.of.empty() && !picture.displacement.empty()) all.push_back(still(scene, picture));
  if (!all.empty()) {
    const std::vector<const meshes::Snapshot*> times = few_of_the_slide(body);
    for (Figure& outline :
         body_figures(history.mesh, times,
                      {"slide_outline", "The slide: its upper outline in time, its points at the end", "The slide"}))
      all.push_back(std::move(outline));
  }
  for (Figure& markers : of_markers(scene, body)) all.push_back(std::move(markers));
  return all;
}

reports::Table stage_table(const mpm::BodyRecord& body) {
  reports::Table table{"Stages", "The slide", "", {"stage", "from [s]", "until [s]", "ended by", "why", "plan"}, {}};
  for (const mpm::StageSpan& stage : body.stages)
    table.rows.push_back({stage.name, fmt::format("{:.6g}", stage.begin), fmt::format("{:.6g}", stage.end),
                          stage.ended_by.empty() ? "under way" : stage.ended_by, stage.reason, stage.scheme});
  return table;
}

reports::Table outcome_table(const std::vector<Outcome>& outcomes, const std::optional<OnSecondMesh>& second) {
  reports::Table table{"What came out", "The slide", doubt(second), {"quantity", "what", "value"}, {}};
  if (second) table.header.insert(table.header.end(), {second->cells, apart});
  for (const Outcome& one : outcomes) {
    if (told_the_other_way(one)) continue;
    table.rows.push_back({one.name, one.description, number(&one)});
    if (!second) continue;
    const Outcome* other = find_outcome(second->outcomes, one.name);
    for (const std::string& cell : {number(other), difference_of_meshes(&one, other)})
      table.rows.back().push_back(cell);
  }
  return table;
}

reports::Table observed_table(const Scene& scene, const std::vector<Outcome>& outcomes,
                              const std::optional<OnSecondMesh>& second) {
  reports::Table table{"What is known and what came out",
                       "The slide",
                       "Shown beside; gates on it stand among the verdicts. " + doubt(second),
                       {"quantity", "measured", "published simulation", "here"},
                       {}};
  if (second) table.header.insert(table.header.end(), {second->cells, apart});
  table.header.insert(table.header.end(), {"in words", "remark"});
  for (const Observation& known : scene.observations) {
    const Outcome* found = find_outcome(outcomes, known.quantity);
    const Outcome* other = second ? find_outcome(second->outcomes, known.quantity) : nullptr;
    std::vector<std::string> row = {found ? found->description : known.quantity,
                                    known.measured.empty() ? "-" : known.measured,
                                    known.simulated.empty() ? "-" : known.simulated, number(found)};
    if (second) row.insert(row.end(), {number(other), difference_of_meshes(found, other)});
    row.insert(row.end(), {in_a_sentence(known, found, other), known.remark});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace wetfront::verification
