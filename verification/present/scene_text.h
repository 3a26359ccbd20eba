#pragma once

#include "verification/scene/scene.h"

#include <string>

/// What a scene says, as a reader of its page wants it: one line each, with units.
namespace wetfront::verification {

std::string geometry_text(const Geometry& geometry);
std::string layer_text(const Layer& layer);
std::string extent_text(const Extent& extent);
std::string start_text(const InitialState& initial);
std::string retention_text(const Retention& retention);
std::string permeability_text(const Soil& soil);
std::string evaporation_text(const Evaporation& evaporation);
std::string boundary_text(const Boundary& boundary);
std::string strength_text(const Strength& strength);
/// What the skeleton meets on a side, and the load there; empty where nothing is said of it.
std::string skeleton_side_text(const Boundary& boundary);
std::string skeleton_text(const SkeletonSettings& settings);

}  // namespace wetfront::verification
