// A small scene for valgrind to count the instructions of: instructions_test.py. Prints the steps it took.
#include "tests/mpm/sheared_sand.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <cstdio>
#include <map>

namespace {

using namespace wetfront::mpm;

using Scene = Problem<2> (*)();

/// Each is made when it is asked for: what makes a wet scene is not to be counted in a dry one.
const std::map<std::string, Scene>& scenes() {
  static const std::map<std::string, Scene> known = {
      {"dry", [] { return test::sheared_sand(256, 4, 1); }},
      {"seepage", [] { return test::seed_column(8, 0.87, 3e-5, 100); }},
      {"seepage_deforming", [] { return test::with_elastic_skeleton(test::seed_column(8, 0.87, 3e-5, 100)); }},
      {"two_velocity_rigid", [] { return test::at_rest(8, 1); }},
      {"two_velocity_deforming", [] { return test::with_elastic_skeleton(test::at_rest(8, 1)); }}};
  return known;
}

}  // namespace

int main(int count, char** words) {
  const auto scene = scenes().find(count == 2 ? words[1] : "");
  if (scene == scenes().end()) {
    std::fputs("usage: mpm_instructions", stderr);
    for (const auto& [name, make] : scenes()) std::fprintf(stderr, " | %s", name.c_str());
    std::fputs("\n", stderr);
    return 2;
  }
  Simulation<2> simulation(scene->second());
  int steps = 0;
  for (; steps < 200 && !simulation.finished(); ++steps) simulation.step();
  std::printf("%d\n", steps);
}
