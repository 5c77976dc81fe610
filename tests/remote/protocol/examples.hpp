// Exchanges of the protocol written down byte by byte, as the clients of 2013 and of today make them.
#pragma once

#include "remote/protocol/request.hpp"
#include "remote/protocol/units.hpp"

namespace darwinop::remote {

inline Request requestForMotor(const MotorSetting& motor) {
  Request request;
  (void)request.motors.add(motor);
  return request;
}

inline const char* const kEmptyRequest = "57 04 00 00";
inline const char* const kEmptyReply = "57 00 00 00 05 00";
inline const char* const kInertialRequest = "57 06 00 41 47 00";
inline const char* const kInertialReply =
    "57 00 00 00 1d 00 00 02 00 00 00 01 f2 00 00 02 80 00 00 01 ff 00 00 02 00 00 00 02 01 00";
inline const char* const kNeckRequest = "57 0b 00 53 12 70 00 00 01 45 00";
inline const char* const kHeadRequest = "57 10 00 53 13 70 ff ff ff 5e 76 00 00 00 a7 00";
inline const char* const kSixRequest =
    "57 2c 00 53 02 70 ff ff fd 75 76 00 00 00 7d 61 00 05 57 30 6d 00 00 01 ff "
    "63 00 00 27 10 00 00 00 00 00 00 00 00 66 00 00 00 cc 00";
inline const char* const kNoRampRequest = "57 0b 00 53 02 61 ff fe 79 60 00";
inline const char* const kLedRequest = "57 0e 00 4c 00 ff 00 00 4c 02 00 00 01 00";
inline const char* const kFeedbackRequest = "57 0a 00 50 12 50 13 46 12 00";
inline const char* const kFeedbackReply = "57 00 00 00 11 00 00 00 1e 00 00 07 7f 00 00 07 59 00";
inline const char* const kCameraRequest = "57 05 00 43 00";
inline const char* const kCameraReply = "57 00 00 00 11 00 00 00 08 ff d8 ff e0 00 10 ff d9 00";
inline const char* const kPollRequest =
    "57 2f 00 41 47 43 50 00 50 01 50 02 50 03 50 04 50 05 50 06 50 07 50 08 50 09 50 0a 50 0b 50 0c 50 0d 50 0e "
    "50 0f 50 10 50 11 50 12 50 13 00";

/// All of them, as requests.
inline const char* const kRequests[] = {kEmptyRequest,  kInertialRequest, kNeckRequest, kHeadRequest,
                                        kSixRequest,    kNoRampRequest,   kLedRequest,  kFeedbackRequest,
                                        kCameraRequest, kPollRequest};

}  // namespace darwinop::remote
