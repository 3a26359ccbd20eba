#include "reports/axes.h"
#include "reports/csv.h"
#include "reports/escape.h"
#include "reports/figure_data.h"
#include "reports/figure_script.h"
#include "reports/number_text.h"
#include "reports/palette.h"
#include "reports/thinned.h"
#include "reports/tolerance_bar.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wetfront::reports {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Escape, HtmlIsSafeAndKeepsUmlauts) {
  EXPECT_EQ(html("Säule <b> & \"x\" 'y'"), "Säule &lt;b&gt; &amp; &quot;x&quot; &#39;y&#39;");
  EXPECT_EQ(html("a\x01z\n"), "az\n");
  EXPECT_EQ(html("\xff|\xc3|\xe2\x82|\xed\xa0\x80"), "\uFFFD|\uFFFD|\uFFFD\uFFFD|\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(html("\U0001F327"), "\U0001F327");
}

TEST(Escape, GnuplotCannotBeTalkedInto) {
  EXPECT_EQ(gnuplot_string("it's `ls`\nnext"), "'it''s `ls` next'");
}

TEST(Escape, CsvAndUrl) {
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(url_path("../a b/ü&.html"), "../a%20b/%C3%BC%26.html");
}

TEST(Escape, WrapsByCharactersNotBytes) {
  EXPECT_EQ(wrap("üü üü üü", 5), "üü üü\nüü");
}

TEST(NumberText, ReadsWell) {
  EXPECT_EQ(number_text(1772), "1772");
  EXPECT_EQ(number_text(0.00999999), "0.01");
  EXPECT_EQ(number_text(99999), "99999");
  EXPECT_EQ(number_text(123456), "1.23\u202f×\u202f10⁵");
  EXPECT_EQ(number_text(99.96), "100");
  EXPECT_EQ(number_text(-3.14e-9), "−3.14\u202f×\u202f10⁻⁹");
  EXPECT_EQ(number_text(std::nan("")), "NaN");
  EXPECT_EQ(quantity_text(8.3e-4, "1"), "0.083\u00a0%");
  EXPECT_EQ(quantity_text(1e-8, "1"), "10⁻⁸");
  EXPECT_EQ(quantity_text(0.412, "kPa"), "0.412\u00a0kPa");
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(duration_text(323), "5\u00a0min 23\u00a0s");
}

TEST(Csv, EveryHeaderHasAUnit) {
  for (const Figure& figure : testing::sample_record().figures) {
    std::istringstream lines(figure_csv(figure));
    std::string header;
    std::getline(lines, header);
    std::size_t units = 0;
    for (const char c : header) units += c == ']';
    EXPECT_EQ(units, 2 * figure.series.size()) << header;
  }
}

TEST(Csv, SeriesOfDifferentLengthAndGaps) {
  Figure figure;
  figure.x_label = "time";
  figure.x_unit = "s";
  figure.y_label = "saturation";
  figure.y_unit = "1";
  figure.series = {{"reference, z = 1 m", Series::Style::line, {0, 1}, {0.1, std::nan("")}, 0},
                   {"MPM", Series::Style::points, {0.5}, {1e-300}, 0}};
  EXPECT_EQ(
      figure_csv(figure),
      "\"reference, z = 1 m: time [s]\",\"reference, z = 1 m: saturation [-]\",MPM: time [s],MPM: saturation [-]\n"
      "0,0.1,0.5,1e-300\n1,nan,,\n");
}

TEST(Axes, EndsAreRoundAndTicksInside) {
  const Axis axis = round_axis(-9.97, -2.8, false);
  EXPECT_DOUBLE_EQ(axis.from, -10);
  EXPECT_DOUBLE_EQ(axis.to, -2.5);
  EXPECT_EQ(axis.ticks.front().label, "−10");
  const Axis logarithmic = round_axis(3e-5, 0.4, true);
  EXPECT_DOUBLE_EQ(logarithmic.from, 2e-5);
  EXPECT_DOUBLE_EQ(logarithmic.to, 0.5);
  const Axis flat = round_axis(3, 3, false);
  EXPECT_LT(flat.from, 3);
  EXPECT_GT(flat.to, 3);
}

TEST(Axes, ComparablePanelsShareTheirScale) {
  const auto figures = testing::sample_record().figures;
  const auto axes = choose_axes(figures);
  // Both profile figures have the elevation along y, both time series the time along x.
  EXPECT_EQ(axes[0].y.from, axes[1].y.from);
  EXPECT_EQ(axes[0].y.to, axes[1].y.to);
  EXPECT_EQ(axes[2].x.to, axes[3].x.to);
  EXPECT_NE(axes[0].x.to, axes[1].x.to);
}

