// Memory for one picture at a time, in place of what libjpeg takes from the heap and gives back for each.
#pragma once

#include <cstdio>
// libjpeg's header needs stdio's before it.
#include <jpeglib.h>

#include <cstddef>
#include <vector>

namespace darwinop::remote {

/// Takes over pool JPOOL_IMAGE of a compressor; what lives as long as the compressor stays with libjpeg. For one that
/// needs no arrays on disk: one scan, standard tables. Must outlive the compressor's last picture, and stay where it
/// is.
class ImageMemory {
 public:
  /// `cinfo` has been made by jpeg_create_compress; its client_data belongs to this from now on.
  explicit ImageMemory(jpeg_compress_struct& cinfo);
  ImageMemory(const ImageMemory&) = delete;
  ImageMemory& operator=(const ImageMemory&) = delete;

  [[nodiscard]] std::size_t most() const noexcept { return most_; }  // that was ever in use, bytes

 private:
  static ImageMemory& of(j_common_ptr cinfo) noexcept { return *static_cast<ImageMemory*>(cinfo->client_data); }
  static void* allocateSmall(j_common_ptr cinfo, int pool, std::size_t bytes);
  static void* allocateLarge(j_common_ptr cinfo, int pool, std::size_t bytes);
  static JSAMPARRAY allocateSamples(j_common_ptr cinfo, int pool, JDIMENSION columns, JDIMENSION rows);
  static JBLOCKARRAY allocateBlocks(j_common_ptr cinfo, int pool, JDIMENSION columns, JDIMENSION rows);
  static void freePool(j_common_ptr cinfo, int pool);
  static void* take(j_common_ptr cinfo, std::size_t bytes);

  jpeg_memory_mgr libjpegs_;
  std::vector<unsigned char> bytes_;
  std::size_t used_ = 0, most_ = 0;
};

}  // namespace darwinop::remote
