// Phrases of the web server's log, by which a line is recognized.
#pragma once

namespace darwinop::web::messages {

// A connection, after its name.
inline constexpr const char* kNotInAllowedNetwork = "not in a network given with --allow";
inline constexpr const char* kConnectionsOpen = " connections are open";  // the limit, before it the number
inline constexpr const char* kClosedForNewer = " was closed to make room for a newer connection";
inline constexpr const char* kTooManyMessages = "too many messages";

}  // namespace darwinop::web::messages
