#include "reports/record_json.h"

#include "reports/json_number.h"
#include "reports/picture_json.h"

#include <stdexcept>

namespace wetfront::reports {

namespace {

using Json = nlohmann::ordered_json;

// What result.json promises to hold; "unknown" where the caller had nothing to say.
constexpr const char* promised_provenance[] = {"git_hash", "dirty", "input_hash", "mesh_hash",
                                               "compiler", "isa",   "threads",    "cpu"};

Json finding_json(const Finding& finding, const std::string& case_name) {
  return {{"case", case_name},
          {"quantity", finding.quantity},
          {"description", finding.description},
          {"group", finding.group},
          {"unit", finding.unit},
          {"error", number_json(finding.error)},
          {"reference_bound", number_json(finding.reference_bound)},
          {"reference_convergence", finding.reference_convergence},
          {"reference_order", number_json(finding.reference_order)},
          {"tolerance", number_json(finding.tolerance)},
          {"reason", finding.reason},
          {"verdict", verdict_key(finding.verdict)},
          {"cpu_s", number_json(finding.cpu_s)},
          {"explanation", finding.explanation}};
}

Finding finding_from(const Json& json) {
  Finding finding;
  finding.quantity = json.at("quantity").get<std::string>();
  finding.description = json.at("description").get<std::string>();
  finding.group = json.at("group").get<std::string>();
  finding.unit = json.at("unit").get<std::string>();
  finding.error = number_from(json.at("error"));
  finding.reference_bound = number_from(json.at("reference_bound"));
  finding.reference_convergence = json.at("reference_convergence").get<std::string>();
  finding.reference_order = number_from(json.at("reference_order"));
  finding.tolerance = number_from(json.at("tolerance"));
  finding.reason = json.at("reason").get<std::string>();
  finding.verdict = verdict_from(json.at("verdict").get<std::string>());
  finding.cpu_s = number_from(json.at("cpu_s"));
  finding.explanation = json.at("explanation").get<std::string>();
  return finding;
}

Json figure_json(const Figure& figure) {
  Json json = {{"id", figure.id},           {"title", figure.title},   {"section", figure.section},
               {"x_label", figure.x_label}, {"x_unit", figure.x_unit}, {"y_label", figure.y_label},
               {"y_unit", figure.y_unit},   {"note", figure.note},     {"log_x", figure.log_x},
               {"log_y", figure.log_y},     {"shaded", Json::array()}, {"series", Json::array()}};
  for (const Figure::Window& window : figure.shaded)
    json["shaded"].push_back(
        {{"from", number_json(window.from)}, {"to", number_json(window.to)}, {"label", window.label}});
  for (const Series& series : figure.series) json["series"].push_back(series_json(series));
  return json;
}

Figure figure_from(const Json& json) {
  Figure figure;
  figure.id = json.at("id").get<std::string>();
  figure.title = json.at("title").get<std::string>();
  figure.section = json.at("section").get<std::string>();
  figure.x_label = json.at("x_label").get<std::string>();
  figure.x_unit = json.at("x_unit").get<std::string>();
  figure.y_label = json.at("y_label").get<std::string>();
  figure.y_unit = json.at("y_unit").get<std::string>();
  figure.note = json.at("note").get<std::string>();
  figure.log_x = json.at("log_x").get<bool>();
  figure.log_y = json.at("log_y").get<bool>();
  for (const Json& window : json.at("shaded"))
    figure.shaded.push_back(
        {number_from(window.at("from")), number_from(window.at("to")), window.at("label").get<std::string>()});
  for (const Json& item : json.at("series")) figure.series.push_back(series_from(item));
  return figure;
}

Json table_json(const Table& table) {
  Json json = {{"title", table.title},   {"section", table.section}, {"caption", table.caption},
               {"header", table.header}, {"rows", table.rows},       {"links", table.links}};
  if (table.marks.empty()) return json;
  json["marks"] = Json::array();
  for (const auto& row : table.marks) {
    Json marks = Json::array();
    for (const Table::Mark& mark : row) marks.push_back({{"kind", mark.kind}, {"link", mark.link}});
    json["marks"].push_back(marks);
  }
  return json;
}

Table table_from(const Json& json) {
  Table table{json.at("title").get<std::string>(),
              json.at("section").get<std::string>(),
              json.at("caption").get<std::string>(),
              json.at("header").get<std::vector<std::string>>(),
              json.at("rows").get<std::vector<std::vector<std::string>>>(),
              json.value("links", std::vector<std::string>{})};
  for (const Json& row : json.value("marks", Json::array())) {
    auto& marks = table.marks.emplace_back();
    for (const Json& mark : row)
      marks.push_back({mark.at("kind").get<std::string>(), mark.at("link").get<std::string>()});
  }
  return table;
}

std::string dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The document with each member on a line of its own and, of the arrays of objects, each element.
std::string by_lines(const Json& document) {
  std::string text = "{";
  std::string comma = "\n";
  for (const auto& [key, value] : document.items()) {
    text += comma + " \"" + key + "\": ";
    comma = ",\n";
    if (!value.is_array() || value.empty()) {
      text += dump(value);
      continue;
    }
    std::string inner = "[\n";
    for (const Json& element : value) {
      text += inner + "  " + dump(element);
      inner = ",\n";
    }
    text += "\n ]";
  }
  return text + "\n}\n";
}

Record record_from(const Json& json) {
  const std::string schema = json.at("schema").get<std::string>();
  if (schema != result_schema)
    throw std::runtime_error("its schema is '" + schema + "' (this program reads '" + result_schema +
                             "'). Use the version of wetfront that wrote it, or run the case again.");
  Record record;
  record.kind = json.value("kind", record.kind);
  record.case_name = json.at("case").get<std::string>();
  record.title = json.at("title").get<std::string>();
  record.requirement = json.at("requirement").get<std::string>();
  record.verdict = verdict_from(json.at("verdict").get<std::string>());
  record.cpu_seconds = number_from(json.at("cpu_s"));
  record.provenance = json.at("provenance").get<std::map<std::string, std::string>>();
  for (const Json& finding : json.at("findings")) record.findings.push_back(finding_from(finding));
  for (const Json& figure : json.at("figures")) record.figures.push_back(figure_from(figure));
  for (const Json& picture : json.value("pictures", Json::array())) record.pictures.push_back(picture_from(picture));
  for (const Json& film : json.value("films", Json::array())) record.films.push_back(film_from(film));
  record.pressure_per_head = number_from(json.value("kpa_per_metre", Json(0)));
  for (const Json& table : json.at("tables")) record.tables.push_back(table_from(table));
  record.plan_text = json.at("plan").get<std::string>();
  record.log = json.at("log").get<std::vector<std::string>>();
  record.scene_path = json.at("scene").at("path").get<std::string>();
  record.scene_text = json.at("scene").at("text").get<std::string>();
  return record;
}

}  // namespace

const char* verdict_key(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::inconclusive:
      return "inconclusive";
    case Verdict::info:
      return "info";
  }
  throw std::logic_error("verdict_key: not a Verdict");
}

