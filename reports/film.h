#pragma once

#include "reports/record.h"

#include <string>
#include <vector>

namespace wetfront::reports {

/// All points at one time, in the order they have at every other.
struct FilmMoment {
  double time = 0;    ///< s
  std::string label;  ///< "failure", "rest", or ""
  std::vector<double> x, y;
  std::vector<std::vector<double>> values;  ///< per quantity: one number per point
};

/// A film of points. `heading` tells everything but frames, points and ranges; its channels are the quantities, to
/// which x and y are added. Of more than `words` numbers as many points are left out, spread evenly, as need be; at
/// most 150 moments stay, labelled ones all. Positions keep 1/65535 of the film's extent. Throws std::invalid_argument
/// when moments differ in their number of points or quantities.
Film make_film(Film heading, std::vector<FilmMoment> moments, std::size_t words = 3'000'000);

/// One point's value in a frame, in the channel's unit.
double film_value(const Film& film, std::size_t frame, std::size_t channel, std::size_t point);

/// About `most` of `count` indices, ascending, spread evenly whatever the order of what they count; all if they are
/// few.
std::vector<std::size_t> spread_evenly(std::size_t count, std::size_t most);

/// The words as base64 of little-endian bytes, and back.
std::string words_text(const std::vector<std::uint16_t>& words);
std::vector<std::uint16_t> words_from(const std::string& text);

}  // namespace wetfront::reports
