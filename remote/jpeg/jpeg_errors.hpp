// What libjpeg complains of: it reports errors by a call that must not return.
#pragma once

#include <cstdio>
// libjpeg's header needs stdio's before it.
#include <jpeglib.h>

#include <csetjmp>
#include <exception>

namespace darwinop::remote {

/// Errors of libjpeg jump to `back`, which the caller has set and to which it has said so by `expected`; nothing in
/// between may have a destructor. Warnings are counted by libjpeg and printed by nobody.
struct JpegComplaints {
  JpegComplaints() {
    jpeg_std_error(&manager);
    manager.error_exit = [](j_common_ptr common) {
      auto* complaints = reinterpret_cast<JpegComplaints*>(common->err);
      if (!complaints->expected) std::terminate();  // out of memory, while it is being made
      std::longjmp(complaints->back, 1);
    };
    manager.output_message = [](j_common_ptr) {};
  }
  JpegComplaints(const JpegComplaints&) = delete;
  JpegComplaints& operator=(const JpegComplaints&) = delete;

  jpeg_error_mgr manager{};  // first: libjpeg hands out its address
  std::jmp_buf back{};
  bool expected = false;
};

}  // namespace darwinop::remote
