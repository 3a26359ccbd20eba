#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::verification {

struct FigureHeading {
  std::string id, title, section;
};
struct FigureAxis {
  std::string label, unit;
};

/// A figure without series.
inline reports::Figure figure_frame(const FigureHeading& heading, const FigureAxis& x, const FigureAxis& y) {
  reports::Figure figure;
  figure.id = heading.id;
  figure.title = heading.title;
  figure.section = heading.section;
  figure.x_label = x.label;
  figure.x_unit = x.unit;
  figure.y_label = y.label;
  figure.y_unit = y.unit;
  return figure;
}

}  // namespace wetfront::verification
