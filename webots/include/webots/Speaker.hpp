// The loudspeaker, "Speaker": sound files and speech. No call waits, except playFileWait().
#ifndef SPEAKER_HPP
#define SPEAKER_HPP

#include <webots/Device.hpp>

namespace darwinop {
namespace facade {
class SoundDesk;
}
}  // namespace darwinop

namespace webots {

class Speaker : public Device {
 public:
  virtual ~Speaker();

  static void playSound(Speaker* left, Speaker* right, const std::string& sound, double volume, double pitch,
                        double balance, bool loop);
  virtual void stop(const std::string& sound);
  bool isSoundPlaying(const std::string& sound) const;
  bool setEngine(const std::string& engine);
  bool setLanguage(const std::string& language);
  std::string getEngine() const;
  std::string getLanguage() const { return language_; }
  virtual void speak(const std::string& text, double volume);
  bool isSpeaking() const;

  // Calls of 2013.
  virtual void enable(int sampling_period);
  virtual void disable();
  virtual void playFile(const char* filename);
  virtual void playFileWait(const char* filename);
  virtual void speak(const char* text, const char* voice = "en", int speed = 175);
  virtual void speakFile(const char* filename, const char* voice = "en", int speed = 175);

 private:
  friend class darwinop::facade::RobotImpl;
  Speaker(const std::string& name, darwinop::facade::RobotImpl& robot);
  void refresh();

  std::string language_;
  darwinop::facade::SoundDesk* desk_;
};

}  // namespace webots

#endif
