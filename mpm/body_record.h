#pragma once

#include "meshes/field_history.h"

#include <string>
#include <vector>

namespace wetfront::mpm {

/// A point of the soil that is followed from its first place.
struct Rider {
  std::string name;
  meshes::Point start{};                ///< m, of the material point nearest to what was asked for
  std::vector<double> time;             ///< s
  std::vector<meshes::Point> place;     ///< m
  std::vector<meshes::Point> velocity;  ///< m/s; zero from equilibrium to equilibrium
};

/// A stage of the run as it went.
struct StageSpan {
  std::string name, scheme;
  double begin = 0, end = 0;  ///< s
  std::string ended_by{};     ///< "time", "failure", "rest"; empty: under way
  std::string reason{};       ///< one sentence
};

/// The body at a moment.
struct Picture {
  meshes::Snapshot snapshot;
  std::string of;                           ///< "failure", "rest", or empty: one of a series
  std::vector<meshes::Point> displacement;  ///< of the points since the run began [m]; empty without riders
};

/// What is kept of a body that moves, beside the fields that are compared.
struct BodyRecord {
  std::vector<Rider> riders;
  std::vector<StageSpan> stages;
  std::vector<Picture> pictures;  ///< at the ends of stages that an event ends, and as often as stages ask for them
};

}  // namespace wetfront::mpm
