// In sanitizer builds, libraries that were loaded stay loaded, so that the leak checker can name what a graphics driver
// leaves behind, and tests/lsan.supp can tell it from our own leaks.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) {
    return 0;
}
