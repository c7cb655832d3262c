#include "sim/true_picture.h"

#include <cmath>

namespace rc2 {

picture::Image true_picture(const truth::Whitted& truth, const std::vector<Sight>& sights,
                            const std::vector<Lamp>& lamps, int depth, bool has_shadows) {
  std::vector<truth::Lamp> at;
  at.reserve(lamps.size());
  for (const Lamp& lamp : lamps) at.push_back({lamp.voxel, lamp.colour, has_shadows});
  picture::Image image;
  image.n = static_cast<int>(std::lround(std::sqrt(sights.size())));
  image.colour.resize(sights.size());
  std::size_t i = 0;
  for (int y = 0; y < image.n; ++y) {
    for (int x = 0; x < image.n; ++x) {
      const Sight& sight = sights[i++];
      image.colour[image.pixel(x, y)] = truth.colour(sight.from, sight.direction, at, depth);
    }
  }
  return image;
}

}  // namespace rc2
