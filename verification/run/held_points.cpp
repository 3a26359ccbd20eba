#include "verification/run/held_points.h"

#include <fmt/format.h>

namespace wetfront::verification {

void tell_held_points(reports::Record& record, const std::string& who, const meshes::FieldHistory& history) {
  const auto found = history.counters.find("points held at the mesh border");
  if (found == history.counters.end() || !(found->second > 0)) return;
  reports::Finding finding;
  finding.quantity = "held_points";
  finding.description = "points held at the mesh border, each time anew";
  finding.group = "Run";
  finding.unit = "1";
  finding.error = found->second;
  finding.explanation =
      "a body that meets the end of its mesh is held there; its run-out is the mesh's where that is its front";
  record.findings.push_back(finding);
  record.log.push_back(fmt::format(
      "{}: {:g} times a point would have left the mesh and was held at its border (points that meet no side condition "
      "of the skeleton stop there). Make the mesh longer or its room higher where the body is not meant to stop.",
      who, found->second));
}

}  // namespace wetfront::verification
