#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "sw/picture/difference.h"

namespace rc2::picture {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPixelsPerDegree = 0.7 * 3840 / 0.7 * kPi / 180;

using Plane = std::vector<glm::dvec3>;

// Linear RGB to XYZ, by columns.
const glm::dmat3 kToXyz{{10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382},
                        {8788810.0 / 24577794, 8788810.0 / 12288897, 8788810.0 / 73733382},
                        {4435075.0 / 24577794, 887015.0 / 12288897, 70074185.0 / 73733382}};
const glm::dvec3 kWhite = kToXyz * glm::dvec3(1);

glm::dvec3 opponent(const glm::dvec3& rgb) {
  const glm::dvec3 t = kToXyz * rgb / kWhite;
  return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

glm::dvec3 rgb_of_opponent(const glm::dvec3& c) {
  const double y = (c.x + 16) / 116;
  return glm::inverse(kToXyz) * (glm::dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite);
}

// CIELAB, less colourful where it is dark (Hunt).
glm::dvec3 lab(const glm::dvec3& rgb) {
  constexpr double kDelta = 6.0 / 29;
  const auto root = [](double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const glm::dvec3 t = kToXyz * rgb / kWhite;
  const double y = root(t.y), lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (root(t.x) - y),
          0.01 * lightness * 200 * (y - root(t.z))};
}

double distance(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + glm::length(glm::dvec2(a.y - b.y, a.z - b.z));
}

// A square filter of three channels.
struct Filter {
  int radius;
  std::vector<glm::dvec3> weight;

  Filter(int filter_radius, const std::function<glm::dvec3(double, double)>& at)
      : radius(filter_radius) {
    for (int y = -radius; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x) weight.push_back(at(x, y));
  }
};

// The border's pixels go on beyond it.
Plane convolve(const Plane& plane, int n, const Filter& filter) {
  Plane result;
  result.reserve(plane.size());
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      glm::dvec3 sum(0);
      const glm::dvec3* weight = filter.weight.data();
      for (int v = -filter.radius; v <= filter.radius; ++v) {
        const auto row = plane.begin() + std::ptrdiff_t{std::clamp(y + v, 0, n - 1)} * n;
        for (int u = -filter.radius; u <= filter.radius; ++u)
          sum += *weight++ * row[std::clamp(x + u, 0, n - 1)];
      }
      result.push_back(sum);
    }
  }
  return result;
}

// What the eye sees of fine detail: Gaussians for lightness, red to green, and, two of them, blue
// to yellow.
Filter contrast_filter() {
  const auto gauss = [](double square, double a, double b) {
    return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * square / b);
  };
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * kPixelsPerDegree));
  Filter filter(radius, [&](double x, double y) {
    const double square = (x * x + y * y) / (kPixelsPerDegree * kPixelsPerDegree);
    return glm::dvec3(gauss(square, 1, 0.0047), gauss(square, 1, 0.0053),
                      gauss(square, 34.1, 0.04) + gauss(square, 13.5, 0.025));
  });
  glm::dvec3 sum(0);
  for (const glm::dvec3& w : filter.weight) sum += w;
  for (glm::dvec3& w : filter.weight) w /= sum;
  return filter;
}

// Slopes (channel 0) and bends (channel 1) of the lightness along x, or along y.
Filter feature_filter(bool along_y) {
  const double deviation = 0.5 * 0.082 * kPixelsPerDegree, square = deviation * deviation;
  Filter filter(static_cast<int>(std::ceil(3 * deviation)), [&](double x, double y) {
    const double g = std::exp(-(x * x + y * y) / (2 * square)), along = along_y ? y : x;
    return glm::dvec3(-along * g, (along * along / square - 1) * g, 0);
  });
  glm::dvec3 positive(0), negative(0);
  for (const glm::dvec3& w : filter.weight) {
    positive += glm::max(w, 0.0);
    negative -= glm::min(w, 0.0);
  }
  for (glm::dvec3& w : filter.weight)
    for (int i = 0; i < 2; ++i) w[i] /= w[i] > 0 ? positive[i] : negative[i];
  return filter;
}

// A picture as the eye takes it in: its colours, and the strength of its edges and points.
struct Seen {
  Plane colour;
  std::vector<glm::dvec2> feature;
};

Seen look_at(const Image& image) {
  Plane plane, lightness;
  for (const glm::vec3& pixel : image.colour) {
    plane.push_back(opponent(glm::clamp(glm::dvec3(pixel), 0.0, 1.0)));
    lightness.emplace_back((plane.back().x + 16) / 116);
  }
  Seen seen;
  for (const glm::dvec3& pixel : convolve(plane, image.n, contrast_filter()))
    seen.colour.push_back(lab(glm::clamp(rgb_of_opponent(pixel), 0.0, 1.0)));
  const Plane x = convolve(lightness, image.n, feature_filter(false));
  const Plane y = convolve(lightness, image.n, feature_filter(true));
  for (std::size_t i = 0; i < x.size(); ++i)
    seen.feature.emplace_back(std::hypot(x[i].x, y[i].x), std::hypot(x[i].y, y[i].y));
  return seen;
}

// Small differences are spread over most of 0..1, the large ones pressed together.
double spread(double difference) {
  const double most = std::pow(distance(lab({0, 1, 0}), lab({0, 0, 1})), 0.7);
  const double knee = 0.4 * most;
  return difference < knee ? 0.95 / knee * difference
                           : 0.95 + (difference - knee) / (most - knee) * 0.05;
}

}  // namespace

double flip(const Image& image, const Image& reference) {
  const Seen a = look_at(image), b = look_at(reference);
  double sum = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    const double colour = spread(std::pow(distance(a.colour[i], b.colour[i]), 0.7));
    const glm::dvec2 apart = glm::abs(a.feature[i] - b.feature[i]);
    const double feature = std::sqrt(std::max(apart.x, apart.y) / std::sqrt(2.0));
    sum += std::pow(colour, 1 - feature);
  }
  return sum / static_cast<double>(a.colour.size());
}

}  // namespace rc2::picture
