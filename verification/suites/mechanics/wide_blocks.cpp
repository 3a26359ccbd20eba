#include "verification/exact/soil_strength.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/cpu_time.h"
#include "verification/suites/mechanics/families.h"
#include "verification/suites/mechanics/lagrangian_block.h"
#include "verification/suites/mechanics/motion_book.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double length = 2;

/// Farthest that a settled block goes from its place, over its length, in 3 s.
void rests(double friction, bool turned, MotionBook& book) {
  const InclineBlock block{.friction = friction, .turned_mesh = turned, .end = 3, .length = length, .settled = true};
  const std::string label = fmt::format("mu = {:g}, settled{}", friction, turned ? ", mesh turned" : "");
  book.energy = {0.05, "1", "it stands: what is exchanged is the little by which it settles anew (measured .024)"};
  book.energy_made = book.energy;
  const auto path = block_path(book.move<2>(label, block_problem<2>(block)), block);
  double farthest = 0;
  for (const BlockState& state : path)
    farthest = std::max(farthest, std::hypot(state.place[0] - path[0].place[0], state.place[1] - path[0].place[1]));
  book.page.judge("rest", fmt::format("way of a block that rests, over its length, {}", label), farthest / length,
                  {1e-3, "1", "what the relaxation leaves out of balance (2e-4) swings by 1e-5"});
}

struct Travel {
  double along, climbed;  ///< at the end; the mean of the second half
};
Travel travel(const std::vector<BlockState>& path, const std::array<double, 2>& start) {
  Travel out{path.back().place[0] - start[0], 0};
  const std::size_t half = path.size() / 2;
  for (std::size_t k = half; k < path.size(); ++k)
    out.climbed += (path[k].place[1] - start[1]) / static_cast<double>(path.size() - half);
  return out;
}
/// By material points and by the Lagrangian mesh, shaken at the start: the stress at rest does not know the slope.
struct Pair {
  Travel points, mesh;
};
Pair both(const InclineBlock& block, MotionBook& book, reports::Figure* figure, int colour) {
  auto problem = block_problem<2>(block);
  problem.output_times.insert(problem.output_times.begin(), 0);
  book.energy = {0.15, "1", "undamped it hops: where it lands contact stops nodes, points follow (measured .11)"};
  book.energy_made.reset();
  const auto motion = book.move<2>(fmt::format("mu = {:g}, cells of {:g} m", block.friction, block.cell), problem);
  const auto path = block_path(motion, block);
  const CpuTime clock;
  const auto other = lagrangian_block_path(block, problem.output_times);
  book.page.spend(clock.seconds());
  if (figure != nullptr) {
    auto dots = points(fmt::format("material points, mu = {:g}", block.friction), colour),
         solid = line(fmt::format("Lagrangian mesh, mu = {:g}", block.friction), colour);
    for (const BlockState& s : path) put(dots, s.time, s.place[0] - path[0].place[0]);
    for (const BlockState& s : other) put(solid, s.time, s.place[0]);
    figure->series.push_back(solid);
    figure->series.push_back(dots);
  }
  return {travel(path, path[0].place), travel(other, {0, 0})};
}

void slides(MotionBook& book) {
  reports::Table table{
      "Way along the slope after 1.5 s [m]",
      "Shaken",
      "An elastic block whose friction follows its reaction rocks and hops (flutter, Adams 1995) and goes "
      "farther than a rigid one, by material points and by finite elements alike.",
      {"mu", "rigid", "points, 4 cells high", "8 cells", "finite elements, 4 high", "8 high"},
      {}};
  auto figure = figure_frame({"way", "Way along the slope", "Time series"}, {"time", "s"}, {"way", "m"});
  int colour = 0;
  for (const double friction : {0.2, 0.36, 0.5, 0.6}) {
    InclineBlock block{.friction = friction, .turned_mesh = true, .end = 1.5, .length = length};
    const double a = exact::sliding_acceleration(InclineBlock::slope, friction, InclineBlock::gravity),
                 rigid = 0.5 * std::max(a, 0.0) * block.end * block.end;
    const Pair coarse = both(block, book, &figure, colour++);
    block.cell = 0.125;
    const Pair fine = both(block, book, nullptr, 0);
    table.rows.push_back({fmt::format("{:g}", friction), fmt::format("{:.3f}", rigid),
                          fmt::format("{:.3f}", coarse.points.along), fmt::format("{:.3f}", fine.points.along),
                          fmt::format("{:.3f}", coarse.mesh.along), fmt::format("{:.3f}", fine.mesh.along)});
    if (friction < 0.3)
      book.page.expect("error", fmt::format("way along the slope, mu = {:g} [m]", friction), coarse.points.along, rigid,
                       {0.01, "1", "the issue's; it hardly rocks"});
    else if (friction < 0.4)
      book.page.expect("error", fmt::format("way against that of the finite elements, mu = {:g} [m]", friction),
                       coarse.points.along, coarse.mesh.along,
                       {0.05, "1", "it rocks, and impacts differ; the rigid block is off by as much"});
    book.page.judge("climb", fmt::format("mean rise over the second half, over a cell, mu = {:g}", friction),
                    coarse.points.climbed / 0.25,
                    {0.1, "1",
                     "hops are .04, and points are held .04 above where they were seeded; a body that is not "
                     "let down to its base climbs by half a cell and more"});
  }
  book.page.tabulate(table);
  book.page.draw(figure);
}

}  // namespace

std::vector<Case> wide_block_cases() {
  return {motion_case({"incline_wide",
                       "M2 Wide block on an incline",
                       "It rests where friction holds it, slides by Coulomb's law, and comes down when it has hopped.",
                       "benchmarks.md section 6; Adams 1995 (self-excited oscillations with constant friction).",
                       Effort::everyday,
                       {}},
                      [](MotionBook& book) {
                        rests(0.6, false, book);
                        rests(0.6, true, book);
                        rests(0.8, false, book);
                        slides(book);
                      })};
}

}  // namespace wetfront::verification
