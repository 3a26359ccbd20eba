#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace wetfront::verification {

/// A place of a mesh in the scene's coordinates: in one dimension the only coordinate becomes y.
std::array<double, 3> scene_point(const meshes::Point& point, int dim);

/// Name of the soil at a place of the scene; "" where only the mesh's own region says it.
std::string soil_at(const Scene& scene, const std::array<double, 3>& place, int dim);

/// Names the mesh's regions by the layer or zone that each cell's centre lies in, and cuts parts out of sides. Throws
/// std::runtime_error where a part holds no face of its side.
void lay_soils(const Scene& scene, meshes::Mesh& mesh);

/// Factor on the permeability of each cell, at its centre; empty where no soil has a field of them.
std::vector<double> conductivity_factors(const Scene& scene, const meshes::Mesh& mesh);

/// The scene's soil of each mesh region; a scene of one soil fills every region with it. Throws std::runtime_error.
std::vector<const Soil*> soils_by_region(const Scene& scene, const meshes::Mesh& mesh);

}  // namespace wetfront::verification
