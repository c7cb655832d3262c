#include <charconv>
#include <cmath>
#include <vector>

#include "fmt/format.h"
#include "sw/base/config.h"
#include "sw/base/error.h"
#include "sw/scene/generate_parts.h"
#include "sw/scene/scene.h"
#include "sw/scene/shapes.h"

namespace rc2::scene {
namespace {

std::vector<std::string> split_at_colons(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name)
    if (c == ':')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

template <typename Number>
Number parse(const std::string& word, const std::string& name) {
  Number value{};
  const char* end = word.data() + word.size();
  const auto [stop, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc() || stop != end)
    throw Error(
        fmt::format("{}: '{}' is not a number as it is asked for here; write for example "
                    "ball:5.5, shells:10:1 or dust:5:1",
                    name, word));
  return value;
}

double parse_percent(const std::string& word, const std::string& name) {
  const auto percent = parse<double>(word, name);
  if (!(percent > 0.0 && percent <= 100.0))
    throw Error(
        fmt::format("{}: {} % is not a share of the cube; choose more than 0 and at most "
                    "100",
                    name, word));
  return percent;
}

void check_word_count(const std::vector<std::string>& words, std::size_t count,
                      const std::string& name) {
  if (words.size() != count)
    throw Error(
        fmt::format("{}: this scene's name has {} part(s) between colons where {} are "
                    "needed; write empty, room, gallery, ball:R, shells:PERCENT:SEED or "
                    "dust:PERCENT:SEED",
                    name, words.size(), count));
}

void generate_ball(Scene& scene, int n, double radius) {
  if (!(radius > 0.0 && radius <= 0.5 * n))
    throw Error(
        fmt::format("{}: a ball of radius {} does not fit into a cube of {} voxels; choose "
                    "more than 0 and at most {}",
                    scene.name, radius, n, 0.5 * n));
  scene.materials.push_back({});
  add_sphere(scene, glm::dvec3(0.5 * (n - 1)), radius, kEdge, 0);
}

}  // namespace

bool is_generated_name(const std::string& name) {
  const std::string word = split_at_colons(name).front();
  return word == "empty" || word == "room" || word == "gallery" || word == "ball" ||
         word == "shells" || word == "dust";
}

Scene generate(const std::string& name, int n) {
  if (n < 2 || n > kMaxSide)
    throw Error(
        fmt::format("{}: a cube of {} voxels a side cannot be built; choose n between 2 "
                    "and {}",
                    name, n, kMaxSide));
  const std::vector<std::string> words = split_at_colons(name);
  const std::string& kind = words.front();
  Scene scene;
  scene.name = name;
  if (kind == "empty") {
    check_word_count(words, 1, name);
  } else if (kind == "room") {
    check_word_count(words, 1, name);
    generate_room(scene, n);
  } else if (kind == "gallery") {
    check_word_count(words, 1, name);
    generate_gallery(scene, n);
  } else if (kind == "ball") {
    check_word_count(words, 2, name);
    generate_ball(scene, n, parse<double>(words[1], name));
  } else if (kind == "shells" || kind == "dust") {
    check_word_count(words, 3, name);
    const double percent = parse_percent(words[1], name);
    const auto seed = parse<std::uint64_t>(words[2], name);
    if (kind == "shells")
      generate_shells(scene, n, percent, seed);
    else
      generate_dust(scene, n, percent, seed);
  } else {
    throw Error(
        fmt::format("{}: there is no generated scene '{}'; write empty, room, gallery, ball:R, "
                    "shells:PERCENT:SEED or dust:PERCENT:SEED",
                    name, kind));
  }
  return scene;
}

}  // namespace rc2::scene
