// The sound program: takes orders from a controller's socket until that closes.
#pragma once

#include <string>

namespace darwinop::audio {

/// `home` is the program's folder: on a robot the data of the voices lie in it. Returns when the controller has gone.
void serve(int socket, const std::string& home);

}  // namespace darwinop::audio
