#include "verification/scene/known_value.h"

#include "verification/scene/units.h"

#include <algorithm>
#include <variant>

namespace wetfront::verification {
namespace {

std::optional<double> quantity_in(const std::string& text, const std::string& unit) {
  const auto read = read_quantity(text, unit);
  if (const double* value = std::get_if<double>(&read)) return *value;
  return {};
}

}  // namespace

const char* unit_of_known(const std::string& quantity) {
  if (quantity == "largest_displacement") return "m";
  return quantity == "largest_velocity" || quantity.starts_with("rise_rate:") ? "m/s" : "s";
}

std::optional<Band> number_in_words(const std::string& said, const std::string& unit) {
  const std::string about = "about ", between = " to ";
  const std::string text = said.starts_with(about) ? said.substr(about.size()) : said;
  const auto to = text.find(between);
  const auto last = quantity_in(to == std::string::npos ? text : text.substr(to + between.size()), unit);
  if (!last) return {};
  Band band{*last, *last};
  if (to != std::string::npos) {
    // The first number mostly leaves the unit to the second: "3 to 3.7 m".
    const std::string from = text.substr(0, to);
    const auto blank = text.find_last_of(' ');
    const bool bare = from.find_first_not_of("0123456789.+-eE") == std::string::npos;
    const auto first = quantity_in(bare ? from + text.substr(blank) : from, unit);
    if (!first) return {};
    band.low = *first;
  }
  if (!(band.low > 0 && band.low <= band.high)) return {};
  return band;
}

std::optional<Band> known_value(const Observation& known, Source source) {
  return number_in_words(source == Source::measured ? known.measured : known.simulated, unit_of_known(known.quantity));
}

std::optional<Band> known_value(const Scene& scene, const std::string& quantity, Source source) {
  const auto known = std::ranges::find(scene.observations, quantity, &Observation::quantity);
  if (known == scene.observations.end()) return {};
  return known_value(*known, source);
}

double relative_distance(double value, const Band& known) {
  if (value < known.low) return (known.low - value) / known.low;
  return value > known.high ? (value - known.high) / known.high : 0 * value;
}

}  // namespace wetfront::verification
