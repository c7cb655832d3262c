#include "sim/line_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "sw/lines/connectivity.h"

namespace rc2 {
namespace {

using lines::VoxelSet;

constexpr double kPanel = 560;   // pixels of the longer side of a panel, if its cubes may be small
constexpr double kLargest = 28;  // pixels per voxel
constexpr int kFine = 3;         // each pixel is the mean of this many squared
constexpr double kLine = 0.07;   // half the width of the segment, in voxels

constexpr glm::dvec3 kPaper(255), kInk(20), kBlue(110, 150, 215), kOrange(245, 150, 50);

// x goes to the lower right, y to the lower left, z up; the picture's second axis goes down.
glm::dvec2 project(glm::dvec3 at) {
  return {(at.x - at.y) * std::sqrt(0.75), (at.x + at.y) / 2 - at.z};
}

class Panel {
 public:
  Panel(glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec2 a = project(from), b = project(to);
    const glm::dvec2 margin(2.0);
    low_ = glm::min(a, b) - margin;
    const glm::dvec2 extent = glm::max(a, b) + margin - low_;
    const double scale = std::clamp(kPanel / std::max(extent.x, extent.y), 1.0, kLargest);
    width_ = static_cast<int>(std::ceil(extent.x * scale));
    height_ = static_cast<int>(std::ceil(extent.y * scale));
    scale_ = scale * kFine;
    fine_.assign(
        static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * kFine * kFine,
        kPaper);
  }

  // Fills a convex quadrilateral given in voxels of the projection, corners in turn.
  void fill(std::array<glm::dvec2, 4> corners, glm::dvec3 colour) {
    glm::dvec2 low(1e9), high(-1e9);
    for (glm::dvec2& corner : corners) {
      corner = (corner - low_) * scale_;
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    const glm::ivec2 limit(width_ * kFine - 1, height_ * kFine - 1);
    const glm::ivec2 first = glm::clamp(glm::ivec2(glm::floor(low)), glm::ivec2(0), limit);
    const glm::ivec2 last = glm::clamp(glm::ivec2(glm::ceil(high)), glm::ivec2(0), limit);
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        if (is_inside(corners, glm::dvec2(x, y) + 0.5)) fine_[index(x, y)] = colour;
  }

  picture::Raster develop() const {
    picture::Raster raster;
    raster.width = width_;
    raster.height = height_;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        glm::dvec3 sum(0);
        for (int i = 0; i < kFine * kFine; ++i)
          sum += fine_[index(x * kFine + i % kFine, y * kFine + i / kFine)];
        const glm::ivec3 mean(glm::round(sum / double{kFine * kFine}));
        raster.pixels.push_back({static_cast<std::uint8_t>(mean.r),
                                 static_cast<std::uint8_t>(mean.g),
                                 static_cast<std::uint8_t>(mean.b)});
      }
    }
    return raster;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * kFine) +
           static_cast<std::size_t>(x);
  }

  static bool is_inside(const std::array<glm::dvec2, 4>& corners, glm::dvec2 at) {
    bool left = true, right = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 along = corners[(i + 1) % corners.size()] - corners[i];
      const glm::dvec2 to = at - corners[i];
      const double side = along.x * to.y - along.y * to.x;
      left = left && side >= 0;
      right = right && side <= 0;
    }
    return left || right;
  }

  glm::dvec2 low_;
  double scale_;
  int width_, height_;
  std::vector<glm::dvec3> fine_;
};

// The three faces of a cube that the viewer sees, each with a dark rim.
void draw_cube(Panel& panel, glm::dvec3 centre, glm::dvec3 colour) {
  constexpr std::array<double, 3> kShade = {0.85, 0.65, 1.0};  // of the faces that x, y, z leave by
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 out(0), u(0), v(0);
    out[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 0.5;
    const auto face = [&](double size) {
      const glm::dvec3 middle = centre + out;
      return std::array<glm::dvec2, 4>{
          project(middle - size * (u + v)), project(middle + size * (u - v)),
          project(middle + size * (u + v)), project(middle - size * (u - v))};
    };
    panel.fill(face(1.0), 0.4 * colour);
    panel.fill(face(0.9), kShade[static_cast<std::size_t>(axis)] * colour);
  }
}

void draw_segment(Panel& panel, glm::dvec3 from, glm::dvec3 to) {
  const glm::dvec2 a = project(from), b = project(to);
  if (a == b) return;
  const glm::dvec2 along = glm::normalize(b - a) * kLine, across(-along.y, along.x);
  panel.fill({a - across, a + across, b + across, b - across}, kInk);
}

picture::Raster stack(const std::vector<picture::Raster>& panels) {
  const bool in_rows = panels.front().width >= panels.front().height;
  picture::Raster page;
  for (const picture::Raster& panel : panels) {
    page.width = in_rows ? panel.width : page.width + panel.width;
    page.height = in_rows ? page.height + panel.height : panel.height;
  }
  page.pixels.reserve(static_cast<std::size_t>(page.width) * static_cast<std::size_t>(page.height));
  for (int row = 0; row < page.height; ++row) {
    for (std::size_t i = 0; i < (in_rows ? 1 : panels.size()); ++i) {
      const int height = panels.front().height;
      const picture::Raster& panel =
          in_rows ? panels[static_cast<std::size_t>(row / height)] : panels[i];
      const auto begin = panel.pixels.begin() + std::ptrdiff_t{row % height} * panel.width;
      page.pixels.insert(page.pixels.end(), begin, begin + panel.width);
    }
  }
  return page;
}

}  // namespace

picture::Raster draw_lines(glm::ivec3 from, glm::ivec3 to,
                           const std::vector<std::vector<glm::ivec3>>& drawings) {
  const VoxelSet first(drawings.front().begin(), drawings.front().end());
  std::vector<picture::Raster> panels;
  for (std::vector<glm::ivec3> voxels : drawings) {
    // From the farthest to the nearest, so that near cubes hide far ones.
    std::sort(voxels.begin(), voxels.end(),
              [](glm::ivec3 a, glm::ivec3 b) { return a.x + a.y + a.z < b.x + b.y + b.z; });
    Panel panel(from, to);
    for (const glm::ivec3& at : voxels)
      draw_cube(panel, at, first.count(at) != 0 ? kBlue : kOrange);
    draw_segment(panel, from, to);
    panels.push_back(panel.develop());
  }
  return stack(panels);
}

}  // namespace rc2
