// Maps voice names of the 2013 robots and of Webots to those of espeak-ng.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace darwinop::audio {

struct VoiceName {
  std::string_view said, today;
};

/// Names that differ. In eSpeak of 2009 "pt" was Brazilian. A variant ("en+f3") keeps the part after the +.
inline constexpr std::array kVoiceNames{
    VoiceName{"default", "en"},
    VoiceName{"en-sc", "en-gb-scotland"},
    VoiceName{"en-uk", "en"},
    VoiceName{"en-gb", "en"},
    VoiceName{"en-n", "en-gb-x-gbclan"},
    VoiceName{"en-uk-north", "en-gb-x-gbclan"},
    VoiceName{"en-rp", "en-gb-x-rp"},
    VoiceName{"en-uk-rp", "en-gb-x-rp"},
    VoiceName{"en-wm", "en-gb-x-gbcwmd"},
    VoiceName{"en-uk-wmids", "en-gb-x-gbcwmd"},
    VoiceName{"en-wi", "en-029"},
    VoiceName{"es-la", "es-419"},
    VoiceName{"pt", "pt-br"},
    VoiceName{"pt-pt", "pt"},
    VoiceName{"no", "nb"},
    VoiceName{"zh", "cmn"},
    VoiceName{"zh-yue", "yue"},
    VoiceName{"hy-west", "hyw"},
    VoiceName{"de-de", "de"},
    VoiceName{"es-es", "es"},
    VoiceName{"fr-fr", "fr"},
    VoiceName{"it-it", "it"},
};

/// Case-insensitive: "de-DE" is "de".
[[nodiscard]] std::string voiceOfToday(std::string_view said);

}  // namespace darwinop::audio
