#include <gmock/gmock.h>

#include "src/errors.h"
#include "src/io/checksum.h"
#include "temporary_folder.h"

namespace isolume {
namespace {

using test::messageOf;

class Checksum : public test::TemporaryFolder {};

TEST_F(Checksum, KnownVectors) {
  // SHA-256 of the published examples is what FIPS 180-2, appendix B, and the empty message's well-known digest say.
  EXPECT_EQ(sha256OfBytes(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256OfBytes("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfBytes("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_F(Checksum, LongFileIsStreamed) {
  // A file longer than the read block, a million times "a" and more, hashes like the same bytes in memory.
  constexpr std::size_t kMillion = 1000000;
  std::ofstream(at("million")) << std::string(kMillion, 'a');
  EXPECT_EQ(sha256OfFile(at("million")), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  const std::string threeMillion(3 * kMillion, 'b');
  std::ofstream(at("more")) << threeMillion;
  EXPECT_EQ(sha256OfFile(at("more")), sha256OfBytes(threeMillion));
}

TEST_F(Checksum, UnreadableFileIsNamed) {
  // A missing file and a folder are input errors with the path and the system's reason.
  EXPECT_EQ(messageOf<InputError>([&] { sha256OfFile(at("none")); }),
            at("none") + ": cannot read: No such file or directory");
  EXPECT_EQ(messageOf<InputError>([&] { sha256OfFile(at("")); }), at("") + ": cannot read: Is a directory");
}

}  // namespace
}  // namespace isolume
