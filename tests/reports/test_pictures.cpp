#include "reports/base64.h"
#include "reports/colour_bands.h"
#include "reports/field_picture.h"
#include "reports/film.h"
#include "reports/film_page.h"
#include "reports/record_json.h"
#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/reports/sample_pictures.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

namespace wetfront::reports {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Base64, ComesBack) {
  for (std::size_t length = 0; length < 9; ++length) {
    std::vector<unsigned char> bytes;
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(static_cast<unsigned char>(255 - 37 * i));
    EXPECT_EQ(from_base64(base64(bytes)), bytes) << length;
  }
  EXPECT_EQ(base64(std::vector<unsigned char>{'M', 'a'}), "TWE=");  // RFC 4648's kind of example
  EXPECT_THROW(from_base64("TWE"), std::runtime_error);
  EXPECT_THROW(from_base64("TW\"="), std::runtime_error);
  EXPECT_THROW(from_base64("T==="), std::runtime_error);
  EXPECT_THROW(from_base64("TQ==TQ=="), std::runtime_error);
}

TEST(Base64, PartsFollowEachOther) {
  EXPECT_EQ(from_base64_parts("TQ==\n TWE="), (std::vector<unsigned char>{'M', 'M', 'a'}));
}

TEST(ColourBands, LieBetweenRoundLimitsAndHoldTheRange) {
  const ColourBands bands = colour_bands(-9.3, 2.1, false);
  EXPECT_LE(bands.limits.front(), -9.3);
  EXPECT_GE(bands.limits.back(), 2.1);
  EXPECT_EQ(bands.limits.size(), bands.colours.size() + 1);
  EXPECT_GE(bands.colours.size(), 8U);
  EXPECT_LE(bands.colours.size(), 18U);
  EXPECT_EQ(bands.band_of(-1e9), 0U);
  EXPECT_EQ(bands.band_of(1e9), bands.colours.size() - 1);
  for (std::size_t k = 0; k < bands.colours.size(); ++k)
    EXPECT_EQ(bands.band_of(0.5 * (bands.limits[k] + bands.limits[k + 1])), k);
}

TEST(ColourBands, DifferencesAreSymmetricToZero) {
  const ColourBands bands = colour_bands(-0.2, 1.3, true);
  EXPECT_NEAR(bands.limits.front(), -bands.limits.back(), 1e-12);
}

TEST(ColourBands, AFieldThatIsEverywhereTheSameHasAScaleToo) {
  for (const double value : {0.0, 1.0, -3e5}) {
    const ColourBands bands = colour_bands(value, value, false);
    EXPECT_LT(bands.limits.front(), bands.limits.back());
    EXPECT_LT(bands.colours.size(), 40U);
  }
}

using testing::sample_film;
using testing::sample_picture;

/// One panel of the sample.
FieldPicture one_panel() {
  FieldPicture picture = sample_picture();
  picture.panels.resize(1);
  return picture;
}

/// Area that all subpaths of a drawing enclose, in the square units of its coordinates.
double painted_area(const std::string& svg) {
  static const std::regex subpath("M(-?\\d+) (-?\\d+)l([-\\d ]+)z");
  double area = 0;
  for (std::sregex_iterator at(svg.begin(), svg.end(), subpath), end; at != end; ++at) {
    std::istringstream moves((*at)[3].str());
    double x = 0, y = 0, twice = 0;
    for (double dx = 0, dy = 0; moves >> dx >> dy;) {
      twice += x * dy - y * dx;
      x += dx;
      y += dy;
    }
    area += std::abs(twice) / 2;
  }
  return area;
}

TEST(FieldPicture, BandsCoverEveryCellOnce) {
  FieldPicture picture = one_panel();
  const std::string page = picture_html(picture, 0);
  // 6 m x 0.8 m, drawn in 3800 - 540 tenths of a pixel; corners are rounded to one of them: 1e-2 of a cell of 136 x 54.
  const double scale = 3260 / 6.0;
  EXPECT_NEAR(painted_area(page) / (4.8 * scale * scale), 1, 1e-2);
  picture.panels[0].nodal[30] = std::nan("");  // four of 192 cells are left out
  EXPECT_NEAR(painted_area(picture_html(picture, 0)) / (4.8 * scale * scale), 188.0 / 192, 1e-2);
}

