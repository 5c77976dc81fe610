// Preallocated memory for libjpeg, in place of heap allocations for every picture.
#pragma once

#include <cstdio>
// jpeglib.h requires stdio.h before it.
#include <jpeglib.h>

#include <cstddef>
#include <vector>

namespace darwinop::remote {

/// Replaces pool JPOOL_IMAGE of a compressor; the permanent pool stays with libjpeg. Only for one scan and standard
/// tables, which need no backing store. Must outlive the compressor's last picture and must not move.
class ImageMemory {
 public:
  /// `cinfo` must come from jpeg_create_compress(); this object uses its client_data.
  explicit ImageMemory(jpeg_compress_struct& cinfo);
  ImageMemory(const ImageMemory&) = delete;
  ImageMemory& operator=(const ImageMemory&) = delete;

  [[nodiscard]] std::size_t most() const noexcept { return most_; }  // peak usage, bytes

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
