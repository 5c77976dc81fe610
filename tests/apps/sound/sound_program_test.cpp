// The sound program as a process: what is missing, what dies, and what is left behind.
#include <gmock/gmock.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "apps/sound/graph.hpp"
#include "hal/signals.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

bool processExists(pid_t pid) {
  return std::filesystem::exists("/proc/" + std::to_string(pid));
}

std::string whyNoSound() {
  try {
    static_cast<void>(connect::openSound());
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST_F(SoundGraph, WithoutACardSoundsTakeTheirTimeAndThatIsReported) {
  writeGraph("pcm.null { type null }\n");
  const auto begin = std::chrono::steady_clock::now();
  sound().order(PlaySound{.id = 1, .file = toneFile(440, 0.3)});
  awaitEnd(1);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 300ms);
  EXPECT_THAT(said, HasSubstr("cannot use sound card \"default\""));
}

TEST_F(SoundGraph, ACardThatIsFreeAgainPlaysTheSoundThatRepeats) {
  const std::string present = folder / "alsa.conf", later = folder / "later.conf";
  std::filesystem::copy_file(present, later);
  writeGraph("pcm.null { type null }\n");
  sound().order(PlaySound{.id = 1, .file = toneFile(440, 0.2), .loop = true});
  awaitBeginAndError();
  std::filesystem::rename(later, present);
  for (int i = 0; i < 2000 && !std::filesystem::exists(recording()); ++i) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(300ms);  // some of it
  EXPECT_FALSE(sound().nextEvent(0ms)) << "one message, whatever the number of tries";
  EXPECT_GT(rms(audiblePart(recorded().channel(0))), 0.1);
}

TEST_F(SoundGraph, AFileThatIsMissingOrIsNoneIsReportedAndTheNextOneSounds) {
  sound().order(PlaySound{.id = 1, .file = folder / "nothing.mp3"});
  awaitEnd(1);
  EXPECT_THAT(said, HasSubstr((folder / "nothing.mp3") + ": " + std::strerror(ENOENT)));
  std::ofstream{folder / "text.mp3"} << "this is not a sound at all, whatever its name says";
  sound().order(PlaySound{.id = 2, .file = folder / "text.mp3"});
  awaitEnd(2);
  EXPECT_THAT(said, HasSubstr(folder / "text.mp3"));
  sound().order(Speak{.id = 3, .text = folder / "no_text", .text_is_file = true});
  awaitEnd(3);
  EXPECT_THAT(said, HasSubstr("no_text: " + std::string{std::strerror(ENOENT)}));
  std::ofstream{folder / "text"} << "Yes!";
  sound().order(Speak{.id = 4, .text = folder / "text", .text_is_file = true, .voice = "gobbledygook+f3"});
  awaitEnd(4);
  EXPECT_THAT(said, HasSubstr("voice \"gobbledygook+f3\" not found, using \"en\""));
  EXPECT_GT(rms(audiblePart(recorded().channel(0))), 0.01);
}

TEST_F(SoundGraph, WhatEndsAtOnceIsReportedAlsoWhenTheCardIsAboutToBeGivenBack) {
  sound().order(Speak{.id = 1, .text = folder / "no_text", .text_is_file = true});
  awaitEnd(1);
  sound().order(PlaySound{.id = 2, .file = toneFile(440, 0.1)});
  awaitEnd(2);
  std::this_thread::sleep_for(100ms);  // the card rests for 0.3 s after the tone, half of which was over
  sound().order(Speak{.id = 3, .text = folder / "no_text", .text_is_file = true});
  awaitEnd(3);
}

TEST_F(SoundGraph, AProgramThatIsKilledIsReportedAndLeavesNoZombie) {
  sound().order(PlaySound{.id = 1, .file = toneFile(440, 10)});
  awaitBegin(1);
  const pid_t pid = sound().pid();
  kill(pid, SIGKILL);
  const auto event = sound().nextEvent(kPatience);
  ASSERT_TRUE(event && std::holds_alternative<SoundLost>(*event));
  EXPECT_THAT(std::get<SoundLost>(*event).sentence, HasSubstr("ended by signal 9"));
  EXPECT_FALSE(processExists(pid));
  EXPECT_TRUE(sound().order(StopSound{})) << "no signal, and nothing to say again";
  EXPECT_FALSE(sound().nextEvent(0ms));
}

/// State of a process as ps shows it; Z or nothing: it has ended.
char stateOf(pid_t pid) {
  std::ifstream file{"/proc/" + std::to_string(pid) + "/stat"};
  std::string text;
  std::getline(file, text);
  const std::size_t name_end = text.rfind(") ");
  return name_end == std::string::npos ? 'Z' : text.at(name_end + 2);
}

/// The state wanted, or that of the program ten seconds after the signal: a sanitizer may first print where it was.
char stateAfter(pid_t pid, int signal, char wanted) {
  kill(pid, signal);
  for (int i = 0; i < 1000 && stateOf(pid) != wanted; ++i) std::this_thread::sleep_for(10ms);
  return stateOf(pid);
}

TEST_F(SoundGraph, EachSignalHasTheDocumentedEffectOnTheProgram) {
  const auto plays = [this] {
    sound().order(PlaySound{.id = 1, .file = toneFile(440, 10)});
    awaitBegin(1);
    return sound().pid();
  };
  pid_t pid = plays();
  for (const SignalRow& row : kSignals) {
    const bool by_controller = row.number == SIGINT || row.number == SIGQUIT || row.number == SIGHUP;
    const bool harmless = row.effect == SignalEffect::kIgnored || row.effect == SignalEffect::kNoEffect;
    if (harmless || by_controller) {
      kill(pid, row.number);
      std::this_thread::sleep_for(20ms);
      ASSERT_NE(stateOf(pid), 'Z') << row.name;
      ASSERT_NE(stateOf(pid), 'T') << row.name;
      continue;
    }
    const bool stops = row.effect == SignalEffect::kStops;
    EXPECT_EQ(stateAfter(pid, row.number, stops ? 'T' : 'Z'), stops ? 'T' : 'Z') << row.name;
    if (stops) {
      EXPECT_NE(stateAfter(pid, SIGCONT, 'S'), 'T');
      continue;
    }
    endProgram();
    pid = plays();
  }
}

TEST_F(SoundGraph, TheProgramEndsWithItsController) {
  const pid_t controller = fork();
  if (controller == 0) {
    sound().order(PlaySound{.id = 1, .file = toneFile(440, 10)});
    awaitBegin(1);
    std::ofstream{folder / "pid"} << sound().pid() << '\n';
    std::filesystem::rename(folder / "pid", folder / "began");
    for (;;) pause();
  }
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!std::filesystem::exists(folder / "began") && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(5ms);
  pid_t program = 0;
  std::ifstream{folder / "began"} >> program;
  ASSERT_GT(program, 0);
  // A zombie does not count: nobody may be there to reap it.
  const auto lives = [&] {
    std::ifstream status{"/proc/" + std::to_string(program) + "/stat"};
    std::string text;
    std::getline(status, text);
    return status && text.find(") Z ") == std::string::npos;
  };
  kill(program, SIGINT);  // Ctrl-C in the controller's terminal
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(lives());
  kill(controller, SIGKILL);
  waitpid(controller, nullptr, 0);
  while (lives() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(5ms);
  EXPECT_FALSE(lives());
}

TEST_F(SoundGraph, APipeOfTheControllerEndsWhenTheControllerClosesIt) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);  // as popen() and many a library make them
  sound();
  close(ends[1]);
  pollfd end{ends[0], POLLIN, 0};
  EXPECT_EQ(poll(&end, 1, 1000), 1) << "the sound program has it also";
  close(ends[0]);
}

TEST_F(SoundGraph, AMissingProgramIsAWordAboutWhereItWasLookedFor) {
  setenv("DARWINOP_SOUND", "/nowhere/darwinop-sound", 1);
  EXPECT_THAT(whyNoSound(), HasSubstr("it was not found. Looked for:\n  /nowhere/darwinop-sound"));
  setenv("DARWINOP_SOUND", "none", 1);
  EXPECT_EQ(whyNoSound(), "DARWINOP_SOUND is \"none\"");
  unsetenv("DARWINOP_SOUND");
  EXPECT_THAT(connect::soundProgramPlaces().front(), HasSubstr("/darwinop-sound"));
}

}  // namespace
}  // namespace darwinop
