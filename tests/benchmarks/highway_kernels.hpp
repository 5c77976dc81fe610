// The SIMD kernels of hal/pixels and managers/vision, written with Highway: peers of highway_bench.cpp.
#pragma once

#include "hal/pixels/bgra_rows.hpp"
#include "hal/pixels/plane_rows.hpp"
#include "managers/vision/classify.hpp"

namespace darwinop::bench {

/// Each does what ours of that type does, for even widths; classify: multiples of 64.
struct HighwayKernels {
  pixels::BgraRow* bgra;
  pixels::LumaRow* luma;
  pixels::ChromaRow* chroma;
  vision::Classify classify;
};

/// highway_kernels.cpp is compiled once for each.
extern const HighwayKernels highwaySsse3, highwayAvx2;  // Highway 1.0.3 has no SSE2

}  // namespace darwinop::bench
