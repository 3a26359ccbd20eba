#pragma once

#include "verification/scene/filling_time.h"
#include "verification/scene/scene.h"
#include "verification/scene/section.h"

#include <filesystem>
#include <string>
#include <vector>

/// The parts of read_scene, in the order they run. Each fills its part of the scene and complains.
namespace wetfront::verification {

struct Reading {
  const Value& root;
  Complaints& complaints;
  Scene& scene;

  /// Rain counts as well: where [water] was forgotten, that is said once, and not of every wet key.
  bool wet() const { return root.find("water") || root.find("rain"); }
  /// filling_time(scene), without consequences of mistakes that were complained of already.
  FillingTime filling() const;
  bool elastic() const;
  bool has_reference() const { return root.find("reference") != nullptr; }
  /// Sides of the built-in shapes; empty for a mesh file, whose sides are known once it is read.
  std::vector<std::string> sides() const;
  /// rho g [Pa/m]; 0 without water or without gravity.
  double unit_weight() const;
  std::filesystem::path folder() const { return scene.path.parent_path(); }
  /// sections_of, with heads of water understood.
  std::vector<SectionReader> sections(const std::string& name) const;
  std::optional<SectionReader> section(const std::string& name) const;
};

void read_top(Reading& reading);       // title, requirement, gravity
void read_geometry(Reading& reading);  // geometry, layer, zone, part
void read_soils(Reading& reading);     // water, soil
void read_initial(Reading& reading);   // initial
void read_rains(Reading& reading);     // rain
void read_evaporation(Reading& reading);
void read_boundaries(Reading& reading);
void read_probes(Reading& reading);
void read_riders(Reading& reading);
void read_stages(Reading& reading);      // stage, mpm
void read_mpm(Reading& reading);         // mpm; part of read_stages
void read_skeleton(Reading& reading);    // skeleton
void read_comparison(Reading& reading);  // reference, comparison, tolerance

void read_layers(Reading& reading);       // layer; part of read_geometry
void check_soil_names(Reading& reading);  // of layers and zones; part of read_soils

/// Retention and permeability of one soil; porosity where the retention gives it.
void read_laws(SectionReader& reader, Soil& soil, const Reading& reading);
/// Stiffness, strength and stress at rest of one soil.
void read_soil_skeleton(SectionReader& reader, Soil& soil);
/// What the skeleton meets on a side, and the load there.
void read_skeleton_condition(SectionReader& reader, Boundary& boundary, const Reading& reading);
/// `side` of a section, complained of where the geometry has none of that name.
std::string read_side(SectionReader& reader, const Reading& reading, const std::string& key = "side");

/// A third component would be ignored in a column or a slope: complains of it.
void check_plane(SectionReader& reader, const std::string& name, const std::vector<double>& components,
                 const Geometry& geometry);

/// `series` of a section.
meshes::RainRecord read_series(SectionReader& reader);
/// Values at places from a file; pressures where `value` says so.
PlaceTable read_places(const std::filesystem::path& path, const TableColumn& value, int dim, SectionReader& reader,
                       const std::string& key);

/// A rain record from a file `time [unit], intensity [unit]`; complaints carry that file's lines.
meshes::RainRecord read_rain_csv(const std::filesystem::path& path, Place named_at, Complaints& complaints);

/// What is wrong with one row of a rain record.
struct RainFault {
  std::size_t row;
  Complaint complaint;
};
/// Times must ascend from 0, intensities be >= 0 and possible.
std::vector<RainFault> faults_of(const meshes::RainRecord& record);

}  // namespace wetfront::verification
