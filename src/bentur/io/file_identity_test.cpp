#include "bentur/io/file_identity.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "bentur/io/temporary_folder.h"

namespace bentur {
namespace {

/// The examples of FIPS 180-4 and NIST's "SHA_All.pdf".
TEST(Sha256, PublishedExamples) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

/// Every filling of the last block, of which some need one more: two lengths never have the same hash, and a file has
/// that of its content.
TEST(Sha256, AFileHasTheHashOfItsContent) {
  const TemporaryFolder folder;
  std::string before;
  for (const std::size_t length : {0U, 1U, 54U, 55U, 56U, 57U, 63U, 64U, 65U, 119U, 120U, 65535U, 65536U, 65537U}) {
    const std::string text(length, 'x');
    std::ofstream(folder.path() / "file", std::ios::binary) << text;
    const FileIdentity identity = identify(folder.path() / "file");
    EXPECT_EQ(identity.size, length);
    EXPECT_EQ(identity.sha256, sha256(text));
    EXPECT_NE(identity.sha256, before);
    before = identity.sha256;
  }
  EXPECT_THROW(static_cast<void>(identify(folder.path() / "none")), std::runtime_error);
}

}  // namespace
}  // namespace bentur
