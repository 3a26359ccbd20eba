#include "reports/film_page.h"

#include "reports/colour_bands.h"
#include "reports/escape.h"
#include "reports/figure_files.h"
#include "reports/film.h"
#include "reports/number_text.h"
#include "reports/panel_row.h"
#include "reports/plane_drawing.h"
#include "reports/whole_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace wetfront::reports {

namespace {

using Json = nlohmann::ordered_json;

constexpr double still_width = 380, player_width = 900;
constexpr std::size_t points_of_still = 4000;
constexpr std::size_t first_quantity = 2;

Extent extent_of(const Film& film) {
  Extent extent{film.channels[0].from, film.channels[0].to, film.channels[1].from, film.channels[1].to};
  for (const Series& line : film.ground)
    for (std::size_t i = 0; i < line.x.size(); ++i) extent.include(line.x[i], line.y[i]);
  return extent;
}

ColourBands bands_of(const Film::Channel& channel) {
  return colour_bands(channel.from, channel.to, false);
}

/// The distance of neighbours in the first frame [m]: of the area that has points in it, each one's share.
double spacing(const Film& film) {
  const auto count = static_cast<std::size_t>(film.points);
  if (count == 0) return 0;
  const Extent box{film.channels[0].from, film.channels[0].to, film.channels[1].from, film.channels[1].to};
  const double side = std::sqrt(4 * (box.right - box.left) * (box.top - box.bottom) / static_cast<double>(count));
  std::set<std::pair<long, long>> filled;
  for (std::size_t p = 0; p < count; ++p)
    filled.insert({std::lround(film_value(film, 0, 0, p) / side), std::lround(film_value(film, 0, 1, p) / side)});
  return side * std::sqrt(static_cast<double>(filled.size()) / static_cast<double>(count));
}

std::string ground(const Film& film, const PlaneDrawing& plane) {
  std::string out;
  for (const Series& line : film.ground) {
    std::string path;
    char pen = 'M';
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      if (!std::isfinite(line.x[i]) || !std::isfinite(line.y[i])) {
        pen = 'M';
        continue;
      }
      path += pen;
      path += std::to_string(plane.x(line.x[i])) + " " + std::to_string(plane.y(line.y[i]));
      pen = 'L';
    }
    out += "<path d=\"" + path + "\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"10\"" +
           (line.style == Series::Style::dashed ? " stroke-dasharray=\"60 40\"" : "") + "/>";
  }
  return out;
}

/// The points that still frames show, and how thick [tenths of a pixel].
struct Dots {
  std::vector<std::size_t> shown;
  double thick;
};

Dots dots_of(const Film& film, const PlaneDrawing& plane) {
  const auto shown = spread_evenly(static_cast<std::size_t>(film.points), points_of_still);
  const double thinner = std::sqrt(static_cast<double>(film.points) / std::max(1.0, static_cast<double>(shown.size())));
  return {shown, std::clamp(1.1 * spacing(film) * thinner * plane.scale(), 8.0, 80.0)};
}

/// One path per band.
std::string drawn(const Dots& dots, const Film& film, std::size_t frame, const PlaneDrawing& plane,
                  const ColourBands& bands) {
  std::vector<std::string> paths(bands.colours.size());
  for (const std::size_t p : dots.shown) {
    std::string& path = paths[bands.band_of(film_value(film, frame, first_quantity, p))];
    path += 'M';
    path += std::to_string(plane.x(film_value(film, frame, 0, p))) + " ";
    path += std::to_string(plane.y(film_value(film, frame, 1, p))) + "h0";
  }
  std::ostringstream out;
  out << "<g stroke-linecap=\"round\" fill=\"none\" stroke-width=\"" << std::lround(dots.thick) << "\">";
  for (std::size_t band = 0; band < paths.size(); ++band)
    if (!paths[band].empty()) out << "<path stroke=\"" << bands.colours[band] << "\" d=\"" << paths[band] << "\"/>\n";
  out << "</g>";
  return out.str();
}

std::string when(const Film::Frame& frame) {
  return (frame.label.empty() ? "" : frame.label + ", ") + number_text(frame.time, 5) + "\u00a0s";
}

/// The first frame, the last, and between them that of failure or the one in the middle.
std::vector<std::size_t> still_frames(const Film& film) {
  std::set<std::size_t> chosen = {0, film.frames.size() - 1};
  std::size_t between = film.frames.size() / 2;
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    if (film.frames[k].label == "failure") between = k;
  chosen.insert(between);
  for (std::size_t k = 1; chosen.size() < 3 && k < film.frames.size(); ++k) chosen.insert(k);
  return {chosen.begin(), chosen.end()};
}

