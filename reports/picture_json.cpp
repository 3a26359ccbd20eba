#include "reports/picture_json.h"

#include "reports/film.h"
#include "reports/json_number.h"

#include <stdexcept>

namespace wetfront::reports {

namespace {

using Json = nlohmann::ordered_json;

Series::Style style_from(const std::string& key) {
  for (const auto style : {Series::Style::line, Series::Style::dashed, Series::Style::points})
    if (key == style_key(style)) return style;
  throw std::runtime_error("'" + key + "' is not a style (line, dashed, points)");
}

}  // namespace

const char* style_key(Series::Style style) {
  return style == Series::Style::line ? "line" : style == Series::Style::dashed ? "dashed" : "points";
}

Json series_json(const Series& series) {
  return {{"label", series.label},
          {"style", style_key(series.style)},
          {"colour", series.colour},
          {"x", numbers_json(series.x)},
          {"y", numbers_json(series.y)}};
}

Series series_from(const Json& json) {
  Series series;
  series.label = json.at("label").get<std::string>();
  series.style = style_from(json.at("style").get<std::string>());
  series.colour = json.at("colour").get<int>();
  series.x = numbers_from(json.at("x"));
  series.y = numbers_from(json.at("y"));
  return series;
}

Json picture_json(const FieldPicture& picture) {
  Json json = {{"id", picture.id},
               {"title", picture.title},
               {"section", picture.section},
               {"quantity", picture.quantity},
               {"unit", picture.unit},
               {"x", numbers_json(picture.x)},
               {"y", numbers_json(picture.y)},
               {"cells", picture.cells},
               {"panels", Json::array()}};
  for (const FieldPicture::Panel& panel : picture.panels)
    json["panels"].push_back(
        {{"label", panel.label}, {"difference", panel.difference}, {"nodal", numbers_json(panel.nodal)}});
  return json;
}

FieldPicture picture_from(const Json& json) {
  FieldPicture picture;
  picture.id = json.at("id").get<std::string>();
  picture.title = json.at("title").get<std::string>();
  picture.section = json.at("section").get<std::string>();
  picture.quantity = json.at("quantity").get<std::string>();
  picture.unit = json.at("unit").get<std::string>();
  picture.x = numbers_from(json.at("x"));
  picture.y = numbers_from(json.at("y"));
  picture.cells = json.at("cells").get<std::vector<int>>();
  for (const Json& panel : json.at("panels"))
    picture.panels.push_back(
        {panel.at("label").get<std::string>(), numbers_from(panel.at("nodal")), panel.at("difference").get<bool>()});
  return picture;
}

Json film_json(const Film& film) {
  Json json = {{"id", film.id},
               {"title", film.title},
               {"caption", film.caption},
               {"points", film.points},
               {"points_of_run", film.points_of_run},
               {"channels", Json::array()},
               {"frames", Json::array()},
               {"ground", Json::array()},
               {"values", words_text(film.values)}};
  for (const Film::Channel& channel : film.channels)
    json["channels"].push_back({{"name", channel.name},
                                {"unit", channel.unit},
                                {"from", number_json(channel.from)},
                                {"to", number_json(channel.to)}});
  for (const Film::Frame& frame : film.frames)
    json["frames"].push_back({{"time", number_json(frame.time)}, {"label", frame.label}});
  for (const Series& line : film.ground) json["ground"].push_back(series_json(line));
  return json;
}

Film film_from(const Json& json) {
  Film film;
  film.id = json.at("id").get<std::string>();
  film.title = json.at("title").get<std::string>();
  film.caption = json.at("caption").get<std::string>();
  film.points = json.at("points").get<int>();
  film.points_of_run = json.at("points_of_run").get<int>();
  for (const Json& channel : json.at("channels"))
    film.channels.push_back({channel.at("name").get<std::string>(), channel.at("unit").get<std::string>(),
                             number_from(channel.at("from")), number_from(channel.at("to"))});
  for (const Json& frame : json.at("frames"))
    film.frames.push_back({number_from(frame.at("time")), frame.at("label").get<std::string>()});
  for (const Json& line : json.at("ground")) film.ground.push_back(series_from(line));
  film.values = words_from(json.at("values").get<std::string>());
  if (film.values.size() != film.frames.size() * film.channels.size() * static_cast<std::size_t>(film.points))
    throw std::runtime_error("the film '" + film.id + "' has " + std::to_string(film.values.size()) +
                             " numbers, which is not frames x channels x points");
  return film;
}

}  // namespace wetfront::reports
