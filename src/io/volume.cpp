#include "volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "errors.h"
#include "header_text.h"
#include "input_file.h"
#include "itk_reader.h"
#include "metaimage.h"
#include "nrrd.h"
#include "raw.h"
#include "vdb.h"

namespace isolume {
namespace {

/// Longer than every signature below, and than the comment that may come before the first tag of a MetaImage.
constexpr std::size_t kHeadBytes = 4096;

/// Files that are known for what they are and that nobody here reads: the message can then say what would help.
struct ForeignFormat {
  std::string_view signature;
  std::size_t at;
  std::string_view name, help;
};
constexpr std::array<ForeignFormat, 9> kForeignFormats{{
    {"<?xml", 0, "XML data, such as a VTK .vti file", "save it as .mha or .nrrd"},
    {"<VTKFile", 0, "a VTK XML file (.vti)", "save it as .mha or .nrrd"},
    {"DICM", 128, "DICOM", "convert the series to .nii or .mha"},
    {"\x89HDF", 0, "HDF5 or NetCDF 4", "save the variable as raw or .nrrd"},
    {"CDF", 0, "NetCDF 3", "save the variable as raw or .nrrd"},
    {"\x93NUMPY", 0, "a NumPy array", "save it as raw, with array.tofile()"},
    {"PK\x03\x04", 0, "a zip archive", "unpack it"},
    {"\x89PNG", 0, "a PNG picture", "expected a volume, not a picture"},
    {"\x1f\x8b", 0, "gzip-compressed data", "unpack it"},
}};
#ifdef ISOLUME_HAVE_ITK
constexpr std::string_view kSupported =
    "VDB, raw, .mhd, .mha, .nhdr, and through ITK .nrrd, NIfTI, MRC, TIFF, GIPL and legacy VTK";
#else
constexpr std::string_view kSupported =
    "VDB, raw, .mhd, .mha, .nhdr; .nrrd, NIfTI, MRC, TIFF, GIPL and legacy VTK need ITK, which this build does not "
    "have";
#endif

bool isVdb(const std::string& head) { return head.starts_with(std::string_view(" BDV\0\0\0\0", 8)); }

bool hasEnding(const std::string& path, std::initializer_list<std::string_view> endings) {
  const std::string ending = lowerCase(std::filesystem::path(path).extension().string());
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Options that do not fit the format are an error, never ignored.
void rejectOptions(const std::string& path, const ReadOptions& options, std::string_view format) {
  const auto reject = [&](bool given, std::string_view name, std::string_view meaning) {
    if (given) throw InputError(fmt::format("{}: {} {}, found {}", path, name, meaning, format));
  };
  constexpr std::string_view kForRaw = "applies to raw files only";
  if (format != "raw") {
    reject(options.raw.dims.has_value(), "--dims", kForRaw);
    reject(options.raw.type.has_value(), "--type", kForRaw);
    reject(options.raw.bigEndian.has_value(), "--endian", kForRaw);
    reject(options.raw.offset.has_value(), "--offset", kForRaw);
    reject(options.raw.spacing.has_value(), "--spacing", kForRaw);
    reject(options.raw.origin.has_value(), "--origin", kForRaw);
  }
  reject(format != "VDB" && !options.grid.empty(), "--grid", "applies to VDB files only");
}

[[noreturn]] void refuse(const std::string& path, const std::string& head) {
  for (const ForeignFormat& format : kForeignFormats)
    if (head.size() > format.at && head.compare(format.at, format.signature.size(), format.signature) == 0)
      throw InputError(
          fmt::format("{}: expected a volume ({}), found {}: {}", path, kSupported, format.name, format.help));
  throw InputError(
      fmt::format("{}: expected a volume ({}), found an unknown format; for raw samples say --dims and "
                  "--type",
                  path, kSupported));
}

}  // namespace

Volume readVolume(const std::string& path, const ReadOptions& options) {
  const std::string head = InputFile(path).head(kHeadBytes);
  // A signature that no raw file has by chance decides, whatever the name says.
  if (isVdb(head)) {
    rejectOptions(path, options, "VDB");
    return readVdb(path, options.grid);
  }
  if (looksLikeNrrd(head)) {
    rejectOptions(path, options, "NRRD");
    return readNrrd(path);
  }
  if (looksLikeMetaImage(head) || hasEnding(path, {".mhd", ".mha"})) {
    rejectOptions(path, options, "MetaImage");
    return readMetaImage(path);
  }
  const bool named = hasEnding(path, {".raw"}) || isRawName(path);
  if (!named && itkCanRead(path)) {
    rejectOptions(path, options, "a format that describes itself");
    return readItk(path, "it");
  }
  if (named || options.raw.dims || options.raw.type) {
    rejectOptions(path, options, "raw");
    return readRaw(path, options.raw);
  }
  refuse(path, head);
}

}  // namespace isolume
