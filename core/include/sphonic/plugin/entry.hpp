#pragma once
/// The macro line of a plugin: SPHONIC_PLUGIN(Interface, "name", Struct, "what it is").

#include <cstring>
#include <memory>
#include <type_traits>

#include <sphonic/plugin/parameter.hpp>

#ifndef SPHONIC_ABI_TAG
#error "build plugins through the CMake target sphonic::plugin: it defines SPHONIC_ABI_TAG"
#endif

namespace sphonic::detail {

/// `Model` carries the parameters; `Product` is the interface's implementation, which may be the model itself
/// or an adapter with a member `model`.
template <class Interface, class Model, class Product>
const abi::Entry* make_entry(const char* name, const char* doc) {
    static const abi::Entry entry = [&] {
        const auto& table = parameter_table<Model>();
        abi::Entry e{};
        std::memcpy(e.magic, abi::magic, sizeof e.magic);
        e.size = sizeof(abi::Entry);
        e.abi = SPHONIC_ABI_TAG;
        e.kind = Interface::kind;
        e.name = name;
        e.doc = doc;
        e.parameters = table.data();
        e.parameter_count = int(table.size());
        e.create = [](const abi::Value* values) -> void* {
            auto product = std::make_unique<Product>();
            if constexpr (std::is_same_v<Model, Product>)
                set_parameters<Model>(*product, values);
            else
                set_parameters<Model>(product->model, values);
            return static_cast<Interface*>(product.release());
        };
        return e;
    }();
    return &entry;
}

}    // namespace sphonic::detail

#define SPHONIC_ENTRY(Interface, Model, Product, name, doc)                                                            \
    extern "C" __attribute__((visibility("default"))) const sphonic::abi::Entry* sphonic_plugin_entry() {              \
        return sphonic::detail::make_entry<Interface, Model, Product>(name, doc);                                      \
    }

/// For a struct that implements the interface itself.
#define SPHONIC_PLUGIN(Interface, name, Struct, doc) SPHONIC_ENTRY(Interface, Struct, Struct, name, doc)

using namespace sphonic;
