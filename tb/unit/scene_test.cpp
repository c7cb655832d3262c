#include "sw/scene/scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "sw/base/error.h"

namespace rc2::scene {
namespace {

// Debian's assimp-testmodels.
const std::filesystem::path kModels = "/usr/share/assimp/models";

using Key = std::tuple<double, double, double>;

Key key(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

std::pair<glm::dvec3, glm::dvec3> extent(const Scene& scene) {
  glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const glm::dvec3& p : scene.vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {low, high};
}

// Closed and consistently oriented: every side is used once in each direction.
void expect_closed(const Scene& scene) {
  std::map<std::pair<Key, Key>, int> sides;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    const std::uint32_t first = scene.first[i], count = scene.first[i + 1] - first;
    for (std::uint32_t k = 0; k < count; ++k)
      ++sides[{key(scene.vertices[first + k]), key(scene.vertices[first + (k + 1) % count])}];
  }
  for (const auto& [side, uses] : sides) {
    const auto back = sides.find({side.second, side.first});
    ASSERT_EQ(uses, 1);
    ASSERT_TRUE(back != sides.end());
  }
}

// Six times the volume inside the mesh; negative if it is inside out.
double six_volumes(const Scene& scene) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i) {
    const glm::dvec3* p = &scene.vertices[scene.first[i]];
    for (std::uint32_t k = 2; k < scene.first[i + 1] - scene.first[i]; ++k)
      sum += glm::dot(p[0], glm::cross(p[k - 1], p[k]));
  }
  return sum;
}

// A file of this process that goes when the test ends.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text) : path_(folder() / name) {
    std::filesystem::create_directories(folder());
    std::ofstream(path_, std::ios::binary) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::filesystem::remove(path_);
    std::error_code not_empty;
    std::filesystem::remove(folder(), not_empty);
  }
  std::string path() const { return path_.string(); }

 private:
  static std::filesystem::path folder() {
    return std::filesystem::path(testing::TempDir()) / ("rc2_scene_" + std::to_string(getpid()));
  }
  std::filesystem::path path_;
};

