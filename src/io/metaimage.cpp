#include "metaimage.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "errors.h"
#include "header_text.h"
#include "input_file.h"
#include "placement.h"
#include "raw_samples.h"

namespace isolume {
namespace {

/// Real headers have less than 4 KiB; the samples of an attached image may follow.
constexpr std::size_t kHeaderLimit = 1 << 16;

using Fields = std::map<std::string, std::string, std::less<>>;

/// `Key = value` lines up to ElementDataFile, which ends every MetaImage header.
Fields parseFields(const std::string& text) {
  Fields fields;
  for (const std::string_view line : splitLines(text)) {
    const std::size_t equals = line.find_first_of("=:");
    if (equals == line.npos) continue;
    const std::string key(trimmed(line.substr(0, equals)));
    fields.try_emplace(key, trimmed(line.substr(equals + 1)));
    if (key == "ElementDataFile") break;
  }
  return fields;
}

class Header {
 public:
  Header(const std::string& path, const std::string& text) : path_(path), fields_(parseFields(text)) {}

  /// The first of several spellings that is there; "" if none is.
  std::string_view find(std::initializer_list<std::string_view> keys) const {
    for (const std::string_view key : keys)
      if (const auto found = fields_.find(key); found != fields_.end()) return found->second;
    return {};
  }
  bool isTrue(std::initializer_list<std::string_view> keys, bool otherwise) const {
    const std::string_view value = find(keys);
    return value.empty() ? otherwise : value[0] == 'T' || value[0] == 't' || value[0] == '1';
  }
  template <class T>
  std::vector<T> numbers(std::initializer_list<std::string_view> keys, std::size_t count,
                         std::vector<T> otherwise) const {
    const std::string_view value = find(keys);
    if (value.empty() && !otherwise.empty()) return otherwise;
    const auto parsed = parseNumbers<T>(value, count);
    if (!parsed)
      throw InputError(fmt::format("{}: {}: expected {} number{}, found '{}'", path_, *keys.begin(), count,
                                   count == 1 ? "" : "s", value));
    return *parsed;
  }

