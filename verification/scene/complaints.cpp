#include "verification/scene/complaints.h"

#include "verification/scene/read.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <tuple>

namespace wetfront::verification {
namespace {

std::string lower(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word;
}

/// Damerau-Levenshtein in its restricted form: a swap of two neighbouring letters counts as one slip.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string render(const std::string& file, Place place, const Complaint& complaint) {
  return file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + complaint.text();
}

}  // namespace

std::string Origin::text() const {
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

std::string Complaint::text() const {
  return problem + (why.empty() ? "" : " (" + why + ")") + "." + (suggestion.empty() ? "" : " " + suggestion);
}

void Complaints::add(Place place, const Complaint& complaint) {
  found_.push_back({place, {}, render(file_, place, complaint)});
}

void Complaints::add_elsewhere(Place place, const std::string& file, Place there, const Complaint& complaint) {
  found_.push_back({place, there, render(file, there, complaint)});
}

std::vector<std::string> Complaints::in_order() const {
  std::vector<Found> sorted = found_;
  const auto order = [](const Found& found) {
    return std::make_tuple(found.place.line, found.place.column, found.there.line, found.there.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Found& a, const Found& b) { return order(a) < order(b); });
  std::vector<std::string> messages;
  for (const Found& found : sorted) messages.push_back(found.message);
  return messages;
}

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  if (word.size() > 60) return "";  // not a misspelt key, and the distance costs its square
  std::string best;
  std::size_t best_distance = std::string::npos;
  for (const std::string& candidate : known) {
    const std::string a = lower(word), b = lower(candidate);
    std::size_t distance = edit_distance(a, b);
    const bool part =
        a.size() >= 3 && (b.find(a) != std::string::npos || (b.size() >= 3 && a.find(b) != std::string::npos));
    if (part) distance = std::min<std::size_t>(distance, 1);  // "conductivity" for "saturated_conductivity"
    const std::size_t allowed = std::max<std::size_t>(1, std::max(a.size(), b.size()) / 3);
    if (distance <= allowed && distance < best_distance && distance < b.size())
      best = candidate, best_distance = distance;
  }
  return best;
}

std::string shortened(const std::string& text) {
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string suggest(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return near.empty() ? "Use one of those." : "Did you mean '" + near + "'?";
}

SceneError::SceneError(std::vector<std::string> all)
    : std::runtime_error(std::accumulate(all.begin(), all.end(), std::string(),
                                         [](std::string text, const std::string& message) {
                                           return text.empty() ? message : std::move(text) + "\n" + message;
                                         })),
      messages(std::move(all)) {}

}  // namespace wetfront::verification