std::string error_of(const std::string& path) {
  try {
    read_file(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> model_files(const std::vector<std::string>& folders) {
  std::vector<std::string> files;
  for (const std::string& folder : folders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kModels / folder))
      if (entry.is_regular_file()) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

struct Model {
  const char* file;
  std::size_t polygons;
};

class ReadModel : public testing::TestWithParam<Model> {};

TEST_P(ReadModel, HasItsPolygonsInRange) {
  Scene scene = read_file((kModels / GetParam().file).string());
  if (GetParam().polygons != 0) {
    EXPECT_EQ(scene.polygon_count(), GetParam().polygons);
  }
  EXPECT_GT(scene.polygon_count(), 0U);
  ASSERT_EQ(scene.first.size(), scene.polygon_count() + 1);
  EXPECT_EQ(scene.first.back(), scene.vertices.size());
  for (const std::uint32_t material : scene.material) ASSERT_LT(material, scene.materials.size());
  for (std::size_t i = 0; i < scene.polygon_count(); ++i)
    ASSERT_GE(scene.first[i + 1] - scene.first[i], 3U);

  constexpr int kSide = 64;
  fit_to_cube(scene, kSide);
  const auto [low, high] = extent(scene);
  const glm::dvec3 size = high - low;
  EXPECT_NEAR(std::max({size.x, size.y, size.z}), kSide - 3.0, 1e-9);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(low[axis] + high[axis], kSide - 1.0, 1e-9);
    EXPECT_GE(low[axis], 1.0 - 1e-9);
    EXPECT_LE(high[axis], kSide - 2.0 + 1e-9);
  }
}

// Counts are what the files say; 0 where Assimp makes the polygons of solids and spheres.
INSTANTIATE_TEST_SUITE_P(
    Formats, ReadModel,
    testing::Values(Model{"Collada/duck.dae", 2144}, Model{"Collada/teapots.DAE", 2976},
                    Model{"OBJ/spider.obj", 1368}, Model{"OBJ/box.obj", 6},
                    Model{"IFC/AC14-FZK-Haus.ifc", 0}, Model{"BLEND/HUMAN.blend", 4280},
                    Model{"BLEND/SuzanneSubdiv_252.blend", 125952},
                    Model{"glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", 121496},
                    Model{"glTF2/BoxTextured-glTF/BoxTextured.gltf", 12},
                    Model{"glTF/BoxTextured-glTF/BoxTextured.gltf", 12},
                    Model{"PLY/Wuson.ply", 3732}, Model{"STL/Wuson.stl", 3732},
                    Model{"NFF/NFF/WithCamera.nff", 0}, Model{"3DS/fels.3ds", 768},
                    Model{"OFF/Cube.off", 6}, Model{"X/Testwuson.X", 3732}));

TEST(ReadFile, PlacesCameraAndLights) {
  const Scene camera = read_file((kModels / "NFF/NFF/WithCamera.nff").string());
  ASSERT_TRUE(camera.camera.has_value());
  EXPECT_NEAR(glm::distance(camera.camera->position, {0, 3, 10}), 0.0, 1e-6);
  EXPECT_GT(camera.camera->angle, 0.1);

  // One sun, one ambient light and three with a place.
  const Scene lights = read_file((kModels / "Collada/lights.dae").string());
  EXPECT_EQ(lights.lights.size(), 3U);
  EXPECT_EQ(lights.ignored_lights, 2);
}

TEST(ReadFile, TurnsUpright) {
  // People and houses are taller than their feet and cellars are deep.
  const auto [low, high] = extent(read_file((kModels / "BLEND/HUMAN.blend").string()));
  EXPECT_GT(high.y - low.y, high.x - low.x);
  EXPECT_GT(high.y - low.y, high.z - low.z);
  const auto [bottom, top] = extent(read_file((kModels / "IFC/AC14-FZK-Haus.ifc").string()));
  EXPECT_LT(top.y - bottom.y, top.x - bottom.x);
  EXPECT_LT(top.y - bottom.y, top.z - bottom.z);
}

TEST(ReadFile, KeepsOutsidesOfMirroredNodes) {
  const Scene scene = read_file((kModels / "BLEND/MirroredCube_252.blend").string());
  EXPECT_GT(six_volumes(scene), 0.0);
  // The same tetrahedron placed as it is and mirrored: both enclose a positive volume.
  const TemporaryFile file("mirrored.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0,1]}],
    "nodes":[{"mesh":0},{"mesh":0,"scale":[-1,1,1],"translation":[-4,0,0]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":1},"indices":0}]}],
    "accessors":[
      {"bufferView":0,"componentType":5123,"count":12,"type":"SCALAR"},
      {"bufferView":1,"componentType":5126,"count":4,"type":"VEC3",
       "min":[0,0,0],"max":[1,1,1]}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":24},
                   {"buffer":0,"byteOffset":24,"byteLength":48}],
    "buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,)"
                                            "AAACAAEAAAABAAMAAAADAAIAAQACAAMA"
                                            "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAA"
                                            "AAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
                                            R"("}]})");
  const Scene pair = read_file(file.path());
  ASSERT_EQ(pair.polygon_count(), 8U);
  expect_closed(pair);
  EXPECT_NEAR(six_volumes(pair), 2.0, 1e-9);
}

// Normals turn as planes do, not as points: under scales that differ, and in a mirror.
TEST(ReadFile, KeepsNormalsUpright) {
  const TemporaryFile file("scaled.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[-1,2,4]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":1,"NORMAL":2},"indices":0}]}],
    "accessors":[
      {"bufferView":0,"componentType":5123,"count":3,"type":"SCALAR"},
      {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3",
       "min":[0,0,0],"max":[1,1,1]},
      {"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":6},
                   {"buffer":0,"byteOffset":8,"byteLength":36},
                   {"buffer":0,"byteOffset":44,"byteLength":36}],
    "buffers":[{"byteLength":80,"uri":"data:application/octet-stream;base64,)"
                                          "AAABAAIAAAAAAIA/AAAAAAAAAAAAAAAA"
                                          "AACAPwAAAAAAAAAAAAAAAAAAgD86zRM/"
                                          "Os0TPzrNEz86zRM/Os0TPzrNEz86zRM/"
                                          "Os0TPzrNEz8="
                                          R"("}]})");
  const Scene scene = read_file(file.path());
  ASSERT_EQ(scene.normals.size(), 3U);
  const glm::dvec3 outside = glm::normalize(
      glm::cross(scene.vertices[1] - scene.vertices[0], scene.vertices[2] - scene.vertices[0]));
  for (const glm::dvec3& normal : scene.normals) EXPECT_LT(glm::distance(normal, outside), 1e-6);
}

