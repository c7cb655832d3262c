#include "sim/render_job.h"

#include <fmt/format.h>

#include <cmath>

#include "sw/base/error.h"

namespace rc2 {

void declare_view(Command& command, std::string& view) {
  command
      .option("--view", view,
              "front: along -z, without perspective, a pixel is a column; camera: through "
              "the scene's camera")
      .one_of({"front", "camera"});
}

std::vector<Sight> sights_of(const scene::Scene& scene, const std::string& view, int n) {
  if (view == "front") return front_sights(n);
  if (!scene.camera)
    throw Error(
        fmt::format("--view camera: {} has no camera; leave out --view, or put a perspective "
                    "camera into the file",
                    scene.name));
  return camera_sights(*scene.camera, n);
}

int weight_of(double share) { return static_cast<int>(std::lround(share * rays::kWeightOne)); }

const std::vector<RayStart>* starts_for(const std::string& view,
                                        const std::vector<RayStart>& starts) {
  return view == "front" ? nullptr : &starts;
}

void make_mirrors(std::vector<rays::Facet>& optics) {
  for (rays::Facet& facet : optics) {
    facet.mirror = rays::kShareOne;
    facet.clear = 0;
  }
}

std::vector<rays::Body> bodies_of(const Job& job) {
  std::vector<rays::Body> bodies(job.scene.polygon_count(), rays::Body::sheet);
  for (const facet::FacetInfo& facet : job.facets.facets) bodies[facet.polygon] = facet.body;
  return bodies;
}

}  // namespace rc2
