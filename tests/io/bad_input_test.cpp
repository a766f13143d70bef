// Files that are no volumes, by path, content and kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "errors.h"
#include "io/vdb.h"
#include "io/volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string failure(const std::string& path) {
  return messageOf<InputError>([&] { readVolume(path); });
}

TEST(BadInput, PathsThatAreNoFiles) {
  // A missing path, a folder, a pipe and an empty file are told apart, each with its path.
  TempFolder folder;
  EXPECT_THAT(failure(folder.path("gone.raw")), HasSubstr("gone.raw: cannot be read: No such file"));
  EXPECT_THAT(failure(folder.path("")), HasSubstr("expected a file, found a folder"));
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_THAT(failure(folder.path("pipe")), HasSubstr("expected a regular file"));
  for (const char* name : {"a.raw", "a.vdb", "a.mhd", "a.nhdr", "a.nii.gz", "a.mrc"})
    EXPECT_THAT(failure(folder.write(name, "")), HasSubstr("found an empty file (0 bytes)"));
}

TEST(BadInput, NoPermission) {
  // A file that this user may not read says so.
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  TempFolder folder;
  const std::string path = folder.write("a_2x2x2_uint8.raw", "12345678");
  chmod(path.c_str(), 0);
  EXPECT_THAT(failure(path), HasSubstr("Permission denied"));
}

TEST(BadInput, FormatsThatNobodyReads) {
  // A known foreign format is named, with what would help; an unknown one lists what is supported.
  TempFolder folder;
  const auto dicom = std::string(128, '\0') + "DICM" + std::string(64, '\0');
  EXPECT_THAT(failure(folder.write("a.vti", "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\">")),
              testing::AllOf(HasSubstr(".vti"), HasSubstr("VDB, raw, .mhd, .mha, .nhdr")));
  EXPECT_THAT(failure(folder.write("b.vti", "<VTKFile type=\"ImageData\">")), HasSubstr("VTK XML"));
  EXPECT_THAT(failure(folder.write("a.dcm", dicom)), HasSubstr("DICOM"));
  EXPECT_THAT(failure(folder.write("a.h5", "\x89HDF\r\n\x1a\n........")), HasSubstr("HDF5"));
  EXPECT_THAT(failure(folder.write("a.npy", "\x93NUMPY........")), HasSubstr("NumPy"));
  EXPECT_THAT(failure(folder.write("a.txt", "hello, world")), HasSubstr("unknown format"));
}

TEST(BadInput, ContentGoesBeforeTheName) {
  // What calls itself by a known ending but has another content is refused, not misread.
  TempFolder folder;
  for (const char* name : {"a.nii.gz", "a.nii", "a.mrc", "a.nrrd", "a.vdb", "a.tif", "a.mha"})
    EXPECT_THAT(failure(folder.write(name, std::string(2000, 'x'))), StartsWith(folder.path(name) + ": ")) << name;
}

TEST(BadInput, DamagedVdb) {
  // A VDB that is cut anywhere in its head, or whose head is nonsense, is an error and no crash.
  TempFolder folder;
  const std::string magic(" BDV\0\0\0\0", 8);
  for (std::size_t zeros : {0, 1, 4, 12, 13, 40, 60, 100})
    EXPECT_THAT(failure(folder.write("a.vdb", magic + std::string(zeros, '\0'))), HasSubstr("a.vdb: "));
  EXPECT_THAT(failure(folder.write("b.vdb", magic + std::string(200, '\xff'))), HasSubstr("b.vdb: "));
  EXPECT_THAT(messageOf<InputError>([&] { listVdbGrids(folder.path("b.vdb")); }), HasSubstr("b.vdb: "));
}

}  // namespace
}  // namespace isolume::test