TEST(ReadFile, KnowsNoNormalsWhereThereAreNone) {
  const TemporaryFile file("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_file(file.path()).normals, std::vector<glm::dvec3>(3, glm::dvec3(0)));
}

TEST(ReadFile, ReadsMaterials) {
  const TemporaryFile library("glass.mtl",
                              "newmtl glass\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nKe 0.7 0.8 0.9\n"
                              "Ns 32\nd 0.25\nNi 1.5\nillum 2\n");
  const TemporaryFile file("glass.obj",
                           "mtllib glass.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                           "usemtl glass\nf 1 2 3 4\nl 1 5\n");
  const Scene scene = read_file(file.path());
  ASSERT_EQ(scene.polygon_count(), 1U);
  EXPECT_EQ(scene.first[1], 4U);
  EXPECT_EQ(scene.ignored_primitives, 1);
  const Material& glass = scene.materials[scene.material[0]];
  EXPECT_EQ(glass.name, "glass");
  EXPECT_NEAR(glass.diffuse.y, 0.2F, 1e-6F);
  EXPECT_NEAR(glass.specular.z, 0.6F, 1e-6F);
  EXPECT_NEAR(glass.emission.x, 0.7F, 1e-6F);
  EXPECT_NEAR(glass.shininess, 32.0F, 1e-4F);
  EXPECT_NEAR(glass.transparency, 0.75F, 1e-6F);
  EXPECT_NEAR(glass.refractive_index, 1.5F, 1e-6F);
}

TEST(ReadFile, ReadsGltfLightsAndMetal) {
  const TemporaryFile file("lit.gltf", R"({"asset":{"version":"2.0"},"scene":0,
    "extensionsUsed":["KHR_lights_punctual","KHR_materials_transmission"],
    "extensions":{"KHR_lights_punctual":{"lights":[
      {"type":"point","color":[1,0.5,0.25],"intensity":40},
      {"type":"directional","color":[1,1,1],"intensity":2}]}},
    "scenes":[{"nodes":[0,1,2]}],
    "nodes":[{"mesh":0},
      {"name":"bulb","translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}},
      {"name":"sun","extensions":{"KHR_lights_punctual":{"light":1}}}],
    "materials":[{"name":"metal","pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0.1},
      "extensions":{"KHR_materials_transmission":{"transmissionFactor":0.5}}}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
                  "min":[0,0,0],"max":[1,1,0]}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
                                       "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAA"
                                       "AAAAAAAAgD8AAAAA"
                                       R"("}]})");
  const Scene scene = read_file(file.path());
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_EQ(scene.ignored_lights, 1);
  EXPECT_NEAR(glm::distance(scene.lights[0].position, {1, 2, 3}), 0.0, 1e-6);
  EXPECT_NEAR(scene.lights[0].colour.x, 1.0F, 1e-5F);
  EXPECT_NEAR(scene.lights[0].colour.z, 0.25F, 1e-5F);
  const Material& metal = scene.materials[scene.material[0]];
  EXPECT_NEAR(metal.mirror, 0.81F, 1e-5F);
  EXPECT_NEAR(metal.transparency, 0.5F, 1e-5F);
}