std::vector<RowPanel> stills(const Film& film, double pressure_per_head) {
  const PlaneDrawing plane(extent_of(film), still_width);
  const Film::Channel& shown = film.channels[first_quantity];
  const ColourBands bands = bands_of(shown);
  const Dots dots = dots_of(film, plane);
  std::vector<RowPanel> panels;
  for (const std::size_t frame : still_frames(film))
    panels.push_back({when(film.frames[frame]),
                      plane.open(film.title + ": " + when(film.frames[frame])) +
                          drawn(dots, film, frame, plane, bands) + ground(film, plane) + plane.frame() + "</svg>",
                      legend_svg(bands, {shown.name, shown.unit, pressure_per_head}, still_width)});
  return panels;
}

/// What the script needs: where metres lie in the drawing, the bands of every quantity, the numbers.
std::string film_data(const Film& film, const PlaneDrawing& plane) {
  Json data = {{"points", film.points},
               {"place", {plane.x0(), plane.y0(), plane.scale()}},
               {"size", {plane.width(), std::lround(plane.height())}},
               {"dot", 0.95 * spacing(film) * plane.scale()},
               {"channels", Json::array()},
               {"frames", Json::array()}};
  for (std::size_t c = 0; c < film.channels.size(); ++c) {
    const Film::Channel& channel = film.channels[c];
    Json entry = {{"name", channel.name}, {"unit", channel.unit}, {"from", channel.from}, {"to", channel.to}};
    if (c >= first_quantity) {
      const ColourBands bands = bands_of(channel);
      entry["limits"] = bands.limits;
      entry["colours"] = bands.colours;
    }
    data["channels"].push_back(entry);
  }
  for (const Film::Frame& frame : film.frames) data["frames"].push_back(when(frame));
  return script_json(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool can_be_shown(const Film& film) {
  return !film.frames.empty() && film.points > 0 && film.channels.size() > first_quantity;
}

/// The points of the still frames: a point a line, all quantities.
std::string stills_csv(const Film& film) {
  std::string csv = "time [s]";
  for (const Film::Channel& channel : film.channels) csv += "," + csv_cell(channel.name + " [" + channel.unit + "]");
  csv += "\n";
  const auto shown = spread_evenly(static_cast<std::size_t>(film.points), points_of_still);
  for (const std::size_t frame : still_frames(film))
    for (const std::size_t p : shown) {
      csv += exact_text(film.frames[frame].time);
      for (std::size_t c = 0; c < film.channels.size(); ++c) csv += "," + number_text(film_value(film, frame, c, p), 6);
      csv += "\n";
    }
  return csv;
}

}  // namespace

void write_stills(const Film& film, const std::filesystem::path& folder) {
  if (!can_be_shown(film)) return;
  make_folder(folder);
  write_whole(folder / (film.id + "_stills.csv"), stills_csv(film));
  write_whole(folder / (film.id + "_stills.svg"),
              in_a_row(stills(film, 0), still_width, PlaneDrawing(extent_of(film), still_width).height() / 10));
}

std::string film_html(const Film& film, double pressure_per_head) {
  if (!can_be_shown(film)) return "";
  const PlaneDrawing plane(extent_of(film), player_width);
  std::ostringstream out;
  out << "<figure class=\"film\" id=\"film-" << html(film.id) << "\"><figcaption><b>" << html(film.title) << "</b> "
      << html(film.caption)
      << (film.points < film.points_of_run
              ? " " + std::to_string(film.points) + " of " + std::to_string(film.points_of_run) + " points."
              : "")
      << "</figcaption><div class=\"panels stills\">";
  for (const RowPanel& still : stills(film, pressure_per_head))
    out << "<div class=\"panel\"><p>" << html(still.label) << "</p>" << still.drawing << still.legend << "</div>\n";
  out << "</div>" << figure_files(film.id + "_stills", {{"CSV", ".csv"}, {"SVG", ".svg"}})
      << "<div class=\"player\" hidden style=\"max-width:" << number_text(34 * plane.width() / plane.height())
      << "rem\"><div class=\"stage\">" << plane.open(film.title) << ground(film, plane) << plane.frame()
      << "</svg></div>";
  for (std::size_t c = first_quantity; c < film.channels.size(); ++c)
    out << "<div class=\"scale\" data-channel=\"" << c << "\">"
        << legend_svg(bands_of(film.channels[c]), {film.channels[c].name, film.channels[c].unit, pressure_per_head},
                      player_width / 2)
        << "</div>";
  out << "</div><script type=\"application/json\" class=\"film-data\">" << film_data(film, plane)
      << "</script><script type=\"text/plain\" class=\"film-values\">" << words_text(film.values)
      << "</script></figure>\n";
  return out.str();
}

}  // namespace wetfront::reports
