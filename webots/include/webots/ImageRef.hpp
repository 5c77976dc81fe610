// Image of webots::Display. This robot has none: absent_devices.hpp.
#ifndef IMAGE_REF_HPP
#define IMAGE_REF_HPP

namespace webots {

/// No object exists here.
class ImageRef;

}  // namespace webots

#endif
