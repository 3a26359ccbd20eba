#include "reports/figure_data.h"

#include "reports/csv.h"
#include "reports/escape.h"
#include "reports/figure_script.h"
#include "reports/palette.h"
#include "reports/picture_json.h"
#include "reports/thinned.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace wetfront::reports {

namespace {

using Json = nlohmann::ordered_json;

Json rounded(const std::vector<double>& values) {
  Json array = Json::array();
  for (const double value : values) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.7g", value);
    array.push_back(std::isfinite(value) ? Json(std::strtod(buffer, nullptr)) : Json(nullptr));
  }
  return array;
}

Json axis_data(const Axis& axis, const std::string& label, const std::string& unit) {
  return {{"from", axis.from}, {"to", axis.to}, {"log", axis.log}, {"label", label}, {"unit", unit == "1" ? "" : unit}};
}

}  // namespace

std::string figure_data(const Figure& figure, const FigureAxes& axes) {
  const FigureLayout layout = lay_out(figure);
  const std::vector<int> indices = palette_indices(figure);
  Json data;
  data["box"] = {FigureLayout::left, layout.top, layout.right(), layout.bottom()};
  data["x"] = axis_data(axes.x, figure.x_label, figure.x_unit);
  data["y"] = axis_data(axes.y, figure.y_label, figure.y_unit);
  data["series"] = Json::array();
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const Series series = thinned(figure.series[s]);
    data["series"].push_back({{"label", series.label},
                              {"style", style_key(series.style)},
                              {"colour", colour_of(indices[s])},
                              {"mark", "#" + figure.id + "_gpPt" + std::to_string(mark_of(indices[s]) - 1)},
                              {"x", rounded(series.x)},
                              {"y", rounded(series.y)}});
  }
  return script_json(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace wetfront::reports
