#include "sim/job.h"

#include <fmt/format.h>

#include "sw/base/error.h"
#include "sw/facet/layers.h"

namespace rc2 {

scene::Scene read_scene(const SceneOptions& options) {
  scene::Scene scene = scene::is_generated_name(options.scene)
                           ? scene::generate(options.scene, options.n)
                           : scene::read_file(options.scene);
  if (options.fitted()) scene::fit_to_cube(scene, options.n);
  return scene;
}

Job prepare(const SceneOptions& options, bool with_layers) {
  const facet::Rule rule = facet::parse_rule(options.rule);
  if (with_layers && rule != facet::Rule::armoured)
    throw Error(
        fmt::format("--rule {}: the layers have their own rules; leave out --rule or "
                    "--layers all",
                    options.rule));
  Job job;
  job.scene = read_scene(options);
  job.facets = with_layers ? facet::build_layers(job.scene, options.n, options.fraction_bits)
                           : facet::build_facets(job.scene, options.n, options.fraction_bits, rule);
  return job;
}

}  // namespace rc2
