/// The library that is missing when the plugin that needs it is loaded.
__attribute__((visibility("default"))) void nowhere() {}
