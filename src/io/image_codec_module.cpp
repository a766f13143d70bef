// The only translation unit that includes OpenImageIO.
#include "image_codec_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>

namespace isolume {
namespace {

// Measured on two 1024^2 renderings, one of fine threads and one of flat walls, against libpng's default (level 6, a
// filter chosen anew for each row): level 3 with the Up filter takes 1/3 of the time at 0.98 and 1.27 times the size;
// level 1 takes 1/4 at 1.08 and 1.40 times, level 6 takes 4/5 at 0.99 and 0.99 times.
constexpr int kPngLevel = 3;
constexpr int kPngFilterUp = 0x20;  // PNG_FILTER_UP

OIIO::TypeDesc typeDesc(SampleType type) {
  switch (type) {
    case SampleType::uint8:
      return OIIO::TypeDesc::UINT8;
    case SampleType::uint16:
      return OIIO::TypeDesc::UINT16;
    case SampleType::float32:
      break;
  }
  return OIIO::TypeDesc::FLOAT;
}

const char* nameOf(ImageFormat format) { return format == ImageFormat::png ? "memory.png" : "memory.exr"; }

int alphaIndex(const std::vector<std::string>& channels) {
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i] == "A") return static_cast<int>(i);
  return -1;
}

OIIO::ImageSpec specFor(const RawImage& image, ImageFormat format) {
  OIIO::ImageSpec spec(image.size.x, image.size.y, static_cast<int>(image.channels.size()), typeDesc(image.type));
  spec.channelnames = image.channels;
  spec.alpha_channel = alphaIndex(image.channels);
  if (format == ImageFormat::png) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);  // samples are straight already: write them as they are
    spec.attribute("png:compressionLevel", kPngLevel);
    spec.attribute("png:filter", kPngFilterUp);
  } else {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // or else the present time is written, and no two files are the same
  }
  for (const auto& [key, value] : image.metadata) spec.attribute(key, value);
  return spec;
}

std::unique_ptr<OIIO::ImageInput> openReader(OIIO::Filesystem::IOMemReader& reader, ImageFormat format) {
  // By the format's name: given a file's name, it would look for that file.
  auto input = OIIO::ImageInput::create(format == ImageFormat::png ? "png" : "openexr");
  if (!input) throw std::runtime_error(OIIO::geterror());
  OIIO::ImageSpec spec, config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // samples as they are stored
  OIIO::Filesystem::IOProxy* proxy = &reader;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);  // set_ioproxy() is forgotten once there is a config
  if (!input->open(nameOf(format), spec, config)) throw std::runtime_error(input->geterror());
  return input;
}

// OpenImageIO renames, interprets or drops some attributes without a word: compare what arrived.
void requireMetadata(const RawImage& image, std::string_view bytes) {
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  const auto input = openReader(reader, ImageFormat::exr);
  for (const auto& [key, value] : image.metadata)
    if (input->spec().get_string_attribute(key) != value)
      throw std::logic_error("image metadata: an EXR file cannot hold '" + key + "' under that name");
}

std::string encode(const RawImage& image, ImageFormat format, int threads) {
  OIIO::attribute("threads", threads);
  OIIO::attribute("exr_threads", threads);
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create(nameOf(format));
  if (!output) throw std::runtime_error(OIIO::geterror());
  const OIIO::ImageSpec spec = specFor(image, format);
  if (!output->set_ioproxy(&bytes) || !output->open(nameOf(format), spec) ||
      !output->write_image(spec.format, image.samples.data()) || !output->close())
    throw std::runtime_error(output->geterror());
  std::string result(bytes.buffer().begin(), bytes.buffer().end());
  if (format == ImageFormat::exr) requireMetadata(image, result);
  return result;
}

RawImage decode(std::string_view bytes, ImageFormat format) {
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  const auto input = openReader(reader, format);
  const OIIO::ImageSpec& spec = input->spec();
  RawImage image{{spec.width, spec.height}, SampleType::float32, spec.channelnames, {}, {}};
  if (spec.format == OIIO::TypeDesc::UINT8) image.type = SampleType::uint8;
  if (spec.format == OIIO::TypeDesc::UINT16) image.type = SampleType::uint16;
  const OIIO::TypeDesc type = typeDesc(image.type);
  image.samples.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels) * type.size());
  if (!input->read_image(0, 0, 0, spec.nchannels, type, image.samples.data()))
    throw std::runtime_error(input->geterror());
  for (const auto& attribute : spec.extra_attribs)
    if (attribute.type() == OIIO::TypeDesc::STRING)
      image.metadata.emplace_back(attribute.name(), attribute.get_string());
  return image;
}

}  // namespace
}  // namespace isolume

const isolume::ImageCodec* isolumeImageCodec() {
  static constexpr isolume::ImageCodec codec{isolume::encode, isolume::decode};
  return &codec;
}
