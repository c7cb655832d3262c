#include "sw/golden/diffuse.h"

#include "sw/lines/digital_line.h"

namespace rc2::golden {
namespace {

// A pair of opposite faces: the axis they look along, the axes of their targets (U, V) and by how
// much the range of targets is narrower than -L .. L on each side.
struct Faces {
  int axis, u, v;
  int narrow_u, narrow_v;
};

// The narrowing gives each target on an edge of the big cube to exactly one face.
constexpr Faces kFaces[] = {{0, 1, 2, 0, 0}, {1, 0, 2, 1, 0}, {2, 0, 1, 1, 1}};

class Diffuser {
 public:
  Diffuser(const Grid& grid, const std::vector<Matter>& field, LightMemory& arrived)
      : grid_(grid), field_(field), arrived_(arrived) {}

  void follow_ray(std::ptrdiff_t start, int distance, const Faces& faces, int side, int u, int v) {
    lines::DigitalLine u_line(u, distance);
    lines::DigitalLine v_line(v, distance);
    std::ptrdiff_t place = start;
    for (;;) {
      glm::ivec3 step;
      step[faces.axis] = side;
      step[faces.u] = u_line.advance();
      step[faces.v] = v_line.advance();
      place += step.x * grid_.stride(0) + step.y * grid_.stride(1) + step.z * grid_.stride(2);
      const Matter matter = field_[static_cast<std::size_t>(place)];
      if (matter == Matter::outside) {
        ++result_.targets.escaped;
        return;
      }
      ++result_.visits;
      if (is_lit(matter)) ++arrived_[grid_[place]];
      if (ends_light(matter)) {
        ++result_.targets.absorbed;
        return;
      }
    }
  }

  Diffusion& result() { return result_; }

 private:
  const Grid& grid_;
  const std::vector<Matter>& field_;
  LightMemory& arrived_;
  Diffusion result_;
};

}  // namespace

Diffusion diffuse(const Grid& grid, const std::vector<Matter>& field, glm::ivec3 source,
                  int distance, LightMemory& arrived, const Progress& progress) {
  Diffuser diffuser(grid, field, arrived);
  TargetCount& targets = diffuser.result().targets;
  targets.total = total_targets(distance);
  const std::ptrdiff_t start = grid.index(source);
  for (const Faces& faces : kFaces) {
    const int u_end = distance - faces.narrow_u;
    const int v_end = distance - faces.narrow_v;
    for (const int side : {-1, 1}) {
      for (int v = -v_end; v <= v_end; ++v) {
        for (int u = -u_end; u <= u_end; ++u)
          diffuser.follow_ray(start, distance, faces, side, u, v);
        if (progress) {
          const std::int64_t done = targets.absorbed + targets.escaped;
          progress("light", 0, static_cast<double>(done) / static_cast<double>(targets.total));
        }
      }
    }
  }
  return diffuser.result();
}

}  // namespace rc2::golden
