#include "verification/scene/keys.h"

/// The table: top of the file, geometry, layers, zones, parts of sides, water.
namespace wetfront::verification {

// Ranges are wide on purpose: they catch slips of a unit or an exponent, not unusual ground.
// clang-format off
std::vector<Key> ground_keys() {
  constexpr auto required = Presence::required;
  constexpr auto optional = Presence::optional;
  const std::vector<TableColumn> line = {{"x", "m"}, {"y", "m"}};
  return {
    {"", "title", Takes::text, "", required, "", "one line for the head of the report", "Seed column"},
    {"", "requirement", Takes::text, "", optional, "", "the sentence that the scene is there to show", "The MPM follows the wetting front."},
    {"", "gravity", Takes::vector, "m/s2", optional, "0 m/s2, -9.81 m/s2", "acceleration of gravity, y up (z up in a box of three sizes, where nothing need be said); zeros: none",
     R"(["0 m/s2", "-9.81 m/s2"])", {"-1000 m/s2", "1000 m/s2"}},

    {"geometry", "column", Takes::table, "", optional, "", "a column with sides top, base, left, right", R"({ height = "1.2 m", cells = 40 })"},
    {"geometry", "slope", Takes::table, "", optional, "", "an inclined layer that rises to the right, with the same sides",
     R"({ length = "20 m", thickness = "1.2 m", angle = "30 deg", cells_along = 80, cells_over = 10 })"},
    {"geometry", "profile", Takes::table, "", optional, "", "ground between a surface and a bedrock line, with the same sides; verticals left and right",
     R"({ surface = [["0 m", "4 m"], ["10 m", "6 m"]], bedrock = [["0 m", "0 m"], ["10 m", "1 m"]], cells_along = 80, cells_over = 20 })"},
    {"geometry", "box", Takes::table, "", optional, "", "a rectangle with the same sides; with three sizes a box in space with front (y = 0) and back too, z up, which only the reference can solve",
     R"({ size = ["5 m", "3 m"], cells = [50, 30] })"},
    {"geometry", "mesh", Takes::path, "", optional, "", "your own gmsh mesh, sides and regions as physical groups", "ground.msh"},
    {"geometry.column", "height", Takes::quantity, "m", required, "", "height", "1.2 m", {"1 mm", "10 km"}},
    {"geometry.column", "cells", Takes::count, "", required, "", "cells over the height, equal but for the boundaries of layers", "40", {"1", "100000"}},
    {"geometry.slope", "length", Takes::quantity, "m", required, "", "horizontal length", "20 m", {"1 mm", "100 km"}},
    {"geometry.slope", "thickness", Takes::quantity, "m", required, "", "vertical thickness", "1.2 m", {"1 mm", "10 km"}},
    {"geometry.slope", "angle", Takes::quantity, "rad", required, "", "inclination", "30 deg", {"0 deg", "80 deg"}},
    {"geometry.slope", "cells_along", Takes::count, "", required, "", "cells along the slope", "80", {"1", "100000"}},
    {"geometry.slope", "cells_over", Takes::count, "", required, "", "cells over the thickness", "10", {"1", "100000"}},
    {"geometry.profile", "surface", Takes::pairs, "", required, "", "the ground surface, straight between its points, x ascending", R"([["0 m", "4 m"], ["10 m", "6 m"]])", {}, {}, "", {}, line},
    {"geometry.profile", "bedrock", Takes::pairs, "", required, "", "the lower end of the ground, over the same x", R"([["0 m", "0 m"], ["10 m", "1 m"]])", {}, {}, "", {}, line},
    {"geometry.profile", "cells_along", Takes::count, "", required, "", "cells from left to right", "80", {"1", "100000"}},
    {"geometry.profile", "cells_over", Takes::count, "", required, "", "cells from bedrock to surface", "20", {"1", "100000"}},
    {"geometry.profile", "room", Takes::quantity, "m", optional, "0 m", "height of empty cells above the surface in the mesh of the points: room for a body to move into", "2.4 m", {"0 m", "10 km"}},
    {"geometry.box", "size", Takes::vector, "m", required, "", "width and height; or width, depth and height", R"(["5 m", "3 m"])", {"1 mm", "100 km"}},
    {"geometry.box", "cells", Takes::counts, "", required, "", "cells in the same directions", "[50, 30]", {"1", "100000"}},

    {"geometry.box", "surface", Takes::pairs, "", optional, "", "soil lies below this line and cells above it are empty, room for a body to run out into; straight between the points, a place given twice is an upright face; full when absent", R"([["0 m", "1 m"], ["1 m", "1 m"], ["1 m", "0 m"], ["4 m", "0 m"]])", {}, {}, "", {}, line},

    {"layer", "soil", Takes::text, "", required, "", "name of its soil", "loam"},
    {"layer", "thickness", Takes::quantity, "m", optional, "", "vertical thickness, the same everywhere", "0.5 m", {"0.1 mm", "10 km", true}},
    {"layer", "bottom", Takes::quantity, "m", optional, "", "its lower boundary is level, at this elevation", "0.7 m", {"-100 km", "100 km"}},
    {"layer", "bottom_line", Takes::pairs, "", optional, "", "its lower boundary is this line", R"([["0 m", "3 m"], ["10 m", "4.5 m"]])", {}, {}, "", {}, line},

    {"zone", "soil", Takes::text, "", required, "", "name of its soil", "clay"},
    {"zone", "x", Takes::range, "m", optional, "", "from, to; the whole width when absent", R"(["1 m", "4 m"])", {"-1000 km", "1000 km"}},
    {"zone", "y", Takes::range, "m", optional, "", "from, to: elevations, or the depth of a box in space", R"(["2 m", "3 m"])", {"-1000 km", "1000 km"}},
    {"zone", "z", Takes::range, "m", optional, "", "from, to: elevations in space", R"(["2 m", "3 m"])", {"-1000 km", "1000 km"}},

    {"part", "name", Takes::text, "", required, "", "name of the part, to be used as a side", "strip"},
    {"part", "of", Takes::text, "", required, "", "the side that it is part of; what is left of that keeps its name", "top"},
    {"part", "x", Takes::range, "m", optional, "", "from, to", R"(["1 m", "4 m"])", {"-1000 km", "1000 km"}},
    {"part", "y", Takes::range, "m", optional, "", "from, to", R"(["0 m", "1 m"])", {"-1000 km", "1000 km"}},
    {"part", "z", Takes::range, "m", optional, "", "from, to", R"(["0 m", "1 m"])", {"-1000 km", "1000 km"}},

    {"water", "density", Takes::quantity, "kg/m3", optional, "1000 kg/m3", "density", "1000 kg/m3", {"100 kg/m3", "20000 kg/m3"}},
    {"water", "bulk_modulus", Takes::quantity, "Pa", optional, "2.2 GPa", "bulk modulus", "2.2 GPa", {"1 kPa", "1000 GPa"}},
    {"water", "viscosity", Takes::quantity, "Pa s", optional, "1e-6 kPa s", "dynamic viscosity", "1e-6 kPa s", {"1e-7 Pa s", "1e3 Pa s"}},
  };
}
// clang-format on

}  // namespace wetfront::verification
