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

// Where a ray ended and how many voxels it went.
struct End {
  std::ptrdiff_t place;
  std::int64_t steps;
};

End follow_ray(const Grid& grid, std::ptrdiff_t start, int distance, const Faces& faces, int side,
               int u, int v) {
  lines::DigitalLine u_line(u, distance);
  lines::DigitalLine v_line(v, distance);
  End end{start, 0};
  do {
    end.place += side * grid.stride(faces.axis) + u_line.advance() * grid.stride(faces.u) +
                 v_line.advance() * grid.stride(faces.v);
    ++end.steps;
  } while (grid[end.place] == Grid::kFree);
  return end;
}

}  // namespace

Diffusion diffuse(const Grid& grid, glm::ivec3 source, int distance, LightMemory& arrived,
                  const Progress& progress) {
  Diffusion result;
  result.targets.total = total_targets(distance);
  const std::ptrdiff_t start = grid.index(source);
  for (const Faces& faces : kFaces) {
    const int u_end = distance - faces.narrow_u;
    const int v_end = distance - faces.narrow_v;
    for (const int side : {-1, 1}) {
      for (int v = -v_end; v <= v_end; ++v) {
        for (int u = -u_end; u <= u_end; ++u) {
          const End end = follow_ray(grid, start, distance, faces, side, u, v);
          if (grid[end.place] == Grid::kOutside) {
            ++result.targets.escaped;
            result.visits += end.steps - 1;
          } else {
            ++result.targets.absorbed;
            result.visits += end.steps;
            ++arrived[grid[end.place]];
          }
        }
        if (progress) {
          const std::int64_t done = result.targets.absorbed + result.targets.escaped;
          progress("light", 0,
                   static_cast<double>(done) / static_cast<double>(result.targets.total));
        }
      }
    }
  }
  return result;
}

}  // namespace rc2::golden
