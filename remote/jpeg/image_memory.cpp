// Memory manager for libjpeg's pool JPOOL_IMAGE.
#include "remote/jpeg/image_memory.hpp"

#include <jerror.h>

#include <algorithm>
#include <cstdint>

namespace darwinop::remote {
namespace {

// libjpeg-turbo's SIMD code needs alignment 32 and writes up to twice that past the end of a row (see jmemmgr.c).
constexpr std::size_t kAlign = 64;
constexpr std::size_t kBytes = 64 * 1024;  // 19 KB are used for rows of 320 pixels; a test checks it

constexpr std::size_t roundedUp(std::size_t bytes) {
  return (bytes + kAlign - 1) / kAlign * kAlign;
}

}  // namespace

ImageMemory::ImageMemory(jpeg_compress_struct& cinfo) : libjpegs_{*cinfo.mem}, bytes_(kBytes + kAlign) {
  cinfo.client_data = this;
  cinfo.mem->alloc_small = allocateSmall;
  cinfo.mem->alloc_large = allocateLarge;
  cinfo.mem->alloc_sarray = allocateSamples;
  cinfo.mem->alloc_barray = allocateBlocks;
  cinfo.mem->free_pool = freePool;
}

void* ImageMemory::take(j_common_ptr cinfo, std::size_t bytes) {
  ImageMemory& memory = of(cinfo);
  bytes = roundedUp(bytes);
  if (bytes > kBytes - memory.used_) {
    cinfo->err->msg_code = JERR_OUT_OF_MEMORY;
    cinfo->err->error_exit(cinfo);
  }
  const std::size_t start = kAlign - reinterpret_cast<std::uintptr_t>(memory.bytes_.data()) % kAlign;
  void* taken = memory.bytes_.data() + start + memory.used_;
  memory.used_ += bytes;
  memory.most_ = std::max(memory.most_, memory.used_);
  return taken;
}

void* ImageMemory::allocateSmall(j_common_ptr cinfo, int pool, std::size_t bytes) {
  return pool == JPOOL_IMAGE ? take(cinfo, bytes) : of(cinfo).libjpegs_.alloc_small(cinfo, pool, bytes);
}

void* ImageMemory::allocateLarge(j_common_ptr cinfo, int pool, std::size_t bytes) {
  return pool == JPOOL_IMAGE ? take(cinfo, bytes) : of(cinfo).libjpegs_.alloc_large(cinfo, pool, bytes);
}

JSAMPARRAY ImageMemory::allocateSamples(j_common_ptr cinfo, int pool, JDIMENSION columns, JDIMENSION rows) {
  if (pool != JPOOL_IMAGE) return of(cinfo).libjpegs_.alloc_sarray(cinfo, pool, columns, rows);
  auto* array = static_cast<JSAMPARRAY>(take(cinfo, rows * sizeof(JSAMPROW)));
  for (JDIMENSION row = 0; row < rows; ++row) array[row] = static_cast<JSAMPROW>(take(cinfo, columns));
  return array;
}

JBLOCKARRAY ImageMemory::allocateBlocks(j_common_ptr cinfo, int pool, JDIMENSION columns, JDIMENSION rows) {
  if (pool != JPOOL_IMAGE) return of(cinfo).libjpegs_.alloc_barray(cinfo, pool, columns, rows);
  auto* array = static_cast<JBLOCKARRAY>(take(cinfo, rows * sizeof(JBLOCKROW)));
  for (JDIMENSION row = 0; row < rows; ++row)
    array[row] = static_cast<JBLOCKROW>(take(cinfo, columns * sizeof(JBLOCK)));
  return array;
}

void ImageMemory::freePool(j_common_ptr cinfo, int pool) {
  if (pool == JPOOL_IMAGE)
    of(cinfo).used_ = 0;
  else
    of(cinfo).libjpegs_.free_pool(cinfo, pool);
}

}  // namespace darwinop::remote
