// Sound process: receives commands from a controller's socket until the socket closes.
#pragma once

#include <string>

namespace darwinop::audio {

/// `home`: the program's folder; on a robot it contains the voice data. Returns when the controller closes the socket.
void serve(int socket, const std::string& home);

}  // namespace darwinop::audio
