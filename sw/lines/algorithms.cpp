#include "sw/lines/algorithms.h"

#include "sw/lines/amanatides_woo.h"
#include "sw/lines/bresenham.h"
#include "sw/lines/dda.h"
#include "sw/lines/dichotomic.h"
#include "sw/lines/loceff.h"

namespace rc2::lines {
namespace {

using Voxels = std::vector<glm::ivec3>;

auto append_to(Voxels& voxels) {
  return [&voxels](glm::ivec3 at) { voxels.push_back(at); };
}

void draw_bresenham(glm::ivec3 from, glm::ivec3 to, Voxels& voxels) {
  bresenham(from, to, append_to(voxels));
}

void draw_dda(glm::ivec3 from, glm::ivec3 to, Voxels& voxels) { dda(from, to, append_to(voxels)); }

void draw_dichotomic(glm::ivec3 from, glm::ivec3 to, Voxels& voxels) {
  dichotomic(from, to, append_to(voxels));
}

void draw_loceff(glm::ivec3 from, glm::ivec3 to, Voxels& voxels) {
  loceff(from, to, append_to(voxels));
}

void draw_amanatides_woo(glm::ivec3 from, glm::ivec3 to, Voxels& voxels) {
  amanatides_woo(from, to, append_to(voxels));
}

}  // namespace

const std::array<Algorithm, 5> kAlgorithms = {{
    {"bresenham", "2.3.1", Adjacency::corner, draw_bresenham},
    {"dda", "2.3.2", Adjacency::corner, draw_dda},
    {"dichotomic", "2.3.3", Adjacency::corner, draw_dichotomic},
    {"loceff", "2.3.4", Adjacency::corner, draw_loceff},
    {"amanatides-woo", "2.3.5", Adjacency::face, draw_amanatides_woo},
}};

}  // namespace rc2::lines