TEST(FieldPicture, LegendsTellPressureInMetresToo) {
  EXPECT_THAT(picture_html(sample_picture(), 9.81), HasSubstr("pore pressure as head of water [m]"));
  EXPECT_THAT(picture_html(sample_picture(), 0), Not(HasSubstr("as-head")));
}

TEST(FieldPicture, IsKeptAsDrawingAndNumbers) {
  const TemporaryFolder desk;
  write_picture(sample_picture(), desk.path());
  EXPECT_THAT(read_whole(desk.path() / "pressure_field.svg"), HasSubstr("MPM minus reference"));
  const std::string csv = read_whole(desk.path() / "pressure_field.csv");
  EXPECT_THAT(csv, HasSubstr("x [m],y [m],MPM: pore pressure [kPa],reference: pore pressure [kPa]"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 25 * 9);
}

TEST(FieldPicture, RefusesWhatDoesNotFit) {
  FieldPicture picture = sample_picture();
  picture.cells[0] = 9999;
  EXPECT_THROW(check(picture), std::runtime_error);
  picture = sample_picture();
  picture.panels[1].nodal.pop_back();
  EXPECT_THROW(check(picture), std::runtime_error);
  picture = sample_picture();
  picture.id = "../a";
  EXPECT_THROW(check(picture), std::runtime_error);
}

TEST(Film, KeepsPlacesToAPartIn65535) {
  const Film film = sample_film(600, 12);
  EXPECT_EQ(film.points, 600);
  ASSERT_EQ(film.channels.size(), 4U);
  const double step = (film.channels[0].to - film.channels[0].from) / 65535;
  // Point 0 of the block starts at (0, 3) and moves 0.8 m along the slope.
  EXPECT_NEAR(film_value(film, 0, 0, 0), 0, step);
  EXPECT_NEAR(film_value(film, 11, 0, 0), 0.8 * std::cos(0.5), step);
  EXPECT_NEAR(film_value(film, 11, 2, 0), 0.8, (film.channels[2].to - film.channels[2].from) / 65535);
  EXPECT_EQ(film.frames[3].label, "failure");
  EXPECT_EQ(film.frames[11].label, "rest");
}

TEST(Film, IsThinnedToItsBudget) {
  const Film film = sample_film(100000, 60);
  EXPECT_EQ(film.points_of_run, 100000);
  EXPECT_NEAR(film.points, 3e6 / (60 * 4), 5);
  EXPECT_LT(film.values.size(), 3'010'000U);
  EXPECT_EQ(film.frames.size(), 60U);
}

TEST(Film, ComesBackFromItsFile) {
  Record record = testing::sample_record();
  const Record back = from_json(to_json(record));
  ASSERT_EQ(back.films.size(), 1U);
  EXPECT_EQ(back.films[0].values, record.films[0].values);
  EXPECT_EQ(back.films[0].channels[3].to, record.films[0].channels[3].to);
  ASSERT_EQ(back.pictures.size(), 1U);
  EXPECT_EQ(back.pictures[0].panels[2].nodal, record.pictures[0].panels[2].nodal);
  EXPECT_EQ(to_json(back), to_json(record));
}

TEST(Film, RefusesPointsThatComeAndGo) {
  Film heading;
  heading.channels = {{"displacement", "m"}};
  const FilmMoment two{0, "", {0, 1}, {0, 1}, {{0, 0}}}, one{1, "", {0}, {0}, {{0}}};
  EXPECT_THROW(make_film(heading, {two, one}), std::invalid_argument);
}

TEST(Film, HasThreeStillFrames) {
  const std::string page = film_html(sample_film(600, 12), 9.81);
  EXPECT_THAT(page, HasSubstr("<p>0\u00a0s</p>"));
  EXPECT_THAT(page, HasSubstr("<p>failure, 2.7273\u00a0s</p>"));
  EXPECT_THAT(page, HasSubstr("<p>rest, 10\u00a0s</p>"));
}

}  // namespace
}  // namespace wetfront::reports
