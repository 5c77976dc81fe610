// Stub of libpcaudio. libespeak-ng links to it for its own playback, which we do not use; the stub avoids installing
// libpcaudio and its sound servers on a robot.
#include <cstddef>

// NOLINTBEGIN(readability-identifier-naming): names of libpcaudio
extern "C" {

struct audio_object;

audio_object* create_audio_device_object(const char*, const char*, const char*) {
  return nullptr;
}
int audio_object_open(audio_object*, int, unsigned, unsigned char) {
  return -1;
}
void audio_object_close(audio_object*) {}
void audio_object_destroy(audio_object*) {}
int audio_object_write(audio_object*, const void*, std::size_t) {
  return -1;
}
int audio_object_drain(audio_object*) {
  return -1;
}
int audio_object_flush(audio_object*) {
  return -1;
}
const char* audio_object_strerror(audio_object*, int) {
  return "playback is not available";
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
