#include "sw/picture/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "sw/base/replace_file.h"

namespace rc2::picture {
namespace {

// The file's header and, in step with it, where in memory its channels lie.
class Channels {
 public:
  explicit Channels(int n) : header(n, n), n_(static_cast<std::size_t>(n)) {}

  void add(const std::string& name, const float& first, std::size_t pixel_bytes = sizeof(float)) {
    add(name, Imf::FLOAT, &first, pixel_bytes);
  }
  void add(const std::string& name, const std::uint32_t& first) {
    add(name, Imf::UINT, &first, sizeof(std::uint32_t));
  }

  Imf::Header header;
  Imf::FrameBuffer memory;

 private:
  void add(const std::string& name, Imf::PixelType type, const void* first,
           std::size_t pixel_bytes) {
    header.channels().insert(name, Imf::Channel(type));
    // OpenEXR describes memory to read and memory to write by the same type, hence the cast.
    auto* const base = const_cast<char*>(static_cast<const char*>(first));
    memory.insert(name, Imf::Slice(type, base, pixel_bytes, pixel_bytes * n_));
  }

  std::size_t n_;
};

}  // namespace

void write_exr(const std::string& path, const Image& image) {
  Channels channels(image.n);
  channels.header.insert("software", Imf::StringAttribute("RC2 " RC2_VERSION));
  channels.header.insert("rc2.n", Imf::IntAttribute(image.n));
  const glm::vec3& colour = image.colour.front();
  const glm::vec3& normal = image.normal.front();
  channels.add("R", colour.r, sizeof colour);
  channels.add("G", colour.g, sizeof colour);
  channels.add("B", colour.b, sizeof colour);
  channels.add("Z", image.depth.front());
  channels.add("N.X", normal.x, sizeof normal);
  channels.add("N.Y", normal.y, sizeof normal);
  channels.add("N.Z", normal.z, sizeof normal);
  channels.add("facet.id", image.facet.front());
  for (std::size_t k = 0; k < image.lights.size(); ++k) {
    channels.add(fmt::format("light{}", k), image.lights[k].front());
  }

  Imf::StdOSStream bytes;
  {
    Imf::OutputFile file(bytes, channels.header);
    file.setFrameBuffer(channels.memory);
    file.writePixels(image.n);
  }
  replace_file(path, bytes.str());
}

}  // namespace rc2::picture
