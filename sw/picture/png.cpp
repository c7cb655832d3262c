#include "sw/picture/png.h"

#include <fmt/format.h>
#include <png.h>

#include "sw/base/error.h"
#include "sw/base/replace_file.h"

namespace rc2::picture {

void write_png(const std::string& path, const Raster& raster) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.format = PNG_FORMAT_RGB;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, raster.pixels.data(), 0, nullptr) ==
      0) {
    throw Error(fmt::format("{}: libpng cannot encode a picture of {} x {} pixels: {}", path,
                            raster.width, raster.height, image.message));
  }
  bytes.resize(size);
  replace_file(path, bytes);
}

}  // namespace rc2::picture
