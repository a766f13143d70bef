#include "itk_reader.h"

#include <fmt/format.h>
#include <itkGiplImageIO.h>
#include <itkMRCImageIO.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkTIFFImageIO.h>
#include <itkVTKImageIO.h>

#include <array>
#include <iostream>
#include <new>
#include <sstream>

#include "errors.h"
#include "header_text.h"
#include "memory_limit.h"
#include "placement.h"
#include "samples.h"
#include "stored_size.h"

namespace isolume {
namespace {

struct ItkFormat {
  const char* name;
  const char* world;  ///< what ITK's coordinates are for that format; "" where the format does not say
  itk::ImageIOBase::Pointer (*make)();
};

template <class Io>
itk::ImageIOBase::Pointer make() {
  return Io::New().GetPointer();
}

constexpr const char* kLps = "LPS millimetres";
const std::array<ItkFormat, 7> kFormats{{
    {"NRRD", kLps, make<itk::NrrdImageIO>},
    {"MetaImage", kLps, make<itk::MetaImageIO>},
    {"NIfTI", kLps, make<itk::NiftiImageIO>},
    {"MRC", "angstroms", make<itk::MRCImageIO>},
    {"GIPL", kLps, make<itk::GiplImageIO>},
    {"VTK legacy image", "", make<itk::VTKImageIO>},
    {"TIFF", "", make<itk::TIFFImageIO>},
}};

/// The libraries below ITK write their reasons to std::cerr; this keeps them off the terminal, for the message.
class CapturedCerr {
 public:
  CapturedCerr() : before_(std::cerr.rdbuf(text_.rdbuf())) {}
  ~CapturedCerr() { std::cerr.rdbuf(before_); }
  CapturedCerr(const CapturedCerr&) = delete;
  CapturedCerr& operator=(const CapturedCerr&) = delete;
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* before_;
};

std::string oneLine(const std::string& text) { return fmt::format("{}", fmt::join(splitWords(text, " \t\r\n"), " ")); }

/// Runs one call into ITK; anything it throws, and any complaint it prints, becomes an InputError with the path.
template <class Call>
auto guarded(const std::string& path, Call call) {
  itk::Object::GlobalWarningDisplayOff();
  const CapturedCerr complaints;
  const auto fail = [&](const std::string& what) {
    return InputError(fmt::format("{}: ITK cannot read it: {}", path, oneLine(what + " " + complaints.text())));
  };
  try {
    return call();
  } catch (const itk::ExceptionObject& error) {
    throw fail(error.GetDescription());
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw fail("out of memory");
  } catch (const std::exception& error) {
    throw fail(error.what());
  }
}

const ItkFormat* formatOf(const std::string& path) {
  itk::Object::GlobalWarningDisplayOff();
  const CapturedCerr complaints;
  for (const ItkFormat& format : kFormats) {
    try {
      if (format.make()->CanReadFile(path.c_str())) return &format;
    } catch (const std::exception&) {
      // A reader that fails on the file does not recognise it.
      continue;
    }
  }
  return nullptr;
}

SampleType sampleTypeOf(const std::string& path, const itk::ImageIOBase& io) {
  const bool longIs64 = sizeof(long) == 8;
  switch (io.GetComponentType()) {
    case itk::IOComponentEnum::UCHAR:
      return SampleType::uint8;
    case itk::IOComponentEnum::CHAR:
      return SampleType::int8;
    case itk::IOComponentEnum::USHORT:
      return SampleType::uint16;
    case itk::IOComponentEnum::SHORT:
      return SampleType::int16;
    case itk::IOComponentEnum::UINT:
      return SampleType::uint32;
    case itk::IOComponentEnum::INT:
      return SampleType::int32;
    case itk::IOComponentEnum::ULONG:
      return longIs64 ? SampleType::uint64 : SampleType::uint32;
    case itk::IOComponentEnum::LONG:
      return longIs64 ? SampleType::int64 : SampleType::int32;
    case itk::IOComponentEnum::ULONGLONG:
      return SampleType::uint64;
    case itk::IOComponentEnum::LONGLONG:
      return SampleType::int64;
    case itk::IOComponentEnum::FLOAT:
      return SampleType::float32;
    case itk::IOComponentEnum::DOUBLE:
      return SampleType::float64;
    default:
      break;
  }
  throw InputError(fmt::format("{}: expected integer or floating-point samples, found '{}'", path,
                               itk::ImageIOBase::GetComponentTypeAsString(io.GetComponentType())));
}

/// The size along the first three axes, once every further axis is known to have one sample.
glm::i64vec3 spatialSize(const std::string& path, const itk::ImageIOBase& io) {
  const unsigned count = io.GetNumberOfDimensions();
  std::vector<itk::SizeValueType> sizes;
  bool volume = count >= 3;
  for (unsigned axis = 0; axis < count; ++axis) {
    sizes.push_back(io.GetDimensions(axis));
    volume &= axis < 3 || sizes.back() == 1;
  }
  if (!volume) throw InputError(fmt::format("{}: expected a 3D image, found {} samples", path, fmt::join(sizes, "x")));
  if (io.GetNumberOfComponents() != 1)
    throw InputError(fmt::format("{}: expected one value per sample, found {} ({})", path, io.GetNumberOfComponents(),
                                 itk::ImageIOBase::GetPixelTypeAsString(io.GetPixelType())));
  return {sizes[0], sizes[1], sizes[2]};
}

glm::dmat4 placementOf(const std::string& path, const itk::ImageIOBase& io) {
  glm::dvec3 spacing, origin;
  glm::dmat3 direction;
  for (unsigned axis = 0; axis < 3; ++axis) {
    spacing[static_cast<int>(axis)] = io.GetSpacing(axis);
    origin[static_cast<int>(axis)] = io.GetOrigin(axis);
    const std::vector<double> column = io.GetDirection(axis);
    direction[static_cast<int>(axis)] = {column.at(0), column.at(1), column.at(2)};
  }
  return placeGrid(path, spacing, direction, origin);
}

/// ITK's reader of NRRD notices a file that ends too soon, that of TIFF a page that does; for the rest this does.
void requireWhole(const std::string& path, std::string_view format, std::uint64_t sampleBytes) {
  constexpr std::uint64_t kGiplHeader = 256;
  if (format == "NIfTI") requireWholeNifti(path);
  if (format == "MRC") requireWholeMrc(path);
  if (format == "VTK legacy image") requireWholeVtk(path, sampleBytes);
  if (format == "TIFF") requireWholeTiff(path);
  if (format == "GIPL") requireContent(path, kGiplHeader, sampleBytes);
}

}  // namespace

bool itkCanRead(const std::string& path) { return formatOf(path) != nullptr; }

Volume readItk(const std::string& path, const std::string& feature, const std::optional<glm::dmat4>& worldFromGrid) {
  const ItkFormat* format = formatOf(path);
  if (!format) throw InputError(fmt::format("{}: expected {}, found nothing that ITK can read as such", path, feature));
  const itk::ImageIOBase::Pointer io = format->make();
  io->SetFileName(path);
  guarded(path, [&] { io->ReadImageInformation(); });

  Volume volume;
  const SampleType type = sampleTypeOf(path, *io);
  const glm::i64vec3 size = spatialSize(path, *io);
  volume.worldFromGrid = worldFromGrid ? *worldFromGrid : placementOf(path, *io);
  volume.values = makeGrid(path, size, volume.worldFromGrid, bytesPerSample(type));

  requireWhole(path, format->name, volume.values.count() * bytesPerSample(type));

  itk::ImageIORegion region(io->GetNumberOfDimensions());
  for (unsigned axis = 0; axis < io->GetNumberOfDimensions(); ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io->GetDimensions(axis));
  }
  io->SetIORegion(region);
  // Zeroed, since some of ITK's readers return without an error before the buffer is full.
  std::vector<std::byte> stored(volume.values.count() * bytesPerSample(type));
  guarded(path, [&] { io->Read(stored.data()); });
  // ITK has turned the samples to this machine's byte order.
  ConvertedSamples converted =
      convertSamples([&](std::size_t first, std::size_t, std::byte*) { return stored.data() + first; }, type, false,
                     volume.values.view());

  volume.valueOffset = converted.valueOffset;
  volume.notes = std::move(converted.notes);
  volume.format = format->name;
  volume.sampleType = sampleTypeName(type);
  volume.world = format->world;
  // NRRD states its space or leaves it open; ITK's own coordinates then mean nothing more than the file's.
  std::string space;
  if (volume.format == "NRRD" && !itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), "NRRD_space", space))
    volume.world = "";
  volume.files = {path};
  return volume;
}

}  // namespace isolume
