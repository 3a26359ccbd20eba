#include "reports/film.h"

#include "reports/base64.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wetfront::reports {

namespace {

constexpr std::size_t most_moments = 150;

void check(const Film& film, const std::vector<FilmMoment>& moments) {
  const auto wrong = [&](const std::string& why) {
    throw std::invalid_argument("film '" + film.id + "': " + why + " (a film has the same points at every time)");
  };
  for (const FilmMoment& moment : moments) {
    if (moment.x.size() != moments.front().x.size() || moment.y.size() != moment.x.size())
      wrong("the number of points changes");
    if (moment.values.size() != film.channels.size()) wrong("a quantity is missing");
    for (const auto& values : moment.values)
      if (values.size() != moment.x.size()) wrong("a point has no value");
  }
}

/// At most `most` of them, first, last and labelled ones always.
std::vector<FilmMoment> thinned(std::vector<FilmMoment> moments, std::size_t most) {
  if (moments.size() <= most) return moments;
  const std::size_t stride = (moments.size() + most - 1) / most;
  std::vector<FilmMoment> kept;
  for (std::size_t k = 0; k < moments.size(); ++k)
    if (k % stride == 0 || k + 1 == moments.size() || !moments[k].label.empty()) kept.push_back(std::move(moments[k]));
  return kept;
}

const std::vector<double>& channel_of(const FilmMoment& moment, std::size_t channel) {
  return channel == 0 ? moment.x : channel == 1 ? moment.y : moment.values[channel - 2];
}

void set_range(Film::Channel& channel, const std::vector<FilmMoment>& moments, std::size_t index) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const FilmMoment& moment : moments)
    for (const double value : channel_of(moment, index))
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (low > high) low = 0, high = 1;
  channel.from = low;
  channel.to = high > low ? high : low + std::max(1e-9, 1e-6 * std::abs(low));
}

}  // namespace

Film make_film(Film heading, std::vector<FilmMoment> moments, std::size_t words) {
  check(heading, moments);
  heading.channels.insert(heading.channels.begin(), {{"x", "m"}, {"y", "m"}});
  moments = thinned(std::move(moments), most_moments);
  const std::size_t count = moments.empty() ? 0 : moments.front().x.size();
  const std::size_t per_point = std::max<std::size_t>(1, moments.size() * heading.channels.size());
  const auto points = spread_evenly(count, words / per_point);
  heading.points_of_run = static_cast<int>(count);
  heading.points = static_cast<int>(points.size());
  for (std::size_t c = 0; c < heading.channels.size(); ++c) set_range(heading.channels[c], moments, c);
  heading.values.reserve(points.size() * per_point);
  for (const FilmMoment& moment : moments) {
    heading.frames.push_back({moment.time, moment.label});
    for (std::size_t c = 0; c < heading.channels.size(); ++c) {
      const auto& [name, unit, from, to] = heading.channels[c];
      for (const std::size_t p : points) {
        const double share = (channel_of(moment, c)[p] - from) / (to - from);
        heading.values.push_back(static_cast<std::uint16_t>(std::isfinite(share) ? std::lround(65535 * share) : 0));
      }
    }
  }
  return heading;
}

double film_value(const Film& film, std::size_t frame, std::size_t channel, std::size_t point) {
  const auto& [name, unit, from, to] = film.channels.at(channel);
  const auto points = static_cast<std::size_t>(film.points);
  return from + film.values.at((frame * film.channels.size() + channel) * points + point) / 65535.0 * (to - from);
}

std::vector<std::size_t> spread_evenly(std::size_t count, std::size_t most) {
  const double share = static_cast<double>(most) / static_cast<double>(std::max<std::size_t>(count, 1));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) {  // multiples of the golden ratio modulo 1 leave no stripes
    double whole = 0;
    if (std::modf(static_cast<double>(i) * 0.6180339887498949, &whole) < share) chosen.push_back(i);
  }
  return chosen;
}

std::string words_text(const std::vector<std::uint16_t>& words) {
  std::vector<unsigned char> bytes;
  bytes.reserve(2 * words.size());
  for (const std::uint16_t word : words) {
    bytes.push_back(static_cast<unsigned char>(word & 255));
    bytes.push_back(static_cast<unsigned char>(word >> 8));
  }
  return base64(bytes);
}

std::vector<std::uint16_t> words_from(const std::string& text) {
  const std::vector<unsigned char> bytes = from_base64(text);
  if (bytes.size() % 2 != 0) throw std::runtime_error("half a word is left over");
  std::vector<std::uint16_t> words(bytes.size() / 2);
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i] = static_cast<std::uint16_t>(bytes[2 * i] | bytes[2 * i + 1] << 8);
  return words;
}

}  // namespace wetfront::reports
