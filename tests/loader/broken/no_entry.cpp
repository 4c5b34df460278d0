/// A shared library, but no plugin: its source forgot the macro line.
extern "C" __attribute__((visibility("default"))) int answer() { return 42; }
