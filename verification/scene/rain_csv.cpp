#include "verification/scene/csv_table.h"
#include "verification/scene/reading.h"

#include <fmt/format.h>

namespace wetfront::verification {

meshes::RainRecord read_rain_csv(const std::filesystem::path& path, Place named_at, Complaints& complaints) {
  static const CsvForm form{
      "rain record", {{{"time", "s"}, {"intensity", "m/s"}}}, "0, 100", "time [s], intensity [mm/h]"};
  const CsvTable table = read_csv(path, form, 0, named_at, complaints);
  if (table.column.empty()) return {};
  const meshes::RainRecord record{table.column[0], table.column[1]};
  const auto faults = faults_of(record);
  for (const RainFault& fault : faults)
    complaints.add_elsewhere(named_at, path.string(), {table.line[fault.row], 1}, fault.complaint);
  return table.sound && faults.empty() ? record : meshes::RainRecord{};
}

std::vector<RainFault> faults_of(const meshes::RainRecord& record) {
  std::vector<RainFault> faults;
  for (std::size_t i = 0; i < record.start.size(); ++i) {
    const double before = i == 0 ? 0 : record.start[i - 1];
    if (i > 0 && record.start[i] <= before)
      faults.push_back(
          {i,
           {"the times of the rain do not ascend", fmt::format("{:g} s follows {:g} s", record.start[i], before),
            "Sort the record by time, each time once."}});
    if (i == 0 && record.start[i] < 0)
      faults.push_back(
          {i, {"the rain starts before the run", fmt::format("at {:g} s", record.start[i]), "The run starts at 0 s."}});
    if (record.intensity[i] < 0)
      faults.push_back({i,
                        {"the rain intensity is negative", fmt::format("{:g} m/s", record.intensity[i]),
                         "Write 0 where it is dry."}});
    if (record.intensity[i] > 0.1)
      faults.push_back(
          {i,
           {"the rain intensity is out of range", fmt::format("{:g} m/s is more than 0.1 m/s", record.intensity[i]),
            "Check the unit and the exponent."}});
  }
  return faults;
}

}  // namespace wetfront::verification
