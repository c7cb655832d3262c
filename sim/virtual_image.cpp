// Thesis 5.5.4: where the rays that a mirror of voxels reflects seem to come from.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "sim/render_job.h"
#include "sim/table_command.h"
#include "sw/chapter5/tracer.h"
#include "sw/facet/layers.h"
#include "sw/facet/optics.h"
#include "sw/scene/shapes.h"

namespace rc2 {
namespace {

using chapter5::Choices;
using chapter5::Leave;
using chapter5::Normal;
using chapter5::Point;
using chapter5::Voxels;

struct Case {
  const char* name;
  Choices choices;
};

// The thesis's three cases. It lets the first voxel stop a ray; only the exact hit needs to know
// where the plane is.
const Case kCases[] = {
    {"facet, plane", {}},
    {"facet, centre", {Normal::facet, Point::centre, Leave::nothing}},
    {"facet, side", {Normal::facet, Point::side, Leave::nothing}},
    {"side, side", {Normal::side, Point::side, Leave::nothing}},
};

// A point source before a mirror, both in the plane z = n/2, in which all rays stay.
struct Stage {
  explicit Stage(int n)
      : source(std::round(0.2 * n), std::round(0.38 * n), n / 2), foot(0.6 * n, 0.5 * n, n / 2) {
    // The mirror is the side of a block that faces the source.
    scene::Scene scene;
    scene.materials.resize(1);
    const double thick = 0.1 * n;
    const glm::dmat3 axes(-normal, along, glm::dvec3(0, 0, 1));
    scene::add_box(scene, {foot - thick * normal, {thick, kHalf * n, 0.3 * n}, axes}, 0);
    facets = facet::build_layers(scene, n, kRenderFraction);
    optics = facet::find_optics(facets.facets, scene.materials);
    make_mirrors(optics);
    image = source - 2 * glm::dot(source - foot, normal) * normal;
  }

  // Towards points of the mirror as far apart from one another, but for a margin at its ends.
  std::vector<Sight> sights(int n) const {
    std::vector<Sight> all;
    const int count = 2 * n;
    for (int i = 0; i < count; ++i) {
      const double share = 1.8 * (i + 0.5) / count - 0.9;
      all.push_back({source, glm::normalize(foot + share * kHalf * n * along - source)});
    }
    return all;
  }

  static constexpr double kHalf = 0.3;         // of the mirror's length, in n
  glm::dvec3 normal{-12.0 / 13, 5.0 / 13, 0};  // towards the source
  glm::dvec3 along{5.0 / 13, 12.0 / 13, 0};    // the mirror
  glm::dvec3 source, foot, image;              // foot: its middle
  facet::FacetSet facets;
  std::vector<rays::Facet> optics;
};

// One ray and where it seems to come from: as far behind the hit as the source is before it.
struct Seen {
  glm::dvec3 hit, direction, from;
};

struct Row {
  int n;
  const char* name;
  std::vector<Seen> rays;
  std::int64_t lost = 0;         // rays whose reflection meets the mirror again, or that miss it
  double mean = 0, largest = 0;  // distance from the image, voxels
  int clouds = 0;
  double dark = 0;  // percent of the true rays near which none is reflected
};

// Points of which each is less than a voxel from another one, or alone.
int count_clouds(std::vector<Seen> rays) {
  int clouds = 0;
  while (!rays.empty()) {
    ++clouds;
    std::vector<glm::dvec3> border{rays.back().from};
    rays.pop_back();
    while (!border.empty()) {
      const glm::dvec3 at = border.back();
      border.pop_back();
      const auto near = std::partition(rays.begin(), rays.end(), [&](const Seen& seen) {
        return glm::distance(seen.from, at) >= 1;
      });
      std::transform(near, rays.end(), std::back_inserter(border),
                     [](const Seen& seen) { return seen.from; });
      rays.erase(near, rays.end());
    }
  }
  return clouds;
}

// Percent of the directions wanted that have none beside them: none within twice the widest angle
// between neighbours.
double dark_share(const std::vector<glm::dvec3>& have, const std::vector<glm::dvec3>& want) {
  const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::min(1.0, glm::dot(a, b)));
  };
  double widest = 0;
  for (std::size_t i = 1; i < want.size(); ++i)
    widest = std::max(widest, angle(want[i], want[i - 1]));
  const auto dark = std::count_if(want.begin(), want.end(), [&](const glm::dvec3& direction) {
    return std::none_of(have.begin(), have.end(), [&](const glm::dvec3& near) {
      return angle(direction, near) <= 2 * widest;
    });
  });
  return 100 * static_cast<double>(dark) / static_cast<double>(want.size());
}

