#include "nrrd.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <string_view>

#include "errors.h"
#include "header_text.h"
#include "input_file.h"
#include "itk_reader.h"
#include "placement.h"
#include "raw_samples.h"

namespace isolume {
namespace {

/// Far above any real header; the samples of an attached image may follow.
constexpr std::size_t kHeaderLimit = 1 << 18;

using Fields = std::map<std::string, std::string>;

/// "field: value" lines up to the first empty line. Names without regard to case and blanks: `data file` = `datafile`.
Fields parseFields(const std::string& text) {
  Fields fields;
  const auto lines = splitLines(text);
  for (std::size_t i = 1; i < lines.size() && !trimmed(lines[i]).empty(); ++i) {
    const std::size_t colon = lines[i].find(": ");
    if (lines[i].starts_with('#') || colon == std::string_view::npos) continue;
    std::string name = lowerCase(lines[i].substr(0, colon));
    std::erase(name, ' ');
    fields.try_emplace(name, trimmed(lines[i].substr(colon + 2)));
  }
  return fields;
}

std::string_view valueOf(const Fields& fields, const std::string& name) {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string_view{} : std::string_view(found->second);
}

template <class T>
std::vector<T> numbers(const std::string& path, const Fields& fields, const std::string& name, std::size_t count) {
  const std::string_view value = valueOf(fields, name);
  const auto parsed = parseNumbers<T>(value, count);
  if (!parsed)
    throw InputError(
        fmt::format("{}: {}: expected {} number{}, found '{}'", path, name, count, count == 1 ? "" : "s", value));
  return *parsed;
}

SampleType typeOf(const std::string& path, const Fields& fields) {
  static const std::map<std::string, SampleType> kTypes{{"signed char", SampleType::int8},
                                                        {"int8", SampleType::int8},
                                                        {"int8_t", SampleType::int8},
                                                        {"uchar", SampleType::uint8},
                                                        {"unsigned char", SampleType::uint8},
                                                        {"uint8", SampleType::uint8},
                                                        {"uint8_t", SampleType::uint8},
                                                        {"short", SampleType::int16},
                                                        {"short int", SampleType::int16},
                                                        {"signed short", SampleType::int16},
                                                        {"signed short int", SampleType::int16},
                                                        {"int16", SampleType::int16},
                                                        {"int16_t", SampleType::int16},
                                                        {"ushort", SampleType::uint16},
                                                        {"unsigned short", SampleType::uint16},
                                                        {"unsigned short int", SampleType::uint16},
                                                        {"uint16", SampleType::uint16},
                                                        {"uint16_t", SampleType::uint16},
                                                        {"int", SampleType::int32},
                                                        {"signed int", SampleType::int32},
                                                        {"int32", SampleType::int32},
                                                        {"int32_t", SampleType::int32},
                                                        {"uint", SampleType::uint32},
                                                        {"unsigned int", SampleType::uint32},
                                                        {"uint32", SampleType::uint32},
                                                        {"uint32_t", SampleType::uint32},
                                                        {"longlong", SampleType::int64},
                                                        {"long long", SampleType::int64},
                                                        {"long long int", SampleType::int64},
                                                        {"signed long long", SampleType::int64},
                                                        {"signed long long int", SampleType::int64},
                                                        {"int64", SampleType::int64},
                                                        {"int64_t", SampleType::int64},
                                                        {"ulonglong", SampleType::uint64},
                                                        {"unsigned long long", SampleType::uint64},
                                                        {"unsigned long long int", SampleType::uint64},
                                                        {"uint64", SampleType::uint64},
                                                        {"uint64_t", SampleType::uint64},
                                                        {"float", SampleType::float32},
                                                        {"double", SampleType::float64}};
  const auto found = kTypes.find(lowerCase(valueOf(fields, "type")));
  if (found == kTypes.end())
    throw InputError(
        fmt::format("{}: type: expected a scalar type such as short, found '{}'", path, valueOf(fields, "type")));
  return found->second;
}

struct Space {
  std::string world;
  glm::dvec3 lpsFromSpace{1};
};

Space spaceOf(const Fields& fields) {
  struct Row {
    std::string_view name, letters;
    glm::dvec3 lpsFromSpace;
  };
  static const std::array<Row, 3> kAnatomical{{
      {"right-anterior-superior", "ras", {-1, -1, 1}},
      {"left-anterior-superior", "las", {1, -1, 1}},
      {"left-posterior-superior", "lps", {1, 1, 1}},
  }};
  const std::string name = lowerCase(valueOf(fields, "space"));
  // `space units` lists one quoted unit per axis; NRRD in medicine means millimetres where it is absent, as ITK
  // assumes.
  const auto units = splitWords(valueOf(fields, "spaceunits"), " \t\"");
  std::string unit = "millimetres";
  if (!units.empty() && units[0] != "mm") unit = units[0];
  for (const Row& row : kAnatomical)
    if (name == row.name || name == row.letters) {
      const bool converted = row.letters != "lps";
      return {fmt::format("LPS {}{}", unit, converted ? fmt::format(", converted from {}", name) : ""),
              row.lpsFromSpace};
    }
  return {name};
}

/// "(a,b,c) (d,e,f) ..." as so many vectors.
std::vector<glm::dvec3> vectors(const std::string& path, const Fields& fields, const std::string& name,
                                std::size_t count) {
  const std::string_view value = valueOf(fields, name);
  const auto words = splitWords(value, " \t(),");
  const auto numbersRead = parseNumbers<double>(fmt::format("{}", fmt::join(words, " ")), 3 * count);
  if (!numbersRead)
    throw InputError(fmt::format("{}: {}: expected {} vector{} like (1,0,0), found '{}'", path, name, count,
                                 count == 1 ? "" : "s", value));
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i < count; ++i)
    result.emplace_back((*numbersRead)[3 * i], (*numbersRead)[3 * i + 1], (*numbersRead)[3 * i + 2]);
  return result;
}

glm::dmat4 placementOf(const std::string& path, const Fields& fields, const Space& space) {
  glm::dmat3 axes(1);
  glm::dvec3 origin(0);
  if (fields.contains("spacedirections")) {
    const auto directions = vectors(path, fields, "spacedirections", 3);
    for (int i = 0; i < 3; ++i) axes[i] = directions[static_cast<std::size_t>(i)] * space.lpsFromSpace;
  } else if (fields.contains("spacings")) {
    const auto spacings = numbers<double>(path, fields, "spacings", 3);
    for (int i = 0; i < 3; ++i) axes[i] *= spacings[static_cast<std::size_t>(i)];
  }
  if (fields.contains("spaceorigin")) origin = vectors(path, fields, "spaceorigin", 1)[0] * space.lpsFromSpace;
  return placeGrid(path, glm::dvec3(1), axes, origin);
}

/// What of this header only ITK reads; "" if nothing.
std::string itkFeature(const Fields& fields, std::string_view dataFile) {
  const std::string encoding = lowerCase(valueOf(fields, "encoding"));
  if (dataFile.empty()) return "NRRD with its samples in the same file";
  if (dataFile.starts_with("LIST") || dataFile.find('%') != dataFile.npos) return "NRRD in several files";
  if (encoding != "raw") return fmt::format("NRRD in encoding '{}'", encoding);
  if (valueOf(fields, "dimension") != "3") return fmt::format("NRRD of dimension '{}'", valueOf(fields, "dimension"));
  for (const char* name : {"lineskip", "axismins"})
    if (fields.contains(name)) return fmt::format("NRRD with the field '{}'", name);
  return "";
}

bool isBigEndian(const std::string& path, const Fields& fields, SampleType type) {
  const std::string endian = lowerCase(valueOf(fields, "endian"));
  if (endian != "little" && endian != "big" && bytesPerSample(type) > 1)
    throw InputError(fmt::format("{}: endian: expected little or big, found '{}'", path, endian));
  return endian == "big";
}

/// ITK before 2025 mirrors left-anterior-superior images in the wrong axis, so where the header says how axes lie in an
/// anatomical space, that is taken from here: attached and detached samples then always stand in the same place.
Volume readThroughItk(const std::string& path, const std::string& feature, const Fields& fields) {
  const Space space = spaceOf(fields);
  if (!space.world.starts_with("LPS") || valueOf(fields, "dimension") != "3" || !fields.contains("spacedirections"))
    return readItk(path, feature);
  Volume volume = readItk(path, feature, placementOf(path, fields, space));
  volume.world = space.world;
  return volume;
}

}  // namespace

