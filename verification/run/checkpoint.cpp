#include "verification/run/checkpoint.h"

#include "verification/run/content_hash.h"
#include "verification/run/history_json.h"
#include "verification/run/sealed_file.h"
#include "verification/run/version.h"

namespace wetfront::mpm {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rider, name, start, time, place, velocity)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StageSpan, name, scheme, begin, end, ended_by, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Picture, snapshot, of, displacement)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyRecord, riders, stages, pictures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(State, time, stage, fields, history, body)

// A member that is not written would come back empty; these do not compile when one is added.
namespace {
[[maybe_unused]] void every_member_is_written(const State& state) {
  [[maybe_unused]] const auto& [time, stage, fields, history, body] = state;
  [[maybe_unused]] const auto& [riders, stages, pictures] = body;
  [[maybe_unused]] const auto& [name, start, times, place, velocity] = riders[0];
  [[maybe_unused]] const auto& [title, scheme, begin, end, ended_by, reason] = stages[0];
  [[maybe_unused]] const auto& [snapshot, of, displacement] = pictures[0];
}
}  // namespace

}  // namespace wetfront::mpm

namespace wetfront::verification {
namespace {

constexpr const char* format = "wetfront checkpoint 1";

std::filesystem::path before(const std::filesystem::path& file) {
  return file.string() + ".before";
}

std::filesystem::path fresh(const std::filesystem::path& file) {
  return file.string() + ".fresh";
}

}  // namespace

void write_checkpoint(const mpm::State& state, const CheckpointFile& where) {
  const nlohmann::json content = {{"belongs_to", where.belongs_to}, {"state", state}};
  const auto bytes = nlohmann::json::to_cbor(content);
  write_sealed(format, bytes, fresh(where.file));
  std::error_code none;
  std::filesystem::rename(where.file, before(where.file), none);
  std::filesystem::rename(fresh(where.file), where.file);
}

std::optional<mpm::State> read_checkpoint(const CheckpointFile& where, std::string& note) {
  for (const auto& file : {where.file, before(where.file)}) {
    if (!std::filesystem::exists(file)) continue;
    const auto bytes = read_sealed(format, file);
    if (!bytes) {
      note += file.string() + " is not a whole checkpoint; ";
      continue;
    }
    const nlohmann::json content = nlohmann::json::from_cbor(*bytes);
    if (content.at("belongs_to") == where.belongs_to) return content.at("state").get<mpm::State>();
    note += file.string() + " belongs to another scene or program; ";
  }
  return {};
}

void forget_checkpoint(const CheckpointFile& where) {
  std::error_code none;
  for (const auto& file : {where.file, before(where.file), fresh(where.file)}) std::filesystem::remove(file, none);
}

std::string checkpoint_owner(const std::string& scene_text) {
  ContentHash hash;
  hash.add(std::string_view(scene_text));
  hash.add(std::string_view(version::git_hash));
  hash.add(std::string_view(version::compiler));
  return hash.text();
}

}  // namespace wetfront::verification
