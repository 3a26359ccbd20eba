#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

/// A result as plain data, complete enough to render every output of a run from it. Knows no solver.
namespace wetfront::reports {

enum class Verdict { pass, fail, inconclusive, info };  ///< info: shown, not gated

/// One line of the verdict table. error, reference_bound and tolerance share `unit` ("1" for relative ones).
struct Finding {
  std::string quantity;     ///< stable key, e.g. "pressure_l2"
  std::string description;  ///< e.g. "relative L2 of pore pressure at 25 % of filling (1772 s)"
  std::string group;        ///< stage or subject, for the order on the page
  std::string unit = "1";
  double error = 0;
  double reference_bound = 0;  ///< the reference's own uncertainty of this quantity
  double tolerance = 0;        ///< 0 for info
  std::string reason;          ///< why this tolerance
  Verdict verdict = Verdict::info;
  double cpu_s = 0;         ///< CPU seconds that bought this number
  std::string explanation;  ///< a sentence for inconclusive or failed findings; may be empty
  /// How the reference's bound was found: "monotone", "oscillatory", ... as its meshes went; empty: no meshes behind
  /// it.
  std::string reference_convergence{};
  double reference_order = std::numeric_limits<double>::quiet_NaN();  ///< observed, in the cell size
};

struct Series {
  enum class Style { line, dashed, points };
  std::string label;
  Style style = Style::line;
  std::vector<double> x, y;  ///< NaN in both: a line is broken there
  int colour = -1;           ///< palette index: series that belong together share it; -1: next free
};

struct Figure {
  std::string id;  ///< file name stem: <id>.csv, <id>.svg
  std::string title;
  std::string section;  ///< "Profiles", "Time series", "Flux audit", "Cost", ...
  std::string x_label, x_unit, y_label, y_unit;
  std::vector<Series> series;
  std::string note;  ///< printed on the figure: the error
  bool log_x = false, log_y = false;
  struct Window {
    double from, to;
    std::string label;
  };
  std::vector<Window> shaded;  ///< in x
};

struct Table {
  std::string title, section, caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> links{};  ///< per row, relative to the page: where its first cell leads; "" nowhere
  /// What a cell says at a glance. A table that has marks is shown on the index page of its run, too.
  struct Mark {
    std::string kind;  ///< "pass", "fail", "refused", or "" for none
    std::string link;  ///< relative to the page; "" nowhere
  };
  std::vector<std::vector<Mark>> marks{};  ///< per row and cell; empty: none
};

/// A field of two dimensions as solutions have it, painted side by side in one scale.
struct FieldPicture {
  std::string id, title, section;
  std::string quantity, unit;  ///< "pore pressure", "kPa"
  std::vector<double> x, y;    ///< m, of the nodes
  std::vector<int> cells;      ///< four nodes each, one after the other around the cell
  struct Panel {
    std::string label;          ///< "MPM", "reference", "MPM minus reference"
    std::vector<double> nodal;  ///< in `unit`; NaN: not painted
    bool difference = false;    ///< has a scale of its own, symmetric to zero
  };
  std::vector<Panel> panels;
};

/// Material points through time, thinned and in whole numbers of 16 bits (film.h makes it).
struct Film {
  std::string id, title, caption;
  struct Channel {
    std::string name, unit;
    double from = 0, to = 1;  ///< what 0 and 65535 stand for
  };
  std::vector<Channel> channels;  ///< x and y first, then what points may be coloured by
  struct Frame {
    double time = 0;    ///< s
    std::string label;  ///< "failure", "rest", or ""
  };
  std::vector<Frame> frames;
  int points = 0, points_of_run = 0;  ///< shown; there were
  std::vector<std::uint16_t> values;  ///< frame by frame, of each channel by channel, of each point by point
  std::vector<Series> ground;         ///< lines behind the points
};

/// A field file for ParaView: nodal and cell fields on a mesh, or values at points.
struct FieldFile {
  std::string stem;  ///< "reference", "mpm_grid", "mpm_points"
  double time = 0;
  int dim = 2;
  std::vector<double> nodes;  ///< 3 coordinates each
  std::vector<int> cells;     ///< 2^dim per cell; empty: points (vertices)
  struct Field {
    std::string name;  ///< with unit, e.g. "pore_pressure [Pa]"
    bool per_cell = false;
    int components = 1;
    std::vector<double> values;
  };
  std::vector<Field> fields;
};

struct Record {
  std::string kind = "comparison report";  ///< what the page is, in its heading
  std::string case_name, title, requirement;
  std::string scene_path, scene_text;
  Verdict verdict = Verdict::info;
  std::vector<Finding> findings;
  std::vector<Figure> figures;
  std::vector<FieldPicture> pictures{};
  std::vector<Film> films{};
  double pressure_per_head = 0;  ///< kPa per metre of water: pages let one choose; 0: no choice
  std::vector<Table> tables;     ///< cost, ledger, effects plan, set-up, reference error bound
  std::string plan_text;         ///< what `wetfront explain` prints
  std::vector<std::string> log;
  /// git_hash, dirty, input_hash, mesh_hash, compiler, isa, threads, cpu, date, wetfront version, ...
  std::map<std::string, std::string> provenance;
  double cpu_seconds = 0;
};

}  // namespace wetfront::reports
