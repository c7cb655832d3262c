#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <random>

#include "sw/picture/exr.h"
#include "sw/picture/png.h"
#include "sw/picture/render.h"

namespace rc2::picture {
namespace {

namespace fs = std::filesystem;

// A folder of the test's own, gone when the test ends.
class Picture : public testing::Test {
 protected:
  Picture() {
    std::string pattern = (fs::temp_directory_path() / "rc2-picture-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Picture() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool folder_is_empty() const { return fs::is_empty(folder_); }

 private:
  fs::path folder_;
};

constexpr glm::vec3 kUp(0, 0, 1);

// One voxel of facet 0 in the middle of a 5-cube; the tests change what they are about.
struct Subject {
  int n = 5;
  VoxelMemory voxels{{{2, 2, 2}, {0}}};
  std::vector<Lamp> lamps;
  std::vector<facet::FacetInfo> facets{{kUp, 0}};
  std::vector<scene::Material> materials = std::vector<scene::Material>(1);

  Image image() const { return render(n, voxels, lamps, facets, materials); }
  glm::vec3 colour() const {
    const Image made = image();
    return made.colour[made.pixel(2, 2)];
  }
};

Subject lit_from(glm::ivec3 lamp, std::uint32_t arrived = 3) {
  Subject subject;
  subject.lamps = {{lamp, glm::vec3(1), {arrived}}};
  return subject;
}

// Random values everywhere, so that no two channels are alike.
Image noise(int n, std::size_t lights) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share(0, 1);
  Image image;
  image.n = n;
  const auto pixels = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  image.lights.resize(lights);
  for (std::size_t i = 0; i < pixels; ++i) {
    image.colour.emplace_back(share(random), share(random), share(random));
    image.normal.emplace_back(share(random), share(random), share(random));
    image.depth.push_back(i == 0 ? INFINITY : share(random));
    image.facet.push_back(i == 0 ? Image::kNoFacet : static_cast<std::uint32_t>(random() % 999));
    for (auto& light : image.lights) light.push_back(static_cast<std::uint32_t>(random()));
  }
  return image;
}

template <typename Value>
std::vector<Value> read_channel(Imf::InputFile& file, const char* name, Imf::PixelType type) {
  const Imath::Box2i window = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(window.size().x) + 1;
  const auto height = static_cast<std::size_t>(window.size().y) + 1;
  const Imf::Channel* channel = file.header().channels().findChannel(name);
  EXPECT_NE(channel, nullptr) << name;
  if (channel == nullptr) return {};
  EXPECT_EQ(channel->type, type) << name;
  std::vector<Value> values(width * height);
  Imf::FrameBuffer memory;
  memory.insert(name, Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(Value),
                                 sizeof(Value) * width));
  file.setFrameBuffer(memory);
  file.readPixels(window.min.y, window.max.y);
  return values;
}

std::vector<float> component(const std::vector<glm::vec3>& vectors, int axis) {
  std::vector<float> values(vectors.size());
  std::transform(vectors.begin(), vectors.end(), values.begin(),
                 [&](const glm::vec3& vector) { return vector[axis]; });
  return values;
}

TEST_F(Picture, ExrHoldsEveryChannel) {
  const Image image = noise(7, 2);
  write_exr(path("a.exr"), image);

  Imf::InputFile file(path("a.exr").c_str());
  const auto floats = [&](const char* name) { return read_channel<float>(file, name, Imf::FLOAT); };
  const auto counts = [&](const char* name) {
    return read_channel<std::uint32_t>(file, name, Imf::UINT);
  };
  EXPECT_EQ(floats("R"), component(image.colour, 0));
  EXPECT_EQ(floats("G"), component(image.colour, 1));
  EXPECT_EQ(floats("B"), component(image.colour, 2));
  EXPECT_EQ(floats("Z"), image.depth);
  EXPECT_EQ(floats("N.X"), component(image.normal, 0));
  EXPECT_EQ(floats("N.Y"), component(image.normal, 1));
  EXPECT_EQ(floats("N.Z"), component(image.normal, 2));
  EXPECT_EQ(counts("facet.id"), image.facet);
  EXPECT_EQ(counts("light0"), image.lights[0]);
  EXPECT_EQ(counts("light1"), image.lights[1]);
  EXPECT_EQ(file.header().channels().findChannel("light2"), nullptr);
  EXPECT_EQ(file.header().typedAttribute<Imf::IntAttribute>("rc2.n").value(), 7);
  const std::string tool = file.header().typedAttribute<Imf::StringAttribute>("software").value();
  EXPECT_EQ(tool.rfind("RC2 ", 0), 0U) << tool;
}

Raster read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << image.message;
  EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  Raster raster;
  raster.width = static_cast<int>(image.width);
  raster.height = static_cast<int>(image.height);
  raster.pixels.resize(std::size_t{image.width} * image.height);
  EXPECT_NE(png_image_finish_read(&image, nullptr, raster.pixels.data(), 0, nullptr), 0);
  return raster;
}

TEST_F(Picture, PngHoldsThePixels) {
  const Raster raster = develop(noise(6, 0), 20);
  write_png(path("a.png"), raster);

  std::string signature(8, '\0');
  std::ifstream(path("a.png"), std::ios::binary).read(signature.data(), 8);
  EXPECT_EQ(signature, "\x89PNG\r\n\x1a\n");
  const Raster read = read_png(path("a.png"));
  EXPECT_EQ(read.width, 24);
  EXPECT_EQ(read.height, 24);
  EXPECT_EQ(read.pixels, raster.pixels);
}

TEST_F(Picture, UnwritablePathLeavesNoFile) {
  const Image image = noise(3, 1);
  const Raster raster = develop(image);
  EXPECT_THROW(write_exr(path("missing/a.exr"), image), Error);
  EXPECT_THROW(write_png(path("missing/a.png"), raster), Error);
  EXPECT_TRUE(folder_is_empty());

  fs::create_directory(path("taken"));
  EXPECT_THROW(write_exr(path("taken"), image), Error);
  EXPECT_THROW(write_png(path("taken"), raster), Error);
  fs::remove(path("taken"));
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(Picture, SecondPictureReplacesTheFirst) {
  write_png(path("a.png"), develop(noise(6, 0), 1));
  write_png(path("a.png"), develop(noise(2, 0), 1));
  EXPECT_EQ(read_png(path("a.png")).width, 2);
}

TEST(Develop, EnlargesByWholePixelsToAtLeastTheShortestSide) {
  for (const auto& [n, side] :
       std::vector<std::pair<int, int>>{{16, 512}, {100, 600}, {600, 600}}) {
    const Raster raster = develop(noise(n, 0), 512);
    EXPECT_EQ(raster.width, side);
    EXPECT_EQ(raster.height, side);
    EXPECT_EQ(raster.pixels.size(),
              static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  }
}

TEST(Develop, TurnsLinearLightIntoSrgbAndClamps) {
  Image image = noise(2, 0);
  image.colour[image.pixel(0, 1)] = {0, 0.5F, 1};
  image.colour[image.pixel(1, 1)] = {-1, 0.001F, 7};
  const Raster raster = develop(image, 6);
  ASSERT_EQ(raster.width, 6);
  // IEC 61966-2-1: 0.5 is 187.5 of 255, 0.001 lies on the straight part, 12.92 * 0.001 * 255 = 3.3
  const std::array<std::uint8_t, 3> left{0, 188, 255}, right{0, 3, 255};
  for (const std::size_t row : {0U, 1U, 2U}) {
    for (const std::size_t column : {0U, 1U, 2U}) {
      EXPECT_EQ(raster.pixels[row * 6 + column], left);
      EXPECT_EQ(raster.pixels[row * 6 + column + 3], right);
    }
  }
}

TEST(Beside, KeepsBothPicturesWhole) {
  const Raster left = develop(noise(5, 0), 10), right = develop(noise(7, 0), 1);
  const Raster page = beside(left, right);
  ASSERT_GE(page.width, left.width + right.width);
  EXPECT_EQ(page.height, 10);
  EXPECT_EQ(page.pixels.size(), static_cast<std::size_t>(page.width * page.height));
  const auto expect_at = [&](const Raster& picture, int first_column, int first_row) {
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        EXPECT_EQ(page.pixels[(first_row + y) * page.width + first_column + x],
                  picture.pixels[y * picture.width + x]);
      }
    }
  };
  expect_at(left, 0, 0);
  expect_at(right, page.width - right.width, 1);
}

TEST(Render, ShowsTheForemostVoxelOfEachColumn) {
  Subject subject;
  subject.n = 4;
  subject.voxels = {{{1, 3, 0}, {0}}, {{2, 3, 1}, {1}}, {{1, 3, 2}, {1}}};
  subject.facets = {{kUp, 0}, {{1, 0, 0}, 1}};
  subject.materials.resize(2);
  subject.lamps = {{{0, 0, 0}, glm::vec3(1), {5, 6, 7}}, {{0, 0, 0}, glm::vec3(1), {0, 9, 1}}};
  const Image image = subject.image();
  // Row 0 is the top of the picture, y = n-1.
  EXPECT_EQ(image.facet[1], 1U);
  EXPECT_EQ(image.normal[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(image.depth[1], 1.5F);
  EXPECT_EQ(image.depth[2], 2.5F);
  EXPECT_EQ(image.lights[0][1], 7U);
  EXPECT_EQ(image.lights[1][1], 1U);
  EXPECT_EQ(image.lights[1][2], 9U);
  for (std::size_t pixel = 0; pixel < 16; ++pixel) {
    if (pixel == 1 || pixel == 2) continue;
    EXPECT_EQ(image.facet[pixel], Image::kNoFacet);
    EXPECT_TRUE(std::isinf(image.depth[pixel]));
    EXPECT_EQ(image.lights[0][pixel], 0U);
  }
}

TEST(Render, UnlitVoxelHasOnlyAmbientAndEmission) {
  Subject dark;
  const glm::vec3 ambient = dark.colour();
  EXPECT_GT(ambient.r, 0);
  EXPECT_EQ(lit_from({2, 2, 4}, 0).colour(), ambient);

  dark.materials[0].emission = {0.25F, 0.5F, 0};
  EXPECT_EQ(dark.colour(), ambient + dark.materials[0].emission);

  dark.materials[0] = {};
  dark.materials[0].diffuse = {0, 0.4F, 0.8F};
  EXPECT_EQ(dark.colour().r, 0);
  EXPECT_FLOAT_EQ(dark.colour().b, 2 * dark.colour().g);
}

TEST(Render, LightCountsByItsAngle) {
  const glm::vec3 ambient = Subject().colour();
  const Subject straight = lit_from({2, 2, 4}), aslant = lit_from({4, 2, 2 + 1}),
                behind = lit_from({2, 2, 0});
  EXPECT_GT(straight.colour().r, aslant.colour().r);
  EXPECT_GT(aslant.colour().r, ambient.r);
  EXPECT_EQ(behind.colour(), ambient);
  // Lambert and the fading with distance: 0.8 N.L / (1 + d^2 / n^2).
  EXPECT_NEAR(straight.colour().r - ambient.r, 0.8 / (1 + 4.0 / 25), 1e-6);
  EXPECT_NEAR(aslant.colour().r - ambient.r, 0.8 / std::sqrt(5.0) / (1 + 5.0 / 25), 1e-6);
}

TEST(Render, HowManyTargetsArriveDoesNotMatter) {
  EXPECT_EQ(lit_from({2, 2, 4}, 1).colour(), lit_from({2, 2, 4}, 1000).colour());
}

TEST(Render, NearLightIsBrighter) {
  EXPECT_GT(lit_from({2, 2, 3}).colour().r, lit_from({2, 2, 4}).colour().r);
}

TEST(Render, LightsAddUpAndKeepTheirColour) {
  Subject both = lit_from({2, 2, 4});
  const glm::vec3 one = both.colour() - Subject().colour();
  both.lamps.push_back(both.lamps[0]);
  both.lamps[1].colour = {0, 2, 0};
  const glm::vec3 added = both.colour() - Subject().colour();
  EXPECT_NEAR(added.r, one.r, 1e-6);
  EXPECT_NEAR(added.g, 3 * one.g, 1e-6);
}

TEST(Render, SheetHasTwoSides) {
  Subject front = lit_from({3, 1, 4}), back = front;
  front.facets[0].normal = glm::normalize(glm::vec3(1, 2, 3));
  back.facets[0].normal = -front.facets[0].normal;
  EXPECT_EQ(front.colour(), back.colour());
  EXPECT_EQ(front.image().normal, back.image().normal);
}

TEST(Render, HighlightIsWhereTheHalfVectorIsTheNormal) {
  Subject shiny = lit_from({4, 2, 2});
  shiny.materials[0].specular = glm::vec3(1);
  shiny.materials[0].shininess = 40;
  Subject matt = shiny;
  matt.materials[0].specular = glm::vec3(0);
  const auto highlight = [&](glm::vec3 normal) {
    shiny.facets[0].normal = matt.facets[0].normal = glm::normalize(normal);
    return shiny.colour().r - matt.colour().r;
  };
  // The light comes from +x and leaves to +z: their half vector is (1,0,1).
  const float middle = highlight({1, 0, 1});
  EXPECT_NEAR(middle, 1 / (1 + 4.0 / 25), 1e-5);
  EXPECT_LT(highlight({1, 0, 2}), middle);
  EXPECT_LT(highlight({2, 0, 1}), middle);
  EXPECT_LT(highlight({1, 1, 1}), middle);
  shiny.materials[0].shininess = 0;
  EXPECT_EQ(highlight({1, 0, 1}), 0);
}

TEST(Render, LooksTheSameAtEverySize) {
  Subject small = lit_from({3, 1, 4}), large;
  large.n = 50;
  large.voxels = {{{20, 20, 20}, {0}}};
  large.lamps = {{{30, 10, 40}, glm::vec3(1), {1}}};
  const Image image = large.image();
  EXPECT_NEAR(image.colour[image.pixel(20, 20)].r, small.colour().r, 1e-6);
}

TEST(Render, RefusesWhatDoesNotBelongTogether) {
  Subject other_light = lit_from({2, 2, 4});
  other_light.lamps[0].arrived.push_back(1);
  EXPECT_THROW(other_light.image(), Error);
  Subject other_facets;
  other_facets.voxels[0].owner.facet = 1;
  EXPECT_THROW(other_facets.image(), Error);
  Subject other_materials;
  other_materials.materials.clear();
  EXPECT_THROW(other_materials.image(), Error);
}

}  // namespace
}  // namespace rc2::picture