Row measure(int n, const Stage& stage, const Case& by) {
  const Voxels voxels(stage.facets.packets, stage.optics, n, by.choices.owner);
  const std::vector<Sight> sights = stage.sights(n);
  std::vector<RayStart> starts = ray_starts(sights, n);
  starts.resize(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  const RayResult result =
      chapter5::trace(voxels, {{1, 1}, &stage.optics, &starts}, by.choices, false);
  Row row{n, by.name, {}};
  std::vector<glm::dvec3> directions, true_directions;
  for (const Sight& sight : sights)
    true_directions.push_back(glm::reflect(sight.direction, stage.normal));
  for (std::size_t i = 0; i + 1 < result.hits.size(); ++i) {
    const RayHit &first = result.hits[i], &second = result.hits[i + 1];
    if (first.ray.node != 1 || second.ray.node != 2) continue;
    if (second.facet != RayHit::kNoFacet) continue;
    const glm::dvec3 hit = glm::dvec3(second.ray.origin) / double{rays::kPlaceOne};
    const glm::dvec3 direction = glm::normalize(glm::dvec3(second.ray.direction));
    const glm::dvec3 from = hit - glm::distance(hit, stage.source) * direction;
    const double off = glm::distance(from, stage.image);
    row.rays.push_back({hit, direction, from});
    row.mean += off;
    row.largest = std::max(row.largest, off);
    directions.push_back(direction);
  }
  row.lost = static_cast<std::int64_t>(sights.size() - row.rays.size());
  if (!row.rays.empty()) row.mean /= static_cast<double>(row.rays.size());
  row.clouds = count_clouds(row.rays);
  row.dark = dark_share(directions, true_directions);
  return row;
}

void print(const std::vector<Row>& rows) {
  fmt::print("{:>5}  {:<16}{:>6}{:>6}{:>12}{:>14}{:>8}{:>9}\n", "n", "normal, point", "rays",
             "lost", "mean off", "largest off", "clouds", "dark, %");
  for (const Row& row : rows)
    fmt::print("{:>5}  {:<16}{:>6}{:>6}{:>12.2f}{:>14.2f}{:>8}{:>9.1f}\n", row.n, row.name,
               row.rays.size(), row.lost, row.mean, row.largest, row.clouds, row.dark);
}

// Everything that a picture of it needs, in the plane of the rays.
std::string to_csv(const std::vector<Row>& rows, const std::vector<int>& sides) {
  std::string csv = "n,choice,what,x,y,to_x,to_y\n";
  for (const int n : sides) {
    const Stage stage(n);
    csv += fmt::format("{},,source,{},{},,\n{},,image,{:.3f},{:.3f},,\n", n, stage.source.x,
                       stage.source.y, n, stage.image.x, stage.image.y);
    const Voxels voxels(stage.facets.packets, stage.optics, n, chapter5::Owner::core);
    for (const VoxelRecord& voxel : voxels.memory())
      if (voxel.at.z == n / 2) csv += fmt::format("{},,voxel,{},{},,\n", n, voxel.at.x, voxel.at.y);
  }
  for (const Row& row : rows) {
    for (const Seen& seen : row.rays) {
      const auto line = [&](const char* what, const glm::dvec3& at, const glm::dvec3& to) {
        csv += fmt::format("{},\"{}\",{},{:.3f},{:.3f},{:.4f},{:.4f}\n", row.n, row.name, what,
                           at.x, at.y, to.x, to.y);
      };
      line("ray", seen.hit, seen.direction);
      line("from", seen.from, seen.hit);
    }
  }
  return csv;
}

}  // namespace

void declare_virtual_image(Command& program) {
  struct Options {
    std::vector<int> sides = {24, 48, 96};
    std::string out;
  };
  auto options = std::make_shared<Options>();
  Command command = program.command(
      "virtual-image",
      "Where the light of a point seems to come from that a mirror of voxels reflects (5.5.4)");
  declare_list(command, "--n", options->sides, 16, 256, "Sides of the cube, in voxels");
  command.option("--out", options->out, "Write rays and points to this CSV file").type("FILE.csv");
  command.run([options] {
    Outputs outputs;
    if (!options->out.empty()) outputs.add_file(options->out);
    std::vector<Row> rows;
    for (const int n : options->sides) {
      const Stage stage(n);
      for (const Case& by : kCases) rows.push_back(measure(n, stage, by));
    }
    print(rows);
    if (!options->out.empty()) replace_file(options->out, to_csv(rows, options->sides));
    outputs.keep();
    return kDone;
  });
}

}  // namespace rc2