TEST(ReadFile, RefusesOrReadsEveryMalformedFile) {
  std::size_t refused = 0;
  for (const std::string& file : model_files(
           {"invalid", "glTF2/wrongTypes", "glTF2/IndexOutOfRange", "glTF2/IncorrectVertexArrays",
            "glTF2/SchemaFailures", "glTF2/MissingBin", "glTF2/RecursiveNodes",
            "glTF2/TestNoRootNode", "glTF2/issue_3269", "glTF2/BoxWithInfinites-glTF-Binary",
            "glTF2/BoxBadNormals-glTF-Binary", "glTF/IncorrectVertexArrays"})) {
    SCOPED_TRACE(file);
    const std::string message = error_of(file);  // anything but an Error ends the test
    if (message.empty()) continue;
    ++refused;
    EXPECT_EQ(message.rfind(file, 0), 0U) << message;
    EXPECT_NE(message.find(';'), std::string::npos) << "says no remedy: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_GE(refused, 30U);
}

TEST(ReadFile, RefusesWhatHasNoPolygons) {
  EXPECT_NE(error_of("no/such/file.obj").find("no such file"), std::string::npos);
  const TemporaryFile points("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 3\n");
  EXPECT_FALSE(error_of(points.path()).empty());
  EXPECT_NE(error_of((kModels / "PLY/pond.0.ply").string()).find("no polygon"), std::string::npos);
}

TEST(ReadFile, RefusesVerticesThatAreNotNumbers) {
  const std::string infinite =
      (kModels / "glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb").string();
  EXPECT_NE(error_of(infinite).find("polygon 0 has a vertex that is not a finite number"),
            std::string::npos);
  const TemporaryFile nan("nan.ply",
                          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                          "property float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\nnan 1 0\n3 0 1 2\n");
  EXPECT_FALSE(error_of(nan.path()).empty());
}

TEST(ReadFile, RefusesHeadersThatPromiseMoreThanTheFileHolds) {
  const TemporaryFile ply("huge.ply",
                          "ply\nformat ascii 1.0\ncomment made by hand\n"
                          "element vertex 4000000000\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n0 0 0\n");
  EXPECT_NE(error_of(ply.path()).find("announces"), std::string::npos);
  const TemporaryFile cut("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement fa");
  EXPECT_NE(error_of(cut.path()).find("does not end"), std::string::npos);
  const TemporaryFile off("huge.off", "OFF\n# a comment\n\n4 3000000000 0\n0 0 0\n");
  EXPECT_NE(error_of(off.path()).find("announces"), std::string::npos);
}

// A letter among the indices makes Assimp read the number before it for ever.
TEST(ReadFile, RefusesFilesThatTakeAllMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer ends the program where memory does";
#endif
  std::ifstream room(RC2_SOURCE_DIR "/sw/scene/room.dae");
  std::string text((std::istreambuf_iterator<char>(room)), {});
  text.replace(text.find("<p>"), 3, "<p>0 x 1 ");
  const TemporaryFile file("endless.dae", text);
  EXPECT_NE(error_of(file.path()).find("memory"), std::string::npos);
  EXPECT_GT(read_file(RC2_SOURCE_DIR "/sw/scene/room.dae").polygon_count(), 0U);
}

TEST(DefaultScene, IsWhatTheTourNeeds) {
  Scene scene = read_file(RC2_SOURCE_DIR "/sw/scene/room.dae");
  std::map<std::uint32_t, int> sides;
  for (std::size_t i = 0; i < scene.polygon_count(); ++i)
    ++sides[scene.first[i + 1] - scene.first[i]];
  EXPECT_GE(sides[4], 20);
  EXPECT_GE(sides[6], 2);
  EXPECT_GE(sides[8], 4);
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_GT(scene.lights[0].colour.x, scene.lights[0].colour.z) << "warm";
  EXPECT_LT(scene.lights[1].colour.x, scene.lights[1].colour.z) << "cool";
  ASSERT_TRUE(scene.camera.has_value());
  EXPECT_NEAR(scene.camera->angle, std::acos(-1.0) / 4, 1e-5) << "Assimp does not read yfov";
  float mirror = 0.0F, transparency = 0.0F;
  for (const std::uint32_t material : scene.material) {
    mirror = std::max(mirror, scene.materials[material].mirror);
    transparency = std::max(transparency, scene.materials[material].transparency);
  }
  EXPECT_NEAR(mirror, 0.85F, 1e-6F);
  EXPECT_NEAR(transparency, 0.7F, 1e-6F);

  fit_to_cube(scene, 16);
  const auto [low, high] = extent(scene);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(low[axis], 1.0, 1e-9) << "a cube fills the cube";
    EXPECT_NEAR(high[axis], 14.0, 1e-9);
  }
}

TEST(Generate, NamesAreRecognised) {
  for (const char* name : {"empty", "room", "ball:3", "shells:10:1", "dust:5:2", "ball"})
    EXPECT_TRUE(is_generated_name(name)) << name;
  for (const char* name : {"ball.obj", "rooms", "", "models/room.dae"})
    EXPECT_FALSE(is_generated_name(name)) << name;
}

TEST(Generate, RefusesMalformedNames) {
  for (const char* name : {"ball",
                           "ball:",
                           "ball:x",
                           "ball:0",
                           "ball:-1",
                           "ball:nan",
                           "ball:9",
                           "ball:3:1",
                           "shells:10",
                           "shells:0:1",
                           "shells:101:1",
                           "shells:99:1",
                           "shells:10:-1",
                           "shells:10:1.5",
                           "shells::1",
                           "dust:1e9:1",
                           "dust:nan:1",
                           "dust:5:1x",
                           "dust:5:99999999999999999999",
                           "empty:1",
                           "room:2",
                           "cube"})
    EXPECT_THROW(generate(name, 16), Error) << name;
  EXPECT_THROW(generate("room", 1), Error);
  EXPECT_THROW(generate("shells:1:1", 3), Error);
  EXPECT_THROW(generate("dust:50:1", 256), Error) << "more facets than there are numbers";
  EXPECT_EQ(generate("empty", 16).polygon_count(), 0U);
}

