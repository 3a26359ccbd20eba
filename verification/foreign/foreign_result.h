#pragma once

#include "meshes/field_history.h"
#include "verification/foreign/point_data.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <filesystem>
#include <string>
#include <vector>

/// Another code's stored result, declared in a TOML file: which file holds which time, what its arrays are called, in
/// which unit and with which sign (README of this folder).
namespace wetfront::verification {

struct ForeignField {
  std::string array;
  double factor = 1;  ///< to SI and to this program's sign: pore pressure is compression-positive
};
struct ForeignSnapshot {
  std::filesystem::path file;
  double time;  ///< s
};
struct ForeignResult {
  std::filesystem::path path;  ///< of the declaration
  std::string text, title, code;
  std::vector<ForeignSnapshot> snapshots;  ///< ascending
  ForeignField pressure, saturation;
  PlaceNames places;  ///< what its tables call the coordinates; empty: x, y, z
  double metres = 1;  ///< of a unit of its places
  std::vector<std::string>
      assumed;  ///< what the declaration leaves out and the code's name stands for, a sentence each
};

/// Reads a declaration (declaration.cpp). Throws SceneError in the grammar of scenes.
ForeignResult read_foreign(const std::filesystem::path& path);

/// The result as a candidate on the scene's own cells: a cell's value is the mean of the points in it. What the soil
/// holds, and therefore what went in, is summed over the cells. Columns only. Throws std::runtime_error where the files
/// do not hold what was declared, where a cell has no point, or where a comparison time has no file.
meshes::FieldHistory foreign_history(const ForeignResult& result, const Scene& scene, const Timeline& timeline);

/// What looks wrong about the declaration: a sign the other way round, a unit a thousand times off. Empty: nothing
/// does.
std::string looks_wrong(const meshes::FieldHistory& candidate, const meshes::FieldHistory& reference);

}  // namespace wetfront::verification
