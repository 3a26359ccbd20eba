#include "verification/compare/missed_events.h"

#include <algorithm>

namespace wetfront::verification {

std::vector<Measurement> missed_events(const Scene& scene, const mpm::BodyRecord& body) {
  int asked = 0, missed = 0;
  std::string which;
  for (const Stage& stage : scene.stages) {
    if (stage.event.kind == StageEvent::Kind::none) continue;
    ++asked;
    const std::string event = stage.event.kind == StageEvent::Kind::failure ? "failure" : "rest";
    const auto came = [&](const mpm::StageSpan& span) { return span.name == stage.name && span.ended_by == event; };
    if (std::ranges::any_of(body.stages, came)) continue;
    ++missed;
    which += (which.empty() ? "" : ", ") + event + " in stage '" + stage.name + "'";
  }
  if (asked == 0) return {};
  return {{"missed_events",
           "events (failure, rest) that did not come in their time",
           -1,
           "",
           static_cast<double>(missed) / asked,
           {},
           which}};
}

}  // namespace wetfront::verification
