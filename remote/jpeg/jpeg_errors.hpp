// Error handler for libjpeg, which requires that error_exit() does not return.
#pragma once

#include <cstdio>
// jpeglib.h requires stdio.h before it.
#include <jpeglib.h>

#include <csetjmp>
#include <exception>

namespace darwinop::remote {

/// Errors longjmp to `back`, which the caller sets with setjmp before it sets `expected`; no object between the two may
/// have a destructor. Warnings are counted by libjpeg and not printed.
struct JpegErrorHandler {
  JpegErrorHandler() {
    jpeg_std_error(&manager);
    manager.error_exit = [](j_common_ptr common) {
      auto* errors = reinterpret_cast<JpegErrorHandler*>(common->err);
      if (!errors->expected) std::terminate();  // out of memory while libjpeg is being set up
      std::longjmp(errors->back, 1);
    };
    manager.output_message = [](j_common_ptr) {};
  }
  JpegErrorHandler(const JpegErrorHandler&) = delete;
  JpegErrorHandler& operator=(const JpegErrorHandler&) = delete;

  jpeg_error_mgr manager{};  // first member: libjpeg passes its address, which is cast back
  std::jmp_buf back{};
  bool expected = false;
};

}  // namespace darwinop::remote
