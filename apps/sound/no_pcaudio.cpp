// libespeak-ng can play by itself, through libpcaudio and all the sound servers that there are. We take its samples, so
// on a robot it gets these functions, which are never called, instead of that library.
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
  return "there is no player here";
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
