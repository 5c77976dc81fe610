// USB adapters: identity, new numbers after a replug, latency timer, and which port is used.
#include "hal/cm730/usb_serial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"
#include "support/usb_tree.hpp"

namespace darwinop::cm730 {
namespace {

using testing::HasSubstr;

TEST(UsbSerial, IdentifiesADeviceByVendorProductAndSerialNumber) {
  UsbTree sys;
  sys.plug("ttyUSB0", "0403", "A900");
  const auto identity = usbIdentity("/dev/ttyUSB0", sys.root());
  ASSERT_TRUE(identity);
  EXPECT_EQ(*identity, (UsbIdentity{"0403", "6001", "A900"}));
  EXPECT_FALSE(usbIdentity("/dev/ttyUSB1", sys.root()));
}

TEST(UsbSerial, OnlyTheSameDeviceReplacesALostOne) {
  UsbTree sys;
  sys.plug("ttyUSB1", "0403", "A900");
  sys.plug("ttyUSB2", "0403", "OTHER");
  sys.plug("ttyUSB3", "067b", "B1");
  using testing::ElementsAre;
  EXPECT_THAT(siblings("/dev/ttyUSB0", UsbIdentity{"0403", "6001", "A900"}, sys.root()), ElementsAre("/dev/ttyUSB1"));
  EXPECT_THAT(siblings("/dev/ttyUSB0", std::nullopt, sys.root()), testing::IsEmpty()) << "none is known to be it";
}

TEST(UsbSerial, AnAdapterWithoutASerialNumberIsNotReplacedByAnotherOne) {
  UsbTree sys;
  sys.plugInto("1-1.2", "ttyUSB0");
  sys.plugInto("1-1.3", "ttyUSB1");
  const auto ours = usbIdentity("/dev/ttyUSB0", sys.root());
  ASSERT_TRUE(ours);
  EXPECT_THAT(siblings("/dev/ttyUSB0", ours, sys.root()), testing::IsEmpty());
  EXPECT_NE(usbIdentity("/dev/ttyUSB1", sys.root()), ours);

  sys.unplug("ttyUSB0");
  sys.unplug("ttyUSB1");
  sys.plugInto("1-1.3", "ttyUSB0");  // the other one gets the number
  EXPECT_NE(usbIdentity("/dev/ttyUSB0", sys.root()), ours);
  sys.plugInto("1-1.2", "ttyUSB1");  // ours comes back under another number, in the same socket
  EXPECT_THAT(siblings("/dev/ttyUSB0", ours, sys.root()), testing::ElementsAre("/dev/ttyUSB1"));
}

TEST(UsbSerial, APortIsOfferedUntilItIsKnownToBeAnotherDevice) {
  UsbTree sys;
  sys.plug("ttyUSB0", "0403", "OTHER");
  sys.plug("ttyUSB1", "0403", "A900");
  using testing::ElementsAre;
  const UsbIdentity ours{"0403", "6001", "A900"};
  EXPECT_THAT(portsOf("/dev/ttyUSB0", std::nullopt, sys.root()), ElementsAre("/dev/ttyUSB0"));
  EXPECT_THAT(portsOf("/dev/ttyUSB1", ours, sys.root()), ElementsAre("/dev/ttyUSB1"));
  EXPECT_THAT(portsOf("/dev/ttyUSB0", ours, sys.root()), ElementsAre("/dev/ttyUSB1")) << "another robot's";
  sys.unplug("ttyUSB1");
  EXPECT_THAT(portsOf("/dev/ttyUSB0", ours, sys.root()), testing::IsEmpty());
}

TEST(UsbSerial, AnAdapterWithASerialNumberIsTheSameInAnySocket) {
  UsbTree sys;
  sys.plugInto("1-1.2", "ttyUSB0", "0403", "A900");
  sys.plugInto("1-1.3", "ttyUSB1", "0403", "A900");
  EXPECT_EQ(usbIdentity("/dev/ttyUSB0", sys.root()), usbIdentity("/dev/ttyUSB1", sys.root()));
}

TEST(UsbSerial, ReadsAndSetsTheLatencyTimer) {
  UsbTree sys;
  sys.plug("ttyUSB0", "0403", "A900", 16);
  EXPECT_EQ(latencyTimer("/dev/ttyUSB0", sys.root()), 16);
  EXPECT_TRUE(setLatencyTimer("/dev/ttyUSB0", 1, sys.root()));
  EXPECT_EQ(latencyTimer("/dev/ttyUSB0", sys.root()), 1);
  EXPECT_FALSE(setLatencyTimer("/dev/ttyUSB5", 1, sys.root()));
}

TEST(CandidatePorts, AreTheSortedUsbSerialPorts) {
  const TemporaryFolder dev;
  for (const char* name : {"ttyUSB1", "ttyS0", "ttyACM0", "ttyUSB0", "null"}) std::ofstream{dev / name};
  const std::string at = dev / "";
  EXPECT_THAT(candidatePorts(dev / ""), testing::ElementsAre(at + "ttyACM0", at + "ttyUSB0", at + "ttyUSB1"));
}

TEST(ChoosePort, UsesTheRequestedPortElseTheFirstOne) {
  EXPECT_EQ(choosePort("/tmp/robot", {"/dev/ttyUSB3"}), "/tmp/robot");
  EXPECT_EQ(choosePort("", {"/dev/ttyUSB3", "/dev/ttyUSB4"}), "/dev/ttyUSB3");
  EXPECT_EQ(choosePort("", {}), "/dev/ttyUSB0");
  EXPECT_THROW(choosePort("tcp://robot", {}), std::runtime_error);
}

TEST(ChoosePort, ReportsARemedyForARobotWithoutAPort) {
  const auto error = [](const char* asked) -> std::string {
    try {
      return choosePort(asked, {});
    } catch (const std::runtime_error& wrong) {
      return wrong.what();
    }
  };
  EXPECT_THAT(error("runtime"), HasSubstr("runtime --status"));
  EXPECT_THAT(error("virtual"), HasSubstr("virtual-robot`"));
}

}  // namespace
}  // namespace darwinop::cm730
