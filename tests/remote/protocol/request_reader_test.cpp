// The request parser: pieces, neighbours, nonsense.
#include "remote/protocol/request_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "examples.hpp"
#include "remote/protocol/request_writer.hpp"
#include "support/hex.hpp"

namespace darwinop::remote {
namespace {

struct ReadRequests {
  std::vector<Request> requests;
  std::vector<Oddities> oddities;
  bool refused = false;
  std::size_t garbage = 0, pending = 0;
  bool operator==(const ReadRequests&) const = default;
};

/// Feeds `bytes` in pieces of `size`.
ReadRequests readInPieces(std::span<const std::uint8_t> bytes, std::size_t size) {
  RequestReader reader;
  ReadRequests read;
  while (!bytes.empty() && !read.refused) {
    const std::span<std::uint8_t> room = reader.room();
    const std::size_t count = std::min({size, bytes.size(), room.size()});
    std::ranges::copy(bytes.first(count), room.begin());
    reader.filled(count);
    bytes = bytes.subspan(count);
    Request request;
    Oddities oddities;
    for (auto found = reader.next(request, oddities); found != RequestReader::Found::kNothing && !read.refused;
         found = reader.next(request, oddities)) {
      read.refused = found == RequestReader::Found::kRefused;
      if (read.refused) break;
      read.requests.push_back(request);
      read.oddities.push_back(oddities);
    }
  }
  read.garbage = reader.garbageBytes();
  read.pending = reader.pending();
  return read;
}

ReadRequests readAll(const std::string& hex) {
  return readInPieces(fromHex(hex), 10000);
}

TEST(RequestReader, FindsTheSameRequestsHoweverTheyAreCut) {
  std::string all;
  for (const char* const request : kRequests) all += std::string{request} + " ";
  const std::vector<std::uint8_t> bytes = fromHex(all);
  const ReadRequests whole = readInPieces(bytes, bytes.size());
  ASSERT_EQ(whole.requests.size(), std::size(kRequests)) << "all in one segment";
  EXPECT_EQ(whole.pending, 0);
  for (std::size_t size = 1; size < bytes.size(); ++size) EXPECT_EQ(readInPieces(bytes, size), whole) << size;
}

TEST(RequestReader, WaitsForTheLastByte) {
  for (const char* const example : kRequests) {
    const std::vector<std::uint8_t> bytes = fromHex(example);
    for (std::size_t size = 1; size < bytes.size(); ++size)
      EXPECT_TRUE(readInPieces(std::span{bytes}.first(size), size).requests.empty()) << example << ", " << size;
  }
}

TEST(RequestReader, SkipsWhatIsNoRequest) {
  const ReadRequests read = readAll("00 01 02 57 04 00 00 00 57 05 00 43 00");
  ASSERT_EQ(read.requests.size(), 2);
  EXPECT_TRUE(read.requests[1].camera);
  EXPECT_EQ(read.garbage, 4);
}

TEST(RequestReader, NeedsNoNulWithinTheLength) {
  const ReadRequests read = readAll("57 05 00 41 47 57 03 00");
  ASSERT_EQ(read.requests.size(), 2);
  EXPECT_TRUE(read.requests[0].accelerometer && read.requests[0].gyro);
  EXPECT_EQ(read.requests[1], Request{});
  EXPECT_FALSE(read.oddities[0].any());
}

TEST(RequestReader, RefusesLengthsThatNoRequestHas) {
  for (const char* const hex : {"57 00 00", "57 02 00 00", "57 01 04 00", "57 ff ff 41"}) {
    const ReadRequests read = readAll(std::string{hex} + " 57 04 00 00");
    EXPECT_TRUE(read.refused) << hex;
    EXPECT_TRUE(read.requests.empty()) << hex;
  }
}

TEST(RequestReader, TakesTheLongestRequestOfTheOldServer) {
  std::vector<std::uint8_t> bytes(kMostStated, 0);
  bytes[0] = kFirstByte;
  bytes[2] = kMostStated >> 8;
  EXPECT_EQ(readInPieces(bytes, 100).requests.size(), 1);
}

TEST(RequestReader, ASectionInTheWrongPlaceEndsTheReading) {
  const ReadRequests read = readAll("57 08 00 47 41 50 03 00");
  ASSERT_EQ(read.requests.size(), 1);
  EXPECT_TRUE(read.requests[0].gyro) << "what came before counts";
  EXPECT_FALSE(read.requests[0].accelerometer);
  EXPECT_TRUE(read.requests[0].positions.empty());
  EXPECT_EQ(read.oddities[0].unknown_at, 4);
  EXPECT_EQ(read.oddities[0].unknown_byte, 0x41);
}

TEST(RequestReader, SubCommandsHaveAnOrderToo) {
  const ReadRequests read = readAll("57 10 00 53 00 76 00 00 00 01 70 00 00 00 01 00");
  ASSERT_EQ(read.requests.size(), 1);
  ASSERT_EQ(read.requests[0].motors.size(), 1);
  EXPECT_EQ(read.requests[0].motors[0].set, MotorSetting::kVelocity);
  EXPECT_EQ(read.oddities[0].unknown_byte, 0x70);
}

TEST(RequestReader, ASectionThatIsCutOffIsNotObeyed) {
  const ReadRequests read = readAll("57 09 00 53 12 70 00 00 01 57 05 00 50 57 04 00 50");
  ASSERT_EQ(read.requests.size(), 2);
  ASSERT_EQ(read.requests[0].motors.size(), 1);
  EXPECT_EQ(read.requests[0].motors[0].set, 0);
  EXPECT_TRUE(read.oddities[0].cut_off);
  EXPECT_EQ(read.oddities[0].unknown_at, 0);
  EXPECT_TRUE(read.oddities[1].any());
}

TEST(RequestReader, MotorsAndLedsThatDoNotExistAreLeftOut) {
  const ReadRequests read = readAll("57 19 00 4c 05 00 00 01 53 14 70 00 00 01 45 53 ff 53 13 70 00 00 00 01 00");
  ASSERT_EQ(read.requests.size(), 1);
  ASSERT_EQ(read.requests[0].motors.size(), 1);
  EXPECT_EQ(read.requests[0].motors[0].joint, Joint::kHead);
  EXPECT_TRUE(read.requests[0].leds.empty());
  EXPECT_EQ(read.oddities[0], (Oddities{.refused_leds = 1, .refused_motors = 2}));
}

TEST(RequestReader, SensorsThatDoNotExistAreToldButStayInTheList) {
  const ReadRequests read = readAll("57 0a 00 50 14 50 80 46 ff 00");
  ASSERT_EQ(read.requests.size(), 1);
  ASSERT_EQ(read.requests[0].positions.size(), 2);
  EXPECT_EQ(read.requests[0].positions[1], 0x80);
  EXPECT_EQ(read.oddities[0].refused_sensors, 3);
}

TEST(RequestReader, NoSectionComesMoreOftenThanItMay) {
  std::vector<std::uint8_t> bytes{kFirstByte, 46, 0};
  for (int i = 0; i < 21; ++i) bytes.insert(bytes.end(), {'P', 1});
  bytes.push_back(0);
  const ReadRequests read = readInPieces(bytes, 100);
  ASSERT_EQ(read.requests.size(), 1);
  EXPECT_EQ(read.requests[0].positions.size(), kJoints);
  EXPECT_EQ(read.oddities[0].unknown_byte, 'P');
}

Request anyRequest() {
  using rc::gen::arbitrary;
  const auto flag = [] { return *arbitrary<bool>(); };
  const auto count = [](std::size_t most) { return *rc::gen::inRange<std::size_t>(0, most + 1); };
  Request request{.accelerometer = flag(),
                  .gyro = flag(),
                  .camera = flag(),
                  .leds = {},
                  .motors = {},
                  .positions = {},
                  .torques = {},
                  .extension = {}};
  for (std::size_t i = count(kLeds); i > 0; --i)
    (void)request.leds.add(
        {static_cast<Led>(*rc::gen::inRange<unsigned>(0, kLeds)), *rc::gen::inRange<std::uint32_t>(0, 0x1000000)});
  for (std::size_t i = count(kJoints); i > 0; --i) {
    MotorSetting motor{.joint = static_cast<Joint>(*rc::gen::inRange<unsigned>(0, kJoints)),
                       .set = *rc::gen::inRange<std::uint8_t>(0, 64)};
    const auto word = [&](MotorSetting::Bit bit) { return motor.has(bit) ? *arbitrary<std::int32_t>() : 0; };
    motor.position = word(MotorSetting::kPosition);
    motor.velocity = word(MotorSetting::kVelocity);
    motor.acceleration = word(MotorSetting::kAcceleration);
    motor.available_torque = word(MotorSetting::kAvailableTorque);
    for (std::int32_t& part : motor.pid) part = word(MotorSetting::kPid);
    motor.torque = word(MotorSetting::kTorque);
    (void)request.motors.add(motor);
  }
  for (std::size_t i = count(kJoints); i > 0; --i) (void)request.positions.add(*arbitrary<std::uint8_t>());
  for (std::size_t i = count(kJoints); i > 0; --i) (void)request.torques.add(*arbitrary<std::uint8_t>());
  request.extended = flag();
  if (request.extended)
    request.extension = {.until_cycle = *arbitrary<std::uint64_t>(),
                         .fault_resets = *arbitrary<std::uint32_t>(),
                         .picture = *arbitrary<std::uint32_t>(),
                         .start_where_it_is = flag(),
                         .farewell = flag(),
                         .unattended = flag()};
  return request;
}

RC_GTEST_PROP(RequestReader, ReadsBackWhatWasWritten, ()) {
  const Request first = anyRequest(), second = anyRequest();
  RequestBuffer buffer;
  std::vector<std::uint8_t> bytes;
  for (const Request* const request : {&first, &second}) {
    const auto written = writeRequest(*request, buffer);
    bytes.insert(bytes.end(), written.begin(), written.end());
  }
  const ReadRequests read = readInPieces(bytes, *rc::gen::inRange<std::size_t>(1, 2000));
  RC_ASSERT(read.requests == (std::vector<Request>{first, second}));
  RC_ASSERT(read.oddities[0].unknown_at == 0U);
  RC_ASSERT(read.pending == 0U);
}

TEST(RequestReader, TheLongestRequestHasTheLengthOfTheBook) {
  Request request{.accelerometer = true,
                  .gyro = true,
                  .camera = true,
                  .leds = {},
                  .motors = {},
                  .positions = {},
                  .torques = {},
                  .extension = {}};
  while (request.leds.add({})) {
  }
  while (request.motors.add({.joint = {}, .set = 63})) {
  }
  while (request.positions.add(0) && request.torques.add(0)) {
  }
  RequestBuffer buffer;
  EXPECT_EQ(writeRequest(request, buffer).size(), kLongestOldRequest);
  request.extended = true;
  EXPECT_EQ(writeRequest(request, buffer).size(), kLongestRequest);
}

}  // namespace
}  // namespace darwinop::remote
