// Speech synthesis with libespeak-ng in a thread of its own: the library is not reentrant and blocks.
#include "hal/audio/program/speech.hpp"

#include <espeak-ng/speak_lib.h>

#include <stdexcept>
#include <utility>

#include "hal/audio/voice_names.hpp"
#include "hal/text_file.hpp"

namespace darwinop::audio {

namespace {

constexpr std::size_t kLongestSpeech = 1'000'000;  // bytes, about a day of speech

/// Synthesis callback; returns 0 to continue, 1 to abort.
int onSamples(short* samples, int count, espeak_EVENT* events) {
  auto* const spoken = static_cast<Spoken*>(events->user_data);
  if (spoken == nullptr) return 0;
  if (samples == nullptr || count <= 0) return spoken->givenUp() ? 1 : 0;
  return spoken->put({samples, static_cast<std::size_t>(count)}) ? 0 : 1;
}

/// Throws std::runtime_error if the file cannot be read or is too long.
std::string textOf(const std::string& file) try {
  if (auto text = readTextFile(file, kLongestSpeech)) return *std::move(text);
  throw std::runtime_error("cannot read " + file + ": No such file or directory");
} catch (const std::runtime_error& error) {
  throw std::runtime_error("speakFile(): " + std::string{error.what()});
}

class Voice final : public SoundSource {
 public:
  explicit Voice(std::shared_ptr<Spoken> spoken) : spoken_{std::move(spoken)} {}
  ~Voice() override { spoken_->giveUp(); }
  Voice(const Voice&) = delete;
  Voice& operator=(const Voice&) = delete;

  [[nodiscard]] int rate() const override { return spoken_->rate(); }
  std::size_t read(std::span<AudioFrame> frames) override { return spoken_->take(frames); }
  [[nodiscard]] bool ended() const override { return spoken_->drained(); }
  bool rewind() override { return false; }

 private:
  std::shared_ptr<Spoken> spoken_;
};

}  // namespace

Speech::Speech(const std::string& data, std::function<void(const std::string&)> report)
    : report_{std::move(report)},
      rate_{espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, data.empty() ? nullptr : data.c_str(),
                              espeakINITIALIZE_DONT_EXIT)} {
  if (rate_ <= 0) {
    report_("speech is not available: voice data (espeak-ng-data) not found" +
            (data.empty() ? std::string{} : " in " + data));
    return;
  }
  espeak_SetSynthCallback(onSamples);
  thread_ = std::thread{[this] { run(); }};
}

Speech::~Speech() {
  {
    const std::lock_guard lock{mutex_};
    ending_ = true;
    if (spoken_) spoken_->giveUp();
    asked_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
  if (rate_ > 0) espeak_Terminate();
}

std::unique_ptr<SoundSource> Speech::speak(const Speak& speak) {
  if (rate_ <= 0) return nullptr;
  const std::lock_guard lock{mutex_};
  if (spoken_) spoken_->giveUp();
  spoken_ = std::make_shared<Spoken>(rate_);
  if (next_) next_->to->complete();  // was never started
  next_ = Job{speak, spoken_};
  asked_.notify_one();
  return std::make_unique<Voice>(spoken_);
}

void Speech::run() {
  for (;;) {
    std::unique_lock lock{mutex_};
    asked_.wait(lock, [this] { return ending_ || next_; });
    if (ending_) return;
    const Job job = *std::exchange(next_, std::nullopt);
    lock.unlock();
    try {
      synthesize(job);
    } catch (const std::exception& error) {
      report_(error.what());
    }
    job.to->complete();
  }
}

void Speech::choose(const std::string& voice) {
  // espeak also accepts file names as voices.
  const bool is_name = voice.find('/') == std::string::npos && voice.find("..") == std::string::npos;
  if (is_name && espeak_SetVoiceByName(voiceOfToday(voice).c_str()) == EE_OK) return;
  if (espeak_SetVoiceByName("en") != EE_OK) throw std::runtime_error("speech is not available: voice \"en\" not found");
  report_("voice \"" + voice + "\" not found, using \"en\"; see the voices in docs/sound.md");
}

void Speech::synthesize(const Job& job) {
  const std::string text = job.speak.text_is_file ? textOf(job.speak.text) : job.speak.text;
  choose(job.speak.voice);
  espeak_SetParameter(espeakRATE, job.speak.words_per_minute, 0);
  // SSML and phoneme markup are off: the text is read literally. AUTO: UTF-8, or Latin-1 if it is not valid UTF-8.
  if (espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0, espeakCHARS_AUTO, nullptr, job.to.get()) !=
      EE_OK)
    throw std::runtime_error("cannot synthesize speech");
}

}  // namespace darwinop::audio
