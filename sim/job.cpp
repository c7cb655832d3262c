#include "sim/job.h"

namespace rc2 {

Job prepare(const SceneOptions& options) {
  Job job;
  job.scene = scene::is_generated_name(options.scene) ? scene::generate(options.scene, options.n)
                                                      : scene::read_file(options.scene);
  if (options.fitted()) scene::fit_to_cube(job.scene, options.n);
  job.facets = facet::build_facets(job.scene, options.n, options.fraction_bits,
                                   facet::parse_rule(options.rule));
  return job;
}

}  // namespace rc2