 private:
  std::string path_;
  Fields fields_;
};

SampleType typeOf(const std::string& path, std::string_view name) {
  // MetaImage's LONG has 4 bytes on every machine.
  static const std::map<std::string_view, SampleType> kTypes{
      {"MET_UCHAR", SampleType::uint8},     {"MET_CHAR", SampleType::int8},     {"MET_USHORT", SampleType::uint16},
      {"MET_SHORT", SampleType::int16},     {"MET_UINT", SampleType::uint32},   {"MET_INT", SampleType::int32},
      {"MET_ULONG", SampleType::uint32},    {"MET_LONG", SampleType::int32},    {"MET_ULONG_LONG", SampleType::uint64},
      {"MET_LONG_LONG", SampleType::int64}, {"MET_FLOAT", SampleType::float32}, {"MET_DOUBLE", SampleType::float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end())
    throw InputError(fmt::format("{}: ElementType: expected a scalar type such as MET_SHORT, found '{}'", path, name));
  return found->second;
}

/// The first three numbers of a field with one number per dimension.
template <class T>
glm::vec<3, T> spatial(const std::vector<T>& all) {
  return {all[0], all[1], all[2]};
}

/// The sizes along x, y and z, once every further dimension is known to have one sample.
glm::i64vec3 spatialSize(const std::string& path, const Header& header, std::size_t dimensions) {
  const auto dims = header.numbers<std::int64_t>({"DimSize"}, dimensions, {});
  if (std::any_of(dims.begin() + 3, dims.end(), [](std::int64_t size) { return size != 1; }))
    throw InputError(fmt::format("{}: DimSize: expected a 3D image, found {}", path, fmt::join(dims, "x")));
  return spatial(dims);
}

glm::dmat4 placementOf(const std::string& path, const Header& header, std::size_t dimensions) {
  std::vector<double> identity(dimensions * dimensions, 0.0);
  for (std::size_t i = 0; i < dimensions; ++i) identity[i * dimensions + i] = 1;
  const auto axes = header.numbers<double>({"TransformMatrix", "Rotation", "Orientation"}, identity.size(), identity);
  glm::dmat3 direction;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t row = 0; row < 3; ++row)
      direction[static_cast<int>(axis)][static_cast<int>(row)] = axes[axis * dimensions + row];
  const std::vector<double> ones(dimensions, 1.0), zeros(dimensions, 0.0);
  return placeGrid(path, spatial(header.numbers<double>({"ElementSpacing", "ElementSize"}, dimensions, ones)),
                   direction, spatial(header.numbers<double>({"Offset", "Position", "Origin"}, dimensions, zeros)));
}

/// The first byte behind the header: behind the line that names ElementDataFile.
std::uint64_t headerBytes(const std::string& text) {
  std::size_t at = 0;
  for (const std::string_view line : splitLines(text)) {
    const std::size_t end = static_cast<std::size_t>(line.data() - text.data()) + line.size();
    at = std::min(text.find('\n', end), text.size() - 1) + 1;
    if (line.starts_with("ElementDataFile")) break;
  }
  return at;
}

/// Where the samples are: file, first byte, compressed or not.
void locateSamples(const std::string& path, const std::string& text, const Header& header, RawDescription& d) {
  const std::string_view dataFile = header.find({"ElementDataFile"});
  if (dataFile.empty())
    throw InputError(fmt::format("{}: ElementDataFile: expected the name of the samples' file, found none", path));
  if (dataFile.starts_with("LIST") || dataFile.find('%') != dataFile.npos)
    throw InputError(fmt::format("{}: ElementDataFile: expected one file, found several ('{}')", path, dataFile));
  if (!header.isTrue({"BinaryData"}, true))
    throw InputError(fmt::format("{}: BinaryData: expected True, found samples as text", path));
  const bool local = dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local";
  const std::int64_t skip = header.numbers<std::int64_t>({"HeaderSize"}, 1, {0})[0];
  if (skip < -1) throw InputError(fmt::format("{}: HeaderSize: expected -1 or more, found {}", path, skip));
  d.dataPath = local ? path : besideHeader(path, dataFile);
  d.compressed = header.isTrue({"CompressedData"}, false);
  d.trailing = local;
  d.dataAtEnd = skip == -1 && !d.compressed;
  d.offset = skip > 0 ? static_cast<std::uint64_t>(skip) : local ? headerBytes(text) : 0;
}

}  // namespace

bool looksLikeMetaImage(const std::string& head) {
  // Any order of tags is allowed, but every known writer begins with one of these.
  for (const std::string_view key : {"ObjectType", "NDims", "Comment"})
    if (head.starts_with(key) && head.find("NDims") != head.npos && head.find('=') != head.npos) return true;
  return false;
}

Volume readMetaImage(const std::string& path) {
  const std::string text = InputFile(path).head(kHeaderLimit);
  const Header header(path, text);
  if (const auto object = header.find({"ObjectType"}); !object.empty() && object != "Image")
    throw InputError(fmt::format("{}: ObjectType: expected Image, found '{}'", path, object));
  constexpr std::int64_t kMostDimensions = 10;  // MetaImage's own limit
  const std::int64_t dimensions = header.numbers<std::int64_t>({"NDims"}, 1, {})[0];
  if (dimensions < 3 || dimensions > kMostDimensions)
    throw InputError(fmt::format("{}: NDims: expected 3 dimensions, found {}", path, dimensions));
  if (const auto channels = header.numbers<std::int64_t>({"ElementNumberOfChannels"}, 1, {1})[0]; channels != 1)
    throw InputError(fmt::format("{}: ElementNumberOfChannels: expected 1, found {}", path, channels));

  RawDescription d;
  locateSamples(path, text, header, d);
  d.dims = spatialSize(path, header, static_cast<std::size_t>(dimensions));
  d.type = typeOf(path, header.find({"ElementType"}));
  d.bigEndian = header.isTrue({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  d.worldFromGrid = placementOf(path, header, static_cast<std::size_t>(dimensions));

  Volume volume = readRawSamples(d);
  volume.format = "MetaImage";
  volume.world = "LPS millimetres";
  if (d.dataPath != path) volume.files.insert(volume.files.begin(), path);
  for (const std::string_view key : {"ElementToIntensityFunctionSlope", "ElementToIntensityFunctionOffset"})
    if (const auto value = header.find({key}); !value.empty())
      volume.notes.push_back(fmt::format("{} = {} is not applied: values are as stored", key, value));
  return volume;
}

}  // namespace isolume
