// controllers/07_talk on a virtual robot that is laid down, set up, touched and worn out; what it says is recorded.
#include <gmock/gmock.h>

#include "runtime/environment.hpp"
#include "support/wave.hpp"
#include "system/rig.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;

/// How often.
int countOf(const std::string& text, const std::string& sentence) {
  int count = 0;
  for (auto at = text.find(sentence); at != std::string::npos; at = text.find(sentence, at + 1)) ++count;
  return count;
}

TEST_F(Rig, TheTalkingExampleSaysOnceWhatItFeels) {
  std::ofstream{file("alsa.conf")} << "pcm.!default { type plug; slave.pcm \"recorder\" }\n"
                                   << "pcm.recorder { type file; slave.pcm { type null }; format \"wav\"; file \""
                                   << file("out.wav") << "\"; truncate false }\n";
  const runtime::Environment card{"ALSA_CONFIG_PATH", file("alsa.conf")};
  const runtime::Environment program{"DARWINOP_SOUND", DARWINOP_SOUND_PROGRAM};
  startVirtualRobot(
      "0 voltage 10.6\n"
      "4.5 fallen back for 1.5\n"
      "4.6 button start for 0.1\n");
  Program running{{Rig::program("darwinop-run"), "--robot", port(), DARWINOP_TALK, "--seconds", "8"}, file("talk.txt")};
  EXPECT_EQ(running.wait(std::chrono::seconds{60}), 0) << running.output();
  const std::string said = running.output();
  for (const char* const sentence :
       {"Hello. I say what I feel.\n", "I lie on my back.\n", "I am upright again. Thank you.\n",
        "You touched my start button.\n", "My battery is low.\n"})
    EXPECT_EQ(countOf(said, sentence), 1) << sentence << said;
  EXPECT_EQ(countOf(said, "face") + countOf(said, "side") + countOf(said, "moves"), 0) << said;
  EXPECT_EQ(countOf(said, "Speaker:"), 0) << said;
  const Wave wave = readWave(file("out.wav"));
  EXPECT_GT(rms(heard(wave.channel(0))), 0.01);
}

}  // namespace
}  // namespace darwinop