Verdict verdict_from(const std::string& key) {
  for (const Verdict verdict : {Verdict::pass, Verdict::fail, Verdict::inconclusive, Verdict::info})
    if (key == verdict_key(verdict)) return verdict;
  throw std::runtime_error("'" + key + "' is not a verdict (pass, fail, inconclusive, info)");
}

std::string to_json(const Record& record) {
  Json json;
  json["schema"] = result_schema;
  json["kind"] = record.kind;
  json["case"] = record.case_name;
  json["title"] = record.title;
  json["requirement"] = record.requirement;
  json["verdict"] = verdict_key(record.verdict);
  json["cpu_s"] = number_json(record.cpu_seconds);
  std::map<std::string, std::string> provenance = record.provenance;
  for (const char* key : promised_provenance) provenance.try_emplace(key, "unknown");
  json["provenance"] = provenance;
  json["findings"] = Json::array();
  for (const Finding& finding : record.findings) json["findings"].push_back(finding_json(finding, record.case_name));
  json["tables"] = Json::array();
  for (const Table& table : record.tables) json["tables"].push_back(table_json(table));
  json["plan"] = record.plan_text;
  json["log"] = record.log;
  json["scene"] = {{"path", record.scene_path}, {"text", record.scene_text}};
  json["figures"] = Json::array();
  for (const Figure& figure : record.figures) json["figures"].push_back(figure_json(figure));
  json["pictures"] = Json::array();
  for (const FieldPicture& picture : record.pictures) json["pictures"].push_back(picture_json(picture));
  json["films"] = Json::array();
  for (const Film& film : record.films) json["films"].push_back(film_json(film));
  json["kpa_per_metre"] = number_json(record.pressure_per_head);
  return by_lines(json);
}

Record from_json(const std::string& text) {
  try {
    return record_from(Json::parse(text));
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("not a ") + result_schema + " file: " + error.what());
  }
}

}  // namespace wetfront::reports
