// The loudspeaker, "Speaker": sound files and speech. No call waits, except playFileWait().
#ifndef SPEAKER_HPP
#define SPEAKER_HPP

#include <webots/Device.hpp>
#include <webots/Robot.hpp>

namespace darwinop {
namespace webots_api {
class SoundDesk;
}
}  // namespace darwinop

namespace webots {

///     speaker->setLanguage("en-us");
///     speaker->speak("I see the ball.", 1.0);                                           // volume
///     webots::Speaker::playSound(speaker, speaker, "cheer.mp3", 0.5, 1.0, 0.0, false);  // mixed with the speech
///
/// A separate process, `darwinop-sound`, plays; it is started by the first sound, and its errors are logged once.
/// Without a sound card the calls take as long as with one. Relative file names start at the directory of the program;
/// formats are WAV, MP3, FLAC and Ogg. With `--robot virtual` and `twin` sounds play in real time. Threads: see Robot.
/// docs/sound.md
class Speaker : public Device {
 public:
  /// The robot's device of this name, for Robot::createSpeaker() and a class of your own; see Device.
  explicit Speaker(const std::string& name);
  virtual ~Speaker();

  /// Plays a file, mixed with up to 31 others. `volume` 0 to 1; `pitch` 0.5 to 2, changes the speed as well; `balance`
  /// -1 (left) to 1 (right), used when both speakers are given; they may be the same one. Values out of range are
  /// clamped with one warning. A file that already plays gets the new values. NULL for both speakers: no sound, one
  /// warning. 2013: everything but the file was ignored.
  static void playSound(Speaker* left, Speaker* right, const std::string& sound, double volume, double pitch,
                        double balance, bool loop);
  /// Stops this file; "": all files and speech (2013: speech only).
  virtual void stop(const std::string& sound);
  /// True until this file has ended; "": any file.
  bool isSoundPlaying(const std::string& sound) const;
  /// True for "espeak", the only engine; false with one warning for any other, as the simulator's "pico".
  bool setEngine(const std::string& engine);
  /// Voice of speak(text, volume): "en" (default), "en-US", "de-DE", ... (docs/sound.md). False: empty name. An unknown
  /// voice becomes English when it speaks.
  bool setLanguage(const std::string& language);
  /// "espeak".
  std::string getEngine() const;
  /// The voice set last, "en" by default.
  std::string getLanguage() const { return language_; }
  /// Speaks a text at 175 words/min and replaces current speech. UTF-8 or Latin-1, cut at 32000 bytes with one warning;
  /// `volume` 0 to 1.
  virtual void speak(const std::string& text, double volume);
  /// True until speech has ended.
  bool isSpeaking() const;

  // Calls of 2013.

  /// No effect; ms.
  virtual void enable(int sampling_period);
  /// No effect.
  virtual void disable();
  /// Plays a file once and replaces the one that playFile() plays.
  virtual void playFile(const char* filename);
  /// As playFile(), and calls Robot::step() with the basic time step until the sound has ended, or until step() returns
  /// -1. Gives up 10 s after the expected end. In lockstep it waits in simulated time. 2013: did not step the robot.
  virtual void playFileWait(const char* filename);
  /// Speaks a text and replaces current speech; `speed` 80 to 450 words/min. 32000 bytes at most.
  virtual void speak(const char* text, const char* voice = "en", int speed = 175);
  /// Speaks a text file of 1 MB at most; `speed` 80 to 450 words/min.
  virtual void speakFile(const char* filename, const char* voice = "en", int speed = 175);

 private:
  friend class darwinop::webots_api::RobotImpl;
  Speaker(const std::string& name, darwinop::webots_api::RobotImpl& robot);
  virtual void refresh();

  std::string language_;
  darwinop::webots_api::SoundDesk* desk_;
};

}  // namespace webots

#endif
