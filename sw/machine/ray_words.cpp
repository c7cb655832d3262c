#include "sw/machine/ray_words.h"

#include <stdexcept>

namespace rc2 {
namespace {

constexpr int kShareBits = rays::kShareFraction + 1;
constexpr int kWeightBits = rays::kWeightFraction + 1;
constexpr int kIndexBits = rays::kIndexFraction + 3;
constexpr std::size_t kCounts = 7;  // behind the hits

// A HEAD for the cells of a box in the rows of a feeder; false if there are none.
bool head_for(const FacetBox& box, int feeder, int feeders, Word& word) {
  const int first = box.lo.y + (feeder - box.lo.y % feeders + feeders) % feeders;
  if (first > box.hi.y) return false;
  word = Word{WordKind::head};
  word.facet = box.facet;
  word.z0 = box.lo.z;
  word.z_span = box.hi.z - box.lo.z;
  word.skip = {box.lo.x, first / feeders};
  word.take = {box.hi.x - box.lo.x + 1, (box.hi.y - first) / feeders + 1};
  return true;
}

using Fields = std::initializer_list<Field>;

// Calls head(word) and ray(sort, fields) for all words of a feeder, in their order.
template <typename Head, typename Ray>
void for_each_word(const MachineConfig& config, const std::vector<FacetBox>& boxes,
                   const RayJob& job, int feeder, Head head, Ray ray) {
  Word word{WordKind::head};
  for (const FacetBox& box : boxes) {
    if (!head_for(box, feeder, config.feeders, word)) continue;
    const rays::Facet& facet = (*job.facets)[box.facet];
    head(word);
    ray(RaySort::normal, Fields{{facet.normal.z, rays::kNormalBits},
                                {facet.normal.y, rays::kNormalBits},
                                {facet.normal.x, rays::kNormalBits},
                                {static_cast<std::int64_t>(facet.body), 2}});
    ray(RaySort::shares, Fields{{facet.leave, kIndexBits},
                                {facet.enter, kIndexBits},
                                {facet.clear, kShareBits},
                                {facet.mirror, kShareBits}});
  }
  const int place = rays::place_bits(config.n), direction = rays::direction_bits(config.n);
  for (int y = feeder; y < config.n; y += config.feeders) {
    for (int x = 0; x < config.n; ++x) {
      const rays::Ray first = first_ray(job, {x, y}, config.n);
      if (first.direction == glm::ivec3(0)) continue;
      head_for({0, {x, y, 0}, {x, y, 0}}, feeder, config.feeders, word);
      head(word);
      ray(RaySort::origin,
          Fields{{first.origin.z, place}, {first.origin.y, place}, {first.origin.x, place}});
      ray(RaySort::direction, Fields{{first.direction.z, direction},
                                     {first.direction.y, direction},
                                     {first.direction.x, direction}});
    }
  }
}

// Takes fields from the lowest bit on out of the values of some beats.
class FieldReader {
 public:
  FieldReader(const std::uint32_t* values, int value_bits)
      : values_(values), value_bits_(value_bits) {}

  std::int64_t take(int width) {
    std::int64_t value = 0;
    for (int i = 0; i < width; ++i, ++at_)
      value |= std::int64_t{values_[at_ / value_bits_] >> at_ % value_bits_ & 1U} << i;
    return value;
  }
  int take_signed(int width) {
    const std::int64_t value = take(width);
    return static_cast<int>(value - (value >> (width - 1) << width));
  }
  glm::ivec3 take_vector(int width) {
    glm::ivec3 vector;
    for (int axis = 2; axis >= 0; --axis) vector[axis] = take_signed(width);
    return vector;
  }

 private:
  const std::uint32_t* values_;
  int value_bits_, at_ = 0;
};

int hit_bits(const MachineConfig& config) {
  const int n = config.n;
  return 7 + kFacetBits + 3 * coordinate_bits(n) + 6 * rays::place_bits(n) +
         3 * rays::direction_bits(n) + kWeightBits + 1 + config.ray_depth + 1;
}

// In the order of rc2_pkg: end_t below start_t without its home.
void unpack_hit(const MachineConfig& config, const glm::ivec2& home, FieldReader fields,
                HomeRecord& record) {
  const int place = rays::place_bits(config.n);
  RayHit hit{};
  record.too_deep += static_cast<int>(fields.take(2));
  record.too_light += static_cast<int>(fields.take(2));
  hit.point = fields.take_vector(place);
  for (int axis = 2; axis >= 0; --axis)
    hit.voxel[axis] = static_cast<int>(fields.take(coordinate_bits(config.n)));
  hit.facet = static_cast<std::uint32_t>(fields.take(kFacetBits));
  hit.is_back = fields.take(1) != 0;
  record.rescued += static_cast<int>(fields.take(1));
  if (fields.take(1) != 0) hit.facet = RayHit::kNoFacet;
  hit.ray.home = home;
  hit.ray.direction = fields.take_vector(rays::direction_bits(config.n));
  hit.ray.origin = fields.take_vector(place);
  hit.ray.weight = static_cast<std::uint16_t>(fields.take(kWeightBits));
  hit.ray.inside = fields.take(1) != 0;
  hit.ray.node = static_cast<std::uint8_t>(fields.take(config.ray_depth + 1));
  record.hits.push_back(hit);
}

}  // namespace

std::vector<FacetBox> boxes_of(const facet::PacketStream& packets) {
  std::vector<FacetBox> boxes;
  for (const facet::PacketHead& head : packets.heads)
    if (head.layer == facet::Layer::armour) boxes.push_back({head.facet, head.lo, head.hi});
  return boxes;
}

std::vector<HostWord> ray_words(const MachineConfig& config, const std::vector<FacetBox>& boxes,
                                const RayJob& job, int feeder) {
  const WordFormat format(config);
  std::vector<HostWord> words;
  for_each_word(
      config, boxes, job, feeder, [&](const Word& head) { words.emplace_back(format, head); },
      [&](RaySort sort, const Fields& fields) { words.emplace_back(format, sort, fields); });
  return words;
}

std::vector<Word> ray_word_sorts(const MachineConfig& config, const std::vector<FacetBox>& boxes,
                                 const RayJob& job, int feeder) {
  std::vector<Word> words;
  for_each_word(
      config, boxes, job, feeder, [&](const Word& head) { words.push_back(head); },
      [&](RaySort sort, const Fields&) {
        words.push_back({WordKind::ray});
        words.back().sort = sort;
      });
  return words;
}

HomeRecord unpack_home(const MachineConfig& config, const glm::ivec2& home,
                       const std::vector<std::uint32_t>& values) {
  const int value_bits = WordFormat(config).value;
  const auto words = static_cast<std::size_t>((hit_bits(config) + value_bits - 1) / value_bits);
  if (values.size() < kCounts || (values.size() - kCounts) % words != 0)
    throw std::logic_error("sw/machine/ray_words.cpp and rtl/rc2_pkg.sv disagree about a hit");
  HomeRecord record;
  const std::size_t end = values.size() - kCounts;
  for (std::size_t at = 0; at < end; at += words)
    unpack_hit(config, home, FieldReader(values.data() + at, value_bits), record);
  record.probes = values[end];
  record.planes = values[end + 1];
  record.run_on = values[end + 2];
  record.hops = values[end + 3];
  record.work = {record.probes, values[end + 4], values[end + 5], values[end + 6]};
  return record;
}

}  // namespace rc2
