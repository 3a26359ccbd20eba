#include "verification/run/history_file.h"

#include "verification/run/history_json.h"
#include "verification/run/sealed_file.h"

namespace wetfront::verification {
namespace {

constexpr const char* format = "wetfront history 2";

}  // namespace

void write_history(const meshes::FieldHistory& history, const std::filesystem::path& path) {
  write_sealed(format, nlohmann::json::to_cbor(nlohmann::json(history)), path);
}

std::optional<meshes::FieldHistory> read_history(const std::filesystem::path& path) {
  const auto content = read_sealed(format, path);
  if (!content) return {};
  return nlohmann::json::from_cbor(*content).get<meshes::FieldHistory>();
}

}  // namespace wetfront::verification
