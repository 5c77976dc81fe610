// The message "hello": tables of joints, devices, faults and limits, sent once at the start.
#include <array>
#include <cstring>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "monitor/json.hpp"
#include "monitor/messages.hpp"
#include "remote/jpeg/image_size.hpp"
#include "runtime/version.hpp"

namespace darwinop::monitor {
namespace {

template <std::size_t N>
Json textOfArray(const char (&text)[N]) {
  return std::string{text, strnlen(text, N)};
}

Json jointTable() {
  Json joints = Json::array();
  for (const JointRow& row : kJointTable)
    joints.push_back({{"id", row.id},
                      {"name", row.name},
                      {"sensor", std::string{row.name} + "S"},
                      {"meaning", row.anatomical},
                      {"chain", kChainNames[static_cast<std::size_t>(row.chain)]},
                      {"low", rounded(radFromTicks(row.low).value)},
                      {"high", rounded(radFromTicks(row.high).value)},
                      {"start", rounded(radFromTicks(row.start).value)}});
  return joints;
}

Json faultTable() {
  Json faults = Json::array();
  for (const FaultRow& row : kFaultTable)
    faults.push_back({{"code", static_cast<int>(row.fault)},
                      {"name", row.name},
                      {"meaning", row.meaning},
                      {"remedy", row.remedy},
                      {"reaction", kReactionNames[static_cast<std::size_t>(row.reaction)]},
                      {"latched", row.latched}});
  return faults;
}

Json deviceTable() {
  Json devices = Json::array();
  devices.push_back({{"name", "Accelerometer"}, {"type", "accelerometer"}, {"unit", "m/s2"}});
  devices.push_back({{"name", "Gyro"}, {"type", "gyro"}, {"unit", "rad/s"}});
  devices.push_back({{"name", "Camera"},
                     {"type", "camera"},
                     {"width", remote::kWholeImage.width},
                     {"height", remote::kWholeImage.height}});
  for (const char* led : {"HeadLed", "EyeLed", "BackLedRed", "BackLedGreen", "BackLedBlue"})
    devices.push_back({{"name", led}, {"type", "led"}});
  return devices;
}

}  // namespace

std::string helloText(const runtime::LoopInfo* info, const Subscription& subscription) {
  Json text;
  text["type"] = "hello";
  text["protocol"] = 1;
  text["runtime"] = runtime::version();
  text["robot"] = info != nullptr ? textOfArray(info->robot) : nullptr;
  text["port"] = info != nullptr ? textOfArray(info->port) : nullptr;
  text["period"] = info != nullptr ? rounded(static_cast<double>(info->period_ns) * 1e-9, 1e9) : nullptr;
  text["rate"] = rounded(subscription.rate);
  text["camera"] = rounded(subscription.camera);
  text["most"] = {{"rate", kMostRate}, {"camera", kMostPictures}};
  text["joints"] = jointTable();
  text["devices"] = deviceTable();
  text["signs"] = {"a positive angle or speed turns the servo's horn counter-clockwise",
                   "left and right partners are mounted mirrored: the mirrored angle has the other sign",
                   "a positive load pushes counter-clockwise",
                   "upright and at rest the accelerometer reads 0, 0, +9.8 m/s2"};
  text["faults"] = faultTable();
  text["limits"] = kLimitNames;
  return jsonText(text);
}

}  // namespace darwinop::monitor
