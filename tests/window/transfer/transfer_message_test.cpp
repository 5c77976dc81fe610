// Transfer requests of a page and the resulting command lines.
#include "window/transfer/transfer_message.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/temporary_folder.hpp"
#include "window/messages.hpp"
#include "window/transfer/transfer_command.hpp"

namespace darwinop {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kFingerprint = "SHA256:AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA";

std::string refusalOf(const std::string& text) {
  std::string why;
  return window::parseTransfer(text, why) ? "taken" : why;
}

/// A start request with this robot.
std::string startWith(const std::string& robot) {
  return R"({"start": {"action": "status", "robot": )" + robot + "}}";
}

std::vector<std::string> wordsFor(const std::string& start) {
  std::string why;
  const auto words = window::parseTransfer(R"({"start": )" + start + "}", why);
  EXPECT_TRUE(words) << why;
  return words ? window::installerArguments(*words->start) : std::vector<std::string>{};
}

TEST(TransferMessage, AcceptsOneKnownMemberPerMessage) {
  for (const char* text : {"", "null", "[]", "{}", R"({"cancel": true, "more": 1})", R"({"install": true})"})
    EXPECT_EQ(refusalOf(text), window::messages::kInvalidTransferRequest) << text;
  EXPECT_THAT(refusalOf(R"({"cancel": 1})"), HasSubstr("\"cancel\""));
  EXPECT_THAT(refusalOf(R"({"more": -1})"), HasSubstr("\"more\""));
  EXPECT_THAT(refusalOf(R"({"start": {"action": "reboot"}})"),
              AllOf(HasSubstr("\"action\""), HasSubstr("make-default")));
  EXPECT_THAT(refusalOf(startWith(R"({"address": "a", "user": "b", "password": "c"})")),
              AllOf(HasSubstr("\"robot\""), HasSubstr("address"), HasSubstr("port")));
  EXPECT_EQ(refusalOf(R"({"start": {"action": "run", "robot": {"address": "a", "user": "b"}}})"),
            window::messages::kNoControllerFolder);
}

TEST(TransferMessage, NoUserOrHostIsTakenForAnOption) {
  for (const char* address : {"-oProxyCommand=x", "-F", "", "a b", "a;b", "a@b", "a\\nb", "a\\u0000b"})
    EXPECT_THAT(refusalOf(startWith(R"({"user": "darwin", "address": ")" + std::string{address} + R"("})")),
                AllOf(HasSubstr("address"), HasSubstr("192.168.123.1")))
        << address;
  for (const char* user : {"-l", "", "a b", "a@b", "$(x)"})
    EXPECT_THAT(refusalOf(startWith(R"({"address": "darwin", "user": ")" + std::string{user} + R"("})")),
                AllOf(HasSubstr("user"), HasSubstr("darwin")))
        << user;
  for (const char* port : {"-1", "65536", "1.5", "\"22\""})
    EXPECT_THAT(refusalOf(startWith(R"({"address": "a", "user": "b", "port": )" + std::string{port} + "}")),
                AllOf(HasSubstr("port"), HasSubstr("65535")));
  EXPECT_THAT(refusalOf(startWith(R"({"address": "a", "user": "b", "key": "a\nb"})")), HasSubstr("\"key\""));
  EXPECT_THAT(
      refusalOf(R"({"start": {"action": "status", "robot": {"address": "a", "user": "b"}, "host_key": "SHA256:x"}})"),
      HasSubstr("fingerprint"));
}

TEST(TransferMessage, BecomeTheCommandsThatAUserWouldType) {
  const std::string robot = R"("robot": {"address": "192.168.123.1", "user": "darwin", "port": 2222})";
  EXPECT_THAT(wordsFor(R"({"action": "status", )" + robot + "}"),
              ElementsAre("--status", "-p", "2222", "darwin@192.168.123.1"));
  EXPECT_THAT(wordsFor(R"({"action": "install", "force": true, )" + robot + "}"),
              ElementsAre("--force", "-p", "2222", "darwin@192.168.123.1"));
  EXPECT_THAT(wordsFor(R"({"action": "logs", "host_key": ")" + std::string{kFingerprint} + "\", " + robot + "}"),
              ElementsAre("--logs", "-f", "--host-key", kFingerprint, "-p", "2222", "darwin@192.168.123.1"));
  EXPECT_EQ(window::typedCommand({"--controller", "/a b", "it's"}),
            R"(darwinop install --controller '/a b' 'it'\''s')");
}

TEST(TransferMessage, RequireExistingPathsAndMakeThemAbsolute) {
  const TemporaryFolder folder;
  const std::string robot = R"("robot": {"address": "r", "user": "u"})";
  std::filesystem::create_directory((folder / "-walker"));
  const std::string controller = R"("controller": ")" + (folder / "-walker") + "\"";
  EXPECT_THAT(wordsFor(R"({"action": "run", "arguments": ["-x", "--force"], )" + controller + ", " + robot + "}"),
              ElementsAre("--controller", (folder / "-walker"), "--run", "u@r", "--", "-x", "--force"));
  EXPECT_THAT([&] { (void)wordsFor(R"({"action": "send", "controller": "-walker", )" + robot + "}"); },
              testing::ThrowsMessage<std::runtime_error>(testing::ContainsRegex("no folder /.*-walker")));
  EXPECT_THAT([&] { (void)wordsFor(R"({"action": "status", "robot": {"address": "r", "user": "u", "key": "/no"}})"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("cannot read key /no")));
}

TEST(TransferMessage, ConvertALoginOfTheCommandLine) {
  EXPECT_EQ(window::robotOf("darwin@192.168.123.1", "", ""),
            (window::RobotAddress{.address = "192.168.123.1", .user = "darwin"}));
  EXPECT_EQ(window::robotOf("robotis@fe80::1%eth0", "2222", "/keys/op2"),
            (window::RobotAddress{.address = "fe80::1%eth0", .user = "robotis", .key = "/keys/op2", .port = 2222}));
  EXPECT_EQ(window::robotOf("u@r", "", "id")->key, (std::filesystem::current_path() / "id").string());
  for (const char* nobody : {"", "192.168.123.1", "-l@r", "u@-F", "a b@r"})
    EXPECT_EQ(window::robotOf(nobody, "", ""), std::nullopt) << nobody;
  for (const char* port : {"ssh", "65536", "-1", "22;"})
    EXPECT_EQ(window::robotOf("u@r", port, ""), std::nullopt) << port;
}

}  // namespace
}  // namespace darwinop
