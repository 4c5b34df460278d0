/// A plugin that needs a function from elsewhere: from no library at all, or from one that is not found at run time.
namespace sphonic::abi {
struct Entry;
}
void nowhere();

extern "C" __attribute__((visibility("default"))) const sphonic::abi::Entry* sphonic_plugin_entry() {
    nowhere();
    return nullptr;
}
