// The socket's old place.
#pragma once

#include "remote/socket.hpp"  // IWYU pragma: export
