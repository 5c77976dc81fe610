// Holds the precompiled headers that rooms share: PrecompiledHeaders.cmake.