TEST(Axes, APanelWithSmallValuesKeepsItsOwnScale) {
  std::vector<Figure> figures(2);
  figures[0].series = {{"a", Series::Style::line, {0, 1}, {0, 100}}};
  figures[1].series = {{"b", Series::Style::line, {0, 1}, {0, 1}}};
  const auto axes = choose_axes(figures);
  EXPECT_EQ(axes[1].y.to, 1);
  EXPECT_EQ(axes[1].x.to, axes[0].x.to);
}

TEST(Axes, CountsWhatCannotBeDrawn) {
  Figure figure;
  figure.log_y = true;
  const Series series{"a", Series::Style::line, {0, 1, 2, 3}, {0, -1, std::nan(""), 5}};
  EXPECT_EQ(undrawable_points(figure, series), 3U);
}

TEST(Palette, SeriesWithoutColourTakeFreeOnes) {
  Figure figure;
  figure.series.resize(4);
  figure.series[1].colour = 0;
  figure.series[3].colour = 2;
  EXPECT_THAT(palette_indices(figure), ::testing::ElementsAre(1, 0, 3, 2));
}

TEST(FigureScript, PlotHasOneSizeWhateverTheLegend) {
  Figure small, large;
  large.title = std::string(150, 'x') + " " + std::string(50, 'y');
  large.series.assign(9, Series{std::string(40, 'n'), Series::Style::line, {}, {}});
  EXPECT_EQ(lay_out(small).bottom() - lay_out(small).top, lay_out(large).bottom() - lay_out(large).top);
  EXPECT_GT(lay_out(large).height, lay_out(small).height + 9 * 15);
}

/// A window that begins near the right edge: its label once ran out of the picture ("not compara").
TEST(FigureScript, LabelsOfWindowsStayInThePicture) {
  Figure figure;
  figure.shaded = {{0.9, 1, "after failure: not comparable"}};
  const FigureAxes axes;  // from 0 to 1
  EXPECT_THAT(figure_script(figure, axes),
              ::testing::ContainsRegex("not comparable' at screen 0\\.99[0-9]*,[0-9.]+ right"));
  figure.shaded = {{0.1, 1, "after failure: not comparable"}};
  EXPECT_THAT(figure_script(figure, axes),
              ::testing::ContainsRegex("not comparable' at screen 0\\.2[0-9]*,[0-9.]+ left"));
}

TEST(FigureScript, PointsAreDrawnOverLines) {
  const std::string script = figure_script(testing::sample_record().figures[0], FigureAxes{});
  EXPECT_LT(script.rfind("with lines"), script.find("with points"));
}

TEST(FigureData, CannotEndItsElement) {
  Figure figure;
  figure.series = {{"</script><!-- x", Series::Style::line, {0}, {std::nan("")}}};
  const std::string data = figure_data(figure, FigureAxes{});
  EXPECT_THAT(data, Not(HasSubstr("<")));
  EXPECT_THAT(data, HasSubstr("[null]"));
}

TEST(Thinned, KeepsTheOutlineAndTheGaps) {
  Series series{"a", Series::Style::line, {}, {}, 3};
  for (int i = 0; i < 100000; ++i) {
    series.x.push_back(i);
    series.y.push_back(std::sin(i * 1e-4));
  }
  series.y[54321] = 7;
  series.y[60000] = std::nan("");
  const Series drawn = thinned(series);
  EXPECT_LE(drawn.x.size(), drawn_limit + 2);
  EXPECT_EQ(drawn.x.front(), 0);
  EXPECT_EQ(drawn.x.back(), 99999);
  EXPECT_EQ(std::count(drawn.y.begin(), drawn.y.end(), 7), 1);
  EXPECT_EQ(std::count_if(drawn.y.begin(), drawn.y.end(), [](double y) { return std::isnan(y); }), 1);
  series.x.resize(drawn_limit);
  series.y.resize(drawn_limit);
  EXPECT_EQ(thinned(series).y, series.y);
}

TEST(ToleranceBar, SaysTheShareInWords) {
  const auto findings = testing::sample_record().findings;
  EXPECT_THAT(tolerance_bar(findings[0]), HasSubstr("42\u00a0%"));
  EXPECT_THAT(tolerance_bar(findings[2]), HasSubstr("206\u00a0%"));
  EXPECT_EQ(tolerance_bar(findings[7]), "");
  EXPECT_DOUBLE_EQ(tolerance_share(findings[5]), 0.74);
}

}  // namespace
}  // namespace wetfront::reports
