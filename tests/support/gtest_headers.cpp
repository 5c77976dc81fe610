// Holds the precompiled GoogleTest headers that the test programs share.
