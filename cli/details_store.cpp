// SPDX-License-Identifier: MIT
#include "cli/details_store.h"

#include <fstream>
#include <iterator>

#include "cli/error.h"
#ifdef ARETE_HAVE_ZLIB
#include <zlib.h>
#endif

namespace arete::cli {
namespace {

#ifdef ARETE_HAVE_ZLIB
Bytes pack(std::span<const std::uint8_t> bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes packed(size);
  if (compress2(packed.data(), &size, bytes.data(), bytes.size(), 6) != Z_OK)
    return {bytes.begin(), bytes.end()};  // not smaller: the block is stored as it is
  packed.resize(size);
  return packed;
}

Bytes unpack(std::span<const std::uint8_t> bytes, std::size_t size) {
  Bytes unpacked(size);
  uLongf found = size;
  if (uncompress(unpacked.data(), &found, bytes.data(), bytes.size()) != Z_OK || found != size)
    return {};
  return unpacked;
}
#else
const Pack pack;
const Unpack unpack;
#endif

std::size_t write_bytes(const std::filesystem::path& path, const Bytes& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw Failure(path.string() + " cannot be written; check free space");
  return bytes.size();
}

Bytes read_bytes(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw Failure(path + " is a folder; name a details file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Failure(path + " cannot be read; check the path");
  Bytes bytes(std::istreambuf_iterator<char>(stream), {});
  if (stream.bad()) throw Failure(path + " cannot be read to its end; the file may be damaged");
  return bytes;
}

template <class Decode>
auto decoded(const std::string& path, Decode&& decode) {
  const Bytes bytes = read_bytes(path);
  try {
    return decode(bytes, unpack);
  } catch (const InvalidDetails& refused) {
    throw Failure(path + ": " + refused.what());
  }
}

}  // namespace

std::size_t write_details(const std::filesystem::path& path, const DetailsFile& details) {
  return write_bytes(path, encode_details(details, pack));
}
std::size_t write_details(const std::filesystem::path& path, const MeshDetailsFile& details) {
  return write_bytes(path, encode_mesh_details(details, pack));
}

DetailsFile read_details(const std::string& path) {
  return decoded(path, [](const Bytes& bytes, const Unpack& unpacked) {
    return decode_details(bytes, unpacked);
  });
}
MeshDetailsFile read_mesh_details(const std::string& path) {
  return decoded(path, [](const Bytes& bytes, const Unpack& unpacked) {
    return decode_mesh_details(bytes, unpacked);
  });
}
bool holds_mesh_details(const std::string& path) { return are_mesh_details(read_bytes(path)); }

}  // namespace arete::cli
