#pragma once

#include "verification/scene/origin.h"

#include <array>
#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

/// What a scene says of the ground: its outline, which soil lies where, what parts of its sides are called.
namespace wetfront::verification {

struct Column {
  double height;  ///< m
  int cells;      ///< over the height
};
/// Inclined layer of constant vertical thickness.
struct Slope {
  double length;     ///< horizontal, m
  double thickness;  ///< vertical, m
  double angle;      ///< rad
  int cells_along, cells_over;
};
struct MeshFile {
  std::filesystem::path path;  ///< user's .msh, sides and regions as named physical groups
};
/// Places along x, ascending, and an elevation at each; straight between them, level beyond.
struct Polyline {
  std::vector<double> x, y;  ///< m
  double at(double position) const;
};
/// A rectangle (two sizes) or a box in space (three), its lower corner at the origin; the last direction is up.
struct Box {
  std::vector<double> size;  ///< m
  std::vector<int> cells;
  /// Soil lies below this line, cells above it are empty; a place given twice is an upright face. Empty: full.
  Polyline surface{};
  int dim() const { return static_cast<int>(size.size()); }
};
/// Ground between two lines.
struct GroundProfile {
  Polyline surface, bedrock;
  int cells_along, cells_over;
  double room = 0;  ///< height of empty cells above the surface, for a body to move in, of the MPM's mesh only [m]
};
using Shape = std::variant<Column, Slope, MeshFile, Box, GroundProfile>;

/// One layer, listed from the surface down. Its lower boundary is `thickness` below that of the layer above, or at one
/// elevation, or a line; the last layer reaches to the base.
struct Layer {
  std::string soil;
  struct ToBase {};
  struct Thickness {
    double value;  ///< vertical, m
  };
  struct Elevation {
    double value;  ///< m
  };
  std::variant<ToBase, Thickness, Elevation, Polyline> bottom;
  Origin origin;
};

/// A range per direction; all of a direction where none was given.
struct Extent {
  static constexpr double everywhere = std::numeric_limits<double>::infinity();
  static constexpr double slack = 1e-9;  ///< m, by which a range is wider than written: gmsh's nodes are 1e-12 m off
  std::array<double, 3> from{-everywhere, -everywhere, -everywhere}, to{everywhere, everywhere, everywhere};
  bool contains(const std::array<double, 3>& point) const;
};
/// A rectangle or box of another soil; a later one lies over an earlier one, and all of them over the layers.
struct Zone {
  std::string soil;
  Extent extent;
  Origin origin;
};
/// The part of a side that lies within an extent, under a name of its own.
struct SidePart {
  std::string name, of;
  Extent extent;
  Origin origin;
};

struct Geometry {
  Shape shape;
  std::vector<Layer> layers;  ///< empty: one soil, or the regions of a mesh file
  std::vector<Zone> zones;
  std::vector<SidePart> parts;
  Origin origin;

  /// 2 or 3; 0 for a mesh file, known once it is read. A column counts as two-dimensional, as its candidate is.
  int dim() const;
};

/// The ground over a place x [m] of a built-in shape: elevations [m].
double surface_at(const Geometry& geometry, double x);
double base_at(const Geometry& geometry, double x);
/// Lower boundaries of the layers there, from the surface down; the last is the base where it is not said. They may lie
/// above the surface or below the base.
std::vector<double> layer_bottoms(const Geometry& geometry, double x);
/// Places along x, ascending and from end to end, between which surface, base and layers are straight [m].
std::vector<double> stations(const Geometry& geometry);
/// Names of the sides of a built-in shape, parts included; empty for a mesh file.
std::vector<std::string> side_names(const Geometry& geometry);

}  // namespace wetfront::verification
