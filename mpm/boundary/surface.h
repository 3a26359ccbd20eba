#pragma once

#include "mpm/boundary/faces.h"
#include "mpm/grid/material_points.h"
#include "mpm/grid/polygon.h"

#include <vector>

namespace wetfront::mpm {

/// A plane piece of the border of the soil.
template <int dim>
struct SurfacePiece {
  std::size_t cell = 0;                          ///< the soil behind
  Vector<dim> centre{};                          ///< x_s [m]
  Vector<dim> area{};                            ///< outwards [m^(dim-1)]
  std::array<double, cell_nodes<dim>> weight{};  ///< mean of N_i over the piece, local nodes of `cell`; sum 1 [-]
  double fill = 1;                               ///< part of the cell that is soil [-]
  bool border = false;                           ///< on the border of the mesh; otherwise in front of empty space
  int side = -1;                                 ///< index into Mesh::sides of a border piece; -1: unnamed
  int face = -1;                                 ///< local face of `cell` that it lies on; -1: it cuts through the cell
};

/// The border of the soil as its points show it, not as any line in the scene says.
///
/// A cell without points is empty; one with points is full or cut. Fill f = (volume of its points)/(volume of the
/// cell). Cut (two dimensions): f < 1 - full_within, and near a surface: next to an empty cell, at the border of the
/// mesh, or with a corner around which less than 3/4 of the volume is filled. (Inside, f of moved points varies by a
/// point's share and means nothing.) In a cut cell the soil lies behind a straight line that holds f of the cell and
/// whose centroid lies where that of the points does along the line (moment-of-fluid, Dyadechko & Shashkov 2005,
/// reduced to one equation), within 30 degrees of the gradient of the nodal fill: exact for straight surfaces on any
/// mesh. Where two cut cells do not meet their shared face in one point, both take the mean.
///
/// What one side of a face covers and the other does not is surface too (small gaps are added to the piece beside
/// them), so the pieces close: over all of them, and along every part of the surface between two borders, area vectors
/// sum to what the ends say, to round-off.
///
/// It is a function of the points alone (a continued run finds the same), and a continuous one but for points that
/// change cells: what `full_within` switches moves the surface by that fraction of a cell. In three dimensions cells
/// with points count as full.
template <int dim>
class Surface {
 public:
  /// Settling by half a per cent, the strain of an elastic slope under its weight, leaves a full cell full.
  static constexpr double full_within = 5e-3;

  Surface(const Grid<dim>& grid, const MaterialPoints<dim>& points, const meshes::Mesh& mesh);

  /// Detects anew if the volume or centroid of any cell's points has changed since; false when nothing was done.
  bool update();
  const std::vector<SurfacePiece<dim>>& pieces() const { return pieces_; }
  /// f of every cell; 0: no points.
  const std::vector<double>& fill() const { return fill_; }
  bool cut(std::size_t cell) const { return line_of_[cell] >= 0; }
  const Faces<dim>& faces() const { return faces_; }

 private:
  struct Interval {
    double from = 0, until = 0;
  };
  /// The line through a cut cell: from where the soil ends on one face to where it begins on another.
  struct Line {
    std::size_t cell = 0;
    HalfPlane soil;
    std::array<int, 2> face{};
    std::array<double, 2> at{};  ///< place along the face, 0 to 1 in the order of local_face
  };
  bool measure_cells();
  void fill_nodes();
  bool near_surface(std::size_t cell) const;
  Vector<2> gradient_direction(std::size_t cell) const;
  void place_line(std::size_t cell);
  void join_lines();
  Interval covered(std::size_t cell, int face) const;
  void add_face_parts(std::size_t cell, int face);
  SurfacePiece<dim> piece_on(std::size_t cell, int face) const;
  void add_part(std::size_t cell, int face, Interval part);
  void close_gap(std::size_t cell, int face, Interval part);
  void add_line(const Line& line);
  void add_face(std::size_t cell, int face);

  const Grid<dim>& grid_;
  const MaterialPoints<dim>& points_;
  Faces<dim> faces_;
  std::vector<double> cell_volume_, node_volume_;
  std::vector<double> volume_, fill_, node_fill_;
  std::vector<Vector<dim>> centroid_;
  std::vector<int> line_of_;
  std::vector<Line> lines_;
  std::vector<SurfacePiece<dim>> pieces_;
  std::vector<char> seen_;             ///< scratch of measure_cells: the cells with points
  std::vector<std::size_t> occupied_;  ///< the same as a list, each once
};

}  // namespace wetfront::mpm