bool looksLikeNrrd(const std::string& head) { return head.starts_with("NRRD000"); }

Volume readNrrd(const std::string& path) {
  const Fields fields = parseFields(InputFile(path).head(kHeaderLimit));
  const std::string_view dataFile = valueOf(fields, "datafile");
  if (const std::string feature = itkFeature(fields, dataFile); !feature.empty())
    return readThroughItk(path, feature, fields);

  RawDescription d{.dataPath = besideHeader(path, dataFile)};
  d.type = typeOf(path, fields);
  const auto sizes = numbers<std::int64_t>(path, fields, "sizes", 3);
  d.dims = {sizes[0], sizes[1], sizes[2]};
  d.bigEndian = isBigEndian(path, fields, d.type);
  if (fields.contains("byteskip")) {
    const std::int64_t skip = numbers<std::int64_t>(path, fields, "byteskip", 1)[0];
    if (skip < -1) throw InputError(fmt::format("{}: byte skip: expected -1 or more, found {}", path, skip));
    d.dataAtEnd = skip == -1;
    d.offset = skip > 0 ? static_cast<std::uint64_t>(skip) : 0;
  }
  const Space space = spaceOf(fields);
  d.worldFromGrid = placementOf(path, fields, space);

  Volume volume = readRawSamples(d);
  volume.format = "NRRD";
  volume.world = space.world;
  volume.files.insert(volume.files.begin(), path);
  return volume;
}

}  // namespace isolume
