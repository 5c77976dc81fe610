// Message texts of reports that more than one place needs: terminal, page, model file and tests.
#pragma once

#include <string_view>

namespace darwinop::gap::messages {

// Why an effect that improves the fit is not named: after its id, and after its title.
inline constexpr std::string_view kVoltage = "fits, but the measured voltage does not drop as this effect requires";
inline constexpr std::string_view kUndecided = "possible; the report names the experiment that decides";
inline constexpr std::string_view kNoPredictiveGain = "fits these logs and predicts no left-out log better";
inline constexpr std::string_view kWorsensHeldOut = "fits these logs and worsens the held-out logs";
inline constexpr std::string_view kVoltageInFull =
    " would improve the fit, but the measured voltage does not drop as this effect requires.";
inline constexpr std::string_view kNoPredictiveGainInFull =
    " would improve the fit, but predicts no log better that the fit leaves out.";
inline constexpr std::string_view kWorsensHeldOutInFull =
    " would improve the fit, but increases the error on the held-out logs by half or more.";

inline constexpr std::string_view kRemainder = "; a remainder is left that no effect of the catalogue explains.";
inline constexpr std::string_view kNotIdentifiable = "not identifiable from these data";
inline constexpr std::string_view kHeldOutLogs = "held-out logs";
inline constexpr std::string_view kNoHeldOutLog = "No log of this case is held out.";
inline constexpr std::string_view kWorse = "do not use the changed model";
inline constexpr std::string_view kBelowFloorFlag = "below the floor";
inline constexpr std::string_view kBelowFloor =
    "Below the floor: closer to these data than noise lets any model come. Either the servo is quieter than assumed, "
    "or "
    "the log is not a measurement of its own: a copy, or a simulation. Do not count it as a success.";

}  // namespace darwinop::gap::messages