TEST(Generate, IsDeterminedByItsName) {
  for (const char* name : {"shells:10:7", "dust:5:7", "room", "ball:5.5"}) {
    const Scene a = generate(name, 32), b = generate(name, 32);
    EXPECT_TRUE(a.vertices == b.vertices) << name;
    EXPECT_TRUE(a.material == b.material) << name;
  }
  EXPECT_FALSE(generate("shells:10:7", 32).vertices == generate("shells:10:8", 32).vertices);
  EXPECT_FALSE(generate("dust:5:7", 32).vertices == generate("dust:5:8", 32).vertices);
  // A fingerprint: the same on every compiler and library.
  const Scene shells = generate("shells:10:7", 32);
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : shells.vertices) sum += p * 256.0;
  EXPECT_EQ(shells.polygon_count(), 626U);
  EXPECT_EQ(sum, glm::dvec3(7417016, 7510297, 8088138));
}

TEST(Generate, MeshesAreClosedAndInsideTheCube) {
  for (const int n : {2, 3, 4, 5, 16, 33, 64}) {
    for (const std::string& name : {std::string("room"), std::string("ball:1"),
                                    "ball:" + std::to_string(0.5 * n), std::string("shells:5:3")}) {
      if (n < 4 && name[0] == 's') continue;
      SCOPED_TRACE(name + " at n = " + std::to_string(n));
      const Scene scene = generate(name, n);
      ASSERT_GT(scene.polygon_count(), 0U);
      expect_closed(scene);
      const auto [low, high] = extent(scene);
      EXPECT_GE(std::min({low.x, low.y, low.z}), -0.5);
      EXPECT_LE(std::max({high.x, high.y, high.z}), n - 0.5);
      EXPECT_EQ(six_volumes(scene) < 0.0, name == "room") << "only the room faces inwards";
      EXPECT_LE(scene.polygon_count(), 25000U);
    }
  }
}

TEST(Generate, BallHasItsVolume) {
  const Scene scene = generate("ball:20", 64);
  const double volume = six_volumes(scene) / 6.0, ideal = 4.0 / 3.0 * std::acos(-1.0) * 8000.0;
  EXPECT_LT(volume, ideal);
  EXPECT_GT(volume, 0.98 * ideal);
  for (const glm::dvec3& p : scene.vertices)
    ASSERT_NEAR(glm::distance(p, glm::dvec3(31.5)), 20.0, 0.01);
}

TEST(Generate, DustIsDistinctAndApart) {
  const Scene scene = generate("dust:3:5", 32);
  const auto wanted = static_cast<std::size_t>(std::lround(0.03 * 32 * 32 * 32));
  ASSERT_EQ(scene.polygon_count(), wanted);
  std::vector<glm::ivec3> voxels;
  for (std::size_t i = 0; i < wanted; ++i) voxels.emplace_back(scene.vertices[scene.first[i]]);
  for (std::size_t i = 0; i < wanted; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const glm::ivec3 apart = glm::abs(voxels[i] - voxels[k]);
      ASSERT_GT(std::max({apart.x, apart.y, apart.z}), 1);
    }
  std::set<Key> full;
  const Scene all = generate("dust:100:1", 8);
  for (std::size_t i = 0; i < all.polygon_count(); ++i)
    full.insert(key(all.vertices[all.first[i]]));
  EXPECT_EQ(full.size(), 512U);
}

TEST(FitToCube, MovesLightsAndCameraAlong) {
  for (const int n : {2, 3, 4, 16}) {
    Scene scene;
    scene.add({{0, 0, 0}, {4, 0, 0}, {4, 2, 0}}, 0);
    scene.lights.push_back({{2, 1, 0}, {}});
    scene.camera = Camera{{2, 1, 8}, {0, 0, -1}, {0, 1, 0}, 1};
    fit_to_cube(scene, n);
    const double low = n < 4 ? 0.0 : 1.0, middle = 0.5 * (n - 1);
    EXPECT_NEAR(scene.vertices[0].x, low, 1e-12);
    EXPECT_NEAR(scene.vertices[1].x, n - 1 - low, 1e-12);
    EXPECT_NEAR(glm::distance(scene.lights[0].position, glm::dvec3(middle)), 0.0, 1e-12);
    EXPECT_NEAR(scene.camera->position.z, middle + 2.0 * (n - 1 - 2 * low), 1e-12);
    EXPECT_EQ(scene.camera->direction, glm::dvec3(0, 0, -1));
  }
}

TEST(FitToCube, RefusesWhatHasNoExtent) {
  Scene nothing;
  EXPECT_THROW(fit_to_cube(nothing, 16), Error);
  Scene point;
  point.add({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 0);
  EXPECT_THROW(fit_to_cube(point, 16), Error);
}

// Assimp's RAW importer announces more child nodes than it makes.
TEST(ReadFile, PassesOverNodesThatAreNotThere) {
  EXPECT_EQ(read_file((kModels / "RAW/WithColor.raw").string()).polygon_count(), 2U);
}

}  // namespace
}  // namespace rc2::scene
