#include "interruption.hpp"

#include <atomic>
#include <csignal>

namespace sphonic::driver {
namespace {

constexpr int ending[] = {SIGINT, SIGTERM, SIGHUP};

/// A signal's handler reaches nothing but what is static.
std::atomic<int> noted = 0, times = 0;
static_assert(std::atomic<int>::is_always_lock_free);

void note(int signal) {
    noted = signal;
    if (++times < 3) return;
    std::signal(signal, SIG_DFL);
    std::raise(signal);    // at once after this handler
}

}    // namespace

Interruptible::Interruptible() {
    noted = times = 0;
    std::signal(SIGXFSZ, SIG_IGN);
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    for (const int signal : ending) {
        struct sigaction before = {};
        ::sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);    // nohup and jobs in the background want it ignored
    }
}

Interruptible::~Interruptible() {
    for (const int signal : ending) {
        struct sigaction now = {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler == note) std::signal(signal, SIG_DFL);
    }
}

void Interruptible::stop_if_asked(const std::string& place, const std::string& state) const {
    if (const int signal = noted) throw Interruption(signal, place + ": interrupted " + state);
}

}    // namespace sphonic::driver
