// Rows of YUYV to planes in reverse pixel order; used by yuyv_to_planes.cpp only.
#pragma once

#include <cstdint>

namespace darwinop::pixels {

/// Writes `width` bytes.
using LumaRow = void(const std::uint8_t* yuyv, int width, std::uint8_t* y) noexcept;

/// Mean chroma of two rows, which may be the same row. Writes pairsOf(width) bytes to each plane.
using ChromaRow = void(const std::uint8_t* upper, const std::uint8_t* lower, int width, std::uint8_t* u,
                       std::uint8_t* v) noexcept;

LumaRow lumaRowScalar;
ChromaRow chromaRowScalar;
#ifdef __SSE2__
LumaRow lumaRowSse2;
ChromaRow chromaRowSse2;
#elif defined(__ARM_NEON)
LumaRow lumaRowNeon;
ChromaRow chromaRowNeon;
#endif

}  // namespace darwinop::pixels
