#include "checksum.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "src/errors.h"

namespace isolume {
namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(const void* data, std::size_t size) { require(EVP_DigestUpdate(context_.get(), data, size) == 1); }
  std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1);
    std::string text;
    for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
  }

 private:
  // OpenSSL refuses SHA-256 only when it cannot allocate or its providers are misconfigured: nothing the input caused.
  static void require(bool ok) {
    if (!ok) throw std::runtime_error("SHA-256: OpenSSL refused to compute a digest");
  }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string sha256OfFile(const std::string& path) {
  const auto fail = [&](int error) {
    throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(error)));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) fail(errno);
  constexpr std::size_t kBlock = std::size_t{1} << 20;  // large enough that the calls cost nothing beside the hashing
  std::vector<char> block(kBlock);
  Sha256 hash;
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) hash.add(block.data(), count);
  if (std::ferror(file.get())) fail(errno);
  return hash.hex();
}

std::string sha256OfBytes(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes.data(), bytes.size());
  return hash.hex();
}

}  // namespace isolume
