/// The generated pages in the repository are those of the table of keys.
/// WETFRONT_UPDATE_GOLDEN=1 writes them again.
#include "verification/scene/keys.h"
#include "verification/scene/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace wetfront::verification {
namespace {

void expect_current(const std::string& name, const std::string& generated) {
  const auto path = std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/scene" / name;
  if (std::getenv("WETFRONT_UPDATE_GOLDEN")) std::ofstream(path) << generated;
  std::ifstream file(path);
  std::ostringstream stored;
  stored << file.rdbuf();
  EXPECT_EQ(stored.str(), generated) << name
                                     << " is not what the table of keys gives: run with WETFRONT_UPDATE_GOLDEN=1";
}

TEST(GeneratedPages, SchemaIsCurrent) {
  expect_current("scene.schema.json", scene_schema());
}
TEST(GeneratedPages, ReferencePageIsCurrent) {
  expect_current("SCENE.md", scene_reference_page());
}

TEST(TableOfKeys, EveryKeyHasASectionAMeaningAndAnExample) {
  for (const Section& section : sections()) {
    std::set<std::string> names;
    for (const Key* key : keys_of(section.name)) {
      EXPECT_TRUE(names.insert(key->name).second) << section.name << "." << key->name << " is there twice";
      EXPECT_FALSE(key->meaning.empty()) << section.name << "." << key->name;
      EXPECT_FALSE(key->example.empty()) << section.name << "." << key->name;
      if (key->takes == Takes::table) {
        EXPECT_NO_THROW(section_named(section.name + "." + key->name));
      }
    }
    EXPECT_FALSE(names.empty()) << section.name;
  }
}

TEST(TableOfKeys, EveryKeyIsInSchemaAndPage) {
  const std::string schema = scene_schema(), page = scene_reference_page();
  for (const Section& section : sections())
    for (const Key* key : keys_of(section.name)) {
      EXPECT_THAT(schema, testing::HasSubstr('"' + key->name + '"'));
      EXPECT_THAT(page, testing::HasSubstr("| `" + key->name + "` |"));
    }
}

}  // namespace
}  // namespace wetfront::verification
